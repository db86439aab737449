// The arena against a plain list of what was taken: pieces are in the block, aligned, apart from one another, and keep
// what was written to them, whatever is taken, made longer and given back at either end.
#include "memory/arena.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "common/inputs.hpp"

using netmesh::Arena;

namespace {

struct Record {
    double a, b;
    std::uint32_t c, d;
};

// A piece and the byte that fills it.
struct Piece {
    unsigned char* begin;
    unsigned char* end;
    unsigned char fill;
    std::size_t mark;  // of its end of the arena, before it was taken
};

class Model {
public:
    Model(std::size_t bytes, std::uint64_t seed) : random_(seed), bytes_(bytes), memory_(bytes + 64 + 16, 0xC3) {
        block_ = memory_.data() + 32;
        block_ += (16 - reinterpret_cast<std::uintptr_t>(block_) % 16) % 16;
        arena.adopt(block_, bytes);
        CHECK(arena.bytes() <= bytes);
        CHECK(arena.bytes() + 16 > bytes);
    }

    void step() {
        const bool low = random_.below(2) == 0;
        std::vector<Piece>& pieces = low ? low_ : high_;
        const std::uint64_t what = random_.below(10);
        if (what < 5) {
            const std::uint64_t kind = random_.below(4);
            const std::size_t count = random_.below(random_.below(8) == 0 ? 200 : 20);
            if (kind == 0) take<unsigned char>(low, count);
            if (kind == 1) take<std::uint32_t>(low, count);
            if (kind == 2) take<double>(low, count);
            if (kind == 3) take<Record>(low, count);
        } else if (what < 7) {
            if (!pieces.empty()) extend(low, 8 * random_.below(6));
        } else if (!pieces.empty()) {
            const std::size_t kept = random_.below(pieces.size());
            const std::size_t mark = pieces[kept].mark;
            low ? arena.release_low(mark) : arena.release_high(mark);
            pieces.resize(kept);
        }
        verify();
    }

    Arena arena;
    int refused = 0, taken = 0;

private:
    std::size_t gap() const { return arena.high_mark() - arena.low_mark(); }

    template <class T> void take(bool low, std::size_t count) {
        const std::size_t before_low = arena.low_mark(), before_high = arena.high_mark(), room = gap();
        T* const p = low ? arena.take_low<T>(count) : arena.take_high<T>(count);
        if (p == nullptr) {
            ++refused;
            CHECK(arena.low_mark() == before_low);
            CHECK(arena.high_mark() == before_high);
            CHECK(count * sizeof(T) + 48 > room);  // no more than alignment at both sides is asked for besides
            return;
        }
        ++taken;
        auto* const begin = reinterpret_cast<unsigned char*>(p);
        CHECK(reinterpret_cast<std::uintptr_t>(p) % 16 == 0);
        add(low, {begin, begin + count * sizeof(T), 0, low ? before_low : before_high});
    }
    void extend(bool low, std::size_t bytes) {
        const std::size_t room = gap(), edge = low ? arena.low_mark() : arena.high_mark();
        if (!(low ? arena.extend_low(bytes) : arena.extend_high(bytes))) {
            ++refused;
            CHECK(bytes + 48 > room);
            return;
        }
        unsigned char* const at = arena.at(edge);
        add(low, {low ? at : at - bytes, low ? at + bytes : at, 0, edge});
    }
    void add(bool low, Piece piece) {
        piece.fill = static_cast<unsigned char>(++fill_);
        std::memset(piece.begin, piece.fill, static_cast<std::size_t>(piece.end - piece.begin));
        (low ? low_ : high_).push_back(piece);
        peak_ = std::max(peak_, arena.bytes_used());
    }
    void verify() {
        bool intact = true, inside = true;
        std::vector<Piece> all = low_;
        all.insert(all.end(), high_.begin(), high_.end());
        for (const Piece& piece : all) {
            inside &= block_ <= piece.begin && piece.end <= block_ + bytes_;
            for (const unsigned char* p = piece.begin; p < piece.end; ++p) intact &= *p == piece.fill;
        }
        std::sort(all.begin(), all.end(), [](const Piece& a, const Piece& b) {
            return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
        });
        bool apart = true;
        for (std::size_t i = 1; i < all.size(); ++i) apart &= all[i - 1].end <= all[i].begin;
        for (const unsigned char* p = memory_.data(); p < memory_.data() + memory_.size(); ++p)
            if (p < block_ || p >= block_ + bytes_) inside &= *p == 0xC3;
        CHECK(intact);
        CHECK(inside);
        CHECK(apart);
        CHECK(arena.low_mark() <= arena.high_mark());
        CHECK(arena.bytes_free() == gap());
        CHECK(arena.bytes_used() == arena.bytes() - gap());
        CHECK(arena.bytes_peak() >= peak_);  // with what requests leave free at either side
        CHECK(arena.bytes_peak() <= peak_ + 48);
    }

    inputs::Random random_;
    std::size_t bytes_, peak_ = 0;
    std::vector<unsigned char> memory_;
    unsigned char* block_;
    std::vector<Piece> low_, high_;
    int fill_ = 0;
};

}  // namespace

TEST_CASE("pieces taken, made longer and given back at both ends never overlap") {
    int refused = 0, taken = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        Model model(1000 + seed * 7, seed);
        for (int step = 0; step < 400; ++step) model.step();
        refused += model.refused;
        taken += model.taken;
    }
    CHECK(refused > 1000);
    CHECK(taken > 1000);
}

TEST_CASE("so many objects that their bytes are few modulo 2^64 are refused") {
    alignas(16) static unsigned char block[1024];
    Arena arena;
    arena.adopt(block, sizeof block);
    for (const std::size_t count : {SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 8 + 2, SIZE_MAX / 4 + 2, SIZE_MAX / 8 * 5}) {
        CHECK(arena.take_low<double>(count) == nullptr);
        CHECK(arena.take_high<double>(count) == nullptr);
        CHECK(arena.take_high<Record>(count) == nullptr);
        CHECK(arena.bytes_wanted() == SIZE_MAX);
        CHECK(arena.bytes_used() == 0);
    }
}

TEST_CASE("what is said to be wanted suffices") {
    for (const std::size_t wanted : {10, 1000, 5000}) {
        std::vector<unsigned char> memory(20000);
        unsigned char* block = memory.data();
        block += (16 - reinterpret_cast<std::uintptr_t>(block) % 16) % 16;
        const auto run = [&](Arena& arena, std::size_t bytes) {
            arena.adopt(block, bytes);
            return arena.take_low<unsigned char>(801) != nullptr && arena.take_high<std::uint32_t>(33) != nullptr &&
                   arena.take_high<double>(wanted / 8) != nullptr;
        };
        Arena arena;
        std::size_t bytes = 16;
        int tries = 0;
        while (!run(arena, bytes)) {
            CHECK(arena.bytes_wanted() > bytes);
            bytes = (arena.bytes_wanted() + 15) / 16 * 16;
            REQUIRE(++tries <= 3);  // one for each piece
        }
        CHECK(bytes <= 801 + 4 * 33 + wanted + 5 * 16);
    }
}

TEST_CASE("scopes give back what was taken since they began") {
    alignas(16) static unsigned char block[4096];
    Arena arena;
    arena.adopt(block, sizeof block);
    arena.take_low<double>(4);
    arena.take_high<double>(5);
    const std::size_t low = arena.low_mark(), high = arena.high_mark();
    {
        const netmesh::ArenaScope scope(arena);
        arena.take_low<double>(7);
        arena.take_high<double>(9);
    }
    CHECK(arena.low_mark() == low);
    CHECK(arena.high_mark() == high);
    {
        const netmesh::HighScope scope(arena);
        arena.take_low<double>(2);
        arena.take_high<double>(9);
    }
    CHECK(arena.low_mark() == low + 2 * sizeof(double));
    CHECK(arena.high_mark() == high);
    std::size_t kept;
    {
        netmesh::ArenaScope scope(arena);
        arena.take_low<double>(4);
        kept = arena.low_mark();
        scope.keep_low_from_now();
        arena.take_low<double>(1);
        arena.take_high<double>(1);
    }
    CHECK(arena.low_mark() == kept);
    CHECK(arena.high_mark() == high);
}
