// What quality_audit.hpp finds from what a step has changed, by looking at the whole mesh: all vertices, all pairs of
// members of a domain.
#pragma once
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "common/hierarchical.hpp"
#include "mesh/audit/quality_audit.hpp"

template <int D> class WholeMesh {
    using u32 = std::uint32_t;

public:
    // cages: those that are not released are looked at.
    WholeMesh(netmesh::Store<D>& store, const std::vector<netmesh::Cage>& cages, u32 inputs,
              const netmesh::Domain<D>& outermost)
        : store_(store), cages_(cages), inputs_(inputs), outermost_(outermost), ratios_(store.state.vertex_count),
          domains_(store.state.vertex_count), neighbours_(store.state.vertex_count) {
        cages_.erase(
            std::remove_if(cages_.begin(), cages_.end(), [](const auto& c) { return c.shell == netmesh::none; }),
            cages_.end());
        REQUIRE(netmesh::measure_hierarchy(
                    store, {cages_.data(), static_cast<u32>(cages_.size()), outermost, ratios_.data(), domains_.data()},
                    store.arena, &quality_) == netmesh::Status::ok);
        REQUIRE(quality_.is_hierarchy);
        for (u32 c = 0; c < store.state.cell_slots; ++c) {
            if (!store.is_live(c) || store.is_ghost(c)) continue;
            for (const u32 v : store.cell(c).vertex)
                for (const u32 w : store.cell(c).vertex)
                    if (v != w) neighbours_[v].push_back(w);
        }
        for (std::vector<u32>& list : neighbours_) {
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
        }
    }

    // K with the distances to the nearest vertex of M_Omega, be it a neighbour or not.
    double exact_feature(const netmesh::AuditTerms& terms) {
        terms_ = terms;
        return feature(true, netmesh::AuditStep{netmesh::none, netmesh::none, false}, nullptr);
    }

    void add_to(const netmesh::AuditStep& step, const netmesh::AuditTerms& terms, netmesh::QualityAudit* audit) {
        terms_ = terms;
        ++audit->meshes;
        audit->encroached += quality_.encroached.violation != nullptr;
        for (u32 v = 0; v < store_.state.vertex_count; ++v) {
            if (is_frame(v) || store_.vertex(v).cell == netmesh::none) continue;
            audit->degree_max = std::max(audit->degree_max, static_cast<u32>(neighbours_[v].size()));
            if (v < inputs_ || terms_.steiner_ratios) audit->worst = std::max(audit->worst, ratios_[v]);
        }
        audit->worst = std::max(audit->worst, terms_.steiner_ratios ? quality_.worst : worst_of_cages());
        if (terms_.features) audit->feature = std::max(audit->feature, feature(false, step, audit));
    }

private:
    bool is_frame(u32 v) const { return v >= inputs_ && v < inputs_ + 2 * D; }
    double distance2(u32 v, u32 w) const { return netmesh::distance2<D>(store_.point(v), store_.point(w)); }
    // Of inputs and cages, measured while all others are exempt.
    double worst_of_cages() {
        std::vector<netmesh::Marker> markers;
        for (u32 v = 0; v < store_.state.vertex_count; ++v) {
            markers.push_back(store_.vertex(v).marker);
            if (markers[v] == netmesh::Marker::steiner) store_.vertex(v).marker = netmesh::Marker::exempt;
        }
        netmesh::HierarchyQuality quality;
        std::vector<double> ratios(store_.state.vertex_count);
        std::vector<u32> domains(store_.state.vertex_count);
        REQUIRE(netmesh::measure_hierarchy(
                    store_, {cages_.data(), static_cast<u32>(cages_.size()), outermost_, ratios.data(), domains.data()},
                    store_.arena, &quality) == netmesh::Status::ok);
        for (u32 v = 0; v < store_.state.vertex_count; ++v) store_.vertex(v).marker = markers[v];
        return quality.worst;
    }
    // What stands for v in a domain.
    u32 member(u32 v, u32 domain) const {
        if (is_frame(v)) return netmesh::none;
        u32 d = domains_[v], within = netmesh::none;
        for (; d != domain && d != netmesh::none; d = cages_[d].parent) within = d;
        if (d != domain) return netmesh::none;
        return within == netmesh::none ? v : cages_[within].centre;
    }
    double feature(bool exact, const netmesh::AuditStep& step, netmesh::QualityAudit* audit) const {
        double worst = 0;
        for (u32 v = 0; v < store_.state.vertex_count; ++v) {
            if (is_frame(v) || store_.vertex(v).cell == netmesh::none) continue;
            const double ratio = feature_at(v, domains_[v], neighbours_[v], exact);
            worst = std::max(worst, ratio);
            if (audit == nullptr) continue;
            double& kind = v == step.vertex ? (step.cleaning ? audit->steiner : audit->input) : audit->cage;
            if (v == step.vertex || v >= step.first_made) kind = std::max(kind, ratio);
        }
        for (const netmesh::Cage& cage : cages_) {
            std::vector<u32> around;
            for (u32 v = 0; v < store_.state.vertex_count; ++v)
                if (store_.vertex(v).cell != netmesh::none && netmesh::is_inside<D>(store_, cage, store_.point(v)))
                    around.insert(around.end(), neighbours_[v].begin(), neighbours_[v].end());
            worst = std::max(worst, feature_at(cage.centre, cage.parent, around, exact));
        }
        return worst;
    }
    double feature_at(u32 v, u32 domain, const std::vector<u32>& neighbours, bool exact) const {
        double mesh2 = netmesh::infinity;
        const auto offer = [&](u32 w) {
            const u32 m = member(w, domain);
            if (m != netmesh::none && m != v) mesh2 = std::min(mesh2, distance2(v, m));
        };
        if (!exact)
            for (const u32 w : neighbours) offer(w);
        for (u32 w = 0; exact && w < store_.state.vertex_count; ++w)
            if (store_.vertex(w).cell != netmesh::none) offer(w);
        std::set<u32> members;
        for (u32 p = 0; p < inputs_; ++p)
            if (!terms_.inserted_inputs || store_.vertex(p).cell != netmesh::none) {
                const u32 m = member(p, domain);
                if (m != netmesh::none) members.insert(m);
            }
        std::vector<double> distances;
        for (const u32 p : members) distances.push_back(distance2(v, p));
        if (distances.size() < 2 || !(mesh2 < netmesh::infinity)) return 0;
        std::nth_element(distances.begin(), distances.begin() + 1, distances.end());
        return netmesh::square_root(distances[1] / mesh2);
    }

    netmesh::Store<D>& store_;
    std::vector<netmesh::Cage> cages_;
    const u32 inputs_;
    const netmesh::Domain<D> outermost_;
    netmesh::AuditTerms terms_ = {};
    std::vector<double> ratios_;
    std::vector<u32> domains_;
    std::vector<std::vector<u32>> neighbours_;
    netmesh::HierarchyQuality quality_;
};
