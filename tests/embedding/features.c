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

/* Of a job that takes what is there: a line for the full build's result, or the reason of another one. */
static void taken(const char* job, netmesh_status status) {
    netmesh_report report;
    if (NETMESH_WITH_ALPHA) {
        ended(job, status, "", 1);
        return;
    }
    report.struct_bytes = sizeof report;
    netmesh_get_report(context, &report);
    if (status == NETMESH_OK && report.diagram.filter == NETMESH_FILTER_COMPLETE &&
        report.diagram.why == NETMESH_WHY_NOT_BUILT)
        return;
    fprintf(stderr, "D = %u, %s: status %d, filter %d\n", (unsigned)dim, job, (int)status, (int)report.diagram.filter);
    ++faults;
}

static void fresh(void) { netmesh_init(block, BLOCK_BYTES, &context); }

static netmesh_mesh_request mesh_request(void) {
    netmesh_mesh_request request;
    netmesh_mesh_request_init(&request, sizeof request, dim);
    request.points = points;
    request.point_count = dim == 2 ? POINTS : dim == 3 ? 10 : 4;
    if (dim > 3) request.tau = 6;
    return request;
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
    netmesh_function function;
    netmesh_function_init(&function, sizeof function);
    function.evaluate = height;
    function.lipschitz = 1;
    function.cut = 4;
    return function;
}

static netmesh_status persist(netmesh_filter filter, uint32_t k, const netmesh_function* function) {
    netmesh_persist_request request;
    netmesh_persist_request_init(&request, sizeof request);
    request.filter = filter;
    request.k = k;
    request.function = function;
    return netmesh_persist(context, &request);
}

static void meshes(void) {
    netmesh_mesh_request request = mesh_request();
    fresh();
    ended("svr", netmesh_mesh(context, &request), "", 1);

    request.method = NETMESH_METHOD_HIERARCHY;
    fresh();
    ended("cages", netmesh_mesh(context, &request), "CAGES", NETMESH_WITH_CAGES);
    request.finish = 1;
    fresh();
    ended("finished", netmesh_mesh(context, &request), "CAGES", NETMESH_WITH_CAGES);
    if (dim < 4) {
        request.finish = 0;
        request.cage_kind = NETMESH_CAGES_THESIS;
        request.tau = 6;
        fresh();
        ended("thesis-cages", netmesh_mesh(context, &request), "THESIS_CAGES", NETMESH_WITH_THESIS_CAGES);
    }

    if (dim < 4) {
        request = mesh_request();
        request.method = NETMESH_METHOD_REFINE;
        request.point_count = 3;
        fresh();
        ended("refine", netmesh_mesh(context, &request), "REFINE", NETMESH_WITH_REFINE);
    }

    request = mesh_request();
    request.sizes.size = even_size;
    fresh();
    ended("sizes", netmesh_mesh(context, &request), "SIZES", NETMESH_WITH_SIZES);
    request = mesh_request();
    request.size_at_inputs = request.size_growth = 1;
    fresh();
    ended("size-at-inputs", netmesh_mesh(context, &request), "SIZES", NETMESH_WITH_SIZES);

    request = mesh_request();
    request.audit = NETMESH_AUDIT_QUALITY;
    fresh();
    ended("audit-quality", netmesh_mesh(context, &request), "AUDITS", NETMESH_WITH_AUDITS);
    request.audit = NETMESH_AUDIT_LOCATION;
    fresh();
    ended("audit-location", netmesh_mesh(context, &request), "AUDITS", NETMESH_WITH_AUDITS);
}

static void filters(void) {
    const netmesh_function function = function_of_height();
    netmesh_mesh_request request = mesh_request();
    netmesh_vineyard_request vineyard;
    request.purpose = NETMESH_PURPOSE_PERSIST;
    fresh();
    if (netmesh_mesh(context, &request) != NETMESH_OK) ++faults;
    ended("complete", persist(NETMESH_FILTER_COMPLETE, 0, NULL), "", 1);
    ended("knn-1", persist(NETMESH_FILTER_KNN, 1, NULL), "", 1);
    ended("basic", persist(NETMESH_FILTER_BASIC, 0, NULL), "BASIC", NETMESH_WITH_BASIC);
    ended("knn-2", persist(NETMESH_FILTER_KNN, 2, NULL), "NEAREST_K", NETMESH_WITH_NEAREST_K);
    ended("kdistance", persist(NETMESH_FILTER_KDISTANCE, 2, NULL), "NEAREST_K", NETMESH_WITH_NEAREST_K);
    ended("function", persist(NETMESH_FILTER_FUNCTION, 0, &function), "FUNCTION", NETMESH_WITH_FUNCTION);
    ended("tight", persist(NETMESH_FILTER_TIGHT, 0, NULL), "TIGHT", NETMESH_WITH_TIGHT);
    netmesh_vineyard_request_init(&vineyard, sizeof vineyard, NETMESH_FILTER_KNN);
    vineyard.k_last = 3;
    ended("vineyard", netmesh_vineyard(context, &vineyard), "NEAREST_K", NETMESH_WITH_NEAREST_K);

    request.certificate.ratio = 2.6;
    fresh();
    {
        const netmesh_status status = netmesh_mesh(context, &request);
        ended("clipped", status == NETMESH_OK ? persist(NETMESH_FILTER_COMPLETE, 0, NULL) : status, "CERTIFICATE",
              NETMESH_WITH_CERTIFICATE);
    }
    if (dim < 4) {
        request = mesh_request();
        request.purpose = NETMESH_PURPOSE_TIGHT;
        request.point_count = 3;
        fresh();
        ended("tight-mesh", netmesh_mesh(context, &request), "SIZES", NETMESH_WITH_SIZES);
    }
}

static void others(void) {
    const netmesh_function function = function_of_height();
    netmesh_delaunay_request delaunay;
    netmesh_alpha_request alpha;
    netmesh_auto_request either;
    netmesh_fit_request fit;
    netmesh_scales_request scales;
    netmesh_delaunay_request_init(&delaunay, sizeof delaunay, dim);
    delaunay.points = points;
    delaunay.point_count = POINTS;
    fresh();
    ended("delaunay", netmesh_delaunay(context, &delaunay), "", 1);
    ended("alpha", persist(NETMESH_FILTER_ALPHA, 0, NULL), "ALPHA", NETMESH_WITH_ALPHA);
    netmesh_alpha_request_init(&alpha, sizeof alpha, dim);
    alpha.points = points;
    alpha.point_count = POINTS;
    fresh();
    ended("alpha-of-points", netmesh_persist_alpha(context, &alpha), "", 1);
    /* takes whichever filter is there */
    netmesh_auto_request_init(&either, sizeof either, dim);
    either.points = points;
    either.point_count = POINTS;
    if (dim < 4) {
        fresh();
        taken("auto", netmesh_persist_auto(context, &either));
    }

    netmesh_fit_request_init(&fit, sizeof fit, dim);
    fit.points = points;
    fit.point_count = 4;
    fit.ratio = 3;
    fresh();
    ended("fit", netmesh_fit(context, &fit), "CERTIFICATE", NETMESH_WITH_CERTIFICATE);
    fit.ratio = 0;
    fit.by_error = 1;
    fit.filter = NETMESH_FILTER_FUNCTION;
    fit.function = &function;
    fit.values = NETMESH_VALUES_THESIS;
    if (dim == 2) {
        fresh();
        ended("fit-error", netmesh_fit(context, &fit), "SIZES FUNCTION", NETMESH_WITH_SIZES && NETMESH_WITH_FUNCTION);
    }

    netmesh_scales_request_init(&scales, sizeof scales, dim);
    scales.points = points;
    scales.point_count = dim == 2 ? 6 : 3;
    scales.ratio = 3;
    fresh();
    ended("scales-ratio", netmesh_persist_scales(context, &scales), "CERTIFICATE", NETMESH_WITH_CERTIFICATE);
    scales.ratio = 0;
    if (dim == 2) {
        fresh();
        ended("scales-eps", netmesh_persist_scales(context, &scales), "SIZES TIGHT",
              NETMESH_WITH_SIZES && NETMESH_WITH_TIGHT);
    }
}

static void dimension(uint32_t d, int built) {
    netmesh_delaunay_request request;
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
    netmesh_delaunay_request_init(&request, sizeof request, d);
    request.points = points;
    request.point_count = POINTS;
    fresh();
    if (netmesh_delaunay(context, &request) != NETMESH_NOT_BUILT || netmesh_plan_delaunay(&request) != 0) {
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
