// netmesh-verify-rips INPUT DIAGRAM PROOF [--quiet]
//
// Verifies that a persistence diagram is the exact one of a Vietoris-Rips complex of points or distances, of a Cech
// complex of points, or of a filtered complex that a file lists, by the proof beside it. What is claimed, what the
// files hold and why the checks are enough is on the page tools/docs/proofs.md, "Rips, Cech and listed complexes";
// steps 1 to 4 below are those of that page. This file is all of the program, it shares no code with netmesh, and needs
// nothing but GMP:
//
//     c++ -std=c++17 -O2 -ffp-contract=off netmesh-verify-rips.cpp -lgmpxx -lgmp
//
// The bounds on rounding hold for IEEE doubles, each operation rounded to nearest: no -ffast-math, no x87. Exit: 0
// verified; 7 not proven, with step and place; 2 usage; 3 a file that is not of its format.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gmpxx.h>
#include <map>
#include <numeric>
#include <queue>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace {
using std::size_t, std::string, std::string_view, std::vector;
using Word = std::uint64_t;
using Key = std::uint64_t;  // a simplex among those of its dimension, in their order
using Id = std::uint32_t;
using Ids = vector<Id>;
constexpr Key kNone = ~Key(0);
constexpr double kInf = HUGE_VAL;
using Failure = std::pair<int, string>;  // exit code, message
[[noreturn]] void badFile(const string& s) { throw Failure(3, s); }
[[noreturn]] void refuse(const char* step, const string& s) {
    throw Failure(7, string("not proven: step ") + step + ": " + s);
}
template <class T> string str(T v) { return std::to_string(v); }
string str(double v) {
    char s[40];
    return std::snprintf(s, sizeof s, "%.17g", v), s;
}
template <class To, class From> To bitsAs(From v) {
    To to;
    return *static_cast<To*>(std::memcpy(&to, &v, sizeof v));
}
Word littleEndian(const char* bytes, size_t count) {
    Word w = 0;
    for (size_t i = 0; i < count; ++i) w |= Word(static_cast<unsigned char>(bytes[i])) << (8 * i);
    return w;
}
struct Fingerprint {
    Word state = 0x6E65746D65736800;
    static Word mix(Word z) {
        z += 0x9E3779B97F4A7C15;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return z ^ (z >> 31);
    }
    void add(Word w) { state = mix(state ^ w) + 0x632BE59BD9B4E019 * w; }
    void add(double x) { add(bitsAs<Word>(x + 0.0)); }
    Word value() const { return mix(state); }
};
//---- STEP 1: FILES ------------------------------------------------------------------------------------------------
struct Bar {
    Word degree;
    double birth, death;
    size_t line = 0;  // of the diagram
    bool operator<(const Bar& b) const { return std::tie(degree, birth, death) < std::tie(b.degree, b.birth, b.death); }
    string text() const { return str(degree) + " " + str(birth) + " " + str(death); }
};
struct Diagram {
    string name;
    std::map<string, string> head;  // the first word of a line and the second one, "?" if there are not two, or twice
    vector<Bar> bars;
    Fingerprint sum;
    bool has(const char* key) const { return head.count(key) > 0; }
};
string readFile(const string& name) {
    std::error_code error;
    std::ifstream file(name, std::ios::binary);
    if (!file || !std::filesystem::is_regular_file(name, error)) badFile(name + ": no file that can be read");
    string bytes(std::filesystem::file_size(name), '\0');
    if (!file.read(&bytes[0], std::streamsize(bytes.size()))) badFile(name + ": can not be read");
    return bytes;
}
// Calls line(words, number) for each line. Words are parted by blanks or, if `marks`, by one comma or semicolon, too.
template <class Fn> void forLines(const string& text, bool marks, Fn line) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    const auto mark = [&](char c) { return marks && (c == ',' || c == ';'); };
    vector<string_view> words;
    size_t number = 0;
    for (const char *p = text.data(), *const last = p + text.size(), *end; p < last; p = end + 1) {
        end = std::find(p, last, '\n');
        words.clear();
        for (bool more = false;; p += more) {  // after a mark a word must follow
            while (p < end && blank(*p)) ++p;
            if (p == end && !more) break;
            const char* const begin = p;
            while (p < end && !blank(*p) && !mark(*p)) ++p;
            words.emplace_back(begin, p - begin);
            while (p < end && blank(*p)) ++p;
            more = p < end && mark(*p);
        }
        line(words, ++number);
    }
}
template <class T> bool readNumber(string_view word, T& value) {
    if (word.size() > 1 && word[0] == '+') word.remove_prefix(1);
    if (word.find_first_of("anAN") != word.npos) return false;  // nan and inf
    auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = end == word.data() + word.size();
    if (std::is_same_v<T, double> && error == std::errc::result_out_of_range)  // 0 or infinite
        return value = T(std::strtod(string(word).c_str(), nullptr)), whole;
    return whole && error == std::errc();
}
Diagram readDiagram(const string& name) {
    Diagram diagram;
    diagram.name = name;
    forLines(readFile(name), false, [&](const vector<string_view>& words, size_t line) {
        const auto bad = [&](const char* what) { badFile(name + ", line " + str(line) + ": " + what); };
        if (!words.empty() && words[0][0] == '#') {
            if (words[0] != "#" || words.size() < 2) return;
            const bool again = diagram.has(string(words[1]).c_str());
            diagram.head[string(words[1])] = words.size() == 3 && !again ? string(words[2]) : "?";
            return;
        }
        Bar bar{0, 0, 0, line};
        if (words.size() != 3 || !readNumber(words[0], bar.degree) || !readNumber(words[1], bar.birth) ||
            (words[2] != "inf" && !readNumber(words[2], bar.death)))
            bad("not degree, birth and death");
        if (words[2] == "inf") bar.death = kInf;
        if (std::isinf(bar.birth) || bar.death == -kInf || (bar.death == kInf && words[2] != "inf"))
            bad("a number beyond the largest double");
        if (!diagram.bars.empty() && bar < diagram.bars.back()) bad("bars are not sorted");
        diagram.sum.add(bar.degree), diagram.sum.add(bar.birth), diagram.sum.add(bar.death);
        diagram.bars.push_back(bar);
    });
    return diagram;
}
struct Table {
    vector<vector<double>> rows;
    vector<size_t> lines;
};
// Rows of numbers, of one width or not. `header`: the first line is skipped if none of its words is a number.
Table readTable(const string& name, bool header, bool infinite) {
    Table table;
    forLines(readFile(name), true, [&](const vector<string_view>& words, size_t line) {
        if (words.empty() || words[0].substr(0, 1) == "#") return;
        vector<double> row(words.size());
        size_t numbers = 0;
        for (size_t i = 0; i < row.size(); ++i) {
            const bool never = infinite && words[i] == "inf";
            numbers += never || readNumber(words[i], row[i]);
            if (std::isinf(row[i] = never ? kInf : row[i] + 0.0) && !never)
                badFile(name + ", line " + str(line) + ": beyond the largest double");
        }
        if (std::exchange(header, false) && numbers == 0) return;
        if (numbers != words.size()) badFile(name + ", line " + str(line) + ": not numbers");
        table.rows.push_back(std::move(row)), table.lines.push_back(line);
    });
    if (table.rows.empty()) badFile(name + ": nothing in it");
    return table;
}
struct Proof {
    Word kind, dim, n, degree, input, at = 0;
    double limit;
    string name, bytes;  // without the fingerprint at the end
    [[noreturn]] void bad(const string& what) const { refuse("1", name + ", before byte " + str(at) + ": " + what); }
    Word take(size_t count) {
        if (count > bytes.size() - at) bad("the file is too short");
        return littleEndian(&bytes[std::exchange(at, at + count)], count);
    }
    Word number() {
        Word v = 0, byte = 128;
        for (int shift = 0; byte >= 128; shift += 7) {
            byte = take(1);
            v |= (byte & 127) << shift;
            if (shift > 28 || (byte == 0 && shift > 0)) bad("a number of more bytes than it takes");
        }
        return v;
    }
    bool ofPoints() const { return kind == 3 || kind == 6; }
    Proof(const string& file, const Diagram& diagram) : name(file), bytes(readFile(file)) {
        if (bytes.compare(0, 16, "netmesh proof 3\n") != 0) badFile(name + ": not a proof of version 3");
        if (bytes.size() < 72) bad("the file is too short");
        const Word written = littleEndian(&bytes[bytes.size() - 8], 8);
        bytes.resize(bytes.size() - 8);
        Fingerprint sum;
        sum.add(Word(bytes.size()));
        for (size_t i = 0; i < bytes.size(); i += 8)
            sum.add(littleEndian(&bytes[i], std::min<size_t>(8, bytes.size() - i)));
        if (written != sum.value()) bad("the file is damaged, by its fingerprint");
        at = 16;
        kind = take(4), dim = take(4), n = take(8), degree = take(8);
        limit = bitsAs<double>(take(8));
        input = take(8);
        if (kind < 3 || kind > 6) bad("not of a kind of its version");
        if (take(8) != diagram.sum.value()) bad("not of this diagram, by its fingerprint");
        const bool fits = n > 0 && n < Id(-1) && degree <= 31 && (ofPoints() || dim == 0) && (kind < 5 || limit == 0);
        if (!fits || !(limit >= 0)) bad("a number that cannot be");
    }
};
//---- STEP 2: THE COMPLEX ------------------------------------------------------------------------------------------
// The nearest double of the root of `square`, times 2^exponent, ties to even. `more`: of a bit more than `square`.
double nearestRoot(const mpz_class& square, long exponent, bool more = false) {
    const long up = 66 - long(mpz_sizeinbase(square.get_mpz_t(), 2)) / 2;  // so that the root has some 66 bits
    mpz_class scaled = up >= 0 ? mpz_class(square << (2 * up)) : mpz_class(square >> (-2 * up)), rest;
    const bool lost = more || (up < 0 && mpz_class(scaled << (-2 * up)) != square);
    mpz_class root;
    mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), scaled.get_mpz_t());
    root = 2 * root + (lost || rest != 0 ? 1 : 0);  // an odd last digit: there is more
    exponent -= up + 1;
    const long top = long(mpz_sizeinbase(root.get_mpz_t(), 2)) + exponent, last = std::max(top - 53, -1074L);
    mpz_class digits = root >> (last - exponent), twice = 2 * (root - (digits << (last - exponent)));
    const int over = cmp(twice, mpz_class(mpz_class(1) << (last - exponent)));
    if (over > 0 || (over == 0 && mpz_odd_p(digits.get_mpz_t()))) digits += 1;
    return square == 0 ? 0 : std::ldexp(digits.get_d(), int(last));
}
// All numbers are whole multiples of 2^lowestDigit.
int lowestDigit(const double* x, size_t count) {
    int lowest = 1024;
    for (size_t k = 0; k < count; ++k)
        if (int exponent; x[k] != 0) std::frexp(x[k], &exponent), lowest = std::min(lowest, exponent - 53);
    return lowest;
}
mpz_class integer(double x, int lowest) {
    int exponent;
    const mpz_class z(std::ldexp(std::frexp(x, &exponent), 53));
    return x == 0 ? z : mpz_class(z << (exponent - 53 - lowest));
}
// Half of the distance, rounded to nearest. s + e is the sum of squares but for less than (8 dim + 16) 2^-106 of it:
// the products and first differences are split exactly, what is left out are squares of their low parts and roundings
// of e. If |s + e - r^2| < r times the unit u in the last place of r, then r is the nearest double to the root, as r +
// u / 2 has the square r^2 + r u + ..; below a power of two units are half as large. A share of .999 leaves 2^-63.
double halfDistance(const double* a, const double* b, size_t dim) {
    double s = 0, e = 0;
    for (size_t k = 0; k < dim; ++k) {
        const double d = a[k] - b[k], back = d - a[k], low = (a[k] - (d - back)) - (b[k] + back);
        const double square = d * d, t = s + square, part = t - s;
        e += ((s - (t - part)) + (square - part)) + (std::fma(d, d, -square) + 2 * d * low);
        s = t;
    }
    const double r = std::sqrt(s + e);
    if (r > 0x1p-400 && r < 0x1p400 && dim < 10000) {
        int exponent;
        const bool power = std::frexp(r, &exponent) == 0.5;
        const double off = std::fma(-r, r, s) + e, unit = std::ldexp(1, exponent - 53);
        if (std::abs(off) < 0.999 * r * unit * (power && off < 0 ? 0.5 : 1)) return r / 2;
    }
    const int lowest = std::min(lowestDigit(a, dim), lowestDigit(b, dim));
    mpz_class sum = 0;
    for (size_t k = 0; k < dim; ++k) {
        const mpz_class d = integer(a[k], lowest) - integer(b[k], lowest);
        sum += d * d;
    }
    return nearestRoot(sum, lowest - 1);
}
struct Points {
    size_t dim = 0;
    vector<double> x;  // of the different ones
    Word sum = 0;
};
Points readPoints(const Diagram& diagram, const string& input, const Proof& proof) {
    const Table table = readTable(input, true, false);
    Points points;
    points.dim = table.rows[0].size();
    std::map<vector<double>, size_t> seen;
    Fingerprint sum;
    sum.add(Word(points.dim));
    for (size_t i = 0; i < table.rows.size(); ++i) {
        if (table.rows[i].size() != points.dim)
            badFile(input + ", line " + str(table.lines[i]) + ": not as many numbers as before");
        if (!seen.emplace(table.rows[i], i).second) continue;
        for (const double c : table.rows[i]) points.x.push_back(c), sum.add(c);
    }
    const std::map<string, Word> due = {
        {"dim", points.dim}, {"points", table.rows.size()}, {"duplicates", table.rows.size() - seen.size()}};
    for (const auto& [key, number] : due) {
        Word said = 0;
        const bool there = diagram.has(key.c_str());
        if (there ? !readNumber(diagram.head.at(key), said) || said != number : key != "duplicates" || number > 0)
            refuse("1", diagram.name + ": its head must say " + key + " " + str(number));
    }
    if (seen.size() != proof.n || proof.dim != points.dim)
        refuse("1", proof.name + ": not of so many points, or dimensions");
    points.sum = sum.value();
    return points;
}
void checkHead(const Diagram& diagram, const Proof& proof) {
    Word degree = 0;
    if (!diagram.has("max-degree") || !readNumber(diagram.head.at("max-degree"), degree) || degree != proof.degree)
        refuse("1", diagram.name + ": its head must say max-degree " + str(proof.degree));
    if (diagram.has("distances") != (proof.kind == 4)) refuse("1", diagram.name + ": # distances, or points?");
}
struct Edge {
    double value;
    Id a, b;  // a > b
};
class Rips {
public:
    Rips(const Diagram& diagram, const string& input, Proof& proof) : n_(Id(proof.n)) {
        const auto fail = [&](const string& s) { refuse("2", input + ": " + s); };
        double threshold = kInf;
        if (diagram.has("threshold") &&
            (!readNumber(diagram.head.at("threshold"), threshold) || !(threshold >= 0) || threshold == kInf))
            badFile(diagram.name + ": # threshold is no number, or not one that can be");
        checkHead(diagram, proof);
        limit_ = std::min(threshold, proof.limit);
        const Word sum = proof.kind == 3 ? joinPoints(readPoints(diagram, input, proof))
                                         : readDistances(input, diagram.has("sparse"), threshold, proof);
        if (sum != proof.input) refuse("1", proof.name + ": not of this input, by its fingerprint");
        if (edges.size() >= Id(-1)) fail("too many edges");
        std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
            return std::tie(x.value, x.a, x.b) < std::tie(y.value, y.a, y.b);
        });
        begin_.assign(n_ + size_t(1), 0);
        for (const Edge& e : edges) ++begin_[e.a], ++begin_[e.b];
        bool cone = false;
        for (Id v = 0; v < n_; ++v) cone = cone || begin_[v] == n_ - size_t(1);
        if (limit_ < threshold && !cone) fail("no point is joined to all others up to the proof's limit");
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        joined_.resize(2 * edges.size());
        for (Id e = 0; e < edges.size(); ++e) {
            joined_[--begin_[edges[e].a]] = {edges[e].b, e};
            joined_[--begin_[edges[e].b]] = {edges[e].a, e};
        }
        for (Id v = 0; v < n_; ++v) std::sort(joined_.begin() + long(begin_[v]), joined_.begin() + long(begin_[v + 1]));
        while ((n_ - 1) >> bits_ != 0) ++bits_;
        size_t rankBits = 1;
        while (edges.size() >> rankBits != 0) ++rankBits;
        if (rankBits + std::min<Word>(proof.degree, n_ > 2 ? n_ - 2 : 0) * bits_ > 64)
            fail("more simplices than this program can number");
        isDense_ = edges.size() >= size_t(n_) * n_ / 32;
    }
    size_t vertices() const { return n_; }
    double vertexValue(Id) const { return 0; }
    double value(int p, Key key) const { return edges[rank(p, key)].value; }
    // Calls f(key, birth, death) for the p-simplices from the last to the first: whether they are the birth or the
    // death of a shortcut pair; if p is 1 the latter is not told.
    template <class Fn> void each(int p, Fn f) const {
        vector<vector<Id>> candidates(p + 1);
        vector<Id> others(p + 1);
        for (Id e = Id(edges.size()); e-- > 0;) {
            const Id ends[] = {edges[e].a, edges[e].b};
            candidates[0].clear();
            eachJoined(ends, 2, e, n_, [&](Id w, Id, int) { return candidates[0].push_back(w), p > 1; });
            if (p == 1)
                f(Key(e), !candidates[0].empty(), false);
            else
                choose(p, e, 0, candidates, others, f);
        }
    }
    template <class Fn> void eachCoface(int p, Key key, Fn f) const {
        Id v[40], other[40];
        const Id e = read(p, key, v, other);
        eachJoined(v, p + 1, Id(-1), n_, [&](Id w, Id rank, int far) {
            Id more[40];
            int count = 0;
            if (rank < e) {
                count = int(std::merge(other, other + p - 1, &w, &w + 1, more) - more);
            } else {
                for (int i = 0; i <= p; ++i)
                    if (i != far) more[count++] = v[i];
            }
            f(keyOf(std::max(rank, e), more, count));
            return true;
        });
    }
    // The facet with which the q-simplex is a shortcut pair, or none: that without the smallest of its vertices besides
    // the last edge, if no smaller one is joined to it before.
    Key shortcut(int q, Key key) const {
        Id v[40], other[40];
        const Id e = read(q, key, v, other);
        std::remove(v, v + q + 1, other[0]);
        bool first = true;
        eachJoined(v, q, e, other[0], [&](Id, Id, int) { return first = false; });
        return first ? keyOf(e, other + 1, q - 2) : kNone;
    }
    Key partner(int, Key) const { return kNone; }  // of shortcut pairs, which end where they begin
    // The pivot of a sum of coboundaries of edges, by a matrix of bits: the edges in the sum. A triangle is in it if an
    // odd number of its edges is. Nothing is done unless the graph is dense.
    bool pivotOfEdges(const vector<Key>& sum, Key& pivot) {
        if (!isDense_) return false;
        if (table_.empty()) {
            table_.assign(size_t(n_) * n_, Id(-1)), words_ = (n_ + 63) / 64, bit_.assign(n_ * words_, 0);
            for (Id e = 0; e < edges.size(); ++e)
                table_[size_t(edges[e].a) * n_ + edges[e].b] = table_[size_t(edges[e].b) * n_ + edges[e].a] = e;
        }
        vector<Key> toggled = sum;
        const auto toggle = [&](Key e) {
            const size_t a = edges[e].a, b = edges[e].b;
            bit_[a * words_ + b / 64] ^= Word(1) << (b % 64), bit_[b * words_ + a / 64] ^= Word(1) << (a % 64);
        };
        for (const Key e : sum) toggle(e);
        pivot = kNone;
        for (Id e = Id(*std::min_element(sum.begin(), sum.end())); e < edges.size() && pivot == kNone; ++e) {
            const size_t a = edges[e].a, b = edges[e].b;
            for (size_t i = 0; i < words_; ++i) {
                const Word with = bit_[a * words_ + b / 64] >> (b % 64) & 1;
                for (Word odd = bit_[a * words_ + i] ^ bit_[b * words_ + i] ^ (0 - with); odd != 0; odd &= odd - 1) {
                    const Id w = Id(64 * i) + Id(__builtin_ctzll(odd));
                    if (w >= n_ || table_[a * n_ + w] >= e || table_[b * n_ + w] >= e) continue;
                    pivot = keyOf(e, &w, 1);
                    break;
                }
                if (pivot == kNone) continue;
                const Key edge = shortcut(2, pivot);
                if (edge == kNone) break;
                toggle(edge), toggled.push_back(edge);  // the edge e: so what was before this triangle stays away
                pivot = kNone, i = size_t(-1);
            }
        }
        for (const Key e : toggled) toggle(e);
        return true;
    }
    vector<Edge> edges;  // in their order: by value, larger end, smaller end

private:
    using Joined = std::pair<Id, Id>;  // a vertex, the rank of the edge to it
    Word joinPoints(const Points& points) {
        const size_t dim = points.dim;
        // Beyond that no half of a distance rounds to the limit, the sum of squares being off by less than dim + 3
        // units in the last place.
        const double far = 2 * limit_ + limit_ * 0x1p-30, far2 = far * far * (1 + 0x1p-30);
        for (Id i = 0; i < n_; ++i)
            for (Id j = 0; j < i; ++j) {
                const double *a = &points.x[i * dim], *b = &points.x[j * dim];
                double square = 0;
                for (size_t k = 0; k < dim; ++k) square += (a[k] - b[k]) * (a[k] - b[k]);
                if (far2 > 0x1p-900 && square > far2 && dim < 1000000) continue;
                const double half = halfDistance(a, b, dim);
                if (half <= limit_ && half < kInf) edges.push_back({half, i, j});
            }
        return points.sum;
    }
    Word readDistances(const string& input, bool sparse, double threshold, const Proof& proof) {
        Table table = readTable(input, false, true);
        const auto bad = [&](size_t row, const char* what) {
            badFile(input + ", line " + str(table.lines[row]) + ": " + what);
        };
        Fingerprint sum;
        sum.add(proof.n);
        // Within the threshold is a distance before it is halved; halving rounds tiny ones alone.
        const auto add = [&](size_t i, size_t j, double d) {
            if (d / 2 <= limit_ && d <= 2 * threshold && d / 2 < kInf) edges.push_back({d / 2, Id(i), Id(j)});
            sum.add(d / 2);
        };
        size_t n = table.rows.size();
        const bool triangle = !sparse && table.rows[0].size() == 1 && (n > 1 || table.rows[0][0] != 0);
        if (sparse) {
            std::map<std::pair<Word, Word>, double> entries;
            for (size_t r = n = 0; r < table.rows.size(); ++r) {
                const vector<double>& row = table.rows[r];
                if (row.size() != 3) bad(r, "not two points and a distance");
                for (int k = 0; k < 2; ++k)
                    if (!(row[k] >= 0 && row[k] < 0x1p26 && row[k] == std::floor(row[k]))) bad(r, "no such point");
                const Word i = Word(row[0]), j = Word(row[1]);
                n = std::max<size_t>(n, std::max(i, j) + 1);
                if (!(row[2] >= 0) || (i == j && row[2] != 0)) bad(r, "not a distance");
                if (i == j) continue;
                if (entries.emplace(std::minmax(i, j, std::greater<>()), row[2]).first->second != row[2])
                    bad(r, "another distance than before");
            }
            for (const auto& [ends, d] : entries)
                sum.add(ends.first), sum.add(ends.second), add(ends.first, ends.second, d);
        } else {
            bool diagonal = n > 1;
            for (size_t i = 0; i < table.rows.size(); ++i) {
                if (table.rows[i].size() != (triangle ? i + 1 : n)) bad(i, "neither a square nor a lower triangle");
                diagonal = diagonal && table.rows[i].back() == 0;
            }
            for (size_t i = 0; i < table.rows.size(); ++i) {
                vector<double>& row = table.rows[i];
                for (size_t j = 0; j < row.size(); ++j)
                    if (!(row[j] >= 0) || (!triangle && (row[j] != table.rows[j][i] || (i == j && row[j] != 0))))
                        bad(i, "not a distance, or not that of the other way round");
                if (triangle && diagonal) row.pop_back();
            }
            const size_t skipped = triangle && !diagonal;  // the first point has no row
            n += skipped;
            for (size_t i = skipped; i < n; ++i)
                for (size_t j = 0; j < i; ++j) add(i, j, table.rows[i - skipped][j]);
        }
        if (n != n_) refuse("1", proof.name + ": not of so many points");
        return sum.value();
    }
    Id rank(int p, Key key) const { return Id(key >> (p - 1) * bits_); }
    Key keyOf(Id edge, const Id* other, int count) const {
        Key key = edge;
        while (count > 0) key = key << bits_ | other[--count];
        return key;
    }
    // The vertices, those besides the last edge, both ascending; the rank of the last edge.
    Id read(int p, Key key, Id* v, Id* other) const {
        for (int i = 0; i < p - 1; ++i, key >>= bits_) other[i] = Id(key & ((Key(1) << bits_) - 1));
        const Id ends[] = {edges[key].b, edges[key].a};
        std::merge(other, other + p - 1, ends, ends + 2, v);
        return Id(key);
    }
    // Calls f(w, rank of the last edge to it, from which vertex) for the vertices below `end` that are joined to all of
    // v by edges before `before`, ascending, until f is false.
    template <class Fn> void eachJoined(const Id* v, int count, Id before, Id end, Fn f) const {
        const Joined *at[40] = {}, *last[40] = {};
        for (int i = 0; i < count; ++i) at[i] = &joined_[begin_[v[i]]], last[i] = &joined_[begin_[v[i] + 1]];
        for (; at[0] != last[0] && at[0]->first < end; ++at[0]) {
            Id latest = at[0]->second;
            int far = 0, i = 1;
            for (; i < count; ++i) {
                while (at[i] != last[i] && at[i]->first < at[0]->first) ++at[i];
                if (at[i] == last[i]) return;
                if (at[i]->first != at[0]->first) break;
                if (at[i]->second > latest) latest = at[i]->second, far = i;
            }
            if (i == count && latest < before && !f(at[0]->first, latest, far)) return;
        }
    }
    // Cliques of candidates, all of which are joined to what is chosen by edges before e: from the largest down, each
    // time the last candidate first. Of the last one chosen those before it decide.
    template <class Fn>
    void choose(int p, Id e, int depth, vector<vector<Id>>& candidates, vector<Id>& others, Fn& f) const {
        const vector<Id>& from = candidates[depth];
        vector<Id>& next = candidates[depth + 1];
        for (size_t i = from.size(); i-- > 0;) {
            others[p - 2 - depth] = from[i];
            const bool lowest = depth == p - 2;
            const Joined *at = &joined_[begin_[from[i]]], *last = &joined_[begin_[from[i] + 1]];
            next.clear();
            for (size_t c = 0; c < i && (!lowest || next.empty()); ++c) {
                while (at != last && at->first < from[c]) ++at;
                if (at != last && at->first == from[c] && at->second < e) next.push_back(from[c]);
            }
            if (lowest)
                f(keyOf(e, others.data(), p - 1), !next.empty(), i == 0);
            else
                choose(p, e, depth + 1, candidates, others, f);
        }
    }
    Id n_;
    double limit_ = 0;
    vector<size_t> begin_;
    vector<Joined> joined_;  // at each vertex, by the other end
    int bits_ = 1;           // of a vertex in a key
    bool isDense_ = false;
    size_t words_ = 0;
    vector<Id> table_;  // ranks of all edges, where it is dense
    vector<Word> bit_;
};
// Simplices of each dimension by value, then by line; their keys are places.
class Listed {
public:
    Listed(const Diagram& diagram, const string& input, const Proof& proof) {
        const Table table = readTable(input, false, false);
        if (diagram.has("filter")) refuse("1", diagram.name + ": of a filter, not of a complex that is listed");
        const auto bad = [&](size_t row, const string& s) {
            badFile(input + ", line " + str(table.lines[row]) + ": " + s);
        };
        Fingerprint sum;
        vector<Ids> rows;
        vector<double> values;
        size_t size = 0;
        for (size_t r = 0; r < table.rows.size(); ++r) {
            const vector<double>& words = table.rows[r];
            Ids& row = rows.emplace_back();
            if (words.size() < 2 || words.size() > 33) bad(r, "not 1 to 32 vertices and a value");
            for (size_t i = 0; i + 1 < words.size(); ++i) {
                if (!(words[i] >= 0 && words[i] < 0x1p32 && words[i] == std::floor(words[i]))) bad(r, "no vertex");
                row.push_back(Id(words[i]));
            }
            std::sort(row.begin(), row.end());
            if (std::adjacent_find(row.begin(), row.end()) != row.end()) bad(r, "a vertex twice");
            values.push_back(words.back());
            size = std::max(size, row.size());
            sum.add(Word(row.size()));
            for (const Id v : row) sum.add(Word(v));
            sum.add(words.back());
        }
        if (sum.value() != proof.input) refuse("1", proof.name + ": not of this input, by its fingerprint");
        place(rows, values, size, bad);
        if (vertices() != proof.n) refuse("1", proof.name + ": not of so many vertices");
        if (proof.degree >= size) refuse("1", proof.name + ": there are no simplices of such a degree");
    }
    size_t vertices() const { return levels_[0].value.size(); }
    double vertexValue(Id v) const { return levels_[0].value[v]; }
    double value(int p, Key key) const { return levels_[p].value[key]; }
    template <class Fn> void each(int p, Fn f) const {
        for (Key key = levels_[p].value.size(); key-- > 0;)
            f(key, partner(p, key) != kNone, p > 1 && shortcut(p, key) != kNone);
    }
    template <class Fn> void eachCoface(int p, Key key, Fn f) const {
        for (const Id coface : levels_[p].cofaces[key]) f(Key(coface));
    }
    // The two of a shortcut pair: the last facet of a simplex, and that one's first coface.
    Key shortcut(int q, Key key) const {
        const Id* const f = &levels_[q].facets[key * (q + 1)];
        const Id last = *std::max_element(f, f + q + 1);
        return levels_[q - 1].cofaces[last][0] == key ? last : kNone;
    }
    Key partner(int p, Key key) const {
        const Ids& cofaces = levels_[p].cofaces[key];
        return !cofaces.empty() && shortcut(p + 1, cofaces[0]) == key ? cofaces[0] : kNone;
    }
    bool pivotOfEdges(const vector<Key>&, Key&) const { return false; }
    vector<Edge> edges;  // between vertices by their keys

protected:
    Listed() = default;
    // Of simplices by their vertices, ascending, at most `size` of them each.
    template <class Fn> void place(const vector<Ids>& rows, const vector<double>& values, size_t size, Fn bad) {
        vector<vector<std::pair<double, size_t>>> order(size);  // of each dimension: values and rows
        for (size_t r = 0; r < rows.size(); ++r) order[rows[r].size() - 1].push_back({values[r], r});
        vector<std::pair<Ids, Id>> below, keys;  // by vertices
        levels_.resize(size + 1);
        for (size_t p = 0; p < size; ++p) {
            std::sort(order[p].begin(), order[p].end());
            keys.clear();
            Level& level = levels_[p];
            level.cofaces.resize(order[p].size());
            for (const auto& [value, r] : order[p]) {
                const Id key = Id(level.value.size());
                keys.emplace_back(rows[r], key);
                level.value.push_back(value);
                for (size_t i = 0; i <= p && p > 0; ++i) {
                    Ids facet = rows[r];
                    facet.erase(facet.begin() + long(i));
                    const auto at = std::lower_bound(below.begin(), below.end(), std::make_pair(facet, Id(0)));
                    if (at == below.end() || at->first != facet || levels_[p - 1].value[at->second] > value)
                        bad(r, "a face is missing, or enters later");
                    level.facets.push_back(at->second);
                    levels_[p - 1].cofaces[at->second].push_back(key);
                }
            }
            std::sort(keys.begin(), keys.end());
            for (size_t i = 1; i < keys.size(); ++i)
                if (keys[i - 1].first == keys[i].first) bad(order[p][keys[i].second].second, "a simplex twice");
            below.swap(keys);
        }
        for (size_t e = 0; e < levels_[1].value.size(); ++e)
            edges.push_back({levels_[1].value[e], levels_[1].facets[2 * e], levels_[1].facets[2 * e + 1]});
    }

private:
    struct Level {
        vector<double> value;
        Ids facets;           // keys, p + 1 each
        vector<Ids> cofaces;  // ascending
    };
    vector<Level> levels_;
};
// All sets of up to degree + 2 points, each at the radius of its smallest enclosing ball: that of its smallest sphere
// if the centre is strictly inside, else the largest of its facets.
class Cech : public Listed {
public:
    Cech(const Diagram& diagram, const string& input, const Proof& proof) {
        checkHead(diagram, proof);
        if (diagram.has("threshold")) refuse("1", diagram.name + ": up to a threshold, not the whole complex");
        points_ = readPoints(diagram, input, proof);
        if (points_.sum != proof.input) refuse("1", proof.name + ": not of this input, by its fingerprint");
        const Id n = Id(proof.n);
        double count = 0, some = 1;
        for (Word p = 0; p <= proof.degree + 1 && p < n; ++p) count += some *= double(n - p) / double(p + 1);
        if (count > 0x1p31) refuse("2", input + ": more simplices than this program can number");
        lowest_ = lowestDigit(points_.x.data(), points_.x.size());
        for (const double c : points_.x) place_.push_back(integer(c, lowest_));
        vector<Ids> sets;  // of all sizes, of each by vertices
        vector<double> radii;
        for (Id v = 0; v < n; ++v) sets.push_back({v}), radii.push_back(0);
        size_t facets = 0;
        for (Word p = 1; p <= proof.degree + 1; ++p) {
            const size_t begin = facets;
            facets = sets.size();
            for (size_t s = begin; s < facets; ++s)
                for (Id v = sets[s].back() + 1; v < n; ++v) {
                    Ids set = sets[s];
                    set.push_back(v);
                    double radius = 0;
                    if (!isCentred(set, radius)) radius = ofFacets(set, sets, radii, begin, facets);
                    sets.push_back(std::move(set)), radii.push_back(radius);
                }
        }
        place(sets, radii, proof.degree + 2, [](size_t, const char* what) { refuse("2", what); });
    }

private:
    double ofFacets(const Ids& set, const vector<Ids>& sets, const vector<double>& radii, size_t begin, size_t end) {
        double most = 0;
        for (size_t i = 0; i < set.size(); ++i) {
            Ids facet = set;
            facet.erase(facet.begin() + long(i));
            const auto at = std::lower_bound(sets.begin() + long(begin), sets.begin() + long(end), facet);
            most = std::max(most, radii[size_t(at - sets.begin())]);
        }
        return most;
    }
    // Is the centre strictly inside? With v_i from the first point to the others it is the first and the sum of x_i v_i
    // where 2 v_i v_j x_j = v_i v_i, and the square of the radius is half of the sum of x_i v_i v_i. By elimination
    // without fractions, which leaves the determinant in the diagonal and as many times x_i behind it.
    bool isCentred(const Ids& set, double& radius) const {
        const size_t k = set.size() - 1, dim = points_.dim;
        if (k == 1) return radius = halfDistance(&points_.x[set[0] * dim], &points_.x[set[1] * dim], dim), true;
        if (k > dim) return false;
        vector<mpz_class> v(k * dim), a(k * (k + 1)), square(k);
        for (size_t i = 0; i < k; ++i)
            for (size_t c = 0; c < dim; ++c) v[i * dim + c] = place_[set[i + 1] * dim + c] - place_[set[0] * dim + c];
        for (size_t i = 0; i < k; ++i)
            for (size_t j = 0; j <= i; ++j) {
                mpz_class product = 0;
                for (size_t c = 0; c < dim; ++c) product += v[i * dim + c] * v[j * dim + c];
                if (i == j) square[i] = a[i * (k + 1) + k] = product;
                a[i * (k + 1) + j] = a[j * (k + 1) + i] = 2 * product;
            }
        mpz_class before = 1, term;
        for (size_t s = 0; s < k; ++s) {
            const mpz_class pivot = a[s * (k + 1) + s];
            if (pivot == 0) return false;  // they are in a flat of less dimensions
            for (size_t i = 0; i < k; ++i) {
                if (i == s) continue;
                const mpz_class factor = a[i * (k + 1) + s];
                for (size_t j = 0; j <= k; ++j) {
                    mpz_class& entry = a[i * (k + 1) + j];
                    term = pivot * entry - factor * a[s * (k + 1) + j];
                    mpz_divexact(entry.get_mpz_t(), term.get_mpz_t(), before.get_mpz_t());
                }
            }
            before = pivot;
        }
        mpz_class first = before, sum = 0;
        for (size_t i = 0; i < k; ++i) {
            const mpz_class& x = a[i * (k + 1) + k];
            if (x <= 0) return false;
            first -= x, sum += x * square[i];
        }
        if (first <= 0) return false;
        const mpz_class below = 2 * before;
        const long digits = 136 + long(mpz_sizeinbase(below.get_mpz_t(), 2)) - long(mpz_sizeinbase(sum.get_mpz_t(), 2)),
                   shift = digits > 0 ? digits + digits % 2 : 0;
        sum <<= shift;
        const mpz_class whole = sum / below;
        return radius = nearestRoot(whole, lowest_ - shift / 2, whole * below != sum), true;
    }
    Points points_;
    int lowest_ = 0;
    vector<mpz_class> place_;  // times 2^-lowest_
};
//---- STEP 3: COLUMNS ----------------------------------------------------------------------------------------------
template <class Complex> class Columns {
public:
    Columns(Complex& complex, Proof& proof) : complex_(complex), proof_(proof) {
        std::unordered_set<Key> below = components();
        for (int p = 1; p <= int(proof.degree); ++p) below = degree(p, below);
        if (proof.at != proof.bytes.size()) proof.bad("bytes behind the end");
        std::sort(bars.begin(), bars.end());
    }
    vector<Bar> bars;
    size_t columns = 0;

private:
    void add(int degree, double birth, double death) {
        if (birth != death) bars.push_back({Word(degree), birth, death});
    }
    // Degree 0: of two components that an edge joins the one with the younger vertex ends. The edges that join some.
    std::unordered_set<Key> components() {
        std::unordered_set<Key> joining;
        Ids root(complex_.vertices());
        std::iota(root.begin(), root.end(), 0);
        const auto find = [&](Id v) {
            while (root[v] != v) v = root[v] = root[root[v]];
            return v;
        };
        for (size_t e = 0; e < complex_.edges.size(); ++e) {
            const Id a = find(complex_.edges[e].a), b = find(complex_.edges[e].b);
            if (a == b) continue;
            root[std::max(a, b)] = std::min(a, b);
            add(0, complex_.vertexValue(std::max(a, b)), complex_.edges[e].value);
            joining.insert(e);
        }
        for (Id v = 0; v < root.size(); ++v)
            if (root[v] == v) add(0, complex_.vertexValue(v), kInf);
        return joining;
    }
    // below: p-simplices that end a class, but for those of shortcut pairs. Returns those of dimension p + 1.
    std::unordered_set<Key> degree(int p, const std::unordered_set<Key>& below) {
        std::unordered_set<Key> pivots;
        vector<Key> order, sum;  // the columns so far
        Word plain = proof_.number();
        complex_.each(p, [&](Key key, bool birth, bool death) {
            if (death || below.count(key) > 0) return;  // its column is 0
            if (birth) {
                const Key partner = complex_.partner(p, key);
                if (partner != kNone) add(p, complex_.value(p, key), complex_.value(p + 1, partner));
                return;
            }
            sum.assign(1, key);
            if (plain > 0 && --plain == 0) {
                Word last = order.size();
                for (Word left = proof_.number() + 1; left > 0; --left) {
                    const Word gap = proof_.number();
                    if (gap >= last) proof_.bad("a column that is not before the one it is added to");
                    sum.push_back(order[last -= gap + 1]);
                }
                plain = proof_.number();
            }
            order.push_back(key);
            const Key pivot = pivotOf(p, sum);
            if (pivot != kNone && !pivots.insert(pivot).second)
                refuse("3", proof_.name + ", degree " + str(p) + ", column " + str(order.size() - 1) +
                                ": another one has its pivot");
            add(p, complex_.value(p, key), pivot == kNone ? kInf : complex_.value(p + 1, pivot));
        });
        if (plain != 0) refuse("3", proof_.name + ", degree " + str(p) + ": more columns than there are");
        columns += order.size();
        return pivots;
    }
    // The first coface of the sum that is in no shortcut pair, after the facets of shortcut pairs before were added.
    Key pivotOf(int p, const vector<Key>& sum) {
        Key pivot = kNone;
        if (sum.size() == 1) {  // mostly that is all
            complex_.eachCoface(p, sum[0], [&](Key coface) { pivot = std::min(pivot, coface); });
            if (pivot == kNone || complex_.shortcut(p + 1, pivot) == kNone) return pivot;
        }
        if (p == 1 && complex_.pivotOfEdges(sum, pivot)) return pivot;
        std::priority_queue<Key, vector<Key>, std::greater<>> heap;  // what is there twice is not
        const auto push = [&](Key coface) { heap.push(coface); };
        for (const Key key : sum) complex_.eachCoface(p, key, push);
        for (pivot = kNone; !heap.empty(); pivot = kNone) {
            pivot = heap.top();
            heap.pop();
            if (!heap.empty() && heap.top() == pivot) {
                heap.pop();
                continue;
            }
            const Key facet = complex_.shortcut(p + 1, pivot);
            if (facet == kNone) break;
            heap.push(pivot);
            complex_.eachCoface(p, facet, push);
        }
        return pivot;
    }
    Complex& complex_;
    Proof& proof_;
};
//---- STEP 4 -------------------------------------------------------------------------------------------------------
template <class Complex> string verify(const Diagram& diagram, const string& input, Proof& proof) {
    Complex complex(diagram, input, proof);
    const Columns<Complex> columns(complex, proof);
    const vector<Bar>&found = columns.bars, &claimed = diagram.bars;
    const auto equal = [](const Bar& a, const Bar& b) { return !(a < b) && !(b < a); };
    const auto [f, c] = std::mismatch(found.begin(), found.end(), claimed.begin(), claimed.end(), equal);
    const string where = diagram.name + (c == claimed.end() ? ", at its end" : ", line " + str(c->line));
    if (f != found.end() && (c == claimed.end() || *f < *c))
        refuse("4", where + ": here the bar " + f->text() + " is missing");
    if (c != claimed.end()) refuse("4", where + ": there is no such bar, or not so often");
    return "verified   " + diagram.name + ": degrees 0 to " + str(proof.degree) + "\ncomplex    " +
           str(complex.vertices()) + " vertices, " + str(complex.edges.size()) + " edges, " + str(columns.columns) +
           " columns\n";
}
}  // namespace
int main(int argc, char** argv) {
    const bool quiet = argc == 5 && string(argv[4]) == "--quiet";
    if (argc != 4 && !quiet) return std::fputs("usage: netmesh-verify-rips INPUT DIAGRAM PROOF [--quiet]\n", stderr), 2;
    try {
        const Diagram diagram = readDiagram(argv[2]);
        for (const char* claim : {"box", "cell", "radii", "weights", "a"})  // a: a choice of bars
            if (diagram.has(claim)) badFile(diagram.name + ": by its head it claims something else: # " + claim);
        Proof proof(argv[3], diagram);
        const bool listed = proof.kind == 5, cech = proof.kind == 6;
        const char* const filter = cech ? "cech" : "rips";
        if (!listed && (!diagram.has("filter") || diagram.head.at("filter") != filter))
            refuse("1", diagram.name + ": not one line # filter " + filter);
        const string report = (listed ? verify<Listed> : cech ? verify<Cech> : verify<Rips>)(diagram, argv[1], proof);
        if (!quiet) std::fputs(report.c_str(), stdout);
        return 0;
    } catch (const Failure& failure) {
        return std::fprintf(stderr, "netmesh-verify-rips: %s\n", failure.second.c_str()), failure.first;
    } catch (const std::exception& error) {
        return std::fprintf(stderr, "netmesh-verify-rips: not proven: %s\n", error.what()), 7;  // no memory
    }
}
