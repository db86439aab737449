#include <algorithm>

#include "quality.hpp"

namespace referee {
namespace {

// Room for the few roundings of a sampled ratio.
constexpr double sampling_room = 1 + 1e-9;

class Sampler {
public:
    Sampler(const Mesh& mesh, const Hierarchy& hierarchy, Verdict* verdict)
        : mesh_(mesh), hierarchy_(hierarchy), verdict_(verdict), tau_(promised_tau(mesh)), nearest_(mesh.count(), 0) {}

    // x is in the ball of `domain`.
    void look_at(const Point& x, int domain) {
        std::uint32_t v = 0;
        double least = INFINITY;
        for (std::uint32_t u = 0; u < mesh_.count(); u++) {
            const double d2 = distance2(mesh_.vertices[u], x);
            if (d2 < least) {
                least = d2;
                v = u;
            }
        }
        if (mesh_.markers[v] == exempt_marker || stands_in_shell(mesh_, hierarchy_, v)) return;
        if (hierarchy_.domain[v] == domain || mesh_.thesis_cages) compare(v, std::sqrt(least));
    }

    // From v to where the ray leaves its clipped cell.
    void follow(std::uint32_t v, const Point& direction) {
        const int domain = hierarchy_.domain[v];
        const Point& x = mesh_.vertices[v];
        double along = 0, from2 = 0;
        const Point& centre = clip_centre(mesh_, domain);
        const double radius = clip_radius(mesh_, domain);
        for (int k = 0; k < mesh_.dim; k++) {
            along += direction[k] * (centre[k] - x[k]);
            from2 += (centre[k] - x[k]) * (centre[k] - x[k]);
        }
        if (from2 >= radius * radius) return;
        // A little inside of the sphere, whatever is lost in the difference of squares.
        double t = along + std::sqrt(along * along + (radius * radius - from2)) - 1e-7 * radius;
        for (std::uint32_t u = 0; u < mesh_.count() && t > 0; u++) {
            double slope = 0, length2 = 0;
            for (int k = 0; k < mesh_.dim; k++) {
                const double a = mesh_.vertices[u][k] - x[k];
                slope += a * direction[k];
                length2 += a * a;
            }
            if (slope > 0 && length2 < 2 * slope * t) t = length2 / (2 * slope);
        }
        if (t > 0) compare(v, t);
    }

private:
    double distance2(const Point& a, const Point& b) const {
        double sum = 0;
        for (int k = 0; k < mesh_.dim; k++) sum += (a[k] - b[k]) * (a[k] - b[k]);
        return sum;
    }
    double in_radius(std::uint32_t v) {
        if (nearest_[v] == 0) {
            double least = INFINITY;
            for (std::uint32_t u = 0; u < mesh_.count(); u++)
                if (u != v) least = std::min(least, distance2(mesh_.vertices[u], mesh_.vertices[v]));
            nearest_[v] = std::sqrt(least);
        }
        return 0.5 * nearest_[v];
    }
    void compare(std::uint32_t v, double reached) {
        const double ratio = reached / in_radius(v);
        verdict_->sampled_ratio = std::max(verdict_->sampled_ratio, ratio);
        if (ratio > tau_ * sampling_room)
            verdict_->add("quality",
                          "a sampled point of vertex " + count_text(v) + " has the ratio " + number_text(ratio));
    }

    const Mesh& mesh_;
    const Hierarchy& hierarchy_;
    Verdict* verdict_;
    double tau_;
    std::vector<double> nearest_;
};

}  // namespace

void sample_quality(const Mesh& mesh, const Hierarchy& hierarchy, std::size_t samples, Random& random,
                    Verdict* verdict) {
    Sampler sampler(mesh, hierarchy, verdict);
    std::vector<std::uint32_t> asked;
    for (std::uint32_t v = 0; v < mesh.count(); v++)
        if (mesh.markers[v] != exempt_marker && !stands_in_shell(mesh, hierarchy, v)) asked.push_back(v);
    for (std::size_t s = 0; s < samples && !asked.empty(); s++) {
        const Point direction = random.direction(mesh.dim);
        if (s % 2 == 0) {
            sampler.follow(asked[random.below(asked.size())], direction);
            continue;
        }
        const int domain = static_cast<int>(random.below(mesh.cages.size() + 1)) - 1;
        const bool whole = mesh.thesis_cages && domain != no_cage;
        const double radius = whole ? mesh.cages[static_cast<std::size_t>(domain)].radius : clip_radius(mesh, domain);
        const double length = radius * std::pow(random.unit(), 1.0 / mesh.dim);
        Point x = clip_centre(mesh, domain);
        for (int k = 0; k < mesh.dim; k++) x[k] += length * direction[k];
        sampler.look_at(x, domain);
    }
}

}  // namespace referee
