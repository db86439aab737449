// Auctions over the points of two diagrams of one degree, for the Wasserstein distance: see wasserstein.hpp.
#pragma once
#include "diagram/price_tree.hpp"
#include "diagram/transport_sums.hpp"
#include "diagram/wasserstein.hpp"

namespace netmesh {

// One diagram's points of one degree, in the order of the tree.
struct Market {
    PairView pairs;
    TransportPoint* points;
    PriceTree::Node* nodes;
    std::int64_t* diagonal;  // cost of the way there
    std::uint32_t* mate;     // in the other diagram; none: the diagonal
    std::uint32_t* best;     // the mates of the best matching so far
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
            side[s].diagonal = memory.take<std::int64_t>(count[s]);
            side[s].mate = memory.take<std::uint32_t>(count[s]);
            side[s].best = memory.take<std::uint32_t>(count[s]);
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
    // Starts from the best matching that is kept.
    Transport(Markets& work, Power power, double relative_error, Monitor& monitor)
        : work_(work), cost_(power), relative_error_(relative_error), monitor_(monitor) {}

    // Bounds of the sum of powers that these points cost: their p-th roots are within the relative error of one
    // another. The best matching is kept, the potentials are those that prove the lower bound. cancelled; internal when
    // the bounds stay apart, which wasserstein.hpp excludes.
    Status solve(Bounds* found) {
        *found = {0, 0, 0};
        if (!take_unit()) return Status::ok;
        Market& b = work_.side[1];
        b.tree.price_all([&b](std::uint32_t j) { return b.diagonal[j]; });
        for (std::int64_t step = at_least_one(dearest() / 4);;) {
            auction(step);
            if (monitor_.has_stopped()) return Status::cancelled;
            cut_potentials();
            const double paid = paid_for([](const Market& m) { return m.mate; });
            const bool is_better = paid < upper_;
            const double upper = is_better ? paid : upper_;
            *found = {cost_.exponent(), lower_bound(upper, step == 1), upper};
            if (monitor_.has_stopped()) return Status::cancelled;
            if (is_better) keep_matching();
            if (are_near(*found)) return Status::ok;
            if (is_better) {
                const int before = cost_.grid() + static_cast<int>(cost_.power().order()) * cost_.exponent();
                if (!take_unit()) {
                    *found = {0, 0, 0};
                    return Status::ok;
                }
                const int shift = cost_.grid() + static_cast<int>(cost_.power().order()) * cost_.exponent() - before;
                b.tree.price_all([&](std::uint32_t j) { return shifted(b.tree.potential(j), shift); });
                step = shifted(step, shift);
            } else if (step == 1) {
                return Status::internal;
            }
            step = at_least_one(step / 5);
            if (step > cost_.ceiling() / 8) step = cost_.ceiling() / 8;
        }
    }

    // See netmesh_wasserstein_request.
    void write(const WassersteinRequest& request) const {
        const Market &a = work_.side[0], &b = work_.side[1];
        for (std::uint32_t i = 0; i < a.tree.count(); ++i) {
            step_done(i);
            const std::uint32_t at = a.tree[i].index;
            if (request.mates_a != nullptr && a.best[i] != none) request.mates_a[at] = b.tree[a.best[i]].index;
            if (request.potentials_a != nullptr) request.potentials_a[at] = lowered(a.tree.potential(i));
        }
        for (std::uint32_t j = 0; j < b.tree.count(); ++j) {
            step_done(j);
            if (request.potentials_b != nullptr) request.potentials_b[b.tree[j].index] = lowered(b.tree.potential(j));
        }
    }
    int exponent() const { return cost_.exponent(); }

private:
    // ---- units: the longest move of the best matching is from 1 to 2, so that no cost that matters leaves the range;
    // the grid is that of its cost

    // Unit, grid and ways to the diagonal by the best matching; upper_ is what it costs. False when that is nothing:
    // potentials are 0 then.
    bool take_unit() {
        const double twice = twice_the_longest_move();
        if (twice == 0) {
            for (Market& m : work_.side) m.tree.price_all([](std::uint32_t) { return 0; });
            return false;
        }
        cost_.set_unit(TransportCost::unit_of(twice) + 1);
        upper_ = paid_for([](const Market& m) { return m.best; });
        cost_.set_grid(upper_);
        for (Market& m : work_.side) {
            for (std::uint32_t i = 0; i < m.tree.count(); ++i) {
                step_done(i);
                m.diagonal[i] = cost_.to_diagonal(m.tree[i].at);
            }
        }
        return true;
    }
    // x 2^k, but no more than the ceiling in size: it is only where an auction begins.
    std::int64_t shifted(std::int64_t x, int k) const {
        const std::int64_t most = cost_.ceiling(), size = x < 0 ? -x : x;
        const std::int64_t wanted = k >= 62   ? (size == 0 ? 0 : most)
                                    : k >= 0  ? (size > (most >> k) ? most : size << k)
                                    : k > -62 ? size >> -k
                                              : 0;
        const std::int64_t limited = wanted < most ? wanted : most;
        return x < 0 ? -limited : limited;
    }
    static std::int64_t at_least_one(std::int64_t x) { return x > 1 ? x : 1; }

    // ---- matchings and potentials

    // Of the best matching, in the diagrams' unit: twice, so that half of the least double is not lost. May be
    // infinite.
    double twice_the_longest_move() const {
        TransportCost plain = TransportCost(Power(1));
        plain.set_unit(1);
        double longest = 0;
        const Market &a = work_.side[0], &b = work_.side[1];
        for (std::uint32_t i = 0; i < a.tree.count(); ++i) {
            step_done(i);
            const double* const x = a.tree[i].at;
            const double move = a.best[i] == none ? plain.length(x) / 2 : plain.distance(x, b.tree[a.best[i]].at);
            if (move > longest) longest = move;
        }
        for (std::uint32_t j = 0; j < b.tree.count(); ++j) {
            step_done(j);
            if (b.best[j] != none) continue;
            const double move = plain.length(b.tree[j].at) / 2;
            if (move > longest) longest = move;
        }
        return longest;
    }
    // No less than a matching costs. What is paid is within (1 + u)^(2p) of its true cost, u = 2^-53, and the sum
    // within 4 u of itself. What is lost below the doubles is less than u of a sum that is 2^-60 or more, which the
    // best matching's is in its unit, and any that is near a lower bound above 0.
    template <class Mates> double paid_for(Mates mates_of) const {
        const Market &a = work_.side[0], &b = work_.side[1];
        const std::uint32_t *const mate_a = mates_of(a), *const mate_b = mates_of(b);
        PositiveSum sum;
        for (std::uint32_t i = 0; i < a.tree.count(); ++i) {
            step_done(i);
            const double* const x = a.tree[i].at;
            sum.add(mate_a[i] == none ? cost_.paid_to_diagonal(x) : cost_.paid_between(x, b.tree[mate_a[i]].at));
        }
        for (std::uint32_t j = 0; j < b.tree.count(); ++j) {
            step_done(j);
            if (mate_b[j] == none) sum.add(cost_.paid_to_diagonal(b.tree[j].at));
        }
        return sum.value() * (1 + (2 * cost_.power().order() + 10) * unit_roundoff);
    }
    void keep_matching() {
        for (Market& m : work_.side) {
            for (std::uint32_t i = 0; i < m.tree.count(); ++i) {
                step_done(i);
                m.best[i] = m.mate[i];
            }
        }
    }
    std::int64_t dearest() const {
        std::int64_t most = 0;
        for (const Market& m : work_.side) {
            for (std::uint32_t i = 0; i < m.tree.count(); ++i) {
                step_done(i);
                if (m.diagonal[i] > most) most = m.diagonal[i];
            }
        }
        return most;
    }
    // Potentials of b are not above its ways to the diagonal.
    void cut_potentials() {
        Market& b = work_.side[1];
        b.tree.price_all([&b](std::uint32_t j) {
            const std::int64_t potential = b.tree.potential(j);
            return potential < b.diagonal[j] ? potential : b.diagonal[j];
        });
    }
    // No more than any matching costs, by the potentials of b and the best for a.
    //
    // They are whole, and so is their sum S, which no matching's cost in whole numbers is below. That is at most
    // 2^grid (1 + u)^(2p) of its true cost: the true one is at least (1 - 2p u) S / 2^grid. As doubles, see lowered(),
    // potentials sum up to (1 - (2p + 8) u) S - 11 u N at least, N the sum of the sizes of negative ones. That counts,
    // so that they prove what is said. In the last round N does not where it keeps the bounds apart; that takes more
    // than 2^16 points, as N is below 2^61 for each and a sum that counts is 2^58 or more.
    double lower_bound(double upper, bool is_last) {
        Market &a = work_.side[0], &b = work_.side[1];
        WholeSum sum;
        double negative = 0;
        for (std::uint32_t i = 0; i < a.tree.count(); ++i) {
            if (monitor_.has_stopped()) return 0;
            const std::int64_t potential = b.tree.best(a.tree[i], a.diagonal[i], cost_).first;
            a.tree.keep(i, potential);
            sum.add(potential);
            if (potential < 0) negative -= static_cast<double>(potential);
        }
        for (std::uint32_t j = 0; j < b.tree.count(); ++j) {
            step_done(j);
            const std::int64_t potential = b.tree.potential(j);
            sum.add(potential);
            if (potential < 0) negative -= static_cast<double>(potential);
        }
        const double unit = power_of_two(-cost_.grid());
        const double whole = cost_.off_grid(sum.value()) * (1 - (2 * cost_.power().order() + 12) * unit_roundoff);
        const double proven = whole - 13 * unit_roundoff * negative * unit;
        if (is_last && !are_near({cost_.exponent(), proven, upper})) return whole;
        return proven > 0 ? proven : 0;
    }
    // A part's share of the error: Total has the rest for its roundings. Of 2^-30, the least, the rest is 2^-42.
    bool are_near(const Bounds& x) const {
        if (!(x.lower > 0)) return false;
        const Power& power = cost_.power();
        return power.root_above(x.upper) <= power.root_below(x.lower) * (1 + relative_error_ * (1 - 0x1p-12));
    }
    // A potential as a double. With s = 1 - (2p + 3) u it is at most s f 2^-grid, so that f(a) + f(b) <= c, which holds
    // for c of at most 2^grid (1 + u)^(2p) of the true cost, goes over to doubles and true costs.
    double lowered(std::int64_t f) const {
        const double x = cost_.off_grid(f), roundings = (2 * cost_.power().order() + (f > 0 ? 6 : 0)) * unit_roundoff;
        return x * (1 - roundings);
    }

    // ---- auctions

    void auction(std::int64_t step) {
        Market &a = work_.side[0], &b = work_.side[1];
        for (Market& m : work_.side) {
            for (std::uint32_t i = 0; i < m.tree.count(); ++i) {
                step_done(i);
                m.mate[i] = none;
            }
        }
        Bidders bidders(work_.queue, work_.queue_size);
        for (std::uint32_t i = 0; i < a.tree.count(); ++i) {
            step_done(i);
            bidders.push(i);
        }
        while (!bidders.empty() && !monitor_.has_stopped()) bid(a, b, step, &bidders);
        if (monitor_.has_stopped()) return;
        for (std::uint32_t j = 0; j < b.tree.count(); ++j) {
            step_done(j);
            if (b.mate[j] == none && b.tree.potential(j) < b.diagonal[j]) bidders.push(j);
        }
        if (bidders.empty()) return;
        a.tree.price_again();
        while (!bidders.empty() && !monitor_.has_stopped()) bid(b, a, step, &bidders);
        b.tree.price_again();
    }
    // The next bidder takes what is best for it, and pays so much that what is second best would be as good, and a step
    // more.
    void bid(Market& from, Market& to, std::int64_t step, Bidders* bidders) {
        const std::uint32_t i = bidders->pop();
        const Offer offer = to.tree.best(from.tree[i], from.diagonal[i], cost_);
        if (offer.at == none) {
            from.tree.keep(i, from.diagonal[i]);
            return;
        }
        const std::int64_t potential = offer.second + step;
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
    double upper_ = 0;  // what the best matching costs
};

}  // namespace netmesh
