#include <cstdio>
#include <vector>

#include "common/inputs.hpp"
#include "common/wasserstein.hpp"
#include "sweep/harness.hpp"

namespace {

struct Result {
    netmesh_status status;
    double value;
    friend bool operator==(const Result& a, const Result& b) { return a.status == b.status && a.value == b.value; }
};

std::vector<netmesh_pair> diagram(std::uint64_t seed, std::size_t count) {
    const inputs::Points p = inputs::uniform(2, count, seed);
    std::vector<netmesh_pair> pairs;
    for (std::size_t i = 0; i < count; ++i)
        pairs.push_back(bar(static_cast<std::uint32_t>(i % 2), p[2 * i], p[2 * i] + 2 * p[2 * i + 1]));
    return pairs;
}

enum class Kind { plain, log, transport };
constexpr const char* names[] = {"distance", "distance, log", "transport"};

struct Distances {
    std::vector<netmesh_pair> a, b;
    Kind kind;

    std::size_t bytes() const {
        if (kind == Kind::transport) {
            const netmesh_wasserstein_request request = wasserstein_request(a, b, 2, 1e-6);
            return netmesh_wasserstein_bytes(&request);
        }
        const netmesh_bottleneck_request request = bottleneck_request(a, b);
        return netmesh_bottleneck_bytes(&request);
    }
    Result in(Block* block, std::size_t bytes) const {
        if (kind == Kind::transport) {
            auto distance = netmesh::sized<netmesh_wasserstein_distance>();
            distance.value = -1;
            return run(wasserstein_request(a, b, 2, 1e-6), netmesh_wasserstein, distance, block, bytes);
        }
        const netmesh_distance distance = {sizeof distance, 0, -1};
        const netmesh_scale scale = kind == Kind::log ? NETMESH_SCALE_LOG : NETMESH_SCALE_PLAIN;
        return run(bottleneck_request(a, b, scale), netmesh_bottleneck, distance, block, bytes);
    }

private:
    template <class Request, class Call, class Found>
    static Result run(Request request, Call call, Found distance, Block* block, std::size_t bytes) {
        request.scratch = block->base();
        request.scratch_bytes = bytes;
        request.monitor.poll = sweep_poll;
        auto detail = netmesh::sized<netmesh_detail>();
        const netmesh_status status = call(&request, &distance, &detail);
        require(detail.status == status, "the detail does not fit");
        const bool disturbed = status == NETMESH_OUT_OF_MEMORY || status == NETMESH_CANCELLED;
        require(status == NETMESH_OK || disturbed, netmesh_status_text(status));
        require(!disturbed || distance.value == -1, "a distance without an OK");
        require(block->guards_intact(), "wrote outside the block");
        total.count(status, false);
        return {status, distance.value};
    }
};

}  // namespace

void sweep_distances() {
    for (const Kind kind : {Kind::plain, Kind::log, Kind::transport}) {
        const Distances job = {diagram(1, 24), diagram(2, 21), kind};
        const char* const name = names[static_cast<int>(kind)];
        place = {name, 0, "undisturbed", 0};
        const Tally before = total;
        const std::size_t bytes = job.bytes();
        Block block(bytes, 0xAA, false);
        disturbance = {};
        const Result undisturbed = job.in(&block, bytes);
        const long polls = disturbance.polls;
        require(undisturbed.status == NETMESH_OK, "the undisturbed run fails");
        place.phase = "poll";
        Slices slices(std::size_t{1} << 20);
        const auto in_slices = [&](long cancel_at) {
            Result result = {};
            disturbance = {};
            slices.run([&] { return (result = job.in(&block, bytes)).status; }, cancel_at);
            total.pauses += slices.pauses;
            return result;
        };
        require(in_slices(-1) == undisturbed, "in slices it ends differently");
        require(slices.pauses == polls, "it did not pause at each poll");
        for (long k = 0; k < polls; ++k) {
            place.where = k;
            require(in_slices(k).status == NETMESH_CANCELLED, "went on as if nothing had happened");
            disturbance = {-1, -1, k, 0, 0, nullptr};
            require(job.in(&block, bytes).status == NETMESH_CANCELLED, "went on as if nothing had happened");
            disturbance = {};
            require(job.in(&block, bytes) == undisturbed, "the next run is another one");
        }
        place.phase = "block of bytes";
        for (std::size_t size = 0; size <= bytes + 64; size += size + 256 < bytes ? 61 : 1) {
            place.where = static_cast<long long>(size);
            Block guarded(size, 0xAA, false), tight(size, 0x55, true);
            const Result first = job.in(&guarded, size);
            require(job.in(&tight, size) == first, "the content of the block before matters");
            if (size >= bytes) require(first == undisturbed, "does not fit in the bytes that it asks for");
        }
        std::printf(
            "%-16s   :                 %5ld polls, %7zu bytes; %6ld refused, %5ld cancelled, %6ld whole, %6ld pauses\n",
            name, polls, bytes, total.refused - before.refused, total.cancelled - before.cancelled,
            total.whole - before.whole, total.pauses - before.pauses);
    }
}
