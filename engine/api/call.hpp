// How a call begins and how it ends.
#pragma once
#include <cstdint>
#include <type_traits>

#include "api/context.hpp"
#include "api/structs.hpp"
#include "mesh/domain.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// Is this a context? Its arena then has the block's present address.
bool usable(netmesh_context* context);
bool usable(const netmesh_context* context);

// What is wrong with a request: a field and a text; the text is null when nothing is. not_built: nothing but that this
// build leaves it out.
struct Complaint {
    netmesh_field field = NETMESH_FIELD_NONE;
    const char* text = nullptr;
    bool not_built = false;

    Complaint() = default;
    // Not an aggregate: as constants those of all calls would stand in one section of the program on some machines.
    Complaint(netmesh_field at, const char* what, bool left_out = false) : field(at), text(what), not_built(left_out) {}
};

// The ends of a call: what netmesh_get_detail tells, and the status. `text` null: the status's own. fail_and_clear also
// forgets all results.
netmesh_status finish(netmesh_context* context, Status status, const char* text = nullptr, std::uint64_t a = 0,
                      std::uint64_t b = 0);
netmesh_status fail_and_clear(netmesh_context* context, Status status, const char* text = nullptr, std::uint64_t a = 0,
                              std::uint64_t b = 0);
netmesh_status refuse(netmesh_context* context, const Complaint& complaint, std::uint64_t row = 0);
inline netmesh_status refuse(netmesh_context* context, netmesh_field field, const char* text) {
    return refuse(context, Complaint{field, text});
}

// A detail with everything that finish puts into the context's.
netmesh_detail detail_of(Status status, const char* text, std::uint64_t a = 0, std::uint64_t b = 0);

// A static text of this library as the context keeps it, and the text. 0: null.
std::int64_t kept_text(const char* text);
const char* text_kept(std::int64_t from);

// What the last call said.
netmesh_detail kept_detail(const netmesh_context* context);

// Text for what read_struct finds at fault.
Complaint complaint_about_struct(netmesh_field fault);

// What is handed to a function that is not there was meant for one.
constexpr char user_alone[] = "a user without its function; give both";
inline Complaint complaint_about_monitor(const netmesh_monitor& monitor) {
    return monitor.poll == nullptr && monitor.user != nullptr ? Complaint{NETMESH_FIELD_MONITOR, user_alone}
                                                              : Complaint{};
}

// Of a regular triangulation that the context holds, where there is nothing for those.
constexpr char weighted_cells[] = "the triangulation that is there has weights, and this is of points without";

// Begins a call: NETMESH_OK and a copy of the request, or the status to return.
template <class Request>
[[gnu::noinline]] netmesh_status begin(netmesh_context* context, const Request* from, Request* request) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const netmesh_field fault = read_struct(from, request, sizeof *request);
    const Complaint complaint =
        fault == NETMESH_FIELD_NONE ? complaint_about_monitor(request->monitor) : complaint_about_struct(fault);
    return complaint.text == nullptr ? NETMESH_OK : refuse(context, complaint);
}

inline Monitor monitor_of(const netmesh_monitor& monitor) { return Monitor(monitor.poll, monitor.user); }

// For the time of a call the context's arena knows who watches it.
class Watch {
public:
    Watch(Arena& arena, Monitor& monitor) : arena_(arena), monitor_(monitor) { arena.watch(&monitor); }
    ~Watch() { arena_.watch(nullptr); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    // The status of the job so far: a wish to stop may have come where nothing could stop. It says more than that
    // memory ran out behind it, after which a fit would go on.
    Status heed(Status status) const {
        const bool goes_on = status == Status::ok || status == Status::out_of_memory;
        return goes_on && monitor_.has_stopped() ? Status::cancelled : status;
    }

private:
    Arena& arena_;
    const Monitor& monitor_;
};

// Whether an enumeration that came from outside has a value in [least, most]. Callers in C may pass any int, which C++
// must not even read as an enumeration.
template <class E> bool in_range(const E& e, E least, E most) {
    using Value = std::underlying_type_t<E>;
    Value value;
    __builtin_memcpy(&value, &e, sizeof value);
    return value >= static_cast<Value>(least) && value <= static_cast<Value>(most);
}

// Forgets the results of filters: diagram, bounds, vineyard and cycles. The mesh stays.
void clear_diagram(netmesh_context* context);
// Forgets every result.
void clear(netmesh_context* context);

template <int D> Domain<D> domain_of(const KeptMesh& mesh) {
    Domain<D> domain;
    for (int k = 0; k < D; ++k) domain.centre[k] = mesh.centre[k];
    domain.radius = mesh.radius;
    domain.enclosing_radius = mesh.enclosing_radius;
    return domain;
}
inline void keep_domain(const AnyDomain& domain, KeptMesh* mesh) {
    for (int k = 0; k < domain.dim; ++k) mesh->centre[k] = domain.centre[k];
    mesh->radius = domain.radius;
    mesh->enclosing_radius = domain.enclosing_radius;
}

}  // namespace netmesh
