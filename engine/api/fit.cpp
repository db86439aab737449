// Budget mode: the best certified diagram that fits in the block.
#include "jobs/fit.hpp"
#include "api/items.hpp"
#include "api/measure.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "certificate/rounding.hpp"
#include "filtration/filters.hpp"

namespace netmesh {
namespace {

constexpr double coarsest_ratio = 4;

// The largest sqrt(hi / lo) of Steiner cells that matter to the scales of interest: hi > from and lo < to.
Status measure_focus(Context& context, const netmesh_goal& goal, const FilterRequest& filter, double* ratio) {
    const ArenaScope scope(context.arena);
    AnyMesh mesh = filtered_mesh_of(context);
    const std::uint32_t count = mesh.vertices();
    Evaluation cells = {context.arena.take_high<double>(count), context.arena.take_high<Interval>(count)};
    if (cells.value == nullptr || cells.interval == nullptr) return Status::out_of_memory;
    Monitor monitor = monitor_of(context.request.monitor);
    const Watch watch(context.arena, monitor);
    const Work work = {context.arena, monitor};
    Status status = clip_cells(filter, work, &mesh);
    if (status == Status::ok) status = evaluate(mesh, filter, work, &cells);
    double widest = 1;
    for (VertexId v(0); v < count && status == Status::ok;)
        for (const std::uint64_t piece = context.arena.piece(v, count, 15); v < piece && status == Status::ok; ++v) {
            const Interval i = cells.interval[v];
            if (mesh.store.vertex(v).marker != Marker::steiner || !(i.hi > goal.focus_from && i.lo < goal.focus_to))
                continue;
            if (!(i.hi / i.lo <= widest)) widest = i.hi / i.lo;
        }
    *ratio = widest > 1 ? square_root(widest) * up : 1;
    return watch.heed(status);
}

// Mesh, diagram and bounds of one goal, in place of what the context held.
class FitRun {
public:
    FitRun(netmesh_context* context, const netmesh_function* function)
        : context_(context),
          asked_(context->request.goal), filter_{context->request.filter->id, context->request.filter->on_mesh,
                                                 values_of(context->request.values), context->request.k, function} {}

    const netmesh_goal& asked() const { return asked_; }

    // By the error: 0 for none.
    Status make(double error, Climbed* climbed) const {
        goal() = {};
        goal().error = error;
        const Status status = mesh_and_persist();
        if (status != Status::ok) return status;
        climbed->certified = climbed->reached = context_->diagram.certified_error;
        context_->diagram.fitted_error = error;
        return ended(bound());
    }
    Status make(const RatioGoal& wanted, Climbed* climbed) const {
        const bool focused = asked_.focus_to > 0;
        const Status status = mesh_and_persist(wanted);
        if (status != Status::ok) return status;
        KeptDiagram& diagram = context_->diagram;
        climbed->certified = diagram.certified_ratio;
        if (focused) {
            const Status measured = measure_focus(*context_, asked_, filter_, &climbed->certified);
            if (measured != Status::ok) return static_cast<Status>(finish(context_, measured));
            diagram.certified_focus = climbed->certified;
        }
        // The mesh is refined for the complete filter's ratio; what it certifies for others is no matter of the ladder.
        const bool is_laddered =
            find_filter(filter_.filter)->has(filter_trait::has_goal) && filter_.values == FilterValues::certified;
        climbed->reached = is_laddered ? climbed->certified : infinity;
        return ended(bound());
    }

    // The same with bounds, and what they decide of bars longer than the request says.
    Status make_bounded(const RatioGoal& wanted, Decided* decided) const {
        Status status = mesh_and_persist(wanted);
        if (status == Status::ok) status = ended(bound());
        if (status != Status::ok) return status;
        context_->bounds.longer_than = asked_.longer_than;
        const DecisionView view = decision_of(context_);
        decided->reach = undecided_reach(view);
        decided->from = decided_from(view);
        decided->top = context_->mesh.enclosing_radius;
        for (std::uint64_t i = 0; i < view.bars; ++i) decided->certain += view.bounds[i].certain;
        return Status::ok;
    }

private:
    netmesh_goal& goal() const { return context_->request.goal; }
    Status mesh_and_persist() const {
        netmesh_status status = dispatch(*context_->request.mesh.method, context_);
        if (status == NETMESH_OK) status = filter_mesh(context_);
        return static_cast<Status>(status);
    }
    Status mesh_and_persist(const RatioGoal& wanted) const {
        goal() = {};
        goal().ratio = wanted.ratio;
        goal().focus_ratio = wanted.focus;
        goal().focus_from = wanted.from;
        goal().focus_to = wanted.to;
        return mesh_and_persist();
    }
    Status bound() const {
        const netmesh_want* const bounds = context_->request.bounds;
        return bounds != nullptr ? static_cast<Status>(dispatch_bounds(*bounds, context_)) : Status::ok;
    }
    // Ends what has been made: it stays only if netmesh_check, which takes more than a diagram does, has room in the
    // block. Of a vertex: value, interval, limit of its cell; of a cell: whether it is in the ball, and its faces; of
    // an input of a mesh that promises a tau: its place in the well-paced order; and the largest star, corner by
    // corner, as laboratory/fat_cell.cpp and the fatness of clipped cells take it (at most so much was seen). What is
    // left out are the boxes of laboratory/feature_integral.cpp, 2,200 of 8 D + 1 bytes, which meshes by an error alone
    // are checked with: small blocks would fit no function.
    Status ended(Status status) const {
        if (status != Status::ok) return status;
        Monitor monitor = monitor_of(context_->request.monitor);
        const Watch watch(context_->arena, monitor);
        constexpr std::size_t vertex_bytes = 3 * sizeof(double) + sizeof(Interval), cell_bytes = 2, input_bytes = 72,
                              fixed = 4096;
        const StoreState& mesh = context_->mesh.store;
        const std::size_t d = context_->input.dim, corner_bytes = 2 * d * (13 + 24 * d);
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
        arena.each(store.state.cell_slots, 10 * context_->input.dim, [&](std::uint64_t c) {
            for (const VertexId v : store.cell(static_cast<std::uint32_t>(c)).vertex)
                if (++cells_at[v] > most) most = cells_at[v];
        });
        return most;
    }

    netmesh_context* context_;
    const netmesh_goal asked_;
    const FilterRequest filter_;
};

Complaint settle_fit(const Settling& s) {
    netmesh_goal& goal = s.goal;
    if (s.r.filter->on_mesh == nullptr || s.source != Source::points)
        return {NETMESH_FIELD_FIT, "fit is for points and filters on a mesh"};
    const bool by_error = fits_error(s.r);
    const netmesh_method* const own = by_error ? s.r.filter->by_tau : s.r.fit->method;
    if (s.rules.method != nullptr && s.rules.method != own)
        return {NETMESH_FIELD_METHOD, "fit makes the mesh itself; leave out method"};
    const std::uint32_t read = given::ratio | given::focus_from | given::focus_to | given::longer_than | given::method |
                               given::whole_cells | (is_given(goal.longer_than) ? std::uint32_t{given::tau} : 0);
    const Complaint unread = refuse_unread(s.r, (by_error ? std::uint32_t{given::method} : read) | given::of_diagram,
                                           "fit finds what fits; leave it out");
    if (unread.text != nullptr) return unread;
    s.rules.method = own;
    if (is_given(goal.longer_than)) {
        if (!(goal.longer_than > 1 && is_finite(goal.longer_than)))
            return {NETMESH_FIELD_LONGER_THAN, "longer_than is not a finite number above 1"};
        if (!s.has(filter_trait::has_goal) || !s.is_certified())
            return {NETMESH_FIELD_LONGER_THAN, "longer_than is for the complete filter with certified values"};
        if (is_given(goal.focus_from) || is_given(goal.focus_to))
            return {NETMESH_FIELD_FOCUS_FROM, "with longer_than scales of interest are chosen; leave them out"};
        if (s.r.bounds == nullptr) return {NETMESH_FIELD_BOUNDS, "longer_than goes by bounds; set them"};
    }
    if (!by_error && !is_given(goal.ratio)) goal.ratio = is_given(goal.longer_than) ? s.ratio_of_tau() : coarsest_ratio;
    return fine();
}

netmesh_status run_fit(netmesh_context* context) {
    const netmesh_request& r = context->request;
    netmesh_function function = {};
    if (r.function != nullptr) {
        const Complaint complaint = read_function(r.function, &function);
        if (complaint.text != nullptr) return refuse(context, complaint);
    }
    if (r.k > r.points.count) return refuse(context, NETMESH_FIELD_K, "k is more than the number of points");
    const FitRun fit_run(context, &function);
    const netmesh_goal& asked = fit_run.asked();
    Status status;
    // Of all tries: each begins with an arena anew. Where one runs out of memory the result is the block's.
    std::size_t peak = 0;
    bool is_limited = false;
    const auto noted = [&](Status tried) {
        if (context->arena.bytes_peak() > peak) peak = context->arena.bytes_peak();
        is_limited |= tried == Status::out_of_memory;
        return tried;
    };
    if (fits_error(r)) {
        status =
            fit(ErrorLadder(), [&](double error, Climbed* climbed) { return noted(fit_run.make(error, climbed)); });
    } else if (asked.longer_than != 0) {
        status = decide(FocusPath(asked.ratio, asked.longer_than), [&](const RatioGoal& goal, Decided* decided) {
            return noted(fit_run.make_bounded(goal, decided));
        });
    } else {
        const RatioLadder ladder(asked.ratio, asked.focus_from, asked.focus_to);
        status =
            fit(ladder, [&](const RatioGoal& goal, Climbed* climbed) { return noted(fit_run.make(goal, climbed)); });
    }
    context->arena.raise_peak(peak);
    if (is_limited) context->arena.use_all();
    if (status != Status::ok) clear(context);  // a mesh or a diagram of which a part is missing is no answer
    return static_cast<netmesh_status>(status);
}

}  // namespace
}  // namespace netmesh

extern "C" {
extern const netmesh_want netmesh_fit;
const netmesh_want netmesh_fit = {netmesh::Want::fit, netmesh::run_fit, netmesh::settle_fit,
                                  &netmesh_method_certificate};
}
