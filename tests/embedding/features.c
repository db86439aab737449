/* Every part of the engine that a switch of netmesh_config.h leaves out, once in each dimension. Built with the same
 * switches as the library. Prints a line for each job that is in the build, by which builds are compared; the exit
 * status is not 0 when a part that is left out does not say so. */
#include "netmesh.h"
#include "vocabulary/netmesh_config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define POINTS 16
#define BLOCK_BYTES ((size_t)256 << 20)

static netmesh_context* context;
static void* block;
static double points[6 * POINTS];
static uint32_t dim;
static int faults;

/* `switches`: names of those that the job needs, "" for none; `built`: are they all on? */
static void ended(const char* job, netmesh_status status, const char* switches, int built) {
    netmesh_report report;
    netmesh_detail detail;
    report.struct_bytes = sizeof report;
    detail.struct_bytes = sizeof detail;
    netmesh_get_detail(context, &detail);
    if (built) {
        netmesh_get_report(context, &report);
        printf("%u %s %d %016llx\n", (unsigned)dim, job, (int)status, (unsigned long long)report.fingerprint);
        if (status != NETMESH_OK) {
            fprintf(stderr, "D = %u, %s: %s\n", (unsigned)dim, job, detail.message);
            ++faults;
        }
    } else {
        const char* const named = strstr(detail.message, "NETMESH_WITH_");
        if (status == NETMESH_NOT_BUILT && detail.field != NETMESH_FIELD_NONE && named != NULL &&
            strstr(switches, named + 13) != NULL)
            return;
        fprintf(stderr, "D = %u, %s needs %s, and said %d: %s\n", (unsigned)dim, job, switches, (int)status,
                detail.message);
        ++faults;
    }
}

static void fresh(void) { netmesh_init(block, BLOCK_BYTES, &context); }

/* count 0: as many as a mesh in this dimension is made of soon. */
static netmesh_request request_of(const netmesh_filter* filter, size_t count) {
    netmesh_request request = netmesh_default_request();
    request.points.coordinates = points;
    request.points.count = count != 0 ? count : dim == 2 ? POINTS : dim == 3 ? 10 : 4;
    request.points.dim = dim;
    request.filter = filter;
    return request;
}

static netmesh_request mesh_request(const netmesh_method* method) {
    netmesh_request request = request_of(NULL, 0);
    request.mesh.method = method;
    if (dim > 3) request.mesh.tau = 6;
    return request;
}

/* In a new context. */
static netmesh_status mesh(const netmesh_request* request) {
    fresh();
    return netmesh_mesh(context, request);
}
static netmesh_status persist(const netmesh_request* request) {
    fresh();
    return netmesh_persist(context, request);
}

static double height(void* user, const double* x) {
    (void)user;
    return x[0];
}
static double even_size(void* user, const double* x) {
    (void)user;
    (void)x;
    return dim == 2 ? .2 : .6;
}

static netmesh_function function_of_height(void) {
    netmesh_function function = {sizeof function, height, NULL, 1, 0, 4};
    return function;
}

/* Of the mesh that the context holds. */
static netmesh_status filter(const netmesh_filter* by, uint32_t k, const netmesh_function* function) {
    netmesh_request request = netmesh_default_request();
    request.filter = by;
    request.k = k;
    request.function = function;
    return netmesh_persist(context, &request);
}

static void meshes(void) {
    netmesh_request request = mesh_request(&netmesh_method_svr);
    ended("svr", mesh(&request), "", 1);

    request = mesh_request(&netmesh_method_netmesh);
    ended("cages", mesh(&request), "", 1);
    request.mesh.finish = 1;
    ended("finished", mesh(&request), "", 1);
    if (dim < 4) {
        request = mesh_request(&netmesh_method_thesis);
        request.mesh.tau = 6;
        ended("thesis-cages", mesh(&request), "", 1);
        request = mesh_request(&netmesh_method_refine);
        request.points.count = 3;
        ended("refine", mesh(&request), "", 1);
    }

    request = mesh_request(&netmesh_method_svr);
    request.mesh.sizes.size = even_size;
    ended("sizes", mesh(&request), "SIZES", NETMESH_WITH_SIZES);
    request = mesh_request(&netmesh_method_svr);
    request.mesh.sizes.at_inputs = request.mesh.sizes.growth = 1;
    ended("size-at-inputs", mesh(&request), "SIZES", NETMESH_WITH_SIZES);

    request = mesh_request(&netmesh_method_svr);
    request.mesh.audit = NETMESH_AUDIT_QUALITY;
    ended("audit-quality", mesh(&request), "AUDITS", NETMESH_WITH_AUDITS);
    request.mesh.audit = NETMESH_AUDIT_LOCATION;
    ended("audit-location", mesh(&request), "AUDITS", NETMESH_WITH_AUDITS);
}

static void filters(void) {
    const netmesh_function function = function_of_height();
    netmesh_request request = mesh_request(&netmesh_method_svr);
    request.filter = &netmesh_filter_complete;
    if (mesh(&request) != NETMESH_OK) ++faults;
    ended("complete", filter(&netmesh_filter_complete, 0, NULL), "", 1);
    ended("knn-1", filter(&netmesh_filter_knn, 1, NULL), "", 1);
    ended("basic", filter(&netmesh_filter_basic, 0, NULL), "", 1);
    ended("knn-2", filter(&netmesh_filter_knn, 2, NULL), "", 1);
    ended("kdistance", filter(&netmesh_filter_kdistance, 2, NULL), "", 1);
    ended("function", filter(&netmesh_filter_function, 0, &function), "", 1);
    ended("tight", filter(&netmesh_filter_tight, 0, NULL), "", 1);
    request = netmesh_default_request();
    request.filter = &netmesh_filter_knn;
    request.k_last = 3;
    request.vines = &netmesh_vines;
    ended("vineyard", netmesh_persist(context, &request), "", 1);

    request = request_of(&netmesh_filter_complete, 0);
    request.goal.ratio = 2.6;
    ended("clipped", persist(&request), "CERTIFICATE", NETMESH_WITH_CERTIFICATE);
    if (dim < 4) {
        request = request_of(&netmesh_filter_tight, 3);
        request.mesh.method = &netmesh_method_svr;
        ended("tight-mesh", mesh(&request), "SIZES", NETMESH_WITH_SIZES);
    }
}

static void others(void) {
    const netmesh_function function = function_of_height();
    netmesh_request request = request_of(NULL, POINTS);
    request.mesh.method = &netmesh_method_delaunay;
    ended("delaunay", mesh(&request), "", 1);
    ended("alpha", filter(&netmesh_filter_alpha, 0, NULL), "", 1);
    request = request_of(&netmesh_filter_alpha, POINTS);
    ended("alpha-of-points", persist(&request), "", 1);
    if (dim < 4) {
        request = request_of(&netmesh_filter_auto, POINTS);
        ended("auto", persist(&request), "", 1);
    }

    request = request_of(&netmesh_filter_complete, 4);
    request.fit = &netmesh_fit;
    request.goal.ratio = 3;
    ended("fit", persist(&request), "CERTIFICATE", NETMESH_WITH_CERTIFICATE);
    if (dim == 2) {
        request = request_of(&netmesh_filter_function, 4);
        request.fit = &netmesh_fit;
        request.function = &function;
        ended("fit-error", persist(&request), "SIZES", NETMESH_WITH_SIZES);
    }

    request = request_of(&netmesh_filter_scales, dim == 2 ? 6 : 3);
    request.goal.ratio = 3;
    ended("scales-ratio", persist(&request), "CERTIFICATE", NETMESH_WITH_CERTIFICATE);
    if (dim == 2) {
        request.goal.ratio = 0;
        ended("scales-eps", persist(&request), "SIZES", NETMESH_WITH_SIZES);
    }
}

static void dimension(uint32_t d, int built) {
    netmesh_request request;
    uint32_t seed = 12345, i;
    dim = d;
    for (i = 0; i < d * POINTS; ++i) {
        seed = seed * 1664525u + 1013904223u;
        points[i] = seed / 4294967296.0;
    }
    if (built) {
        meshes();
        filters();
        others();
        return;
    }
    request = request_of(NULL, POINTS);
    request.mesh.method = &netmesh_method_delaunay;
    if (mesh(&request) != NETMESH_NOT_BUILT || netmesh_plan_mesh(&request) != 0) {
        fprintf(stderr, "D = %u is left out and does not say so\n", (unsigned)d);
        ++faults;
    }
}

#define IS_DIMENSION(D) d == D ||
int main(void) {
    uint32_t d;
    block = malloc(BLOCK_BYTES);
    if (block == NULL) return 2;
    for (d = 2; d <= 6; ++d) dimension(d, NETMESH_EACH_DIMENSION(IS_DIMENSION) 0);
    free(block);
    return faults > 0;
}
