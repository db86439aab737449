#include "mesh/check/check_domain.hpp"

namespace netmesh {
namespace {

// Slack of lengths, for the rounding of places on the sphere, of inputs on the boundary of the domain and of heights of
// facets. The first is of the radius; the second of the coordinates' size, of which one unit in the last place moves a
// vertex by 2^-53: in a domain 1e-11 wide at distance 1 from the origin this is the larger one.
constexpr double slack_of_radius = 0x1p-30, slack_of_places = 0x1p-48;

class DomainCheck {
public:
    DomainCheck(const AnyStore& store, const AnyDomain& domain, const std::uint32_t* domains, const NetPromise& net)
        : dim(store.dim), store_(store), domain_(domain), domains_(domains), net_(net),
          slack_(domain.radius * slack_of_radius) {
        double most = 0;
        for (int k = 0; k < dim; ++k)
            if (absolute(domain.centre[k]) > most) most = absolute(domain.centre[k]);
        place_ = slack_of_places * (most + domain.radius);
        slack_ += place_;
    }

    CheckResult run(bool whole) {
        mark();
        CheckResult result = find_inputs(whole);
        if (result.violation == nullptr) result = has_net() ? find_net() : find_frame();
        if (result.violation == nullptr && net_.spacing > 0 && !has_net())
            result = {"there is no boundary net, although its spacing was asked for", none};
        for (std::uint32_t v = 0; v < store_.state.vertex_count;)
            for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 60); v < piece; ++v) {
                store_.vertex(v).queued = 0;
            }
        return result;
    }

private:
    static constexpr std::uint8_t in_cell = 1, on_hull = 2;

    void mark() {
        for (std::uint32_t c = 0; c < store_.state.cell_slots;)
            for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 40 * dim); c < piece; ++c) {
                for (int i = 0; i <= dim; ++i) {
                    store_.vertex(store_.cell(c).vertex[i]).queued |= in_cell;
                    for (int j = 0; j <= dim && store_.cell(c).neighbour[i] == none; ++j)
                        if (j != i) store_.vertex(store_.cell(c).vertex[j]).queued |= on_hull;
                }
            }
    }
    bool is(std::uint32_t v, std::uint8_t what) const { return (store_.vertex(v).queued & what) != 0; }
    // Exempt, and not as part of a shell.
    bool stands_free(std::uint32_t v) const {
        return is(v, in_cell) && store_.vertex(v).marker == Marker::exempt &&
               (domains_ == nullptr || domains_[v] == none);
    }
    bool is_on_sphere(std::uint32_t v) const {
        return absolute(square_root(domain_.distance2(store_.point(v))) - domain_.radius) <= slack_;
    }
    bool has_net() const {
        for (std::uint32_t v = 0; v < store_.state.vertex_count;)
            for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 60); v < piece; ++v) {
                if (is(v, on_hull) && !is_on_sphere(v)) return false;
            }
        return true;
    }
    CheckResult find_inputs(bool whole);
    CheckResult find_net();
    CheckResult find_frame() const;
    double* normal_of(std::uint32_t c, int i, double* inner, double* centre) const;
    bool reaches_beyond(std::uint32_t c, int i) const;
    bool leaves_hole(std::uint32_t c, int i) const;

    const int dim;
    const AnyStore& store_;
    const AnyDomain& domain_;
    const std::uint32_t* const domains_;
    const NetPromise& net_;
    double delta_ = 0;  // spacing of the net
    double place_;      // slack of a vertex's place
    double net_slack_;  // of the net: a facet's direction is known to its vertices' slack over delta
    double slack_;      // of lengths
    double far2_ = 0;   // of the input farthest from the domain's centre
};

[[gnu::cold]] CheckResult DomainCheck::find_inputs(bool whole) {
    const double most = domain_.radius + slack_;
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 60); v < piece; ++v) {
            if (whole && !is(v, in_cell)) return {"a vertex belongs to no cell", v};
            const Marker marker = store_.vertex(v).marker;
            if (is(v, on_hull) && marker != Marker::exempt) return {"a vertex of the mesh's hull is not exempt", v};
            const double d2 = domain_.distance2(store_.point(v));
            if (marker != Marker::input) continue;
            if (d2 > most * most) return {"an input is not in the domain", v};
            if (d2 > far2_) far2_ = d2;
        }
    return {nullptr, none};
}

[[gnu::cold]] CheckResult DomainCheck::find_net() {
    const double rho = square_root(far2_);
    delta_ = 2 * rho * (net_.spacing > 0 ? net_.spacing : 1);
    const double k = 2 * net_.tau / (net_.tau - 2), least = delta_ * (k * square_root(2) + 1) + rho;
    if (domain_.radius + slack_ < (least > 3 * rho ? least : 3 * rho))
        return {"the domain is too small for its boundary net and tau", none};
    net_slack_ = slack_ + (delta_ > 0 ? place_ * domain_.radius / delta_ : 0);
    const double apart = delta_ > net_slack_ ? delta_ - net_slack_ : 0;
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 60); v < piece; ++v) {
            if (!stands_free(v)) continue;
            if (!is_on_sphere(v))
                return {"an exempt vertex is not on the domain's sphere, where the boundary net is", v};
            for (std::uint32_t w = 0; w < v;)
                for (const std::uint64_t piece = store_.arena.piece(w, v, 40); w < piece; ++w) {
                    if (stands_free(w) && distance2(dim, store_.point(v), store_.point(w)) < apart * apart)
                        return {"two vertices of the boundary net are too near", v};
                }
        }
    for (std::uint32_t c = 0; c < store_.state.cell_slots;)
        for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 40 * dim); c < piece; ++c) {
            for (int i = 0; i <= dim; ++i)
                if (store_.cell(c).neighbour[i] == none && leaves_hole(c, i)) return {"the boundary net has a hole", c};
        }
    return {nullptr, none};
}

[[gnu::cold]] CheckResult DomainCheck::find_frame() const {
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 60); v < piece; ++v) {
            if (stands_free(v) && !is(v, on_hull))
                return {"a vertex is exempt and neither on the hull nor in the boundary net nor in a shell", v};
        }
    for (std::uint32_t c = 0; c < store_.state.cell_slots;)
        for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 40 * dim); c < piece; ++c) {
            for (int i = 0; i <= dim; ++i)
                if (store_.cell(c).neighbour[i] == none && reaches_beyond(c, i))
                    return {"the domain reaches beyond the hull", c};
        }
    return {nullptr, none};
}

// What the directions of facet i of cell c leave of the ways from it to vertex i and to the domain's centre. Returns
// inner; null when the facet has no normal.
[[gnu::cold]] double* DomainCheck::normal_of(std::uint32_t c, int i, double* inner, double* centre) const {
    store_.arena.pass(2 * dim);
    const AnyCell cell = store_.cell(c);
    const double* const p = store_.point(cell.vertex[i == 0 ? 1 : 0]);
    double along[dimension_max][dimension_max];  // orthonormal directions of the facet
    int size = 0;
    const auto leave = [&](double* e) {
        for (int j = 0; j < size; ++j) {
            const double common = dot(dim, e, along[j]);
            for (int k = 0; k < dim; ++k) e[k] -= common * along[j][k];
        }
    };
    for (int j = 0; j <= dim; ++j) {
        if (j == i || store_.point(cell.vertex[j]) == p) continue;
        double* const e = along[size];
        for (int k = 0; k < dim; ++k) e[k] = store_.point(cell.vertex[j])[k] - p[k];
        leave(e);
        const double length = square_root(dot(dim, e, e));
        if (!(length > 0)) return nullptr;
        for (int k = 0; k < dim; ++k) e[k] /= length;
        ++size;
    }
    for (int k = 0; k < dim; ++k) {
        inner[k] = store_.point(cell.vertex[i])[k] - p[k];
        centre[k] = domain_.centre[k] - p[k];
    }
    leave(inner);
    leave(centre);
    return inner;
}

// Is the domain's centre not as far from facet i of cell c, to the side of vertex i, as the domain's radius?
[[gnu::cold]] bool DomainCheck::reaches_beyond(std::uint32_t c, int i) const {
    double inner[dimension_max], centre[dimension_max];
    if (normal_of(c, i, inner, centre) == nullptr) return true;
    const double height = square_root(dot(dim, centre, centre));
    return !(dot(dim, inner, centre) > 0) || height < domain_.radius - slack_;
}

// Is the point of the sphere above facet i of cell c, which is as far from all of its vertices, farther from them than
// delta?
[[gnu::cold]] bool DomainCheck::leaves_hole(std::uint32_t c, int i) const {
    double inner[dimension_max], centre[dimension_max], top[dimension_max];
    if (normal_of(c, i, inner, centre) == nullptr) return true;
    const double length = square_root(dot(dim, inner, inner));
    for (int k = 0; k < dim; ++k) top[k] = domain_.centre[k] - domain_.radius / length * inner[k];
    const double* const p = store_.point(store_.cell(c).vertex[i == 0 ? 1 : 0]);
    return far2_ > 0 && !(square_root(distance2(dim, top, p)) <= delta_ + net_slack_);
}

}  // namespace

CheckResult check_domain(const AnyStore& store, const AnyDomain& domain, const std::uint32_t* domains, bool whole,
                         const NetPromise& net) {
    return DomainCheck(store, domain, domains, net).run(whole);
}

}  // namespace netmesh
