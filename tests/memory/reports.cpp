// What an arena tells whoever watches the job that works in it.
#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

#include "common/block.hpp"
#include "common/inputs.hpp"
#include "common/polls.hpp"
#include "numerics/sort.hpp"

using netmesh::Monitor;

TEST_CASE("pieces of a loop cover its range, and are reported as the work of all of its steps") {
    Block block(1024);
    for (const std::uint32_t cost : {1u, 40u, 299u, 300u, 5000u})
        for (const std::uint64_t from : {0u, 3u, 100000u})
            for (const std::uint64_t count : {0u, 1u, 63u, 64u, 65u, 1024u, 5000u, 200000u}) {
                CAPTURE(cost);
                CAPTURE(from);
                CAPTURE(count);
                Polls polls;
                Monitor monitor(Polls::answer, &polls);
                block.arena.watch(&monitor);
                std::uint64_t next = from;
                for (std::uint64_t i = from; i < from + count;)
                    for (const std::uint64_t piece = block.arena.piece(i, from + count, cost); i < piece; ++i)
                        REQUIRE(i == next++);
                CHECK(next == from + count);
                const double expected = static_cast<double>(count) * cost / 256 / 1000;
                CHECK(static_cast<double>(polls.made) <= 1.2 * expected + 1);
                CHECK(static_cast<double>(polls.made) >= 0.8 * expected - 1);
                block.arena.watch(nullptr);
            }
}

TEST_CASE("steps of a loop and moves of many bytes are reported, and nobody is told when nobody watches") {
    Block block(1024);
    Polls polls;
    Monitor monitor(Polls::answer, &polls);
    std::vector<unsigned char> bytes(std::size_t{1} << 24);
    for (const bool watched : {true, false}) {
        polls = {};
        block.arena.watch(watched ? &monitor : nullptr);
        for (std::uint64_t i = 0; i < 256 * 1000; ++i) block.arena.step(i, 10);
        CHECK(polls.made == (watched ? 10 : 0));
        for (std::size_t i = 0; i < bytes.size(); i += 101) bytes[i] = static_cast<unsigned char>(i / 101);
        netmesh::move_bytes(bytes.data() + 5, bytes.data(), bytes.size() - 5, block.arena);
        for (std::size_t i = 0; i + 5 < bytes.size(); i += 101)
            REQUIRE(bytes[i + 5] == static_cast<unsigned char>(i / 101));
        netmesh::move_bytes(bytes.data(), bytes.data() + 5, bytes.size() - 5, block.arena);
        for (std::size_t i = 0; i + 5 < bytes.size(); i += 101)
            REQUIRE(bytes[i] == static_cast<unsigned char>(i / 101));
        CHECK((polls.made > 10) == watched);
    }
    CHECK_FALSE(block.arena.has_stopped());
    polls = {0, 0};
    block.arena.watch(&monitor);
    block.arena.pass(100000);
    CHECK(block.arena.has_stopped());
    block.arena.rebase(block.arena.at(0));
    CHECK_FALSE(block.arena.has_stopped());
}

TEST_CASE("a sort that is reported is the same sort") {
    Block block(1024);
    Polls polls;
    Monitor monitor(Polls::answer, &polls);
    block.arena.watch(&monitor);
    inputs::Random random(3);
    std::vector<std::uint64_t> numbers(std::size_t{1} << 19);
    for (std::uint64_t& n : numbers) n = random.below(1000000);
    std::vector<std::uint64_t> same = numbers;
    netmesh::sort(numbers.data(), numbers.size(), netmesh::Ascending{}, block.arena);
    netmesh::sort(same.data(), same.size(), netmesh::Ascending{});
    CHECK(numbers == same);
    CHECK(polls.made > 50);
}
