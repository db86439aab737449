/* netmesh: quality Delaunay/Voronoi meshes of point clouds in R^2..R^6 and their certified persistent homology,
 * inside one block of memory that the caller hands over.
 *
 * The library never allocates, has no mutable global state, and gives the same results on every compiler and
 * processor. A context lives at the start of the caller's block; nothing outside the block is written, and the block
 * may be copied byte by byte to another 16-byte aligned address and used there. Two contexts are independent.
 *
 * This header is what programs need for diagrams:
 *
 *     netmesh/context.h       a context, statuses and errors, progress
 *     netmesh/points.h        what a diagram is of: points, distances, simplices
 *     netmesh/request.h       one request: filters, goals, rules of meshes, what is wanted besides
 *     netmesh/options.h       members of a request by name, for tools and bindings
 *     netmesh/diagram.h       filters, bars, bounds of bars, cycles, vines
 *     netmesh/report.h        what a context holds and how it came about
 *     netmesh/mesh.h          meshes taken over from elsewhere, checked, read
 *     netmesh/distance.h      distances of two diagrams
 *     netmesh/pieces.h        alpha diagrams in pieces, of any number of points, on any number of machines
 *     netmesh/job.h           calls in slices: pause at a poll, go on later
 *
 * and this one is for itself:
 *
 *     netmesh/laboratory.h    cells measured, size, structure and fatness analysed
 *
 * Life of a context:   init -> persist -> get_*
 *                      init -> mesh | load -> persist | check -> get_*
 *
 * A request is a struct with defaults:
 *
 *     netmesh_request request = netmesh_default_request();
 *     request.points.coordinates = numbers;
 *     request.points.count = n;
 *     request.points.dim = 3;
 *     request.filter = &netmesh_filter_alpha;
 *     status = netmesh_persist(context, &request);
 *
 * Sizes of structs. Every struct that crosses this interface begins with its size in bytes as the caller's compiler
 * saw it. netmesh_default_* write it; in all other structs, those for results too, the caller does: pair.struct_bytes =
 * sizeof pair. It is the promise that programs and libraries of different versions go together: structs only ever grow
 * at their end. A struct smaller than the library's is taken as it is and what is missing counts as 0, which is the
 * default of every field that a later version adds; a larger one is taken when all that this library does not know is
 * 0. Of structs for results nothing past struct_bytes is written. The members of a struct that are structs without a
 * size of their own keep their layout; some have `reserved` room for what is added to them.
 *
 * "Thesis" is D. Sheehy, Mesh Generation and Geometric Persistent Homology, CMU 2011; numbers are its sections.
 * Unless said otherwise a call that does not return NETMESH_OK leaves the previous result untouched. */
#ifndef NETMESH_H
#define NETMESH_H

#include "netmesh/context.h"
#include "netmesh/diagram.h"
#include "netmesh/distance.h"
#include "netmesh/job.h"
#include "netmesh/mesh.h"
#include "netmesh/options.h"
#include "netmesh/pieces.h"
#include "netmesh/points.h"
#include "netmesh/report.h"
#include "netmesh/request.h"

#endif
