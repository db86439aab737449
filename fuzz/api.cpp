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

// The corpus numbers jobs: 2 a mesh, 3 for persistence, 5 for the tight filter; others are no purpose of a mesh.
netmesh_purpose purpose_of(std::uint32_t job) {
    switch (job) {
    case 2: return NETMESH_PURPOSE_MESH;
    case 3: return NETMESH_PURPOSE_PERSIST;
    case 5: return NETMESH_PURPOSE_TIGHT;
    default: return static_cast<netmesh_purpose>(3 + job);
    }
}

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
    // With the fields that requests of points have in common.
    template <class Request> Request on_points(Request request, const Choices& c, const std::vector<double>& x) {
        request.dim = c.dim;
        request.monitor = c.monitor;
        request.points = x.data();
        request.point_count = c.dim == 0 ? 0 : x.size() / c.dim;
        // The seed says how they lie, so that older inputs mean what they did.
        const std::size_t gap = c.seed / 8 % 3 + 1, dim = c.dim;
        if (c.seed % 8 == 4) request.point_stride_bytes = 4;  // refused
        if (c.seed % 8 == 5) request = in_rows(request, x, &floats_, dim);
        if (c.seed % 8 == 6) request = in_rows(request, x, &floats_, dim + gap);
        if (c.seed % 8 == 7) request = in_rows(request, x, &doubles_, dim + gap);
        return request;
    }
    // In rows of that many numbers, the last one cut off where its point ends.
    template <class Request, class Number>
    static Request in_rows(Request request, const std::vector<double>& x, std::vector<Number>* rows,
                           std::size_t stride) {
        std::vector<Number> all;
        for (std::size_t i = 0; i < request.point_count; ++i) {
            all.resize(i * stride, std::numeric_limits<Number>::quiet_NaN());
            for (std::uint32_t k = 0; k < request.dim; ++k) all.push_back(static_cast<Number>(x[i * request.dim + k]));
        }
        *rows = std::vector<Number>(all);  // no spare capacity
        request.points = rows->data();
        request.point_format = sizeof(Number) == 4 ? NETMESH_POINTS_FLOAT32 : NETMESH_POINTS_FLOAT64;
        request.point_stride_bytes = stride == request.dim ? 0 : stride * sizeof(Number);
        return request;
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
    netmesh_status checked(std::uint32_t what, const netmesh_mesh_request& mesh, const Choices& c) {
        netmesh::requests::Check request;
        request.what = what;
        request.monitor = c.monitor;
        request.mesh = handed_.over(mesh, c);
        return ended(netmesh_check(context_, &request));
    }

    void triangulate() {
        const Choices c = choose();
        const std::vector<double> x = make_points(c.dim);
        netmesh_delaunay_request request = on_points(netmesh::requests::Delaunay(c.dim), c, x);
        request.seed = c.seed;
        if (tape_.rarely()) request.points = nullptr;
        if (ended(netmesh_delaunay(context_, maybe<netmesh_delaunay_request>(request, c))) == NETMESH_OK) {
            const netmesh_status status = checked(7, c.mesh_request(), c);
            require(status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY || status == NETMESH_INVALID_ARGUMENT ||
                    status == NETMESH_CANCELLED);
        }
    }
    void make_mesh() {
        const Choices c = choose();
        const auto method = static_cast<netmesh_method>(tape_.below(4));
        const std::vector<double> x = make_points(c.dim);
        netmesh_mesh_request request = on_points(c.mesh_request(), c, x);
        request.method = method;
        if (method == NETMESH_METHOD_REFINE && tape_.rarely()) request.net_spacing = tape_.byte() / 25.0;
        request.purpose = purpose_of(tape_.rarely() ? tape_.byte() : 2 + tape_.below(4));
        if (tape_.rarely()) request.points = nullptr;
        ended(netmesh_mesh(context_, maybe(request, c)));
    }
    void fit() {
        Choices c = choose();
        if (polls_left_ > 0) polls_left_ = 30;  // some runs
        if (tape_.byte() & 1) c.certificate.ratio = 2 + tape_.byte() / 64.0;
        if (tape_.byte() & 1) {
            c.certificate.focus_from = std::ldexp(1.0, static_cast<int>(tape_.below(16)) - 8);
            c.certificate.focus_to = c.certificate.focus_from * (1 + tape_.byte() / 16.0);
        }
        const std::vector<double> x = make_points(c.dim);
        netmesh_fit_request request = on_points(netmesh::requests::Fit(c.dim), c, x);
        request.seed = c.seed;
        request.ratio = c.certificate.ratio;
        request.focus_from = c.certificate.focus_from;
        request.focus_to = c.certificate.focus_to;
        request.max_degree = tape_.below(8);
        request.keep_zero_pairs = tape_.byte() & 1;
        request.bounds = tape_.byte() & 1;
        if (tape_.byte() & 1) request.filter = static_cast<netmesh_filter>(tape_.below(9));
        if (tape_.byte() & 1) request.values = NETMESH_VALUES_THESIS;
        request.whole_cells = tape_.rarely() ? 1 : 0;
        request.k = tape_.below(4);
        netmesh::requests::Function f;
        f.evaluate = fuzz::function_of;
        f.user = &well_;
        f.lipschitz = f.cut = 1;
        if (tape_.byte() & 1) {
            request.filter = NETMESH_FILTER_FUNCTION;
            request.function = handed_.over<netmesh_function>(f, c);
            request.by_error = tape_.byte() & 1;
            if (request.by_error != 0 && !tape_.rarely()) request.ratio = request.focus_from = request.focus_to = 0;
        }
        if (tape_.rarely()) request.points = nullptr;
        if (tape_.rarely()) {
            request.longer_than = tape_.rarely() ? tape_.number() : 1 + tape_.byte() / 64.0;
            if (tape_.byte() & 1) request.focus_from = request.focus_to = 0;
        }
        if (ended(netmesh_fit(context_, maybe<netmesh_fit_request>(request, c))) != NETMESH_OK) return;
        const netmesh_report r = report();
        const bool laddered = r.diagram.filter == NETMESH_FILTER_COMPLETE && request.values == NETMESH_VALUES_CERTIFIED;
        require(r.diagram.present != 0);
        require(r.decision.present == 0 || r.decision.longer_than == request.longer_than);
        require(!(r.decision.decided_from < r.decision.undecided_to));
        require(!laddered || r.diagram.certified_ratio <= r.mesh.certificate.ratio);
        netmesh_mesh_request made = c.mesh_request();
        made.tau = made.domain_factor = 0;  // a mesh for an error has the dimension's tau
        made.certificate = r.mesh.certificate;
        made.whole_cells = r.mesh.clipped == 0 ? 1 : 0;
        // Meshes for an error are smaller than bounds on sizes allow; those are held to the sizes asked for alone.
        require(r.diagram.fitted_error == 0 || request.by_error != 0);
        Choices all = c;
        all.sets_bytes = false;  // a shorter request would not say what the mesh was made for
        if (r.diagram.fitted_error == 0) require(checked(15, made, all) != NETMESH_CHECK_FAILED);
    }
    void persist() {
        const Choices c = choose();
        netmesh::requests::Persist request(static_cast<netmesh_filter>(tape_.below(14)));
        request.monitor = c.monitor;
        request.k = c.k;
        request.values = static_cast<netmesh_values>(tape_.rarely() ? tape_.byte() : tape_.below(2));
        request.max_degree = tape_.below(8);
        request.keep_zero_pairs = tape_.byte() & 1;
        ended(netmesh_persist(context_, maybe<netmesh_persist_request>(request, c)));
    }
    void persist_alpha() {
        const Choices c = choose();
        netmesh_alpha_request request = netmesh::requests::Alpha(c.dim);
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.keep_zero_pairs = tape_.byte() & 1;
        const std::vector<double> x = make_points(c.dim);
        request = on_points(request, c, x);
        ended(netmesh_persist_alpha(context_, maybe(request, c)));
    }
    void persist_auto() {
        const Choices c = choose();
        netmesh_auto_request request = netmesh::requests::Auto(c.dim);
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.keep_zero_pairs = tape_.byte() & 1;
        const std::vector<double> x = make_points(c.dim);
        request = on_points(request, c, x);
        if (ended(netmesh_persist_auto(context_, maybe(request, c))) != NETMESH_OK) return;
        const netmesh_report r = report();
        const bool is_alpha = r.diagram.filter == NETMESH_FILTER_ALPHA;
        const bool alpha_why = r.diagram.why == NETMESH_WHY_AFFORDABLE || r.diagram.why == NETMESH_WHY_NO_MESH;
        require(r.diagram.why != NETMESH_WHY_ASKED && is_alpha == alpha_why && is_alpha == (r.mesh.is_mesh == 0));
        netmesh_plan_auto(&request);
    }
    void persist_points() {
        const Choices c = choose();
        const auto filter = static_cast<netmesh_filter>(tape_.rarely() ? tape_.byte() : 9 + tape_.below(4));
        netmesh_points_request request = netmesh::requests::Points(c.dim, filter);
        request.values = static_cast<netmesh_values>(tape_.below(3));
        request.k = tape_.below(6);
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.keep_zero_pairs = tape_.byte() & 1;
        request.representatives = tape_.byte() & 1;
        const std::vector<double> x = make_points(c.dim);
        request = on_points(request, c, x);
        ended(netmesh_persist_points(context_, maybe(request, c)));
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
        netmesh::requests::Distances request;
        request.monitor = c.monitor;
        std::memcpy(&request.layout, &layout, sizeof layout);
        request.numbers = layout == NETMESH_DISTANCES_FULL ? full.data() : lower.data();
        request.entries = entries.data();
        request.entry_count = entries.size();
        request.point_count = n;
        if ((tape_.byte() & 1) != 0) request.threshold = tape_.number();
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.keep_zero_pairs = tape_.byte() & 1;
        request.representatives = tape_.byte() & 1;
        ended(netmesh_persist_distances(context_, maybe<netmesh_distances_request>(request, c)));
        netmesh_plan_distances(&request);
    }
    void points_vineyard() {
        const Choices c = choose();
        const auto filter = static_cast<netmesh_filter>(tape_.rarely() ? tape_.byte() : 11 + tape_.below(2));
        netmesh_points_vineyard_request request = netmesh::requests::PointsVineyard(c.dim, filter);
        request.values = static_cast<netmesh_values>(tape_.below(3));
        request.k_first = tape_.below(5);
        request.k_last = tape_.rarely() ? tape_.byte() : request.k_first + tape_.below(4);
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(3);
        const std::vector<double> x = make_points(c.dim);
        request = on_points(request, c, x);
        ended(netmesh_points_vineyard(context_, maybe(request, c)));
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
        netmesh::requests::Homology request;
        request.monitor = c.monitor;
        request.vertices = complex.vertices.data();
        request.starts = complex.starts.data();
        request.entries = complex.entries.data();
        request.simplex_count = complex.entries.size();
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.keep_zero_pairs = tape_.byte() & 1;
        request.representatives = tape_.byte() & 1;
        ended(netmesh_homology(context_, maybe<netmesh_homology_request>(request, c)));
    }
    void value_vineyard() {
        const Choices c = choose();
        const Complex complex = make_complex();
        netmesh::requests::ValueVineyard request;
        request.monitor = c.monitor;
        request.vertices = complex.vertices.data();
        request.starts = complex.starts.data();
        request.simplex_count = complex.entries.size();
        request.step_count = 1 + tape_.below(3);
        request.max_degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        request.by_vertex = tape_.byte() & 1;
        std::vector<double> all;
        for (std::uint64_t step = 0; step < request.step_count; ++step)
            for (std::size_t i = 0; i < complex.entries.size(); ++i) {
                const std::uint64_t size = complex.starts[i + 1] - complex.starts[i];
                if (request.by_vertex != 0 ? size == 1 : step == 0) all.push_back(complex.entries[i]);
                if (request.by_vertex == 0 && step > 0)
                    all.push_back(tape_.rarely() ? tape_.number() : double(size) * 256 + tape_.byte());
            }
        const std::vector<double> entries(all);  // no spare capacity
        request.entries = entries.data();
        ended(netmesh_value_vineyard(context_, maybe<netmesh_value_vineyard_request>(request, c)));
    }
    void vineyard() {
        const Choices c = choose();
        netmesh::requests::Vineyard request(
            static_cast<netmesh_filter>(tape_.rarely() ? tape_.byte() : 4 + tape_.below(2)));
        request.monitor = c.monitor;
        request.k_first = tape_.below(4);
        request.k_last = request.k_first + tape_.below(4);
        request.values = static_cast<netmesh_values>(tape_.below(3));
        request.max_degree = tape_.below(7);
        ended(netmesh_vineyard(context_, maybe<netmesh_vineyard_request>(request, c)));
    }
    void persist_function() {
        const Choices c = choose();
        well_.kind = static_cast<int>(tape_.below(5));
        netmesh::requests::Function f;
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
        netmesh::requests::Persist request(NETMESH_FILTER_FUNCTION);
        request.monitor = c.monitor;
        request.function = tape_.rarely() ? nullptr : handed_.over<netmesh_function>(f, c);
        request.values = static_cast<netmesh_values>(tape_.below(3));
        request.max_degree = tape_.below(7);
        request.keep_zero_pairs = tape_.byte() & 1;
        ended(netmesh_persist(context_, maybe<netmesh_persist_request>(request, c)));
    }
    void persist_scales() {
        const Choices c = choose();
        const std::vector<double> x = make_points(c.dim);
        netmesh_scales_request request = on_points(netmesh::requests::Scales(c.dim), c, x);
        request.seed = c.seed;
        request.tau = c.tau;
        request.eps = c.eps;
        request.theta = c.theta;
        request.values = static_cast<netmesh_values>(tape_.below(3));
        request.max_degree = tape_.below(7);
        request.keep_zero_pairs = tape_.byte() & 1;
        ended(netmesh_persist_scales(context_, maybe(request, c)));
    }
    void represent() {
        const Choices c = choose();
        netmesh::requests::Represent request;
        request.monitor = c.monitor;
        ended(netmesh_represent(context_, maybe<netmesh_represent_request>(request, c)));
    }
    void bound_bars() {
        const Choices c = choose();
        netmesh::requests::Bounds request;
        request.monitor = c.monitor;
        // The function of the last diagram, unless another byte says so.
        netmesh::requests::Function f;
        f.evaluate = fuzz::function_of;
        f.user = &well_;
        f.lipschitz = f.cut = tape_.rarely() ? tape_.number() : 1;
        if (tape_.byte() & 1) request.function = handed_.over<netmesh_function>(f, c);
        ended(netmesh_bound_bars(context_, maybe<netmesh_bounds_request>(request, c)));
    }
    void analyse() {
        const Choices c = choose();
        static const double tolerances[] = {0, 16, 4, 1, -1};
        const std::uint32_t bytes =
            tape_.rarely() ? tape_.byte() : static_cast<std::uint32_t>(sizeof(netmesh_analysis));
        netmesh_analysis* const analysis = handed_.over(netmesh_analysis{}, bytes);
        netmesh::requests::Analyse request;
        request.what = tape_.below(10);
        request.tolerance = tolerances[tape_.below(5)];
        request.monitor = c.monitor;
        const netmesh_mesh_request mesh = c.mesh_request();
        request.mesh = handed_.over(mesh, c);
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
        netmesh::requests::Load request(c.dim);
        request.dim = c.dim;
        request.monitor = c.monitor;
        request.vertices = null & 1 ? nullptr : vertices.data();
        request.markers = null & 2 ? nullptr : a.markers.data();
        request.vertex_count = a.markers.size();
        request.cells = null & 4 ? nullptr : a.cells.data();
        request.cell_count = a.cell_count;
        request.domain = with_domain ? a.domain : nullptr;
        request.mesh = handed_.over(c.mesh_request(), c);
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
        netmesh::requests::Cages request;
        request.monitor = c.monitor;
        request.cages = list.data();
        request.cage_count = list.size();
        ended(netmesh_load_cages(context_, maybe<netmesh_cages_request>(request, c)));
    }
    void check() {
        const Choices c = choose();
        netmesh::requests::Check request;
        request.what = tape_.below(40);
        request.monitor = c.monitor;
        request.mesh = handed_.over(c.mesh_request(), c);
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
        double ratio;
        netmesh_get_vine_ratio(context_, tape_.byte(), &ratio);
        read_far_behind();
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
        for (const netmesh_simplex& s : cycle)
            for (std::uint32_t a = 1; a <= pair.degree; ++a) require(s.vertices[a - 1] < s.vertices[a]);
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
    // The corpus numbers jobs: 1 and 4 are triangulations, 6 is scale by scale, the others are meshes.
    void plan_job(std::uint32_t job, const Choices& c, std::uint64_t n) {
        netmesh::requests::Delaunay delaunay(c.dim);
        delaunay.point_count = n;
        delaunay.purpose = job == 4 ? NETMESH_PURPOSE_PERSIST : NETMESH_PURPOSE_MESH;
        netmesh::requests::Scales scales(c.dim);
        scales.point_count = n;
        scales.tau = c.tau;
        scales.eps = c.eps;
        scales.theta = c.theta;
        netmesh_mesh_request mesh = c.mesh_request();
        mesh.point_count = n;
        mesh.purpose = purpose_of(job);
        if (job == 1 || job == 4) {
            netmesh_plan_delaunay(maybe<netmesh_delaunay_request>(delaunay, c));
        } else if (job == 6) {
            netmesh_plan_scales(maybe<netmesh_scales_request>(scales, c));
        } else {
            netmesh_plan_mesh(maybe(mesh, c));
        }
    }
    void plan() {
        const Choices c = choose();
        const std::uint64_t n = tape_.rarely() ? UINT64_MAX / (tape_.byte() + 1u) : tape_.byte();
        plan_job(tape_.below(9), c, n);
        netmesh_points_request points = netmesh::requests::Points(c.dim, static_cast<netmesh_filter>(tape_.below(16)));
        points.dim = c.dim;
        points.point_count = n;
        const netmesh_points_request* const handed = tape_.rarely() ? nullptr : &points;
        points.k = tape_.byte();
        points.max_degree = tape_.byte();
        netmesh_plan_points(handed);
        netmesh_alpha_request alpha = netmesh::requests::Alpha(c.dim);
        alpha.point_count = n;
        netmesh_plan_alpha(&alpha);
        netmesh_points_vineyard_request nested = netmesh::requests::PointsVineyard(c.dim, points.filter);
        nested.point_count = n;
        nested.k_first = points.k / 2;
        nested.k_last = points.k;
        nested.max_degree = points.max_degree;
        netmesh_plan_points_vineyard(&nested);
        netmesh::requests::Homology homology;
        homology.simplex_count = n;
        homology.vertex_count = UINT64_MAX / (tape_.byte() + 1u);
        netmesh_plan_homology(&homology);
        netmesh::requests::ValueVineyard values;
        values.simplex_count = n;
        values.vertex_count = homology.vertex_count;
        values.step_count = n;
        netmesh_plan_value_vineyard(&values);
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
            const std::uint32_t which = tape_.byte() % 4;
            return which % 2 == 0 ? value_vineyard() : which == 1 ? points_vineyard() : read_results();
        }
        default: return read_results();
        }
    }

    Tape tape_;
    fuzz::Handed handed_;
    std::vector<float> floats_;  // points that a call reads
    std::vector<double> doubles_;
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
