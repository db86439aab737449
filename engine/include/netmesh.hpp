// netmesh for C++17: the C interface with requests that are born initialised, and results as ranges of values. Header
// only, nothing numeric in it, no exceptions, no allocation. See netmesh.h for what each call does, costs and returns;
// every call of it stands here.
//
//     netmesh::EngineIn<1 << 20> engine;                                // with its block
//     netmesh::Request request(&netmesh_filter_alpha);
//     request.set_points(3, points);                                    // a vector, an array, a Span of numbers
//     if (engine.persist(request) != NETMESH_OK) puts(engine.detail().message);
//     for (const netmesh_pair& bar : engine.pairs(1)) printf("%g %g\n", bar.birth, bar.death);
#ifndef NETMESH_HPP
#define NETMESH_HPP

#include <cstddef>
#include <cstdint>

#include "netmesh.h"
#include "netmesh/laboratory.h"

namespace netmesh {

// Numbers that stand one after the other somewhere else.
template <class Number> class Span {
public:
    constexpr Span() = default;
    constexpr Span(Number* data, std::size_t size) : data_(data), size_(size) {}
    constexpr Number* data() const { return data_; }
    constexpr std::size_t size() const { return size_; }
    constexpr bool empty() const { return size_ == 0; }
    constexpr Number& operator[](std::size_t i) const { return data_[i]; }
    constexpr Number* begin() const { return data_; }
    constexpr Number* end() const { return data_ + size_; }

private:
    Number* data_ = nullptr;
    std::size_t size_ = 0;
};

// What an item is made of, as long as the item lives.
inline Span<const double> coordinates(const netmesh_vertex& vertex, std::uint32_t dim) {
    return {vertex.coordinates, dim};
}
inline Span<const std::uint32_t> vertices(const netmesh_cell& cell, std::uint32_t dim) {
    return {cell.vertices, std::size_t{dim} + 1};
}
inline Span<const std::uint32_t> neighbours(const netmesh_cell& cell, std::uint32_t dim) {
    return {cell.neighbours, std::size_t{dim} + 1};
}
inline Span<const std::uint32_t> vertices(const netmesh_simplex& simplex) {
    return {simplex.vertices, std::size_t{simplex.degree} + 1};
}

// Points that stay where they are until the job is done: container.data() and .size() of doubles or floats, dim numbers
// a point. Numbers behind the last whole point are not read.
inline netmesh_points points_of(std::uint32_t dim, const double* numbers, std::size_t count) {
    return {numbers, dim == 0 ? 0 : count / dim, dim, NETMESH_POINTS_FLOAT64, 0, nullptr, 0, nullptr, 0};
}
inline netmesh_points points_of(std::uint32_t dim, const float* numbers, std::size_t count) {
    return {numbers, dim == 0 ? 0 : count / dim, dim, NETMESH_POINTS_FLOAT32, 0, nullptr, 0, nullptr, 0};
}
template <class Container> netmesh_points points_of(std::uint32_t dim, const Container& container) {
    return points_of(dim, container.data(), container.size());
}

// Items of a result by their index, read one by one: of a context, until it is changed. read(index, &item) tells
// whether there is such an item. An iterator holds the item that it stands at. It has no category, which would take a
// header of the C++ library: it is for loops.
template <class Item, class Read> class Items {
public:
    class Iterator {
    public:
        Iterator(const Read& read, std::uint64_t index, std::uint64_t end) : read_(read), index_(index), end_(end) {
            load();
        }
        const Item& operator*() const { return item_; }
        const Item* operator->() const { return &item_; }
        Iterator& operator++() {
            ++index_;
            load();
            return *this;
        }
        Iterator operator++(int) {
            const Iterator before = *this;
            ++*this;
            return before;
        }
        // Of the item; UINT64_MAX past the last one.
        std::uint64_t index() const { return index_; }
        friend bool operator==(const Iterator& a, const Iterator& b) { return a.index_ == b.index_; }
        friend bool operator!=(const Iterator& a, const Iterator& b) { return a.index_ != b.index_; }

    private:
        void load() {
            item_ = {};
            item_.struct_bytes = sizeof item_;
            if (index_ >= end_ || !read_(index_, &item_)) index_ = past;
        }
        Read read_;
        std::uint64_t index_, end_;
        Item item_;
    };

    explicit Items(const Read& read, std::uint64_t first = 0, std::uint64_t end = past)
        : read_(read), first_(first), end_(end) {}
    Iterator begin() const { return {read_, first_, end_}; }
    Iterator end() const { return {read_, past, past}; }
    bool empty() const { return begin() == end(); }
    // Item i of the range; with struct_bytes 0 where there is none. O(1).
    Item operator[](std::uint64_t i) const {
        Item item = {};
        item.struct_bytes = sizeof item;
        if (i >= end_ - first_ || !read_(first_ + i, &item)) item = {};
        return item;
    }
    // Costs O(log size()) looks.
    std::uint64_t size() const {
        return first_where([](const Item&) { return false; }) - first_;
    }
    // The items from the first one with at_least(item) to the first one with above(item), of a range sorted so.
    template <class AtLeast, class Above> Items between(const AtLeast& at_least, const Above& above) const {
        return Items(read_, first_where(at_least), first_where(above));
    }

private:
    static constexpr std::uint64_t past = UINT64_MAX;
    // The index of the first item of which it holds, or of the end; of the items before it, it does not hold.
    template <class Holds> std::uint64_t first_where(const Holds& holds) const {
        const auto is_before = [&](std::uint64_t index) {
            Item item = {};
            item.struct_bytes = sizeof item;
            return index < end_ && read_(index, &item) && !holds(item);
        };
        std::uint64_t low = first_, step = 1;  // all items before `low` are before what is looked for
        while (is_before(low + step - 1)) {
            low += step;
            step *= 2;
        }
        for (std::uint64_t high = low + step - 1; low < high;) {
            const std::uint64_t middle = low + (high - low) / 2;
            if (is_before(middle)) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    Read read_;
    std::uint64_t first_, end_;
};

// How items of a context are read.
template <class Item> struct ByIndex {
    const netmesh_context* context;
    netmesh_status (*get)(const netmesh_context*, std::uint64_t, Item*);
    bool operator()(std::uint64_t index, Item* item) const { return get(context, index, item) == NETMESH_OK; }
};
struct InCycle {
    const netmesh_context* context;
    std::uint64_t pair;
    bool operator()(std::uint64_t index, netmesh_simplex* simplex) const {
        return netmesh_get_cycle_simplex(context, pair, index, simplex) == NETMESH_OK;
    }
};
template <class Item> using Indexed = Items<Item, ByIndex<Item>>;

// An empty struct with its size set: sized<netmesh_report>(), sized<netmesh_load_request>().
template <class Struct> Struct sized() {
    Struct s = {};
    s.struct_bytes = sizeof s;
    return s;
}

// A request with its defaults; every member can be set.
struct Request : netmesh_request {
    explicit Request(const netmesh_filter* f = nullptr) : netmesh_request(netmesh_default_request()) { filter = f; }
    template <class Container> Request& set_points(std::uint32_t dim, const Container& container) {
        points = points_of(dim, container);
        return *this;
    }
    // A number for each point, of the type of their coordinates; after set_points. &netmesh_radii or &netmesh_weights.
    template <class Container> Request& set_weights(const netmesh_weighting* what, const Container& container) {
        points.weights = container.data();
        weighting = what;
        return *this;
    }
    // Vectors of `dim` numbers each, one after the other; after set_points.
    template <class Container> Request& set_lattice(const Container& vectors) {
        points.lattice = vectors.data();
        points.lattice_count = static_cast<std::uint32_t>(vectors.size() / points.dim);
        periods = &netmesh_periodic;
        return *this;
    }
};
struct Bottleneck : netmesh_bottleneck_request {
    Bottleneck() : netmesh_bottleneck_request(netmesh_default_bottleneck()) {}
};
struct Wasserstein : netmesh_wasserstein_request {
    Wasserstein() : netmesh_wasserstein_request(netmesh_default_wasserstein()) {}
};

// Of the library, which may differ from NETMESH_VERSION.
inline std::uint32_t version() { return netmesh_version(); }
inline const char* version_text() { return netmesh_version_text(); }
inline const char* status_text(netmesh_status status) { return netmesh_status_text(status); }
inline const char* why_text(netmesh_why why) { return netmesh_why_text(why); }
inline const char* field_text(netmesh_field field) { return netmesh_field_text(field); }

// The request with nothing left open.
inline netmesh_status settle(const netmesh_request& request, netmesh_request* settled,
                             netmesh_detail* detail = nullptr) {
    settled->struct_bytes = sizeof *settled;
    if (detail != nullptr) detail->struct_bytes = sizeof *detail;
    return netmesh_settle(&request, settled, detail);
}
// Bytes of block to plan for: of the diagram, of the mesh alone.
inline std::size_t plan(const netmesh_request& request) { return netmesh_plan(&request); }
inline std::size_t plan_mesh(const netmesh_request& request) { return netmesh_plan_mesh(&request); }
inline std::uint64_t plan_polls(const netmesh_request& request, std::uint64_t* most = nullptr) {
    return netmesh_plan_polls(&request, most);
}
inline std::uint64_t plan_mesh_polls(const netmesh_request& request, std::uint64_t* most = nullptr) {
    return netmesh_plan_mesh_polls(&request, most);
}
inline std::size_t plan_leaf(std::uint32_t dim, std::uint64_t points, std::uint32_t pieces) {
    return netmesh_plan_leaf(dim, points, pieces);
}

// Calls visit(netmesh_option) for each option, visit(netmesh_option_word) for each of its words.
template <class Visit> void for_each_option(Visit&& visit) {
    netmesh_option option = sized<netmesh_option>();
    for (std::uint32_t i = 0; netmesh_get_option(i, &option) == NETMESH_OK; ++i) visit(i, option);
}
template <class Visit> void for_each_option_word(std::uint32_t index, Visit&& visit) {
    netmesh_option_word word = sized<netmesh_option_word>();
    for (std::uint32_t i = 0; netmesh_get_option_word(index, i, &word) == NETMESH_OK; ++i) visit(word);
}

// Bottleneck distance, with request.scratch of bottleneck_bytes(request).
inline std::size_t bottleneck_bytes(const netmesh_bottleneck_request& request) {
    return netmesh_bottleneck_bytes(&request);
}
inline netmesh_status bottleneck(const netmesh_bottleneck_request& request, netmesh_distance* distance,
                                 netmesh_detail* detail = nullptr) {
    distance->struct_bytes = sizeof *distance;
    if (detail != nullptr) detail->struct_bytes = sizeof *detail;
    return netmesh_bottleneck(&request, distance, detail);
}

// Wasserstein distance, with request.scratch of wasserstein_bytes(request).
inline std::size_t wasserstein_bytes(const netmesh_wasserstein_request& request) {
    return netmesh_wasserstein_bytes(&request);
}
inline netmesh_status wasserstein(const netmesh_wasserstein_request& request, netmesh_wasserstein_distance* distance,
                                  netmesh_detail* detail = nullptr) {
    distance->struct_bytes = sizeof *distance;
    if (detail != nullptr) detail->struct_bytes = sizeof *detail;
    return netmesh_wasserstein(&request, distance, detail);
}

// Calls visit(netmesh_filter_info) for each filter.
template <class Visit> void for_each_filter(Visit&& visit) {
    netmesh_filter_info info = sized<netmesh_filter_info>();
    for (std::uint32_t i = 0; netmesh_get_filter_info(i, &info) == NETMESH_OK; ++i) visit(info);
}

// Calls visit(netmesh_figure) for each figure of a report or an analysis.
template <class Visit> void for_each_figure(const netmesh_report& report, Visit&& visit) {
    netmesh_figure figure = sized<netmesh_figure>();
    for (std::uint32_t i = 0; netmesh_get_report_figure(&report, i, &figure) == NETMESH_OK; ++i) visit(figure);
}
template <class Visit> void for_each_figure(const netmesh_analysis& analysis, Visit&& visit) {
    netmesh_figure figure = sized<netmesh_figure>();
    for (std::uint32_t i = 0; netmesh_get_analysis_figure(&analysis, i, &figure) == NETMESH_OK; ++i) visit(figure);
}

// Calls in slices, on a stack that the caller keeps alive: see netmesh/job.h. An object is a handle.
class Job {
public:
    // status() tells whether there is a job; every other call on none does nothing.
    Job(void* stack, std::size_t stack_bytes, netmesh_task task, void* user) {
        status_ = netmesh_job_init(stack, stack_bytes, task, user, &job_);
    }
    netmesh_status status() const { return status_; }
    netmesh_status resume() { return status_ = netmesh_resume(job_); }
    netmesh_status cancel() { return status_ = netmesh_cancel(job_); }
    bool ended() const { return netmesh_job_ended(job_) != 0; }
    std::size_t stack_used() const { return netmesh_stack_used(job_); }
    // For the task: true when it is to end.
    bool pause() { return netmesh_pause(job_) != 0; }
    // For requests of calls that the task makes: pauses at each poll.
    netmesh_monitor monitor() { return {netmesh_poll_pause, job_}; }

private:
    netmesh_job* job_ = nullptr;
    netmesh_status status_ = NETMESH_NO_RESULT;
};

// A context in a block that the caller keeps alive. Copying the object copies the handle, not the context.
class Engine {
public:
    // status() tells whether the block was accepted; every other call on a refused one returns INVALID_ARGUMENT.
    Engine(void* block, std::size_t block_bytes) { status_ = netmesh_init(block, block_bytes, &context_); }
    // The context in a byte copy of a block, netmesh_adopt.
    static Engine adopt(void* block) {
        Engine engine;
        engine.status_ = netmesh_adopt(block, &engine.context_);
        return engine;
    }
    netmesh_status status() const { return status_; }
    netmesh_context* context() const { return context_; }

    // Jobs.
    netmesh_status persist(const netmesh_request& r) { return status_ = netmesh_persist(context_, &r); }
    netmesh_status mesh(const netmesh_request& r) { return status_ = netmesh_mesh(context_, &r); }
    netmesh_status load(const netmesh_load_request& r) { return status_ = netmesh_load(context_, &r); }
    netmesh_status load_cages(const netmesh_cages_request& r) { return status_ = netmesh_load_cages(context_, &r); }
    netmesh_status check(const netmesh_check_request& r = sized<netmesh_check_request>()) {
        return status_ = netmesh_check(context_, &r);
    }
    netmesh_status analyse(netmesh_analysis* analysis,
                           const netmesh_analyse_request& r = sized<netmesh_analyse_request>()) {
        analysis->struct_bytes = sizeof *analysis;
        return status_ = netmesh_analyse(context_, &r, analysis);
    }
    // Pieces of alpha diagrams.
    netmesh_status split(const netmesh_split_request& r) { return status_ = netmesh_split(context_, &r); }
    netmesh_split_result split_result() const {
        netmesh_split_result result = sized<netmesh_split_result>();
        netmesh_get_split(context_, &result);
        return result;
    }
    netmesh_status leaf(const netmesh_leaf_request& r) { return status_ = netmesh_leaf(context_, &r); }
    netmesh_status join(const netmesh_join_request& r) { return status_ = netmesh_join(context_, &r); }
    // No bytes: there is none.
    netmesh_piece piece() const {
        netmesh_piece piece = {};
        netmesh_get_piece(context_, &piece);
        return piece;
    }
    static netmesh_piece_info read_piece(const netmesh_piece& piece) {
        netmesh_piece_info info = sized<netmesh_piece_info>();
        netmesh_read_piece(&piece, &info);
        return info;
    }
    netmesh_status collect(const netmesh_collect_request& r) { return status_ = netmesh_collect(context_, &r); }
    // ratios[vertices], domains[vertices].
    netmesh_status measure_cells(double* ratios, std::uint32_t* domains) {
        return status_ = netmesh_measure_cells(context_, ratios, domains);
    }
    // cells[vertices], balls[cells]; struct_bytes of the first ones are set.
    netmesh_status measure_voronoi(netmesh_voronoi* cells) {
        return status_ = netmesh_measure_voronoi(context_, cells);
    }
    // Of all cages, in their order.
    netmesh_status weighted_cells(netmesh_weighted_cell* cells) {
        return status_ = netmesh_weighted_cells(context_, cells);
    }
    netmesh_status measure_balls(netmesh_ball* balls) { return status_ = netmesh_measure_balls(context_, balls); }
    // order[inputs], theta[inputs].
    netmesh_status well_paced_order(std::uint32_t* order, double* theta) {
        return status_ = netmesh_well_paced_order(context_, order, theta);
    }
    netmesh_status pace(const std::uint32_t* order, double* theta) {
        return status_ = netmesh_pace(context_, order, theta);
    }

    // Results.
    netmesh_detail detail() const {
        netmesh_detail d = sized<netmesh_detail>();
        netmesh_get_detail(context_, &d);
        return d;
    }
    netmesh_report report() const {
        netmesh_report r = sized<netmesh_report>();
        netmesh_get_report(context_, &r);
        return r;
    }
    // Ranges of items, in order: for (const netmesh_pair& pair : engine.pairs()). What a job changes ends them.
    Indexed<netmesh_vertex> vertices() const { return items(netmesh_get_vertex); }
    Indexed<netmesh_cell> cells() const { return items(netmesh_get_cell); }
    Indexed<netmesh_cage> cages() const { return items(netmesh_get_cage); }
    Indexed<netmesh_pair> pairs() const { return items(netmesh_get_pair); }
    Indexed<netmesh_bar_bounds> bar_bounds() const { return items(netmesh_get_bar_bounds); }
    Indexed<netmesh_scale_step> scale_steps() const { return items(netmesh_get_scale_step); }
    Indexed<netmesh_vine_point> vine_points() const { return items(netmesh_get_vine_point); }
    // Of one degree; index() of their iterators counts all pairs, as bounds and cycles are numbered.
    Indexed<netmesh_pair> pairs(std::uint32_t degree) const {
        return pairs().between([&](const netmesh_pair& pair) { return pair.degree >= degree; },
                               [&](const netmesh_pair& pair) { return pair.degree > degree; });
    }
    // Of one vine.
    Indexed<netmesh_vine_point> vine(std::uint32_t number) const {
        return vine_points().between([&](const netmesh_vine_point& point) { return point.vine >= number; },
                                     [&](const netmesh_vine_point& point) { return point.vine > number; });
    }
    // The representative of a pair; nothing where none is kept.
    Items<netmesh_simplex, InCycle> cycle(std::uint64_t pair) const {
        return Items<netmesh_simplex, InCycle>(InCycle{context_, pair});
    }
    // Calls visit(index, item) for each vertex, cell, cage, pair, bar, step of the ratio and point of a vine, in order.
    template <class Visit> void for_each_vertex(Visit&& visit) const { for_each(netmesh_get_vertex, visit); }
    template <class Visit> void for_each_cell(Visit&& visit) const { for_each(netmesh_get_cell, visit); }
    template <class Visit> void for_each_cage(Visit&& visit) const { for_each(netmesh_get_cage, visit); }
    template <class Visit> void for_each_pair(Visit&& visit) const { for_each(netmesh_get_pair, visit); }
    template <class Visit> void for_each_bar_bounds(Visit&& visit) const { for_each(netmesh_get_bar_bounds, visit); }
    template <class Visit> void for_each_scale_step(Visit&& visit) const { for_each(netmesh_get_scale_step, visit); }
    template <class Visit> void for_each_vine_point(Visit&& visit) const { for_each(netmesh_get_vine_point, visit); }
    // Calls visit(index, row) for each point that is hidden.
    template <class Visit> void for_each_hidden(Visit&& visit) const {
        std::uint64_t row = 0;
        for (std::uint64_t i = 0; netmesh_get_hidden(context_, i, &row) == NETMESH_OK; ++i) visit(i, row);
    }
    // Calls visit(index, netmesh_simplex) for each simplex of the representative of a pair.
    template <class Visit> netmesh_status for_each_in_cycle(std::uint64_t pair, Visit&& visit) const {
        std::uint64_t count = 0;
        const netmesh_status status = netmesh_get_cycle(context_, pair, &count);
        netmesh_simplex simplex = sized<netmesh_simplex>();
        for (std::uint64_t i = 0; status == NETMESH_OK && i < count; ++i)
            if (netmesh_get_cycle_simplex(context_, pair, i, &simplex) == NETMESH_OK) visit(i, simplex);
        return status;
    }
    // Of the diagram at one k of the vineyard; 0 where there is none.
    double vine_ratio(std::uint32_t k) const {
        double ratio = 0;
        return netmesh_get_vine_ratio(context_, k, &ratio) == NETMESH_OK ? ratio : 0;
    }

private:
    Engine() = default;
    template <class Item>
    Indexed<Item> items(netmesh_status (*get)(const netmesh_context*, std::uint64_t, Item*)) const {
        return Indexed<Item>(ByIndex<Item>{context_, get});
    }
    template <class Item, class Visit>
    void for_each(netmesh_status (*get)(const netmesh_context*, std::uint64_t, Item*), Visit& visit) const {
        Item item = sized<Item>();
        for (std::uint64_t i = 0; get(context_, i, &item) == NETMESH_OK; ++i) visit(i, item);
    }

    netmesh_context* context_ = nullptr;
    netmesh_status status_ = NETMESH_NO_RESULT;
};

// An engine and its block in one object, static or of a scope, which is neither copied nor moved.
template <std::size_t bytes> class BlockOf {
protected:
    alignas(16) unsigned char block_[bytes];
};
template <std::size_t bytes> class EngineIn : BlockOf<bytes>, public Engine {
public:
    EngineIn() : Engine(this->block_, bytes) {}
    EngineIn(const EngineIn&) = delete;
    EngineIn& operator=(const EngineIn&) = delete;
};

// An engine and a block from anywhere, as of mmap or malloc, that release(block) gives back: at the end of the scope,
// or where it was moved to. A null block is refused by status(), and not released.
template <class Release> class OwningEngine : public Engine {
public:
    OwningEngine(void* block, std::size_t block_bytes, Release release)
        : Engine(block, block_bytes), block_(block), release_(release) {}
    OwningEngine(OwningEngine&& other) noexcept : Engine(other), block_(other.block_), release_(other.release_) {
        other.block_ = nullptr;
    }
    OwningEngine& operator=(OwningEngine&&) = delete;
    ~OwningEngine() {
        if (block_ != nullptr) release_(block_);
    }

private:
    void* block_;
    Release release_;
};
template <class Release> OwningEngine(void*, std::size_t, Release) -> OwningEngine<Release>;

}  // namespace netmesh

#endif
