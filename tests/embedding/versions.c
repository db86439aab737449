/* A program and a library of different versions. This one is built twice: with netmesh.h, and with a header whose
 * structs lack their last member, as an older version's did (header.py). Every struct stands between bytes that the
 * library must leave alone. What both print must be the same. */
#include "netmesh.h"
#include "netmesh/laboratory.h"

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

GUARDED(netmesh_request, request);
GUARDED(netmesh_function, function);
GUARDED(netmesh_distances, distances);
GUARDED(netmesh_simplices, simplices);
GUARDED(netmesh_load_request, load);
GUARDED(netmesh_cages_request, cages);
GUARDED(netmesh_check_request, check);
GUARDED(netmesh_bottleneck_request, bottleneck);
GUARDED(netmesh_wasserstein_request, wasserstein);
GUARDED(netmesh_analyse_request, analyse);
GUARDED(netmesh_request, settled);
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
GUARDED(netmesh_option, option);
GUARDED(netmesh_option_word, word);

static void fill_results(void) {
    FILL(settled), FILL(detail), FILL(report), FILL(analysis), FILL(vertex), FILL(cell), FILL(cage), FILL(voronoi),
        FILL(ball), FILL(pair), FILL(bar), FILL(step);
    FILL(simplex), FILL(vine), FILL(distance), FILL(transport), FILL(figure), FILL(info), FILL(option), FILL(word);
}

/* Between its guards an empty struct of its size. */
#define EMPTY(name) (FILL(name), memset(&(name).it, 0, sizeof((name).it)), (name).it.struct_bytes = sizeof((name).it))

static void fill_requests(void) {
    EMPTY(function), EMPTY(distances), EMPTY(simplices), EMPTY(load), EMPTY(cages), EMPTY(check), EMPTY(analyse);
    FILL(request), FILL(bottleneck), FILL(wasserstein);
    load.it.dim = 2;
    cages.it.cage_bytes = sizeof(netmesh_cage);
    bottleneck.it = netmesh_default_bottleneck();
    wasserstein.it = netmesh_default_wasserstein();
}

/* A request of what the context holds; of `count` points. */
static void ask(const netmesh_filter* filter) {
    request.it = netmesh_default_request();
    request.it.filter = filter;
}
static void ask_of_points(const netmesh_filter* filter, size_t count) {
    ask(filter);
    request.it.points.coordinates = points;
    request.it.points.count = count;
    request.it.points.dim = 2;
}

static void print_report(void) {
    DID(netmesh_get_report(context, &report.it));
    printf("%u vertices, ratio %.17g, fingerprint %016llx\n", (unsigned)report.it.mesh.vertices,
           report.it.diagram.certified_ratio, (unsigned long long)report.it.fingerprint);
}

static void print_figures(void) {
    uint32_t i, w, applying = 0;
    for (i = 0; netmesh_get_report_figure(&report.it, i, &figure.it) == NETMESH_OK; ++i)
        applying += figure.it.applies && strncmp(figure.it.path, "predicates.", 11) != 0;
    printf("%u figures of the report, %u apply without those of predicates\n", i, applying);
    for (i = applying = 0; netmesh_get_analysis_figure(&analysis.it, i, &figure.it) == NETMESH_OK; ++i)
        applying += figure.it.applies && strncmp(figure.it.path, "fatness.", 8) != 0;
    printf("%u figures of the analysis, %u apply without those of fatness\n", i, applying);
    for (i = 0; netmesh_get_filter_info(i, &info.it) == NETMESH_OK; ++i) printf("%s ", info.it.name);
    for (i = 0; netmesh_get_option(i, &option.it) == NETMESH_OK; ++i) {
        printf("%s ", option.it.name);
        for (w = 0; netmesh_get_option_word(i, w, &word.it) == NETMESH_OK; ++w) printf("%s ", word.it.name);
    }
    printf("\n");
    look_at_guards("a table");
}

static void run_mesh(void) {
    uint64_t length;
    ask_of_points(&netmesh_filter_complete, POINTS);
    request.it.mesh.method = &netmesh_method_svr;
    DID(netmesh_mesh(context, &request.it));
    DID(netmesh_check(context, &check.it));
    ask(&netmesh_filter_complete);
    DID(netmesh_persist(context, &request.it));
    request.it.bounds = &netmesh_bounds;
    DID(netmesh_persist(context, &request.it));
    request.it.bounds = NULL;
    request.it.cycles = &netmesh_cycles;
    DID(netmesh_persist(context, &request.it));
    DID(netmesh_analyse(context, &analyse.it, &analysis.it));
    DID(netmesh_get_vertex(context, 1, &vertex.it));
    DID(netmesh_get_cell(context, 1, &cell.it));
    DID(netmesh_get_pair(context, 1, &pair.it));
    DID(netmesh_get_bar_bounds(context, 1, &bar.it));
    DID(netmesh_get_scale_step(context, 0, &step.it));
    DID(netmesh_get_cycle(context, 1, &length));
    DID(netmesh_get_cycle_simplex(context, 1, 0, &simplex.it));
    printf("vertex at %g %g, cell of %u, pair born at %.17g, between %g and %g\n", vertex.it.coordinates[0],
           vertex.it.coordinates[1], (unsigned)cell.it.vertices[0], pair.it.birth, bar.it.birth_low, bar.it.birth_high);
    print_report();
    print_figures();
    ask(&netmesh_filter_knn);
    request.it.k_last = 3;
    request.it.max_degree = 0;
    request.it.vines = &netmesh_vines;
    DID(netmesh_persist(context, &request.it));
    DID(netmesh_get_vine_point(context, 1, &vine.it));
    printf("vine %u born at %.17g\n", (unsigned)vine.it.vine, vine.it.birth);
    ask(&netmesh_filter_function); /* there is none */
    DID(netmesh_persist(context, &request.it));
    DID(netmesh_get_detail(context, &detail.it));
    printf("field %s\n", netmesh_field_text(detail.it.field));
}

static void persist(const netmesh_filter* filter, size_t count) {
    ask_of_points(filter, count);
    DID(netmesh_settle(&request.it, &settled.it, &detail.it));
    printf("method %u, ratio %.17g, degree %u\n", (unsigned)(settled.it.mesh.method == &netmesh_method_certificate),
           settled.it.goal.ratio, (unsigned)settled.it.max_degree);
    DID(netmesh_persist(context, &request.it));
    print_report();
}

static void run_others(void) {
    static const uint32_t vertices[] = {0, 1, 0, 1};
    static const uint64_t starts[] = {0, 1, 2, 4};
    static const double entries[] = {0, 0, 1}, lower[] = {3, 5, 4};
    static const uint8_t markers[3] = {0, 0, 0};
    static const uint32_t one_cell[] = {0, 1, 2};
    ask_of_points(NULL, POINTS);
    request.it.mesh.method = &netmesh_method_delaunay;
    DID(netmesh_mesh(context, &request.it));
    print_report();
    persist(&netmesh_filter_scales, POINTS);
    persist(&netmesh_filter_alpha, POINTS);
    persist(&netmesh_filter_auto, POINTS);
    persist(&netmesh_filter_rips, POINTS);
    distances.it.layout = NETMESH_DISTANCES_LOWER;
    distances.it.numbers = lower;
    distances.it.count = 3;
    ask(&netmesh_filter_rips);
    request.it.distances = &distances.it;
    DID(netmesh_persist(context, &request.it));
    print_report();
    ask_of_points(&netmesh_filter_barycentric_cech, 8);
    request.it.k_last = 2;
    request.it.vines = &netmesh_vines;
    DID(netmesh_persist(context, &request.it));
    print_report();
    ask_of_points(&netmesh_filter_complete, POINTS);
    request.it.fit = &netmesh_fit;
    DID(netmesh_persist(context, &request.it));
    print_report();
    simplices.it.vertices = vertices;
    simplices.it.starts = starts;
    simplices.it.entries = entries;
    simplices.it.simplex_count = 3;
    ask(&netmesh_filter_simplices);
    request.it.simplices = &simplices.it;
    DID(netmesh_persist(context, &request.it));
    print_report();
    simplices.it.step_count = 1;
    request.it.vines = &netmesh_vines;
    DID(netmesh_persist(context, &request.it));
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
    ask_of_points(&netmesh_filter_function, POINTS);
    request.it.function = &function.it; /* which has no function yet */
    DID(netmesh_persist(context, &request.it));
    points[0] = points[2] + 1e-6 * (points[4] - points[2]); /* two points that a cage goes around */
    points[1] = points[3] + 1e-6 * (points[5] - points[3]);
    ask_of_points(NULL, POINTS);
    request.it.mesh.method = &netmesh_method_netmesh;
    DID(netmesh_mesh(context, &request.it));
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
