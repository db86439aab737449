// The hash by which reports know points: that of engine/numerics/fingerprint.hpp, which stays inside the engine. The
// tool needs it of points that no call of the engine sees all of; tests/tools/parts/scratch_points.cpp compares the
// two.
#pragma once
#include <cstdint>

namespace netmesh::tool {

class Fingerprint {
public:
    void add(std::uint64_t word) { state_ = mixed(state_ ^ word) + 0x632BE59BD9B4E019u * word; }
    std::uint64_t value() const { return mixed(state_); }

private:
    static std::uint64_t mixed(std::uint64_t x) {
        x += 0x9E3779B97F4A7C15u;
        x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
        return x ^ (x >> 31);
    }
    std::uint64_t state_ = 0x6E65746D65736800u;
};

}  // namespace netmesh::tool
