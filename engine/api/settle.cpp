#include "api/settling.hpp"

#include <cstddef>

#include "jobs/point_set.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

constexpr double accuracy = 0.5, mediality_of_scales = 1.0 / 9;
constexpr std::uint64_t seed_default = 1;

// A member of the request that is given where it is not 0, in the order of given::. Two have another default.
struct Given {
    std::uint16_t offset;
    std::uint8_t bytes, field;
};
template <class Member> constexpr std::uint8_t member_bytes(const Member&) {
    return sizeof(Member);  // NOLINT(bugprone-sizeof-expression): members may be pointers
}
#define NETMESH_PART(name, member, field, text)                                                                        \
    {static_cast<std::uint16_t>(offsetof(netmesh_request, member)), member_bytes(netmesh_request{}.member),            \
     NETMESH_FIELD_##field},
constexpr Given can_be_given[] = {NETMESH_EACH_GIVEN(NETMESH_PART)};
#undef NETMESH_PART
static_assert(NETMESH_FIELD_COUNT <= UINT8_MAX);

bool is_part_given(const netmesh_request& r, const Given& part) {
    if (part.field == NETMESH_FIELD_THRESHOLD) return r.threshold != infinity;
    if (part.field == NETMESH_FIELD_SEED) return r.seed != seed_default;
    const unsigned char* const bytes = reinterpret_cast<const unsigned char*>(&r) + part.offset;
    for (unsigned i = 0; i < part.bytes; ++i)
        if (bytes[i] != 0) return true;
    return false;
}

// What is said of weights and periods without naming a kind of them, or by naming one.
Complaint settle_weights(const Settling& s) {
    if (s.r.squares > 1) return {NETMESH_FIELD_SQUARES, "neither 0 nor 1"};
    if (s.r.weighting != nullptr) return dispatch_settle(*s.r.weighting, s);
    const netmesh_points& p = s.r.points;
    const netmesh_field field = s.r.squares != 0             ? NETMESH_FIELD_SQUARES
                                : p.weights != nullptr       ? NETMESH_FIELD_WEIGHTING
                                : p.weight_stride_bytes != 0 ? NETMESH_FIELD_WEIGHT_STRIDE_BYTES
                                                             : NETMESH_FIELD_NONE;
    return {field,
            field != NETMESH_FIELD_NONE ? "of points with weights alone; name a weighting, or leave it out" : nullptr};
}

Complaint settle_periods(const Settling& s) {
    const netmesh_points& p = s.r.points;
    if (s.r.periods != nullptr) return dispatch_settle(*s.r.periods, s);
    return p.lattice != nullptr || p.lattice_count != 0
               ? Complaint{NETMESH_FIELD_PERIODS, "a lattice without periods; name netmesh_periodic"}
               : fine();
}

Complaint settle_source(const Settling& s) {
    const netmesh_points& p = s.r.points;
    if ((p.dim != 0) + (s.r.distances != nullptr) + (s.r.simplices != nullptr) > 1)
        return {NETMESH_FIELD_POINTS, "more than one source; give points, distances or simplices"};
    if (s.source != Source::points)
        return p.coordinates != nullptr || p.count != 0 || s.call == Call::mesh
                   ? Complaint{NETMESH_FIELD_DIM, "points without a dimension; give points.dim"}
                   : fine();
    const bool is_rips = s.r.filter != nullptr && s.r.filter->id == NETMESH_FILTER_RIPS;
    if (!is_rips || p.dim <= NETMESH_DIM_MAX || p.dim > NETMESH_RIPS_DIM_MAX) {
        const Complaint complaint = complaint_about_dim(p.dim);
        if (complaint.text != nullptr) return complaint;
    }
    if (s.is_promise()) return fine();
    return complaint_about_rows(p);
}

Complaint settle_promised_filter(const Settling& s) {
    return s.r.filter == nullptr || s.is_of(FilterSource::mesh) || s.is_of(FilterSource::delaunay)
               ? fine()
               : Complaint{NETMESH_FIELD_FILTER, "not a filter on a mesh, so nothing of a mesh is promised"};
}

Complaint settle_filter(const Settling& s) {
    const netmesh_filter* const filter = s.r.filter;
    if (filter == nullptr && s.call == Call::persist)
        return {NETMESH_FIELD_FILTER, "no filter; name one, such as netmesh_filter_auto"};
    if (filter == nullptr)
        return s.rules.method != nullptr ? fine()
                                         : Complaint{NETMESH_FIELD_METHOD, "no filter and no method; name one"};
    const bool of_simplices = filter->id == NETMESH_FILTER_NONE;
    const bool is_more = s.source == Source::context && (s.r.bounds != nullptr || s.r.cycles != nullptr);
    if (of_simplices != (s.source == Source::simplices) && !(of_simplices && is_more))
        return {NETMESH_FIELD_FILTER, "simplices and the filter simplices go together"};
    if (s.source == Source::distances && filter->id != NETMESH_FILTER_RIPS)
        return {NETMESH_FIELD_FILTER, "distances have the filter rips alone; name it"};
    if (s.call == Call::mesh && filter->by_tau == nullptr)
        return {NETMESH_FIELD_FILTER, "this filter has no mesh of its own; call netmesh_persist"};
    return fine();
}

Complaint settle_values(const Settling& s) {
    if (!in_range(s.r.values, NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_OPEN))
        return {NETMESH_FIELD_VALUES, "unknown kind of values"};
    if (s.r.values == NETMESH_VALUES_THESIS && !s.has(filter_trait::has_values) && !s.is_promise())
        return {NETMESH_FIELD_VALUES, "this filter has one kind of values; leave it open"};
    if (s.r.values == NETMESH_VALUES_OPEN)
        s.r.values = is_given(s.goal.error) || fits_error(s.r) ? NETMESH_VALUES_THESIS : NETMESH_VALUES_CERTIFIED;
    return fine();
}

// What the filter, or without one the method, reads. Of a mesh that is there goals, rules and seed are read by nobody.
// A mesh of its own has no threshold, whatever is done with it later.
Complaint refuse_rest(const Settling& s) {
    const netmesh_filter* const filter = s.r.filter;
    // What asks for an accuracy of a diagram is of filters alone.
    std::uint32_t read = filter != nullptr ? filter->reads : s.rules.method->reads & ~(given::error | given::eps);
    if (s.call == Call::mesh) read |= given::of_diagram & ~(given::threshold | given::weighting);
    const char* text =
        filter != nullptr ? "this filter does not read it; leave it out" : "this method does not read it; leave it out";
    if (filter != nullptr && s.source == Source::context && s.call == Call::persist) {
        if (filter->on_mesh != nullptr) text = "the mesh is made already; leave it out";
        read &= given::of_diagram & ~given::seed;
    }
    Complaint complaint = refuse_unread(s.r, read, text);
    if (complaint.field == NETMESH_FIELD_THRESHOLD) complaint.text = "of the filter rips alone; leave it out";
    if (complaint.field == NETMESH_FIELD_WEIGHTING) complaint.text = "of the filter alpha alone; leave out weights";
    if (complaint.field == NETMESH_FIELD_PERIODS) complaint.text = "of the filter alpha alone; leave out periods";
    if (complaint.field == NETMESH_FIELD_SEED)
        complaint.text = "of triangulations and meshes that are made; leave it out";
    return complaint;
}

// What is 0 or 1, what is 0 until a later version gives it a meaning, and what is for a function that is not there.
Complaint settle_flags(const netmesh_request& r) {
    const netmesh_field flag = r.keep_zero_pairs > 1    ? NETMESH_FIELD_KEEP_ZERO_PAIRS
                               : r.mesh.finish > 1      ? NETMESH_FIELD_FINISH
                               : r.mesh.whole_cells > 1 ? NETMESH_FIELD_WHOLE_CELLS
                               : r.keep_mesh > 1        ? NETMESH_FIELD_KEEP_MESH
                                                        : NETMESH_FIELD_NONE;
    if (flag != NETMESH_FIELD_NONE) return {flag, "neither 0 nor 1"};
    if (r.mesh.reserved != 0) return {NETMESH_FIELD_REQUEST, "reserved is not 0"};
    if (r.mesh.sizes.user != nullptr && r.mesh.sizes.size == nullptr) return {NETMESH_FIELD_SIZES, user_alone};
    return complaint_about_monitor(r.monitor);
}

Complaint settle_want(const netmesh_want* want, Want what, netmesh_field field, const Settling& s) {
    if (want == nullptr) return fine();
    if (want->what != what) return {field, "another want stands here"};
    return want->settle != nullptr ? dispatch_settle(*want, s) : fine();
}

Complaint settle_wants(const Settling& s) {
    Complaint complaint = settle_want(s.r.bounds, Want::bounds, NETMESH_FIELD_BOUNDS, s);
    if (complaint.text == nullptr) complaint = settle_want(s.r.cycles, Want::cycles, NETMESH_FIELD_CYCLES, s);
    if (complaint.text == nullptr) complaint = settle_want(s.r.vines, Want::vines, NETMESH_FIELD_VINES, s);
    if (complaint.text == nullptr) complaint = settle_want(s.r.fit, Want::fit, NETMESH_FIELD_FIT, s);
    return complaint;
}

}  // namespace

Complaint refuse_unread(const netmesh_request& r, std::uint32_t read, const char* text) {
    std::uint32_t bit = 1;
    for (const Given& part : can_be_given) {
        if ((read & bit) == 0 && is_part_given(r, part)) return {static_cast<netmesh_field>(part.field), text};
        bit <<= 1;
    }
    return {};
}

Complaint settle_promise(std::uint32_t held_dim, netmesh_request* request) {
    const Settling s(Call::promise, held_dim, request);
    Complaint complaint = settle_flags(*request);
    if (complaint.text == nullptr) complaint = settle_source(s);
    if (complaint.text == nullptr) complaint = settle_weights(s);
    if (complaint.text == nullptr) complaint = settle_periods(s);
    if (complaint.text == nullptr) complaint = settle_promised_filter(s);
    if (complaint.text == nullptr) complaint = settle_values(s);
    if (complaint.text == nullptr && is_given(s.goal.theta)) complaint = {NETMESH_FIELD_THETA, "theta is of no mesh"};
    if (complaint.text == nullptr && s.has(filter_trait::has_eps)) complaint = settle_accuracy(s);
    return complaint.text == nullptr ? settle_rules(s) : complaint;
}

Complaint settle(Call call, std::uint32_t held_dim, netmesh_request* request) {
    const Settling s(call, held_dim, request);
    if (call == Call::mesh && s.r.fit != nullptr)
        return {NETMESH_FIELD_FIT, "fit is of diagrams; call netmesh_persist"};
    if (call == Call::mesh) s.r.bounds = s.r.cycles = s.r.vines = nullptr;  // of a diagram
    Complaint complaint = settle_flags(*request);
    if (complaint.text == nullptr) complaint = settle_source(s);
    if (complaint.text == nullptr) complaint = settle_weights(s);
    if (complaint.text == nullptr) complaint = settle_periods(s);
    if (complaint.text == nullptr) complaint = settle_filter(s);
    if (complaint.text == nullptr) complaint = settle_values(s);
    if (complaint.text == nullptr && call == Call::persist) complaint = settle_wants(s);
    if (complaint.text == nullptr) complaint = refuse_rest(s);
    if (complaint.text != nullptr) return complaint;
    return request->filter != nullptr ? dispatch_settle(*request->filter, s) : dispatch_settle(*s.rules.method, s);
}

Source source_of(const netmesh_request& r) {
    return r.points.dim != 0        ? Source::points
           : r.distances != nullptr ? Source::distances
           : r.simplices != nullptr ? Source::simplices
                                    : Source::context;
}

// ---- steps that several kinds of filters share ----

Complaint settle_neighbours(const Settling& s) {
    netmesh_request& r = s.r;
    if (r.k_last != 0 && r.vines == nullptr)
        return {NETMESH_FIELD_K_LAST, "a range of k is for vines; leave out k_last"};
    if (s.has(filter_trait::needs_k) && r.k == 0) r.k = 1;
    if (r.vines == nullptr) return fine();
    if (r.k_last == 0) r.k_last = r.k;
    return r.k_last < r.k ? Complaint{NETMESH_FIELD_K_LAST, "the last k is below the first"} : fine();
}

Complaint settle_mesh_degree(const Settling& s) {
    const std::uint32_t top = (s.dim != 0 ? s.dim : NETMESH_DIM_MAX) - (s.r.periods != nullptr ? 0 : 1);
    if (s.r.max_degree > top) s.r.max_degree = top;
    return fine();
}

Complaint settle_accuracy(const Settling& s) {
    const bool has_theta = s.has(filter_trait::has_theta);
    if (is_given(s.goal.theta) && !(s.goal.theta > 0 && s.goal.theta <= mediality_of_scales))
        return {NETMESH_FIELD_THETA, "theta is not in (0, 1/9]"};
    if (is_given(s.goal.eps) && !(s.goal.eps > 0 && s.goal.eps <= 0.5))
        return {NETMESH_FIELD_EPS, "eps is not in (0, 1/2]"};
    if (is_given(s.goal.eps) && is_given(s.goal.ratio))
        return {NETMESH_FIELD_EPS, "eps and ratio both say what is asked of the diagram; leave one of them out"};
    if (has_theta && !is_given(s.goal.theta)) s.goal.theta = mediality_of_scales;
    if (!s.is_valid_tau()) return {NETMESH_FIELD_TAU, "tau is not a finite number above 2"};
    // A point of an over-refined mesh has 10^4 vertices and more from D = 4 on.
    const double by_tau = s.ratio_of_tau() * (1 + 3 * s.goal.theta);
    const bool is_open =
        !is_given(s.goal.eps) && !is_given(s.goal.ratio) && s.r.fit == nullptr && s.rules.method == nullptr;
    if (is_open && s.is_certified() && s.dim >= 4 && !s.is_promise()) s.goal.ratio = by_tau;
    const bool certifies = s.rules.method != nullptr && s.rules.method->certifies();
    if (!is_given(s.goal.eps) && !is_given(s.goal.ratio) && !certifies) s.goal.eps = accuracy;
    return fine();
}

Complaint complaint_about_dim(std::uint32_t dim) {
    if (serves_dimension(dim)) return {};
    if (dim < NETMESH_DIM_MIN || dim > NETMESH_DIM_MAX) return {NETMESH_FIELD_DIM, "the dimension is not 2..6"};
    return {NETMESH_FIELD_DIM, "left out of this build: the dimension, by NETMESH_EACH_DIMENSION", true};
}

Complaint complaint_about_point_count(std::uint64_t count) {
    if (count == 0) return {NETMESH_FIELD_POINT_COUNT, "there are no points"};
    if (count > NETMESH_POINTS_MAX) return {NETMESH_FIELD_POINT_COUNT, "more than 2^28 points"};
    return {};
}

std::size_t alignment_of(const netmesh_points& points) {
    return points.format == NETMESH_POINTS_FLOAT32 ? alignof(float) : alignment_of_double;
}

Complaint complaint_about_rows(const netmesh_points& p) {
    const Complaint complaint = complaint_about_point_count(p.count);
    if (complaint.text != nullptr) return complaint;
    if (p.dim > SIZE_MAX / 32 / p.count) return {NETMESH_FIELD_POINT_COUNT, "more than an address space holds"};
    if (!in_range(p.format, NETMESH_POINTS_FLOAT64, NETMESH_POINTS_FLOAT32))
        return {NETMESH_FIELD_POINT_FORMAT, "unknown format of points"};
    const std::size_t row = p.dim * (p.format == NETMESH_POINTS_FLOAT32 ? sizeof(float) : sizeof(double));
    const std::size_t stride = p.stride_bytes, alignment = alignment_of(p);
    return stride != 0 && (stride < row || stride % alignment != 0 || stride > SIZE_MAX / 2 / p.count)
               ? Complaint{NETMESH_FIELD_POINT_STRIDE_BYTES, "less than a row, not aligned as points are, or too large"}
               : fine();
}

Complaint complaint_about_coordinates(const netmesh_points& points) {
    if (points.coordinates == nullptr) return {NETMESH_FIELD_POINTS, "points is null"};
    if (reinterpret_cast<std::uintptr_t>(points.weights) % alignment_of(points) != 0)
        return {NETMESH_FIELD_WEIGHTS, "weights are not aligned as their format asks"};
    if (reinterpret_cast<std::uintptr_t>(points.coordinates) % alignment_of(points) != 0)
        return {NETMESH_FIELD_POINTS, "points is not aligned as its format asks"};
    return {};
}

Complaint read_function(const netmesh_function* from, netmesh_function* function) {
    if (from == nullptr) return {NETMESH_FIELD_FUNCTION, "the function is null"};
    const netmesh_field fault = read_struct(from, function, sizeof *function);
    if (fault != NETMESH_FIELD_NONE) return complaint_about_struct(fault);
    if (function->evaluate == nullptr) return {NETMESH_FIELD_FUNCTION, "the function is null"};
    if (!is_length(function->lipschitz)) return {NETMESH_FIELD_LIPSCHITZ, "lipschitz is not finite and >= 0"};
    if (!is_length(function->distance_factor))
        return {NETMESH_FIELD_DISTANCE_FACTOR, "distance_factor is not finite and >= 0"};
    if (!is_finite(function->cut)) return {NETMESH_FIELD_CUT, "cut is not finite"};
    return {};
}

}  // namespace netmesh
