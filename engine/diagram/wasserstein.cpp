#include "diagram/wasserstein.hpp"

#include "diagram/price_tree.hpp"

namespace netmesh {
namespace {

// What is known of a distance, or of a part of one.
struct Bracket {
    double lower, upper;
};

// One diagram's points of one degree, in the order of the tree.
struct Market {
    PairView pairs;
    TransportPoint* points;
    PriceTree::Node* nodes;
    double* diagonal;     // cost of the way there, at most what the best matching costs
    std::uint32_t* mate;  // in the other diagram; none: the diagonal
    PriceTree tree;
};

struct Markets {
    Market side[2];
    std::uint32_t* queue;
    std::uint32_t queue_size;

    void lay_out(Scratch& memory, std::size_t count_a, std::size_t count_b) {
        const std::size_t count[2] = {count_a, count_b};
        for (int s = 0; s < 2; ++s) {
            side[s].points = memory.take<TransportPoint>(count[s]);
            side[s].nodes = memory.take<PriceTree::Node>(count[s]);
            side[s].diagonal = memory.take<double>(count[s]);
            side[s].mate = memory.take<std::uint32_t>(count[s]);
        }
        queue_size = static_cast<std::uint32_t>(count_a > count_b ? count_a : count_b) + 1;
        queue = memory.take<std::uint32_t>(queue_size);
    }
};

// The points that have to bid, first come first served.
class Bidders {
public:
    Bidders(std::uint32_t* ring, std::uint32_t size) : ring_(ring), size_(size) {}
    bool empty() const { return first_ == end_; }
    void push(std::uint32_t i) {
        ring_[end_] = i;
        end_ = behind(end_);
    }
    std::uint32_t pop() {
        const std::uint32_t i = ring_[first_];
        first_ = behind(first_);
        return i;
    }

private:
    std::uint32_t behind(std::uint32_t place) const { return place + 1 == size_ ? 0 : place + 1; }

    std::uint32_t* ring_;
    std::uint32_t size_, first_ = 0, end_ = 0;
};

// Auctions over the points of two diagrams of one degree.
class Transport {
public:
    Transport(Markets& work, Power power, double relative_error, Monitor& monitor)
        : work_(work), cost_(power), relative_error_(relative_error), monitor_(monitor) {}

    // The part of the distance that is due to these points, from the matching at hand. False when it is cancelled.
    bool solve(Bracket* found) {
        *found = {0, 0};
        double longest = longest_move();
        if (longest == 0) return true;
        cost_.set_unit(TransportCost::unit_of(longest));
        measure_diagonals(infinity);
        ceiling_ = cost_of_matching();
        measure_diagonals(ceiling_);
        Market& b = work_.side[1];
        b.tree.price_all([&b](std::uint32_t j) { return b.diagonal[j]; });
        for (double step = dearest() / 4;;) {
            auction(step);
            if (monitor_.has_stopped()) return false;
            longest = longest_move();
            if (longest == 0) return true;
            step = change_unit(longest, step);
            measure_diagonals(infinity);
            const double upper = cost_of_matching();
            if (upper < ceiling_) ceiling_ = upper;
            measure_diagonals(ceiling_);
            cut_potentials();
            const double lower = lower_bound();
            if (monitor_.has_stopped()) return false;
            const Bracket in_unit = {cost_.power().root_below(lower), cost_.power().root_above(upper)};
            *found = {cost_.lowered_from_unit(in_unit.lower), cost_.raised_from_unit(in_unit.upper)};
            if (in_unit.upper <= in_unit.lower * (1 + relative_error_)) return true;
            // Below this step the potentials' own rounding counts.
            if (step < ceiling_ * 0x1p-46) return true;
            step /= 5;
            if (step > ceiling_ / 8) step = ceiling_ / 8;
        }
    }

    // Of the last auction: see netmesh_wasserstein_request.
    void write(const WassersteinRequest& request) const {
        const Market &a = work_.side[0], &b = work_.side[1];
        for (std::uint32_t i = 0; i < a.tree.count(); ++i) {
            const std::uint32_t at = a.tree[i].index;
            if (request.mates_a != nullptr && a.mate[i] != none) request.mates_a[at] = b.tree[a.mate[i]].index;
            if (request.potentials_a != nullptr) request.potentials_a[at] = lowered(a.tree.potential(i));
        }
        for (std::uint32_t j = 0; j < b.tree.count(); ++j)
            if (request.potentials_b != nullptr) request.potentials_b[b.tree[j].index] = lowered(b.tree.potential(j));
    }
    int exponent() const { return cost_.exponent(); }

private:
    // ---- units: the longest move of the matching is from 1 to 2, so that no cost that matters leaves the range

    // Potentials and step in the unit of another matching.
    double change_unit(double longest, double step) {
        const int unit = TransportCost::unit_of(longest);
        const int shift = (unit - cost_.exponent()) * static_cast<int>(cost_.power().order());
        cost_.set_unit(unit);
        if (shift == 0) return step;
        PriceTree& tree = work_.side[1].tree;
        tree.price_all([&](std::uint32_t j) { return scaled(tree.potential(j), shift); });
        ceiling_ = scaled(ceiling_, shift);
        return scaled(step, shift);
    }
    // x 2^k, where that is beyond the doubles the end of their range.
    static double scaled(double x, int k) {
        for (; k > 1000; k -= 1000) x *= 0x1p1000;
        for (; k < -1000; k += 1000) x *= 0x1p-1000;
        x *= power_of_two(k);
        return x > 0x1p1000 ? 0x1p1000 : x < -0x1p1000 ? -0x1p1000 : x;
    }

    // ---- matching and potentials

    // The farthest that a point goes, in the diagrams' unit.
    double longest_move() const {
        const TransportCost plain = TransportCost(Power(1));
        double longest = 0;
        const Market &a = work_.side[0], &b = work_.side[1];
        for (std::uint32_t i = 0; i < a.tree.count(); ++i) {
            step_done(i);
            const double* const x = a.tree[i].at;
            const double move = a.mate[i] == none ? plain.to_diagonal(x) : plain.between(x, b.tree[a.mate[i]].at);
            if (move > longest) longest = move;
        }
        for (std::uint32_t j = 0; j < b.tree.count(); ++j) {
            step_done(j);
            if (b.mate[j] != none) continue;
            const double move = plain.to_diagonal(b.tree[j].at);
            if (move > longest) longest = move;
        }
        return longest;
    }
    // Ways to the diagonal, at most `ceiling`.
    void measure_diagonals(double ceiling) {
        for (Market& m : work_.side) {
            for (std::uint32_t i = 0; i < m.tree.count(); ++i) {
                step_done(i);
                m.diagonal[i] = cost_.to_diagonal(m.tree[i].at);
                if (m.diagonal[i] > ceiling) m.diagonal[i] = ceiling;
            }
        }
    }
    double dearest() const {
        double most = 0;
        for (const Market& m : work_.side)
            for (std::uint32_t i = 0; i < m.tree.count(); ++i)
                if (m.diagonal[i] > most) most = m.diagonal[i];
        return most;
    }
    // Potentials of b are not above its ways to the diagonal.
    void cut_potentials() {
        Market& b = work_.side[1];
        b.tree.price_all([&b](std::uint32_t j) {
            const double potential = b.tree.potential(j);
            return potential < b.diagonal[j] ? potential : b.diagonal[j];
        });
    }
    // No less than the matching costs; the ways to the diagonal as they are.
    double cost_of_matching() const {
        const Market &a = work_.side[0], &b = work_.side[1];
        double sum = 0;
        for (std::uint32_t i = 0; i < a.tree.count(); ++i) {
            step_done(i);
            sum += a.mate[i] == none ? a.diagonal[i] : cost_.between(a.tree[i].at, b.tree[a.mate[i]].at);
        }
        for (std::uint32_t j = 0; j < b.tree.count(); ++j) {
            step_done(j);
            if (b.mate[j] == none) sum += b.diagonal[j];
        }
        return sum * (1 + roundoff());
    }
    // No more than any matching costs, by the potentials of b and the best for a.
    double lower_bound() {
        Market &a = work_.side[0], &b = work_.side[1];
        double sum = 0, sum_of_sizes = 0;
        for (std::uint32_t i = 0; i < a.tree.count(); ++i) {
            if (monitor_.has_stopped()) return 0;
            const double potential = b.tree.best(a.tree[i], a.diagonal[i], cost_).first;
            a.tree.keep(i, potential);
            sum += potential;
            sum_of_sizes += absolute(potential);
        }
        for (std::uint32_t j = 0; j < b.tree.count(); ++j) {
            step_done(j);
            sum += b.tree.potential(j);
            sum_of_sizes += absolute(b.tree.potential(j));
        }
        const double bound = sum - roundoff() * sum_of_sizes;
        return bound > 0 ? bound : 0;
    }
    // A cost as computed is within order + 1 roundings of the true one, c. Where f(a) + f(b) is near c, c is at most
    // 2 (|f(a)| + |f(b)|), and the difference c - f(b), which f(a) is not above, is rounded by less than 2^-53 of the
    // same: with 2 order + 6 roundings off each potential, f(a) + f(b) <= c holds for the true cost. A sum of n terms
    // is within n roundings of the sum of their sizes.
    double roundoff() const {
        const double terms = static_cast<double>(work_.side[0].tree.count()) + work_.side[1].tree.count();
        return (terms + 4 * cost_.power().order() + 16) * unit_roundoff;
    }
    double lowered(double potential) const {
        return potential - (2 * cost_.power().order() + 8) * unit_roundoff * absolute(potential);
    }

    // ---- auctions

    void auction(double step) {
        Market &a = work_.side[0], &b = work_.side[1];
        for (Market& m : work_.side)
            for (std::uint32_t i = 0; i < m.tree.count(); ++i) m.mate[i] = none;
        Bidders bidders(work_.queue, work_.queue_size);
        for (std::uint32_t i = 0; i < a.tree.count(); ++i) bidders.push(i);
        while (!bidders.empty() && !monitor_.has_stopped()) bid(a, b, step, &bidders);
        for (std::uint32_t j = 0; j < b.tree.count(); ++j)
            if (b.mate[j] == none && b.tree.potential(j) < b.diagonal[j]) bidders.push(j);
        if (bidders.empty()) return;
        a.tree.price_again();
        while (!bidders.empty() && !monitor_.has_stopped()) bid(b, a, step, &bidders);
        b.tree.price_again();
    }
    // The next bidder takes what is best for it, and pays so much that what is second best would be as good, and a step
    // more.
    void bid(Market& from, Market& to, double step, Bidders* bidders) {
        const std::uint32_t i = bidders->pop();
        const Offer offer = to.tree.best(from.tree[i], from.diagonal[i], cost_);
        if (offer.at == none) {
            from.tree.keep(i, from.diagonal[i]);
            return;
        }
        const double potential = offer.second + step;
        from.tree.keep(i, potential);
        to.tree.price(offer.at, cost_.between(from.tree[i].at, to.tree[offer.at].at) - potential);
        const std::uint32_t outbid = to.mate[offer.at];
        if (outbid != none) {
            from.mate[outbid] = none;
            bidders->push(outbid);
        }
        to.mate[offer.at] = i;
        from.mate[i] = offer.at;
    }
    void step_done(std::uint32_t i) const {
        if (i % 256 == 0) monitor_.pass(25);
    }

    Markets& work_;
    TransportCost cost_;
    double relative_error_;
    Monitor& monitor_;
    double ceiling_ = 0;
};

// Points off the diagonal of one degree into the tree.
void collect_points_of(Market& m, std::uint32_t degree, Monitor& monitor) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < m.pairs.count; ++i) {
        const netmesh_pair pair = m.pairs[i];
        if (pair.degree != degree || is_essential(pair) || pair.birth == pair.death) continue;
        m.points[count++] = {{pair.birth, pair.death}, static_cast<std::uint32_t>(i)};
    }
    m.tree.build(m.points, m.nodes, count, monitor);
}

// Essential pairs of one degree by birth.
std::uint32_t collect_essential(const Market& m, std::uint32_t degree, Monitor& monitor) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < m.pairs.count; ++i) {
        const netmesh_pair pair = m.pairs[i];
        if (pair.degree == degree && is_essential(pair))
            m.points[count++] = {{pair.birth, pair.birth}, static_cast<std::uint32_t>(i)};
    }
    std::uint64_t compared = 0;
    sort(m.points, count, [&](const TransportPoint& x, const TransportPoint& y) {
        if (++compared % 256 == 0) monitor.pass(15);
        return x.at[0] < y.at[0] || (!(y.at[0] < x.at[0]) && x.index < y.index);
    });
    return count;
}

// The p-norm of two brackets.
Bracket combined(const Bracket& x, const Bracket& y, const Power& power) {
    if (x.upper == 0) return y;
    if (y.upper == 0) return x;
    if (x.upper == infinity || y.upper == infinity) return {infinity, infinity};
    const double larger = x.upper > y.upper ? x.upper : y.upper;
    TransportCost cost(power);
    cost.set_unit(TransportCost::unit_of(larger));
    const double r = power.roundoff();
    const double upper = power.root_above((cost.of(x.upper) + cost.of(y.upper)) * (1 + 2 * r));
    const double lower = power.root_below((cost.of(x.lower) + cost.of(y.lower)) * (1 - 2 * r));
    return {cost.lowered_from_unit(lower), cost.raised_from_unit(upper)};
}

// Essential pairs go by birth, which is the least of all sums where costs are convex. False when their numbers differ.
bool match_essential(Markets& work, const WassersteinRequest& request, std::uint32_t degree, const Power& power,
                     Monitor& monitor, Bracket* total) {
    Market &a = work.side[0], &b = work.side[1];
    const std::uint32_t count = collect_essential(a, degree, monitor);
    if (collect_essential(b, degree, monitor) != count) return false;
    for (std::uint32_t i = 0; i < count; ++i) {
        monitor.pass(1 + power.order());
        const double move = absolute(a.points[i].at[0] - b.points[i].at[0]);
        *total = combined(*total, {move * (1 - 2 * unit_roundoff), move * (1 + 2 * unit_roundoff)}, power);
        if (request.mates_a != nullptr) request.mates_a[a.points[i].index] = b.points[i].index;
    }
    return true;
}

}  // namespace

std::size_t wasserstein_bytes(std::uint64_t count_a, std::uint64_t count_b) {
    if (count_a >= compared_pairs_max || count_b >= compared_pairs_max || (count_a + count_b) > SIZE_MAX / 256)
        return SIZE_MAX;
    Scratch memory = {nullptr, 0};
    Markets work = {};
    work.lay_out(memory, static_cast<std::size_t>(count_a), static_cast<std::size_t>(count_b));
    return memory.used;
}

Status wasserstein(const WassersteinRequest& request, Monitor& monitor, netmesh_wasserstein_distance* distance) {
    PairView a = request.a, b = request.b;
    a.monitor = b.monitor = &monitor;
    if (!are_diagram(a, false) || !are_diagram(b, false)) return Status::invalid_argument;
    if (wasserstein_bytes(a.count, b.count) > request.scratch_bytes) return Status::out_of_memory;
    Scratch memory = {static_cast<unsigned char*>(request.scratch), 0};
    Markets work = {};
    work.lay_out(memory, static_cast<std::size_t>(a.count), static_cast<std::size_t>(b.count));
    work.side[0].pairs = a;
    work.side[1].pairs = b;
    for (std::size_t i = 0; i < a.count; ++i) {
        if (request.mates_a != nullptr) request.mates_a[i] = none;
        if (request.potentials_a != nullptr) request.potentials_a[i] = 0;
    }
    for (std::size_t j = 0; j < b.count && request.potentials_b != nullptr; ++j) request.potentials_b[j] = 0;
    const Power power(request.order);
    Bracket total = {0, 0};
    int exponent = 0;
    std::uint64_t from = 0;
    std::uint32_t degree = request.degree;
    const bool all = degree == NETMESH_ALL_DEGREES;
    for (bool more = !all || next_degree(a, b, from, &degree); more; more = all && next_degree(a, b, from, &degree)) {
        if (!match_essential(work, request, degree, power, monitor, &total)) {
            total = {infinity, infinity};
            break;
        }
        collect_points_of(work.side[0], degree, monitor);
        collect_points_of(work.side[1], degree, monitor);
        // To begin with all go to the diagonal. What is good in the first order is good in others, too, of which costs
        // are so flat that auctions get nearer to the short moves by small steps alone.
        for (Market& m : work.side)
            for (std::uint32_t i = 0; i < m.tree.count(); ++i) m.mate[i] = none;
        Bracket part;
        if (request.order > 1 && !Transport(work, Power(1), 0.25, monitor).solve(&part)) return Status::cancelled;
        Transport transport(work, power, request.relative_error, monitor);
        if (!transport.solve(&part)) return Status::cancelled;
        if (!all) transport.write(request);
        exponent = transport.exponent();
        total = combined(total, part, power);
        from = std::uint64_t{degree} + 1;
    }
    if (monitor.has_stopped()) return Status::cancelled;
    *distance = {sizeof *distance, exponent, total.upper, total.lower};
    return Status::ok;
}

}  // namespace netmesh
