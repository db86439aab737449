// The bytes: a head, which is a header and the bars, and the body: for each dimension arrays one after the other, each
// padded to 8 bytes. Numbers are those of the machine; a mark in the header tells machines of another order.
#include "pieces/residual.hpp"

#include "numerics/fingerprint.hpp"

namespace netmesh {
namespace {

constexpr std::uint64_t piece_magic = 0x6E6D706965636501u;  // the last byte is the version
constexpr std::uint32_t dimensions = dimension_most() + 1;

struct Header {
    std::uint64_t magic;
    std::uint64_t bytes;
    std::uint64_t checksum;  // of what follows in the head
    std::uint64_t body_checksum;
    PieceJob job;
    std::uint64_t node, simplices, bars;
    std::uint64_t count[8];    // simplices by dimension
    std::uint64_t entries[8];  // rows of columns that are not edges or facets
};
static_assert(sizeof(Header) % 8 == 0 && dimensions <= 8, "arrays behind it are aligned");
static_assert(sizeof(Pair) == 24, "bars are written as they are");

constexpr std::uint64_t bars_max = std::uint64_t{1} << 56;
std::uint64_t head_bytes_of(const Header& header) { return sizeof(Header) + header.bars * sizeof(Pair); }

constexpr std::size_t padded(std::size_t bytes) { return (bytes + 7) & ~std::size_t{7}; }

std::uint64_t checksum_of(const unsigned char* first, std::uint64_t begin, std::uint64_t end) {
    Fingerprint sum;
    for (std::uint64_t at = begin; at < end; at += 8) {
        std::uint64_t word;
        __builtin_memcpy(&word, first + at, 8);
        sum.add(word);
    }
    return sum.value();
}

// Where arrays stand, one after the other; `first` may be null, to count bytes.
class Layout {
public:
    Layout(unsigned char* first, std::size_t begin) : first_(first), at_(begin) {}
    template <class T> T* next(std::uint64_t count) {
        T* const here = first_ == nullptr ? nullptr : reinterpret_cast<T*>(first_ + at_);
        if (count > SIZE_MAX / 64 || at_ > SIZE_MAX / 2) is_possible_ = false;
        if (is_possible_) at_ += padded(static_cast<std::size_t>(count) * sizeof(T));
        return here;
    }
    std::size_t bytes() const { return at_; }
    bool is_possible() const { return is_possible_; }

private:
    unsigned char* first_;
    std::size_t at_;
    bool is_possible_ = true;
};

struct Arrays {
    PieceSimplices simplices;
    std::uint32_t *start, *entry;
};
Arrays lay_out(const Header& header, std::uint32_t k, Layout& layout) {
    const PieceJob& job = header.job;
    const std::uint64_t count = header.count[k];
    Arrays a = {};
    a.simplices.count = static_cast<std::uint32_t>(count);
    a.simplices.value = layout.next<double>(count);
    a.simplices.vertices = layout.next<std::uint32_t>(count * (k + 1));
    a.simplices.home = layout.next<PieceNode>(count);
    a.simplices.scope = layout.next<PieceNode>(count);
    a.simplices.state = layout.next<std::uint8_t>(count);
    if (job.has_ends(k)) a.simplices.ends = layout.next<PieceSides>(count);
    if (job.has_sides(k)) a.simplices.sides = layout.next<PieceSides>(count);
    if (job.is_middle(k)) {
        a.start = layout.next<std::uint32_t>(count + 1);
        a.entry = layout.next<std::uint32_t>(header.entries[k]);
    }
    return a;
}

bool are_in_order(const PieceSimplices& s, std::uint32_t k) {
    for (std::uint32_t i = 1; i < s.count; ++i) {
        if (s.value[i - 1] < s.value[i]) continue;
        if (!(s.value[i - 1] == s.value[i])) return false;
        if (compare_vertices(s.vertices_of(k, i - 1), s.vertices_of(k, i), k + 1) >= 0) return false;
    }
    return true;
}

const char* fault_of(const Arrays& a, const Header& header, std::uint32_t k) {
    const PieceSimplices& s = a.simplices;
    const PieceNode last = 2 * header.job.pieces;
    for (std::uint32_t i = 0; i < s.count; ++i) {
        if (s.home[i] == no_piece || s.home[i] >= last || s.scope[i] == no_piece || s.scope[i] >= last)
            return "a simplex of the piece is at home nowhere";
        for (int j = 0; j < 2; ++j) {
            if (s.ends != nullptr && s.ends[i].of[j] != none && s.ends[i].of[j] >= header.count[0])
                return "an edge of the piece has an end that it does not list";
            if (s.sides != nullptr && s.sides[i].of[j] != none && s.sides[i].of[j] >= header.count[k + 1])
                return "a facet of the piece has a side that it does not list";
        }
    }
    if (!are_in_order(s, k)) return "simplices of the piece are not in order";
    if (a.start == nullptr) return nullptr;
    if (a.start[0] != 0 || a.start[s.count] != header.entries[k]) return "columns of the piece are not its own";
    for (std::uint32_t i = 0; i < s.count; ++i)
        if (a.start[i] > a.start[i + 1]) return "columns of the piece are not its own";
    for (std::uint64_t i = 0; i < header.entries[k]; ++i)
        if (a.entry[i] >= header.count[k - 1]) return "a column of the piece has a row that it does not list";
    return nullptr;
}

const char* read_header(const unsigned char* first, std::size_t count, Header* header) {
    if (count < sizeof(Header)) return "the piece ends in its header";
    __builtin_memcpy(header, first, sizeof(Header));
    if (header->magic == __builtin_bswap64(piece_magic)) return "the piece is from a machine of another byte order";
    if (header->magic != piece_magic)
        return header->magic >> 8 == piece_magic >> 8 ? "the piece is of another version" : "that is no piece";
    constexpr std::size_t begin = offsetof(Header, checksum) + sizeof(std::uint64_t);
    if (header->bytes < count) return "something follows the piece";
    if (header->bytes % 8 != 0 || header->bars >= bars_max) return "the piece is damaged";
    const std::uint64_t head = head_bytes_of(*header);
    if (head > count || (head < count && count < header->bytes)) return "the piece is cut off";
    const PieceJob& job = header->job;
    if (header->checksum != checksum_of(first, begin, head)) return "the piece is damaged";
    if (job.dim < 2 || job.dim >= dimensions || job.pieces == 0 || (job.pieces & (job.pieces - 1)) != 0 ||
        job.pieces >= 1u << 30 || header->node == no_piece || header->node >= 2 * std::uint64_t{job.pieces} ||
        job.max_degree >= job.dim)
        return "the piece is damaged";
    for (std::uint32_t k = 0; k < 8; ++k)
        if (header->count[k] >= none || header->entries[k] >= none) return "the piece is damaged";
    return nullptr;
}

void put_header(const Header& header, const unsigned char* first, Piece* out) {
    *out = Piece{};
    out->job = header.job;
    out->node = static_cast<PieceNode>(header.node);
    out->simplices = header.simplices;
    out->bar_count = header.bars;
    out->bars = reinterpret_cast<const Pair*>(first + sizeof(Header));
}

const char* check_layout(const Header& header) {
    Layout layout(nullptr, sizeof(Header));
    layout.next<Pair>(header.bars);
    for (std::uint32_t k = 0; k <= header.job.top(); ++k) lay_out(header, k, layout);
    return layout.is_possible() && layout.bytes() == header.bytes ? nullptr : "the piece is damaged";
}
const char* check_body(const Header& header, const unsigned char* first, std::size_t count) {
    const std::uint64_t head = head_bytes_of(header);
    if (count < header.bytes) return "the piece is cut off: its head is there alone";
    return checksum_of(first, head, count) == header.body_checksum ? nullptr : "the piece is damaged";
}

}  // namespace

bool operator==(const PieceJob& a, const PieceJob& b) {
    return a.dim == b.dim && a.pieces == b.pieces && a.points == b.points && a.rows == b.rows &&
           a.fingerprint == b.fingerprint && a.max_degree == b.max_degree && a.keep_zero == b.keep_zero;
}

const char* read_piece_head(const void* bytes, std::size_t count, Piece* out, PieceSize* size) {
    const auto* const first = static_cast<const unsigned char*>(bytes);
    Header header;
    const char* fault = read_header(first, count, &header);
    if (fault == nullptr) fault = check_layout(header);
    if (fault != nullptr) return fault;
    put_header(header, first, out);
    *size = {header.bytes, head_bytes_of(header)};
    return nullptr;
}

const char* check_piece_body(const void* bytes, std::size_t count) {
    Header header;
    __builtin_memcpy(&header, bytes, sizeof header);
    return check_body(header, static_cast<const unsigned char*>(bytes), count);
}

const char* read_piece(const void* bytes, std::size_t count, Arena& arena, Piece* out, Status* status) {
    const auto* const first = static_cast<const unsigned char*>(bytes);
    Header header;
    *status = Status::ok;
    const char* fault = read_header(first, count, &header);
    if (fault == nullptr) fault = check_layout(header);
    if (fault == nullptr) fault = check_body(header, first, count);
    if (fault != nullptr) return fault;
    put_header(header, first, out);
    Layout layout(const_cast<unsigned char*>(first), sizeof(Header));  // nobody writes through these pointers
    layout.next<Pair>(header.bars);
    for (std::uint32_t k = 0; k <= header.job.top(); ++k) {
        const Arrays a = lay_out(header, k, layout);
        fault = fault_of(a, header, k);
        if (fault != nullptr) return fault;
        out->of[k] = a.simplices;
        if (a.start == nullptr) continue;
        PieceColumn* const columns = arena.take_low<PieceColumn>(a.simplices.count);
        if (columns == nullptr) {
            *status = Status::out_of_memory;
            return nullptr;
        }
        arena.each(a.simplices.count, 4, [&](std::uint64_t i) {
            columns[i] = {a.entry + a.start[i], a.start[i + 1] - a.start[i]};
        });
        out->of[k].columns = columns;
    }
    return nullptr;
}

namespace {

// Which simplices stay, and their numbers then.
class Writer {
public:
    Writer(const Piece& piece, const Work& work) : piece_(piece), arena_(work.arena) {}

    Status run(PieceBytes* out) {
        const std::uint32_t top = piece_.job.top();
        for (std::uint32_t k = 0; k <= top; ++k) {
            number_[k] = arena_.take_high<std::uint32_t>(piece_.of[k].count);
            if (number_[k] == nullptr) return Status::out_of_memory;
        }
        Header header = {};
        header.magic = piece_magic;
        header.job = piece_.job;
        header.node = piece_.node;
        header.simplices = piece_.simplices;
        header.bars = piece_.bar_count;
        for (std::uint32_t k = 0; k <= top; ++k)
            arena_.each(piece_.of[k].count, 4, [&](std::uint64_t i) { number_[k][i] = is_listed(k, i) ? 0 : none; });
        for (std::uint32_t k = 1; k <= top; ++k) keep_rows(k);
        for (std::uint32_t k = 0; k <= top; ++k) {
            std::uint32_t next = 0;
            arena_.each(piece_.of[k].count, 3, [&](std::uint64_t i) {
                if (number_[k][i] != none) number_[k][i] = next++;
            });
            header.count[k] = next;
        }
        for (std::uint32_t k = 2; k <= top; ++k) header.entries[k] = entries_of(k);
        for (const std::uint64_t entries : header.entries)
            if (entries >= none) return Status::out_of_memory;
        Layout size(nullptr, sizeof(Header));
        size.next<Pair>(piece_.bar_count);
        for (std::uint32_t k = 0; k <= top; ++k) lay_out(header, k, size);
        if (!size.is_possible()) return Status::out_of_memory;
        header.bytes = size.bytes();
        unsigned char* const first = arena_.take_low<unsigned char>(size.bytes());
        if (first == nullptr) return Status::out_of_memory;
        write(header, first);
        *out = {first, size.bytes()};
        return Status::ok;
    }

private:
    // Whether it is known to be listed without looking at who has it as a row.
    bool is_listed(std::uint32_t k, std::uint64_t i) const {
        const std::uint8_t state = piece_.of[k].state[i];
        return (state & piece_state::original) != 0 && (state & (piece_state::column | piece_state::row)) != 0;
    }
    bool is_column(std::uint32_t k, std::uint64_t i) const {
        const PieceSimplices& s = piece_.of[k];
        return (s.state[i] & piece_state::column) != 0 && (s.state[i] & piece_state::original) != 0 &&
               is_below(s.home[i], piece_.node);
    }
    bool is_row(std::uint32_t k, std::uint32_t i) const { return (piece_.of[k].state[i] & piece_state::row) != 0; }
    bool has_sides(std::uint32_t k, std::uint64_t i) const {
        const PieceSimplices& s = piece_.of[k];
        return (s.state[i] & piece_state::row) != 0 && (s.state[i] & piece_state::original) != 0;
    }
    void keep(std::uint32_t k, std::uint32_t i) {
        if (i != none) number_[k][i] = 0;
    }
    void keep_rows(std::uint32_t k) {
        const PieceSimplices& s = piece_.of[k];
        if (s.ends != nullptr)
            arena_.each(s.count, 6, [&](std::uint64_t i) {
                if (!is_column(k, i)) return;
                keep(0, s.ends[i].of[0]);
                keep(0, s.ends[i].of[1]);
            });
        if (s.sides != nullptr)
            arena_.each(s.count, 6, [&](std::uint64_t i) {
                if (!has_sides(k, i)) return;
                keep(k + 1, s.sides[i].of[0]);
                keep(k + 1, s.sides[i].of[1]);
            });
        if (s.columns != nullptr)
            arena_.each(s.count, 10, [&](std::uint64_t i) {
                if (!is_column(k, i)) return;
                for (std::uint32_t j = 0; j < s.columns[i].count; ++j)
                    if (is_row(k - 1, s.columns[i].rows[j])) keep(k - 1, s.columns[i].rows[j]);
            });
    }
    std::uint64_t entries_of(std::uint32_t k) const {
        const PieceSimplices& s = piece_.of[k];
        std::uint64_t entries = 0;
        if (s.columns == nullptr) return 0;
        arena_.each(s.count, 10, [&](std::uint64_t i) {
            if (!is_column(k, i)) return;
            for (std::uint32_t j = 0; j < s.columns[i].count; ++j) entries += is_row(k - 1, s.columns[i].rows[j]);
        });
        return entries;
    }
    std::uint32_t number_of(std::uint32_t k, std::uint32_t i) const { return i == none ? i : number_[k][i]; }

    void write(Header& header, unsigned char* first) {
        arena_.each(header.bytes / 8, 1, [first](std::uint64_t i) { __builtin_memset(first + 8 * i, 0, 8); });
        Layout layout(first, sizeof(Header));
        Pair* const bars = layout.next<Pair>(piece_.bar_count);
        move_bytes(bars, piece_.bars, sizeof(Pair) * static_cast<std::size_t>(piece_.bar_count), arena_);
        for (std::uint32_t k = 0; k <= piece_.job.top(); ++k) {
            const Arrays a = lay_out(header, k, layout);
            write_simplices(k, a);
        }
        header.body_checksum = checksum_of(first, head_bytes_of(header), header.bytes);
        __builtin_memcpy(first, &header, sizeof header);
        header.checksum = checksum_of(first, offsetof(Header, checksum) + sizeof(std::uint64_t), head_bytes_of(header));
        __builtin_memcpy(first, &header, sizeof header);
    }
    void write_simplices(std::uint32_t k, const Arrays& to) {
        const PieceSimplices& s = piece_.of[k];
        std::uint32_t entries = 0;
        arena_.each(s.count, 30, [&](std::uint64_t index) {
            const auto i = static_cast<std::uint32_t>(index);
            const std::uint32_t n = number_[k][i];
            if (n == none) return;
            to.simplices.value[n] = s.value[i];
            for (std::uint32_t j = 0; j <= k; ++j)
                to.simplices.vertices[std::size_t{n} * (k + 1) + j] = s.vertices[std::size_t{i} * (k + 1) + j];
            to.simplices.home[n] = s.home[i];
            to.simplices.scope[n] = s.scope[i];
            to.simplices.state[n] = s.state[i];
            if (to.simplices.ends != nullptr)
                for (int j = 0; j < 2; ++j)
                    to.simplices.ends[n].of[j] = is_column(k, i) ? number_of(0, s.ends[i].of[j]) : std::uint32_t{none};
            if (to.simplices.sides != nullptr)
                for (int j = 0; j < 2; ++j)
                    to.simplices.sides[n].of[j] =
                        has_sides(k, i) ? number_of(k + 1, s.sides[i].of[j]) : std::uint32_t{none};
            if (to.start == nullptr) return;
            to.start[n] = entries;
            for (std::uint32_t j = 0; is_column(k, i) && j < s.columns[i].count; ++j)
                if (is_row(k - 1, s.columns[i].rows[j])) to.entry[entries++] = number_[k - 1][s.columns[i].rows[j]];
            to.start[n + 1] = entries;
        });
    }

    const Piece& piece_;
    Arena& arena_;
    std::uint32_t* number_[dimension_most() + 1] = {};
};

}  // namespace

Status write_piece(const Piece& piece, const Work& work, PieceBytes* out) {
    const HighScope scope(work.arena);
    return Writer(piece, work).run(out);
}

Status move_piece_down(Arena& arena, PieceBytes* bytes) {
    unsigned char* const moved = arena.take_low<unsigned char>(bytes->count);
    if (moved == nullptr) return Status::out_of_memory;
    move_bytes(moved, bytes->first, bytes->count, arena);
    bytes->first = moved;
    return Status::ok;
}

}  // namespace netmesh
