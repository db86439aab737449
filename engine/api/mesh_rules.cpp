#include "api/mesh_rules.hpp"

#include "filtration/tight_filter.hpp"
#include "mesh/cages/cage_template.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

bool has_cages(const netmesh_mesh_request& request) { return request.method == NETMESH_METHOD_HIERARCHY; }

Complaint complaint_about_audit(const netmesh_mesh_request& request) {
    if (request.audit == 0) return {};
    if (request.audit > (NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY)) return {NETMESH_FIELD_AUDIT, "unknown audit"};
    if (request.method == NETMESH_METHOD_REFINE) return {NETMESH_FIELD_AUDIT, "audits are not for the method refine"};
    const bool locates = (request.audit & NETMESH_AUDIT_LOCATION) != 0;
    if (locates && (request.purpose != NETMESH_PURPOSE_MESH || sizes_of(request).asks()))
        return {NETMESH_FIELD_AUDIT,
                "an audit of location is for meshes that are not over-refined nor for persistence"};
    return {};
}

Complaint complaint_about_ratios(const netmesh_certificate_goal& goal) {
    const bool focused = goal.focus_ratio != 0 || goal.focus_from != 0 || goal.focus_to != 0;
    if (goal.ratio == 0) return {NETMESH_FIELD_RATIO, focused ? "a focus without a ratio" : nullptr};
    if (!is_valid_ratio(goal.ratio)) return {NETMESH_FIELD_RATIO, "ratio is not a finite number above the root of 2"};
    if (!focused) return {};
    if (!(goal.focus_ratio > 1 && goal.focus_ratio < goal.ratio))
        return {NETMESH_FIELD_FOCUS_RATIO, "focus_ratio is not between 1 and ratio"};
    return complaint_about_focus(goal.focus_from, goal.focus_to);
}

Complaint complaint_about_cages(const netmesh_mesh_request& request) {
    if (request.cage_kind != NETMESH_CAGES_THESIS) return {};
    if (request.method != NETMESH_METHOD_HIERARCHY)
        return {NETMESH_FIELD_CAGE_KIND, "only the method with cages has cages of the thesis"};
    if (!(request.tau >= thesis_tau_min)) return {NETMESH_FIELD_TAU, "cages of the thesis need a tau of at least 3.4"};
    if (request.purpose != NETMESH_PURPOSE_MESH)
        return {NETMESH_FIELD_PURPOSE, "a mesh with cages of the thesis is not for persistence"};
    if (sizes_of(request).asks())
        return {NETMESH_FIELD_SIZES, "a mesh with cages of the thesis is not over-refined, nor when it is finished"};
    if ((request.audit & NETMESH_AUDIT_LOCATION) != 0)
        return {NETMESH_FIELD_AUDIT, "an audit of location does not go with cages of the thesis"};
    return {};
}

}  // namespace

Complaint complaint_about_numbers(const netmesh_mesh_request& request) {
    if (!in_range(request.purpose, NETMESH_PURPOSE_MESH, NETMESH_PURPOSE_TIGHT))
        return {NETMESH_FIELD_PURPOSE, "the purpose is neither a mesh nor persistence"};
    if (!in_range(request.method, NETMESH_METHOD_SVR, NETMESH_METHOD_REFINE))
        return {NETMESH_FIELD_METHOD, "unknown method"};
    if (!in_range(request.cage_kind, NETMESH_CAGES_COMPACT, NETMESH_CAGES_THESIS))
        return {NETMESH_FIELD_CAGE_KIND, "unknown kind of cages"};
    if (request.cage_kind == NETMESH_CAGES_THESIS && request.dim > thesis_dim_max)
        return {NETMESH_FIELD_CAGE_KIND, "there are cages of the thesis up to D = 4"};
    if (!is_valid_tau(tau_of(request.dim, request.tau)))
        return {NETMESH_FIELD_TAU, "tau is not a finite number above 2"};
    if (!(request.sizes.eps >= 0) || !is_finite(request.sizes.eps))
        return {NETMESH_FIELD_SIZES, "sizes.eps is neither 0 nor a finite number above"};
    if (!(request.size_at_inputs >= 0) || !is_finite(request.size_at_inputs))
        return {NETMESH_FIELD_SIZE_AT_INPUTS, "size_at_inputs is neither 0 nor a finite number above"};
    if (!(request.size_growth >= 0) || !is_finite(request.size_growth))
        return {NETMESH_FIELD_SIZE_GROWTH, "size_growth is neither 0 nor a finite number above"};
    if (request.size_growth > 0 && request.size_at_inputs == 0)
        return {NETMESH_FIELD_SIZE_GROWTH, "size_growth without size_at_inputs asks for cells of no size at inputs"};
    if (request.domain_factor != 0 && !(request.domain_factor >= 1 && request.domain_factor <= 8))
        return {NETMESH_FIELD_DOMAIN_FACTOR, "domain_factor is not between 1 and 8"};
    if (request.net_spacing != 0 && !(request.net_spacing >= 1.0 / 64 && request.net_spacing <= 8))
        return {NETMESH_FIELD_NET_SPACING, "net_spacing is not between 1/64 and 8"};
    if (request.purpose == NETMESH_PURPOSE_TIGHT && !is_valid_eps(eps_of(request.tight_eps)))
        return {NETMESH_FIELD_TIGHT_EPS, "tight_eps is not in (0, 1/2]"};
    return {};
}

Complaint complaint_about_method(const netmesh_mesh_request& request) {
    if (has_cages(request) && request.purpose != NETMESH_PURPOSE_MESH && request.finish == 0)
        return {NETMESH_FIELD_PURPOSE, "a mesh with cages is not for persistence; finish it"};
    if (has_cages(request) && sizes_of(request).asks() && request.finish == 0)
        return {NETMESH_FIELD_SIZES, "a mesh with cages is not over-refined; finish it"};
    if (request.net_spacing != 0 && request.method != NETMESH_METHOD_REFINE)
        return {NETMESH_FIELD_NET_SPACING, "only the method refine has a boundary net"};
    const Complaint complaint = complaint_about_cages(request);
    return complaint.text != nullptr ? complaint : complaint_about_audit(request);
}

Complaint complaint_about_goal(const netmesh_mesh_request& request) {
    const Complaint complaint = complaint_about_ratios(request.certificate);
    if (complaint.text != nullptr || request.certificate.ratio == 0) return complaint;
    if (request.purpose != NETMESH_PURPOSE_PERSIST)
        return {NETMESH_FIELD_PURPOSE, "refinement by the certificate is for persistence with the complete filter"};
    if (request.method != NETMESH_METHOD_SVR)
        return {NETMESH_FIELD_METHOD, "refinement by the certificate is a method of its own"};
    if (sizes_of(request).asks()) return {NETMESH_FIELD_SIZES, "refinement by the certificate does not over-refine"};
    return {};
}

Complaint complaint_about_built_mesh(const netmesh_mesh_request& request) {
    if (!built::cages && has_cages(request))
        return {NETMESH_FIELD_METHOD, "left out of this build: NETMESH_WITH_CAGES", true};
    if (!built::thesis_cages && request.cage_kind == NETMESH_CAGES_THESIS)
        return {NETMESH_FIELD_CAGE_KIND, "left out of this build: NETMESH_WITH_THESIS_CAGES", true};
    if (!built::refine && request.method == NETMESH_METHOD_REFINE)
        return {NETMESH_FIELD_METHOD, "left out of this build: NETMESH_WITH_REFINE", true};
    if (!built::certificate && request.certificate.ratio > 0)
        return {NETMESH_FIELD_RATIO, "left out of this build: NETMESH_WITH_CERTIFICATE", true};
    if (!built::audits && request.audit != 0)
        return {NETMESH_FIELD_AUDIT, "left out of this build: NETMESH_WITH_AUDITS", true};
    if (!built::sizes && sizes_of(request).asks())
        return {NETMESH_FIELD_SIZES, "left out of this build: NETMESH_WITH_SIZES", true};
    return {};
}

Complaint complaint_about_promises(const netmesh_mesh_request& request) {
    Complaint complaint = complaint_about_numbers(request);
    if (complaint.text == nullptr) complaint = complaint_about_ratios(request.certificate);
    return complaint.text != nullptr ? complaint : complaint_about_built_mesh(request);
}

SizeRule sizes_of(const netmesh_mesh_request& request) {
    SizeRule sizes = size_rule_of(request);
    if (request.purpose != NETMESH_PURPOSE_TIGHT) return sizes;
    const double tight = tight_size(eps_of(request.tight_eps));
    if (!(sizes.eps > 0 && sizes.eps < tight)) sizes.eps = tight;
    return sizes;
}

MeshRequest mesh_request_of(const netmesh_mesh_request& request) {
    MeshRequest asked;
    asked.method = request.certificate.ratio > 0                ? MeshMethod::certificate
                   : request.method == NETMESH_METHOD_HIERARCHY ? MeshMethod::hierarchy
                   : request.method == NETMESH_METHOD_REFINE    ? MeshMethod::reference
                                                                : MeshMethod::quality;
    asked.tau = tau_of(request.dim, request.tau);
    asked.domain_factor = request.domain_factor != 0 ? request.domain_factor : 1;
    if (request.net_spacing != 0) asked.net_spacing = request.net_spacing;
    if (request.purpose == NETMESH_PURPOSE_TIGHT) {
        const double least = tight_domain_factor(eps_of(request.tight_eps));
        if (asked.domain_factor < least) asked.domain_factor = least;
    }
    asked.certify_filter = request.purpose == NETMESH_PURPOSE_PERSIST;
    asked.size = sizes_of(request);
    asked.goal = goal_of(request);
    asked.finish = request.finish != 0;
    asked.cages = request.cage_kind == NETMESH_CAGES_THESIS ? CageKind::thesis : CageKind::compact;
    asked.audit_location = (request.audit & NETMESH_AUDIT_LOCATION) != 0;
    asked.audit_quality = (request.audit & NETMESH_AUDIT_QUALITY) != 0;
    asked.seed = request.seed;
    return asked;
}

}  // namespace netmesh
