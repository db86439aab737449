// What every call says to arguments that it cannot use: a status and the field at fault; the result that was there
// stays.
#include <doctest/doctest.h>

#include <cfenv>
#include <cstring>
#include <limits>
#include <utility>
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
constexpr netmesh_filter no_filter = static_cast<netmesh_filter>(15);  // the largest value that the type can hold

double one(void*, const double*) { return 1; }

netmesh_function constant_one() {
    netmesh::requests::Function function;
    function.evaluate = one;
    function.lipschitz = function.cut = 1;
    return function;
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
    const std::uint64_t start[2] = {0, 1};
    double number[9];
    std::uint32_t order[9];
    std::uint64_t count;
    Calls calls(3);
    netmesh::requests::Load load(3);
    load.vertices = x.data();
    load.markers = marker;
    load.vertex_count = 3;
    load.cells = index;
    load.cell_count = 1;
    netmesh::requests::Homology homology;
    homology.vertices = index;
    homology.starts = start;
    homology.entries = x.data();
    homology.simplex_count = 1;
    for (netmesh_context* c : {static_cast<netmesh_context*>(nullptr), not_one}) {
        calls.context = c;
        no_context(c, netmesh_delaunay, calls.delaunay_request(x));
        no_context(c, netmesh_mesh, calls.mesh_request(x));
        no_context<netmesh_load_request>(c, netmesh_load, load);
        no_context<netmesh_cages_request>(c, netmesh_load_cages, netmesh::requests::Cages());
        no_context(c, netmesh_persist, persist_by(NETMESH_FILTER_ALPHA));
        no_context(c, netmesh_persist_auto, calls.auto_request(x));
        no_context(c, netmesh_persist_scales, calls.scales_request(x));
        no_context(c, netmesh_persist_points, calls.points_request(x, NETMESH_FILTER_RIPS));
        no_context(c, netmesh_points_vineyard, calls.nested_request(x, NETMESH_FILTER_BARYCENTRIC_CECH, 2));
        no_context<netmesh_homology_request>(c, netmesh_homology, homology);
        no_context<netmesh_value_vineyard_request>(c, netmesh_value_vineyard, netmesh::requests::ValueVineyard());
        no_context<netmesh_fit_request>(c, netmesh_fit, on(x, netmesh::requests::Fit(3)));
        CHECK(calls.vineyard(NETMESH_FILTER_KNN, 1, 1) == NETMESH_INVALID_ARGUMENT);
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
    for (int status = 0; status <= NETMESH_NOT_BUILT + 1; ++status)
        CHECK(netmesh_status_text(static_cast<netmesh_status>(status))[0] != 0);
    for (int field = 0; field <= NETMESH_FIELD_COUNT; ++field) {
        const char* const text = netmesh_field_text(static_cast<netmesh_field>(field));
        CHECK(text[0] != 0);
        CHECK((std::strcmp(text, "unknown field") == 0) == (field == NETMESH_FIELD_COUNT));
    }
    CHECK(netmesh_version() == NETMESH_VERSION);
    CHECK(std::strcmp(netmesh_version_text(), "0.2.0") == 0);
}

TEST_CASE("a context that holds nothing") {
    Session s(3);
    double number[4];
    std::uint32_t order[4] = {};
    auto analysis = netmesh::sized<netmesh_analysis>();
    Arrays cages(3);
    cages.cages.push_back(netmesh::sized<netmesh_cage>());
    std::uint64_t count;
    const netmesh_function f = constant_one();
    netmesh_persist_request by_function = persist_by(NETMESH_FILTER_FUNCTION);
    by_function.function = &f;
    CHECK(netmesh_measure_cells(s.context, number, order) == NETMESH_NO_RESULT);
    auto weighted = netmesh::sized<netmesh_weighted_cell>();
    CHECK(netmesh_weighted_cells(s.context, &weighted) == NETMESH_NO_RESULT);
    CHECK(cages.load_cages(s) == NETMESH_NO_RESULT);
    CHECK(s.persist(NETMESH_FILTER_ALPHA) == NETMESH_NO_RESULT);
    CHECK(s.persist(by_function) == NETMESH_NO_RESULT);
    CHECK(s.vineyard(NETMESH_FILTER_KNN, 1, 1) == NETMESH_NO_RESULT);
    CHECK(s.represent() == NETMESH_NO_RESULT);
    CHECK(s.bound_bars() == NETMESH_NO_RESULT);
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

TEST_CASE("points and what is asked of meshes") {
    for (const int dim : dimensions()) {
        Fixture f(dim);
        const netmesh_mesh_request good = f.session.mesh_request(f.points);
        const auto refused = [&](auto change, netmesh_field field) {
            netmesh_mesh_request bad = good;
            change(bad);
            f.refused(netmesh_mesh(f.c, &bad), field);
            return bad;
        };
        f.needs_points(netmesh_delaunay, f.session.delaunay_request(f.points));
        f.needs_points(netmesh_mesh, good);
        for (const int wrong : {-1, 3})
            refused([=](auto& r) { r.purpose = static_cast<netmesh_purpose>(wrong); }, NETMESH_FIELD_PURPOSE);
        for (const double tau : {2.0, -1.0, not_a_number, infinite}) {
            const netmesh_mesh_request bad = refused([=](auto& r) { r.tau = tau; }, NETMESH_FIELD_TAU);
            CHECK(netmesh_plan_mesh(&bad) == 0);
        }
        for (const double eps : {-1.0, not_a_number, infinite})
            refused([=](auto& r) { r.sizes.eps = eps; }, NETMESH_FIELD_SIZES);
        for (const double size : {-1.0, not_a_number, infinite}) {
            refused([=](auto& r) { r.size_at_inputs = size; }, NETMESH_FIELD_SIZE_AT_INPUTS);
            refused([=](auto& r) { r.size_at_inputs = 1, r.size_growth = size; }, NETMESH_FIELD_SIZE_GROWTH);
        }
        refused([](auto& r) { r.size_growth = 0.5; }, NETMESH_FIELD_SIZE_GROWTH);
        for (const double factor : {0.5, 9.0, not_a_number})
            refused([=](auto& r) { r.domain_factor = factor; }, NETMESH_FIELD_DOMAIN_FACTOR);
        for (const double spacing : {-1.0, 0.015, 8.5, not_a_number, infinite}) {
            const auto by_refine = [=](auto& r) { r.method = NETMESH_METHOD_REFINE, r.net_spacing = spacing; };
            refused(by_refine, NETMESH_FIELD_NET_SPACING);
        }
        refused([](auto& r) { r.net_spacing = 1; }, NETMESH_FIELD_NET_SPACING);
        for (const double eps : {-1.0, 0.75, not_a_number}) {
            const auto tight = [=](auto& r) {
                r.purpose = NETMESH_PURPOSE_TIGHT;
                r.tight_eps = eps;
            };
            const netmesh_mesh_request bad = refused(tight, NETMESH_FIELD_TIGHT_EPS);
            CHECK(netmesh_plan_mesh(&bad) == 0);
        }
        for (const int method : {-1, 3}) {
            const netmesh_mesh_request bad =
                refused([=](auto& r) { r.method = static_cast<netmesh_method>(method); }, NETMESH_FIELD_METHOD);
            CHECK(netmesh_plan_mesh(&bad) == 0);
        }
        const auto with_cages = [](auto& r) { r.method = NETMESH_METHOD_HIERARCHY; };
        refused([=](auto& r) { with_cages(r), r.purpose = NETMESH_PURPOSE_PERSIST; }, NETMESH_FIELD_PURPOSE);
        refused([=](auto& r) { with_cages(r), r.sizes.eps = 0.5; }, NETMESH_FIELD_SIZES);
        refused([=](auto& r) { with_cages(r), r.size_at_inputs = 0.5; }, NETMESH_FIELD_SIZES);
        refused([](auto& r) { r.audit = 4; }, NETMESH_FIELD_AUDIT);
        for (const int kind : {-1, 2})
            refused([=](auto& r) { with_cages(r), r.cage_kind = static_cast<netmesh_cage_kind>(kind); },
                    NETMESH_FIELD_CAGE_KIND);
        const auto of_thesis = [=](auto& r) { with_cages(r), r.cage_kind = NETMESH_CAGES_THESIS, r.tau = 6; };
        if (dim > 4) refused(of_thesis, NETMESH_FIELD_CAGE_KIND);
        if (dim <= 4) {
            refused([=](auto& r) { of_thesis(r), r.method = NETMESH_METHOD_SVR; }, NETMESH_FIELD_CAGE_KIND);
            for (const double tau : {0.0, 3.39})
                refused([=](auto& r) { of_thesis(r), r.tau = tau; }, NETMESH_FIELD_TAU);
            refused([=](auto& r) { of_thesis(r), r.finish = 1, r.purpose = NETMESH_PURPOSE_PERSIST; },
                    NETMESH_FIELD_PURPOSE);
            refused([=](auto& r) { of_thesis(r), r.finish = 1, r.sizes.eps = 0.5; }, NETMESH_FIELD_SIZES);
            for (const std::uint32_t more : {0u, static_cast<std::uint32_t>(NETMESH_AUDIT_QUALITY)})
                refused([=](auto& r) { of_thesis(r), r.audit = NETMESH_AUDIT_LOCATION | more; }, NETMESH_FIELD_AUDIT);
        }
        const auto by_ratio = [](auto& r) { r.certificate.ratio = 3, r.purpose = NETMESH_PURPOSE_PERSIST; };
        refused([=](auto& r) { by_ratio(r), r.certificate.ratio = 1.4; }, NETMESH_FIELD_RATIO);
        refused([=](auto& r) { by_ratio(r), r.certificate.ratio = 0, r.certificate.focus_from = 1; },
                NETMESH_FIELD_RATIO);
        refused([=](auto& r) { by_ratio(r), r.certificate.focus_ratio = 3; }, NETMESH_FIELD_FOCUS_RATIO);
        refused([=](auto& r) { by_ratio(r), r.certificate.focus_ratio = 2; }, NETMESH_FIELD_FOCUS_FROM);
        const auto focused = [=](auto& r) { by_ratio(r), r.certificate.focus_ratio = 2, r.certificate.focus_from = 1; };
        for (const double to : {0.0, 1.0, -1.0, not_a_number})
            refused([=](auto& r) { focused(r), r.certificate.focus_to = to; }, NETMESH_FIELD_FOCUS_TO);
        for (const double from : {-1.0, not_a_number, infinite})
            refused([=](auto& r) { focused(r), r.certificate.focus_from = from, r.certificate.focus_to = 2; },
                    NETMESH_FIELD_FOCUS_FROM);
        refused([=](auto& r) { by_ratio(r), r.purpose = NETMESH_PURPOSE_MESH; }, NETMESH_FIELD_PURPOSE);
        refused([=](auto& r) { by_ratio(r), r.method = NETMESH_METHOD_REFINE; }, NETMESH_FIELD_METHOD);
        refused([=](auto& r) { by_ratio(r), r.sizes.eps = 1; }, NETMESH_FIELD_SIZES);
    }
}

TEST_CASE("points scale by scale, to fit, and by themselves") {
    for (const int dim : dimensions()) {
        Fixture f(dim);
        const netmesh_scales_request scales = f.session.scales_request(f.points);
        const auto no_scales = [&](auto change, netmesh_field field) {
            netmesh_scales_request bad = scales;
            change(bad);
            f.refused(netmesh_persist_scales(f.c, &bad), field);
        };
        f.needs_points(netmesh_persist_scales, scales);
        for (const double tau : {2.0, -1.0, not_a_number, infinite})
            no_scales([=](auto& r) { r.tau = tau; }, NETMESH_FIELD_TAU);
        for (const double eps : {-1.0, 0.75, not_a_number}) no_scales([=](auto& r) { r.eps = eps; }, NETMESH_FIELD_EPS);
        for (const double theta : {-1.0, 0.25, not_a_number})
            no_scales([=](auto& r) { r.theta = theta; }, NETMESH_FIELD_THETA);
        no_scales([](auto& r) { r.values = static_cast<netmesh_values>(2); }, NETMESH_FIELD_VALUES);
        for (const double c : {-1.0, 1.88, infinite}) no_scales([=](auto& r) { r.ratio = c; }, NETMESH_FIELD_RATIO);
        no_scales([](auto& r) { r.ratio = 2, r.eps = 0.5; }, NETMESH_FIELD_EPS);

        const netmesh_auto_request either = on(f.points, netmesh::requests::Auto(static_cast<std::uint32_t>(dim)));
        f.needs_points(netmesh_persist_auto, either);

        const netmesh_fit_request fit = on(f.points, netmesh::requests::Fit(static_cast<std::uint32_t>(dim)));
        f.needs_points(netmesh_fit, fit);
        netmesh_fit_request bad_fit = fit;
        bad_fit.ratio = 1.2;
        f.refused(netmesh_fit(f.c, &bad_fit), NETMESH_FIELD_RATIO);
        bad_fit = fit;
        bad_fit.focus_to = 1;
        f.refused(netmesh_fit(f.c, &bad_fit), NETMESH_FIELD_FOCUS_FROM);
        bad_fit.focus_from = 2;
        f.refused(netmesh_fit(f.c, &bad_fit), NETMESH_FIELD_FOCUS_TO);
        for (const netmesh_filter filter : {NETMESH_FILTER_ALPHA, NETMESH_FILTER_SCALES, NETMESH_FILTER_RIPS}) {
            bad_fit = fit;
            bad_fit.filter = filter;
            f.refused(netmesh_fit(f.c, &bad_fit), NETMESH_FIELD_FILTER);
        }
        bad_fit = fit;
        bad_fit.values = static_cast<netmesh_values>(2);
        f.refused(netmesh_fit(f.c, &bad_fit), NETMESH_FIELD_VALUES);
        bad_fit = fit;
        bad_fit.filter = NETMESH_FILTER_FUNCTION;
        f.refused(netmesh_fit(f.c, &bad_fit), NETMESH_FIELD_FUNCTION);
        bad_fit.filter = NETMESH_FILTER_KNN;
        bad_fit.k = 1000000;
        f.refused(netmesh_fit(f.c, &bad_fit), NETMESH_FIELD_K);

        const netmesh_points_request rips = f.session.points_request(f.points, NETMESH_FILTER_RIPS);
        const auto no_points = [&](auto change, netmesh_field field) {
            netmesh_points_request bad = rips;
            change(bad);
            f.refused(netmesh_persist_points(f.c, &bad), field);
            return bad;
        };
        const auto barycentric = [](auto& r) { r.filter = NETMESH_FILTER_BARYCENTRIC_CECH; };
        f.needs_points(netmesh_persist_points, f.session.points_request(f.points, NETMESH_FILTER_CECH));
        for (const netmesh_filter filter : {NETMESH_FILTER_NONE, NETMESH_FILTER_ALPHA, no_filter})
            no_points([=](auto& r) { r.filter = filter; }, NETMESH_FIELD_FILTER);
        no_points([](auto& r) { r.values = static_cast<netmesh_values>(7); }, NETMESH_FIELD_VALUES);
        no_points([=](auto& r) { barycentric(r), r.k = 0; }, NETMESH_FIELD_K);
        no_points([](auto& r) { r.max_degree = 31; }, NETMESH_FIELD_MAX_DEGREE);
        no_points([=](auto& r) { barycentric(r), r.k = 31, r.max_degree = 0; }, NETMESH_FIELD_K);
        no_points([=](auto& r) { barycentric(r), r.k = 30, r.max_degree = 1; }, NETMESH_FIELD_MAX_DEGREE);
        no_points([=](auto& r) { barycentric(r), r.representatives = 1; }, NETMESH_FIELD_REPRESENTATIVES);

        const netmesh_points_vineyard_request nested =
            f.session.nested_request(f.points, NETMESH_FILTER_BARYCENTRIC_CECH, 2);
        const auto no_range = [&](auto change, netmesh_field field) {
            netmesh_points_vineyard_request bad = nested;
            change(bad);
            f.refused(netmesh_points_vineyard(f.c, &bad), field);
            CHECK(netmesh_plan_points_vineyard(&bad) == 0);
        };
        f.needs_points(netmesh_points_vineyard, nested);
        for (const netmesh_filter filter :
             {NETMESH_FILTER_NONE, NETMESH_FILTER_KNN, NETMESH_FILTER_RIPS, NETMESH_FILTER_CECH, no_filter})
            no_range([=](auto& r) { r.filter = filter; }, NETMESH_FIELD_FILTER);
        no_range([](auto& r) { r.values = static_cast<netmesh_values>(7); }, NETMESH_FIELD_VALUES);
        no_range([](auto& r) { r.k_first = 0; }, NETMESH_FIELD_K_FIRST);
        no_range([](auto& r) { r.k_first = 3; }, NETMESH_FIELD_K_LAST);
        no_range([](auto& r) { r.k_last = 31, r.max_degree = 0; }, NETMESH_FIELD_K_LAST);
        no_range([](auto& r) { r.k_last = 30; }, NETMESH_FIELD_MAX_DEGREE);
        no_range([](auto& r) { r.max_degree = NETMESH_DEGREE_MAX; }, NETMESH_FIELD_MAX_DEGREE);
    }
}

TEST_CASE("plans of what cannot be") {
    for (const int served : dimensions()) {
        const std::uint32_t dim = static_cast<std::uint32_t>(served);
        netmesh::requests::Points rips(dim, NETMESH_FILTER_RIPS);
        CHECK(netmesh_plan_points(nullptr) == 0);
        CHECK(netmesh_plan_points(&rips) == 0);
        rips.point_count = many;
        CHECK(netmesh_plan_points(&rips) == 0);
        rips.point_count = many - 1;
        rips.max_degree = 30;
        CHECK(netmesh_plan_points(&rips) == SIZE_MAX);
        rips.filter = NETMESH_FILTER_ALPHA;
        CHECK(netmesh_plan_points(&rips) == 0);

        netmesh::requests::PointsVineyard nested(dim, NETMESH_FILTER_BARYCENTRIC_RIPS);
        CHECK(netmesh_plan_points_vineyard(nullptr) == 0);
        CHECK(netmesh_plan_points_vineyard(&nested) == 0);
        nested.point_count = many;
        CHECK(netmesh_plan_points_vineyard(&nested) == 0);
        nested.point_count = many - 1;
        nested.k_last = 29;
        CHECK(netmesh_plan_points_vineyard(&nested) == SIZE_MAX);
        nested.point_count = 9;
        nested.k_last = 3;
        const std::size_t three = netmesh_plan_points_vineyard(&nested);
        nested.k_last = 4;
        CHECK(netmesh_plan_points_vineyard(&nested) > three);
        nested.dim = 7;
        CHECK(netmesh_plan_points_vineyard(&nested) == 0);

        netmesh::requests::Mesh mesh(dim);
        CHECK(netmesh_plan_mesh(nullptr) == 0);
        CHECK(netmesh_plan_mesh(&mesh) == 0);
        mesh.point_count = many;
        CHECK(netmesh_plan_mesh(&mesh) == 0);
        mesh.point_count = many - 1;
        mesh.purpose = static_cast<netmesh_purpose>(3);
        CHECK(netmesh_plan_mesh(&mesh) == 0);
        mesh.purpose = NETMESH_PURPOSE_TIGHT;
        mesh.sizes.eps = -1;
        CHECK(netmesh_plan_mesh(&mesh) == 0);
        mesh.sizes.eps = 1e-9;
        CHECK(netmesh_plan_mesh(&mesh) == SIZE_MAX);

        netmesh::requests::Delaunay delaunay(dim);
        CHECK(netmesh_plan_delaunay(nullptr) == 0);
        CHECK(netmesh_plan_delaunay(&delaunay) == 0);
        delaunay.point_count = 1;
        CHECK(netmesh_plan_delaunay(&delaunay) > 0);
        delaunay.purpose = NETMESH_PURPOSE_TIGHT;
        CHECK(netmesh_plan_delaunay(&delaunay) == 0);

        netmesh::requests::Scales scales(dim);
        CHECK(netmesh_plan_scales(nullptr) == 0);
        CHECK(netmesh_plan_scales(&scales) == 0);
        scales.point_count = 10;
        CHECK(netmesh_plan_scales(&scales) > 0);
        scales.eps = 0.75;
        CHECK(netmesh_plan_scales(&scales) == 0);
        scales.eps = 0.5, scales.ratio = 3;
        CHECK(netmesh_plan_scales(&scales) == 0);
    }
}

// The plan knows nothing of the points but how they lie.
template <class Request, class Plan> void check_layout(Request request, Plan plan) {
    request.point_count = 8;
    request.point_stride_bytes = 8 * request.dim + 8;
    CHECK(plan(&request) > 0);
    const std::size_t too_short = 8 * request.dim - 8, odd = 8 * request.dim + 1, too_long = SIZE_MAX / 2;
    for (const std::size_t bad : {too_short, odd, too_long}) {
        CAPTURE(bad);
        request.point_stride_bytes = bad;
        CHECK(plan(&request) == 0);
    }
    request.point_format = NETMESH_POINTS_FLOAT32;
    request.point_stride_bytes = 4 * request.dim;
    CHECK(plan(&request) > 0);
    request.point_stride_bytes = 0;
    request.point_format = static_cast<netmesh_point_format>(2);
    CHECK(plan(&request) == 0);
}

TEST_CASE("plans of points that cannot lie so") {
    for (const int served : dimensions()) {
        const std::uint32_t dim = static_cast<std::uint32_t>(served);
        CAPTURE(dim);
        check_layout(netmesh::requests::Mesh(dim), netmesh_plan_mesh);
        check_layout(netmesh::requests::Delaunay(dim), netmesh_plan_delaunay);
        check_layout(netmesh::requests::Alpha(dim), netmesh_plan_alpha);
        check_layout(netmesh::requests::Auto(dim), netmesh_plan_auto);
        check_layout(netmesh::requests::Scales(dim), netmesh_plan_scales);
        check_layout(netmesh::requests::Points(dim, NETMESH_FILTER_RIPS), netmesh_plan_points);
        netmesh::requests::PointsVineyard nested(dim, NETMESH_FILTER_BARYCENTRIC_RIPS);
        nested.k_last = 2;
        check_layout(nested, netmesh_plan_points_vineyard);
    }
}

TEST_CASE("what is planned grows with what is asked for") {
    for (const int served : dimensions()) {
        const std::uint32_t dim = static_cast<std::uint32_t>(served);
        CAPTURE(dim);
        netmesh::requests::Mesh m(dim);
        m.point_count = 1000;
        const auto plan = [&m](netmesh_purpose purpose) {
            m.purpose = purpose;
            return static_cast<double>(netmesh_plan_mesh(&m));
        };
        netmesh::requests::Delaunay d(dim);
        netmesh::requests::Scales scales(dim);
        d.point_count = scales.point_count = 1000;
        const double delaunay = static_cast<double>(netmesh_plan_delaunay(&d));
        d.purpose = NETMESH_PURPOSE_PERSIST;
        CHECK(delaunay < plan(NETMESH_PURPOSE_MESH));
        CHECK(plan(NETMESH_PURPOSE_MESH) < plan(NETMESH_PURPOSE_PERSIST));
        CHECK(delaunay < static_cast<double>(netmesh_plan_delaunay(&d)));
        CHECK(plan(NETMESH_PURPOSE_PERSIST) < plan(NETMESH_PURPOSE_TIGHT));
        CHECK(plan(NETMESH_PURPOSE_TIGHT) < static_cast<double>(netmesh_plan_scales(&scales)));
        // A size smaller than the tight filter's counts, a larger one does not.
        const double tight = plan(NETMESH_PURPOSE_TIGHT);
        m.sizes.eps = 0.5;
        CHECK(plan(NETMESH_PURPOSE_TIGHT) == tight);
        m.sizes.eps = 0.01;
        CHECK(plan(NETMESH_PURPOSE_TIGHT) > tight);
        m.sizes.eps = 0;
        const double mesh = plan(NETMESH_PURPOSE_MESH);
        m.method = NETMESH_METHOD_HIERARCHY;
        const double caged = plan(NETMESH_PURPOSE_MESH);
        CHECK(caged > mesh);
        m.method = NETMESH_METHOD_SVR;
        m.audit = NETMESH_AUDIT_LOCATION;
        CHECK(plan(NETMESH_PURPOSE_MESH) > caged);
        // Coarse meshes: the lists of balls of each point take most. They have a third of what is left.
        m.tau = 1e6;
        m.point_count = 100000;
        const double balls = by_dimension<double>(served, {8, 24, 96, 480, 2400});
        CHECK(plan(NETMESH_PURPOSE_MESH) > 3 * 16 * balls * 100000);
    }
}

TEST_CASE("jobs that go beyond what they are for") {
    for (const int dim : dimensions(2, 3)) {
        CAPTURE(dim);
        Session s(dim);
        const inputs::Points points = inputs::uniform(dim, 1);
        s.request.domain_factor = 5;  // more than the tight filter needs
        s.request.sizes.eps = 0.1;
        REQUIRE(s.mesh(points, NETMESH_PURPOSE_TIGHT) == NETMESH_OK);
        CHECK(s.report().mesh.sizes.eps == 0.1);
        s.request.domain_factor = 0;
        s.request.sizes.eps = 0.5;
        REQUIRE(s.mesh(points, NETMESH_PURPOSE_TIGHT) == NETMESH_OK);
        CHECK(s.report().mesh.sizes.eps < 0.12);
        s.request.audit = NETMESH_AUDIT_LOCATION;
        CHECK(s.mesh(points) == NETMESH_INVALID_ARGUMENT);
        CHECK(s.detail().field == NETMESH_FIELD_AUDIT);
    }
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        const inputs::Points points = inputs::uniform(dim, 3);
        REQUIRE(s.mesh(points) == NETMESH_OK);
        const std::uint64_t print = s.report().fingerprint;
        s.request.audit = NETMESH_AUDIT_QUALITY;
        REQUIRE(s.mesh(points) == NETMESH_OK);
        CHECK(s.report().mesh.audit.meshes > 0);
        CHECK(s.report().mesh.aspect_ratio_max <= netmesh_tau(&s.request));
        s.request.audit = 0;
        s.request.sizes.eps = 1e-16;  // below what coordinates resolve
        CHECK(s.mesh_in_block(points) == NETMESH_INVALID_ARGUMENT);
        CHECK(s.detail().field == NETMESH_FIELD_SIZES);
        CHECK(s.report().mesh.present == 0);
        s.request.sizes.eps = 0;
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

TEST_CASE("points beyond what lists can number") {
    // More points than a graph of edges is made for, and more simplices than 62 bits number: both are listed, one by
    // one, until stopped.
    Session s(2);
    s.reserve(std::size_t{1} << 24);
    s.request.monitor.poll = [](void*, const netmesh_progress* progress) {
        return int(progress->stage == NETMESH_STAGE_FILTER);
    };
    const auto rips = [&](std::size_t n, std::uint32_t degree) {
        const inputs::Points points = inputs::uniform(2, n);
        const netmesh_points_request r = s.points_request(points, NETMESH_FILTER_RIPS, 1, degree);
        return netmesh_persist_points(s.context, &r);
    };
    CHECK(rips(65537, 1) == NETMESH_CANCELLED);
    CHECK(rips(300, 30) == NETMESH_CANCELLED);
    const inputs::Points few = inputs::uniform(2, 3);
    const netmesh_points_request r = s.points_request(few, NETMESH_FILTER_BARYCENTRIC_CECH, 4, 0);
    CHECK(netmesh_persist_points(s.context, &r) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.detail().field == NETMESH_FIELD_K);
}

TEST_CASE("filters after a mesh") {
    for (const int dim : dimensions()) {
        Fixture f(dim);
        Session& s = f.session;
        const auto wrong_values = static_cast<netmesh_values>(2);
        f.needs_request(netmesh_persist, persist_by(NETMESH_FILTER_COMPLETE));
        for (const netmesh_filter filter : {NETMESH_FILTER_NONE, NETMESH_FILTER_RIPS, NETMESH_FILTER_SCALES, no_filter})
            f.refused(s.persist(filter), NETMESH_FIELD_FILTER);
        f.refused(s.persist(persist_by(NETMESH_FILTER_COMPLETE, 0, wrong_values)), NETMESH_FIELD_VALUES);
        f.ended(s.persist(NETMESH_FILTER_ALPHA), NETMESH_NO_RESULT);
        f.refused(s.persist(persist_by(NETMESH_FILTER_KNN, 4)), NETMESH_FIELD_K);

        netmesh::requests::Vineyard good(NETMESH_FILTER_KNN);
        f.needs_request<netmesh_vineyard_request>(netmesh_vineyard, good);
        f.refused(s.vineyard(NETMESH_FILTER_COMPLETE, 1, 2), NETMESH_FIELD_FILTER);
        f.refused(s.vineyard(NETMESH_FILTER_KNN, 0, 2), NETMESH_FIELD_K_FIRST);
        f.refused(s.vineyard(NETMESH_FILTER_KNN, 2, 1), NETMESH_FIELD_K_LAST);
        f.refused(s.vineyard(NETMESH_FILTER_KNN, 1, 4), NETMESH_FIELD_K_LAST);
        good.values = wrong_values;
        f.refused(netmesh_vineyard(f.c, &good), NETMESH_FIELD_VALUES);

        netmesh_function function = constant_one();
        netmesh_persist_request by_function = persist_by(NETMESH_FILTER_FUNCTION);
        f.refused(s.persist(by_function), NETMESH_FIELD_FUNCTION);
        by_function.function = &function;
        by_function.values = wrong_values;
        f.refused(s.persist(by_function), NETMESH_FIELD_VALUES);
        by_function.values = NETMESH_VALUES_CERTIFIED;
        function.evaluate = nullptr;
        f.refused(s.persist(by_function), NETMESH_FIELD_FUNCTION);
        function = constant_one();
        function.struct_bytes = 0;
        f.refused(s.persist(by_function), NETMESH_FIELD_STRUCT_BYTES);
        const std::pair<double netmesh_function::*, netmesh_field> numbers[] = {
            {&netmesh_function::lipschitz, NETMESH_FIELD_LIPSCHITZ},
            {&netmesh_function::distance_factor, NETMESH_FIELD_DISTANCE_FACTOR},
            {&netmesh_function::cut, NETMESH_FIELD_CUT}};
        for (const auto& [member, field] : numbers)
            for (const double number : {field == NETMESH_FIELD_CUT ? infinite : -1.0, not_a_number, infinite}) {
                function = constant_one();
                function.*member = number;
                f.refused(s.persist(by_function), field);
            }
        f.needs_request<netmesh_represent_request>(netmesh_represent, netmesh::requests::Represent());
        f.needs_request<netmesh_bounds_request>(netmesh_bound_bars, netmesh::requests::Bounds());
        f.ended(s.represent(), NETMESH_NO_RESULT);
        f.ended(s.bound_bars(), NETMESH_NO_RESULT);
    }
}

TEST_CASE("checks, analyses and cages after a mesh") {
    for (const int dim : dimensions()) {
        Fixture f(dim);
        Session& s = f.session;
        f.needs_request<netmesh_check_request>(netmesh_check, netmesh::requests::Check());
        f.refused(s.check(0), NETMESH_FIELD_WHAT);
        f.refused(s.check(32), NETMESH_FIELD_WHAT);
        const netmesh::requests::Mesh other(static_cast<std::uint32_t>(dim == 6 ? 2 : dim + 1));
        netmesh::requests::Check check;
        check.mesh = &other;
        f.refused(netmesh_check(f.c, &check), NETMESH_FIELD_MESH);
        auto analysis = netmesh::sized<netmesh_analysis>();
        const auto promises = [&](auto change, netmesh_field field) {
            netmesh::requests::Mesh mesh(static_cast<std::uint32_t>(dim));
            change(mesh);
            check.mesh = &mesh;
            f.refused(netmesh_check(f.c, &check), field);
            netmesh::requests::Analyse analyse_it;
            analyse_it.mesh = &mesh;
            f.refused(netmesh_analyse(f.c, &analyse_it, &analysis), field);
            const Arrays arrays(s);
            const netmesh_load_request load = arrays.load_request(mesh);
            f.refused(netmesh_load(f.c, &load), field);
        };
        for (const double tau : {2.0, -1.0, not_a_number, infinite})
            promises([=](auto& r) { r.tau = tau; }, NETMESH_FIELD_TAU);
        for (const double eps : {-1.0, not_a_number, infinite})
            promises([=](auto& r) { r.sizes.eps = eps; }, NETMESH_FIELD_SIZES);
        for (const double ratio : {-1.0, 1.4, not_a_number, infinite})
            promises([=](auto& r) { r.certificate.ratio = ratio; }, NETMESH_FIELD_RATIO);
        promises([=](auto& r) { r.certificate = {2, 3, 1, 2}; }, NETMESH_FIELD_FOCUS_RATIO);
        f.refused(s.analyse(&analysis, 0), NETMESH_FIELD_WHAT);
        f.refused(s.analyse(&analysis, 8), NETMESH_FIELD_WHAT);
        f.refused(s.analyse(&analysis, 2, -1), NETMESH_FIELD_TOLERANCE);
        const netmesh::requests::Analyse analyse;
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
        netmesh::requests::Cages cages;
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
    netmesh_persist_request all = persist_by(NETMESH_FILTER_BASIC, 0, NETMESH_VALUES_THESIS);
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
    all.filter = NETMESH_FILTER_COMPLETE;
    REQUIRE(s.persist(all) == NETMESH_OK);
    CHECK(s.bound_bars() == NETMESH_OK);
    CHECK(s.bound_bars() == NETMESH_OK);
    CHECK(netmesh_get_bar_bounds(c, s.pairs().size(), &bounds) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(s.vineyard(NETMESH_FILTER_KNN, 2, 3) == NETMESH_OK);
    double ratio;
    CHECK(netmesh_get_vine_ratio(c, 1, &ratio) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vine_ratio(c, 4, &ratio) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_vine_ratio(c, 3, &ratio) == NETMESH_OK);
}

TEST_CASE("complexes") {
    Fixture f(2);
    const std::uint32_t v[] = {0, 1, 0, 1};
    const std::uint64_t starts[] = {0, 1, 2, 4};
    const double t[] = {0, 0, 1};
    netmesh::requests::Homology good;
    good.vertices = v;
    good.starts = starts;
    good.entries = t;
    good.simplex_count = 3;
    good.vertex_count = 4;
    const auto refused = [&](auto change, netmesh_field field) {
        netmesh_homology_request bad = good;
        change(bad);
        f.refused(netmesh_homology(f.c, &bad), field);
    };
    f.needs_request<netmesh_homology_request>(netmesh_homology, good);
    refused([](auto& r) { r.vertices = nullptr; }, NETMESH_FIELD_VERTICES);
    refused([](auto& r) { r.starts = nullptr; }, NETMESH_FIELD_STARTS);
    refused([](auto& r) { r.entries = nullptr; }, NETMESH_FIELD_ENTRIES);
    refused([](auto& r) { r.simplex_count = 0; }, NETMESH_FIELD_SIMPLEX_COUNT);
    refused([](auto& r) { r.vertex_count = 3; }, NETMESH_FIELD_VERTEX_COUNT);
    const auto plan = [](std::uint64_t simplices, std::uint64_t vertices) {
        netmesh::requests::Homology r;
        r.simplex_count = simplices;
        r.vertex_count = vertices;
        return netmesh_plan_homology(&r);
    };
    CHECK(plan(0, 0) == 0);
    CHECK(plan(5, 4) == 0);
    CHECK(plan(1, UINT64_MAX) == 0);
    CHECK(plan(3, 4) > 16384);
    CHECK(netmesh_plan_homology(nullptr) == 0);
    CHECK(netmesh_homology(f.c, &good) == NETMESH_OK);
    CHECK(f.session.report().simplicial_complex.vertices == 2);
}
