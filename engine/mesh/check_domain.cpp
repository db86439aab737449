#include "mesh/check_domain.hpp"

#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Slack of lengths, for the rounding of places on the sphere, of inputs on the boundary of the domain and of heights of
// facets. The first is of the radius; the second of the coordinates' size, of which one unit in the last place moves a
// vertex by 2^-53: in a domain 1e-11 wide at distance 1 from the origin this is the larger one.
constexpr double slack_of_radius = 0x1p-30, slack_of_places = 0x1p-48;

template <int D> class DomainCheck {
public:
    DomainCheck(const Store<D>& store, const Domain<D>& domain, const std::uint32_t* domains, const NetPromise& net)
        : store_(store), domain_(domain), domains_(domains), net_(net), slack_(domain.radius * slack_of_radius) {
        double most = 0;
        for (int k = 0; k < D; ++k)
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
            for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 40 * D); c < piece; ++c) {
                for (int i = 0; i <= D; ++i) {
                    store_.vertex(store_.cell(c).vertex[i]).queued |= in_cell;
                    for (int j = 0; j <= D && store_.cell(c).neighbour[i] == none; ++j)
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

    const Store<D>& store_;
    const Domain<D>& domain_;
    const std::uint32_t* const domains_;
    const NetPromise& net_;
    double delta_ = 0;  // spacing of the net
    double place_;      // slack of a vertex's place
    double net_slack_;  // of the net: a facet's direction is known to its vertices' slack over delta
    double slack_;      // of lengths
    double far2_ = 0;   // of the input farthest from the domain's centre
};

template <int D> [[gnu::cold]] CheckResult DomainCheck<D>::find_inputs(bool whole) {
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

template <int D> [[gnu::cold]] CheckResult DomainCheck<D>::find_net() {
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
                    if (stands_free(w) && distance2<D>(store_.point(v), store_.point(w)) < apart * apart)
                        return {"two vertices of the boundary net are too near", v};
                }
        }
    for (std::uint32_t c = 0; c < store_.state.cell_slots;)
        for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 40 * D); c < piece; ++c) {
            for (int i = 0; i <= D; ++i)
                if (store_.cell(c).neighbour[i] == none && leaves_hole(c, i)) return {"the boundary net has a hole", c};
        }
    return {nullptr, none};
}

template <int D> [[gnu::cold]] CheckResult DomainCheck<D>::find_frame() const {
    for (std::uint32_t v = 0; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 60); v < piece; ++v) {
            if (stands_free(v) && !is(v, on_hull))
                return {"a vertex is exempt and neither on the hull nor in the boundary net nor in a shell", v};
        }
    for (std::uint32_t c = 0; c < store_.state.cell_slots;)
        for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 40 * D); c < piece; ++c) {
            for (int i = 0; i <= D; ++i)
                if (store_.cell(c).neighbour[i] == none && reaches_beyond(c, i))
                    return {"the domain reaches beyond the hull", c};
        }
    return {nullptr, none};
}

// What the directions of facet i of cell c leave of the ways from it to vertex i and to the domain's centre. Returns
// inner; null when the facet has no normal.
template <int D>
[[gnu::cold]] double* DomainCheck<D>::normal_of(std::uint32_t c, int i, double* inner, double* centre) const {
    store_.arena.pass(2 * D);
    const Cell<D>& cell = store_.cell(c);
    const double* const p = store_.point(cell.vertex[i == 0 ? 1 : 0]);
    double along[D][D];  // orthonormal directions of the facet
    int size = 0;
    const auto leave = [&](double* e) {
        for (int j = 0; j < size; ++j) {
            const double common = dot<D>(e, along[j]);
            for (int k = 0; k < D; ++k) e[k] -= common * along[j][k];
        }
    };
    for (int j = 0; j <= D; ++j) {
        if (j == i || store_.point(cell.vertex[j]) == p) continue;
        double* const e = along[size];
        for (int k = 0; k < D; ++k) e[k] = store_.point(cell.vertex[j])[k] - p[k];
        leave(e);
        const double length = square_root(dot<D>(e, e));
        if (!(length > 0)) return nullptr;
        for (int k = 0; k < D; ++k) e[k] /= length;
        ++size;
    }
    for (int k = 0; k < D; ++k) {
        inner[k] = store_.point(cell.vertex[i])[k] - p[k];
        centre[k] = domain_.centre[k] - p[k];
    }
    leave(inner);
    leave(centre);
    return inner;
}

// Is the domain's centre not as far from facet i of cell c, to the side of vertex i, as the domain's radius?
template <int D> [[gnu::cold]] bool DomainCheck<D>::reaches_beyond(std::uint32_t c, int i) const {
    double inner[D], centre[D];
    if (normal_of(c, i, inner, centre) == nullptr) return true;
    const double height = square_root(dot<D>(centre, centre));
    return !(dot<D>(inner, centre) > 0) || height < domain_.radius - slack_;
}

// Is the point of the sphere above facet i of cell c, which is as far from all of its vertices, farther from them than
// delta?
template <int D> [[gnu::cold]] bool DomainCheck<D>::leaves_hole(std::uint32_t c, int i) const {
    double inner[D], centre[D], top[D];
    if (normal_of(c, i, inner, centre) == nullptr) return true;
    const double length = square_root(dot<D>(inner, inner));
    for (int k = 0; k < D; ++k) top[k] = domain_.centre[k] - domain_.radius / length * inner[k];
    const double* const p = store_.point(store_.cell(c).vertex[i == 0 ? 1 : 0]);
    return far2_ > 0 && !(square_root(distance2<D>(top, p)) <= delta_ + net_slack_);
}

}  // namespace

template <int D>
CheckResult check_domain(const Store<D>& store, const Domain<D>& domain, const std::uint32_t* domains, bool whole,
                         const NetPromise& net) {
    return DomainCheck<D>(store, domain, domains, net).run(whole);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template CheckResult check_domain<D>(const Store<D>&, const Domain<D>&, const std::uint32_t*, bool,                \
                                         const NetPromise&);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
