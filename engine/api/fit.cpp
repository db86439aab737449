// Budget mode: the best certified diagram that fits in the block.
#include "jobs/fit.hpp"
#include "api/items.hpp"
#include "api/measure.hpp"
#include "api/requests.hpp"
#include "certificate/rounding.hpp"
#include "filtration/filters.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

constexpr double coarsest_ratio = 4;

// The largest sqrt(hi / lo) of Steiner cells that matter to the scales of interest: hi > from and lo < to.
Status measure_focus(Context& context, const netmesh_fit_request& request, const FilterRequest& filter, double* ratio) {
    const ArenaScope scope(context.arena);
    AnyMesh mesh = filtered_mesh_of(context);
    const std::uint32_t count = mesh.vertices();
    Evaluation cells = {context.arena.take_high<double>(count), context.arena.take_high<Interval>(count)};
    if (cells.value == nullptr || cells.interval == nullptr) return Status::out_of_memory;
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context.arena, monitor);
    const Work work = {context.arena, monitor};
    Status status = clip_cells(filter, work, &mesh);
    if (status == Status::ok) status = evaluate(mesh, filter, work, &cells);
    double widest = 1;
    for (VertexId v(0); v < count && status == Status::ok;)
        for (const std::uint64_t piece = context.arena.piece(v, count, 15); v < piece && status == Status::ok; ++v) {
            const Interval i = cells.interval[v];
            if (mesh.store.vertex(v).marker != Marker::steiner ||
                !(i.hi > request.focus_from && i.lo < request.focus_to))
                continue;
            if (!(i.hi / i.lo <= widest)) widest = i.hi / i.lo;
        }
    *ratio = widest > 1 ? square_root(widest) * up : 1;
    return watch.heed(status);
}

// Mesh, diagram and bounds of one goal, in place of what the context held.
class FitRun {
public:
    FitRun(netmesh_context* context, const netmesh_fit_request& request, const FilterRequest& filter)
        : context_(context), request_(request), filter_(filter) {}

    // By the error: 0 for none.
    Status make(double error, Climbed* climbed) const {
        Sizes sizes = {filter_.function, error};
        netmesh_mesh_request asked = mesh_request();
        if (error > 0) asked.sizes = {0, Sizes::at, &sizes};
        const Status status = mesh_and_persist(asked);
        if (status != Status::ok) return status;
        climbed->certified = climbed->reached = context_->diagram.certified_error;
        context_->diagram.fitted_error = error;
        return ended(request_.bounds != 0 ? static_cast<Status>(bound()) : Status::ok);
    }
    Status make(const RatioGoal& goal, Climbed* climbed) const {
        const bool focused = request_.focus_to > 0;
        const Status status = mesh_and_persist(mesh_request(goal));
        if (status != Status::ok) return status;
        KeptDiagram& diagram = context_->diagram;
        climbed->certified = diagram.certified_ratio;
        if (focused) {
            const Status measured = measure_focus(*context_, request_, filter_, &climbed->certified);
            if (measured != Status::ok) return static_cast<Status>(finish(context_, measured));
            diagram.certified_focus = climbed->certified;
        }
        // The mesh is refined for the complete filter's ratio; what it certifies for others is no matter of the ladder.
        const bool is_laddered =
            find_filter(filter_.filter)->has(filter_trait::has_goal) && filter_.values == FilterValues::certified;
        climbed->reached = is_laddered ? climbed->certified : infinity;
        return ended(request_.bounds != 0 ? static_cast<Status>(bound()) : Status::ok);
    }

    // The same with bounds, and what they decide of bars longer than the request says.
    Status make_bounded(const RatioGoal& goal, Decided* decided) const {
        Status status = mesh_and_persist(mesh_request(goal));
        if (status == Status::ok) status = ended(static_cast<Status>(bound()));
        if (status != Status::ok) return status;
        context_->bounds.longer_than = request_.longer_than;
        const DecisionView view = decision_of(context_);
        decided->reach = undecided_reach(view);
        decided->from = decided_from(view);
        decided->top = context_->mesh.enclosing_radius;
        for (std::uint64_t i = 0; i < view.bars; ++i) decided->certain += view.bounds[i].certain;
        return Status::ok;
    }

private:
    // What a caller's size function would be.
    struct Sizes {
        const netmesh_function* function;
        double error;
        static double at(void* self, const double* x) {
            const Sizes& sizes = *static_cast<const Sizes*>(self);
            return netmesh_size_for_error(sizes.function, sizes.error, x);
        }
    };

    Status mesh_and_persist(const netmesh_mesh_request& asked) const {
        netmesh_status status = netmesh_mesh(context_, &asked);
        if (status == NETMESH_OK) status = persist();
        return static_cast<Status>(status);
    }
    // Ends what has been made: it stays only if netmesh_check, which takes more than a diagram does, has room in the
    // block. Of a vertex: value, interval, limit of its cell; of a cell: whether it is in the ball, and its faces; of
    // an input of a mesh that promises a tau: its place in the well-paced order; and the largest star, corner by
    // corner, as laboratory/fat_cell.cpp and the fatness of clipped cells take it (at most so much was seen). What is
    // left out are the boxes of laboratory/feature_integral.cpp, 2,200 of 8 D + 1 bytes, which meshes by an error alone
    // are checked with: small blocks would fit no function.
    Status ended(Status status) const {
        if (status != Status::ok) return status;
        Monitor monitor = monitor_of(request_.monitor);
        const Watch watch(context_->arena, monitor);
        constexpr std::size_t vertex_bytes = 3 * sizeof(double) + sizeof(Interval), cell_bytes = 2, input_bytes = 72,
                              fixed = 4096;
        const StoreState& mesh = context_->mesh.store;
        const std::size_t d = request_.dim, corner_bytes = 2 * d * (13 + 24 * d);
        const std::size_t inputs = context_->mesh.tau > 0 ? context_->input.distinct : 0;
        const std::size_t needed = mesh.vertex_count * vertex_bytes + mesh.cell_slots * cell_bytes +
                                   inputs * input_bytes + largest_star() * corner_bytes + fixed;
        if (monitor.has_stopped()) return static_cast<Status>(finish(context_, Status::cancelled));
        // Taken and given back, so that it counts as what the call uses: in a block of that size it fits.
        const ArenaScope scope(context_->arena);
        if (context_->arena.take_low<unsigned char>(needed) != nullptr) return status;
        return static_cast<Status>(finish(context_, Status::out_of_memory));
    }
    // Most cells at a vertex; 0 where there is no room to count them, or for a check.
    std::size_t largest_star() const {
        Arena& arena = context_->arena;
        const ArenaScope scope(arena);
        const std::uint32_t vertices = context_->mesh.store.vertex_count;
        std::uint32_t* const cells_at = arena.take_low<std::uint32_t>(vertices);
        if (cells_at == nullptr) return 0;
        arena.each(vertices, 2, [&](std::uint64_t v) { cells_at[v] = 0; });
        std::uint32_t most = 0;
        const AnyStore store = store_of(*context_);
        arena.each(store.state.cell_slots, 10 * request_.dim, [&](std::uint64_t c) {
            for (const VertexId v : store.cell(static_cast<std::uint32_t>(c)).vertex)
                if (++cells_at[v] > most) most = cells_at[v];
        });
        return most;
    }
    netmesh_mesh_request mesh_request() const {
        netmesh_mesh_request asked;
        netmesh_mesh_request_init(&asked, sizeof asked, request_.dim);
        asked.monitor = request_.monitor;
        asked.points = request_.points;
        asked.point_format = request_.point_format;
        asked.point_stride_bytes = request_.point_stride_bytes;
        asked.point_count = request_.point_count;
        asked.seed = request_.seed;
        asked.purpose = NETMESH_PURPOSE_PERSIST;
        return asked;
    }
    netmesh_mesh_request mesh_request(const RatioGoal& goal) const {
        netmesh_mesh_request asked = mesh_request();
        asked.certificate = {goal.ratio, goal.focus, goal.from, goal.to};
        asked.whole_cells = request_.whole_cells != 0 || !find_filter(filter_.filter)->has(filter_trait::clips_cells);
        return asked;
    }
    netmesh_status persist() const {
        netmesh_persist_request asked;
        netmesh_persist_request_init(&asked, sizeof asked);
        asked.filter = filter_.filter;
        asked.monitor = request_.monitor;
        asked.values = request_.values;
        asked.k = filter_.k;
        asked.max_degree = request_.max_degree;
        asked.keep_zero_pairs = request_.keep_zero_pairs;
        asked.function = request_.function;
        return netmesh_persist(context_, &asked);
    }
    netmesh_status bound() const {
        netmesh_bounds_request asked;
        netmesh_bounds_request_init(&asked, sizeof asked);
        asked.monitor = request_.monitor;
        asked.function = request_.function;
        return netmesh_bound_bars(context_, &asked);
    }

    netmesh_context* context_;
    const netmesh_fit_request& request_;
    const FilterRequest filter_;
};

Complaint complaint_about_fit(const netmesh_fit_request& request) {
    const Complaint complaint = complaint_about_points(request);
    if (complaint.text != nullptr) return complaint;
    if (request.ratio != 0 && !is_valid_ratio(request.ratio))
        return {NETMESH_FIELD_RATIO, "ratio is not a finite number above the root of 2"};
    const bool focused = request.focus_from != 0 || request.focus_to != 0;
    if (request.by_error != 0 && request.ratio != 0) return {NETMESH_FIELD_RATIO, "by_error does not go with a ratio"};
    if (request.by_error != 0 && focused)
        return {NETMESH_FIELD_FOCUS_FROM, "by_error does not go with scales of interest"};
    if (request.longer_than != 0) {
        if (!(request.longer_than > 1 && is_finite(request.longer_than)))
            return {NETMESH_FIELD_LONGER_THAN, "longer_than is not a finite number above 1"};
        if (focused) return {NETMESH_FIELD_FOCUS_FROM, "with longer_than scales of interest are chosen, not given"};
    }
    return focused ? complaint_about_focus(request.focus_from, request.focus_to) : Complaint{};
}

// `function` is what the filter's function is copied to.
Complaint read_filter(const netmesh_fit_request& request, FilterRequest* filter, netmesh_function* function) {
    constexpr netmesh_filter none = NETMESH_FILTER_NONE;  // of callers whose struct has no filter yet
    const bool is_given = __builtin_memcmp(&request.filter, &none, sizeof none) != 0;
    const Filter* const row = is_given ? find_filter(request.filter) : find_filter(NETMESH_FILTER_COMPLETE);
    if (row == nullptr || row->source != FilterSource::mesh) return {NETMESH_FIELD_FILTER, "not a filter on a mesh"};
    const Complaint complaint = complaint_about_values(request.values);
    if (complaint.text != nullptr) return complaint;
    const std::uint32_t k = request.k > 1 ? request.k : 1;
    *filter = {row->id, values_of(request.values), row->has(filter_trait::needs_k) ? k : 0, function};
    if (request.longer_than != 0 && (!row->has(filter_trait::has_goal) || filter->values != FilterValues::certified))
        return {NETMESH_FIELD_FILTER, "longer_than is for the complete filter with certified values"};
    if (filter->k > request.point_count) return {NETMESH_FIELD_K, "k is more than the number of points"};
    if (request.by_error != 0 && !row->has(filter_trait::needs_function))
        return {NETMESH_FIELD_FILTER, "by_error is of the filter by a function"};
    if (row->has(filter_trait::needs_function)) {
        const Complaint about_function = read_function(request.function, function);
        if (about_function.text != nullptr) return about_function;
    }
    if (request.by_error == 0 && !built::certificate)
        return {NETMESH_FIELD_RATIO, "left out of this build: NETMESH_WITH_CERTIFICATE", true};
    if (request.by_error != 0 && !built::sizes)
        return {NETMESH_FIELD_FUNCTION, "left out of this build: NETMESH_WITH_SIZES", true};
    return complaint_about_built_filter(row->id, k);
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_fit(netmesh_context* context, const netmesh_fit_request* from) {
    netmesh_fit_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about_fit(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    netmesh_function function = {};
    FilterRequest filter;
    const Complaint about_filter = read_filter(request, &filter, &function);
    if (about_filter.text != nullptr) return refuse(context, about_filter);
    const FitRun run(context, request, filter);
    const double coarsest = request.ratio != 0 ? request.ratio : coarsest_ratio;
    Status status;
    // Of all tries: each begins with an arena anew. Where one runs out of memory the result is the block's.
    std::size_t peak = 0;
    bool is_limited = false;
    const auto noted = [&](Status tried) {
        if (context->arena.bytes_peak() > peak) peak = context->arena.bytes_peak();
        is_limited |= tried == Status::out_of_memory;
        return tried;
    };
    if (request.by_error != 0) {
        status = fit(ErrorLadder(), [&](double error, Climbed* climbed) { return noted(run.make(error, climbed)); });
    } else if (request.longer_than != 0) {
        status = decide(FocusPath(coarsest, request.longer_than), [&](const RatioGoal& goal, Decided* decided) {
            return noted(run.make_bounded(goal, decided));
        });
    } else {
        const RatioLadder ladder(coarsest, request.focus_from, request.focus_to);
        status = fit(ladder, [&](const RatioGoal& goal, Climbed* climbed) { return noted(run.make(goal, climbed)); });
    }
    context->arena.raise_peak(peak);
    if (is_limited) context->arena.use_all();
    if (status != Status::ok) clear(context);  // a mesh or a diagram of which a part is missing is no answer
    return static_cast<netmesh_status>(status);
}
