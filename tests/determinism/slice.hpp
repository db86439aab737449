// The jobs that every build must agree on: twenty small inputs in each dimension, each triangulated, filtered by its
// alpha complex, meshed and filtered by its mesh; and every other call on a few points. Freestanding, so that it also
// runs on bare metal and in wasm.
#pragma once
#include <cstddef>

#include "netmesh.h"

namespace slice {

constexpr std::size_t block_bytes = std::size_t{3} << 20;  // enough for the largest job
constexpr int inputs_per_dimension = 20;

// Runs dimensions first..last inside block (16-byte aligned), calling print once for each input with a line (without
// its end) of fingerprints: input, Delaunay triangulation, alpha diagram, mesh, mesh diagram; a job that ends in
// another status than NETMESH_OK shows the status. After the inputs of a dimension four lines (D = 2: five) of the
// other calls. Returns the number of lines.
int run(void* block, std::size_t bytes, int first, int last, void (*print)(const char* line));

// The demonstration for small devices: 500 uniform points in dim = 2 or 200 in dim = 3, to a mesh, to a diagram in all
// degrees, in demo_bytes of block. Prints one line of fingerprints.
constexpr std::size_t demo_bytes = std::size_t{1} << 20;
netmesh_status demo(int dim, void* block, std::size_t bytes, netmesh_report* report, void (*print)(const char* line));

}  // namespace slice
