// Two contexts in two threads at once, each with other jobs before and after: the results are those of one thread.
#include <netmesh.hpp>

#include <cstdio>
#include <thread>
#include <vector>

namespace {

std::vector<double> points(std::uint32_t dim, std::size_t n) {
    std::vector<double> p(n * dim);
    std::uint64_t state = dim;
    for (double& x : p) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        x = static_cast<double>(state >> 40);
    }
    return p;
}

// Fingerprints of a series of jobs in one context.
std::vector<std::uint64_t> series(std::uint32_t first_dim, int jobs) {
    std::vector<std::uint64_t> found, memory((std::size_t{32} << 20) / 8 + 2);
    const std::uintptr_t at = reinterpret_cast<std::uintptr_t>(memory.data());
    netmesh::Engine engine(reinterpret_cast<void*>((at + 15) / 16 * 16), std::size_t{32} << 20);
    for (int i = 0; i < jobs; ++i) {
        const std::uint32_t dim = 2 + (first_dim + static_cast<std::uint32_t>(i)) % 3;
        const std::vector<double> p = points(dim, 400 / dim / dim);
        netmesh::Request request(&netmesh_filter_complete);
        request.set_points(dim, p);
        const bool good = engine.persist(request) == NETMESH_OK;
        found.push_back(good ? engine.report().fingerprint : 0);
    }
    return found;
}

}  // namespace

int main() {
    const std::vector<std::uint64_t> one = series(0, 12), other = series(1, 12);
    std::vector<std::uint64_t> one_beside, other_beside;
    std::thread a([&] { one_beside = series(0, 12); }), b([&] { other_beside = series(1, 12); });
    a.join();
    b.join();
    for (std::uint64_t fingerprint : one)
        if (fingerprint == 0) return 1;
    if (one_beside != one || other_beside != other) return 2;
    std::printf("%zu results beside each other equal\n", one.size() + other.size());
    return 0;
}
