// Bytes to a sequence of calls on one context, in any order, with good arguments and bad ones. The block, each array
// and each request is allocated at its exact size, so that AddressSanitizer sees every access outside. Each call must
// end in a known status that is not NETMESH_INTERNAL, with a text, and results must be readable as far as the report
// says.
#include <cstring>
#include <limits>
#include <vector>

#include "common/read.hpp"
#include "fuzz/choices.hpp"

namespace {

using fuzz::Choices;
using fuzz::require;
using fuzz::Tape;

// By number; then auto, and none.
std::vector<const netmesh_filter*> all_filters() {
    std::vector<const netmesh_filter*> all = {&netmesh_filter_simplices};
    netmesh::for_each_filter([&](const netmesh_filter_info& info) { all.push_back(info.filter); });
    all.push_back(&netmesh_filter_auto);
    all.push_back(nullptr);
    return all;
}
const std::vector<const netmesh_filter*> filters = all_filters();
const std::uint32_t filter_count = static_cast<std::uint32_t>(filters.size());
const netmesh_method* const methods[] = {&netmesh_method_svr,    &netmesh_method_netmesh,  &netmesh_method_refine,
                                         &netmesh_method_thesis, &netmesh_method_delaunay, &netmesh_method_certificate};

class Calls {
public:
    Calls(const std::uint8_t* data, std::size_t size) : tape_(data, size) {
        static const std::uint32_t units[] = {1, 64, 1024, 4096};
        const std::uint32_t unit = units[tape_.below(4)];
        block_bytes_ = std::size_t{unit} * (tape_.byte() + 1u);
        block_ = std::malloc(block_bytes_);
        require(block_ != nullptr);
        dim_ = 2 + tape_.below(5);
        std::memset(block_, tape_.byte(), block_bytes_);
        start();
    }
    Calls(const Calls&) = delete;
    Calls& operator=(const Calls&) = delete;
    ~Calls() { std::free(block_); }

    void run() {
        for (int i = 0; i < 16 && context_ != nullptr && !tape_.empty(); ++i) call();
    }

private:
    void start() {
        context_ = nullptr;
        const netmesh_status status = netmesh_init(block_, block_bytes_, &context_);
        require(status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY);
        require((status == NETMESH_OK) == (context_ != nullptr));
    }
    // Of a call that keeps a detail.
    netmesh_status ended(netmesh_status status) {
        require(static_cast<unsigned>(status) <= NETMESH_NOT_BUILT && status != NETMESH_INTERNAL);
        require(netmesh_status_text(status) != nullptr);
        const netmesh_detail detail = detail_of(context_);
        require(detail.message != nullptr && detail.field < NETMESH_FIELD_COUNT);
        require(netmesh_field_text(detail.field) != nullptr);
        if (status != NETMESH_OK) require(detail.status == status);
        return status;
    }

    Choices choose() {
        handed_.clear();
        return Choices::read(tape_, &dim_, &polls_left_, &well_);
    }
    // What a call gets for its request.
    template <class Request> const Request* maybe(const Request& request, const Choices& c) {
        return tape_.rarely() ? nullptr : handed_.over(request, c);
    }
    netmesh::Request on_points(netmesh::Request request, const Choices& c, const std::vector<double>& x) {
        request.set_points(c.dim, x);
        // The seed says how they lie, so that older inputs mean what they did.
        const std::size_t gap = c.seed / 8 % 3 + 1, dim = c.dim;
        if (c.seed % 8 == 4) request.points.stride_bytes = 4;  // refused
        if (c.seed % 8 == 5) put_in_rows(&request.points, x, &floats_, dim);
        if (c.seed % 8 == 6) put_in_rows(&request.points, x, &floats_, dim + gap);
        if (c.seed % 8 == 7) put_in_rows(&request.points, x, &doubles_, dim + gap);
        return request;
    }
    // Of jobs that no seed matters to, which refuse most of them: half of the choices.
    static netmesh::Request unseeded(netmesh::Request request) {
        if (request.seed < 128) request.seed = 1;
        return request;
    }
    // In rows of that many numbers, the last one cut off where its point ends.
    template <class Number>
    static void put_in_rows(netmesh_points* points, const std::vector<double>& x, std::vector<Number>* rows,
                            std::size_t stride) {
        std::vector<Number> all;
        for (std::size_t i = 0; i < points->count; ++i) {
            all.resize(i * stride, std::numeric_limits<Number>::quiet_NaN());
            for (std::uint32_t k = 0; k < points->dim; ++k) all.push_back(static_cast<Number>(x[i * points->dim + k]));
        }
        *rows = std::vector<Number>(all);  // no spare capacity
        points->coordinates = rows->data();
        points->format = sizeof(Number) == 4 ? NETMESH_POINTS_FLOAT32 : NETMESH_POINTS_FLOAT64;
        points->stride_bytes = stride == points->dim ? 0 : stride * sizeof(Number);
    }
    std::vector<double> make_points(std::uint32_t dim) {
        std::vector<double> x;
        const std::uint32_t n = tape_.below(14);
        for (std::uint32_t i = 0; i < n * dim; ++i) x.push_back(tape_.number());
        return std::vector<double>(x);  // no spare capacity
    }
    netmesh_report report() {
        auto r = netmesh::sized<netmesh_report>();
        require(netmesh_get_report(context_, &r) == NETMESH_OK);
        return r;
    }
    netmesh_status checked(std::uint32_t what, const netmesh_request& promised, const Choices& c) {
        auto request = netmesh::sized<netmesh_check_request>();
        request.what = what;
        request.monitor = c.monitor;
        request.promised = handed_.over(promised, c);
        return ended(netmesh_check(context_, &request));
    }
    // What settle says is what the call says, and what is settled is settled again as it is. Then the plan of it.
    netmesh_status persisted(const netmesh_request& request, const Choices& c) {
        auto settled = netmesh::sized<netmesh_request>(), again = netmesh::sized<netmesh_request>();
        auto detail = netmesh::sized<netmesh_detail>();
        const netmesh_status said = netmesh_settle(&request, &settled, &detail);
        require(said == NETMESH_OK || said == NETMESH_INVALID_ARGUMENT || said == NETMESH_NOT_BUILT);
        require((said == NETMESH_OK) == (detail.field == NETMESH_FIELD_NONE) && detail.message != nullptr);
        const netmesh_field field = detail.field;
        if (said == NETMESH_OK) {
            require(netmesh_settle(&settled, &again, &detail) == NETMESH_OK);
            require(std::memcmp(&settled, &again, sizeof again) == 0);
        }
        netmesh_plan(&request);
        const netmesh_request* const handed = maybe(request, c);
        const bool whole = handed != nullptr && !c.sets_bytes;
        const netmesh_status status = ended(netmesh_persist(context_, handed));
        // Without a filter it is a mesh that is settled.
        if (whole && said != NETMESH_OK)
            require(status == said && (request.filter == nullptr || detail_of(context_).field == field));
        return status;
    }

    void triangulate() {
        const Choices c = choose();
        const std::vector<double> x = make_points(c.dim);
        netmesh::Request request = on_points(c.request(nullptr), c, x);
        request.mesh.method = &netmesh_method_delaunay;
        if (tape_.rarely()) request.points.coordinates = nullptr;
        if (ended(netmesh_mesh(context_, maybe<netmesh_request>(request, c))) == NETMESH_OK) {
            const netmesh_status status = checked(7, c.mesh_request(nullptr), c);
            require(status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY || status == NETMESH_INVALID_ARGUMENT ||
                    status == NETMESH_CANCELLED);
        }
    }
    void make_mesh() {
        const Choices c = choose();
        const netmesh_method* const method = methods[tape_.below(4)];
        const std::vector<double> x = make_points(c.dim);
        netmesh::Request request = on_points(c.mesh_request(nullptr), c, x);
        if (request.mesh.method == nullptr) request.mesh.method = method;
        if (method == &netmesh_method_refine && tape_.rarely()) request.mesh.net_spacing = tape_.byte() / 25.0;
        static const netmesh_filter* const purposes[] = {nullptr, &netmesh_filter_complete, nullptr,
                                                         &netmesh_filter_tight};
        request.filter = tape_.rarely() ? filters[tape_.byte() % filter_count] : purposes[tape_.below(4)];
        if (request.goal.ratio > 0 && request.filter != nullptr) request.mesh.method = nullptr;
        if (tape_.rarely()) request.points.coordinates = nullptr;
        netmesh_plan_mesh(&request);
        ended(netmesh_mesh(context_, maybe<netmesh_request>(request, c)));
    }
    void fit() {
        Choices c = choose();
        if (polls_left_ > 0) polls_left_ = 30;  // some runs
        if (tape_.byte() & 1) c.goal.ratio = 2 + tape_.byte() / 64.0;
        if (tape_.byte() & 1) {
            c.goal.focus_from = std::ldexp(1.0, static_cast<int>(tape_.below(16)) - 8);
            c.goal.focus_to = c.goal.focus_from * (1 + tape_.byte() / 16.0);
        }
        const std::vector<double> x = make_points(c.dim);
        netmesh::Request request = on_points(c.request(&netmesh_filter_complete), c, x);
        request.fit = &netmesh_fit;
        request.goal = c.goal;
        request.max_degree = tape_.below(8);
        request.keep_zero_pairs = tape_.byte() & 1;
        request.bounds = tape_.byte() & 1 ? &netmesh_bounds : nullptr;
        if (tape_.byte() & 1) request.filter = filters[tape_.below(9)];
        if (tape_.byte() & 1) request.values = NETMESH_VALUES_THESIS;
        request.mesh.whole_cells = tape_.rarely() ? 1 : 0;
        const std::uint32_t k = tape_.below(4);
        if (request.filter == &netmesh_filter_knn || request.filter == &netmesh_filter_kdistance) request.k = k;
        auto f = netmesh::sized<netmesh_function>();
        f.evaluate = fuzz::function_of;
        f.user = &well_;
        f.lipschitz = f.cut = 1;
        if (tape_.byte() & 1) {
            request.filter = &netmesh_filter_function;
            request.function = handed_.over<netmesh_function>(f, c);
            if (!tape_.rarely()) request.goal = {};
        }
        if (tape_.rarely()) request.points.coordinates = nullptr;
        if (tape_.rarely()) {
            request.goal.longer_than = tape_.rarely() ? tape_.number() : 1 + tape_.byte() / 64.0;
            if (tape_.byte() & 1) request.goal.focus_from = request.goal.focus_to = 0;
        }
        if (persisted(request, c) != NETMESH_OK) return;
        const netmesh_report r = report();
        const bool laddered = r.diagram.filter == NETMESH_FILTER_COMPLETE && request.values != NETMESH_VALUES_THESIS;
        require(r.diagram.present != 0);
        require(r.decision.present == 0 || r.decision.longer_than == request.goal.longer_than);
        require(!(r.decision.decided_from < r.decision.undecided_to));
        require(!laddered || r.diagram.certified_ratio <= r.mesh.goal.ratio);
        netmesh::Request made = c.request(nullptr);
        made.k = 0;
        made.goal = r.mesh.goal;
        made.mesh.whole_cells = r.mesh.clipped == 0 && made.goal.ratio > 0 ? 1 : 0;
        // Meshes for an error are smaller than bounds on sizes allow; those are held to the sizes asked for alone.
        require(r.diagram.fitted_error == 0 || request.filter == &netmesh_filter_function);
        Choices all = c;
        all.sets_bytes = false;  // a shorter request would not say what the mesh was made for
        if (r.diagram.fitted_error == 0) require(checked(15, made, all) != NETMESH_CHECK_FAILED);
    }
    // Of what the context holds.
    void persist() {
        const Choices c = choose();
        netmesh::Request request = c.request(filters[tape_.below(14)]);
        const std::uint32_t values = tape_.rarely() ? tape_.byte() : tape_.below(2);
        std::memcpy(&request.values, &values, sizeof values);
        request.max_degree = tape_.below(8);
        request.keep_zero_pairs = tape_.byte() & 1;
        persisted(request, c);
    }
    // Any request at all: what contradicts is refused, everything else is done.
    void anything() {
        const Choices c = choose();
        const std::vector<double> x = make_points(c.dim);
        netmesh::Request request = c.mesh_request(filters[tape_.below(filter_count)]);
        if (tape_.below(4) != 0) request = on_points(request, c, x);
        const std::uint32_t what = tape_.byte(), more = tape_.byte();
        if (what & 1) request.bounds = &netmesh_bounds;
        if (what & 2) request.cycles = &netmesh_cycles;
        if ((what & 12) == 12) request.vines = &netmesh_vines;
        if ((what & 48) == 48) request.fit = &netmesh_fit;
        if (what & 64) request.keep_mesh = 1;
        if (what & 128) request.max_degree = tape_.below(4);
        if ((more & 3) == 3) request.mesh.method = methods[tape_.below(6)];
        if ((more & 12) == 12) request.k = tape_.below(5), request.k_last = request.k + tape_.below(3);
        if ((more & 48) == 48) request.threshold = tape_.number();
        if ((more & 64) != 0) request.values = static_cast<netmesh_values>(tape_.below(3));
        if (polls_left_ > 0) polls_left_ = 30;
        persisted(request, c);
    }
    void persist_alpha() {
        const Choices c = choose();
        netmesh::Request request = c.request(&netmesh_filter_alpha);
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.keep_zero_pairs = tape_.byte() & 1;
        const std::vector<double> x = make_points(c.dim);
        persisted(on_points(request, c, x), c);
    }
    // Points with weights, with periods or with both: diagrams and triangulations, and what is refused.
    void weigh_and_repeat() {
        const Choices c = choose();
        const std::uint32_t what = tape_.byte();
        netmesh::Request request = c.request(&netmesh_filter_alpha);
        if (what & 32) request.filter = &netmesh_filter_auto;
        if (tape_.rarely()) request.filter = filters[tape_.below(filter_count)];
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(8);
        request.keep_zero_pairs = tape_.byte() & 1;
        const std::vector<double> x = make_points(c.dim);
        request.set_points(c.dim, x);
        const std::size_t gap = what >> 3 & 3;
        if (what & 4) put_in_rows(&request.points, x, &floats_, c.dim + gap);
        if (!(what & 4) && gap > 0) put_in_rows(&request.points, x, &doubles_, c.dim + gap);
        if ((what & 3) != 0) extras_.weigh(tape_, &request);
        if ((what & 3) != 1) extras_.repeat(tape_, &request);
        const std::uint32_t more = tape_.byte();
        request.keep_mesh = (more & 3) == 3 ? 1 : 0;
        if (tape_.rarely()) request.bounds = &netmesh_bounds;
        if (tape_.rarely() || (more & 64) != 0) request.cycles = &netmesh_cycles;
        if (tape_.rarely()) request.points.coordinates = nullptr;
        if (polls_left_ > 0) polls_left_ = 200;  // copies are many in four dimensions
        if ((more & 28) == 28) {
            if (more & 32) request.filter = nullptr, request.mesh.method = &netmesh_method_delaunay;
            netmesh_plan_mesh(&request);
            if (ended(netmesh_mesh(context_, maybe<netmesh_request>(request, c))) == NETMESH_OK) {
                const netmesh_status status = checked(tape_.below(16), c.mesh_request(nullptr), c);
                require(status != NETMESH_CHECK_FAILED);
            }
        } else if (persisted(request, c) == NETMESH_OK && !c.sets_bytes) {
            require_all_points(request);
        }
    }
    // No point is lost, and with periods what is left in the end is a torus.
    void require_all_points(const netmesh_request& request) {
        const netmesh_report r = report();
        require(r.input.distinct + r.input.duplicates + r.input.hidden == r.input.points);
        require(request.weighting != nullptr || r.input.hidden == 0);
        require(r.input.periods == request.points.lattice_count);
        if (request.periods == nullptr) return;
        std::uint64_t wanted = 1, left = r.input.periods;
        std::vector<std::uint64_t> lasting(NETMESH_DIM_MAX + 1);
        for (const netmesh_pair& pair : read_all(context_, netmesh_get_pair))
            lasting[pair.degree] += std::isinf(pair.death);
        for (std::uint32_t degree = 0; degree <= r.diagram.max_degree; ++degree) {
            require(lasting[degree] == wanted);
            wanted = wanted * left / (degree + 1);
            left -= left > 0;
        }
    }
    void persist_auto() {
        const Choices c = choose();
        netmesh::Request request = c.request(&netmesh_filter_auto);
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.keep_zero_pairs = tape_.byte() & 1;
        const std::vector<double> x = make_points(c.dim);
        request = on_points(request, c, x);
        if (persisted(request, c) != NETMESH_OK) return;
        const netmesh_report r = report();
        const bool is_alpha = r.diagram.filter == NETMESH_FILTER_ALPHA;
        const bool alpha_why = r.diagram.why == NETMESH_WHY_AFFORDABLE || r.diagram.why == NETMESH_WHY_NO_MESH;
        require(r.diagram.why != NETMESH_WHY_ASKED && is_alpha == alpha_why && is_alpha == (r.mesh.is_mesh == 0));
    }
    void persist_points() {
        const Choices c = choose();
        netmesh::Request request =
            c.request(filters[tape_.rarely() ? tape_.byte() % filter_count : 9 + tape_.below(4)]);
        request.values = static_cast<netmesh_values>(tape_.below(3));
        request.k = tape_.below(6);
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.keep_zero_pairs = tape_.byte() & 1;
        request.cycles = tape_.byte() & 1 ? &netmesh_cycles : nullptr;
        if (request.filter == &netmesh_filter_rips || request.filter == &netmesh_filter_cech) request.k = 0;
        const std::vector<double> x = make_points(c.dim);
        persisted(unseeded(on_points(request, c, x)), c);
    }
    // Of few points; numbers are anything now and then.
    void persist_distances() {
        const Choices c = choose();
        const std::uint32_t n = tape_.below(9), layout = tape_.rarely() ? tape_.byte() : tape_.below(3);
        std::vector<double> full(std::size_t{n} * n, 0.0), lower;
        std::vector<netmesh_distance_entry> entries;
        for (std::uint32_t i = 0; i < n; ++i) {
            for (std::uint32_t j = 0; j < i; ++j) {
                const double d = tape_.rarely() ? tape_.number() : tape_.below(16);
                full[i * std::size_t{n} + j] = d;
                full[j * std::size_t{n} + i] = tape_.rarely() ? tape_.number() : d;
                lower.push_back(d);
                if ((tape_.byte() & 3) != 0) entries.push_back({tape_.rarely() ? tape_.byte() : i, j, d});
            }
        }
        auto distances = netmesh::sized<netmesh_distances>();
        std::memcpy(&distances.layout, &layout, sizeof layout);
        distances.numbers = layout == NETMESH_DISTANCES_FULL ? full.data() : lower.data();
        distances.entries = entries.data();
        distances.entry_count = entries.size();
        distances.count = n;
        netmesh::Request request = c.request(&netmesh_filter_rips);
        request.distances = handed_.over(distances);
        if ((tape_.byte() & 1) != 0) request.threshold = tape_.number();
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.keep_zero_pairs = tape_.byte() & 1;
        request.cycles = tape_.byte() & 1 ? &netmesh_cycles : nullptr;
        persisted(request, c);
    }
    void points_vineyard() {
        const Choices c = choose();
        netmesh::Request request =
            c.request(filters[tape_.rarely() ? tape_.byte() % filter_count : 11 + tape_.below(2)]);
        request.values = static_cast<netmesh_values>(tape_.below(3));
        request.k = tape_.below(5);
        request.k_last = tape_.rarely() ? tape_.byte() : request.k + tape_.below(4);
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(3);
        request.vines = &netmesh_vines;
        const std::vector<double> x = make_points(c.dim);
        persisted(unseeded(on_points(request, c, x)), c);
    }
    // A complex of few vertices: subsets are frequent. Entries grow with the size unless a byte says otherwise.
    struct Complex {
        std::vector<std::uint32_t> vertices;
        std::vector<std::uint64_t> starts = {0};
        std::vector<double> entries;
    };
    Complex make_complex() {
        Complex made;
        const std::uint32_t count = tape_.below(40);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t mask = tape_.below(32), how = tape_.byte();
            double size = 0;
            for (std::uint32_t v = 0; v < 5; ++v) {
                if (mask >> v & 1) {
                    made.vertices.push_back(how == 200 ? UINT32_MAX : v);
                    ++size;
                }
            }
            made.starts.push_back(how == 201 ? made.starts.back() / 2 : made.vertices.size());
            made.entries.push_back(how >= 250 ? tape_.number() : size);
        }
        return Complex(static_cast<const Complex&>(made));  // no spare capacity
    }
    void homology() {
        const Choices c = choose();
        const Complex complex = make_complex();
        auto simplices = netmesh::sized<netmesh_simplices>();
        simplices.vertices = complex.vertices.data();
        simplices.starts = complex.starts.data();
        simplices.entries = complex.entries.data();
        simplices.simplex_count = complex.entries.size();
        netmesh::Request request = c.request(&netmesh_filter_simplices);
        request.simplices = handed_.over(simplices);
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.keep_zero_pairs = tape_.byte() & 1;
        request.cycles = tape_.byte() & 1 ? &netmesh_cycles : nullptr;
        persisted(request, c);
    }
    void value_vineyard() {
        const Choices c = choose();
        const Complex complex = make_complex();
        auto simplices = netmesh::sized<netmesh_simplices>();
        simplices.vertices = complex.vertices.data();
        simplices.starts = complex.starts.data();
        simplices.simplex_count = complex.entries.size();
        simplices.step_count = 1 + tape_.below(3);
        netmesh::Request request = c.request(&netmesh_filter_simplices);
        request.vines = &netmesh_vines;
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        simplices.by_vertex = tape_.byte() & 1;
        std::vector<double> all;
        for (std::uint64_t step = 0; step < simplices.step_count; ++step)
            for (std::size_t i = 0; i < complex.entries.size(); ++i) {
                const std::uint64_t size = complex.starts[i + 1] - complex.starts[i];
                if (simplices.by_vertex != 0 ? size == 1 : step == 0) all.push_back(complex.entries[i]);
                if (simplices.by_vertex == 0 && step > 0)
                    all.push_back(tape_.rarely() ? tape_.number() : double(size) * 256 + tape_.byte());
            }
        const std::vector<double> entries(all);  // no spare capacity
        simplices.entries = entries.data();
        request.simplices = handed_.over(simplices);
        persisted(request, c);
    }
    void vineyard() {
        const Choices c = choose();
        netmesh::Request request =
            c.request(filters[tape_.rarely() ? tape_.byte() % filter_count : 4 + tape_.below(2)]);
        request.vines = &netmesh_vines;
        request.k = tape_.below(4);
        request.k_last = request.k + tape_.below(4);
        request.values = static_cast<netmesh_values>(tape_.below(3));
        request.max_degree = tape_.below(7);
        persisted(request, c);
    }
    void persist_function() {
        const Choices c = choose();
        well_.kind = static_cast<int>(tape_.below(5));
        auto f = netmesh::sized<netmesh_function>();
        f.evaluate = fuzz::function_of;
        f.user = &well_;
        f.lipschitz = f.cut = 1;
        switch (tape_.below(6)) {
        case 0: f.evaluate = nullptr; break;
        case 1: f.lipschitz = tape_.number(); break;
        case 2: f.distance_factor = tape_.number(); break;
        case 3: f.cut = tape_.number(); break;
        default: break;
        }
        netmesh::Request request = c.request(&netmesh_filter_function);
        request.function = tape_.rarely() ? nullptr : handed_.over<netmesh_function>(f, c);
        request.values = static_cast<netmesh_values>(tape_.below(3));
        request.max_degree = tape_.below(7);
        request.keep_zero_pairs = tape_.byte() & 1;
        if (tape_.rarely()) request.bounds = &netmesh_bounds;
        persisted(request, c);
    }
    void persist_scales() {
        const Choices c = choose();
        const std::vector<double> x = make_points(c.dim);
        netmesh::Request request = on_points(c.request(&netmesh_filter_scales), c, x);
        request.mesh.tau = c.mesh.tau;
        request.goal.eps = c.goal.eps;
        request.goal.theta = c.goal.theta;
        request.values = static_cast<netmesh_values>(tape_.below(3));
        request.max_degree = tape_.below(7);
        request.keep_zero_pairs = tape_.byte() & 1;
        persisted(request, c);
    }
    // More of the diagram that is there.
    netmesh::Request again(const Choices& c) {
        const netmesh_report r = report();
        netmesh::Request request = c.request(filters[r.diagram.filter]);
        request.values = r.diagram.values;
        request.k = r.diagram.k;
        request.max_degree = r.diagram.max_degree;
        request.keep_zero_pairs = tape_.byte() & 1;
        return request;
    }
    void represent() {
        const Choices c = choose();
        netmesh::Request request = again(c);
        request.cycles = &netmesh_cycles;
        persisted(request, c);
    }
    void bound_bars() {
        const Choices c = choose();
        netmesh::Request request = again(c);
        request.bounds = &netmesh_bounds;
        // The function of the last diagram, unless another byte says so.
        auto f = netmesh::sized<netmesh_function>();
        f.evaluate = fuzz::function_of;
        f.user = &well_;
        f.lipschitz = f.cut = tape_.rarely() ? tape_.number() : 1;
        if (tape_.byte() & 1) request.function = handed_.over<netmesh_function>(f, c);
        persisted(request, c);
    }
    void analyse() {
        const Choices c = choose();
        static const double tolerances[] = {0, 16, 4, 1, -1};
        const std::uint32_t bytes =
            tape_.rarely() ? tape_.byte() : static_cast<std::uint32_t>(sizeof(netmesh_analysis));
        netmesh_analysis* const analysis = handed_.over(netmesh_analysis{}, bytes);
        auto request = netmesh::sized<netmesh_analyse_request>();
        request.what = tape_.below(10);
        request.tolerance = tolerances[tape_.below(5)];
        request.monitor = c.monitor;
        const netmesh_request promised = c.mesh_request(nullptr);
        request.promised = handed_.over(promised, c);
        const netmesh_analyse_request* const handed = tape_.rarely() ? nullptr : &request;
        ended(netmesh_analyse(context_, handed, tape_.rarely() ? nullptr : analysis));
    }
    void orders() {
        const netmesh_report r = report();
        std::vector<std::uint32_t> order(r.mesh.inputs);
        std::vector<double> theta(r.mesh.inputs);
        const netmesh_status status = ended(netmesh_well_paced_order(context_, order.data(), theta.data()));
        require(status != NETMESH_OK || r.mesh.present != 0);
        if (status != NETMESH_OK) return;
        if (tape_.byte() & 1) order[0] = tape_.byte();
        ended(netmesh_pace(context_, order.data(), theta.data()));
    }
    void measure() {
        const netmesh_report r = report();
        std::vector<double> ratios(r.mesh.vertices);
        std::vector<std::uint32_t> domains(r.mesh.vertices);
        ended(netmesh_measure_cells(context_, ratios.data(), domains.data()));
    }

    // A mesh to load.
    struct Arrays {
        std::uint32_t dim;
        std::vector<double> vertices;
        std::vector<std::uint8_t> markers;
        std::vector<std::uint32_t> cells;
        std::uint64_t cell_count;
        double domain[NETMESH_DIM_MAX + 1];
    };
    Arrays held(const netmesh_report& r) {
        Arrays a = {};
        a.dim = r.mesh.present != 0 ? r.input.dim : 2;
        for (const netmesh_vertex& v : read_all(context_, netmesh_get_vertex)) {
            a.vertices.insert(a.vertices.end(), v.coordinates, v.coordinates + a.dim);
            a.markers.push_back(static_cast<std::uint8_t>(v.marker));
        }
        for (const netmesh_cell& c : read_all(context_, netmesh_get_cell))
            a.cells.insert(a.cells.end(), c.vertices, c.vertices + a.dim + 1);
        a.cell_count = r.mesh.cells;
        require(a.markers.size() == r.mesh.vertices && a.cells.size() == a.cell_count * (a.dim + 1));
        std::memcpy(a.domain, r.mesh.domain, sizeof a.domain);
        return a;
    }
    // Arbitrary cells on arbitrary points.
    void invent(Arrays* a) {
        a->vertices = make_points(a->dim);
        a->markers.assign(a->vertices.size() / a->dim, 0);
        a->cells.resize((a->dim + 1) * tape_.below(6));
        for (std::uint32_t& v : a->cells) v = tape_.below(12);
        a->cell_count = a->cells.size() / (a->dim + 1);
        for (double& x : a->domain) x = tape_.number();
    }
    void change_one(Arrays* a) {
        const std::size_t low = tape_.byte(), at = low + 256u * tape_.byte();
        switch (tape_.below(7)) {
        case 0: a->cells[at % a->cells.size()] = tape_.byte(); break;
        case 1: a->vertices[at % a->vertices.size()] = tape_.number(); break;
        case 2: a->markers[at % a->markers.size()] = tape_.byte(); break;
        case 3: a->domain[at % (a->dim + 1)] = tape_.number(); break;
        case 4: --a->cell_count; break;
        case 5: a->cells[at % a->cells.size()] = UINT32_MAX; break;
        default: break;
        }
    }
    // What the context holds, a byte of it changed or not.
    void load() {
        Choices c = choose();
        const netmesh_report r = report();
        Arrays a = held(r);
        if (r.mesh.present == 0) {
            if (r.input.dim >= 2) a.dim = r.input.dim;
            invent(&a);
        } else {
            change_one(&a);
        }
        const std::vector<double> vertices(a.vertices);  // no spare capacity
        const std::uint8_t null = tape_.below(8) == 7 ? tape_.byte() : std::uint8_t{0};
        const bool with_domain = r.mesh.is_mesh != 0 || (tape_.byte() & 1) != 0;
        if (c.dim > a.dim) c.dim = a.dim;  // the arrays have rows of so many numbers
        auto request = netmesh::sized<netmesh_load_request>();
        request.dim = c.dim;
        request.monitor = c.monitor;
        request.vertices = null & 1 ? nullptr : vertices.data();
        request.markers = null & 2 ? nullptr : a.markers.data();
        request.vertex_count = a.markers.size();
        request.cells = null & 4 ? nullptr : a.cells.data();
        request.cell_count = a.cell_count;
        request.domain = with_domain ? a.domain : nullptr;
        const netmesh_request promised = c.mesh_request(nullptr);
        request.promised = handed_.over(promised, c);
        ended(netmesh_load(context_, null & 8 ? nullptr : &request));
    }
    void load_cages() {
        const Choices c = choose();
        std::vector<netmesh_cage> cages = read_all(context_, netmesh_get_cage);
        require(cages.size() == report().mesh.hierarchy.cages);
        if (tape_.byte() & 1) {
            const std::uint32_t centre = tape_.below(16), parent = tape_.below(3);
            cages.push_back({sizeof(netmesh_cage), centre, parent, tape_.number()});
        }
        const std::vector<netmesh_cage> list(cages);
        auto request = netmesh::sized<netmesh_cages_request>();
        request.monitor = c.monitor;
        request.cages = list.data();
        request.cage_count = list.size();
        ended(netmesh_load_cages(context_, maybe<netmesh_cages_request>(request, c)));
    }
    void check() {
        const Choices c = choose();
        auto request = netmesh::sized<netmesh_check_request>();
        request.what = tape_.below(40);
        request.monitor = c.monitor;
        const netmesh_request promised = c.mesh_request(nullptr);
        request.promised = handed_.over(promised, c);
        ended(netmesh_check(context_, tape_.rarely() ? nullptr : &request));
    }

    // Everything that the report announces can be read, and the next one behind it cannot.
    void read_results() {
        const netmesh_report r = report();
        netmesh::for_each_figure(r, [](const netmesh_figure& f) { require(f.path != nullptr && f.values != nullptr); });
        require(read_all(context_, netmesh_get_vertex).size() == r.mesh.vertices);
        const std::vector<netmesh_cell> cells = read_all(context_, netmesh_get_cell);
        require(cells.size() == r.mesh.cells);
        for (const netmesh_cell& c : cells)
            for (std::uint32_t j = 0; j <= r.input.dim; ++j)
                require(c.vertices[j] < r.mesh.vertices &&
                        (c.neighbours[j] < r.mesh.cells || c.neighbours[j] == NETMESH_NONE));
        std::uint64_t pairs = 0;
        for (const std::uint64_t n : r.diagram.pairs) pairs += n;
        const std::vector<netmesh_pair> list = read_all(context_, netmesh_get_pair);
        require(list.size() == pairs);
        for (std::uint64_t i = 0; i < pairs; ++i) read_pair(i, list[i]);
        require(read_all(context_, netmesh_get_vine_point).size() == r.vineyard.points);
        require(read_all(context_, netmesh_get_cage).size() == r.mesh.hierarchy.cages);
        read_hidden(r);
        double ratio;
        netmesh_get_vine_ratio(context_, tape_.byte(), &ratio);
        read_far_behind();
    }
    void read_hidden(const netmesh_report& r) {
        std::uint64_t row = 0, before = 0, count = 0;
        for (; netmesh_get_hidden(context_, count, &row) == NETMESH_OK; ++count) {
            require(row < r.input.points && (count == 0 || row > before));
            before = row;
        }
        require(count == r.input.hidden);
    }
    void read_far_behind() {
        auto v = netmesh::sized<netmesh_vertex>();
        auto c = netmesh::sized<netmesh_cell>();
        auto pair = netmesh::sized<netmesh_pair>();
        require(netmesh_get_vertex(context_, UINT64_MAX - tape_.byte(), &v) != NETMESH_OK);
        require(netmesh_get_cell(context_, UINT64_MAX - tape_.byte(), &c) != NETMESH_OK);
        require(netmesh_get_pair(context_, UINT64_MAX - tape_.byte(), &pair) != NETMESH_OK);
        require(netmesh_get_pair(context_, 0, nullptr) != NETMESH_OK);
    }
    void read_pair(std::uint64_t i, const netmesh_pair& pair) {
        require(pair.death >= pair.birth);
        auto bounds = netmesh::sized<netmesh_bar_bounds>();
        netmesh_get_bar_bounds(context_, i, &bounds);
        auto step = netmesh::sized<netmesh_scale_step>();
        if (netmesh_get_scale_step(context_, i, &step) == NETMESH_OK)
            require(step.from <= step.reach && step.ratio >= 1);
        std::uint64_t simplices = 0;
        if (netmesh_get_cycle(context_, i, &simplices) != NETMESH_OK) return;
        const std::vector<netmesh_simplex> cycle = cycle_of(context_, i);
        require(cycle.size() == simplices);
        // With periods two vertices can be one point.
        const bool can_repeat = report().input.periods != 0;
        for (const netmesh_simplex& s : cycle)
            for (std::uint32_t a = 1; a <= pair.degree; ++a)
                require(s.vertices[a - 1] < s.vertices[a] || (can_repeat && s.vertices[a - 1] == s.vertices[a]));
        auto s = netmesh::sized<netmesh_simplex>();
        require(netmesh_get_cycle_simplex(context_, i, simplices, &s) != NETMESH_OK);
    }

    void move() {
        void* const other = std::malloc(block_bytes_);
        require(other != nullptr);
        std::memcpy(other, block_, block_bytes_);
        std::memset(block_, 0x5A, block_bytes_);
        std::free(block_);
        block_ = other;
        require(netmesh_adopt(block_, &context_) == NETMESH_OK && context_ != nullptr);
    }
    void plan() {
        const Choices c = choose();
        const std::uint64_t n = tape_.rarely() ? UINT64_MAX / (tape_.byte() + 1u) : tape_.byte();
        netmesh::Request request = c.mesh_request(filters[tape_.below(filter_count)]);
        request.points.count = n;
        request.k = tape_.rarely() ? tape_.byte() : 0;
        if (tape_.rarely()) request.max_degree = tape_.byte();
        if (tape_.rarely()) request.vines = &netmesh_vines, request.k_last = 2 * request.k;
        netmesh_plan(maybe<netmesh_request>(request, c));
        netmesh_plan_mesh(maybe<netmesh_request>(request, c));
        std::uint64_t most = 0;
        netmesh_plan_polls(maybe<netmesh_request>(request, c), tape_.rarely() ? nullptr : &most);
        netmesh_plan_mesh_polls(maybe<netmesh_request>(request, c), &most);
        auto simplices = netmesh::sized<netmesh_simplices>();
        simplices.simplex_count = n;
        simplices.vertex_count = UINT64_MAX / (tape_.byte() + 1u);
        netmesh::Request homology = c.request(&netmesh_filter_simplices);
        homology.k = 0;
        homology.simplices = &simplices;
        netmesh_plan(&homology);
        simplices.step_count = n;
        homology.vines = &netmesh_vines;
        netmesh_plan(&homology);
    }

    void call() {
        switch (tape_.below(25)) {
        case 0:
        case 1: return triangulate();
        case 2:
        case 3: return make_mesh();
        case 4:
        case 5: return persist();
        case 6: {
            const std::uint32_t which = tape_.byte();
            if (which % 8 == 0) return persist_alpha();
            if (which % 8 == 4) return persist_auto();
            return which >= 192 ? persist_distances() : persist_points();
        }
        case 7: return homology();
        case 8: return vineyard();
        case 9:
        case 10: return represent();
        case 11: return bound_bars();
        case 12: return analyse();
        case 13: return check();
        case 14: return load();
        case 15: return load_cages();
        case 16: return measure();
        case 17: return orders();
        case 18: return persist_function();
        case 19: return persist_scales();
        case 20: return move();
        case 21: return plan();
        case 22: return fit();
        case 23: return tape_.rarely() ? start() : read_results();
        case 24: {
            const std::uint32_t which = tape_.byte();
            if (which % 4 == 0) return value_vineyard();
            if (which % 4 == 1) return points_vineyard();
            if (which % 4 == 2) return anything();
            return which < 64 ? read_results() : weigh_and_repeat();  // other calls read results, too
        }
        default: return read_results();
        }
    }

    Tape tape_;
    fuzz::Handed handed_;
    std::vector<float> floats_;  // points that a call reads
    std::vector<double> doubles_;
    fuzz::Extras extras_;
    void* block_;
    std::size_t block_bytes_ = 0;
    netmesh_context* context_ = nullptr;
    std::uint32_t dim_ = 2;
    int polls_left_ = 0;
    fuzz::Well well_ = {0};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Calls calls(data, size);
    calls.run();
    return 0;
}
