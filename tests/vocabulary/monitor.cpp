// What the caller's poll is told, and how often it is asked.
#include "vocabulary/monitor.hpp"

#include <doctest/doctest.h>

#include <vector>

using netmesh::Monitor;

namespace {

struct Listener {
    std::vector<netmesh_progress> heard;
    int answer = 0;

    static int poll(void* user, const netmesh_progress* progress) {
        auto* const self = static_cast<Listener*>(user);
        self->heard.push_back(*progress);
        return self->answer;
    }
};

}  // namespace

TEST_CASE("a poll comes once for every 1,000 units of work, however large the steps are") {
    for (const std::uint32_t work : {1u, 7u, 100u, 500u}) {
        CAPTURE(work);
        Listener listener;
        Monitor monitor(Listener::poll, &listener);
        monitor.begin(NETMESH_STAGE_DELAUNAY, 5);
        const std::uint32_t steps = 50000 / work;
        bool stops = false;
        for (std::uint32_t i = 0; i < steps; ++i) {
            if (i % 2 == 0)
                stops |= monitor.advance(i, work);
            else
                monitor.pass(work);
        }
        CHECK_FALSE(stops);
        CHECK(listener.heard.size() >= 30);
        CHECK(listener.heard.size() <= 50);
    }
    Listener listener;
    Monitor monitor(Listener::poll, &listener);
    for (int i = 0; i < 10; ++i) monitor.advance(0, 200000);
    CHECK(listener.heard.size() == 10);
}

TEST_CASE("a poll is told the stage, what is done of it, and the size of the mesh") {
    Listener listener;
    Monitor monitor(Listener::poll, &listener);
    monitor.begin(NETMESH_STAGE_REFINE, 1000);
    monitor.mesh_size(70, 300);
    monitor.advance(42, 200000);
    monitor.begin(NETMESH_STAGE_REDUCE, 17);
    monitor.advance(3, 200000);
    REQUIRE(listener.heard.size() == 2);
    CHECK(listener.heard[0].stage == NETMESH_STAGE_REFINE);
    CHECK(listener.heard[0].done == 42);
    CHECK(listener.heard[0].total == 1000);
    CHECK(listener.heard[0].vertices == 70);
    CHECK(listener.heard[0].cells == 300);
    CHECK(listener.heard[1].stage == NETMESH_STAGE_REDUCE);
    CHECK(listener.heard[1].done == 3);
    CHECK(listener.heard[1].total == 17);
}

TEST_CASE("in a stage that has just begun nothing is done") {
    Listener listener;
    Monitor monitor(Listener::poll, &listener);
    monitor.begin(NETMESH_STAGE_REFINE, 1000);
    monitor.advance(42, 200000);
    monitor.begin(NETMESH_STAGE_REDUCE, 17);
    monitor.pass(200000);
    REQUIRE(listener.heard.size() == 2);
    CHECK(listener.heard[1].stage == NETMESH_STAGE_REDUCE);
    CHECK(listener.heard[1].done == 0);
}

TEST_CASE("any answer but 0 stops") {
    for (const int answer : {1, 2, -1, 1 << 30}) {
        Listener listener;
        listener.answer = answer;
        Monitor monitor(Listener::poll, &listener);
        CHECK(monitor.advance(0, 200000));
    }
    Monitor silent;
    CHECK_FALSE(silent.advance(0, 200000));
}

TEST_CASE("a wish to stop is remembered where nothing can stop, and the caller is not asked again") {
    Listener listener;
    Monitor monitor(Listener::poll, &listener);
    monitor.begin(NETMESH_STAGE_CHECK, 10);
    monitor.pass(200000);
    CHECK_FALSE(monitor.has_stopped());
    listener.answer = 1;
    monitor.pass(200000);
    CHECK(monitor.has_stopped());
    listener.answer = 0;
    for (int i = 0; i < 10; ++i) monitor.pass(200000);
    monitor.begin(NETMESH_STAGE_REDUCE, 5);
    CHECK(monitor.has_stopped());
    CHECK(monitor.advance(0, 1));
    CHECK(listener.heard.size() == 2);
}
