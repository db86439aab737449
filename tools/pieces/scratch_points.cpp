#include "tools/pieces/scratch_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "platform/interrupt.hpp"

namespace netmesh::tool {

namespace {

constexpr std::uint64_t block_records = std::uint64_t{1} << 14;  // read and written at once
constexpr std::uint32_t bin_bits = 16;

std::uint64_t word_of(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}
// A whole number that ascends with x; there is no -0.0.
std::uint64_t key_of(double x) {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    const std::uint64_t bits = word_of(x);
    return (bits & sign) != 0 ? ~bits : bits | sign;
}

double number_of(std::uint64_t key) {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    const std::uint64_t bits = (key & sign) != 0 ? key & ~sign : ~key;
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

// The tree's own figures (engine/pieces/node.hpp).
std::uint32_t levels_of(std::uint64_t points, std::uint32_t pieces) {
    std::uint32_t levels = 0;
    while (std::uint64_t{1} << levels < pieces || (points - 1) >> levels >= 16) ++levels;
    return levels;
}
std::uint32_t depth_of(std::uint32_t node) {
    std::uint32_t depth = 0;
    while (node >> depth > 1) ++depth;
    return depth;
}

}  // namespace

bool ScratchPoints::Before::operator()(const double* a, const double* b) const {
    if (a[axis] != b[axis]) return a[axis] < b[axis];
    for (std::uint32_t k = 0; k < words; k++)
        if (a[k] != b[k]) return a[k] < b[k];
    return false;
}

bool ScratchPoints::is_equal(const double* a, const double* b) const { return std::equal(a, a + dim_, b); }

ScratchPoints::Box ScratchPoints::no_box() const {
    Box box(2 * dim_, HUGE_VAL);
    std::fill(box.begin() + dim_, box.end(), -HUGE_VAL);
    return box;
}

void ScratchPoints::grow(const double* record, Box* box) const {
    for (std::uint32_t k = 0; k < dim_; k++) {
        (*box)[k] = std::min((*box)[k], record[k]);
        (*box)[dim_ + k] = std::max((*box)[dim_ + k], record[k]);
    }
}

Outcome ScratchPoints::fault() const {
    if (platform::interrupted()) return {Exit::cancelled, "netmesh: cancelled while points were put in order"};
    return file_error(folder_, "a file for the points: " + file_.why());
}

bool ScratchPoints::load(std::uint64_t first, std::uint64_t count, Records* records) {
    records->resize(static_cast<std::size_t>(count * words()));
    return file_.read(first * words() * 8, records->data(), records->size() * 8);
}

bool ScratchPoints::save(std::uint64_t first, const double* records, std::uint64_t count) {
    return file_.write(first * words() * 8, records, static_cast<std::size_t>(count * words() * 8));
}

Outcome ScratchPoints::open(const std::string& folder, std::uint32_t dim, std::uint64_t points_most) {
    folder_ = folder;
    dim_ = dim;
    most_ = std::max<std::uint64_t>(points_most, 64);
    box_ = no_box();
    print_ = Fingerprint();
    print_.add(dim);
    return file_.open(folder) ? Outcome{} : fault();
}

Outcome ScratchPoints::add(const std::vector<double>& coordinates) {
    for (std::size_t at = 0; at < coordinates.size(); at += dim_) {
        const double* const point = &coordinates[at];
        if (rows_ == NETMESH_PIECES_POINTS_MAX)
            return {Exit::data, "netmesh: more points than a job in pieces has room for, 2^31 - 1"};
        grow(point, &box_);
        for (std::uint32_t k = 0; k < dim_; k++) print_.add(word_of(point[k]));
        pending_.insert(pending_.end(), point, point + dim_);
        pending_.push_back(static_cast<double>(rows_++));
        if (pending_.size() < block_records * words()) continue;
        const Outcome outcome = end();
        if (!outcome.good()) return outcome;
    }
    return {};
}

Outcome ScratchPoints::end() {
    const std::uint64_t count = pending_.size() / words();
    if (!save(count_, pending_.data(), count)) return fault();
    count_ += count;
    pending_.clear();
    return {};
}

bool ScratchPoints::each(const Part& part, const std::function<void(const double*)>& visit) {
    Records some;
    for (std::uint64_t at = 0; at < part.count; at += block_records) {
        const std::uint64_t count = std::min(block_records, part.count - at);
        if (!load(part.first + at, count, &some)) return false;
        for (std::size_t i = 0; i < some.size(); i += words()) visit(&some[i]);
    }
    return true;
}

namespace {

// The words by which records are told apart one after the other, those so far fixed, and the range of the next one.
struct Search {
    std::vector<std::uint32_t> word;  // the order in which words are looked at
    std::vector<double> fixed;
    std::uint64_t low = 0, high = UINT64_MAX, candidates = 0;

    bool has(const double* record) const {
        for (std::size_t k = 0; k < fixed.size(); k++)
            if (record[word[k]] != fixed[k]) return false;
        const std::uint64_t key = key_of(record[word[fixed.size()]]);
        return low <= key && key <= high;
    }
};

}  // namespace

// By the keys of one word after the other: a range of keys is counted in bins, then the bin that holds the rank, until
// what is left fits memory. One look at the part, for nearly all inputs.
bool ScratchPoints::find(const Part& part, const Before& before, std::uint64_t rank, Records* found, bool* repeats) {
    Search search;
    search.word.push_back(before.axis);
    for (std::uint32_t k = 0; k < words(); k++)
        if (k != before.axis) search.word.push_back(k);
    search.low = key_of(part.box[before.axis]);
    search.high = key_of(part.box[dim_ + before.axis]);
    search.candidates = part.count;
    std::vector<std::uint64_t> bins;
    while (search.candidates > most_) {
        if (search.low == search.high) {  // all the same: by the next word
            search.fixed.push_back(number_of(search.low));
            const std::uint32_t next = search.word[search.fixed.size()];
            search.low = next < dim_ ? key_of(part.box[next]) : 0;
            search.high = next < dim_ ? key_of(part.box[dim_ + next]) : UINT64_MAX;
            continue;
        }
        std::uint32_t shift = 0;
        while ((search.high - search.low) >> shift >> bin_bits != 0) ++shift;
        bins.assign(((search.high - search.low) >> shift) + 1, 0);
        const bool good = each(part, [&](const double* record) {
            if (search.has(record)) bins[(key_of(record[search.word[search.fixed.size()]]) - search.low) >> shift]++;
        });
        if (!good) return false;
        std::size_t bin = 0;
        for (; rank >= bins[bin]; bin++) rank -= bins[bin];
        search.candidates = bins[bin];
        search.low += std::uint64_t{bin} << shift;
        search.high = std::min(search.high, search.low + ((std::uint64_t{1} << shift) - 1));
    }
    Records kept;
    kept.reserve(static_cast<std::size_t>(search.candidates * words()));
    const bool good = each(part, [&](const double* record) {
        if (search.has(record)) kept.insert(kept.end(), record, record + words());
    });
    if (!good) return false;
    std::vector<std::uint32_t> order(kept.size() / words());
    std::iota(order.begin(), order.end(), 0u);
    const auto at = [&](std::uint32_t i) { return &kept[std::size_t{i} * words()]; };
    const auto by = [&](std::uint32_t a, std::uint32_t b) { return before(at(a), at(b)); };
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(order.begin(), middle, order.end(), by);
    found->assign(at(*middle), at(*middle) + words());
    // Equal points are neighbours in this order, and differ in rows alone: keys of coordinates do not part them.
    *repeats = search.fixed.size() == dim_ ||
               (rank > 0 && is_equal(at(*std::max_element(order.begin(), middle, by)), found->data()));
    return true;
}

// Records that are read at one end of what is left of a part, put in place and written again.
class ScratchPoints::Block {
public:
    explicit Block(ScratchPoints* points) : points_(*points) {}
    std::uint64_t first = 0, count = 0;
    double* at(std::uint64_t i) { return &records_[static_cast<std::size_t>(i * points_.words())]; }
    bool load(std::uint64_t from, std::uint64_t how_many) {
        first = from;
        count = how_many;
        return points_.load(first, count, &records_);
    }
    bool save() { return count == 0 || points_.save(first, records_.data(), count); }

private:
    ScratchPoints& points_;
    Records records_;
};

bool ScratchPoints::partition(const Part& part, const std::function<bool(const double*)>& is_first, Part* one,
                              Part* other) {
    Block low(this), high(this);
    std::uint64_t begin = part.first, end = part.first + part.count;  // what has not been loaded
    std::uint64_t i = 0, j = 0;  // low's from i on, and high's before j, are not known to be in place
    Box boxes[2] = {no_box(), no_box()};
    const auto look = [&](const double* record) {
        const bool first = is_first(record);
        grow(record, &boxes[first ? 0 : 1]);
        return first;
    };
    const auto swap = [&](double* a, double* b) { std::swap_ranges(a, a + words(), b); };
    for (;;) {
        while (i < low.count && look(low.at(i))) i++;
        if (i == low.count) {
            if (!low.save()) return false;
            if (begin == end) break;
            const std::uint64_t count = std::min(block_records, end - begin);
            if (!low.load(begin, count)) return false;
            begin += count;
            i = 0;
            continue;
        }
        while (j > 0 && !look(high.at(j - 1))) j--;
        if (j == 0) {
            if (!high.save()) return false;
            if (begin == end) break;
            const std::uint64_t count = std::min(block_records, end - begin);
            if (!high.load(end - count, count)) return false;
            end -= count;
            j = count;
            continue;
        }
        swap(low.at(i++), high.at(--j));
    }
    // One block is left, and all others are where they belong.
    const bool is_low = i < low.count;
    Block& last = is_low ? low : high;
    std::uint64_t from = is_low ? i : 0;
    for (std::uint64_t k = from, to = is_low ? low.count : j; k < to; k++)
        if (look(last.at(k)) && from++ != k) swap(last.at(from - 1), last.at(k));
    if (!last.save()) return false;
    const std::uint64_t middle = last.count == 0 ? part.first + part.count : last.first + from;
    *one = {part.first, middle - part.first, 2 * part.node, boxes[0]};
    *other = {middle, part.first + part.count - middle, 2 * part.node + 1, boxes[1]};
    return true;
}

void ScratchPoints::put(const Part& part, const netmesh_split_result& made, const Records& records, PointsWriter* out) {
    std::vector<double> coordinates;
    std::vector<std::uint32_t> rows;
    for (std::uint64_t i = 0; i < made.count; i++) {
        const double* const record = &records[std::size_t{made.order[i]} * words()];
        coordinates.insert(coordinates.end(), record, record + dim_);
        rows.push_back(static_cast<std::uint32_t>(record[dim_]));
        if (rows.size() < block_records && i + 1 < made.count) continue;
        out->put_points(part.first + i + 1 - rows.size(), coordinates.data(), rows.data(), rows.size());
        coordinates.clear();
        rows.clear();
    }
    for (std::uint32_t level = 0; level <= made.levels; level++) {
        const std::size_t first = (std::size_t{1} << level) - 1;
        out->put_boxes(part.node << level, made.boxes + first * 2 * dim_, std::size_t{1} << level);
    }
}

Outcome ScratchPoints::cut_in_memory(const Part& part, const SplitNode& split, std::uint32_t pieces,
                                     netmesh_split_result* made, Records* records) {
    if (!load(part.first, part.count, records)) return fault();
    // In the order of rows, which decides in what order points of a lowest node stand.
    std::vector<std::uint32_t> order(static_cast<std::size_t>(part.count));
    std::iota(order.begin(), order.end(), 0u);
    const auto row = [&](std::uint32_t i) { return (*records)[std::size_t{i} * words() + dim_]; };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return row(a) < row(b); });
    Records moved(words());
    for (std::uint32_t i = 0; i < order.size(); i++) {  // cycle by cycle
        if (order[i] == i) continue;
        const auto at = [&](std::uint32_t k) { return records->begin() + std::ptrdiff_t{k} * words(); };
        std::copy(at(i), at(i + 1), moved.begin());
        std::uint32_t to = i;
        for (std::uint32_t from = order[i]; from != i; from = order[to]) {
            std::copy(at(from), at(from + 1), at(to));
            order[to] = to;
            to = from;
        }
        std::copy(moved.begin(), moved.end(), at(to));
        order[to] = to;
    }
    return split(*records, pieces, made);
}

Outcome ScratchPoints::cut_all(const Part& root, const SplitNode& split, std::uint32_t levels, PointsWriter* out,
                               bool* repeats) {
    std::vector<Part> parts = {root};
    *repeats = false;
    while (!parts.empty()) {
        const Part part = parts.back();
        parts.pop_back();
        const std::uint32_t below = levels - depth_of(part.node);
        if (part.count <= most_ || below == 0) {
            netmesh_split_result made = {};
            Records records;
            const Outcome outcome = cut_in_memory(part, split, std::uint32_t{1} << below, &made, &records);
            if (!outcome.good()) return outcome;
            *repeats = made.count < part.count;
            if (*repeats) return {};
            put(part, made, records, out);
            continue;
        }
        std::uint32_t axis = 0;
        for (std::uint32_t k = 1; k < dim_; k++)
            if (part.box[dim_ + k] - part.box[k] > part.box[dim_ + axis] - part.box[axis]) axis = k;
        const Before before = {axis, words()};
        Records middle;
        Part one, other;
        if (!find(part, before, part.count / 2, &middle, repeats)) return fault();
        if (*repeats) return {};
        const auto is_first = [&](const double* record) { return before(record, middle.data()); };
        if (!partition(part, is_first, &one, &other)) return fault();
        out->put_boxes(part.node, part.box.data(), 1);
        parts.push_back(std::move(other));
        parts.push_back(std::move(one));
    }
    return {};
}

// Of equal points the first alone: of those of a part that fits memory, or is cut so that equal points stay together.
Outcome ScratchPoints::drop_equal_in(const Part& part, std::vector<Part>* parts, std::uint64_t* kept) {
    if (part.count <= most_) {
        Records records;
        if (!load(part.first, part.count, &records)) return fault();
        std::vector<std::uint32_t> order(static_cast<std::size_t>(part.count));
        std::iota(order.begin(), order.end(), 0u);
        const auto at = [&](std::uint32_t i) { return &records[std::size_t{i} * words()]; };
        const Before before = {0, words()};
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return before(at(a), at(b)); });
        Records left;
        for (std::size_t i = 0; i < order.size(); i++)
            if (i == 0 || !is_equal(at(order[i]), at(order[i - 1])))
                left.insert(left.end(), at(order[i]), at(order[i]) + words());
        if (!save(*kept, left.data(), left.size() / words())) return fault();
        *kept += left.size() / words();
        return {};
    }
    std::uint32_t axis = 0;
    for (std::uint32_t k = 1; k < dim_; k++)
        if (part.box[dim_ + k] - part.box[k] > part.box[dim_ + axis] - part.box[axis]) axis = k;
    const Before before = {axis, dim_};  // without rows
    Records middle;
    Part one, other;
    bool ignored;
    if (!find(part, {axis, words()}, part.count / 2, &middle, &ignored)) return fault();
    if (!partition(
            part, [&](const double* r) { return before(r, middle.data()); }, &one, &other))
        return fault();
    if (one.count == 0 && !partition(
                              part, [&](const double* r) { return !before(middle.data(), r); }, &one, &other))
        return fault();
    if (other.count > 0) {
        parts->push_back(std::move(other));
        parts->push_back(std::move(one));
        return {};
    }
    Records first;  // all are equal
    const bool good = each(one, [&](const double* record) {
        if (first.empty() || record[dim_] < first[dim_]) first.assign(record, record + words());
    });
    return good && save((*kept)++, first.data(), 1) ? Outcome{} : fault();
}

Outcome ScratchPoints::drop_equal() {
    std::vector<Part> parts = {{0, count_, 0, box_}};
    std::uint64_t kept = 0;
    while (!parts.empty()) {  // from left to right, so that what is kept has room
        const Part part = parts.back();
        parts.pop_back();
        const Outcome outcome = drop_equal_in(part, &parts, &kept);
        if (!outcome.good()) return outcome;
    }
    count_ = kept;
    return {};
}

// First as if all points were different. They are, of nearly every input, and where they are not one of the cuts or
// nodes tells: equal points are neighbours at each cut.
Outcome ScratchPoints::write(const std::string& path, const std::string& name, const SplitNode& split, PiecesJob* job) {
    for (bool repeats = true; repeats;) {
        while (lowers_ && count_ < job->pieces) job->pieces /= 2;
        if (count_ < job->pieces)
            return usage_error("--pieces " + std::to_string(job->pieces) +
                               ": more pieces than there are different points");
        job->count = count_;
        job->rows = rows_;
        job->fingerprint = fingerprint();
        job->dim = dim_;
        job->levels = levels_of(count_, job->pieces);
        PointsWriter out;
        Outcome outcome = out.open(path, name, *job);
        if (outcome.good()) outcome = cut_all({0, count_, 1, box_}, split, job->levels, &out, &repeats);
        if (outcome.good()) outcome = repeats ? drop_equal() : out.finish();
        if (!outcome.good()) return outcome;
    }
    return {};
}

}  // namespace netmesh::tool
