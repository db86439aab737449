/* The loop that lives longest among points of the plane, exactly: from which radius on discs around the points close
 * it, and at which radius they have filled it. */
#ifndef LOOP_H
#define LOOP_H

#include <netmesh.h>

/* All memory that netmesh uses; netmesh_plan says how much that is for so many points. Its stack comes on top:
 * NETMESH_STACK_BYTES_ALPHA(3), or (2) where 2 is the only dimension that is built. */
static unsigned char block[24 * 1024] __attribute__((aligned(16)));

/* A circle of radius 1; a sensor's points would stand here. */
static const float points[][2] = {
    {1, 0},  {.866025f, .5f},   {.5f, .866025f},   {0, 1},  {-.5f, .866025f}, {-.866025f, .5f},
    {-1, 0}, {-.866025f, -.5f}, {-.5f, -.866025f}, {0, -1}, {.5f, -.866025f}, {.866025f, -.5f}};

/* Both radii in thousandths of a unit; 0 where there is no loop. */
static inline netmesh_status longest_loop(int* born, int* filled) {
    netmesh_context* context;
    netmesh_pair bar;
    uint64_t i;
    netmesh_request request = netmesh_default_request();
    netmesh_status status = netmesh_init(block, sizeof block, &context);
    request.points.coordinates = points;
    request.points.count = sizeof points / sizeof points[0];
    request.points.dim = 2;
    request.points.format = NETMESH_POINTS_FLOAT32;
    request.filter = &netmesh_filter_alpha_small;
    if (status == NETMESH_OK) status = netmesh_persist(context, &request);
    *born = *filled = 0;
    bar.struct_bytes = sizeof bar;
    for (i = 0; status == NETMESH_OK && netmesh_get_pair(context, i, &bar) == NETMESH_OK; ++i)
        if (bar.degree == 1 && bar.death - bar.birth > (*filled - *born) / 1e3) {
            *born = (int)(1e3 * bar.birth + .5);
            *filled = (int)(1e3 * bar.death + .5);
        }
    return status;
}

#endif
