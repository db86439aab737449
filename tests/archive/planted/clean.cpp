// No fault: every check passes. Calls memcpy, polls through the monitor, keeps a constant table.
#include <cstddef>

#include "vocabulary/monitor.cpp"  // the poll is called there

extern "C" void* memcpy(void*, const void*, std::size_t);

namespace netmesh {
namespace {
const double weights[4] = {1.0, 0.5, 0.25, 0.125};
}
template <int D> double weigh(const double* p) {
    double copy[D];
    memcpy(copy, p, sizeof copy);
    double sum = 0.0;
    for (int i = 0; i < D; ++i) sum += copy[i] * weights[i & 3];
    return sum;
}
template double weigh<2>(const double*);
template double weigh<6>(const double*);
}  // namespace netmesh

extern "C" double netmesh_clean(const double* p, int dim, netmesh_poll poll, void* user) {
    netmesh::Monitor monitor(poll, user);
    if (monitor.advance(1, 200000)) return 0.0;
    return dim == 2 ? netmesh::weigh<2>(p) : netmesh::weigh<6>(p);
}
