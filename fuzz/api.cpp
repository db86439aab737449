// Bytes to a sequence of calls on one context, in any order, with good arguments and bad ones. The block, and each
// array, is allocated at its exact size, so that AddressSanitizer sees every access outside. Each call must end in a
// known status that is not NETMESH_INTERNAL, with a text, and results must be readable as far as the report says.
#include <cstring>
#include <vector>

#include "fuzz/decoder.hpp"
#include "netmesh.h"

namespace {

using fuzz::require;
using fuzz::Tape;

// A job of a fuzzer may not take long: so many polls, then it is cancelled.
int poll_budget(void* user, const netmesh_progress* progress) {
    require(progress->stage <= NETMESH_STAGE_COUNT);
    int* const left = static_cast<int*>(user);
    return --*left < 0;
}

struct Well {
    int kind;
};
double size_of(void* user, const double* x) {
    const double r = std::fabs(x[0]) + std::fabs(x[1]);
    switch (static_cast<Well*>(user)->kind) {
    case 0: return 1 + r / 8;
    case 1: return std::numeric_limits<double>::infinity();
    case 2: return 0;
    case 3: return std::numeric_limits<double>::quiet_NaN();
    default: return x[0];
    }
}
double function_of(void* user, const double* x) {
    const double r = std::fabs(x[0]) + std::fabs(x[1]);
    switch (static_cast<Well*>(user)->kind) {
    case 0: return r / 2;
    case 1: return 1;
    case 2: return -1;
    case 3: return std::numeric_limits<double>::quiet_NaN();
    default: return r > 2 ? std::numeric_limits<double>::infinity() : 0;
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
        require(static_cast<unsigned>(status) <= NETMESH_NOT_A_COMPLEX && status != NETMESH_INTERNAL);
        require(netmesh_status_text(status) != nullptr);
        const netmesh_detail detail = netmesh_get_detail(context_);
        require(detail.message != nullptr);
        if (status != NETMESH_OK) require(detail.status == status);
        return status;
    }

    netmesh_options make_options() {
        netmesh_options o;
        netmesh_options_init(&o, dim_);
        polls_left_ = 1;
        well_.kind = 0;
        o.poll = poll_budget;
        o.user = &polls_left_;
        if (tape_.below(4) != 0) return o;
        switch (tape_.below(18)) {
        case 0: o.dim = dim_ = 2 + tape_.below(5); break;
        case 1: o.dim = tape_.byte(); break;
        case 2: o.struct_bytes = tape_.byte(); break;
        case 3: o.tau = tape_.number(); break;
        case 4: o.domain_factor = tape_.number(); break;
        case 5: o.eps = tape_.number(); break;
        case 6: o.theta = tape_.number(); break;
        case 7: o.k = tape_.byte(); break;
        case 8: polls_left_ = 0; break;
        case 9: o.finish = tape_.below(3); break;
        case 10: o.over_refine_eps = tape_.number(); break;
        case 11:
            o.size = size_of;
            o.size_user = &well_;
            well_.kind = static_cast<int>(tape_.below(5));
            break;
        case 12: o.seed = tape_.byte(); break;
        case 13: o.tau = 2 + tape_.byte() / 64.0; break;
        case 14: o.ratio = 1.75 + tape_.byte() / 64.0; break;
        case 15:
            o.ratio = 2 + tape_.byte() / 64.0;
            o.focus_ratio = o.ratio - tape_.byte() / 256.0;
            o.focus_from = std::ldexp(1.0, static_cast<int>(tape_.below(16)) - 8);
            o.focus_to = o.focus_from * (1 + tape_.byte() / 16.0);
            break;
        case 16: o.audit = tape_.below(5); break;
        default:
            (tape_.byte() & 1 ? o.ratio : o.focus_ratio) = tape_.number();
            (tape_.byte() & 1 ? o.focus_from : o.focus_to) = tape_.number();
            break;
        }
        return o;
    }
    const netmesh_options* maybe(const netmesh_options& options) { return tape_.rarely() ? nullptr : &options; }

    std::vector<double> make_points(std::uint32_t dim) {
        std::vector<double> x;
        const std::uint32_t n = tape_.below(14);
        for (std::uint32_t i = 0; i < n * dim; ++i) x.push_back(tape_.number());
        return std::vector<double>(x);  // no spare capacity
    }
    netmesh_report report() {
        netmesh_report r;
        r.struct_bytes = sizeof r;
        require(netmesh_get_report(context_, &r) == NETMESH_OK);
        return r;
    }

    void triangulate() {
        const netmesh_options o = make_options();
        const std::vector<double> x = make_points(o.dim);
        const std::size_t n = o.dim == 0 ? 0 : x.size() / o.dim;
        if (ended(netmesh_delaunay(context_, tape_.rarely() ? nullptr : x.data(), n, maybe(o))) == NETMESH_OK) {
            const netmesh_status status = ended(netmesh_check(context_, 7, &o));
            require(status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY || status == NETMESH_INVALID_ARGUMENT ||
                    status == NETMESH_CANCELLED);
        }
    }
    void make_mesh() {
        netmesh_options o = make_options();
        o.method = static_cast<netmesh_method>(tape_.below(4));
        const std::vector<double> x = make_points(o.dim);
        const std::size_t n = o.dim == 0 ? 0 : x.size() / o.dim;
        const auto job = static_cast<netmesh_job>(tape_.rarely() ? tape_.byte() : 2 + tape_.below(4));
        ended(netmesh_mesh(context_, tape_.rarely() ? nullptr : x.data(), n, job, maybe(o)));
    }
    void fit() {
        netmesh_options o = make_options();
        if (polls_left_ > 0) polls_left_ = 30;  // some runs
        if (tape_.byte() & 1) o.ratio = 2 + tape_.byte() / 64.0;
        if (tape_.byte() & 1) {
            o.focus_from = std::ldexp(1.0, static_cast<int>(tape_.below(16)) - 8);
            o.focus_to = o.focus_from * (1 + tape_.byte() / 16.0);
        }
        const std::vector<double> x = make_points(o.dim);
        const std::size_t n = o.dim == 0 ? 0 : x.size() / o.dim;
        const std::uint32_t degree = tape_.below(8);
        const int zeros = tape_.byte() & 1, bounds = tape_.byte() & 1;
        if (ended(netmesh_fit(context_, tape_.rarely() ? nullptr : x.data(), n, degree, zeros, bounds, maybe(o))) !=
            NETMESH_OK)
            return;
        const netmesh_report r = report();
        require(r.certified_ratio <= r.ratio && r.has_diagram != 0);
        o.ratio = r.ratio;
        o.focus_ratio = r.focus_ratio;
        o.focus_from = r.focus_from;
        o.focus_to = r.focus_to;
        const netmesh_status status = ended(netmesh_check(context_, 15, &o));
        require(status != NETMESH_CHECK_FAILED);
    }
    void persist() {
        const netmesh_options o = make_options();
        const auto filter = static_cast<netmesh_filter>(tape_.below(14));
        const auto values = static_cast<netmesh_values>(tape_.rarely() ? tape_.byte() : tape_.below(2));
        const std::uint32_t degree = tape_.below(8);
        ended(netmesh_persist(context_, filter, values, degree, tape_.byte() & 1, maybe(o)));
    }
    void persist_points() {
        const netmesh_options o = make_options();
        const auto filter = static_cast<netmesh_filter>(tape_.rarely() ? tape_.byte() : 9 + tape_.below(4));
        const auto values = static_cast<netmesh_values>(tape_.below(3));
        const std::uint32_t k = tape_.below(6), degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        const int zeros = tape_.byte() & 1, cycles = tape_.byte() & 1;
        const std::vector<double> x = make_points(o.dim);
        const std::size_t n = o.dim == 0 ? 0 : x.size() / o.dim;
        ended(netmesh_persist_points(context_, x.data(), n, filter, values, k, degree, zeros, cycles, maybe(o)));
    }
    void homology() {
        const netmesh_options o = make_options();
        std::vector<std::uint32_t> vertices;
        std::vector<std::uint64_t> starts = {0};
        std::vector<double> values;
        const std::uint32_t count = tape_.below(40);
        for (std::uint32_t i = 0; i < count; ++i) {
            // A mask of few vertices: subsets are frequent. Values grow with the size unless the byte says otherwise.
            const std::uint32_t mask = tape_.below(32), how = tape_.byte();
            double size = 0;
            for (std::uint32_t v = 0; v < 5; ++v) {
                if (mask >> v & 1) {
                    vertices.push_back(how == 200 ? UINT32_MAX : v);
                    ++size;
                }
            }
            starts.push_back(how == 201 ? starts.back() / 2 : vertices.size());
            values.push_back(how >= 250 ? tape_.number() : size);
        }
        const std::vector<std::uint32_t> v(vertices);
        const std::vector<std::uint64_t> s(starts);
        const std::vector<double> t(values);
        const std::uint32_t degree = tape_.rarely() ? tape_.byte() : tape_.below(4);
        const int zeros = tape_.byte() & 1, cycles = tape_.byte() & 1;
        ended(netmesh_homology(context_, v.data(), s.data(), t.data(), count, degree, zeros, cycles, maybe(o)));
    }
    void vineyard() {
        const netmesh_options o = make_options();
        const auto filter = static_cast<netmesh_filter>(tape_.rarely() ? tape_.byte() : 4 + tape_.below(2));
        const std::uint32_t first = tape_.below(4), last = first + tape_.below(4);
        ended(netmesh_vineyard(context_, filter, first, last, static_cast<netmesh_values>(tape_.below(3)),
                               tape_.below(7), maybe(o)));
    }
    void persist_function() {
        const netmesh_options o = make_options();
        well_.kind = static_cast<int>(tape_.below(5));
        netmesh_function f = {function_of, &well_, 1, 0, 1};
        switch (tape_.below(6)) {
        case 0: f.evaluate = nullptr; break;
        case 1: f.lipschitz = tape_.number(); break;
        case 2: f.distance_factor = tape_.number(); break;
        case 3: f.cut = tape_.number(); break;
        default: break;
        }
        ended(netmesh_persist_function(context_, tape_.rarely() ? nullptr : &f,
                                       static_cast<netmesh_values>(tape_.below(3)), tape_.below(7), tape_.byte() & 1,
                                       maybe(o)));
    }
    void persist_scales() {
        const netmesh_options o = make_options();
        const std::vector<double> x = make_points(o.dim);
        const std::size_t n = o.dim == 0 ? 0 : x.size() / o.dim;
        const auto values = static_cast<netmesh_values>(tape_.below(3));
        ended(netmesh_persist_scales(context_, x.data(), n, values, tape_.below(7), tape_.byte() & 1, maybe(o)));
    }
    void analyse() {
        const netmesh_options o = make_options();
        static const double tolerances[] = {0, 16, 4, 1, -1};
        netmesh_analysis a;
        a.struct_bytes = tape_.rarely() ? tape_.byte() : sizeof a;
        const std::uint32_t what = tape_.below(10);
        const double tolerance = tolerances[tape_.below(5)];
        ended(netmesh_analyse(context_, what, tolerance, maybe(o), tape_.rarely() ? nullptr : &a));
    }
    void orders() {
        const netmesh_report r = report();
        std::vector<std::uint32_t> order(r.inputs);
        std::vector<double> theta(r.inputs);
        const netmesh_status status = ended(netmesh_well_paced_order(context_, order.data(), theta.data()));
        require(status != NETMESH_OK || r.cells != 0);
        if (status != NETMESH_OK) return;
        if (tape_.byte() & 1) order[0] = tape_.byte();
        ended(netmesh_pace(context_, order.data(), theta.data()));
    }
    void measure() {
        const netmesh_report r = report();
        std::vector<double> ratios(r.vertices);
        std::vector<std::uint32_t> domains(r.vertices);
        ended(netmesh_measure_cells(context_, ratios.data(), domains.data()));
    }

    // What the context holds, a byte of it changed or not.
    void load() {
        const netmesh_options o = make_options();
        const netmesh_report r = report();
        const std::uint32_t dim = r.dim >= 2 ? r.dim : 2;
        const std::uint64_t count = r.cells != 0 ? r.vertices : 0;
        std::vector<double> vertices(count * dim);
        std::vector<std::uint8_t> markers(count);
        std::vector<std::uint32_t> cells(r.cells * (dim + 1));
        for (std::uint64_t i = 0; i < count; ++i) {
            netmesh_vertex v;
            require(netmesh_get_vertex(context_, i, &v) == NETMESH_OK);
            std::memcpy(&vertices[i * dim], v.coordinates, dim * sizeof(double));
            markers[i] = static_cast<std::uint8_t>(v.marker);
        }
        for (std::uint64_t i = 0; i < r.cells; ++i) {
            netmesh_cell c;
            require(netmesh_get_cell(context_, i, &c) == NETMESH_OK);
            std::memcpy(&cells[i * (dim + 1)], c.vertices, (dim + 1) * sizeof(std::uint32_t));
        }
        double domain[NETMESH_DIM_MAX + 1];
        std::memcpy(domain, r.domain, sizeof domain);
        std::uint64_t cell_count = r.cells;
        if (r.cells == 0) {  // arbitrary cells on arbitrary points
            vertices = make_points(dim);
            markers.assign(vertices.size() / dim, 0);
            cells.resize((dim + 1) * tape_.below(6));
            for (std::uint32_t& v : cells) v = tape_.below(12);
            cell_count = cells.size() / (dim + 1);
            for (double& x : domain) x = tape_.number();
        } else {
            const std::size_t at = tape_.byte() + 256u * tape_.byte();
            switch (tape_.below(7)) {
            case 0: cells[at % cells.size()] = tape_.byte(); break;
            case 1: vertices[at % vertices.size()] = tape_.number(); break;
            case 2: markers[at % markers.size()] = tape_.byte(); break;
            case 3: domain[at % (dim + 1)] = tape_.number(); break;
            case 4: --cell_count; break;
            case 5: cells[at % cells.size()] = UINT32_MAX; break;
            default: break;
            }
        }
        const std::vector<double> v(vertices);
        const std::uint8_t null = tape_.below(8) == 7 ? tape_.byte() : std::uint8_t{0};
        const bool with_domain = r.is_mesh != 0 || (tape_.byte() & 1) != 0;
        netmesh_options used = o;
        if (r.cells != 0 && o.dim != dim && o.dim > dim) used.dim = dim;  // the arrays have rows of dim numbers
        if (r.cells == 0 && o.dim > dim) used.dim = dim;
        ended(netmesh_load(context_, null & 1 ? nullptr : v.data(), null & 2 ? nullptr : markers.data(), markers.size(),
                           null & 4 ? nullptr : cells.data(), cell_count, with_domain ? domain : nullptr,
                           null & 8 ? nullptr : &used));
    }
    void load_cages() {
        const netmesh_options o = make_options();
        std::vector<netmesh_cage> cages;
        const netmesh_report r = report();
        for (std::uint64_t i = 0; i < r.cages; ++i) {
            netmesh_cage c;
            require(netmesh_get_cage(context_, i, &c) == NETMESH_OK);
            cages.push_back(c);
        }
        if (tape_.byte() & 1) cages.push_back({tape_.below(16), tape_.below(3), tape_.number()});
        const std::vector<netmesh_cage> list(cages);
        ended(netmesh_load_cages(context_, list.data(), list.size(), maybe(o)));
    }
    void check() {
        const netmesh_options o = make_options();
        ended(netmesh_check(context_, tape_.below(40), maybe(o)));
    }

    // Everything that the report announces can be read, and the next one behind it cannot.
    void read_all() {
        const netmesh_report r = report();
        netmesh_vertex v;
        // Without cells there are no vertices to read: the report counts those of a complex.
        const std::uint64_t vertices = r.cells != 0 ? r.vertices : 0;
        for (std::uint64_t i = 0; i < vertices; ++i) require(netmesh_get_vertex(context_, i, &v) == NETMESH_OK);
        require(netmesh_get_vertex(context_, vertices, &v) != NETMESH_OK);
        netmesh_cell c;
        for (std::uint64_t i = 0; i < r.cells; ++i) {
            require(netmesh_get_cell(context_, i, &c) == NETMESH_OK);
            for (std::uint32_t j = 0; j <= r.dim; ++j)
                require(c.vertices[j] < r.vertices && (c.neighbours[j] < r.cells || c.neighbours[j] == NETMESH_NONE));
        }
        require(netmesh_get_cell(context_, r.cells, &c) != NETMESH_OK);
        std::uint64_t pairs = 0;
        for (const std::uint64_t n : r.pairs) pairs += n;
        if (r.has_diagram == 0) pairs = 0;
        for (std::uint64_t i = 0; i < pairs; ++i) read_pair(i);
        netmesh_pair pair;
        require(netmesh_get_pair(context_, pairs, &pair) != NETMESH_OK);
        netmesh_vine_point p;
        const std::uint64_t vine_points = r.has_vineyard != 0 ? r.vine_points : 0;
        for (std::uint64_t i = 0; i < vine_points; ++i) require(netmesh_get_vine_point(context_, i, &p) == NETMESH_OK);
        require(netmesh_get_vine_point(context_, vine_points, &p) != NETMESH_OK);
        double ratio;
        netmesh_get_vine_ratio(context_, tape_.byte(), &ratio);
        netmesh_cage cage;
        require(netmesh_get_cage(context_, r.cages, &cage) != NETMESH_OK);
        require(netmesh_get_vertex(context_, UINT64_MAX - tape_.byte(), &v) != NETMESH_OK);
        require(netmesh_get_cell(context_, UINT64_MAX - tape_.byte(), &c) != NETMESH_OK);
        require(netmesh_get_pair(context_, UINT64_MAX - tape_.byte(), &pair) != NETMESH_OK);
        require(netmesh_get_pair(context_, 0, nullptr) != NETMESH_OK);
    }
    void read_pair(std::uint64_t i) {
        netmesh_pair pair;
        require(netmesh_get_pair(context_, i, &pair) == NETMESH_OK && pair.death >= pair.birth);
        netmesh_bar_bounds bounds;
        netmesh_get_bar_bounds(context_, i, &bounds);
        netmesh_scale_step step;
        if (netmesh_get_scale_step(context_, i, &step) == NETMESH_OK)
            require(step.from <= step.reach && step.ratio >= 1);
        std::uint64_t simplices = 0;
        if (netmesh_get_cycle(context_, i, &simplices) != NETMESH_OK) return;
        netmesh_simplex s;
        for (std::uint64_t j = 0; j < simplices; ++j) {
            require(netmesh_get_cycle_simplex(context_, i, j, &s) == NETMESH_OK);
            for (std::uint32_t a = 1; a <= pair.degree; ++a) require(s.vertices[a - 1] < s.vertices[a]);
        }
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
        const netmesh_options o = make_options();
        const std::uint64_t n = tape_.rarely() ? UINT64_MAX / (tape_.byte() + 1u) : tape_.byte();
        netmesh_plan_bytes(static_cast<netmesh_job>(tape_.below(9)), maybe(o), n);
        netmesh_points_bytes(static_cast<netmesh_filter>(tape_.below(16)), maybe(o), n, tape_.byte(), tape_.byte());
        netmesh_homology_bytes(n, UINT64_MAX / (tape_.byte() + 1u));
    }

    void call() {
        switch (tape_.below(25)) {
        case 0:
        case 1: return triangulate();
        case 2:
        case 3: return make_mesh();
        case 4:
        case 5: return persist();
        case 6: return persist_points();
        case 7: return homology();
        case 8: return vineyard();
        case 9:
        case 10: {
            const netmesh_options o = make_options();
            ended(netmesh_represent(context_, maybe(o)));
            return;
        }
        case 11: {
            const netmesh_options o = make_options();
            ended(netmesh_bound_bars(context_, maybe(o)));
            return;
        }
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
        case 23: return tape_.rarely() ? start() : read_all();
        default: return read_all();
        }
    }

    Tape tape_;
    void* block_;
    std::size_t block_bytes_ = 0;
    netmesh_context* context_ = nullptr;
    std::uint32_t dim_ = 2;
    int polls_left_ = 0;
    Well well_ = {0};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Calls calls(data, size);
    calls.run();
    return 0;
}
