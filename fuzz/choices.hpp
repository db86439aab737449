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

// Weights and a lattice for the points of a request, good ones and bad ones. Each array ends where its last number
// does; it lives as long as this object.
class Extras {
public:
    void weigh(Tape& tape, netmesh_request* request) {
        const std::uint32_t how = tape.byte();
        request->weighting = how & 1 ? &netmesh_radii : &netmesh_weights;
        request->squares = tape.rarely() ? tape.byte() : how >> 1 & 1;
        const bool are_floats = request->points.format == NETMESH_POINTS_FLOAT32;
        are_floats ? place_weights(tape, how, &floats_, request) : place_weights(tape, how, &doubles_, request);
        if (!tape.rarely()) return;
        const std::size_t size = are_floats ? sizeof(float) : sizeof(double);
        switch (tape.below(5)) {
        case 0: request->points.weights = nullptr; break;
        case 1: request->points.weights = shifted(request->points.weights, size / 2); break;
        case 2: request->points.weights = shifted(request->points.weights, 1); break;
        case 3: request->weighting = nullptr; break;
        default: {  // no stride, whatever the numbers are
            const std::size_t strides[] = {size / 2, size + 1, size + size / 2, SIZE_MAX - 1, SIZE_MAX / 16 * 16};
            request->points.weight_stride_bytes = strides[tape.below(5)];
            break;
        }
        }
    }
    void repeat(Tape& tape, netmesh_request* request) {
        const std::uint32_t dim = request->points.dim, count = tape.below(dim + 2), how = tape.byte();
        std::vector<double> all;
        for (std::uint32_t j = 0; j < count; ++j)
            for (std::uint32_t k = 0; k < dim; ++k) {
                const double side = how & 4 ? 8 : 4 + j, small = tape.byte() % 5 - 2.0;
                switch (how % 4) {
                case 0: all.push_back(j == k ? side : 0); break;
                case 1: all.push_back(j == k ? side : small); break;
                case 2: all.push_back(j == k ? 0.7 * side : k < j ? 0.1 * small : 0); break;
                default: all.push_back(j == k && how & 8 ? side : tape.number()); break;
                }
            }
        all.push_back(1);  // behind the last number, where it lies between others
        const bool is_shifted = tape.rarely();
        lattice_ = std::vector<double>(all.begin(), all.end() - (is_shifted ? 0 : 1));  // no spare capacity
        request->points.lattice = lattice_.data();
        request->points.lattice_count = count;
        request->periods = &netmesh_periodic;
        if (is_shifted) {
            const std::size_t by[] = {1, 2, 4};
            request->points.lattice = static_cast<const double*>(shifted(lattice_.data(), by[tape.below(3)]));
        }
        if (!tape.rarely()) return;
        switch (tape.below(3)) {
        case 0: request->points.lattice = nullptr; break;
        case 1: request->periods = nullptr; break;
        default: request->points.lattice_count = 0; break;
        }
    }

private:
    static const void* shifted(const void* from, std::size_t by) { return static_cast<const char*>(from) + by; }
    template <class Number>
    static void place_weights(Tape& tape, std::uint32_t how, std::vector<Number>* numbers, netmesh_request* request) {
        const std::size_t apart = how >> 2 & 3, count = request->points.count;
        const double equal = tape.number();
        std::vector<Number> all;
        for (std::size_t i = 0; i < count; ++i) {
            double number = equal;
            switch (how >> 4 & 3) {
            case 0: number = tape.byte() / 16.0; break;
            case 1: number = tape.number(); break;
            case 2: number = std::nextafter(equal, tape.byte() - 128.0); break;
            default: break;
            }
            if (how & 1 && !tape.rarely()) number = std::fabs(number);
            all.resize(i * (apart > 0 ? apart : 1), std::numeric_limits<Number>::quiet_NaN());
            all.push_back(static_cast<Number>(number));
        }
        all.push_back(1);
        *numbers = std::vector<Number>(all.begin(), all.end() - 1);  // no spare capacity
        request->points.weights = numbers->data();
        request->points.weight_stride_bytes = apart * sizeof(Number);
    }

    std::vector<float> floats_;
    std::vector<double> doubles_, lattice_;
};

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
