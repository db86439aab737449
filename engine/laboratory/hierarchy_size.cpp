#include "laboratory/hierarchy_size.hpp"

#include "mesh/cages/any_cage.hpp"
#include "mesh/check/hierarchy_quality.hpp"
#include "mesh/check/quality.hpp"
#include "numerics/elementary.hpp"

namespace netmesh {
namespace {

constexpr double margin = 0x1p-40, tolerance = 0x1p-15;

class DomainSums {
public:
    DomainSums(const AnyStore& store, const DomainSumRequest& request, const Work& work, DomainSum& sum)
        : store_(store), request_(request), work_(work), sum_(sum) {}

    Status open();
    Status add(std::uint32_t d);

private:
    // Domains in the order of their cages, the outermost last.
    std::uint32_t place(std::uint32_t d) const { return d == none ? request_.cage_count : d; }
    bool is_exempt(std::uint32_t v) const { return store_.vertex(v).marker == Marker::exempt; }
    bool is_inserted(std::uint32_t v) const { return store_.vertex(v).cell != none; }
    void sort_vertices(const std::uint32_t* domain);
    std::uint32_t gather_inputs(std::uint32_t d, const AnyDomain& ball, double* foreign);
    double feature_size(const AnyInputTree& tree, const double* x) const;
    double share_of_cages(const AnyInputTree& tree, std::uint32_t d) const;

    const AnyStore& store_;
    const DomainSumRequest& request_;
    const Work& work_;
    DomainSum& sum_;
    double* nearest2_;         // [vertices]
    std::uint32_t* vertices_;  // [vertices], by domain
    std::uint32_t* first_;     // [domains + 1], in vertices_
    std::uint32_t* inside_;    // [domains]: list of the cages directly inside, through Cage::next
    std::uint32_t* inputs_;    // [inputs + 1]: Q of the domain at hand
};

// check_failed: this is no hierarchy.
Status DomainSums::open() {
    const std::uint32_t vertices = store_.state.vertex_count, cages = request_.cage_count;
    Arena& arena = work_.arena;
    nearest2_ = arena.take_low<double>(vertices);
    vertices_ = arena.take_low<std::uint32_t>(vertices);
    std::uint32_t* const domain = arena.take_low<std::uint32_t>(vertices);
    first_ = arena.take_low<std::uint32_t>(cages + 2);
    inside_ = arena.take_low<std::uint32_t>(cages + 1);
    inputs_ = arena.take_low<std::uint32_t>(request_.inputs + 1);
    if (nearest2_ == nullptr || vertices_ == nullptr || domain == nullptr || first_ == nullptr || inside_ == nullptr ||
        inputs_ == nullptr)
        return Status::out_of_memory;
    HierarchyQuality quality;
    const Status status =
        measure_hierarchy(store_, {request_.cages, cages, request_.outermost, nearest2_, domain}, arena, &quality);
    if (status != Status::ok || !quality.is_hierarchy) return status == Status::ok ? Status::check_failed : status;
    recomputed_nearest2(store_, nearest2_);
    sort_vertices(domain);
    for (std::uint32_t d = 0; d <= cages; ++d) {
        store_.arena.step(d, 4);
        inside_[d] = none;
    }
    for (std::uint32_t d = 0; d < cages;)
        for (const std::uint64_t piece = store_.arena.piece(d, cages, 8); d < piece; ++d) {
            std::uint32_t& head = inside_[place(request_.cages[d].parent)];
            request_.cages[d].next = head;
            head = d;
        }
    return Status::ok;
}

void DomainSums::sort_vertices(const std::uint32_t* domain) {
    const std::uint32_t vertices = store_.state.vertex_count, domains = request_.cage_count + 1;
    for (std::uint32_t d = 0; d <= domains; ++d) {
        store_.arena.step(d, 4);
        first_[d] = 0;
    }
    for (std::uint32_t v = 0; v < vertices;)
        for (const std::uint64_t piece = store_.arena.piece(v, vertices, 10); v < piece; ++v) {
            if (is_inserted(v)) ++first_[place(domain[v])];
        }
    for (std::uint32_t d = 1; d <= domains; ++d) {
        store_.arena.step(d, 4);
        first_[d] += first_[d - 1];
    }  // where each domain ends
    for (std::uint32_t v = vertices; v-- > 0;) {
        store_.arena.step(v, 10);
        if (is_inserted(v)) vertices_[--first_[place(domain[v])]] = v;
    }
}

// Q in inputs_; *foreign: F.
std::uint32_t DomainSums::gather_inputs(std::uint32_t d, const AnyDomain& ball, double* foreign) {
    std::uint32_t count = 0, nearest = none;
    double far2 = infinity;
    for (std::uint32_t k = first_[place(d)]; k < first_[place(d) + 1];)
        for (const std::uint64_t piece = store_.arena.piece(k, first_[place(d) + 1], 30); k < piece; ++k) {
            const std::uint32_t v = vertices_[k];
            if (v < request_.inputs) inputs_[count++] = v;
            if (!is_exempt(v) || !(ball.distance2(store_.point(v)) < far2)) continue;
            far2 = ball.distance2(store_.point(v));
            nearest = v;
        }
    for (std::uint32_t e = inside_[place(d)]; e != none; e = request_.cages[e].next)
        inputs_[count++] = request_.cages[e].centre;
    if (count == 1 && nearest != none) inputs_[count++] = nearest;
    *foreign = square_root(far2);
    if (d != none && request_.cages[d].radius < *foreign) *foreign = request_.cages[d].radius;
    return count;
}

double DomainSums::feature_size(const AnyInputTree& tree, const double* x) const {
    double d2;
    const std::uint32_t first = tree.nearest(x, none, none, &d2);
    tree.nearest(x, none, first, &d2);
    return square_root(d2);
}

// The sum that the lower bound subtracts.
double DomainSums::share_of_cages(const AnyInputTree& tree, std::uint32_t d) const {
    double sum = 0;
    for (std::uint32_t e = inside_[place(d)]; e != none; e = request_.cages[e].next) {
        const Cage& cage = request_.cages[e];
        double q2;
        tree.nearest(store_.point(cage.centre), none, cage.centre, &q2);
        const double room = square_root(q2) - cage.radius;
        sum += room > 0 ? power(2 * in_radius(cage) / room, store_.dim) : infinity;
    }
    return sum;
}

Status DomainSums::add(std::uint32_t d) {
    ArenaScope scope(work_.arena);
    const int dim = store_.dim;
    const AnyDomain ball = domain_ball(store_, request_.cages, d, request_.outermost);
    double foreign, ratio = 0, reach = 0, off2 = infinity;
    const std::uint32_t count = gather_inputs(d, ball, &foreign);
    AnyInputTree tree;
    if (tree.build(store_, work_.arena, count, false, inputs_) != Status::ok) return Status::out_of_memory;
    std::uint32_t size = 0;
    for (std::uint32_t k = first_[place(d)]; k < first_[place(d) + 1];)
        for (const std::uint64_t piece = store_.arena.piece(k, first_[place(d) + 1], 800); k < piece; ++k) {
            const std::uint32_t v = vertices_[k];
            if (d != none || !is_exempt(v)) ++sum_.size;
            if (is_exempt(v)) continue;
            ++size;
            const double nearest = square_root(nearest2_[v]),
                         f = count > 1 ? feature_size(tree, store_.point(v)) : infinity;
            const double out = square_root(ball.distance2(store_.point(v))) + 0.5 * nearest;
            if (f / nearest > ratio) ratio = f / nearest;
            if (out > reach) reach = out;
        }
    if (d != none) {
        sum_.lower += 2 * dim;  // its shell
        sum_.upper += 2 * dim;
    }
    if (ratio > sum_.feature_ratio) sum_.feature_ratio = ratio;
    if (size == 0) return Status::ok;
    if (count < 2) {
        sum_.upper = infinity;
        return Status::ok;
    }
    for (std::uint32_t k = 0; k < count;)
        for (const std::uint64_t piece = store_.arena.piece(k, count, 20); k < piece; ++k) {
            const double q2 = ball.distance2(store_.point(inputs_[k]));
            if (q2 < off2) off2 = q2;
        }
    const double room = 0.5 * (foreign - square_root(off2)), inner = room < ball.radius ? room : ball.radius;
    double radius[2] = {inner > 0 ? inner * (1 - margin) : 0, reach * (1 + margin)};
    if (radius[1] < radius[0]) radius[1] = radius[0];
    FeatureIntegral integral;
    const IntegralRequest asked = {ball.centre, radius, 2, request_.tolerance,
                                   request_.boxes_max / (request_.cage_count + 1)};
    const Status status = feature_integral(store_, tree, asked, work_, &integral);
    if (status != Status::ok) return status;
    const double volume = unit_ball_volume(dim);
    const double lower = integral.lower[0] / (volume * power(request_.tau, dim)) * (1 - tolerance) -
                         share_of_cages(tree, d) * (1 + tolerance);
    if (lower > 0) sum_.lower += lower;
    sum_.upper += integral.upper[1] / volume * power(2 * ratio + 1, dim) * (1 + tolerance);
    sum_.boxes += integral.boxes;
    return Status::ok;
}

}  // namespace

Status sum_over_domains(const AnyStore& store, const DomainSumRequest& request, const Work& work, DomainSum* sum) {
    *sum = {};
    ArenaScope scope(work.arena);
    DomainSums sums(store, request, work, *sum);
    Status status = sums.open();
    for (std::uint32_t d = 0; d < request.cage_count && status == Status::ok; ++d) status = sums.add(d);
    if (status == Status::ok) status = sums.add(none);
    for (std::uint32_t d = 0; d < request.cage_count; ++d) request.cages[d].next = none;
    if (status != Status::check_failed) return status;
    sum->upper = infinity;
    return Status::ok;
}

}  // namespace netmesh
