// What every call says to arguments that it cannot use: a status and the field at fault; the result that was there
// stays. Requests that contradict themselves: settle.cpp.
#include <doctest/doctest.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"
#include "refusals.hpp"

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t many = Fixture::many;

using R = netmesh_request;
R of_simplices(const netmesh_simplices& simplices, const netmesh_want* vines = nullptr) {
    netmesh::Request r(&netmesh_filter_simplices);
    r.simplices = &simplices;
    r.vines = vines;
    return r;
}

// Every call that takes a context and can say that it is none.
template <class Request>
void no_context(netmesh_context* c, netmesh_status (*job)(netmesh_context*, const Request*), const Request& request) {
    CHECK(job(c, &request) == NETMESH_INVALID_ARGUMENT);
}
template <class Item>
void no_context(netmesh_context* c, netmesh_status (*get)(const netmesh_context*, std::uint64_t, Item*)) {
    auto item = netmesh::sized<Item>();
    CHECK(get(c, 0, &item) == NETMESH_INVALID_ARGUMENT);
}

}  // namespace

TEST_CASE("blocks and contexts that are none") {
    netmesh_context* context;
    alignas(16) static unsigned char block[16384];
    CHECK(netmesh_init(nullptr, 16384, &context) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_init(block, sizeof block, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_init(block + 8, sizeof block - 8, &context) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_init(block, 100, &context) == NETMESH_OUT_OF_MEMORY);
    CHECK(netmesh_adopt(nullptr, &context) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_adopt(block, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_adopt(block + 4, &context) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_adopt(block, &context) == NETMESH_INVALID_ARGUMENT);
    CHECK(context == nullptr);

    netmesh_context* const not_one = reinterpret_cast<netmesh_context*>(block);
    const inputs::Points x = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::uint8_t marker[3] = {};
    const std::uint32_t index[4] = {0, 1, 2, 3};
    double number[9];
    std::uint32_t order[9];
    std::uint64_t count;
    Calls calls(3);
    auto load = netmesh::sized<netmesh_load_request>();
    load.dim = 3;
    load.vertices = x.data();
    load.markers = marker;
    load.vertex_count = 3;
    load.cells = index;
    load.cell_count = 1;
    const R simplices = of_simplices(an_edge), steps = of_simplices(two_steps, &netmesh_vines);
    for (netmesh_context* c : {static_cast<netmesh_context*>(nullptr), not_one}) {
        calls.context = c;
        no_context<R>(c, netmesh_mesh, calls.delaunay_request(x));
        no_context<R>(c, netmesh_mesh, calls.mesh_request(x));
        no_context(c, netmesh_load, load);
        no_context(c, netmesh_load_cages, netmesh::sized<netmesh_cages_request>());
        no_context<R>(c, netmesh_persist, persist_by(&netmesh_filter_alpha));
        no_context<R>(c, netmesh_persist, calls.alpha_request(x));
        no_context<R>(c, netmesh_persist, calls.auto_request(x));
        no_context<R>(c, netmesh_persist, calls.scales_request(x));
        no_context<R>(c, netmesh_persist, calls.points_request(x, &netmesh_filter_rips));
        no_context<R>(c, netmesh_persist, calls.nested_request(x, &netmesh_filter_barycentric_cech, 2));
        no_context(c, netmesh_persist, simplices);
        no_context(c, netmesh_persist, steps);
        no_context<R>(c, netmesh_persist, calls.fit_request(x));
        CHECK(calls.vineyard(&netmesh_filter_knn, 1, 1) == NETMESH_INVALID_ARGUMENT);
        CHECK(calls.represent() == NETMESH_INVALID_ARGUMENT);
        CHECK(calls.bound_bars() == NETMESH_INVALID_ARGUMENT);
        CHECK(calls.check() == NETMESH_INVALID_ARGUMENT);
        auto analysis = netmesh::sized<netmesh_analysis>();
        CHECK(calls.analyse(&analysis) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_measure_cells(c, number, order) == NETMESH_INVALID_ARGUMENT);
        auto voronoi = netmesh::sized<netmesh_voronoi>();
        auto ball = netmesh::sized<netmesh_ball>();
        CHECK(netmesh_measure_voronoi(c, &voronoi) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_measure_balls(c, &ball) == NETMESH_INVALID_ARGUMENT);
        auto weighted = netmesh::sized<netmesh_weighted_cell>();
        CHECK(netmesh_weighted_cells(c, &weighted) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_well_paced_order(c, order, number) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_pace(c, index, number) == NETMESH_INVALID_ARGUMENT);
        auto report = netmesh::sized<netmesh_report>();
        CHECK(netmesh_get_report(c, &report) == NETMESH_INVALID_ARGUMENT);
        no_context(c, netmesh_get_vertex);
        no_context(c, netmesh_get_cell);
        no_context(c, netmesh_get_cage);
        no_context(c, netmesh_get_pair);
        no_context(c, netmesh_get_bar_bounds);
        no_context(c, netmesh_get_scale_step);
        no_context(c, netmesh_get_vine_point);
        auto simplex = netmesh::sized<netmesh_simplex>();
        CHECK(netmesh_get_cycle(c, 0, &count) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_cycle_simplex(c, 0, 0, &simplex) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_vine_ratio(c, 1, number) == NETMESH_INVALID_ARGUMENT);
        auto detail = netmesh::sized<netmesh_detail>();
        CHECK(netmesh_get_detail(c, &detail) == NETMESH_INVALID_ARGUMENT);
        CHECK(detail.status == NETMESH_OK);
        CHECK(detail.message != nullptr);
    }
    for (int status = 0; status <= NETMESH_STACK_OVERFLOW + 1; ++status)
        CHECK(netmesh_status_text(static_cast<netmesh_status>(status))[0] != 0);
    for (int field = 0; field <= NETMESH_FIELD_COUNT; ++field) {
        const char* const text = netmesh_field_text(static_cast<netmesh_field>(field));
        CHECK(text[0] != 0);
        CHECK((std::strcmp(text, "unknown field") == 0) == (field == NETMESH_FIELD_COUNT));
    }
    CHECK(netmesh_version() == NETMESH_VERSION);
    const std::string version = std::to_string(NETMESH_VERSION_MAJOR) + "." + std::to_string(NETMESH_VERSION_MINOR) +
                                "." + std::to_string(NETMESH_VERSION_PATCH);
    CHECK(netmesh_version_text() == version);
}

TEST_CASE("a context that holds nothing") {
    Session s(3);
    double number[4];
    std::uint32_t order[4] = {};
    auto analysis = netmesh::sized<netmesh_analysis>();
    Arrays cages(3);
    cages.cages.push_back(netmesh::sized<netmesh_cage>());
    std::uint64_t count;
    netmesh::Request bounds(&netmesh_filter_complete), cycles(&netmesh_filter_complete);
    bounds.bounds = &netmesh_bounds;
    cycles.cycles = &netmesh_cycles;
    CHECK(netmesh_measure_cells(s.context, number, order) == NETMESH_NO_RESULT);
    auto weighted = netmesh::sized<netmesh_weighted_cell>();
    CHECK(netmesh_weighted_cells(s.context, &weighted) == NETMESH_NO_RESULT);
    CHECK(cages.load_cages(s) == NETMESH_NO_RESULT);
    CHECK(s.persist(&netmesh_filter_alpha) == NETMESH_NO_RESULT);
    CHECK(s.persist(a_function, netmesh::Request()) == NETMESH_NO_RESULT);
    CHECK(s.vineyard(&netmesh_filter_knn, 1, 1) == NETMESH_NO_RESULT);
    CHECK(s.persist(cycles) == NETMESH_NO_RESULT);
    CHECK(s.persist(bounds) == NETMESH_NO_RESULT);
    CHECK(s.check(1) == NETMESH_NO_RESULT);
    CHECK(s.analyse(&analysis, 2) == NETMESH_NO_RESULT);
    CHECK(netmesh_well_paced_order(s.context, order, number) == NETMESH_NO_RESULT);
    CHECK(netmesh_pace(s.context, order, number) == NETMESH_NO_RESULT);
    CHECK(netmesh_get_cycle(s.context, 0, &count) == NETMESH_NO_RESULT);
    const netmesh_report r = s.report();
    CHECK(r.input.present + r.mesh.present + r.diagram.present + r.bounds.present + r.scales.present +
              r.vineyard.present + r.simplicial_complex.present ==
          0);
    CHECK(r.fingerprint == 0);
    CHECK(r.memory.block_bytes > 0);
}

TEST_CASE("plans of what cannot be") {
    CHECK(netmesh_plan(nullptr) == 0);
    CHECK(netmesh_plan_mesh(nullptr) == 0);
    for (const auto plan : {netmesh_plan_polls, netmesh_plan_mesh_polls}) {
        std::uint64_t most = 1;
        CHECK(plan(nullptr, &most) == 0);
        CHECK(most == 0);
        CHECK(plan(nullptr, nullptr) == 0);
    }
    for (const int served : dimensions()) {
        const std::uint32_t dim = static_cast<std::uint32_t>(served);
        const auto of = [&](const netmesh_filter* filter) {
            netmesh::Request r(filter);
            CHECK(netmesh_plan(&r) == 0);  // of what a context holds
            r.points.dim = dim;
            CHECK(netmesh_plan(&r) == 0);
            CHECK(netmesh_plan_mesh(&r) == 0);
            r.points.count = many;
            CHECK(netmesh_plan(&r) == 0);
            CHECK(netmesh_plan_mesh(&r) == 0);
            return r;
        };
        netmesh::Request rips = of(&netmesh_filter_rips);
        rips.points.count = many - 1;
        rips.max_degree = 30;
        CHECK(netmesh_plan(&rips) == SIZE_MAX);
        CHECK(netmesh_plan_mesh(&rips) == 0);

        netmesh::Request nested = of(&netmesh_filter_barycentric_rips);
        nested.vines = &netmesh_vines;
        nested.points.count = many - 1;
        nested.k_last = 29;
        CHECK(netmesh_plan(&nested) == SIZE_MAX);
        nested.points.count = 9;
        nested.k_last = 3;
        const std::size_t three = netmesh_plan(&nested);
        nested.k_last = 4;
        CHECK(netmesh_plan(&nested) > three);
        nested.points.dim = 7;
        CHECK(netmesh_plan(&nested) == 0);

        netmesh::Request mesh = of(nullptr);
        mesh.points.count = many - 1;
        CHECK(netmesh_plan_mesh(&mesh) == 0);  // by no method
        mesh.mesh.method = &netmesh_method_svr;
        mesh.filter = &netmesh_filter_tight;
        mesh.mesh.sizes.eps = -1;
        CHECK(netmesh_plan_mesh(&mesh) == 0);
        mesh.mesh.sizes.eps = 1e-9;
        CHECK(netmesh_plan_mesh(&mesh) == SIZE_MAX);
        CHECK(netmesh_plan(&mesh) == SIZE_MAX);

        netmesh::Request delaunay = of(nullptr);
        delaunay.mesh.method = &netmesh_method_delaunay;
        delaunay.points.count = 1;
        CHECK(netmesh_plan_mesh(&delaunay) > 0);
        delaunay.filter = &netmesh_filter_tight;
        CHECK(netmesh_plan_mesh(&delaunay) == 0);

        netmesh::Request scales = of(&netmesh_filter_scales);
        scales.points.count = 10;
        CHECK(netmesh_plan(&scales) > 0);
        scales.goal.eps = 0.75;
        CHECK(netmesh_plan(&scales) == 0);
        scales.goal.eps = 0.5, scales.goal.ratio = 3;
        CHECK(netmesh_plan(&scales) == 0);
    }
}

// The plan knows nothing of the points but how they lie.
template <class Plan> void check_layout(netmesh::Request request, std::uint32_t dim, Plan plan) {
    netmesh_points& points = request.points;
    points.dim = dim;
    points.count = 8;
    points.stride_bytes = 8 * dim + 8;
    CHECK(plan(&request) > 0);
    const std::size_t too_short = 8 * dim - 8, odd = 8 * dim + 1, too_long = SIZE_MAX / 2;
    for (const std::size_t bad : {too_short, odd, too_long}) {
        CAPTURE(bad);
        points.stride_bytes = bad;
        CHECK(plan(&request) == 0);
    }
    points.format = NETMESH_POINTS_FLOAT32;
    points.stride_bytes = 4 * dim;
    CHECK(plan(&request) > 0);
    points.stride_bytes = 0;
    points.format = static_cast<netmesh_point_format>(2);
    CHECK(plan(&request) == 0);
}

TEST_CASE("plans of points that cannot lie so") {
    for (const int served : dimensions()) {
        const std::uint32_t dim = static_cast<std::uint32_t>(served);
        CAPTURE(dim);
        netmesh::Request mesh;
        for (const netmesh_method* const method : {&netmesh_method_svr, &netmesh_method_delaunay}) {
            mesh.mesh.method = method;
            check_layout(mesh, dim, netmesh_plan_mesh);
        }
        for (const netmesh_filter* const filter : {&netmesh_filter_complete, &netmesh_filter_alpha,
                                                   &netmesh_filter_auto, &netmesh_filter_scales, &netmesh_filter_rips})
            check_layout(netmesh::Request(filter), dim, netmesh_plan);
        netmesh::Request nested(&netmesh_filter_barycentric_rips);
        nested.vines = &netmesh_vines;
        nested.k_last = 2;
        check_layout(nested, dim, netmesh_plan);
    }
}

TEST_CASE("what is planned grows with what is asked for") {
    for (const int served : dimensions()) {
        const std::uint32_t dim = static_cast<std::uint32_t>(served);
        CAPTURE(dim);
        netmesh::Request m;
        m.points.dim = dim;
        m.points.count = 1000;
        m.mesh.method = &netmesh_method_svr;
        // Of the mesh alone, or of the diagram.
        const auto plan = [&m](const netmesh_filter* filter) {
            m.filter = filter;
            return static_cast<double>(filter == nullptr ? netmesh_plan_mesh(&m) : netmesh_plan(&m));
        };
        const netmesh_filter *const complete = &netmesh_filter_complete, *const tight_filter = &netmesh_filter_tight;
        netmesh::Request d, alpha(&netmesh_filter_alpha), scales(&netmesh_filter_scales);
        d.points = alpha.points = scales.points = m.points;
        d.mesh.method = &netmesh_method_delaunay;
        scales.goal.eps = 0.5;
        const double delaunay = static_cast<double>(netmesh_plan_mesh(&d));
        alpha.keep_mesh = 1;
        CHECK(delaunay < plan(nullptr));
        CHECK(plan(nullptr) < plan(complete));
        CHECK(delaunay < static_cast<double>(netmesh_plan(&alpha)));
        CHECK(plan(complete) < plan(tight_filter));
        CHECK(plan(tight_filter) < static_cast<double>(netmesh_plan(&scales)));
        // A size smaller than the tight filter's counts, a larger one does not.
        const double tight = plan(tight_filter);
        m.mesh.sizes.eps = 0.5;
        CHECK(plan(tight_filter) == tight);
        m.mesh.sizes.eps = 0.01;
        CHECK(plan(tight_filter) > tight);
        m.mesh.sizes.eps = 0;
        const double mesh = plan(nullptr);
        m.mesh.method = &netmesh_method_netmesh;
        const double caged = plan(nullptr);
        CHECK(caged > mesh);
        m.mesh.method = &netmesh_method_svr;
        m.mesh.audit = NETMESH_AUDIT_LOCATION;
        CHECK(plan(nullptr) > caged);
        // Coarse meshes: the lists of balls of each point take most. They have a third of what is left.
        m.mesh.tau = 1e6;
        m.points.count = 100000;
        const double balls = by_dimension<double>(served, {8, 24, 96, 480, 2400});
        CHECK(plan(nullptr) > 3 * 16 * balls * 100000);
    }
}

TEST_CASE("jobs that go beyond what they are for") {
    for (const int dim : dimensions(2, 3)) {
        CAPTURE(dim);
        Session s(dim);
        const inputs::Points points = inputs::uniform(dim, 1);
        s.request.mesh.domain_factor = 5;  // more than the tight filter needs
        s.request.mesh.sizes.eps = 0.1;
        REQUIRE(s.mesh(points, &netmesh_filter_tight) == NETMESH_OK);
        CHECK(s.report().mesh.sizes.eps == 0.1);
        s.request.mesh.domain_factor = 0;
        s.request.mesh.sizes.eps = 0.5;
        REQUIRE(s.mesh(points, &netmesh_filter_tight) == NETMESH_OK);
        CHECK(s.report().mesh.sizes.eps < 0.12);
        s.request.mesh.audit = NETMESH_AUDIT_LOCATION;
        CHECK(s.mesh(points) == NETMESH_INVALID_ARGUMENT);
        CHECK(s.detail().field == NETMESH_FIELD_AUDIT);
    }
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        const inputs::Points points = inputs::uniform(dim, 3);
        REQUIRE(s.mesh(points) == NETMESH_OK);
        const std::uint64_t print = s.report().fingerprint;
        s.request.mesh.audit = NETMESH_AUDIT_QUALITY;
        REQUIRE(s.mesh(points) == NETMESH_OK);
        CHECK(s.report().mesh.audit.meshes > 0);
        netmesh_request settled;
        REQUIRE(netmesh::settle(s.mesh_request(points, &netmesh_filter_complete), &settled) == NETMESH_OK);
        CHECK(s.report().mesh.tau == settled.mesh.tau);
        CHECK(s.report().mesh.aspect_ratio_max <= settled.mesh.tau);
        s.request.mesh.audit = 0;
        s.request.mesh.sizes.eps = 1e-16;  // below what coordinates resolve
        CHECK(s.mesh_in_block(points) == NETMESH_INVALID_ARGUMENT);
        CHECK(s.detail().field == NETMESH_FIELD_SIZES);
        CHECK(s.report().mesh.present == 0);
        s.request.mesh.sizes.eps = 0;
        REQUIRE(s.mesh(points) == NETMESH_OK);
        CHECK(s.report().fingerprint == print);
    }
}

TEST_CASE("another floating-point mode is refused") {
    netmesh_context* context;
    alignas(16) static unsigned char block[16384];
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        REQUIRE(std::fesetround(mode) == 0);
        const netmesh_status status = netmesh_init(block, sizeof block, &context);
        std::fesetround(FE_TONEAREST);
        CHECK(status == NETMESH_FLOATING_POINT);
        CHECK(context == nullptr);
    }
#if defined(__SSE2__)
    const unsigned before = _mm_getcsr();
    for (const unsigned flush : {0x8000u, 0x40u}) {  // results that are denormal; operands
        _mm_setcsr(before | flush);
        const netmesh_status status = netmesh_init(block, sizeof block, &context);
        _mm_setcsr(before);
        CHECK(status == NETMESH_FLOATING_POINT);
    }
#endif
    CHECK(netmesh_init(block, sizeof block, &context) == NETMESH_OK);
}

TEST_CASE("points beyond what a table of edges holds, and simplices beyond what has numbers") {
    Session s(2);
    s.reserve(std::size_t{1} << 27);
    const auto rips = [&](std::size_t n, std::uint32_t degree, double threshold) {
        const inputs::Points points = inputs::uniform(2, n);
        netmesh::Request r = s.points_request(points, &netmesh_filter_rips, 1, degree);
        r.threshold = threshold;
        return netmesh_persist(s.context, &r);
    };
    CHECK(rips(65537, 1, 0.003) == NETMESH_OK);
    CHECK(s.report().diagram.simplices > 2 * 65537);
    CHECK(s.report().diagram.pairs[0] == 65537);
    // These are listed, one by one, until stopped.
    s.request.monitor.poll = [](void*, const netmesh_progress* progress) {
        return int(progress->stage == NETMESH_STAGE_FILTER);
    };
    CHECK(rips(300, 30, HUGE_VAL) == NETMESH_CANCELLED);
    const inputs::Points few = inputs::uniform(2, 3);
    const netmesh::Request r = s.points_request(few, &netmesh_filter_barycentric_cech, 4, 0);
    CHECK(netmesh_persist(s.context, &r) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.detail().field == NETMESH_FIELD_K);
}

TEST_CASE("filters after a mesh") {
    for (const int dim : dimensions()) {
        Fixture f(dim);
        Session& s = f.session;
        f.needs_request<R>(netmesh_persist, persist_by(&netmesh_filter_complete));
        for (const netmesh_filter* const filter :
             {&netmesh_filter_auto, &netmesh_filter_scales, &netmesh_filter_rips, &netmesh_filter_cech,
              &netmesh_filter_barycentric_cech, &netmesh_filter_barycentric_rips})
            f.refused(s.persist(filter), NETMESH_FIELD_POINTS);
        f.refused(s.vineyard(&netmesh_filter_barycentric_cech, 1, 2), NETMESH_FIELD_POINTS);
        f.ended(s.persist(&netmesh_filter_alpha), NETMESH_NO_RESULT);
        f.refused(s.persist(persist_by(&netmesh_filter_knn, 4)), NETMESH_FIELD_K);

        netmesh::Request vines(&netmesh_filter_knn);
        vines.vines = &netmesh_vines;
        f.needs_request<R>(netmesh_persist, vines);
        f.refused(s.vineyard(&netmesh_filter_complete, 0, 0), NETMESH_FIELD_VINES);
        f.refused(s.vineyard(&netmesh_filter_knn, 2, 1), NETMESH_FIELD_K_LAST);
        f.refused(s.vineyard(&netmesh_filter_knn, 1, 4), NETMESH_FIELD_K_LAST);

        netmesh_function function = constant_one();
        const netmesh::Request by_function(&netmesh_filter_function);
        function.evaluate = nullptr;
        f.refused(s.persist(function, by_function), NETMESH_FIELD_FUNCTION);
        function = constant_one();
        function.struct_bytes = 0;
        f.refused(s.persist(function, by_function), NETMESH_FIELD_STRUCT_BYTES);
        const std::pair<double netmesh_function::*, netmesh_field> numbers[] = {
            {&netmesh_function::lipschitz, NETMESH_FIELD_LIPSCHITZ},
            {&netmesh_function::distance_factor, NETMESH_FIELD_DISTANCE_FACTOR},
            {&netmesh_function::cut, NETMESH_FIELD_CUT}};
        for (const auto& [member, field] : numbers)
            for (const double number : {field == NETMESH_FIELD_CUT ? infinite : -1.0, not_a_number, infinite}) {
                function = constant_one();
                function.*member = number;
                f.refused(s.persist(function, by_function), field);
            }
        // Nothing is kept of a diagram that nobody asked for.
        std::uint64_t count;
        auto bounds = netmesh::sized<netmesh_bar_bounds>();
        CHECK(netmesh_get_cycle(f.c, 0, &count) == NETMESH_NO_RESULT);
        CHECK(netmesh_get_bar_bounds(f.c, 0, &bounds) != NETMESH_OK);
    }
}

TEST_CASE("checks, analyses and cages after a mesh") {
    for (const int dim : dimensions()) {
        Fixture f(dim);
        Session& s = f.session;
        f.needs_request<netmesh_check_request>(netmesh_check, netmesh::sized<netmesh_check_request>());
        CHECK(s.check(0) == NETMESH_OK);  // all of them
        f.refused(s.check(32), NETMESH_FIELD_WHAT);
        auto analysis = netmesh::sized<netmesh_analysis>();
        CHECK(s.analyse(&analysis, 0) == NETMESH_OK);
        CHECK(analysis.what == NETMESH_ANALYSE_ALL);
        f.refused(s.analyse(&analysis, 8), NETMESH_FIELD_WHAT);
        f.refused(s.analyse(&analysis, 2, -1), NETMESH_FIELD_TOLERANCE);
        const auto analyse = netmesh::sized<netmesh_analyse_request>();
        f.refused(netmesh_analyse(f.c, nullptr, &analysis), NETMESH_FIELD_REQUEST);
        f.refused(netmesh_analyse(f.c, &analyse, nullptr), NETMESH_FIELD_RESULT);
        analysis.struct_bytes = 1;
        f.refused(netmesh_analyse(f.c, &analyse, &analysis), NETMESH_FIELD_RESULT);

        std::vector<double> number(s.report().mesh.vertices);
        std::vector<std::uint32_t> index(s.report().mesh.vertices);
        f.refused(netmesh_measure_cells(f.c, nullptr, index.data()), NETMESH_FIELD_RESULT);
        f.refused(netmesh_measure_cells(f.c, number.data(), nullptr), NETMESH_FIELD_RESULT);
        f.refused(netmesh_weighted_cells(f.c, nullptr), NETMESH_FIELD_RESULT);
        netmesh_weighted_cell weighted = {};
        f.refused(netmesh_weighted_cells(f.c, &weighted), NETMESH_FIELD_RESULT);
        weighted = netmesh::sized<netmesh_weighted_cell>();
        CHECK(netmesh_weighted_cells(f.c, &weighted) == NETMESH_OK);  // there are no cages
        CHECK(weighted.weight == 0);
        f.refused(netmesh_well_paced_order(f.c, nullptr, number.data()), NETMESH_FIELD_ORDER);
        f.refused(netmesh_pace(f.c, nullptr, number.data()), NETMESH_FIELD_ORDER);
        f.refused(netmesh_pace(f.c, index.data(), nullptr), NETMESH_FIELD_THETAS);
        f.refused(netmesh_pace(f.c, index.data(), number.data()), NETMESH_FIELD_ORDER);  // 0, 0, 0
        CHECK(netmesh_well_paced_order(f.c, index.data(), nullptr) == NETMESH_OK);

        auto cage = netmesh::sized<netmesh_cage>();
        auto cages = netmesh::sized<netmesh_cages_request>();
        cages.cage_count = 1;
        f.needs_request<netmesh_cages_request>(netmesh_load_cages, cages);
        f.refused(netmesh_load_cages(f.c, &cages), NETMESH_FIELD_CAGES);
        cages.cages = &cage;
        cages.cage_bytes = 4;
        f.refused(netmesh_load_cages(f.c, &cages), NETMESH_FIELD_CAGE_BYTES);
        cages.cage_bytes = sizeof cage;
        cages.cage_count = NETMESH_NONE;
        f.refused(netmesh_load_cages(f.c, &cages), NETMESH_FIELD_CAGE_COUNT);
        cages.cage_count = 1;
        cages.cage_bytes = dim % 2 == 0 ? 0 : sizeof cage;  // 0: as the first cage says
        const std::pair<std::uint32_t, double> wrong[] = {{0, -1}, {1u << 20, 1}, {0, not_a_number}};
        for (const auto& [centre, radius] : wrong) {
            cage.centre = centre;
            cage.radius = radius;
            f.ended(netmesh_load_cages(f.c, &cages), NETMESH_CHECK_FAILED);
        }
    }
}

TEST_CASE("what cannot be read") {
    Fixture f(3);
    Session& s = f.session;
    netmesh_context* const c = f.c;
    netmesh_report report;
    report.struct_bytes = 2;
    auto simplex = netmesh::sized<netmesh_simplex>();
    auto bounds = netmesh::sized<netmesh_bar_bounds>();
    netmesh_vertex vertex;
    vertex.struct_bytes = 0;
    std::uint64_t count;
    CHECK(netmesh_get_report(c, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_report(c, &report) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_detail(c, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vertex(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vertex(c, 0, &vertex) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_cell(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_cage(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_pair(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vine_point(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vine_ratio(c, 1, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_cycle(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_cycle_simplex(c, 0, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_bar_bounds(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    netmesh::Request all = persist_by(&netmesh_filter_basic, 0, NETMESH_VALUES_THESIS);
    all.keep_zero_pairs = 1;
    REQUIRE(s.persist(all) == NETMESH_OK);
    CHECK(netmesh_get_scale_step(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.bound_bars() == NETMESH_OK);
    CHECK(s.represent() == NETMESH_OK);
    CHECK(s.represent() == NETMESH_OK);  // they are there already
    const std::uint64_t pairs = s.pairs().size();
    CHECK(netmesh_get_cycle(c, pairs, &count) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(netmesh_get_cycle(c, 0, &count) == NETMESH_OK);
    CHECK(netmesh_get_cycle_simplex(c, 0, count, &simplex) == NETMESH_INVALID_ARGUMENT);
    all.filter = &netmesh_filter_complete;
    REQUIRE(s.persist(all) == NETMESH_OK);
    CHECK(s.bound_bars() == NETMESH_OK);
    CHECK(s.bound_bars() == NETMESH_OK);
    CHECK(netmesh_get_bar_bounds(c, s.pairs().size(), &bounds) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(s.vineyard(&netmesh_filter_knn, 2, 3) == NETMESH_OK);
    double ratio;
    CHECK(netmesh_get_vine_ratio(c, 1, &ratio) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vine_ratio(c, 4, &ratio) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vine_ratio(c, 3, &ratio) == NETMESH_OK);
}

TEST_CASE("complexes") {
    Fixture f(2);
    const R good = of_simplices(an_edge);
    const auto refused = [&](auto change, netmesh_field field) {
        netmesh_simplices bad = an_edge;
        change(bad);
        R request = good;
        request.simplices = &bad;
        f.refused(netmesh_persist(f.c, &request), field);
    };
    f.needs_request<R>(netmesh_persist, good);
    refused([](auto& s) { s.struct_bytes = 0; }, NETMESH_FIELD_STRUCT_BYTES);
    refused([](auto& s) { s.vertices = nullptr; }, NETMESH_FIELD_VERTICES);
    refused([](auto& s) { s.starts = nullptr; }, NETMESH_FIELD_STARTS);
    refused([](auto& s) { s.entries = nullptr; }, NETMESH_FIELD_ENTRIES);
    refused([](auto& s) { s.simplex_count = 0; }, NETMESH_FIELD_SIMPLEX_COUNT);
    refused([](auto& s) { s.vertex_count = 3; }, NETMESH_FIELD_VERTEX_COUNT);
    const auto plan = [&](std::uint64_t simplex_count, std::uint64_t vertex_count) {
        auto simplices = netmesh::sized<netmesh_simplices>();
        simplices.simplex_count = simplex_count;
        simplices.vertex_count = vertex_count;
        R request = good;
        request.simplices = &simplices;
        return netmesh_plan(&request);
    };
    CHECK(plan(0, 0) == 0);
    CHECK(plan(5, 4) == 0);
    CHECK(plan(1, UINT64_MAX) == 0);
    CHECK(plan(3, 4) > 16384);
    CHECK(netmesh_persist(f.c, &good) == NETMESH_OK);
    CHECK(f.session.report().simplicial_complex.vertices == 2);
}
