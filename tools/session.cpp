#include "tools/session.hpp"

#include <algorithm>

#include "platform/interrupt.hpp"
#include "tools/io/numbers.hpp"
#include "tools/memory_advice.hpp"
#include "tools/requests.hpp"

namespace netmesh::tool {

namespace {

constexpr std::size_t least_lazy_bytes = std::size_t{1} << 30;

}  // namespace

std::size_t lazy_bytes(std::size_t plan, std::size_t physical) {
    std::size_t bytes = plan > SIZE_MAX / 64 ? SIZE_MAX : 64 * plan;
    if (bytes < least_lazy_bytes) bytes = least_lazy_bytes;
    return bytes < physical ? bytes : physical;
}

// A request that is refused goes to the engine as it is, which says why.
Session::Session(const Options& options, std::uint32_t dim, platform::Reservation* block)
    : options_(options), dim_(dim), block_(block != nullptr ? *block : own_block_), function_(options),
      bar_(!options.quiet) {
    settle(options, dim, &request_);
    promise_ = promised(request_);
}

netmesh_request Session::promise() const {
    netmesh_request promise = promise_;
    promise.function = function_.for_sizes();
    return promise;
}

int Session::poll(void* self, const netmesh_progress* progress) {
    Session& session = *static_cast<Session*>(self);
    session.clock_.pass(progress->stage);
    session.bar_.show(*progress);
    session.last_ = *progress;
    return platform::interrupted() ? 1 : 0;
}

netmesh_status Session::call(netmesh_stage stage, const std::function<netmesh_status()>& engine_call) {
    if (platform::interrupted()) return NETMESH_CANCELLED;
    clock_.begin_call();
    report_.reset();
    const netmesh_status status = engine_call();
    clock_.end_call(stage);
    bar_.clear();
    return status;
}

const netmesh_report& Session::report() const {
    if (!report_) report_ = engine_.report();
    return *report_;
}

netmesh_status Session::attempt(std::size_t bytes, const Work& work) {
    engine_ = Engine(nullptr, 0);
    report_.reset();
    if (!block_.reserve(bytes)) return NETMESH_OUT_OF_MEMORY;
    engine_ = Engine(block_.base(), block_.bytes());
    return engine_.status() == NETMESH_OK ? work(*this) : engine_.status();
}

Outcome Session::run(std::size_t plan, const PointCloud& cloud, const Work& work) {
    if (options_.memory_bytes != 0) return explain(attempt(options_.memory_bytes, work), cloud, plan);
    const std::size_t physical = platform::physical_memory_bytes();
    std::size_t bytes = std::max(lazy_bytes(plan, physical), block_.bytes());
    while (!block_.reserve(bytes)) {  // a limit on address space, or strict accounting
        if (bytes < least_lazy_bytes / 64) return explain(NETMESH_OUT_OF_MEMORY, cloud, plan);
        bytes /= 2;
    }
    netmesh_status status = attempt(bytes, work);
    while (status == NETMESH_OUT_OF_MEMORY && bytes < physical) {
        bytes = bytes > physical / 4 ? physical : 4 * bytes;
        const netmesh_status again = attempt(bytes, work);
        if (block_.base() == nullptr) break;  // refused: what the smaller block said stands
        status = again;
    }
    return explain(status, cloud, plan);
}

std::string Session::memory_message(const PointCloud& cloud, std::size_t plan) const {
    std::string text = "netmesh: ";
    if (block_.base() == nullptr) {
        text += options_.memory_bytes == 0 ? "the system refuses to reserve memory"
                                           : "the system refuses to reserve " + bytes_text(options_.memory_bytes);
    } else {
        text += bytes_text(block_.bytes()) + " of memory are too few";
    }
    const std::uint64_t wanted = engine_.detail().bytes_wanted;
    if (last_.stage != NETMESH_STAGE_NONE) {
        text += "; it got to " + grouped_text(last_.done);
        if (last_.total > 0) text += " of " + grouped_text(last_.total);
        text += std::string(" in stage ") + stage_name(last_.stage);
        if (last_.vertices > 0) text += " with " + counted(last_.vertices, "vertex", "vertices");
    }
    if (wanted > 0) text += "; it takes more than " + bytes_text(wanted - 1);
    if (plan != SIZE_MAX && plan > block_.bytes()) {
        text += "; plan for " + bytes_text_up(plan) + ": --memory " + memory_option_text(plan);
    } else if (options_.memory_bytes != 0 && options_.memory_bytes < SIZE_MAX / 2) {
        const std::size_t next = std::max<std::size_t>(2 * options_.memory_bytes, wanted);
        text += ", more than is planned for such a number of points: try --memory " + memory_option_text(next);
    }
    const std::string advice = memory_advice(options_, cloud.dim, cloud.rows(), block_.bytes());
    return advice.empty() ? text : text + "; or " + advice;
}

// What the points do not allow is bad data; what no points would, bad usage.
Outcome Session::explain_argument(const netmesh_detail& detail, const PointCloud& cloud,
                                  const std::string& said) const {
    const std::string option = option_of(options_, detail.field);
    switch (detail.field) {
    case NETMESH_FIELD_DIM:  // of a library built without it: the tool itself takes 2..6 only
        return file_error(cloud.name, "dimension " + std::to_string(dim_) + ": " + said);
    case NETMESH_FIELD_POINT_COUNT: return file_error(cloud.name, said);
    case NETMESH_FIELD_LATTICE:
        return usage_error(option + ": vector " + std::to_string(detail.index_a + 1) + ": " + said);
    case NETMESH_FIELD_NET_SPACING:
    case NETMESH_FIELD_TAU:
    case NETMESH_FIELD_K:
    case NETMESH_FIELD_K_LAST: return file_error(cloud.name, option + ": " + said);
    case NETMESH_FIELD_WEIGHTS: return cloud.fault(detail.index_a, said);
    case NETMESH_FIELD_ERROR:
    case NETMESH_FIELD_SIZES:
    case NETMESH_FIELD_SIZE_AT_INPUTS: return cloud.fault(detail.index_a, option + ": near this point " + said);
    default: break;
    }
    return option.empty() ? Outcome{Exit::internal, "netmesh: internal error: " + said}
                          : usage_error(option + ": " + said);
}

Outcome Session::explain(netmesh_status status, const PointCloud& cloud, std::size_t plan) const {
    const netmesh_detail detail = engine_.detail();
    const std::string said =
        detail.message == nullptr || detail.message[0] == '\0' ? netmesh_status_text(status) : detail.message;
    switch (status) {
    case NETMESH_OK: return {};
    case NETMESH_OUT_OF_MEMORY: return {Exit::memory, memory_message(cloud, plan)};
    case NETMESH_CANCELLED: return {Exit::cancelled, "netmesh: cancelled"};
    case NETMESH_NOT_FINITE:
        if (said.rfind("the function", 0) == 0)
            return usage_error(option_of(options_, NETMESH_FIELD_FUNCTION) + ": not finite at a vertex of the mesh");
        return cloud.fault(detail.index_a, "a coordinate is not finite");
    case NETMESH_OUT_OF_RANGE:
        if (cloud.lattice.kind != Lattice::none)
            return cloud.fault(detail.index_a,
                               "this point is 2^50 periods away, or so far beside the lattice that its copies "
                               "have no digits left, or coordinates are too far apart in size for an exact alpha "
                               "complex; any copy of a point can stand in its place");
        if (filter_of(options_) == NETMESH_FILTER_ALPHA)
            return file_error(cloud.name, "coordinates too far apart in size for an exact alpha complex: it has room "
                                          "for 2^2075 units in space, 2^1185 in R^6");
        return cloud.fault(detail.index_a,
                           "outside the range that meshing admits: coordinates up to 2^500 (3.3e150), distances from "
                           "2^-500 (3.1e-151)");
    case NETMESH_NOT_BUILT:
    case NETMESH_INVALID_ARGUMENT: return explain_argument(detail, cloud, said);
    case NETMESH_FLAT: {
        const std::string constant = cloud.constant_coordinate();
        if (cloud.lattice.kind != Lattice::none)
            return file_error(cloud.name,
                              "flat with all copies: in directions without a period points have to differ; leave "
                              "those coordinates out of points and lattice",
                              Exit::degenerate);
        return file_error(cloud.name,
                          "flat: fewer than " + std::to_string(dim_ + 1) +
                              " affinely independent points in dimension " + std::to_string(dim_) +
                              ", so there is no Delaunay triangulation; " +
                              (!constant.empty()       ? constant
                               : cloud.weights.empty() ? "persist --filter cech takes few points as they are"
                                                       : "there is no other filter of balls"),
                          Exit::degenerate);
    }
    case NETMESH_TOO_CLOSE:
        return cloud.fault(
            detail.index_b,
            "this point and the one of " + cloud.place(detail.index_a) +
                " are distinct but closer than coordinates resolve for this mesh: 64 units in the "
                "last place, more when tau is near 2 or the ratio below 2; persist --filter alpha makes no mesh and "
                "takes any points",
            Exit::degenerate);
    case NETMESH_CHECK_FAILED: return {Exit::check, "netmesh: check failed: " + said};
    default: return {Exit::internal, "netmesh: internal error: " + said};
    }
}

}  // namespace netmesh::tool
