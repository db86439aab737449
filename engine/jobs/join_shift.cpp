#include "jobs/join_shift.hpp"

#include "certificate/rounding.hpp"
#include "numerics/sort.hpp"

namespace netmesh {

bool JoinShift::add(double radius, double gap, Arena& arena) {
    static_assert(sizeof(Cluster) == Arena::alignment, "one after the other without a gap");
    Cluster* const cluster = arena.take_high<Cluster>(1);
    if (cluster == nullptr) return false;
    const double most = radius * up;
    *cluster = {(0.5 * gap * down - most) * down, most};
    clusters_ = cluster;
    ++count_;
    return true;
}

void JoinShift::close() {
    sort(clusters_, count_,
         [](const Cluster& a, const Cluster& b) { return a.from != b.from ? a.from < b.from : a.radius > b.radius; });
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < count_; ++i)
        if (kept == 0 || clusters_[i].radius > clusters_[kept - 1].radius) clusters_[kept++] = clusters_[i];
    count_ = kept;
}

std::uint32_t JoinShift::until(double x) const {
    std::uint32_t first = 0, last = count_;
    while (first < last) {
        const std::uint32_t middle = first + (last - first) / 2;
        if (clusters_[middle].from <= x) {
            first = middle + 1;
        } else {
            last = middle;
        }
    }
    return first;
}

double JoinShift::after(double a) const {
    const std::uint32_t n = until(a);
    return n == 0 ? a : (a + clusters_[n - 1].radius) * up;
}

// The least of y and all max(s_j, y - r_j): s_j ascends and y - r_j descends.
double JoinShift::before(double y) const {
    std::uint32_t first = 0, last = count_;
    while (first < last) {
        const std::uint32_t middle = first + (last - first) / 2;
        if (clusters_[middle].from < y - clusters_[middle].radius) {
            first = middle + 1;
        } else {
            last = middle;
        }
    }
    double least = y;
    if (first > 0 && (y - clusters_[first - 1].radius) * down < least) least = (y - clusters_[first - 1].radius) * down;
    if (first < count_ && clusters_[first].from < least) least = clusters_[first].from;
    return least;
}

// Where before(y) stands still the quotient grows, elsewhere it falls: it is largest at an end or where it begins to
// fall, at s_j + r_j.
double JoinShift::factor(double from, double to) const {
    double most = 1;
    const auto consider = [&](double y) {
        const double f = y / before(y) * up;
        if (before(y) < y && f > most) most = f;
    };
    consider(from);
    if (to < infinity) consider(to);
    for (std::uint32_t i = until(to); i-- > 0;) {
        const double top = clusters_[i].from + clusters_[i].radius;
        if (top < from) break;
        if (top < to) consider(top);
    }
    return most;
}

}  // namespace netmesh
