// Builds with NETMESH_VALIDATE: a mesh that grows is checked after every insertion, and a fault stops the program.
#ifdef NETMESH_VALIDATE
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "common/dimensions.hpp"
#include "common/hierarchical.hpp"
#include "common/last_words.hpp"
#include "mesh/check/check_cages.hpp"
#include "mesh/loop/aspect_rule.hpp"

using namespace netmesh;

namespace {

enum class Fault { none, marker, frame, cell, origin, distance, count, queued, bucket, unnoticed };
Fault planted = Fault::none;

// Quality meshing by the plainest of rules, which looks at whole corners and does one thing wrong when half of the
// inputs are in.
template <int D> class FaultyRule : public AspectRule<D, FaultyRule<D>> {
    using Base = AspectRule<D, FaultyRule<D>>;
    using Base::inputs_;
    using Base::inserted_;
    using Base::is_bad;
    using Base::queue_;
    using Base::store_;

public:
    FaultyRule(Store<D>& store, const MeshRequest& request, const Work& work, MeshResult<D>& result)
        : Base(store, request, work, result) {}

    bool may_be_bad(double corner2, const Vertex<D>& vertex) const { return is_bad(corner2, vertex.nearest2); }
    bool must_yield(const Split<D>& split, const NearestInput& nearest) const {
        return nearest.distance2 < split.empty2;
    }
    void queue_bad(CellId c) {
        const Cell<D>& cell = store_.cell(c);
        if (!(cell.radius2 < infinity) || (is_time() && planted == Fault::unnoticed)) return;
        const unsigned far = this->positions_of_bad(cell);
        if (this->domain_.contains(cell.centre))
            this->queue_positions(cell, far);
        else
            this->queue_bad_crossings(this->domain_, cell, far);
    }
    void queue_new(const Cavity& cavity, VertexId v) {
        if (!is_time() || planted != Fault::unnoticed) Base::queue_new(cavity, this->domain_, v);
    }
    Verdict judge(VertexId v, Split<D>* split) {
        const double* const p = store_.point(v);
        Corner<D> corner;
        std::uint32_t cells = 0;
        bool leaves_ball = false;
        const bool fits = this->kernel_.visit_star(v, [&](CellId c) {
            const Cell<D>& cell = store_.cell(c);
            ++cells;
            leaves_ball |= !(cell.radius2 < infinity) || !this->domain_.contains(cell.centre);
            if (!(cell.radius2 < infinity)) return;
            if (this->domain_.contains(cell.centre))
                corner.offer(cell.centre, distance2<D>(cell.centre, p), c);
            else
                offer_crossings<D>(store_, this->domain_, v, c, 0, &corner);
        });
        if (!fits) return Verdict::out_of_memory;
        const double nearest2 = store_.vertex(v).nearest2;
        if (!is_bad(corner.distance2, nearest2)) {
            corner.distance2 = -1;
            if (leaves_ball) this->find_beyond(this->domain_, v, this->least_bad2(store_.vertex(v)), cells, &corner);
            if (corner.distance2 < 0) return Verdict::good;
        }
        this->split_towards(v, corner, this->wanted_distance(square_root(nearest2), this->pull_back()), split);
        return Verdict::bad;
    }
    void update_distances(const Cavity& cavity, VertexId v) {
        this->update_nearest(cavity, v);
        if (is_time()) plant(v);
    }

private:
    bool is_time() const { return 2 * inserted_ > inputs_; }
    void plant(VertexId v) {
        Vertex<D>& vertex = store_.vertex(v);
        switch (planted) {
        case Fault::marker: vertex.marker = vertex.marker == Marker::input ? Marker::steiner : Marker::input; break;
        case Fault::frame: store_.vertex(inputs_).marker = Marker::steiner; break;
        case Fault::cell: vertex.cell = store_.vertex(inputs_).cell; break;
        case Fault::origin:
            if (vertex.marker == Marker::steiner) vertex.origin = vertex.origin == 0 ? 1 : 0;
            break;
        case Fault::distance: vertex.nearest2 *= 1.01; break;
        case Fault::count: ++inserted_; break;
        case Fault::queued: vertex.queued = 1; break;
        case Fault::bucket:
            queue_.push(v);
            vertex.next = v;
            break;
        default: break;
        }
    }
};

template <int D> std::string words_of(Fault fault) {
    return last_words([fault] {
        planted = fault;
        Block block(std::size_t{1} << 22);
        StoreState state = {};
        Store<D> store(block.arena, state);
        Monitor monitor;
        MeshResult<D> result;
        const std::size_t count = D < 4 ? 20 : 8;
        const inputs::Points points = inputs::uniform(D, count);
        const MeshRequest request = by_quality(D < 4 ? 2.5 : 5);
        if (mesh_by_rule<D, FaultyRule<D>>(store, points.data(), count, request, {block.arena, monitor}, &result) !=
            Status::ok)
            std::abort();
    });
}

// A mesh with cages that are left, and the hierarchy that it grew with, made again.
template <int D> struct WithCages : Hierarchical<D> {
    WithCages() : Hierarchical<D>(inputs::geometric(D, 200, 4), by_hierarchy(D < 4 ? 3 : 6)) {
        REQUIRE(this->status == Status::ok);
        REQUIRE(this->state.vertex_count <= validated_vertices_max);
        const std::uint32_t count = this->result.hierarchy.cages;
        REQUIRE(count >= 2);
        REQUIRE(hierarchy.open(this->store, this->block.arena, this->inputs()) == Status::ok);
        for (std::uint32_t d = 0; d < count; ++d) {
            const Cage& c = this->result.cages[d];
            hierarchy.make({VertexId(c.centre), c.nearest2, none}, c.radius, c.parent, c.shell);
        }
        for (std::uint32_t v = 0; v < this->inputs(); ++v)
            hierarchy.set(v, innermost_cage<D>(this->store, hierarchy, this->store.point(v), 0));
    }
    std::string violation() {
        const char* const found = cages_violation<D>(this->store, hierarchy, this->inputs());
        return found == nullptr ? "" : found;
    }
    std::uint32_t innermost() const {
        std::uint32_t least = 0;
        for (std::uint32_t d = 1; d < hierarchy.made(); ++d)
            if (hierarchy.cages()[d].radius < hierarchy.cages()[least].radius) least = d;
        return least;
    }
    Hierarchy<D> hierarchy;
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("a fault of the mesher is found by its next insertion, with its place", T, growth_faults) {
    constexpr int D = T::value;
    const std::pair<Fault, const char*> faults[] = {
        {Fault::marker, "a vertex is marked as an input, or an input not"},
        {Fault::frame, "a vertex of the frame is not exempt"},
        {Fault::cell, "a vertex points to a cell that it does not belong to"},
        {Fault::origin, "a vertex is noted with an input that is not its nearest"},
        {Fault::distance, "a nearest distance is wrong"},
        {Fault::count, "the count of inputs in the mesh is wrong"},
        {Fault::queued, "a vertex is marked as queued and in no bucket"},
        {Fault::bucket, "the list of a bucket does not end"},
        {Fault::unnoticed, "a cell is bad and nobody has noticed"}};
    CHECK(words_of<D>(Fault::none) == "lived");
    for (const auto& [fault, text] : faults) {
        const std::string words = words_of<D>(fault);
        CAPTURE(words);
        CHECK(words.find(text) != std::string::npos);
        CHECK(words.find("mesh/loop/refinement.hpp:") != std::string::npos);
    }
}
TEST_CASE_TEMPLATE_APPLY(growth_faults, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("planted faults of cages and domains are found", T, cage_faults) {
    constexpr int D = T::value;
    WithCages<D> t;
    CHECK(t.violation() == "");
    const std::uint32_t d = t.innermost();
    Cage& cage = t.hierarchy.cage(d);
    Vertex<D>& shell = t.store.vertex(cage.shell);
    SUBCASE("a centre that is no input") {
        cage.centre = t.inputs();
        CHECK(t.violation() == "a cage's centre is not an input in the mesh");
    }
    SUBCASE("a shell that ends before the vertices do") {
        cage.shell = t.state.vertex_count;
        CHECK(t.violation() == "a shell vertex is not in the mesh");
    }
    SUBCASE("a shell vertex that was released") {
        shell.marker = Marker::steiner;
        CHECK(t.violation() == "a shell vertex is not exempt");
    }
    SUBCASE("a shell vertex that was moved") {
        for (int k = 0; k < D; ++k) shell.x[k] = t.store.point(cage.centre)[k];
        CHECK(t.violation() == "a shell vertex is out of its place");
    }
    SUBCASE("a nearest distance that was not updated") {
        cage.nearest2 *= 1.01;
        CHECK(t.violation() == "a cage's nearest distance is wrong");
    }
    SUBCASE("a parent that is none") {
        REQUIRE(cage.parent != none);
        cage.parent = none;
        CHECK(t.violation() == "a cage's parent is not the cage around it");
    }
    SUBCASE("an input whose domain is too large") {
        t.hierarchy.set(cage.centre, none);
        CHECK(t.violation() == "a vertex's domain is not the innermost cage around it");
    }
    SUBCASE("a shell whose cage is gone") {
        t.hierarchy.release(d);
        CHECK(t.violation() == "an exempt vertex belongs to no shell");
    }
    SUBCASE("an input in the gap") {
        for (VertexId v(0); v < t.inputs(); ++v) {
            if (v == cage.centre || !is_inside<D>(t.store, cage, t.store.point(v))) continue;
            for (int k = 0; k < D; ++k) t.store.vertex(v).x[k] = t.store.point(cage.centre)[k];
            t.store.vertex(v).x[0] += 0.7 * cage.radius;
        }
        CHECK(t.violation() == "an input is in the gap around a cage");
    }
}
TEST_CASE_TEMPLATE_APPLY(cage_faults, Dimensions<2, 4>);
#endif
