#include "tools/session.hpp"

#include <cmath>

#include "platform/interrupt.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

// What a user can get wrong of netmesh_delaunay and netmesh_mesh: the number of points, and an --eps too small for them; of
// netmesh_persist: k.
constexpr std::uint64_t argument_point_count = 3, argument_size = 6, argument_k = 7, argument_scale_size = 8;
constexpr std::size_t least_lazy_bytes = std::size_t{1} << 30;

}  // namespace

std::size_t lazy_bytes(std::size_t plan, std::size_t physical) {
    std::size_t bytes = plan > SIZE_MAX / 64 ? SIZE_MAX : 64 * plan;
    if (bytes < least_lazy_bytes) bytes = least_lazy_bytes;
    return bytes < physical ? bytes : physical;
}

Session::Session(const Options& options, std::uint32_t dim)
    : memory_bytes_(options.memory_bytes), dim_(dim), bar_(!options.quiet) {
    netmesh_options_init(&engine_options_, dim);
    if (options.tau) engine_options_.tau = *options.tau;
    (promises_accuracy(options) ? engine_options_.eps : engine_options_.over_refine_eps) = options.eps;
    engine_options_.theta = options.theta;
    engine_options_.seed = options.seed;
    engine_options_.method = options.method.value_or(NETMESH_METHOD_SVR);
    engine_options_.finish = options.finish ? 1 : 0;
    engine_options_.audit = options.audit;
    engine_options_.k = options.k.value_or(1);
    engine_options_.poll = poll;
    engine_options_.user = this;
    if (refines_by_certificate(options)) {
        set_goal(options.ratio.value_or(options.fit ? 0 : default_ratio()), options.focus, options.from, options.to);
    }
}

double Session::default_ratio() const { return std::sqrt(2 + netmesh_tau(&engine_options_)); }

void Session::set_goal(double ratio, double focus, double from, double to) {
    engine_options_.ratio = ratio;
    engine_options_.focus_ratio = focus;
    engine_options_.focus_from = from;
    engine_options_.focus_to = to;
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
    const netmesh_status status = engine_call();
    clock_.end_call(stage);
    bar_.clear();
    return status;
}

netmesh_report Session::report() const {
    netmesh_report report = {};
    report.struct_bytes = sizeof report;
    netmesh_get_report(context_, &report);
    return report;
}

netmesh_status Session::attempt(std::size_t bytes, const Work& work) {
    context_ = nullptr;
    if (!block_.reserve(bytes)) return NETMESH_OUT_OF_MEMORY;
    const netmesh_status status = netmesh_init(block_.base(), block_.bytes(), &context_);
    if (status != NETMESH_OK) context_ = nullptr;
    return status == NETMESH_OK ? work(*this) : status;
}

Outcome Session::run(netmesh_job job, const PointCloud& cloud, const Work& work) {
    return run_planned(netmesh_plan_bytes(job, &engine_options_, cloud.rows()), cloud, work);
}

Outcome Session::run_planned(std::size_t plan, const PointCloud& cloud, const Work& work) {
    if (memory_bytes_ != 0) return explain(attempt(memory_bytes_, work), cloud, plan);
    const std::size_t physical = platform::physical_memory_bytes();
    std::size_t bytes = lazy_bytes(plan, physical);
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

std::string Session::memory_message(std::size_t plan) const {
    std::string text = "netmesh: ";
    if (block_.base() == nullptr) {
        text += memory_bytes_ == 0 ? "the system refuses to reserve memory"
                                   : "the system refuses to reserve " + std::to_string(memory_bytes_) + " bytes";
    } else {
        text += std::to_string(block_.bytes()) + " bytes of memory are too few";
    }
    const netmesh_detail detail = context_ == nullptr ? netmesh_detail{} : netmesh_get_detail(context_);
    if (last_.stage != NETMESH_STAGE_NONE) {
        text += "; it got to " + grouped_text(last_.done);
        if (last_.total > 0) text += " of " + grouped_text(last_.total);
        text += std::string(" in stage ") + stage_name(last_.stage);
        if (last_.vertices > 0) text += " with " + grouped_text(last_.vertices) + " vertices";
    }
    if (detail.bytes_wanted > 0) text += "; it takes more than " + std::to_string(detail.bytes_wanted - 1) + " bytes";
    if (plan != SIZE_MAX && plan > block_.bytes()) text += "; plan for " + std::to_string(plan) + " bytes";
    return text;
}

Outcome Session::explain(netmesh_status status, const PointCloud& cloud, std::size_t plan) const {
    netmesh_detail detail = context_ == nullptr ? netmesh_detail{} : netmesh_get_detail(context_);
    const std::string said =
        detail.message == nullptr || detail.message[0] == '\0' ? netmesh_status_text(status) : detail.message;
    switch (status) {
    case NETMESH_OK: return {};
    case NETMESH_OUT_OF_MEMORY: return {Exit::memory, memory_message(plan)};
    case NETMESH_CANCELLED: return {Exit::cancelled, "netmesh: cancelled"};
    case NETMESH_NOT_FINITE: return data_error(cloud.where(detail.index_a) + ": a coordinate is not finite");
    case NETMESH_OUT_OF_RANGE:
        return data_error(cloud.where(detail.index_a) +
                          ": outside the range that meshing admits: coordinates up to 2^500 (3.3e150), distances from "
                          "2^-500 (3.1e-151)");
    case NETMESH_INVALID_ARGUMENT:
        if (detail.index_a == argument_point_count || detail.index_a == argument_k)
            return data_error(cloud.name + ": " + said);
        if (detail.index_a == argument_size || detail.index_a == argument_scale_size)
            return data_error(cloud.where(detail.index_b) + ": near this point " + said);
        return {Exit::internal, "netmesh: internal error: " + said};
    case NETMESH_FLAT:
        return {Exit::degenerate, cloud.name + ": flat: fewer than " + std::to_string(dim_ + 1) +
                                      " affinely independent points in dimension " + std::to_string(dim_) +
                                      ", so there is no Delaunay triangulation"};
    case NETMESH_TOO_CLOSE:
        return {Exit::degenerate, cloud.where(detail.index_b) + ": this point and the one of " +
                                      cloud.place(detail.index_a) +
                                      " are distinct but closer than 64 units in the last place"};
    case NETMESH_CHECK_FAILED: return {Exit::check, "netmesh: check failed: " + said};
    default: return {Exit::internal, "netmesh: internal error: " + said};
    }
}

}  // namespace netmesh::tool
