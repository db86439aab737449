/* netmesh: quality Delaunay/Voronoi meshes of point clouds in R^2..R^6 and their certified persistent homology,
 * inside one block of memory that the caller hands over.
 *
 * The library never allocates, has no mutable global state, and gives the same results on every compiler and
 * processor. A context lives at the start of the caller's block; nothing outside the block is written, and the block
 * may be copied byte by byte to another 16-byte aligned address and used there. Two contexts are independent.
 *
 * The interface is in headers that can also be included one by one:
 *
 *     netmesh/context.h       a context, statuses and errors, progress
 *     netmesh/mesh.h          triangulations and meshes
 *     netmesh/measure.h       their cells measured, checked and analysed
 *     netmesh/persistence.h   filters, diagrams, bounds of bars, cycles, vineyards in k
 *     netmesh/complexes.h     other complexes: by scales, of points, any filtered one
 *     netmesh/distances.h     complexes of data that is known by its distances
 *     netmesh/bottleneck.h    the distance of two diagrams
 *     netmesh/wasserstein.h   the cost of transport from one diagram to another
 *     netmesh/report.h        what a context holds and how it came about
 *     netmesh/job.h           calls in slices: pause at a poll, go on later
 *
 * Life of a context:   init -> delaunay | mesh | load -> persist | vineyard -> bound_bars, represent -> get_*
 *                      init -> fit | persist_scales | persist_points | persist_distances | points_vineyard | homology |
 *                              value_vineyard -> get_*
 *
 * Requests. A job takes the context and one request, a struct that its init call fills with defaults:
 *
 *     netmesh_mesh_request request;
 *     netmesh_mesh_request_init(&request, sizeof request, 3);
 *     request.points = points;
 *     request.point_count = n;
 *     status = netmesh_mesh(context, &request);
 *
 * Sizes of structs. Every struct that crosses this interface begins with its size in bytes as the caller's compiler
 * saw it: an init call writes it, and in structs for results the caller does (pair.struct_bytes = sizeof pair). It is
 * the promise that programs and libraries of different versions go together: structs only ever grow at their end.
 * A struct smaller than the library's is taken as it is and what is missing counts as 0, which is the default of every
 * field that a later version adds; a larger one is taken when all that this library does not know is 0. Of structs for
 * results nothing past struct_bytes is written. The members of a struct that are structs without a size of their own
 * keep their layout; a part of a report has `reserved` room for what is added to it.
 *
 * "Thesis" is D. Sheehy, Mesh Generation and Geometric Persistent Homology, CMU 2011; numbers are its sections.
 * Unless said otherwise a call that does not return NETMESH_OK leaves the previous result untouched. */
#ifndef NETMESH_H
#define NETMESH_H

#include "netmesh/bottleneck.h"
#include "netmesh/complexes.h"
#include "netmesh/context.h"
#include "netmesh/distances.h"
#include "netmesh/job.h"
#include "netmesh/measure.h"
#include "netmesh/mesh.h"
#include "netmesh/persistence.h"
#include "netmesh/report.h"
#include "netmesh/wasserstein.h"

#endif
