/* A program and a library of different versions. This one is built twice: with netmesh.h, and with a header whose
 * structs lack their last member, as an older version's did (header.py). Every struct stands between bytes that the
 * library must leave alone. What both print must be the same. */
#include "netmesh.h"

#include <stdio.h>
#include <string.h>

#define POINTS 24
#define BLOCK_BYTES ((size_t)4 << 20)
#define GUARD 0xC3
#define GUARD_BYTES 96

/* A struct `name.it` between guards; GUARDED once for each, FILL before its use, CHECK after each call. */
#define GUARDED(type, name)                                                                                            \
    static struct {                                                                                                    \
        unsigned char before[GUARD_BYTES];                                                                             \
        type it;                                                                                                       \
        unsigned char after[GUARD_BYTES];                                                                              \
    } name
#define FILL(name)                                                                                                     \
    (memset(&(name), GUARD, sizeof(name)), (name).it.struct_bytes = sizeof((name).it),                                 \
     watch(#name, (name).before, (name).after))

static struct {
    const char* name;
    const unsigned char *before, *after;
} watched[64];
static int watched_count, damages;

static void watch(const char* name, const unsigned char* before, const unsigned char* after) {
    watched[watched_count].name = name;
    watched[watched_count].before = before;
    watched[watched_count++].after = after;
}

static void look_at_guards(const char* call) {
    int i, k, bad;
    for (i = 0; i < watched_count; ++i) {
        for (bad = 0, k = 0; k < GUARD_BYTES; ++k) bad += watched[i].before[k] != GUARD || watched[i].after[k] != GUARD;
        if (bad > 0) printf("%s wrote %d bytes beside %s\n", call, bad, watched[i].name);
        damages += bad;
    }
}

/* Prints a call's status; looks at all guards. */
static netmesh_status did(const char* call, netmesh_status status) {
    printf("%s: %s\n", call, netmesh_status_text(status));
    look_at_guards(call);
    return status;
}
#define DID(call) did(#call, call)

static uint64_t memory[BLOCK_BYTES / 8 + 2];
static double points[2 * POINTS];
static netmesh_context* context;

GUARDED(netmesh_delaunay_request, delaunay);
GUARDED(netmesh_mesh_request, mesh);
GUARDED(netmesh_load_request, load);
GUARDED(netmesh_cages_request, cages);
GUARDED(netmesh_check_request, check);
GUARDED(netmesh_function, function);
GUARDED(netmesh_persist_request, persist);
GUARDED(netmesh_bounds_request, bounds);
GUARDED(netmesh_represent_request, represent);
GUARDED(netmesh_fit_request, fit);
GUARDED(netmesh_vineyard_request, vineyard);
GUARDED(netmesh_scales_request, scales);
GUARDED(netmesh_alpha_request, alpha);
GUARDED(netmesh_auto_request, either);
GUARDED(netmesh_points_request, rips);
GUARDED(netmesh_distances_request, distances);
GUARDED(netmesh_points_vineyard_request, nested);
GUARDED(netmesh_homology_request, homology);
GUARDED(netmesh_value_vineyard_request, values);
GUARDED(netmesh_bottleneck_request, bottleneck);
GUARDED(netmesh_wasserstein_request, wasserstein);
GUARDED(netmesh_analyse_request, analyse);
GUARDED(netmesh_detail, detail);
GUARDED(netmesh_report, report);
GUARDED(netmesh_analysis, analysis);
GUARDED(netmesh_vertex, vertex);
GUARDED(netmesh_cell, cell);
GUARDED(netmesh_cage, cage);
GUARDED(netmesh_voronoi, voronoi);
GUARDED(netmesh_ball, ball);
GUARDED(netmesh_pair, pair);
GUARDED(netmesh_bar_bounds, bar);
GUARDED(netmesh_scale_step, step);
GUARDED(netmesh_simplex, simplex);
GUARDED(netmesh_vine_point, vine);
GUARDED(netmesh_distance, distance);
GUARDED(netmesh_wasserstein_distance, transport);
GUARDED(netmesh_figure, figure);
GUARDED(netmesh_filter_info, info);

static void fill_results(void) {
    FILL(detail), FILL(report), FILL(analysis), FILL(vertex), FILL(cell), FILL(cage), FILL(voronoi), FILL(ball),
        FILL(pair), FILL(bar), FILL(step);
    FILL(simplex), FILL(vine), FILL(distance), FILL(transport), FILL(figure), FILL(info);
}

#define POINTS_OF(request) ((request).it.points = points, (request).it.point_count = POINTS)

static void fill_requests(void) {
    FILL(delaunay), FILL(mesh), FILL(load), FILL(cages), FILL(check), FILL(function), FILL(persist), FILL(bounds);
    FILL(represent), FILL(fit), FILL(either), FILL(vineyard), FILL(scales), FILL(rips), FILL(distances), FILL(nested),
        FILL(homology), FILL(values), FILL(bottleneck), FILL(wasserstein), FILL(analyse);
    netmesh_delaunay_request_init(&delaunay.it, sizeof delaunay.it, 2);
    netmesh_mesh_request_init(&mesh.it, sizeof mesh.it, 2);
    netmesh_load_request_init(&load.it, sizeof load.it, 2);
    netmesh_cages_request_init(&cages.it, sizeof cages.it, sizeof(netmesh_cage));
    netmesh_check_request_init(&check.it, sizeof check.it);
    netmesh_function_init(&function.it, sizeof function.it);
    netmesh_persist_request_init(&persist.it, sizeof persist.it);
    netmesh_bounds_request_init(&bounds.it, sizeof bounds.it);
    netmesh_represent_request_init(&represent.it, sizeof represent.it);
    netmesh_fit_request_init(&fit.it, sizeof fit.it, 2);
    netmesh_vineyard_request_init(&vineyard.it, sizeof vineyard.it, NETMESH_FILTER_KNN);
    netmesh_scales_request_init(&scales.it, sizeof scales.it, 2);
    netmesh_alpha_request_init(&alpha.it, sizeof alpha.it, 2);
    netmesh_auto_request_init(&either.it, sizeof either.it, 2);
    netmesh_points_request_init(&rips.it, sizeof rips.it, 2, NETMESH_FILTER_RIPS);
    netmesh_distances_request_init(&distances.it, sizeof distances.it);
    netmesh_points_vineyard_request_init(&nested.it, sizeof nested.it, 2, NETMESH_FILTER_BARYCENTRIC_CECH);
    netmesh_homology_request_init(&homology.it, sizeof homology.it);
    netmesh_value_vineyard_request_init(&values.it, sizeof values.it);
    netmesh_bottleneck_request_init(&bottleneck.it, sizeof bottleneck.it, sizeof(netmesh_pair));
    netmesh_wasserstein_request_init(&wasserstein.it, sizeof wasserstein.it, sizeof(netmesh_pair));
    netmesh_analyse_request_init(&analyse.it, sizeof analyse.it);
    look_at_guards("an init call");
    POINTS_OF(delaunay), POINTS_OF(either), POINTS_OF(mesh), POINTS_OF(fit), POINTS_OF(scales), POINTS_OF(alpha),
        POINTS_OF(rips), POINTS_OF(nested);
    mesh.it.purpose = NETMESH_PURPOSE_PERSIST;
    vineyard.it.k_last = 3;
    nested.it.point_count = 8;
    nested.it.k_last = 2;
#ifndef NETMESH_SHORTER
    vineyard.it.max_degree = 0; /* what an older program cannot say counts as 0 */
#endif
}

static void print_report(void) {
    DID(netmesh_get_report(context, &report.it));
    printf("%u vertices, ratio %.17g, fingerprint %016llx\n", (unsigned)report.it.mesh.vertices,
           report.it.diagram.certified_ratio, (unsigned long long)report.it.fingerprint);
}

static void print_figures(void) {
    uint32_t i, applying = 0;
    for (i = 0; netmesh_get_report_figure(&report.it, i, &figure.it) == NETMESH_OK; ++i)
        applying += figure.it.applies && strncmp(figure.it.path, "predicates.", 11) != 0;
    printf("%u figures of the report, %u apply without those of predicates\n", i, applying);
    for (i = applying = 0; netmesh_get_analysis_figure(&analysis.it, i, &figure.it) == NETMESH_OK; ++i)
        applying += figure.it.applies && strncmp(figure.it.path, "fatness.", 8) != 0;
    printf("%u figures of the analysis, %u apply without those of fatness\n", i, applying);
    for (i = 0; netmesh_get_filter_info(i, &info.it) == NETMESH_OK; ++i) printf("%s ", info.it.name);
    printf("\n");
    look_at_guards("a table");
}

static void run_mesh(void) {
    uint64_t simplices;
    DID(netmesh_mesh(context, &mesh.it));
    DID(netmesh_check(context, &check.it));
    DID(netmesh_persist(context, &persist.it));
    DID(netmesh_bound_bars(context, &bounds.it));
    DID(netmesh_represent(context, &represent.it));
    DID(netmesh_analyse(context, &analyse.it, &analysis.it));
    DID(netmesh_get_vertex(context, 1, &vertex.it));
    DID(netmesh_get_cell(context, 1, &cell.it));
    DID(netmesh_get_pair(context, 1, &pair.it));
    DID(netmesh_get_bar_bounds(context, 1, &bar.it));
    DID(netmesh_get_scale_step(context, 0, &step.it));
    DID(netmesh_get_cycle(context, 1, &simplices));
    DID(netmesh_get_cycle_simplex(context, 1, 0, &simplex.it));
    printf("vertex at %g %g, cell of %u, pair born at %.17g, between %g and %g\n", vertex.it.coordinates[0],
           vertex.it.coordinates[1], (unsigned)cell.it.vertices[0], pair.it.birth, bar.it.birth_low, bar.it.birth_high);
    print_report();
    print_figures();
    DID(netmesh_vineyard(context, &vineyard.it));
    DID(netmesh_get_vine_point(context, 1, &vine.it));
    printf("vine %u born at %.17g\n", (unsigned)vine.it.vine, vine.it.birth);
    persist.it.filter = NETMESH_FILTER_FUNCTION; /* there is none */
    DID(netmesh_persist(context, &persist.it));
    DID(netmesh_get_detail(context, &detail.it));
    printf("field %s\n", netmesh_field_text(detail.it.field));
}

static void run_others(void) {
    static const uint32_t vertices[] = {0, 1, 0, 1};
    static const uint64_t starts[] = {0, 1, 2, 4};
    static const double entries[] = {0, 0, 1};
    static const uint8_t markers[3] = {0, 0, 0};
    static const uint32_t one_cell[] = {0, 1, 2};
    DID(netmesh_delaunay(context, &delaunay.it));
    print_report();
    DID(netmesh_persist_scales(context, &scales.it));
    print_report();
    DID(netmesh_persist_alpha(context, &alpha.it));
    print_report();
    DID(netmesh_persist_auto(context, &either.it));
    print_report();
    DID(netmesh_persist_points(context, &rips.it));
    print_report();
    static const double lower[3] = {3, 5, 4};
    distances.it.layout = NETMESH_DISTANCES_LOWER;
    distances.it.numbers = lower;
    distances.it.point_count = 3;
    DID(netmesh_persist_distances(context, &distances.it));
    print_report();
    DID(netmesh_points_vineyard(context, &nested.it));
    print_report();
    DID(netmesh_fit(context, &fit.it));
    print_report();
    homology.it.vertices = vertices;
    homology.it.starts = starts;
    homology.it.entries = entries;
    homology.it.simplex_count = 3;
    DID(netmesh_homology(context, &homology.it));
    print_report();
    values.it.vertices = vertices;
    values.it.starts = starts;
    values.it.entries = entries;
    values.it.simplex_count = 3;
    values.it.step_count = 1;
    DID(netmesh_value_vineyard(context, &values.it));
    print_report();
    load.it.vertices = points;
    load.it.markers = markers;
    load.it.vertex_count = 3;
    load.it.cells = one_cell;
    load.it.cell_count = 1;
    DID(netmesh_load(context, &load.it));
    print_report();
    netmesh_load_cages(context, &cages.it); /* without a domain; and an older program's cages may be too small */
    look_at_guards("netmesh_load_cages");
    mesh.it.method = NETMESH_METHOD_HIERARCHY;
    mesh.it.purpose = NETMESH_PURPOSE_MESH;
    points[0] = points[2] + 1e-6 * (points[4] - points[2]); /* two points that a cage goes around */
    points[1] = points[3] + 1e-6 * (points[5] - points[3]);
    DID(netmesh_mesh(context, &mesh.it));
    DID(netmesh_get_cage(context, 0, &cage.it));
    printf("cage about %u\n", (unsigned)cage.it.centre);
    bottleneck.it.pairs_a = bottleneck.it.pairs_b = &pair.it;
    bottleneck.it.count_a = bottleneck.it.count_b = 0;
    netmesh_bottleneck(&bottleneck.it, &distance.it,
                       &detail.it); /* an older program's pairs or scratch are too small */
    look_at_guards("netmesh_bottleneck");
    wasserstein.it.pairs_a = wasserstein.it.pairs_b = &pair.it;
    wasserstein.it.count_a = wasserstein.it.count_b = 0;
    netmesh_wasserstein(&wasserstein.it, &transport.it, &detail.it);
    look_at_guards("netmesh_wasserstein");
}

int main(void) {
    const uintptr_t at = (uintptr_t)memory;
    uint64_t state = 5;
    int i;
    for (i = 0; i < 2 * POINTS; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        points[i] = (double)(state >> 40);
    }
    if (netmesh_init((unsigned char*)memory + (16 - at % 16) % 16, BLOCK_BYTES, &context) != NETMESH_OK) return 1;
    fill_requests();
    fill_results();
    run_mesh();
    run_others();
    printf("%d bytes beside structs were written\n", damages);
    return damages == 0 ? 0 : 1;
}
