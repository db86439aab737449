// Vertices whose cell may be bad, those with the nearest neighbours first.
#pragma once
#include <cstdint>

#include "delaunay/store.hpp"

namespace netmesh {

// First in, first out among vertices whose squared nearest-neighbour distances have the same binary exponent. Links run
// through the vertices, so membership costs no memory. O(1). Vertices beyond a limit are put off: only marked.
template <int D> class BucketQueue {
public:
    // largest2: squared distances are measured down from here; below 2^-511 of it everything is one bucket.
    Status open(Store<D>& store, Arena& arena, double largest2) {
        store_ = &store;
        top_ = exponent_of(largest2);
        limit2_ = least_late2_ = infinity;
        buckets_ = arena.take_low<Bucket>(count);
        if (buckets_ == nullptr) return Status::out_of_memory;
        for (int b = 0; b < count; ++b) buckets_[b] = {none, none};
        for (std::uint64_t& word : filled_) word = 0;
        return Status::ok;
    }

    void push(VertexId v) { push(v, store_->vertex(v).nearest2); }
    // The same with another squared distance in place of the vertex's own.
    void push(VertexId v, double nearest2) {
        if (nearest2 > limit2_ && !has(store_->vertex(v))) return put_off(v, nearest2);
        push_now(v, nearest2);
    }
    // The same whatever the limit.
    void push_now(VertexId v, double nearest2) {
        auto&& vertex = store_->vertex(v);
        if (has(vertex)) return;
        vertex.queued = listed;
        vertex.next = none;
        int b = count - 1 - (top_ - exponent_of(nearest2));
        if (b < 0) b = 0;
        if (b >= count) b = count - 1;
        Bucket& bucket = buckets_[b];
        if (bucket.tail == none)
            bucket.head = v;
        else
            store_->vertex(bucket.tail).next = v;
        bucket.tail = v;
        filled_[b / 64] |= std::uint64_t{1} << (b % 64);
    }

    static bool has(const Vertex<D>& vertex) { return (vertex.queued & listed) != 0; }

    // From now on vertices farther than the root of limit2 from their nearest neighbours are not queued but put off,
    // unless they are in the queue. Whoever sets a limit looks for them: they stay marked until they are pushed.
    void set_limit(double limit2) { limit2_ = limit2; }
    bool puts_off() const { return limit2_ < infinity; }
    // For v that is not in the queue, and put off or not.
    void put_off(VertexId v, double nearest2) {
        store_->vertex(v).queued = is_late;
        if (nearest2 < least_late2_) least_late2_ = nearest2;
    }
    // The least squared distance of those put off since this was called last; infinity: there were none.
    double take_least_put_off() {
        const double least2 = least_late2_;
        least_late2_ = infinity;
        return least2;
    }
    static bool is_put_off(const Vertex<D>& vertex) { return (vertex.queued & is_late) != 0; }

    // The next vertex, `none` when there is none.
    VertexId pop() {
        for (int w = 0; w < count / 64; ++w) {
            if (filled_[w] == 0) continue;
            const int b = w * 64 + lowest_bit(filled_[w]);
            Bucket& bucket = buckets_[b];
            const VertexId v = bucket.head;
            bucket.head = store_->vertex(v).next;
            if (bucket.head == none) {
                bucket.tail = none;
                filled_[w] &= filled_[w] - 1;
            }
            store_->vertex(v).queued = 0;
            return v;
        }
        return none;
    }

#ifdef NETMESH_VALIDATE
    // What is wrong with the lists; null: nothing. O(vertices).
    const char* violation() const {
        const std::uint32_t vertices = store_->state.vertex_count;
        std::uint32_t listed = 0;
        for (int b = 0; b < count; ++b) {
            const Bucket& bucket = buckets_[b];
            if ((filled_[b / 64] >> (b % 64) & 1) != (bucket.head != none)) return "a bucket's bit is wrong";
            VertexId last = none;
            for (VertexId v = bucket.head; v != none; v = store_->vertex(v).next) {
                if (v >= vertices || ++listed > vertices) return "the list of a bucket does not end";
                if (!has(store_->vertex(v))) return "a vertex in a bucket is not marked as queued";
                last = v;
            }
            if (bucket.tail != last) return "the list of a bucket ends elsewhere";
        }
        for (VertexId v(0); v < vertices; ++v) listed -= has(store_->vertex(v));
        return listed == 0 ? nullptr : "a vertex is marked as queued and in no bucket";
    }
#endif

private:
    static constexpr int count = 512;
    static constexpr std::uint8_t listed = 1, is_late = 8;  // in Vertex::queued
    struct Bucket {
        VertexId head, tail;
    };
    static int lowest_bit(std::uint64_t word) {
        int b = 0;
        for (; (word & 0xFF) == 0; word >>= 8) b += 8;
        for (; (word & 1) == 0; word >>= 1) ++b;
        return b;
    }

    Store<D>* store_;
    Bucket* buckets_;
    int top_;
    double limit2_, least_late2_;
    std::uint64_t filled_[count / 64];
};

}  // namespace netmesh
