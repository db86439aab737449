// netmesh-verify POINTS DIAGRAM PROOF [--quiet]
//
// Verifies that a persistence diagram of points is the exact one, by the proof beside it. What is claimed, what the
// files hold and why the checks are enough is on the page tools/docs/proofs.md; steps 1 to 6 below are those of that
// page. This file is all of the program, it shares no code with netmesh, and needs nothing but GMP:
//
//     c++ -std=c++17 -O2 -ffp-contract=off netmesh-verify.cpp -lgmpxx -lgmp
//
// The bounds on rounding hold for IEEE doubles, each operation rounded to nearest: no -ffast-math, no x87, no
// contraction to fused operations. Exit: 0 verified; 7 not proven (stderr names the step and the place); 2 usage; 3 a
// file that can not be read or is not of its format.

#include <gmpxx.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <limits>
#include <map>
#include <queue>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using std::size_t, std::string, std::string_view, std::vector;
using Word = std::uint64_t;
using Id = std::uint32_t;

constexpr Id kNone = 0xFFFFFFFF;
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kUnit = 0x1p-53;  // the relative error of one rounding

struct Failure {
    int code;
    string text;
};
[[noreturn]] void badFile(const string& text) { throw Failure{3, text}; }
[[noreturn]] void refuse(const string& step, const string& text) {
    throw Failure{7, "not proven: step " + step + ": " + text};
}

template <class T> string str(T v) { return std::to_string(v); }
string str(double v, int digits = 17) {
    char s[40];
    std::snprintf(s, sizeof s, "%.*g", digits, v);
    return s;
}

template <class To, class From> To bitsAs(From v) {
    static_assert(sizeof(To) == sizeof(From));
    To to;
    std::memcpy(&to, &v, sizeof v);
    return to;
}
Word littleEndian(const char* bytes, size_t count) {
    Word w = 0;
    for (size_t i = 0; i < count; ++i) w |= Word(static_cast<unsigned char>(bytes[i])) << (8 * i);
    return w;
}

Word mix(Word z) {
    z += 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
}
struct Fingerprint {
    Word state = 0x6E65746D65736800;
    void add(Word w) { state = mix(state ^ w) + 0x632BE59BD9B4E019 * w; }
    void add(double v) { add(bitsAs<Word>(v)); }
    Word value() const { return mix(state); }
};

// STEP 1: files

struct Points {
    size_t dim = 0, rows = 0;
    vector<double> x;  // rows * dim, never -0
};

struct Bar {
    Word degree;
    double birth, death;
    size_t line = 0;  // of the diagram
    bool operator<(const Bar& b) const { return std::tie(degree, birth, death) < std::tie(b.degree, b.birth, b.death); }
    string text() const { return str(degree) + " " + str(birth) + " " + str(death); }
};

struct Diagram {
    Word dim = 0, maxDegree = 0, points = 0, duplicates = 0, fingerprint = 0;
    vector<Bar> bars;
};

struct Proof {
    vector<Id> rows;   // for each place
    vector<Id> cells;  // dim + 1 places each
};

string readFile(const string& name) {
    std::error_code error;
    std::FILE* file = std::filesystem::is_regular_file(name, error) ? std::fopen(name.c_str(), "rb") : nullptr;
    if (!file) badFile(name + ": no file that can be read");
    string bytes(std::filesystem::file_size(name), '\0');
    const size_t read = std::fread(&bytes[0], 1, bytes.size(), file);
    std::fclose(file);
    if (read != bytes.size()) badFile(name + ": can not be read");
    return bytes;
}

// Calls line(words, number) for each line. Between words are blanks or, if `marks`, one comma or semicolon with blanks
// around; what follows # is then left out.
template <class Fn> void forLines(const string& text, bool marks, Fn line) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    const auto mark = [&](char c) { return marks && (c == ',' || c == ';'); };
    vector<string_view> words;
    size_t number = 0;
    for (const char *p = text.data(), *const last = p + text.size(), *next; p < last; p = next + 1) {
        next = std::find(p, last, '\n');
        const char* const end = marks ? std::find(p, next, '#') : next;
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
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (std::is_same_v<T, double> && error == std::errc::result_out_of_range) {
        value = T(std::strtod(string(word).c_str(), nullptr));  // 0 or infinite
        error = std::errc();
    }
    return error == std::errc() && end == word.data() + word.size() && value == value;
}

Points readPoints(const string& name) {
    const string bytes = readFile(name);
    Points points;
    if (bytes.compare(0, 6, "\x93NUMPY") == 0) {  // as numpy writes it
        const size_t wide = bytes.size() > 6 && bytes[6] > 1 ? 4 : 2;
        const size_t begin = bytes.size() < 12 ? bytes.size() : 8 + wide + littleEndian(&bytes[8], wide);
        unsigned long long rows = 0, dim = 0;
        char byColumns[6] = "";
        constexpr const char* head =
            "{ 'descr' : '<f8' , 'fortran_order' : %5[A-Za-z] , 'shape' : ( %18llu , %18llu ) ";
        if (begin >= bytes.size() || std::sscanf(&bytes[8 + wide], head, byColumns, &rows, &dim) != 3 || dim == 0 ||
            (bytes.size() - begin) % (8 * dim) != 0 || (bytes.size() - begin) / (8 * dim) != rows)
            badFile(name + ": not an .npy file of little endian doubles of shape (rows, dim)");
        points.dim = dim;
        points.rows = rows;
        points.x.resize(rows * dim);
        for (size_t i = 0; i < rows * dim; ++i) {
            double& x = points.x[byColumns[0] == 'T' ? i % rows * dim + i / rows : i];
            x = bitsAs<double>(littleEndian(&bytes[begin + 8 * i], 8)) + 0.0;  // -0 becomes 0
            if (!std::isfinite(x)) badFile(name + ": byte " + str(begin + 8 * i) + ": not a finite number");
        }
    } else {
        forLines(bytes, true, [&](const vector<string_view>& words, size_t line) {
            if (words.empty()) return;
            if (points.rows++ == 0) points.dim = words.size();
            if (words.size() != points.dim) badFile(name + ", line " + str(line) + ": not as many numbers as before");
            for (const string_view word : words) {
                double x;
                if (!readNumber(word, x) || !std::isfinite(x))
                    badFile(name + ", line " + str(line) + ": not a finite number");
                points.x.push_back(x + 0.0);
            }
        });
    }
    if (points.rows == 0 || points.rows >= kNone || points.dim < 2 || points.dim > 6)
        badFile(name + ": no points, or too many, or not of dimension 2 to 6");
    return points;
}

Diagram readDiagram(const string& name) {
    Diagram diagram;
    Fingerprint sum;
    std::map<string, string> head;
    forLines(readFile(name), false, [&](const vector<string_view>& words, size_t line) {
        const auto bad = [&](const char* what) { badFile(name + ", line " + str(line) + ": " + what); };
        if (!words.empty() && words[0][0] == '#') {
            if (words[0] != "#" || words.size() < 2) return;
            const auto [at, first] = head.emplace(words[1], words.size() == 3 ? words[2] : "");
            if (!first) at->second.clear();
            return;
        }
        Bar bar{0, 0, 0, line};
        if (words.size() != 3 || !readNumber(words[0], bar.degree) || !readNumber(words[1], bar.birth) ||
            !readNumber(words[2], bar.death))
            bad("not degree, birth and death");
        if (!diagram.bars.empty() && bar < diagram.bars.back()) bad("bars are not sorted");
        sum.add(bar.degree);
        sum.add(bar.birth);
        sum.add(bar.death);
        diagram.bars.push_back(bar);
    });
    head.emplace("duplicates", "0");
    if (head["filter"] != "alpha") badFile(name + ": not one line # filter alpha");
    for (const auto& [key, value] : {std::pair<const char*, Word*>{"dim", &diagram.dim},
                                     {"points", &diagram.points},
                                     {"max-degree", &diagram.maxDegree},
                                     {"duplicates", &diagram.duplicates}})
        if (!readNumber(head[key], *value)) badFile(name + ": not one line # " + key + " and a number");
    diagram.fingerprint = sum.value();
    return diagram;
}

Proof readProof(const string& name, const Points& points, Word different, Word pointsSum, Word diagramSum) {
    const string bytes = readFile(name);
    if (bytes.compare(0, 16, "netmesh proof 1\n") != 0) badFile(name + ": not a proof of version 1");
    size_t at = bytes.size(), end = at - 8, width = 1;
    const auto bad = [&](const string& what) { refuse("1", name + ", before byte " + str(at) + ": " + what); };
    const auto take = [&](size_t count) {
        if (count > end - at) bad("the file is too short");
        return littleEndian(&bytes[std::exchange(at, at + count)], count);
    };
    if (bytes.size() < 64) bad("the file is too short");
    Fingerprint sum;
    sum.add(Word(end));
    for (size_t i = 0; i < end; i += 8) sum.add(littleEndian(&bytes[i], std::min<size_t>(8, end - i)));
    if (littleEndian(&bytes[end], 8) != sum.value()) bad("the file is damaged, by its fingerprint");
    at = 16;
    if (take(4) != 1) bad("not of kind 1, the alpha complex");
    if (take(4) != points.dim) bad("not the dimension of the points");
    if (take(8) != different) bad("not as many points as the file has different ones");
    const size_t c = take(8), size = points.dim + 1;
    if (take(8) != pointsSum) bad("not of these points, by their fingerprint");
    if (take(8) != diagramSum) bad("not of this diagram, by its fingerprint");

    Proof proof;
    proof.rows.resize(different);
    while ((points.rows - 1) >> (8 * width) != 0) ++width;
    for (Id& row : proof.rows) {
        row = Id(take(width));
        if (row >= points.rows) bad("there is no row " + str(row));
    }
    if (c > (end - at) / size || c >= kNone) bad("more cells than the file can hold");
    proof.cells.resize(c * size);
    for (size_t i = 0; i < c * size; ++i) {
        Id* const place = &proof.cells[i];
        const auto badCell = [&](const string& what) { bad("cell " + str(i / size) + ": " + what); };
        Word v = 0, byte = 128;
        for (int shift = 0; byte >= 128; shift += 7) {
            byte = take(1);
            v |= (byte & 127) << shift;
            if (shift > 28 || (byte == 0 && shift > 0)) badCell("a number of more bytes than it takes");
        }
        if (i % size > 0) v += Word(place[-1]) + 1;
        if (i % size == 0 && i > 0) v += *(place - size);
        if (v >= different) badCell("there is no place " + str(v));
        *place = Id(v);
        const Id* const next = place + 1;
        if (i > size && i % size == points.dim &&
            !std::lexicographical_compare(next - 2 * size, next - size, next - size, next))
            badCell("it is not after the one before");
    }
    if (at != end) bad("bytes behind the cells");
    return proof;
}

// For each row the first one that is equal to it.
vector<Id> firstEqual(const Points& points) {
    size_t size = 4;
    while (size < 2 * points.rows) size *= 2;
    vector<Id> table(size, kNone), first(points.rows);
    for (size_t row = 0; row < points.rows; ++row) {
        const double* const x = &points.x[row * points.dim];
        Word slot = 0;
        for (size_t j = 0; j < points.dim; ++j) slot = mix(slot ^ bitsAs<Word>(x[j]));
        for (slot &= size - 1; table[slot] != kNone; slot = (slot + 1) & (size - 1))
            if (std::equal(x, x + points.dim, &points.x[table[slot] * points.dim])) break;
        if (table[slot] == kNone) table[slot] = Id(row);
        first[row] = table[slot];
    }
    return first;
}

// NUMBERS. An expression of coordinates is written once, as a template, and computed with Approx; if that leaves its
// sign open with mpz_class.

// A double v and a bound: |v - the true value| <= c kUnit m, where c counts roundings, see Verifier::sign. If
// differences of coordinates are integers, then v is exact as long as all products have m < 2^50; sums are of at most
// 42 terms.
struct Approx {
    double v = 0, m = 0;
    static bool exact;
    void operator+=(const Approx& b) { v += b.v, m += b.m; }
    void operator-=(const Approx& b) { v -= b.v, m += b.m; }
    friend Approx operator*(const Approx& a, const Approx& b) {
        const Approx product{a.v * b.v, a.m * b.m};
        if (!(product.m < 0x1p50)) exact = false;
        return product;
    }
};
bool Approx::exact = false;

// By the first rows, one after the other: minor[s] is the determinant of the first |s| rows and the columns in s.
template <class T, int N> T det(const T (&a)[N][N]) {
    T minor[1 << N];
    for (int c = 0; c < N; ++c) minor[1 << c] = a[0][c];
    for (unsigned s = 1; s < 1u << N; ++s) {
        const int row = __builtin_popcount(s) - 1;
        for (int c = 0, left = row; c < N && row > 0; ++c) {
            if (!(s >> c & 1)) continue;
            if (left-- % 2 == 0)
                minor[s] += a[row][c] * minor[s ^ 1u << c];
            else
                minor[s] -= a[row][c] * minor[s ^ 1u << c];
        }
    }
    return minor[(1 << N) - 1];
}

// The double nearest to 2^exponent sqrt(numerator / denominator), ties to even.
double nearestRoot(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
    const auto bits = [](const mpz_class& z) { return long(mpz_sizeinbase(z.get_mpz_t(), 2)); };
    const long shift = std::max(0L, (133 + bits(denominator) - bits(numerator)) / 2);  // the root has 65 bits or more
    const mpz_class scaled = numerator << (2 * shift);
    mpz_class root = scaled / denominator;
    root = sqrt(root);
    const bool more = root * root * denominator != scaled;  // the value is (root + something below 1) 2^exponent
    exponent -= shift;
    const long last = std::max(-1074L, exponent + bits(root) - 53);  // the exponent of the last bit of the double
    const unsigned long drop = last - exponent;                      // bits; at least 12
    const mpz_class half = mpz_class(1) << (drop - 1);
    mpz_class kept = root >> drop;
    const mpz_class rest = root - (kept << drop);
    if (rest > half || (rest == half && (more || kept % 2 == 1))) ++kept;
    return std::ldexp(kept.get_d(), int(std::min(last, 2000L)));
}

// Error free: high + low is the sum, the product.
inline void twoSum(double a, double b, double& high, double& low) {
    high = a + b;
    const double c = high - a;
    low = (a - (high - c)) + (b - c);
}
inline void twoProduct(double a, double b, double& high, double& low) {
    constexpr double splitter = 0x1p27 + 1;
    high = a * b;
    const double ca = splitter * a, cb = splitter * b;
    const double ah = ca - (ca - a), bh = cb - (cb - b), al = a - ah, bl = b - bh;
    low = ((ah * bh - high) + ah * bl + al * bh) + al * bl;
}

template <int D> double dot(const double* a, const double* b) {
    double s = a[0] * b[0];
    for (int j = 1; j < D; ++j) s += a[j] * b[j];
    return s;
}

// Of a sphere through p_0: its centre from p_0 on is c, approximately x.
template <int D> struct Ball {
    double x[D], norm;  // |x|
    double delta;       // at least |x - c|; or it is infinite, and nothing is claimed

    // The sign of |w - p_0 - c|^2 - R^2 = v.(v - 2c) for v = w - p_0; 2 if not sure. The error is 2 |v||x - c| and, u
    // for v, 2u for v - 2x, D u for products and sums, of |v|(|v| + 2|x|).
    int side(const double* w, const double* p0) const {
        double s = 0, vv = 0;
        for (int j = 0; j < D; ++j) {
            const double v = w[j] - p0[j];
            s += v * (v - 2 * x[j]);
            vv += v * v;
        }
        if (!(vv >= 0x1p-300) || delta == kInf) return 2;
        const double v = std::sqrt(vv), bound = 1.0001 * v * (2 * delta + (D + 5) * kUnit * (v + 2 * norm));
        return s > bound ? 1 : s < -bound ? -1 : 2;
    }
};

// The smallest sphere through p_0 .. p_K in R^D, in doubles, with proven bounds. Let e_i = p_i - p_0 for i = 1 .. K,
// E the matrix of these rows, and c the centre from p_0 on: the vector in their span with 2 e_i.c = |e_i|^2. Let u be
// kUnit. Coordinates are below 2^100, |e_i| >= 2^-150, |F| <= 2^200, |x| <= 2^150, else nothing is claimed. So nothing
// overflows; and what underflows, below 2^-1000, is much smaller than the bounds, which all have terms of at least
// u^2 2^-301, and room for it. Bounds of sums are by Cauchy and Schwarz: sum |a_j b_j| <= |a||b|.
//
// Whatever doubles f_i (rows of F) and x are, let M = I - F E^T. If |M| <= 1/2, then E has rank K, and for a vector
// d = sum a_i e_i in the span F d = F E^T a = (I - M) a, so |a| <= 2 |F||d|. Let x = c + d + d', d in the span, d'
// normal to it, and rho_i = e_i.(2x - e_i) = 2 e_i.d. Then |d|^2 = sum a_i e_i.d = a.rho / 2, so |d| <= |F||rho|.
// |d'| is at most the distance of x to any vector y of the span; y = sum b_i e_i, b_i = f_i.x. For K = D it is 0.
template <int D, int K> struct Sphere : Ball<D> {
    using Ball<D>::x, Ball<D>::norm, Ball<D>::delta;
    const double* p[K + 1];
    double e[K][D], length[K], b[K], gap;  // gap: at least |y - x|

    Sphere(const double* coordinates, const Id* vertices, bool claim) {
        double q[K][D], r[K][K], qq[K], f[K][D];  // Gram and Schmidt: e_i = q_i + sum r_ih q_h
        double sumE = 0, sumF = 0, sumM = 0, sumRho = 0;
        delta = kInf;
        if (!claim) return;
        for (int i = 0; i <= K; ++i) p[i] = coordinates + size_t(vertices[i]) * D;
        for (int j = 0; j < D; ++j) x[j] = 0;
        for (int i = 0; i < K; ++i) {
            for (int j = 0; j < D; ++j) q[i][j] = e[i][j] = p[i + 1][j] - p[0][j];
            const double ee = dot<D>(e[i], e[i]);
            if (!(ee >= 0x1p-300)) return;
            sumE += ee;
            length[i] = std::sqrt(ee);
            for (int h = 0; h < i; ++h) {
                r[i][h] = dot<D>(q[i], q[h]) / qq[h];
                for (int j = 0; j < D; ++j) q[i][j] -= r[i][h] * q[h][j];
            }
            qq[i] = dot<D>(q[i], q[i]);
            const double t = (0.5 * ee - dot<D>(e[i], x)) / qq[i];
            for (int j = 0; j < D; ++j) x[j] += t * q[i][j];
        }
        for (int i = K - 1; i >= 0; --i) {
            for (int j = 0; j < D; ++j) f[i][j] = q[i][j] / qq[i];
            for (int h = i + 1; h < K; ++h)
                for (int j = 0; j < D; ++j) f[i][j] -= r[h][i] * f[h][j];
            sumF += dot<D>(f[i], f[i]);
        }
        norm = std::sqrt(dot<D>(x, x));
        if (!(sumF <= 0x1p400 && norm <= 0x1p150)) return;
        // An entry of M: u for e, 1 for each product and D for sums, of |f_i||e_j|: below (D + 3) u |f_i||e_j|.
        for (int i = 0; i < K; ++i)
            for (int h = 0; h < K; ++h) {
                const double m = dot<D>(f[i], e[h]) - (i == h);
                sumM += m * m;
            }
        if (!(std::sqrt(sumM) + (D + 4) * kUnit * std::sqrt(sumE * sumF) <= 0.49)) return;
        // e_i.(2x - e_i): u for e, 2u for the other factor, 1 for each product and D - 1 for sums: (D + 4) u.
        // y - x: u for e, 1 for each product, K for sums, of |b_i||e_i| and |x|.
        double y[D], sizeY = norm;
        for (int j = 0; j < D; ++j) y[j] = -x[j];
        for (int i = 0; i < K; ++i) {
            double s = 0;
            b[i] = dot<D>(f[i], x);
            for (int j = 0; j < D; ++j) {
                s += e[i][j] * (2 * x[j] - e[i][j]);
                y[j] += b[i] * e[i][j];
            }
            s = std::abs(s) + (D + 5) * kUnit * length[i] * (length[i] + 2 * norm);
            sumRho += s * s;
            sizeY += std::abs(b[i]) * length[i];
        }
        gap = 1.0001 * (std::sqrt(dot<D>(y, y)) + (K + 3) * kUnit * sizeY);
        delta = 1.0001 * std::sqrt(sumF * sumRho);  // the factors are for the roundings of the bounds themselves
        if (K < D) delta += gap;
    }

    // The nearest double to the radius, or -1 if that is not sure.
    //
    // R^2 = |c|^2 = Q + error, Q = |x|^2 + sum b_i e_i.(e_i - 2x). For, with x = c + g and e_i.(e_i - 2c) = 0,
    // Q = |c|^2 + 2 c.g + |g|^2 - 2 y.g, so |Q - R^2| = ||g|^2 - 2 (y - c).g| <= |g|^2 + 2 (|y - x| + |g|)|g|.
    //
    // Q with about twice as many bits: e_i = h + l exactly, |l| <= u|h|; h - 2x = zh + zl exactly, and zl + l is
    // rounded. For one coordinate let A = |e|(|e| + 2|x|) >= |h||zh|, up to a factor below 1.01. Left out is
    // l zl and the rounding of zl: below 5 u^2 A. h zh is summed without error; all the rest, less than
    // (5.5 A + 1.1 D sum A) u, in doubles, with at most 4 D + 2 roundings of each part: below 320 u^2 sum A for D <= 6.
    // |x|^2 likewise: below 100 u^2 |x|^2.
    double radius() const {
        double square = 0, low = 0, high, rest, error;
        for (int j = 0; j < D; ++j) {
            twoProduct(x[j], x[j], high, rest);
            twoSum(square, high, square, error);
            low += error + rest;
        }
        double bound = 256 * kUnit * kUnit * norm * norm + 1.001 * delta * (3 * delta + 2 * gap);
        for (int i = 0; i < K; ++i) {
            double s = 0, t = 0, h, l, zh, zl;
            for (int j = 0; j < D; ++j) {
                twoSum(p[i + 1][j], -p[0][j], h, l);
                twoSum(h, -2 * x[j], zh, zl);
                zl += l;
                twoProduct(h, zh, high, rest);
                twoSum(s, high, s, error);
                t += (error + rest) + (h * zl + l * zh);
            }
            t += s;
            low += b[i] * t;
            bound += std::abs(b[i]) *
                     ((K + 5) * kUnit * std::abs(t) + 512 * kUnit * kUnit * length[i] * (length[i] + 2 * norm));
        }
        // Nearest is r if (r - g)^2 < R^2 < (r + g)^2 for half of the step g below it, which is not more than that
        // above: if |R^2 - r^2| < 2 r g - g^2.
        double r = std::sqrt(square + low);
        for (int pass = 0; pass < 2 && r > 0 && r < kInf; ++pass) {
            twoProduct(r, r, high, rest);
            const double d = (square - high) + (low - rest);
            error = bound + 4 * kUnit * (std::abs(square - high) + std::abs(low) + std::abs(rest));
            if (1.001 * error + std::abs(d) < r * (r - bitsAs<double>(bitsAs<Word>(r) - 1)) * (1 - 1e-9)) return r;
            r += d / (2 * r);
        }
        return -1;
    }
};

// FACES

// The simplices of one dimension.
struct Level {
    size_t count = 0;
    vector<Id> vertices;   // ascending; as long as they are needed
    vector<Id> facets;     // for each simplex those opposite to its vertices
    vector<double> value;  // rounded
};

// A face of a simplex: all of its vertices but that at pos. key: the second and third vertex of the face.
struct Face {
    Word key;
    Id parent, pos;
    Id vertex(const Id* simplex, Id j) const { return simplex[j + (j >= pos)]; }
};

// The faces of simplices of W vertices each, ascending, equal ones side by side.
template <Id W> vector<Face> sortedFaces(const vector<Id>& simplices, size_t vertices) {
    const size_t count = simplices.size() / W;
    vector<size_t> start(vertices + 1, 0);  // by the first vertex of the face
    for (size_t i = 0; i < count; ++i) {
        start[simplices[i * W]] += W - 1;
        start[simplices[i * W + 1]] += 1;
    }
    size_t sum = 0;
    for (size_t& s : start) sum += std::exchange(s, sum);
    vector<Face> faces(sum);
    for (size_t i = 0; i < count; ++i) {
        const Id* const v = &simplices[i * W];
        for (Id pos = 0; pos < W; ++pos) {
            Face face{0, Id(i), pos};
            if (W > 2) face.key = Word(face.vertex(v, 1)) << 32;
            if (W > 3) face.key |= face.vertex(v, 2);
            faces[start[face.vertex(v, 0)]++] = face;
        }
    }
    const auto less = [&](const Face& a, const Face& b) {
        if (W <= 4 || a.key != b.key) return a.key < b.key;
        const Id *const va = &simplices[size_t(a.parent) * W], *const vb = &simplices[size_t(b.parent) * W];
        Id j = 3;
        while (j < W - 2 && a.vertex(va, j) == b.vertex(vb, j)) ++j;
        return a.vertex(va, j) < b.vertex(vb, j);
    };
    for (size_t v = 0, begin = 0; v < vertices; begin = start[v++])
        std::sort(faces.begin() + begin, faces.begin() + start[v], less);
    return faces;
}

// Calls group(vertices of the face, begin, end) for each set of equal faces.
template <Id W, class Fn> void forGroups(const vector<Id>& simplices, const vector<Face>& faces, Fn group) {
    const auto vertices = [&](const Face* f, Id* to) {
        for (Id j = 0; j < W - 1; ++j) to[j] = f->vertex(&simplices[size_t(f->parent) * W], j);
    };
    Id here[W - 1], next[W - 1];
    const Face* const end = faces.data() + faces.size();
    for (const Face *f = faces.data(), *g; f < end; f = g) {
        vertices(f, here);
        for (g = f + 1; g < end && g->key == f->key; ++g) {
            vertices(g, next);
            if (!std::equal(here, here + W - 1, next)) break;
        }
        group(here, f, g);
    }
}

// STEPS 3 AND 4

template <int D> class Verifier {
public:
    Level levels[D + 1];
    size_t gmpSigns = 0, gmpValues = 0;

    // Coordinates are scaled by 2^-scale, to integers if they are below 2^100 then, else below 1 if that is possible
    // without error, else all is left to GMP.
    Verifier(const Points& points, Proof&& proof) : n_(proof.rows.size()), rows_(std::move(proof.rows)), x_(n_ * D) {
        levels[D].vertices = std::move(proof.cells);
        levels[D].count = levels[D].vertices.size() / (D + 1);
        int high = -1074, low = 1024, exponent;  // the bits of coordinates are below 2^high, from 2^low on
        for (size_t i = 0; i < n_ * D; ++i) {
            x_[i] = points.x[size_t(rows_[i / D]) * D + i % D];
            if (x_[i] == 0) continue;
            const double m = std::ldexp(std::abs(std::frexp(x_[i], &exponent)), 53);
            high = std::max(high, exponent);
            low = std::min(low, exponent - 53 + __builtin_ctzll(Word(m)));
        }
        fast_ = high - low < 1074;
        if (fast_) scale_ = high - low <= 100 ? low : high;
        lowest_ = low - scale_;
        for (double& v : x_) v = std::ldexp(v, -scale_);
    }

    void triangulation();
    template <int K> void values();  // the simplices of dimension K and less, and their values

private:
    const double* point(Id place) const { return &x_[size_t(place) * D]; }
    string name(const Id* v, int count) const {
        string s = "rows";
        for (int i = 0; i < count; ++i) s += " " + str(rows_[v[i]]);
        return s;
    }

    // Coordinate j of a - b; as an integer in units of 2^lowest_.
    void diff(Id a, Id b, int j, Approx& to) const {
        to.v = point(a)[j] - point(b)[j];
        to.m = std::abs(to.v);
    }
    void diff(Id a, Id b, int j, mpz_class& to) const { to = integer(point(a)[j]) - integer(point(b)[j]); }
    mpz_class integer(double v) const {
        int exponent;
        mpz_class z(std::ldexp(std::frexp(v, &exponent), 53));
        exponent -= 53 + lowest_;
        if (exponent >= 0) return z << exponent;
        return z >> -exponent;  // bits that are 0
    }

    // det of the rows f_i - a: tells the side of the facet f on which a is. For count > 1 a is the centroid of `count`
    // points, and rows are count (f_i - a). Row `replaced`, if not -1, is then the direction from a to the centroid of
    // the facet g.
    template <class T> T sideOf(const Id* f, const Id* a, int count, int replaced = -1, const Id* g = nullptr) const {
        T m[D][D], d;
        for (int i = 0; i < D; ++i)
            for (const Id *v = i == replaced ? g : f + i, *const end = i == replaced ? g + D : v + 1; v < end; ++v)
                for (int k = 0; k < count * D; ++k) {
                    diff(*v, a[k / D], k % D, d);
                    m[i][k % D] += d;
                }
        return det(m);
    }
    // For v = w - s_0, e_i = s_i - s_0 and G the matrix of e_i.e_j: | G  e_i.e_i | v.e_j  v.v | has the determinant
    // det G (v.v - v.G^-1 (e_i.e_i)) = det G (|w - c|^2 - R^2), and det G > 0. For K = D the factor E^T can be left out
    // on the right of the first K columns: then det E is in place of det G.
    template <class T, int K> T power(const Id* s, Id w) const {
        T e[K + 1][D], m[K + 1][K + 1];
        for (int i = 0; i <= K; ++i)
            for (int j = 0; j < D; ++j) diff(i < K ? s[i + 1] : w, s[0], j, e[i][j]);
        for (int i = 0; i <= K; ++i)
            for (int h = 0; h <= K; ++h) {
                if (K == D && h < K) m[i][h] = e[i][h];
                for (int j = 0; j < D && (K < D || h == K); ++j) m[i][h] += e[i][j] * e[h == K ? i : h][j];
            }
        return det(m);
    }

    // Of a determinant of at most 7 rows. m sums its terms without signs. A term has D entries, each with at most 7
    // roundings, one with 43, of sums of differences (sideOf); or K + 1 <= 7, each with at most 13 (power). To these
    // come 7 products and 21 sums of minors: below 120 roundings. m itself is by less than 1 % too small. Nothing
    // overflows, as entries are below 2^107, squares below 2^210; if they are no integers, they are below 2^7, squares
    // below 2^7, and underflow changes v by less than 2^-900.
    template <class Fn> int sign(Fn expression) {
        if (fast_) {
            Approx::exact = lowest_ == 0;
            const Approx a = expression(Approx());
            const double bound = 128 * kUnit * a.m;
            if (std::abs(a.v) > bound && bound > 0x1p-800) return a.v > 0 ? 1 : -1;
            if (Approx::exact) return (a.v > 0) - (a.v < 0);
        }
        ++gmpSigns;
        return sgn(mpz_class(expression(mpz_class())));
    }

    template <int K> double radius(const Sphere<D, K>& sphere, const Id* s) {
        if (sphere.delta < kInf) {
            const double r = std::ldexp(sphere.radius(), scale_);
            if (r >= std::numeric_limits<double>::min() && r < kInf) return r;
        }
        ++gmpValues;  // 4 R^2 = d.G^-1 d for d_i = e_i.e_i, by the determinants of G and of | G d | d 0 |
        mpz_class e[K][D], g[K][K], m[K + 1][K + 1];
        for (int i = 0; i < K; ++i) {
            for (int j = 0; j < D; ++j) diff(s[i + 1], s[0], j, e[i][j]);
            for (int h = 0; h <= i; ++h) {
                for (int j = 0; j < D; ++j) g[i][h] += e[i][j] * e[h][j];
                g[h][i] = m[h][i] = m[i][h] = g[i][h];
            }
            m[i][K] = m[K][i] = g[i][i];
        }
        return nearestRoot(-det(m), 4 * det(g), long(lowest_) + scale_);
    }

    size_t n_;
    vector<Id> rows_;
    vector<double> x_;            // coordinates by places, times 2^-scale_
    int scale_ = 0, lowest_ = 0;  // x_ are integers times 2^lowest_
    bool fast_ = true;            // the bounds hold
    vector<Face> facets_;         // of the cells
};

template <int D> void Verifier<D>::triangulation() {
    Level& cells = levels[D];
    const auto cell = [&](size_t i) { return &cells.vertices[i * (D + 1)]; };

    // a, and the spheres and values of the cells, for later
    vector<bool> seen(n_, false);
    for (const Id p : cells.vertices) seen[p] = true;
    for (size_t p = 0; p < n_; ++p)
        if (!seen[p]) refuse("3a", "row " + str(rows_[p]) + " is in no cell");
    vector<signed char> orientation(cells.count);
    vector<Ball<D>> balls(cells.count);
    cells.value.resize(cells.count);
    for (size_t i = 0; i < cells.count; ++i) {
        const Id* const c = cell(i);
        const int s = sign([&](auto t) { return sideOf<decltype(t)>(c + 1, c, 1); });
        if (s == 0) refuse("3a", "cell " + str(i) + ", " + name(c, D + 1) + ", is flat");
        orientation[i] = static_cast<signed char>(s);
        const Sphere<D, D> sphere(x_.data(), c, fast_);
        balls[i] = sphere;
        cells.value[i] = radius(sphere, c);
    }
    // On which side of its facet a cell is: the orientation of (vertex, facet).
    const auto sideOfCell = [&](Id i, Id pos) { return pos % 2 == 0 ? orientation[i] : -orientation[i]; };

    // b
    facets_ = sortedFaces<D + 1>(cells.vertices, n_);
    vector<Id> hull;   // vertices of hull facets
    vector<int> side;  // sides on which their cells are
    forGroups<D + 1>(cells.vertices, facets_, [&](const Id* facet, const Face* f, const Face* end) {
        if (end - f == 1) {
            hull.insert(hull.end(), facet, facet + D);
            side.push_back(sideOfCell(f->parent, f->pos));
            return;
        }
        const Id a = f[0].parent, b = f[1].parent, va = cell(a)[f[0].pos], vb = cell(b)[f[1].pos];
        const auto bad = [&](const char* what) {
            refuse("3b", "cells " + str(a) + " and " + str(b) + " at facet " + name(facet, D) + what);
        };
        if (end - f > 2) bad(" are not alone");
        if (sideOfCell(a, f[0].pos) == sideOfCell(b, f[1].pos)) bad(" are on one side");
        // Either test will do, as the vertices are on different sides.
        int inside = balls[a].side(point(vb), point(cell(a)[0]));
        if (inside == 2) inside = balls[b].side(point(va), point(cell(b)[0]));
        if (inside == 2) inside = orientation[a] * sign([&](auto t) { return power<decltype(t), D>(cell(a), vb); });
        if (inside < 0) bad(" are not Delaunay");
    });

    // c
    if (hull.empty()) refuse("3c", "there is no hull facet");
    const auto signOfO = [&](const Id* facet, int replaced = -1) {
        return sign([&](auto t) { return sideOf<decltype(t)>(facet, cell(0), D + 1, replaced, hull.data()); });
    };
    for (size_t i = 0; i < side.size(); ++i)
        if (signOfO(&hull[i * D]) != side[i])
            refuse("3c", "the centroid of cell 0 is not inside of hull facet " + name(&hull[i * D], D));

    // d. The side of the hyperplane through o and the ridge on which the vertex at pos is: det(f_i - o) with row pos
    // moved to the end. The sign of det(f_i - o) is known by c. One test of convexity will do: let l be the linear
    // function from o on that is 1 on a facet, l' that of the other. l - l' is 0 on the hyperplane, so it is of
    // different signs, or 0, at the two vertices.
    forGroups<D>(hull, sortedFaces<D>(hull, n_), [&](const Id* ridge, const Face* f, const Face* end) {
        const auto bad = [&](const char* what) { refuse("3d", "hull ridge " + name(ridge, D - 1) + what); };
        if (end - f != 2) bad(" is not in two hull facets");
        const Id a = f[0].parent, b = f[1].parent, vb = hull[size_t(b) * D + f[1].pos];
        if ((side[a] == side[b]) == ((f[0].pos - f[1].pos) % 2 == 0)) bad(" has both hull facets on one side");
        if (sign([&](auto t) { return sideOf<decltype(t)>(&hull[size_t(a) * D], &vb, 1); }) == -side[a])
            bad(" is not convex");
    });

    // e
    for (size_t i = 1; i < cells.count; ++i) {
        bool outside = false;
        for (Id pos = 0; pos <= D && !outside; ++pos) {
            Id facet[D];
            for (Id j = 0; j < D; ++j) facet[j] = Face{0, 0, pos}.vertex(cell(i), j);
            outside = signOfO(facet) == -sideOfCell(Id(i), pos);
        }
        if (!outside) refuse("3e", "the centroid of cell 0 is also in cell " + str(i));
    }
    // A closed facet meets the ray if the direction is in its cone from o: if the direction in place of no vertex
    // makes a determinant of the other sign.
    for (size_t i = 1; i < side.size(); ++i) {
        bool outside = false;
        for (int j = 0; j < D && !outside; ++j) outside = signOfO(&hull[i * D], j) == -side[i];
        if (!outside) refuse("3e", "the ray through the first hull facet also meets that of " + name(&hull[i * D], D));
    }
}

template <int D> template <int K> void Verifier<D>::values() {
    Level &level = levels[K], &above = levels[K + 1];
    const vector<Face> faces = K == D - 1 ? std::move(facets_) : sortedFaces<K + 2>(above.vertices, n_);
    above.facets.resize(above.vertices.size());
    forGroups<K + 2>(above.vertices, faces, [&](const Id* s, const Face* begin, const Face* end) {
        if (level.count == kNone) refuse("4", "too many simplices");
        const Sphere<D, K> sphere(x_.data(), s, fast_);
        bool empty = true;
        for (const Face* f = begin; f < end && empty; ++f) {
            const Id other = above.vertices[size_t(f->parent) * (K + 2) + f->pos];
            int side = sphere.side(point(other), point(s[0]));
            if (side == 2) side = sign([&](auto t) { return power<decltype(t), K>(s, other); });
            empty = side >= 0;
        }
        double value = empty ? radius(sphere, s) : kInf;
        for (const Face* f = begin; f < end; ++f) {
            if (!empty) value = std::min(value, above.value[f->parent]);
            above.facets[size_t(f->parent) * (K + 2) + f->pos] = Id(level.count);
        }
        level.vertices.insert(level.vertices.end(), s, s + K + 1);
        level.value.push_back(value);
        ++level.count;
    });
    above.vertices = vector<Id>();
    if constexpr (K > 1) {
        values<K - 1>();
    } else {
        level.facets = std::move(level.vertices);
        levels[0].count = n_;
        levels[0].value.assign(n_, 0.0);
    }
}

// STEP 5

class Pairs {
public:
    vector<Bar> bars;

    Pairs(Level* levels, int dim, Word maxDegree) : levels_(levels), maxDegree_(maxDegree), paired_(dim + 1) {
        const int top = maxDegree > 0 ? dim : 1;
        sortByValue(top);
        for (int k = 0; k <= top; ++k) paired_[k].resize(levels[k].count);
        if (maxDegree > 0) cells(levels[dim - 1], levels[dim], dim);
        for (int k = top - 1; k >= 2; --k) columns(levels[k - 1].count, levels[k], k);
        // Vertices are born at 0, in any order; of two components that an edge joins the younger one ends.
        joins(levels[0].count, levels[1].facets, [&](size_t edge, size_t vertex) { pair(0, vertex, edge); });
        for (int k = 0; k <= top; ++k)
            for (size_t i = 0; i < levels[k].count; ++i)
                if (!paired_[k][i]) add(k, levels[k].value[i], kInf);
        std::sort(bars.begin(), bars.end());
    }

private:
    // Makes numbers of simplices ascend with their values. Values are not negative, so their bits ascend with them.
    void sortByValue(int top) {
        vector<Id> rank, below;
        for (int k = 1; k <= top; ++k) {
            Level& level = levels_[k];
            vector<std::pair<Word, Id>> order(level.count);
            for (size_t i = 0; i < level.count; ++i) order[i] = {bitsAs<Word>(level.value[i]), Id(i)};
            std::sort(order.begin(), order.end());
            below.swap(rank);
            rank.resize(level.count);
            const vector<Id> facets = std::move(level.facets);
            level.facets.resize(facets.size());
            for (size_t i = 0; i < level.count; ++i) {
                rank[order[i].second] = Id(i);
                level.value[i] = bitsAs<double>(order[i].first);
                for (int j = 0; j <= k; ++j) {
                    const Id facet = facets[size_t(order[i].second) * (k + 1) + j];
                    level.facets[i * (k + 1) + j] = k == 1 ? facet : below[facet];
                }
            }
        }
    }

    void add(int degree, double birth, double death) {
        if (Word(degree) <= maxDegree_ && birth != death) bars.push_back({Word(degree), birth, death});
    }
    void pair(int degree, size_t birth, size_t death) {
        paired_[degree][birth] = paired_[degree + 1][death] = true;
        add(degree, levels_[degree].value[birth], levels_[degree + 1].value[death]);
    }

    // Edges of a graph, given by their ends, one after the other. The elder of a component is its node of lowest
    // number; of two components that are joined the one with the younger elder ends: joined(edge, that elder).
    template <class Fn> static void joins(size_t nodes, const vector<Id>& ends, Fn joined) {
        vector<Id> root(nodes);
        for (size_t i = 0; i < nodes; ++i) root[i] = Id(i);
        const auto find = [&](Id i) {
            while (root[i] != i) i = root[i] = root[root[i]];
            return i;
        };
        for (size_t i = 0; i < ends.size() / 2; ++i) {
            const Id a = find(ends[2 * i]), b = find(ends[2 * i + 1]);
            if (a == b) continue;
            root[std::max(a, b)] = std::min(a, b);
            joined(i, std::max(a, b));
        }
    }

    // Pairs of facets and cells. The block of the boundary matrix, transposed and with rows and columns in reverse
    // order, has the same pairs. Its columns are the facets, from the last to the first, each with the one or two cells
    // that it is in; with one more node, the outside, which is older than all, they are edges of a graph.
    void cells(const Level& low, const Level& high, int dim) {
        vector<Id> ends(2 * low.count, 0);  // nodes: 0 is the outside, then the cells from the last to the first
        for (size_t i = 0; i < high.facets.size(); ++i) {
            Id* const e = &ends[2 * (low.count - 1 - high.facets[i])];
            e[e[0] != 0] = Id(high.count - i / (dim + 1));
        }
        joins(high.count + 1, ends, [&](size_t i, size_t j) { pair(dim - 1, low.count - 1 - i, high.count - j); });
    }

    // The standard algorithm for columns of dimension k. Those that are known to become 0, as their simplices are
    // births of pairs, are left out. A column at work is a heap, in which a row that is there twice is 0.
    void columns(size_t rows, const Level& level, int k) {
        vector<size_t> where(rows, size_t(-1));  // by lowest one: the column's begin in `stored`; there it comes last
        vector<Id> stored;
        std::priority_queue<Id> heap;
        const auto takeLowest = [&]() {
            while (!heap.empty()) {
                const Id row = heap.top();
                heap.pop();
                if (heap.empty() || heap.top() != row) return row;
                heap.pop();
            }
            return kNone;
        };
        for (size_t column = 0; column < level.count; ++column) {
            if (paired_[k][column]) continue;
            for (int j = 0; j <= k; ++j) heap.push(level.facets[column * (k + 1) + j]);
            Id row = takeLowest();
            for (; row != kNone && where[row] != size_t(-1); row = takeLowest())
                for (const Id* r = &stored[where[row]]; *r != row; ++r) heap.push(*r);
            if (row == kNone) continue;
            where[row] = stored.size();
            for (Id r = takeLowest(); r != kNone; r = takeLowest()) stored.push_back(r);
            stored.push_back(row);
            pair(k - 1, row, column);
        }
    }

    Level* levels_;
    Word maxDegree_;
    vector<vector<bool>> paired_;
};

// ALL STEPS

template <int D> string verify(const Points& points, Proof&& proof, const Diagram& diagram, const string& name) {
    string seconds;  // of processor time
    std::clock_t last = 0;
    const auto lap = [&](const char* step) {
        const std::clock_t now = std::clock();
        seconds += string(" ") + step + " " + str(double(now - std::exchange(last, now)) / CLOCKS_PER_SEC, 3);
    };
    lap("1, 2:");
    Verifier<D> verifier(points, std::move(proof));
    verifier.triangulation();
    lap("3:");
    verifier.template values<D - 1>();
    lap("4:");
    const Pairs pairs(verifier.levels, D, diagram.maxDegree);
    lap("5:");
    const vector<Bar>&found = pairs.bars, &claimed = diagram.bars;
    for (size_t i = 0; i < found.size() || i < claimed.size(); ++i) {
        const size_t line = i < claimed.size() ? claimed[i].line : claimed.empty() ? 0 : claimed.back().line + 1;
        const string where = name + ", line " + str(line);
        if (i == found.size() || (i < claimed.size() && claimed[i] < found[i]))
            refuse("6", where + ": there is no such bar, or not so often");
        if (i == claimed.size() || found[i] < claimed[i])
            refuse("6", where + ": before it the bar " + found[i].text() + " is missing");
    }
    lap("6:");
    string simplices, bars;
    for (const Level& level : verifier.levels) simplices += " " + str(level.count);
    for (Word k = 0; k <= D && k <= diagram.maxDegree; ++k)
        bars += " " + str(std::count_if(found.begin(), found.end(), [&](const Bar& bar) { return bar.degree == k; }));
    return "simplices " + simplices + "\nbars      " + bars + "\nby GMP     signs " + str(verifier.gmpSigns) +
           ", values " + str(verifier.gmpValues) + "\nseconds    step" + seconds + "\n";
}

void run(const string& pointsName, const string& diagramName, const string& proofName, bool quiet) {
    const Points points = readPoints(pointsName);
    const Diagram diagram = readDiagram(diagramName);
    const vector<Id> first = firstEqual(points);
    Fingerprint sum;
    sum.add(Word(points.dim));
    Word different = 0;
    for (size_t i = 0; i < points.x.size(); ++i) {
        if (first[i / points.dim] != i / points.dim) continue;
        different += i % points.dim == 0;
        sum.add(points.x[i]);
    }
    if (diagram.dim != points.dim || diagram.points != points.rows || diagram.duplicates != points.rows - different)
        refuse("1", diagramName + ": its head must say dim " + str(points.dim) + ", points " + str(points.rows) +
                        ", duplicates " + str(points.rows - different));
    Proof proof = readProof(proofName, points, different, sum.value(), diagram.fingerprint);

    // 2. As many places as different points, each of another point: so each row is equal to one of them.
    vector<bool> seen(points.rows, false);
    for (const Id row : proof.rows) {
        if (seen[first[row]]) refuse("2", "row " + str(row) + ", or one equal to it, is on the list twice");
        seen[first[row]] = true;
    }
    constexpr decltype(&verify<2>) verifyIn[] = {verify<2>, verify<3>, verify<4>, verify<5>, verify<6>};
    const string report = verifyIn[points.dim - 2](points, std::move(proof), diagram, diagramName);
    if (quiet) return;
    std::printf("verified   %s: %s points in R^%s, degrees 0 to %s\n%s", diagramName.c_str(), str(different).c_str(),
                str(points.dim).c_str(), str(diagram.maxDegree).c_str(), report.c_str());
}

}  // namespace

int main(int argc, char** argv) {
    const bool quiet = argc == 5 && string(argv[4]) == "--quiet";
    if (argc != 4 && !quiet) {
        std::fprintf(stderr, "usage: netmesh-verify POINTS DIAGRAM PROOF [--quiet]\n");
        return 2;
    }
    try {
        run(argv[1], argv[2], argv[3], quiet);
    } catch (const Failure& failure) {
        std::fprintf(stderr, "netmesh-verify: %s\n", failure.text.c_str());
        return failure.code;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "netmesh-verify: not proven: %s\n", error.what());  // no memory
        return 7;
    }
    return 0;
}
