// What the command line asks of the library, as the library's request, and what the library says about it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "netmesh.hpp"
#include "tools/io/points.hpp"
#include "tools/options.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

// Of --focus auto, where --longer-than is not given.
constexpr double default_longer_than = 1.5;

// The request of a command with nothing left open, for points in `dim` dimensions, without the points: of `dim` 2 what
// can be said of all. Exit::usage names the option that is refused, *at the field; *settled then is the request as it
// was asked.
Outcome settle(const Options& options, std::uint32_t dim, netmesh_request* settled, netmesh_field* at = nullptr);
// The options with what is settled in place of what was given.
Options settled(const Options& options, std::uint32_t dim);
// The option for which the filter auto is refused; empty: none.
std::string option_against_auto(const Options& options);

// tau that meshes have where none is asked for.
double default_tau(std::uint32_t dim);

// The request on these points; on the mesh or triangulation that is there, by which rules it was made is not asked; and
// what a mesh promises that was made for it.
netmesh_request on_points(netmesh_request request, const PointCloud& cloud);
netmesh_request on_what_is_there(netmesh_request request);
netmesh_request promised(netmesh_request request);

// Bytes to plan for what a command makes of so many points, for size, and for a mesh of so many vertices that is read.
std::size_t plan_of(const Options& options, std::uint32_t dim, std::size_t points);
std::size_t plan_for_size(const Options& options);
std::size_t plan_to_read(std::uint32_t dim, std::size_t vertices);

}  // namespace netmesh::tool
