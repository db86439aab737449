// What a fuzzer's bytes choose of requests, and requests as a caller hands them over: in memory of exactly the size
// that their struct_bytes say, so that AddressSanitizer sees every access behind it.
#pragma once
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "fuzz/decoder.hpp"
#include "netmesh.hpp"

namespace fuzz {

// A job of a fuzzer may not take long: so many polls, then it is cancelled. `user` is null where a request ends before
// it.
inline int poll_budget(void* user, const netmesh_progress* progress) {
    require(progress->stage <= NETMESH_STAGE_COUNT);
    int* const left = static_cast<int*>(user);
    return left == nullptr || --*left < 0;
}

struct Well {
    int kind;
};
inline int kind_of(const void* user) { return user == nullptr ? 0 : static_cast<const Well*>(user)->kind; }
inline double size_of(void* user, const double* x) {
    const double r = std::fabs(x[0]) + std::fabs(x[1]);
    switch (kind_of(user)) {
    case 0: return 1 + r / 8;
    case 1: return std::numeric_limits<double>::infinity();
    case 2: return 0;
    case 3: return std::numeric_limits<double>::quiet_NaN();
    default: return x[0];
    }
}
inline double function_of(void* user, const double* x) {
    const double r = std::fabs(x[0]) + std::fabs(x[1]);
    switch (kind_of(user)) {
    case 0: return r / 2;
    case 1: return 1;
    case 2: return -1;
    case 3: return std::numeric_limits<double>::quiet_NaN();
    default: return r > 2 ? std::numeric_limits<double>::infinity() : 0;
    }
}

// What the bytes choose of a request beside its source and its filter.
struct Choices {
    std::uint32_t dim;
    netmesh_monitor monitor;
    std::uint32_t struct_bytes = 0;  // wanted of the request when sets_bytes
    bool sets_bytes = false;
    std::uint32_t k = 0;
    std::uint64_t seed = 1;
    netmesh_goal goal = {};
    netmesh_mesh_rules mesh = {};

    // Mostly none; otherwise one. *dim: of this call, and of all that follow if the bytes say so.
    static Choices read(Tape& tape, std::uint32_t* dim, int* polls_left, Well* well);

    // Without a source.
    netmesh::Request request(const netmesh_filter* filter) const {
        netmesh::Request r(filter);
        r.monitor = monitor;
        r.seed = seed;
        r.k = k;
        return r;
    }
    // With all that is said of meshes.
    netmesh::Request mesh_request(const netmesh_filter* filter) const {
        netmesh::Request r = request(filter);
        r.points.dim = dim;
        r.goal = goal;
        r.mesh = mesh;
        return r;
    }
};

inline void read_goal(Tape& tape, netmesh_goal* goal) {
    goal->ratio = 2 + tape.byte() / 64.0;
    goal->focus_ratio = goal->ratio - tape.byte() / 256.0;
    goal->focus_from = std::ldexp(1.0, static_cast<int>(tape.below(16)) - 8);
    goal->focus_to = goal->focus_from * (1 + tape.byte() / 16.0);
}

inline Choices Choices::read(Tape& tape, std::uint32_t* dim, int* polls_left, Well* well) {
    *polls_left = 1;
    well->kind = 0;
    Choices c = {};
    c.seed = 1;
    c.dim = *dim;
    c.monitor = {poll_budget, polls_left};
    if (tape.below(4) != 0) return c;
    switch (tape.below(18)) {
    case 0: c.dim = *dim = 2 + tape.below(5); break;
    case 1: c.dim = tape.byte(); break;
    case 2:
        c.struct_bytes = tape.byte();
        c.sets_bytes = true;
        break;
    case 3: c.mesh.tau = tape.number(); break;
    case 4: c.mesh.domain_factor = tape.number(); break;
    case 5: c.goal.eps = tape.number(); break;
    case 6: c.goal.theta = tape.number(); break;
    case 7: c.k = tape.byte(); break;
    case 8: *polls_left = 0; break;
    case 9: {
        const std::uint32_t choice = tape.below(9);
        c.mesh.finish = choice % 3;
        if (choice / 3 == 1) c.mesh.method = &netmesh_method_thesis, c.mesh.tau = 6;
        break;
    }
    case 10: c.mesh.sizes.eps = tape.number(); break;
    case 11:
        c.mesh.sizes.size = size_of;
        c.mesh.sizes.user = well;
        well->kind = static_cast<int>(tape.below(5));
        break;
    case 12: c.seed = tape.byte(); break;
    case 13: c.mesh.tau = 2 + tape.byte() / 64.0; break;
    case 14:
        c.goal.ratio = 1.75 + tape.byte() / 64.0;
        c.mesh.whole_cells = tape.byte() & 1;
        break;
    case 15: read_goal(tape, &c.goal); break;
    case 16: c.mesh.audit = tape.below(5); break;
    default: {
        double& ratio = tape.byte() & 1 ? c.goal.ratio : c.goal.focus_ratio;
        ratio = tape.number();
        double& end = tape.byte() & 1 ? c.goal.focus_from : c.goal.focus_to;
        end = tape.number();
        break;
    }
    }
    return c;
}

// Structs handed over by one call.
class Handed {
public:
    // A copy of a struct with so many bytes, zeros behind those that the struct has.
    template <class Struct> Struct* over(const Struct& from, std::uint32_t bytes = sizeof(Struct)) {
        void* const copy = std::calloc(1, bytes < sizeof bytes ? sizeof bytes : bytes);
        require(copy != nullptr);
        copies_.emplace_back(copy);
        std::memcpy(copy, &from, bytes < sizeof from ? bytes : sizeof from);
        std::memcpy(copy, &bytes, sizeof bytes);
        return static_cast<Struct*>(copy);
    }
    // As many bytes as the choices say; no caller's struct ends within a pointer.
    template <class Request> const Request* over(const Request& from, const Choices& choices) {
        return over(from, choices.sets_bytes ? choices.struct_bytes / 8 * 8 : static_cast<std::uint32_t>(sizeof from));
    }
    void clear() { copies_.clear(); }

private:
    struct Free {
        void operator()(void* p) const { std::free(p); }
    };
    std::vector<std::unique_ptr<void, Free>> copies_;
};

}  // namespace fuzz
