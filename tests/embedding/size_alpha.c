/* The smallest program with an exact diagram: points in a static array to the number of pairs of their alpha complex.
 */
#include <netmesh.h>
#include <stdio.h>

#ifndef FILTER
#define FILTER netmesh_filter_alpha
#endif

static const double points[][2] = {{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 3}, {2, 2}};
static union {
    unsigned char bytes[65536];
    double aligned[2];
} block __attribute__((aligned(16)));

int main(void) {
    netmesh_context* context;
    netmesh_request request = netmesh_default_request();
    netmesh_pair pair;
    unsigned count = 0;
    if (netmesh_init(&block, sizeof block, &context) != NETMESH_OK) return 1;
    request.points.coordinates = points[0];
    request.points.count = sizeof points / sizeof points[0];
    request.points.dim = 2;
    request.filter = &FILTER;
#ifdef PLANS
    if (netmesh_plan(&request) > sizeof block) return 1;
#endif
    if (netmesh_persist(context, &request) != NETMESH_OK) return 1;
    pair.struct_bytes = sizeof pair;
    while (netmesh_get_pair(context, count, &pair) == NETMESH_OK) ++count;
    printf("%u\n", count);
    return 0;
}
