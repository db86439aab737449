// Jobs on stacks of their own: what the calls refuse, and that results do not depend on where a job paused.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "common/bottleneck.hpp"
#include "common/kinds.hpp"
#include "common/session.hpp"

namespace {

alignas(16) unsigned char stack[1 << 18];

// A task that pauses a number of times and says how it went on.
struct Counted {
    netmesh_job* job = nullptr;
    int pauses = 0, to_do = 0;
    netmesh_status end = NETMESH_OK;
    netmesh_status in_job = NETMESH_OK;  // of calls that a job must not make on itself
    static netmesh_status run(void* user) {
        Counted& c = *static_cast<Counted*>(user);
        while (c.pauses < c.to_do) {
            ++c.pauses;
            if (netmesh_pause(c.job) != 0) return NETMESH_CANCELLED;
        }
        c.in_job = netmesh_resume(c.job);
        return c.end;
    }
    netmesh_status init() { return netmesh_job_init(stack, sizeof stack, run, this, &job); }
};

}  // namespace

TEST_CASE("a job pauses, goes on and ends") {
    for (const netmesh_status end : {NETMESH_OK, NETMESH_FLAT}) {
        Counted c;
        c.to_do = 3;
        c.end = end;
        REQUIRE(c.init() == NETMESH_OK);
        CHECK(netmesh_job_ended(c.job) == 0);
        CHECK(c.pauses == 0);
        for (int i = 1; i <= 3; ++i) {
            CHECK(netmesh_resume(c.job) == NETMESH_PAUSED);
            CHECK(c.pauses == i);
            CHECK(netmesh_job_ended(c.job) == 0);
        }
        CHECK(netmesh_resume(c.job) == end);
        CHECK(netmesh_job_ended(c.job) == 1);
        CHECK(c.in_job == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_resume(c.job) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_cancel(c.job) == NETMESH_INVALID_ARGUMENT);
    }
}

TEST_CASE("a job is ended before it began, at a pause, after it ended") {
    Counted c;
    c.to_do = 3;
    REQUIRE(c.init() == NETMESH_OK);
    CHECK(netmesh_cancel(c.job) == NETMESH_CANCELLED);
    CHECK(c.pauses == 0);
    CHECK(netmesh_job_ended(c.job) == 1);
    CHECK(netmesh_resume(c.job) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(c.init() == NETMESH_OK);
    CHECK(netmesh_resume(c.job) == NETMESH_PAUSED);
    CHECK(netmesh_cancel(c.job) == NETMESH_CANCELLED);
    CHECK(c.pauses == 1);
    CHECK(netmesh_job_ended(c.job) == 1);
}

TEST_CASE("what cannot be a job") {
    Counted c;
    netmesh_job* job = nullptr;
    CHECK(netmesh_job_init(nullptr, sizeof stack, Counted::run, &c, &job) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_job_init(stack, sizeof stack, nullptr, &c, &job) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_job_init(stack, sizeof stack, Counted::run, &c, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_job_init(stack, NETMESH_STACK_BYTES_MIN - 1, Counted::run, &c, &job) == NETMESH_OUT_OF_MEMORY);
    CHECK(job == nullptr);
    CHECK(netmesh_resume(nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_cancel(nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_pause(nullptr) == 0);
    CHECK(netmesh_job_ended(nullptr) == 0);
    CHECK(netmesh_stack_used(nullptr) == 0);
    CHECK(netmesh_poll_pause(nullptr, nullptr) == 0);
    REQUIRE(c.init() == NETMESH_OK);
    CHECK(netmesh_pause(c.job) == 0);  // not by the job itself
    CHECK(netmesh_resume(c.job) == NETMESH_OK);
    std::memset(stack, 0, sizeof stack);
    CHECK(netmesh_resume(c.job) == NETMESH_INVALID_ARGUMENT);
}

TEST_CASE("two jobs in turn, and one that pauses in the other") {
    alignas(16) static unsigned char other_stack[1 << 16];
    Counted a, b;
    a.to_do = 5;
    b.to_do = 2;
    REQUIRE(a.init() == NETMESH_OK);
    REQUIRE(netmesh_job_init(other_stack, sizeof other_stack, Counted::run, &b, &b.job) == NETMESH_OK);
    for (int i = 0; i < 2; ++i) {
        CHECK(netmesh_resume(a.job) == NETMESH_PAUSED);
        CHECK(netmesh_resume(b.job) == NETMESH_PAUSED);
    }
    CHECK(netmesh_resume(b.job) == NETMESH_OK);
    for (int i = 0; i < 3; ++i) CHECK(netmesh_resume(a.job) == NETMESH_PAUSED);
    CHECK(netmesh_resume(a.job) == NETMESH_OK);

    struct Outer {
        Counted inner;
        netmesh_job* job = nullptr;
        static netmesh_status run(void* user) {
            Outer& o = *static_cast<Outer*>(user);
            netmesh_status status = netmesh_resume(o.inner.job);
            for (; status == NETMESH_PAUSED; status = netmesh_resume(o.inner.job))
                if (netmesh_pause(o.job) != 0) return netmesh_cancel(o.inner.job);
            return status;
        }
    } outer;
    outer.inner.to_do = 4;
    REQUIRE(netmesh_job_init(other_stack, sizeof other_stack, Counted::run, &outer.inner, &outer.inner.job) ==
            NETMESH_OK);
    REQUIRE(netmesh_job_init(stack, sizeof stack, Outer::run, &outer, &outer.job) == NETMESH_OK);
    for (int i = 0; i < 4; ++i) CHECK(netmesh_resume(outer.job) == NETMESH_PAUSED);
    CHECK(netmesh_resume(outer.job) == NETMESH_OK);
}

#if !defined(__SANITIZE_ADDRESS__)
TEST_CASE("a stack that is too small is seen, and how much of one was used") {
    struct Deep {
        netmesh_job* job = nullptr;
        std::size_t bytes = 0;
        static netmesh_status run(void* user) {
            Deep& d = *static_cast<Deep*>(user);
            unsigned char* volatile room = static_cast<unsigned char*>(__builtin_alloca(d.bytes));
            for (std::size_t i = 0; i < d.bytes; ++i) room[i] = 1;
            netmesh_pause(d.job);
            return NETMESH_OK;
        }
    } deep;
    unsigned char* const middle = stack + sizeof stack / 2;
    std::size_t least = 0;
    for (const std::size_t bytes : {std::size_t{100}, std::size_t{1000}, std::size_t{3000}}) {
        deep.bytes = bytes;
        REQUIRE(netmesh_job_init(middle, 4096, Deep::run, &deep, &deep.job) == NETMESH_OK);
        CHECK(netmesh_resume(deep.job) == NETMESH_PAUSED);
        const std::size_t used = netmesh_stack_used(deep.job);
        CHECK(used >= bytes);
        CHECK(used < 4096);
        CHECK((least == 0 || used - least >= bytes - 1000));
        least = least == 0 ? used : least;
        CHECK(netmesh_resume(deep.job) == NETMESH_OK);
    }
    deep.bytes = 4200;
    REQUIRE(netmesh_job_init(middle, 4096, Deep::run, &deep, &deep.job) == NETMESH_OK);
    CHECK(netmesh_resume(deep.job) == NETMESH_STACK_OVERFLOW);
    CHECK(netmesh_job_ended(deep.job) == 1);
    CHECK(netmesh_resume(deep.job) == NETMESH_INVALID_ARGUMENT);
}
#endif

namespace {

// Polls that pause a job at random.
struct Pauses {
    netmesh_job* job = nullptr;
    std::uint64_t state = 1;
    long polls = 0, pauses = 0;
    bool pauses_at_next() {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return state >> 62 != 0;
    }
    static int poll(void* user, const netmesh_progress*) {
        Pauses& p = *static_cast<Pauses*>(user);
        ++p.polls;
        if (p.job == nullptr || !p.pauses_at_next()) return 0;
        ++p.pauses;
        return netmesh_pause(p.job);
    }
};

using Work = std::function<std::uint64_t(Session&)>;
struct Named {
    const char* name;
    int dim;
    Work work;
};

std::uint64_t result(const Session& session, netmesh_status status) {
    return status == NETMESH_OK ? session.report().fingerprint : 1000 + static_cast<std::uint64_t>(status);
}

const std::vector<Named>& larger_jobs() {
    static const std::vector<Named> jobs = {
        {"delaunay, alpha", 3, [](Session& s) { return result(s, s.alpha(inputs::uniform(3, 12000))); }},
        {"alpha of points", 2,
         [](Session& s) {
             const inputs::Points points = inputs::uniform(2, 20000);
             return result(s, s.persist_until_it_fits(s.alpha_request(points)));
         }},
        {"auto, given up", 3,
         [](Session& s) {
             const inputs::Points points = kinds::skew_lines(1000);
             return result(s, s.persist_until_it_fits(s.auto_request(points)));
         }},
        {"svr, complete, bounds", 3,
         [](Session& s) {
             s.bounds = true;
             return result(s, s.mesh_and_persist(inputs::uniform(3, 1000)));
         }},
        {"netmesh, check", 2,
         [](Session& s) {
             s.request.mesh.method = &netmesh_method_netmesh;
             netmesh_status status = s.mesh(inputs::clusters(2, 2000));
             if (status == NETMESH_OK) status = s.check();
             return result(s, status);
         }},
        {"by the certificate, cycles", 3,
         [](Session& s) {
             s.request.goal.ratio = 2.25;
             netmesh_status status = s.mesh_and_persist(inputs::uniform(3, 300));
             if (status == NETMESH_OK) status = s.represent();
             return result(s, status);
         }},
        {"rips", 3,
         [](Session& s) {
             const inputs::Points points = inputs::uniform(3, 90);
             return result(s, s.persist_until_it_fits(s.points_request(points, &netmesh_filter_rips, 1, 2)));
         }},
        {"scales", 2,
         [](Session& s) {
             const inputs::Points points = inputs::clusters(2, 800);
             return result(s, s.persist_until_it_fits(s.scales_request(points)));
         }},
        {"vineyard", 2,
         [](Session& s) {
             netmesh_status status = s.mesh(inputs::uniform(2, 800), &netmesh_filter_complete);
             if (status == NETMESH_OK) status = s.vineyard(&netmesh_filter_knn, 2, 5);
             return result(s, status);
         }},
        {"distance", 2,
         [](Session& s) {
             s.alpha(inputs::uniform(2, 3000, 1));
             const std::vector<netmesh_pair> a = s.pairs();
             s.alpha(inputs::uniform(2, 3000, 2));
             const std::vector<netmesh_pair> b = s.pairs();
             netmesh_bottleneck_request r = bottleneck_request(a, b);
             const Scratch scratch(r);
             scratch.lend(&r);
             r.monitor = s.request.monitor;
             auto distance = netmesh::sized<netmesh_distance>();
             const netmesh_status status = netmesh_bottleneck(&r, &distance, nullptr);
             std::uint64_t bits = 0;
             std::memcpy(&bits, &distance.value, sizeof bits);
             return status == NETMESH_OK ? bits : 1000 + static_cast<std::uint64_t>(status);
         }},
    };
    return jobs;
}

}  // namespace

TEST_CASE("larger jobs paused at random polls give the same results") {
    struct Sliced {
        const Named* named = nullptr;
        Pauses pauses;
        std::uint64_t found = 0;
        static netmesh_status run(void* user) {
            Sliced& s = *static_cast<Sliced*>(user);
            Session session(s.named->dim);
            session.reserve(std::size_t{1} << 28);  // enough for every step
            session.request.monitor = {Pauses::poll, &s.pauses};
            s.found = s.named->work(session);
            return NETMESH_OK;
        }
    };
    long pauses = 0;
    for (std::uint64_t seed = 1; pauses < 1000; ++seed) {
        REQUIRE(seed < 100);
        for (const Named& named : larger_jobs()) {
            const std::string name = named.name;
            CAPTURE(name);
            Sliced whole, sliced;
            whole.named = sliced.named = &named;
            Sliced::run(&whole);
            CHECK(whole.found > 1100);
            sliced.pauses.state = seed;
            REQUIRE(netmesh_job_init(stack, sizeof stack, Sliced::run, &sliced, &sliced.pauses.job) == NETMESH_OK);
            netmesh_status status = netmesh_resume(sliced.pauses.job);
            while (status == NETMESH_PAUSED) status = netmesh_resume(sliced.pauses.job);
            CHECK(status == NETMESH_OK);
            CHECK(sliced.found == whole.found);
            CHECK(sliced.pauses.polls == whole.pauses.polls);
            pauses += sliced.pauses.pauses;
        }
    }
    MESSAGE(pauses << " pauses");
}
