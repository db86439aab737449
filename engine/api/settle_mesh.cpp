// What a request asks of the mesh that is made for it.
#include "api/settling.hpp"
#include "filtration/function_filter.hpp"
#include "filtration/tight_filter.hpp"
#include "mesh/cages/cage_template.hpp"
#include "vocabulary/callback.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

constexpr double thesis_tau = 7;

// Each number by itself.
Complaint settle_numbers(const Settling& s) {
    if (!s.is_valid_tau()) return {NETMESH_FIELD_TAU, "tau is not a finite number above 2"};
    const netmesh_sizes& sizes = s.rules.sizes;
    const char* const no_size = "neither 0 nor a finite number above";
    if (!is_length(sizes.eps)) return {NETMESH_FIELD_SIZE_EPS, no_size};
    if (!is_length(sizes.at_inputs)) return {NETMESH_FIELD_SIZE_AT_INPUTS, no_size};
    if (!is_length(sizes.growth)) return {NETMESH_FIELD_SIZE_GROWTH, no_size};
    if (sizes.growth > 0 && sizes.at_inputs == 0)
        return {NETMESH_FIELD_SIZE_GROWTH, "growth without at_inputs asks for cells of no size at inputs"};
    const double factor = s.rules.domain_factor, spacing = s.rules.net_spacing, error = s.goal.error;
    if (is_given(factor) && !(factor >= 1 && factor <= 8))
        return {NETMESH_FIELD_DOMAIN_FACTOR, "domain_factor is not between 1 and 8"};
    if (is_given(spacing) && !(spacing >= 1.0 / 64 && spacing <= 8))
        return {NETMESH_FIELD_NET_SPACING, "net_spacing is not between 1/64 and 8"};
    if (is_given(error) && !(error > 0 && is_finite(error)))
        return {NETMESH_FIELD_ERROR, "error is not a finite number above 0"};
    return fine();
}

// Which method makes the mesh; of a promise it may be none.
void settle_method(const Settling& s) {
    if (s.rules.method != nullptr || s.row == nullptr || s.r.filter->on_mesh == nullptr) return;
    const bool by_goal = s.has(filter_trait::has_goal) || (s.has(filter_trait::has_eps) && is_given(s.goal.ratio));
    const bool by_ratio = by_goal && s.is_certified() && s.rules.finish == 0 && s.r.filter->by_ratio != nullptr;
    s.rules.method = by_ratio ? s.r.filter->by_ratio : s.r.filter->by_tau;
}

Complaint settle_window(const Settling& s) {
    const char* const text = "not 0 < focus_from < focus_to";
    if (!(s.goal.focus_from > 0) || !is_finite(s.goal.focus_from)) return {NETMESH_FIELD_FOCUS_FROM, text};
    return s.goal.focus_from < s.goal.focus_to ? fine() : Complaint{NETMESH_FIELD_FOCUS_TO, text};
}

// Refined by the certificate: for a ratio, and scales of interest.
Complaint settle_certificate(const Settling& s) {
    const bool fits = s.r.fit != nullptr && s.call == Call::persist;
    if (!fits) {
        if (is_given(s.goal.ratio) && is_given(s.rules.tau) && s.goal.ratio != s.ratio_of_tau() && !s.is_promise())
            return {NETMESH_FIELD_TAU, "ratio says what the mesh is made for; leave out tau"};
        if (!is_given(s.goal.ratio)) s.goal.ratio = s.ratio_of_tau();
        if (!is_given(s.rules.tau) && s.goal.ratio == s.ratio_of_tau()) s.rules.tau = tau_of(s.dim, 0);
    }
    if (!is_valid_ratio(s.goal.ratio)) return {NETMESH_FIELD_RATIO, "ratio is not a finite number from 1.4143 on"};
    if (s.row != nullptr && !s.has(filter_trait::clips_cells)) s.rules.whole_cells = 1;
    const bool focused = is_given(s.goal.focus_ratio) || is_given(s.goal.focus_from) || is_given(s.goal.focus_to);
    if (!focused) return fine();
    if (!fits && !(s.goal.focus_ratio > 1 && s.goal.focus_ratio < s.goal.ratio))
        return {NETMESH_FIELD_FOCUS_RATIO, "focus_ratio is not between 1 and ratio"};
    return settle_window(s);
}

Complaint settle_cages(const Settling& s, const netmesh_method& by) {
    if (by.cages == CageKind::thesis) {
        if (s.dim > thesis_dim_max) return {NETMESH_FIELD_METHOD, "there are cages of the thesis up to D = 4"};
        if (!(s.rules.tau >= thesis_tau_min) && !s.is_promise())
            return {NETMESH_FIELD_TAU, "cages of the thesis need a tau of at least 3.4"};
        if (s.row != nullptr && !s.is_promise())
            return {NETMESH_FIELD_METHOD, "a mesh with cages of the thesis has no filter"};
    }
    if (s.rules.finish != 0 || s.is_promise()) return fine();
    if (s.row != nullptr) return {NETMESH_FIELD_FINISH, "the method leaves cages, which have no filter; set finish"};
    return s.is_sized() ? Complaint{NETMESH_FIELD_SIZES, "a mesh with cages is not over-refined; set finish"} : fine();
}

Complaint settle_audit(const Settling& s, const netmesh_method& by) {
    if (s.rules.audit > (NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY)) return {NETMESH_FIELD_AUDIT, "unknown audit"};
    const bool locates = (s.rules.audit & NETMESH_AUDIT_LOCATION) != 0;
    return locates && (s.row != nullptr || s.is_sized() || by.certifies() || by.cages == CageKind::thesis)
               ? Complaint{NETMESH_FIELD_AUDIT, "an audit of location is for meshes of svr and netmesh that are not "
                                                "over-refined and have no filter"}
               : fine();
}

Complaint no_certificate() { return {NETMESH_FIELD_RATIO, "left out of this build: NETMESH_WITH_CERTIFICATE", true}; }

Complaint settle_built(const Settling& s) {
    if (!built::certificate && s.certifies()) return no_certificate();
    if (!built::audits && s.rules.audit != 0)
        return {NETMESH_FIELD_AUDIT, "left out of this build: NETMESH_WITH_AUDITS", true};
    if (!built::sizes && (s.is_sized() || fits_error(s.r)))
        return {NETMESH_FIELD_SIZES, "left out of this build: NETMESH_WITH_SIZES", true};
    return fine();
}

}  // namespace

Complaint settle_rules(const Settling& s) {
    Complaint complaint = settle_numbers(s);
    if (complaint.text != nullptr) return complaint;
    const bool asks_ratio = s.rules.method == nullptr && is_given(s.goal.ratio) &&
                            (s.has(filter_trait::has_goal) || s.has(filter_trait::has_eps));
    if (!built::certificate && asks_ratio) return no_certificate();
    settle_method(s);
    const netmesh_method* const by = s.rules.method;
    if (by != nullptr) {
        if (by->triangulates() && s.row != nullptr)
            return {NETMESH_FIELD_METHOD, "this filter needs a mesh; name a method that makes one"};
        complaint = refuse_unread(
            s.r, by->reads | given::of_diagram | (s.r.fit != nullptr ? given::focus | given::longer_than : 0),
            "the method of the mesh does not read it; leave it out");
        if (complaint.text != nullptr) return complaint;
    }
    if (s.certifies()) {
        if (s.row != nullptr && !s.is_promise() && s.r.fit == nullptr && !s.is_certified())
            return {NETMESH_FIELD_METHOD, "refinement by the certificate is for certified values"};
        complaint = settle_certificate(s);
    } else if (s.r.fit == nullptr && !is_given(s.rules.tau)) {
        s.rules.tau = by != nullptr && by->cages == CageKind::thesis ? thesis_tau : tau_of(s.dim, 0);
    }
    if (complaint.text == nullptr && is_given(s.goal.error) && s.r.values != NETMESH_VALUES_THESIS && !s.is_promise())
        complaint = {NETMESH_FIELD_VALUES, "error is for the function's own values; leave values open"};
    if (complaint.text == nullptr && by != nullptr && by->has_cages()) complaint = settle_cages(s, *by);
    if (complaint.text == nullptr && by != nullptr) complaint = settle_audit(s, *by);
    return complaint.text == nullptr ? settle_built(s) : complaint;
}

Complaint settle_on_mesh(const Settling& s) {
    Complaint complaint = settle_mesh_degree(s);
    const bool persists = s.call == Call::persist;
    if (persists && s.has(filter_trait::needs_k)) complaint = settle_neighbours(s);
    // What is wanted of a diagram that is there needs none: bounds go by its error then.
    const bool is_kept = s.source == Source::context && (s.r.bounds != nullptr || s.r.cycles != nullptr);
    const bool reads_function =
        s.has(filter_trait::needs_function) && ((persists && !is_kept) || is_given(s.goal.error));
    if (complaint.text == nullptr && reads_function && s.r.function == nullptr)
        complaint = {NETMESH_FIELD_FUNCTION, "the function is null"};
    if (complaint.text != nullptr || s.source != Source::points) return complaint;
    if (s.has(filter_trait::has_eps)) complaint = settle_accuracy(s);
    return complaint.text == nullptr ? settle_rules(s) : complaint;
}

double tau_of(std::uint32_t dim, double tau) {
    if (tau != 0) return tau;
    return serves_dimension(dim) ? with_dimension(dim, [](auto d) { return figures<decltype(d)::value>.tau_default; })
                                 : 4;
}

double ErrorSizes::at(void* self, const double* x) {
    const ErrorSizes& sizes = *static_cast<const ErrorSizes*>(self);
    const double by_error = wanted_reach(sizes.function, sizes.error, value_at(sizes.function, x));
    const double by_caller = sizes.caller.by_caller(x);  // what is no size is passed on
    return by_caller >= by_error ? by_error : by_caller;
}

MeshRequest mesh_request_of(const netmesh_request& r, std::uint32_t dim, ErrorSizes* sizes) {
    const netmesh_mesh_rules& m = r.mesh;
    const bool is_tight = r.filter != nullptr && r.filter->id == NETMESH_FILTER_TIGHT && r.goal.eps > 0;
    MeshRequest asked;
    const bool certifies = m.method != nullptr ? m.method->certifies() : r.goal.ratio > 0;
    asked.method = certifies ? MeshMethod::certificate : m.method != nullptr ? m.method->method : MeshMethod::quality;
    if (m.method != nullptr) asked.cages = m.method->cages;
    asked.tau = tau_of(dim, m.tau);
    if (m.domain_factor != 0) asked.domain_factor = m.domain_factor;
    if (m.net_spacing != 0) asked.net_spacing = m.net_spacing;
    asked.size = {m.sizes.eps, m.sizes.size, m.sizes.user, m.sizes.at_inputs, m.sizes.growth};
    if (r.goal.error > 0 && read_function(r.function, &sizes->function).text == nullptr) {
        sizes->error = r.goal.error;
        sizes->caller = asked.size;
        asked.size.function = ErrorSizes::at;
        asked.size.user = sizes;
    }
    if (is_tight) {
        const double size = tight_size(r.goal.eps), least = tight_domain_factor(r.goal.eps);
        if (!(asked.size.eps > 0 && asked.size.eps < size)) asked.size.eps = size;
        if (asked.domain_factor < least) asked.domain_factor = least;
    }
    asked.certify_filter = certifies || (r.filter != nullptr && r.filter->on_mesh != nullptr && !is_tight);
    if (certifies)
        asked.goal = {r.goal.ratio, r.goal.focus_ratio, r.goal.focus_from, r.goal.focus_to, m.whole_cells == 0};
    asked.finish = m.finish != 0;
    asked.audit_location = (m.audit & NETMESH_AUDIT_LOCATION) != 0;
    asked.audit_quality = (m.audit & NETMESH_AUDIT_QUALITY) != 0;
    asked.seed = r.seed;
    return asked;
}

}  // namespace netmesh
