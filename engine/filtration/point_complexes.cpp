#include "filtration/point_complexes.hpp"

#include "geometry/circumsphere_fast.hpp"
#include "geometry/circumsphere_settle.hpp"
#include "geometry/half_distance.hpp"
#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// A function of its own, so that its numbers are not on the stack while exact stages run.
[[gnu::noinline]] Certainty sphere_of(std::uint32_t k, std::uint32_t dim, const double* const* const* point,
                                      Circumsphere* sphere) {
    return circumspheres_fast<double, any_dimension, any_dimension>(k, dim, point, sphere);
}

constexpr std::uint32_t count_max = 0x7FFFFFFFu;

// The simplices whose edges are at most 2 * limit long, dimension by dimension. Their values are half their longest
// edge.
template <class Half> class Cliques {
public:
    Cliques(Half half, std::uint32_t n, double limit, const Work& work, ListedComplex* out)
        : half_(half), n_(n), limit_(limit), arena_(work.arena), monitor_(work.monitor), out_(*out) {}

    Status list(std::uint32_t dimension) {
        out_ = {};
        out_.dimension = dimension;
        out_.count[0] = n_;
        if (!take(0)) return Status::out_of_memory;
        for (std::uint32_t i = 0; i < n_;)
            for (const std::uint64_t piece = arena_.piece(i, n_, 5); i < piece; ++i) {
                out_.rows[0][i] = i;
                out_.value[0][i] = 0;
            }
        monitor_.begin(NETMESH_STAGE_FILTER, 0);
        for (std::uint32_t k = 1; k <= dimension; ++k) {
            std::uint64_t count = 0;
            bool going = extend(k, [&count](const std::uint32_t*, std::uint32_t, double) { ++count; });
            if (!going) return Status::cancelled;
            if (count == 0) {
                out_.dimension = k - 1;
                break;
            }
            if (count > count_max) {
                arena_.refuse(count > SIZE_MAX / 64 ? SIZE_MAX / 2
                                                    : static_cast<std::size_t>(count * (4 * (k + 1) + 8)));
                return Status::out_of_memory;
            }
            out_.count[k] = static_cast<std::uint32_t>(count);
            if (!take(k)) return Status::out_of_memory;
            std::uint32_t* row = out_.rows[k];
            double* value = out_.value[k];
            going = extend(k, [&row, &value, k](const std::uint32_t* vertices, std::uint32_t last, double v) {
                for (std::uint32_t i = 0; i < k; ++i) *row++ = vertices[i];
                *row++ = last;
                *value++ = v;
            });
            if (!going) return Status::cancelled;
        }
        return Status::ok;
    }

private:
    bool take(std::uint32_t k) {
        out_.rows[k] = arena_.take_low<std::uint32_t>(std::size_t{out_.count[k]} * (k + 1));
        out_.value[k] = arena_.take_low<double>(out_.count[k]);
        return out_.rows[k] != nullptr && out_.value[k] != nullptr;
    }

    // Calls f(vertices, last, value) for every k-simplex. False: cancelled.
    template <class F> bool extend(std::uint32_t k, F f) {
        for (std::uint32_t i = 0; i < out_.count[k - 1]; ++i) {
            const std::uint32_t* const row = out_.rows[k - 1] + std::size_t{i} * k;
            if (monitor_.advance(i, 1 + (n_ - row[k - 1]) / 12)) return false;
            for (std::uint32_t last = row[k - 1] + 1; last < n_; ++last) {
                double value = out_.value[k - 1][i];
                for (std::uint32_t v = 0; v < k && value <= limit_; ++v) {
                    const double half = half_(last, row[v]);
                    if (half > value) value = half;
                }
                if (value <= limit_) f(row, last, value);
            }
        }
        return true;
    }

    Half half_;  // half the distance of two vertices, the larger one first; infinite: they are never joined
    std::uint32_t n_;
    double limit_;
    Arena& arena_;
    Monitor& monitor_;
    ListedComplex& out_;
};

template <class Half>
[[gnu::noinline]] Status list_cliques(Half half, std::uint32_t n, std::uint32_t dimension, double limit,
                                      const Work& work, ListedComplex* out) {
    Cliques<Half> cliques(half, n, limit, work, out);
    const Status status = cliques.list(dimension);
    ComplexFault fault;
    return status != Status::ok ? status : link_faces(*out, false, work, &fault);
}

// Radii of smallest enclosing balls.
class EnclosingBalls {
public:
    EnclosingBalls(int dim, const double* coordinates, const ListedComplex& complex, Arena& arena)
        : dim_(dim), coordinates_(coordinates), complex_(complex), arena_(arena) {}

    // Of a k-simplex, k >= 2, whose facets have their values. The ball is that of a facet or the simplex's own sphere,
    // which then has its centre strictly inside. out_of_memory, out_of_range.
    Status radius(std::uint32_t k, std::uint32_t simplex, double* out) const {
        double value = 0;
        for (std::uint32_t i = 0; i <= k; ++i) {
            const double facet = complex_.value[k - 1][complex_.rows[k][std::size_t{simplex} * (k + 1) + i]];
            if (facet > value) value = facet;
        }
        *out = value;
        const std::uint32_t space = static_cast<std::uint32_t>(dim_);
        if (k > space) return Status::ok;  // no more than dim + 1 points hold a ball
        std::uint32_t vertices[dimension_most() + 1];
        const double* point[dimension_most() + 1];
        vertices_of(complex_, k, simplex, vertices);
        for (std::uint32_t i = 0; i <= k; ++i) point[i] = coordinates_ + vertices[i] * std::size_t{space};
        Circumsphere sphere;
        const double* const* const one[] = {point};
        const Certainty certain = sphere_of(k, space, one, &sphere);
        if (certain.within == 0) {
            const Status status = settle_circumsphere(point, k, dim_, true, false, arena_, &sphere);
            if (status != Status::ok) return status == Status::check_failed ? Status::ok : status;  // flat
        }
        if (sphere.within != 0) return Status::ok;
        if (certain.radius == 0) {
            const Status status = settle_circumsphere(point, k, dim_, false, true, arena_, &sphere);
            if (status != Status::ok) return status;
        }
        *out = sphere.radius;
        return Status::ok;
    }

private:
    int dim_;
    const double* coordinates_;
    const ListedComplex& complex_;
    Arena& arena_;
};

// The chains of nested sets that end in one set, from the top down: a chain of length m is a path of m - 1 steps.
class NestedSets {
public:
    NestedSets(const ListedComplex& complex, std::uint32_t k) : complex_(complex), least_(k - 1) {
        std::uint32_t first = 0;
        for (std::uint32_t d = least_; d <= complex.dimension; ++d) {
            first_[d] = first;
            first += complex.count[d];
        }
        sets_ = first;
    }
    std::uint32_t sets() const { return sets_; }
    double value(std::uint32_t set) const {
        const std::uint32_t d = dimension_of(set);
        return complex_.value[d][set - first_[d]];
    }
    std::uint32_t dimension_of(std::uint32_t set) const {
        std::uint32_t d = complex_.dimension;
        while (set < first_[d]) --d;
        return d;
    }
    // Calls f(subset) for the proper subsets of `set` of at least k vertices that have at most `span` vertices less
    // than `largest`. A subset is reached by leaving out its missing vertices from the last to the first.
    template <class F> void subsets(std::uint32_t set, std::uint32_t largest, std::uint32_t span, F f) const {
        const std::uint32_t d = dimension_of(set), top = dimension_of(largest);
        const std::uint32_t least = top > least_ + span ? top - span : least_;
        for (std::uint64_t missing = 1; missing < std::uint64_t{1} << (d + 1); ++missing) {
            std::uint32_t left = d + 1;
            for (std::uint32_t v = 0; v <= d; ++v) left -= missing >> v & 1;
            if (left <= least) continue;
            std::uint32_t at = set - first_[d], dimension = d;
            for (std::uint32_t v = d + 1; v-- > 0;) {
                if ((missing >> v & 1) == 0) continue;
                at = complex_.rows[dimension][std::size_t{at} * (dimension + 1) + v];
                --dimension;
            }
            f(first_[dimension] + at);
        }
    }

private:
    const ListedComplex& complex_;
    std::uint32_t least_, sets_;  // least_: dimension of the smallest sets
    std::uint32_t first_[ListedComplex::dimension_max + 1];
};

double binomial_of_real(double n, std::uint32_t k) {
    double b = 1;
    for (std::uint32_t i = 0; i < k; ++i) b = b * (n - i) / (i + 1);
    return b > 0 ? b : 0;
}

struct HalfDistances {
    int dim;
    const double* coordinates;
    double operator()(std::uint32_t i, std::uint32_t j) const {
        const std::size_t row = static_cast<std::size_t>(dim);
        return half_distance(dim, coordinates + j * row, coordinates + i * row);
    }
};

}  // namespace

Status rips_complex(int dim, const double* coordinates, std::uint32_t n, std::uint32_t dimension, double threshold,
                    const Work& work, ListedComplex* out) {
    const double cone = cone_radius<any_dimension>(dim, coordinates, n);
    return list_cliques(HalfDistances{dim, coordinates}, n, dimension, threshold < cone ? threshold : cone, work, out);
}

Status full_rips_complex(int dim, const double* coordinates, std::uint32_t n, std::uint32_t dimension, const Work& work,
                         ListedComplex* out) {
    return list_cliques(HalfDistances{dim, coordinates}, n, dimension, infinity, work, out);
}

Status distance_complex(const DistanceSource& source, std::uint32_t dimension, double limit, const Work& work,
                        ListedComplex* out) {
    const auto half = [&source](std::uint32_t i, std::uint32_t j) { return source.half(i, j); };
    return list_cliques(half, source.count, dimension, limit, work, out);
}

namespace {

// Apart from what follows, as it takes its share of the stack.
[[gnu::noinline]] void measure_listed_edges(const HalfDistances& half, ListedComplex* out, const Arena& arena) {
    if (out->dimension == 0) return;
    arena.each(out->count[1], 60, [&](std::uint64_t i) {
        const std::uint32_t* const ends = out->rows[1] + 2 * i;
        out->value[1][i] = half(ends[0], ends[1]);
    });
}

}  // namespace

Status cech_complex(int dim, const double* coordinates, std::uint32_t n, std::uint32_t dimension, const Work& work,
                    ListedComplex* out) {
    const auto none = [](std::uint32_t, std::uint32_t) { return 0.0; };  // values come below
    Status status = list_cliques(none, n, dimension, infinity, work, out);
    if (status != Status::ok) return status;
    measure_listed_edges({dim, coordinates}, out, work.arena);
    const EnclosingBalls balls(dim, coordinates, *out, work.arena);
    for (std::uint32_t k = 2; k <= out->dimension; ++k) {
        for (std::uint32_t i = 0; i < out->count[k]; ++i) {
            if (work.monitor.advance(i, 2 * k)) return Status::cancelled;
            status = balls.radius(k, i, &out->value[k][i]);
            if (status != Status::ok) return status;
        }
    }
    return Status::ok;
}

Status barycentric_complex(const ListedComplex& complex, std::uint32_t k, std::uint32_t span, std::uint32_t dimension,
                           const Work& work, ListedComplex* out) {
    *out = {};
    if (k > complex.dimension + 1) return Status::invalid_argument;
    const NestedSets nested(complex, k);
    if (dimension > complex.dimension + 1 - k) dimension = complex.dimension + 1 - k;
    if (dimension > span) dimension = span;
    out->dimension = dimension;
    for (std::uint32_t m = 0; m <= dimension; ++m) {
        std::uint64_t count = nested.sets();
        if (m > 0) {
            count = 0;
            for (std::uint32_t i = 0; i < out->count[m - 1]; ++i) {
                if (work.monitor.advance(i, 1u << (span < 4 ? span + 2 : 6))) return Status::cancelled;
                const std::uint32_t* const chain = out->rows[m - 1] + std::size_t{i} * m;
                nested.subsets(chain[0], chain[m - 1], span, [&count](std::uint32_t) { ++count; });
            }
        }
        if (count > count_max) {
            work.arena.refuse(count > SIZE_MAX / 64 ? SIZE_MAX / 2
                                                    : static_cast<std::size_t>(count * (4 * (m + 1) + 8)));
            return Status::out_of_memory;
        }
        out->count[m] = static_cast<std::uint32_t>(count);
        out->rows[m] = work.arena.take_low<std::uint32_t>(static_cast<std::size_t>(count) * (m + 1));
        out->value[m] = work.arena.take_low<double>(static_cast<std::size_t>(count));
        if (out->rows[m] == nullptr || out->value[m] == nullptr) return Status::out_of_memory;
        std::uint32_t* row = out->rows[m];
        double* value = out->value[m];
        for (std::uint32_t i = 0; m == 0 && i < out->count[0]; ++i) {
            work.arena.step(i, 20);
            *row++ = i;
            *value++ = nested.value(i);
        }
        for (std::uint32_t i = 0; m > 0 && i < out->count[m - 1]; ++i) {
            if (work.monitor.advance(i, 1u << (span < 4 ? span + 2 : 6))) return Status::cancelled;
            const std::uint32_t* const chain = out->rows[m - 1] + std::size_t{i} * m;
            const double enters = out->value[m - 1][i];
            nested.subsets(chain[0], chain[m - 1], span, [&](std::uint32_t subset) {
                *row++ = subset;
                for (std::uint32_t c = 0; c < m; ++c) *row++ = chain[c];
                *value++ = enters;
            });
        }
    }
    ComplexFault fault;
    return link_faces(*out, false, work, &fault);
}

std::uint32_t set_size(const ListedComplex& complex, std::uint32_t k, std::uint32_t label) {
    return NestedSets(complex, k).dimension_of(label) + 1;
}

double skeleton_count(std::uint64_t n, std::uint32_t dimension) {
    double total = 0;
    for (std::uint32_t k = 0; k <= dimension; ++k) total += binomial_of_real(static_cast<double>(n), k + 1);
    return total;
}

// Chains of length m that end in a set of j vertices: the sum over smaller sets in it of chains of length m - 1.
double barycentric_count(std::uint64_t n, std::uint32_t k, std::uint32_t sets, std::uint32_t dimension) {
    constexpr std::uint32_t most = ListedComplex::dimension_max + 2;
    double ends[most] = {}, total = 0;
    for (std::uint32_t j = k; j <= sets && j < most; ++j) ends[j] = 1;
    for (std::uint32_t m = 0; m <= dimension; ++m) {
        double next[most] = {};
        for (std::uint32_t j = k; j <= sets && j < most; ++j) {
            total += ends[j] * binomial_of_real(static_cast<double>(n), j);
            for (std::uint32_t i = k; i < j; ++i) next[j] += ends[i] * binomial_of_real(j, i);
        }
        for (std::uint32_t j = 0; j < most; ++j) ends[j] = next[j];
    }
    return total;
}

double barycentric_pairs(std::uint64_t n, std::uint32_t k, std::uint32_t max_degree) {
    double total = 0;
    for (std::uint32_t j = k; j <= k + max_degree; ++j)
        total += binomial_of_real(static_cast<double>(n), j) * binomial_of_real(j - 1, k - 1);
    return total;
}

}  // namespace netmesh
