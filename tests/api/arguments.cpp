// What every call says to arguments that it cannot use: a status, the position of the argument, and the result that was
// there stays.
#include <doctest/doctest.h>

#include <cfenv>
#include <limits>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "common/session.hpp"

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Fixture {
    explicit Fixture(int dim) : session(dim), points(inputs::uniform(dim, 3)), n(3) {
        session.reserve(std::size_t{1} << 22);
        REQUIRE(session.mesh(points, NETMESH_JOB_PERSIST) == NETMESH_OK);
        fingerprint = session.report().fingerprint;
    }
    // `position` 0: of what the call says nothing (the context itself is none).
    void refused(netmesh_status status, std::uint64_t position, netmesh_status expected = NETMESH_INVALID_ARGUMENT) {
        CHECK(status == expected);
        const netmesh_detail detail = netmesh_get_detail(session.context);
        if (position != 0) CHECK(detail.index_a == position);
        if (position != 0) CHECK(detail.message[0] != 0);
        CHECK(session.report().fingerprint == fingerprint);
    }
    netmesh_options with(double netmesh_options::*field, double value) const {
        netmesh_options o = session.options;
        o.*field = value;
        return o;
    }
    Session session;
    inputs::Points points;
    std::size_t n;
    std::uint64_t fingerprint;
};

double one(void*, const double*) { return 1; }

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
    netmesh_options o;
    netmesh_options_init(&o, 3);
    const double x[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::uint8_t marker[3] = {};
    const std::uint32_t index[4] = {0, 1, 2, 3};
    const std::uint64_t start[2] = {0, 1};
    double number[9];
    std::uint32_t order[9];
    netmesh_analysis analysis;
    netmesh_report report;
    netmesh_vertex vertex;
    netmesh_cell cell;
    netmesh_cage cage;
    netmesh_pair pair;
    netmesh_simplex simplex;
    netmesh_scale_step step;
    netmesh_bar_bounds bounds;
    netmesh_vine_point vine_point;
    std::uint64_t count;
    const netmesh_function f = {one, nullptr, 1, 0, 1};
    constexpr netmesh_values values = NETMESH_VALUES_CERTIFIED;
    for (netmesh_context* c : {static_cast<netmesh_context*>(nullptr), not_one}) {
        report.struct_bytes = sizeof report;
        CHECK(netmesh_delaunay(c, x, 3, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_mesh(c, x, 3, NETMESH_JOB_MESH, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_load(c, x, marker, 3, index, 1, nullptr, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_load_cages(c, &cage, 0, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_measure_cells(c, number, order) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_persist(c, NETMESH_FILTER_ALPHA, values, 1, 0, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_persist_function(c, &f, values, 1, 0, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_persist_scales(c, x, 3, values, 1, 0, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_persist_points(c, x, 3, NETMESH_FILTER_RIPS, values, 1, 1, 0, 0, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_homology(c, index, start, x, 1, 0, 0, 0, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_vineyard(c, NETMESH_FILTER_KNN, 1, 1, values, 1, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_represent(c, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_bound_bars(c, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_check(c, 1, &o) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_analyse(c, 1, 0, &o, &analysis) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_well_paced_order(c, order, number) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_pace(c, index, number) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_report(c, &report) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_vertex(c, 0, &vertex) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_cell(c, 0, &cell) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_cage(c, 0, &cage) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_pair(c, 0, &pair) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_cycle(c, 0, &count) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_cycle_simplex(c, 0, 0, &simplex) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_bar_bounds(c, 0, &bounds) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_scale_step(c, 0, &step) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_vine_point(c, 0, &vine_point) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_vine_ratio(c, 1, number) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_detail(c).status == NETMESH_OK);
    }
    for (int status = 0; status <= NETMESH_NOT_A_COMPLEX + 1; ++status)
        CHECK(netmesh_status_text(static_cast<netmesh_status>(status))[0] != 0);
}

TEST_CASE("a context that holds nothing") {
    Session s(3);
    double number[4];
    std::uint32_t order[4] = {};
    netmesh_analysis analysis;
    analysis.struct_bytes = sizeof analysis;
    netmesh_cage cage = {};
    std::uint64_t count;
    const netmesh_function f = {one, nullptr, 1, 0, 1};
    CHECK(netmesh_measure_cells(s.context, number, order) == NETMESH_NO_RESULT);
    CHECK(netmesh_load_cages(s.context, &cage, 1, &s.options) == NETMESH_NO_RESULT);
    CHECK(netmesh_persist(s.context, NETMESH_FILTER_ALPHA, NETMESH_VALUES_CERTIFIED, 1, 0, &s.options) ==
          NETMESH_NO_RESULT);
    CHECK(netmesh_persist_function(s.context, &f, NETMESH_VALUES_CERTIFIED, 1, 0, &s.options) == NETMESH_NO_RESULT);
    CHECK(netmesh_vineyard(s.context, NETMESH_FILTER_KNN, 1, 1, NETMESH_VALUES_CERTIFIED, 1, &s.options) ==
          NETMESH_NO_RESULT);
    CHECK(netmesh_represent(s.context, &s.options) == NETMESH_NO_RESULT);
    CHECK(netmesh_bound_bars(s.context, &s.options) == NETMESH_NO_RESULT);
    CHECK(netmesh_check(s.context, 1, &s.options) == NETMESH_NO_RESULT);
    CHECK(netmesh_analyse(s.context, 2, 0, &s.options, &analysis) == NETMESH_NO_RESULT);
    CHECK(netmesh_well_paced_order(s.context, order, number) == NETMESH_NO_RESULT);
    CHECK(netmesh_pace(s.context, order, number) == NETMESH_NO_RESULT);
    CHECK(netmesh_get_cycle(s.context, 0, &count) == NETMESH_NO_RESULT);
}

TEST_CASE("points, jobs and options") {
    for (int dim = 2; dim <= 6; ++dim) {
        Fixture f(dim);
        netmesh_context* const c = f.session.context;
        const double* const x = f.points.data();
        const netmesh_options o = f.session.options;
        const std::size_t many = (std::size_t{1} << 28) + 1;
        constexpr netmesh_job job = NETMESH_JOB_MESH;
        f.refused(netmesh_delaunay(c, nullptr, f.n, &o), 2);
        f.refused(netmesh_delaunay(c, x, 0, &o), 3);
        f.refused(netmesh_delaunay(c, x, many, &o), 3);
        f.refused(netmesh_delaunay(c, x, f.n, nullptr), 4);
        netmesh_options bad = o;
        bad.struct_bytes = 4;
        f.refused(netmesh_delaunay(c, x, f.n, &bad), 4);
        for (const std::uint32_t d : {1u, 7u}) {
            bad = o;
            bad.dim = d;
            f.refused(netmesh_delaunay(c, x, f.n, &bad), 4);
            f.refused(netmesh_mesh(c, x, f.n, job, &bad), 5);
        }
        f.refused(netmesh_mesh(c, nullptr, f.n, job, &o), 2);
        f.refused(netmesh_mesh(c, x, 0, job, &o), 3);
        for (const int wrong : {-1, 0, 1, 4, 6})
            f.refused(netmesh_mesh(c, x, f.n, static_cast<netmesh_job>(wrong), &o), 4);
        for (const double tau : {2.0, -1.0, not_a_number, infinite}) {
            bad = f.with(&netmesh_options::tau, tau);
            f.refused(netmesh_mesh(c, x, f.n, job, &bad), 5);
            f.refused(netmesh_persist_scales(c, x, f.n, NETMESH_VALUES_CERTIFIED, 1, 0, &bad), 7);
            CHECK(netmesh_plan_bytes(job, &bad, 10) == 0);
        }
        for (const double eps : {-1.0, not_a_number, infinite}) {
            bad = f.with(&netmesh_options::over_refine_eps, eps);
            f.refused(netmesh_mesh(c, x, f.n, job, &bad), 5);
        }
        for (const double factor : {0.5, 9.0, not_a_number}) {
            bad = f.with(&netmesh_options::domain_factor, factor);
            f.refused(netmesh_mesh(c, x, f.n, job, &bad), 5);
        }
        for (const double eps : {-1.0, 0.75, not_a_number}) {
            bad = f.with(&netmesh_options::eps, eps);
            f.refused(netmesh_mesh(c, x, f.n, NETMESH_JOB_PERSIST_TIGHT, &bad), 5);
            f.refused(netmesh_persist_scales(c, x, f.n, NETMESH_VALUES_CERTIFIED, 1, 0, &bad), 7);
            CHECK(netmesh_plan_bytes(NETMESH_JOB_PERSIST_TIGHT, &bad, 10) == 0);
        }
        for (const double theta : {-1.0, 0.25, not_a_number}) {
            bad = f.with(&netmesh_options::theta, theta);
            f.refused(netmesh_persist_scales(c, x, f.n, NETMESH_VALUES_CERTIFIED, 1, 0, &bad), 7);
        }
        for (const int method : {-1, 3}) {
            bad = o;
            bad.method = static_cast<netmesh_method>(method);
            f.refused(netmesh_mesh(c, x, f.n, job, &bad), 5);
            CHECK(netmesh_plan_bytes(job, &bad, 10) == 0);
        }
        bad = o;
        bad.method = NETMESH_METHOD_NETMESH;
        f.refused(netmesh_mesh(c, x, f.n, NETMESH_JOB_PERSIST, &bad), 4);
        bad.over_refine_eps = 0.5;
        f.refused(netmesh_mesh(c, x, f.n, job, &bad), 5);

        f.refused(netmesh_persist_scales(c, nullptr, f.n, NETMESH_VALUES_CERTIFIED, 1, 0, &o), 2);
        f.refused(netmesh_persist_scales(c, x, 0, NETMESH_VALUES_CERTIFIED, 1, 0, &o), 3);
        f.refused(netmesh_persist_scales(c, x, many, NETMESH_VALUES_CERTIFIED, 1, 0, &o), 3);
        f.refused(netmesh_persist_scales(c, x, f.n, static_cast<netmesh_values>(2), 1, 0, &o), 4);
        f.refused(netmesh_persist_scales(c, x, f.n, NETMESH_VALUES_CERTIFIED, 1, 0, nullptr), 7);
        constexpr netmesh_filter rips = NETMESH_FILTER_RIPS, bary = NETMESH_FILTER_BARYCENTRIC_CECH;
        constexpr netmesh_values values = NETMESH_VALUES_CERTIFIED;
        f.refused(netmesh_persist_points(c, nullptr, f.n, rips, values, 1, 1, 0, 0, &o), 2);
        f.refused(netmesh_persist_points(c, x, 0, rips, values, 1, 1, 0, 0, &o), 3);
        f.refused(netmesh_persist_points(c, x, many, rips, values, 1, 1, 0, 0, &o), 3);
        f.refused(netmesh_persist_points(c, x, f.n, NETMESH_FILTER_ALPHA, values, 1, 1, 0, 0, &o), 4);
        f.refused(netmesh_persist_points(c, x, f.n, rips, static_cast<netmesh_values>(7), 1, 1, 0, 0, &o), 5);
        f.refused(netmesh_persist_points(c, x, f.n, bary, values, 0, 1, 0, 0, &o), 6);
        f.refused(netmesh_persist_points(c, x, f.n, rips, values, 1, 31, 0, 0, &o), 7);
        f.refused(netmesh_persist_points(c, x, f.n, rips, values, 1, 1, 0, 0, nullptr), 10);
        CHECK(netmesh_points_bytes(rips, &o, 0, 1, 1) == 0);
        CHECK(netmesh_points_bytes(rips, nullptr, 5, 1, 1) == 0);
        CHECK(netmesh_points_bytes(rips, &o, many, 1, 1) == 0);
        CHECK(netmesh_points_bytes(NETMESH_FILTER_ALPHA, &o, 5, 1, 1) == 0);
        CHECK(netmesh_points_bytes(rips, &o, many - 1, 1, 30) == SIZE_MAX);
        CHECK(netmesh_plan_bytes(job, nullptr, 10) == 0);
        CHECK(netmesh_plan_bytes(job, &o, 0) == 0);
        CHECK(netmesh_plan_bytes(job, &o, many) == 0);
        CHECK(netmesh_plan_bytes(static_cast<netmesh_job>(7), &o, 10) == 0);
        bad = f.with(&netmesh_options::over_refine_eps, -1);
        CHECK(netmesh_plan_bytes(job, &bad, 10) == 0);
        bad = f.with(&netmesh_options::over_refine_eps, 1e-9);
        CHECK(netmesh_plan_bytes(NETMESH_JOB_PERSIST_TIGHT, &bad, many - 1) == SIZE_MAX);
        CHECK(netmesh_plan_bytes(NETMESH_JOB_DELAUNAY, &o, 1) > 0);
    }
}

TEST_CASE("what is planned grows with what is asked for") {
    for (int dim = 2; dim <= 6; ++dim) {
        CAPTURE(dim);
        netmesh_options o;
        netmesh_options_init(&o, static_cast<std::uint32_t>(dim));
        const auto plan = [&o](netmesh_job job, std::uint64_t points = 1000) {
            return static_cast<double>(netmesh_plan_bytes(job, &o, points));
        };
        CHECK(plan(NETMESH_JOB_DELAUNAY) < plan(NETMESH_JOB_MESH));
        CHECK(plan(NETMESH_JOB_MESH) < plan(NETMESH_JOB_PERSIST));
        CHECK(plan(NETMESH_JOB_DELAUNAY) < plan(NETMESH_JOB_PERSIST_ALPHA));
        CHECK(plan(NETMESH_JOB_PERSIST) < plan(NETMESH_JOB_PERSIST_TIGHT));
        CHECK(plan(NETMESH_JOB_PERSIST_TIGHT) < plan(NETMESH_JOB_PERSIST_SCALES));
        // A size smaller than the tight filter's counts, a larger one does not.
        const double tight = plan(NETMESH_JOB_PERSIST_TIGHT);
        o.over_refine_eps = 0.5;
        CHECK(plan(NETMESH_JOB_PERSIST_TIGHT) == tight);
        o.over_refine_eps = 0.01;
        CHECK(plan(NETMESH_JOB_PERSIST_TIGHT) > tight);
        o.over_refine_eps = 0;
        const double mesh = plan(NETMESH_JOB_MESH);
        o.method = NETMESH_METHOD_NETMESH;
        const double caged = plan(NETMESH_JOB_MESH);
        CHECK(caged > mesh);
        o.method = NETMESH_METHOD_SVR;
        o.audit = NETMESH_AUDIT_LOCATION;
        CHECK(plan(NETMESH_JOB_MESH) > caged);
        // Coarse meshes: the lists of balls of each point take most. They have a third of what is left.
        o.tau = 1e6;
        const double balls[] = {0, 0, 8, 24, 96, 480, 2400};
        CHECK(plan(NETMESH_JOB_MESH, 100000) > 3 * 16 * balls[dim] * 100000);
    }
}

TEST_CASE("jobs that go beyond what they are for") {
    for (int dim = 2; dim <= 3; ++dim) {
        CAPTURE(dim);
        Session s(dim);
        const inputs::Points points = inputs::uniform(dim, 1);
        s.options.domain_factor = 5;  // more than the tight filter needs
        s.options.over_refine_eps = 0.1;
        REQUIRE(s.mesh(points, NETMESH_JOB_PERSIST_TIGHT) == NETMESH_OK);
        CHECK(s.report().over_refine_eps == 0.1);
        s.options.domain_factor = 0;
        s.options.over_refine_eps = 0.5;
        REQUIRE(s.mesh(points, NETMESH_JOB_PERSIST_TIGHT) == NETMESH_OK);
        CHECK(s.report().over_refine_eps < 0.12);
        s.options.audit = NETMESH_AUDIT_QUALITY;
        CHECK(netmesh_mesh(s.context, points.data(), 1, NETMESH_JOB_MESH, &s.options) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_detail(s.context).index_a == 5);
    }
    for (int dim = 2; dim <= 6; ++dim) {
        CAPTURE(dim);
        Session s(dim);
        const inputs::Points points = inputs::uniform(dim, 3);
        REQUIRE(s.mesh(points) == NETMESH_OK);
        const std::uint64_t print = s.report().fingerprint;
        s.options.audit = NETMESH_AUDIT_QUALITY;
        REQUIRE(s.mesh(points) == NETMESH_OK);
        CHECK(s.report().audit.meshes > 0);
        CHECK(s.report().aspect_ratio_max <= netmesh_tau(&s.options));
        s.options.audit = 0;
        s.options.over_refine_eps = 1e-16;  // below what coordinates resolve
        CHECK(netmesh_mesh(s.context, points.data(), 3, NETMESH_JOB_MESH, &s.options) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_detail(s.context).index_a == 6);
        CHECK(s.report().cells == 0);
        s.options.over_refine_eps = 0;
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

TEST_CASE("dimensions that there are not") {
    netmesh_options o;
    netmesh_options_init(&o, 0);
    CHECK(o.dim == NETMESH_DIM_MIN);
    netmesh_options_init(&o, 100);
    CHECK(o.dim == NETMESH_DIM_MAX);
}

TEST_CASE("points beyond what lists can number") {
    // More points than a graph of edges is made for, and more simplices than 62 bits number: both are listed, one by one, until stopped.
    Session s(2);
    s.reserve(std::size_t{1} << 24);
    s.options.poll = [](void*, const netmesh_progress* progress) {
        return int(progress->stage == NETMESH_STAGE_FILTER);
    };
    const auto rips = [&](std::size_t n, std::uint32_t degree) {
        const inputs::Points points = inputs::uniform(2, n);
        return netmesh_persist_points(s.context, points.data(), n, NETMESH_FILTER_RIPS, NETMESH_VALUES_CERTIFIED, 1,
                                      degree, 0, 0, &s.options);
    };
    CHECK(rips(65537, 1) == NETMESH_CANCELLED);
    CHECK(rips(300, 30) == NETMESH_CANCELLED);
    const inputs::Points few = inputs::uniform(2, 3);
    CHECK(netmesh_persist_points(s.context, few.data(), 3, NETMESH_FILTER_BARYCENTRIC_CECH, NETMESH_VALUES_CERTIFIED,
                                 31, 0, 0, 0, &s.options) == NETMESH_INVALID_ARGUMENT);
}

TEST_CASE("steps after a mesh") {
    for (int dim = 2; dim <= 6; ++dim) {
        Fixture f(dim);
        netmesh_context* const c = f.session.context;
        const netmesh_options o = f.session.options;
        constexpr netmesh_filter complete = NETMESH_FILTER_COMPLETE, knn = NETMESH_FILTER_KNN;
        constexpr netmesh_values values = NETMESH_VALUES_CERTIFIED;
        const auto wrong_values = static_cast<netmesh_values>(2);
        f.refused(netmesh_persist(c, NETMESH_FILTER_NONE, values, 1, 0, &o), 2);
        f.refused(netmesh_persist(c, NETMESH_FILTER_RIPS, values, 1, 0, &o), 2);
        f.refused(netmesh_persist(c, NETMESH_FILTER_FUNCTION, values, 1, 0, &o), 2);
        f.refused(netmesh_persist(c, complete, wrong_values, 1, 0, &o), 3);
        f.refused(netmesh_persist(c, complete, values, 1, 0, nullptr), 6);
        f.refused(netmesh_persist(c, NETMESH_FILTER_ALPHA, values, 1, 0, &o), 0, NETMESH_NO_RESULT);
        netmesh_options bad = o;
        bad.k = 4;
        f.refused(netmesh_persist(c, knn, values, 1, 0, &bad), 7);
        f.refused(netmesh_vineyard(c, complete, 1, 2, values, 1, &o), 2);
        f.refused(netmesh_vineyard(c, knn, 0, 2, values, 1, &o), 3);
        f.refused(netmesh_vineyard(c, knn, 2, 1, values, 1, &o), 4);
        f.refused(netmesh_vineyard(c, knn, 1, 2, wrong_values, 1, &o), 5);
        f.refused(netmesh_vineyard(c, knn, 1, 4, values, 1, &o), 7);
        f.refused(netmesh_vineyard(c, knn, 1, 2, values, 1, nullptr), 8);
        f.refused(netmesh_persist_function(c, nullptr, values, 1, 0, &o), 2);
        netmesh_function function = {nullptr, nullptr, 1, 0, 1};
        f.refused(netmesh_persist_function(c, &function, values, 1, 0, &o), 2);
        for (double netmesh_function::*field :
             {&netmesh_function::lipschitz, &netmesh_function::distance_factor, &netmesh_function::cut})
            for (const double number : {-1.0, not_a_number, infinite}) {
                function = {one, nullptr, 1, 0, 1};
                function.*field = number;
                f.refused(netmesh_persist_function(c, &function, values, 1, 0, &o), 2);
            }
        function = {one, nullptr, 1, 0, 1};
        f.refused(netmesh_persist_function(c, &function, wrong_values, 1, 0, &o), 3);
        f.refused(netmesh_persist_function(c, &function, values, 1, 0, nullptr), 6);
        f.refused(netmesh_represent(c, nullptr), 2);
        f.refused(netmesh_represent(c, &o), 0, NETMESH_NO_RESULT);
        f.refused(netmesh_bound_bars(c, nullptr), 2);
        f.refused(netmesh_bound_bars(c, &o), 0, NETMESH_NO_RESULT);
        f.refused(netmesh_check(c, 0, &o), 2);
        f.refused(netmesh_check(c, 32, &o), 2);
        f.refused(netmesh_check(c, 1, nullptr), 3);
        netmesh_analysis analysis;
        analysis.struct_bytes = sizeof analysis;
        f.refused(netmesh_analyse(c, 0, 0, &o, &analysis), 2);
        f.refused(netmesh_analyse(c, 8, 0, &o, &analysis), 2);
        f.refused(netmesh_analyse(c, 2, -1, &o, &analysis), 3);
        f.refused(netmesh_analyse(c, 2, 0, nullptr, &analysis), 4);
        f.refused(netmesh_analyse(c, 2, 0, &o, nullptr), 5);
        analysis.struct_bytes = 1;
        f.refused(netmesh_analyse(c, 2, 0, &o, &analysis), 5);
        std::vector<double> number(f.session.report().vertices);
        std::vector<std::uint32_t> index(f.session.report().vertices);
        f.refused(netmesh_measure_cells(c, nullptr, index.data()), 2);
        f.refused(netmesh_measure_cells(c, number.data(), nullptr), 3);
        f.refused(netmesh_well_paced_order(c, nullptr, number.data()), 2);
        f.refused(netmesh_pace(c, nullptr, number.data()), 2);
        f.refused(netmesh_pace(c, index.data(), nullptr), 3);
        f.refused(netmesh_pace(c, index.data(), number.data()), 2);  // 0, 0, 0 is no permutation
        CHECK(netmesh_well_paced_order(c, index.data(), nullptr) == NETMESH_OK);
        f.refused(netmesh_load_cages(c, nullptr, 1, &o), 2);
        netmesh_cage cage = {0, NETMESH_NONE, 1};
        f.refused(netmesh_load_cages(c, &cage, NETMESH_NONE, &o), 3);
        f.refused(netmesh_load_cages(c, &cage, 1, nullptr), 4);
        for (const netmesh_cage wrong : {netmesh_cage{0, NETMESH_NONE, -1}, netmesh_cage{1u << 20, NETMESH_NONE, 1},
                                         netmesh_cage{0, NETMESH_NONE, not_a_number}})
            f.refused(netmesh_load_cages(c, &wrong, 1, &o), 0, NETMESH_CHECK_FAILED);
    }
}

TEST_CASE("what cannot be read") {
    Fixture f(3);
    netmesh_context* const c = f.session.context;
    netmesh_report report;
    report.struct_bytes = 4;
    netmesh_simplex simplex;
    netmesh_bar_bounds bounds;
    std::uint64_t count;
    CHECK(netmesh_get_report(c, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_report(c, &report) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vertex(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_cell(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_cage(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_pair(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vine_point(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vine_ratio(c, 1, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_cycle(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_cycle_simplex(c, 0, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_bar_bounds(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    const netmesh_options& o = f.session.options;
    REQUIRE(netmesh_persist(c, NETMESH_FILTER_BASIC, NETMESH_VALUES_THESIS, 2, 1, &o) == NETMESH_OK);
    CHECK(netmesh_get_scale_step(c, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_bound_bars(c, &o) == NETMESH_OK);
    CHECK(netmesh_represent(c, &o) == NETMESH_OK);
    CHECK(netmesh_represent(c, &o) == NETMESH_OK);  // they are there already
    const std::uint64_t pairs = f.session.pairs().size();
    CHECK(netmesh_get_cycle(c, pairs, &count) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(netmesh_get_cycle(c, 0, &count) == NETMESH_OK);
    CHECK(netmesh_get_cycle_simplex(c, 0, count, &simplex) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(netmesh_persist(c, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_THESIS, 2, 1, &o) == NETMESH_OK);
    CHECK(netmesh_bound_bars(c, &o) == NETMESH_OK);
    CHECK(netmesh_bound_bars(c, &o) == NETMESH_OK);
    CHECK(netmesh_get_bar_bounds(c, f.session.pairs().size(), &bounds) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(netmesh_vineyard(c, NETMESH_FILTER_KNN, 2, 3, NETMESH_VALUES_CERTIFIED, 1, &o) == NETMESH_OK);
    double ratio;
    CHECK(netmesh_get_vine_ratio(c, 1, &ratio) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vine_ratio(c, 4, &ratio) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vine_ratio(c, 3, &ratio) == NETMESH_OK);
}

TEST_CASE("complexes and distances") {
    Session s(2);
    const std::uint32_t v[] = {0, 1, 0, 1};
    const std::uint64_t starts[] = {0, 1, 2, 4};
    const double t[] = {0, 0, 1};
    const auto refused = [&](netmesh_status status, std::uint64_t position) {
        CHECK(status == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_detail(s.context).index_a == position);
    };
    refused(netmesh_homology(s.context, nullptr, starts, t, 3, 1, 0, 0, &s.options), 2);
    refused(netmesh_homology(s.context, v, nullptr, t, 3, 1, 0, 0, &s.options), 3);
    refused(netmesh_homology(s.context, v, starts, nullptr, 3, 1, 0, 0, &s.options), 4);
    refused(netmesh_homology(s.context, v, starts, t, 0, 1, 0, 0, &s.options), 5);
    refused(netmesh_homology(s.context, v, starts, t, 3, 1, 0, 0, nullptr), 9);
    CHECK(netmesh_homology_bytes(0, 0) == 0);
    CHECK(netmesh_homology_bytes(5, 4) == 0);
    CHECK(netmesh_homology_bytes(1, UINT64_MAX) == 0);

    const netmesh_pair a[] = {{0, 0, 1}};
    alignas(16) static unsigned char scratch[4096];
    netmesh_distance d;
    const auto distance = [&](const netmesh_pair* x, const netmesh_pair* y, int scale, void* where, std::size_t bytes,
                              netmesh_distance* out) {
        return netmesh_bottleneck(x, 1, y, 1, NETMESH_ALL_DEGREES, static_cast<netmesh_scale>(scale), where, bytes,
                                  nullptr, nullptr, out);
    };
    CHECK(distance(a, a, 0, scratch, sizeof scratch, &d) == NETMESH_OK);
    CHECK(distance(nullptr, a, 0, scratch, sizeof scratch, &d) == NETMESH_INVALID_ARGUMENT);
    CHECK(distance(a, nullptr, 0, scratch, sizeof scratch, &d) == NETMESH_INVALID_ARGUMENT);
    CHECK(distance(a, a, 2, scratch, sizeof scratch, &d) == NETMESH_INVALID_ARGUMENT);
    CHECK(distance(a, a, 0, nullptr, sizeof scratch, &d) == NETMESH_INVALID_ARGUMENT);
    CHECK(distance(a, a, 0, scratch + 8, sizeof scratch - 8, &d) == NETMESH_INVALID_ARGUMENT);
    CHECK(distance(a, a, 0, scratch, sizeof scratch, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(distance(a, a, 0, nullptr, 0, &d) == NETMESH_OUT_OF_MEMORY);
}
