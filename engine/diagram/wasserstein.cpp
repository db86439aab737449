#include "diagram/wasserstein.hpp"

#include "diagram/transport.hpp"

namespace netmesh {
namespace {

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

// Essential pairs go by birth, which is the least of all sums where costs are convex. False when their numbers differ.
bool match_essential(Markets& work, const WassersteinRequest& request, std::uint32_t degree, const Power& power,
                     Monitor& monitor, Total* total) {
    Market &a = work.side[0], &b = work.side[1];
    const std::uint32_t count = collect_essential(a, degree, monitor);
    if (collect_essential(b, degree, monitor) != count) return false;
    TransportCost cost(power);
    double longest = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i % 256 == 0) monitor.pass(25);
        const double move = cost.difference(a.points[i].at[0], b.points[i].at[0]);
        if (move > longest) longest = move;
        if (request.mates_a != nullptr) request.mates_a[a.points[i].index] = b.points[i].index;
    }
    if (longest == 0) return true;
    cost.set_unit(TransportCost::unit_of(longest));
    PositiveSum sum;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i % 256 == 0) monitor.pass(25 + 4 * power.order());
        sum.add(cost.paid_on_line(a.points[i].at[0], b.points[i].at[0]));
    }
    // Roundings as in Transport::paid_for.
    const double roundings = (2 * power.order() + 10) * unit_roundoff;
    total->add({cost.exponent(), sum.value() * (1 - roundings), sum.value() * (1 + roundings)});
    return true;
}

// The part of one degree, without essential pairs.
Status match_points(Markets& work, const WassersteinRequest& request, std::uint32_t degree, const Power& power,
                    Monitor& monitor, Total* total, int* exponent) {
    // To begin with all go to the diagonal. What is good in the first order is good in others, too, of which costs are
    // so flat that auctions get nearer to the short moves by small steps alone.
    for (Market& m : work.side) {
        collect_points_of(m, degree, monitor);
        for (std::uint32_t i = 0; i < m.tree.count(); ++i) {
            if (i % 256 == 0) monitor.pass(25);
            m.best[i] = none;
        }
    }
    Bounds part;
    if (request.order > 1) {
        const Status status = Transport(work, Power(1), 0.25, monitor).solve(&part);
        if (status != Status::ok) return status;
    }
    Transport transport(work, power, request.relative_error, monitor);
    const Status status = transport.solve(&part);
    if (status != Status::ok) return status;
    total->add(part);
    if (request.degree != NETMESH_ALL_DEGREES) transport.write(request);
    *exponent = transport.exponent();
    return Status::ok;
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
    Total total(power);
    int exponent = 0;
    std::uint64_t from = 0;
    std::uint32_t degree = request.degree;
    const bool all = degree == NETMESH_ALL_DEGREES;
    for (bool more = !all || next_degree(a, b, from, &degree); more; more = all && next_degree(a, b, from, &degree)) {
        if (!match_essential(work, request, degree, power, monitor, &total)) {
            if (monitor.has_stopped()) return Status::cancelled;
            *distance = {sizeof *distance, 0, infinity, infinity};
            return Status::ok;
        }
        const Status status = match_points(work, request, degree, power, monitor, &total, &exponent);
        if (status != Status::ok) return status;
        from = std::uint64_t{degree} + 1;
    }
    if (monitor.has_stopped()) return Status::cancelled;
    if (!total.is_within(request.relative_error)) return Status::internal;
    *distance = total.distance(exponent);
    return Status::ok;
}

}  // namespace netmesh
