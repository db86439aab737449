#include "mesh/thesis_cages.hpp"

#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "cage_lemmas.hpp"
#include "hierarchical.hpp"

using namespace netmesh;

namespace {

// The rule with the table of lemmas filled in: K' after each step, everything else after some of them.
template <int D> class Watched : public ThesisCages<D, Watched<D>> {
    using Base = ThesisCages<D, Watched<D>>;

public:
    static inline lemmas::Table* table = nullptr;
    static inline std::uint32_t every = 1;

    using Base::Base;
    Status take_turn(VertexId p) {
        const Status status = Base::take_turn(p);
        if (status == Status::ok) look(true, {});
        return status;
    }
    Status begin() {
        const Status status = Base::begin();
        first_ = this->store_.state.vertex_count;
        return status;
    }
    Status after_step() {
        const Status status = Base::after_step();
        std::vector<std::uint32_t> fresh;
        seen_.resize(this->inputs_);
        for (std::uint32_t p = 0; p < this->inputs_; ++p) {
            if (this->store_.vertex(p).cell == none || seen_[p]) continue;
            seen_[p] = true;
            fresh.push_back(p);
        }
        for (; first_ < this->store_.state.vertex_count; ++first_) fresh.push_back(first_);
        if (status == Status::ok) look(false, fresh);
        return status;
    }

private:
    void look(bool clean, const std::vector<std::uint32_t>& fresh) {
        if (table == nullptr || ++steps_ % every != 0) return;
        std::vector<lemmas::Ball> cages;
        for (std::uint32_t d = 0; d < this->hierarchy_.made(); ++d)
            if (this->hierarchy_.is_live(d)) cages.push_back({this->hierarchy_.cage(d).centre, this->hierarchy_.cage(d).radius});
        lemmas::Judge<D> judge(this->store_, cages, this->request_.tau, clean, table);
        judge.judge();
        for (const std::uint32_t v : fresh) judge.judge_insertion(v);
    }
    std::uint32_t first_ = 0, steps_ = 0;
    std::vector<bool> seen_;
};

template <int D> struct ThesisMesh {
    ThesisMesh(const inputs::Points& points, double tau, bool finish, lemmas::Table* table, std::uint32_t every)
        : block(std::size_t{1} << 26), store(block.arena, state) {
        MeshRequest request;
        request.method = MeshMethod::hierarchy;
        request.tau = tau;
        request.finish = finish;
        Watched<D>::table = table;
        Watched<D>::every = every;
        status = mesh_by_rule<D, Watched<D>>(store, points.data(), points.size() / D, request, {block.arena, monitor},
                                             &result);
        Watched<D>::table = nullptr;
        if (table == nullptr) return;
        std::vector<lemmas::Ball> cages;
        for (std::uint32_t d = 0; d < result.hierarchy.cages; ++d)
            cages.push_back({result.cages[d].centre, result.cages[d].radius});
        lemmas::Judge<D> judge(store, cages, tau, true, table);
        judge.judge();
        if (!finish) judge.judge_gaps(result.input.rows - result.input.duplicates);
    }
    Block block;
    StoreState state = {};
    Store<D> store;
    Monitor monitor;
    MeshResult<D> result = {};
    Status status;
};

// Input i of a sequence of families.
template <int D> inputs::Points input(std::uint64_t i) {
    const std::uint64_t seed = 1000 + i;
    const double gaps[] = {10, 30, 1e2, 1e3, 1e4, 1e6, 1e9};
    switch (i % 6) {
    case 0: return inputs::geometric(D, gaps[i / 6 % 7], 10, seed);
    case 1: return inputs::close_pairs(D, 6, 1 / gaps[i / 6 % 7], seed);
    case 2: return inputs::uniform(D, 3 + i % 20, seed);
    case 3: return inputs::clusters(D, 24, seed);
    case 4: return inputs::nested(D, 2 + i % 3, 4, gaps[i / 6 % 7], seed);
    default: {
        inputs::Points points = inputs::geometric(D, gaps[i / 6 % 7], 5, seed);
        for (const double x : inputs::close_pairs(D, 4, 1e-5, seed)) points.push_back(x);
        return points;
    }
    }
}

void print(int dim, const lemmas::Table& table) {
    for (const auto& [name, row] : table.rows)
        std::printf("D%d  %-56s %10llu  %.6f  %llu\n", dim, name.c_str(), (unsigned long long)row.checked, row.worst,
                    (unsigned long long)row.violations);
    for (const auto& [name, value] : table.largest) std::printf("D%d  %-56s %g\n", dim, name.c_str(), value);
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("every lemma of cages holds on every mesh", T, every_lemma) {
    constexpr int D = T::value;
    const char* const asked = std::getenv("NETMESH_LEMMA_INPUTS");
    const std::uint64_t count = asked != nullptr ? std::strtoull(asked, nullptr, 10) : D == 2 ? 60 : D == 3 ? 12 : 2;
    lemmas::Table all;
    for (std::uint64_t i = 0; i < count; ++i) {
        const double tau = i % 3 == 0 ? 4 : i % 3 == 1 ? 6 : 7;
        for (const bool finish : {false, true}) {
            lemmas::Table table;
            ThesisMesh<D> mesh(input<D>(i), tau, finish && D < 4, &table, D == 2 ? 7 : 23);
            REQUIRE(mesh.status == Status::ok);
            CHECK_MESSAGE(table.violated() == "", "input ", i, " finish ", finish);
            all.join(table);
        }
    }
    if (asked != nullptr) print(D, all);
    CHECK(all.violations() == 0);
}
TEST_CASE_TEMPLATE_APPLY(every_lemma, Dimensions<2, 4>);
