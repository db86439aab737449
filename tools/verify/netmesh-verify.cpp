// netmesh-verify POINTS DIAGRAM PROOF [--quiet]
//
// Verifies that a persistence diagram of points, or of balls, is the exact one, by the proof beside it. What is
// claimed, what the files hold and why the checks are enough is on the page tools/docs/proofs.md; steps 1 to 6 below
// are those of that page. This file is all of the program, it shares no code with netmesh, and needs nothing but GMP:
//
//     c++ -std=c++17 -O2 -ffp-contract=off netmesh-verify.cpp -lgmpxx -lgmp
//
// The bounds on rounding hold for IEEE doubles, each operation rounded to nearest: no -ffast-math, no x87, no fused
// operations. Exit: 0 verified; 7 not proven, with step and place; 2 usage; 3 a file that is not of its format.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gmpxx.h>
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
using Ids = vector<Id>;
constexpr Id kNone = 0xFFFFFFFF;
constexpr double kInf = HUGE_VAL, kUnit = 0x1p-53;  // the relative error of one rounding
using Failure = std::pair<int, string>;             // exit code, message
[[noreturn]] void badFile(const string& s) { throw Failure(3, s); }
[[noreturn]] void refuse(const string& step, const string& s) {
    throw Failure(7, "not proven: step " + step + ": " + s);
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
Word mix(Word z) {
    z += 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
}
struct Fingerprint {
    Word state = 0x6E65746D65736800;
    void add(Word w) { state = mix(state ^ w) + 0x632BE59BD9B4E019 * w; }
    Word value() const { return mix(state); }
};
//---- STEP 1: FILES ------------------------------------------------------------------------------------------------
struct Points {
    size_t dim = 0, rows = 0;
    vector<double> x, weight;  // rows * dim, never -0; of the rows, or none
};
struct Bar {
    Word degree;
    double birth, death;
    size_t line = 0;  // of the diagram
    bool operator<(const Bar& b) const { return std::tie(degree, birth, death) < std::tie(b.degree, b.birth, b.death); }
    string text() const { return str(degree) + " " + str(birth) + " " + str(death); }
};
struct Diagram {
    string name, input;
    std::map<string, Word> head;
    int kind = 0;  // 1: of radii, 2: of weights, in column `column` of the points, from 1, or in the last one
    bool squares = false;
    Word fingerprint = 0, column = 0;
    vector<Bar> bars;
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
Points readPoints(const string& name, const Diagram& diagram) {
    const string bytes = readFile(name);
    Points points;
    if (bytes.compare(0, 6, "\x93NUMPY") == 0) {  // as numpy writes it
        const size_t wide = bytes.size() > 6 && bytes[6] > 1 ? 4 : 2;
        const size_t begin = bytes.size() < 12 ? bytes.size() : 8 + wide + littleEndian(&bytes[8], wide);
        unsigned long long rows = 0, dim = 0;
        int length = 0;
        constexpr const char* head = "{ 'descr' : '<f8' , 'fortran_order' : False , 'shape' : ( %10llu , %1llu )%n";
        if (begin < bytes.size()) std::sscanf(&bytes[8 + wide], head, &rows, &dim, &length);
        if (length == 0 || bytes.size() - begin != 8 * rows * dim)
            badFile(name + ": not an .npy file of little endian doubles of shape (rows, dim), by rows");
        points.dim = dim, points.rows = rows, points.x.resize(rows * dim);
        for (size_t i = 0; i < rows * dim; ++i) {
            points.x[i] = bitsAs<double>(littleEndian(&bytes[begin + 8 * i], 8)) + 0.0;  // -0 becomes 0
            if (!std::isfinite(points.x[i])) badFile(name + ": byte " + str(begin + 8 * i) + ": not a finite number");
        }
    } else {
        bool first = true;
        forLines(bytes, true, [&](const vector<string_view>& words, size_t line) {
            if (words.empty() || words[0].substr(0, 1) == "#") return;
            size_t numbers = 0;
            for (const string_view word : words) {
                double x;
                if (!readNumber(word, x)) continue;
                if (!std::isfinite(x)) badFile(name + ", line " + str(line) + ": beyond the largest double");
                points.x.push_back(x + 0.0);
                ++numbers;
            }
            if (std::exchange(first, false) && numbers == 0) return;  // a header
            if (points.rows++ == 0) points.dim = numbers;
            if (numbers != words.size() || numbers != points.dim)
                badFile(name + ", line " + str(line) + ": not finite numbers, as many as before");
        });
    }
    if (diagram.kind > 0 && points.rows > 0) {
        const size_t width = points.dim--, column = std::min<size_t>(diagram.column - 1, width - 1);
        size_t to = 0;
        for (size_t i = 0; i < width * points.rows; ++i)
            (i % width == column ? points.weight.emplace_back() : points.x[to++]) = points.x[i];
        points.x.resize(to);
        if (diagram.kind == 1 && *std::min_element(points.weight.begin(), points.weight.end()) < 0)
            badFile(name + ": a radius is negative");
    }
    if (points.rows == 0 || points.rows >= kNone || points.dim < 2 || points.dim > 6)
        badFile(name + ": no points, or too many, or not of dimension 2 to 6");
    return points;
}
Diagram readDiagram(const string& name) {
    Diagram diagram;
    diagram.name = name;
    Fingerprint sum;
    std::map<string, string> head;
    size_t negative = 0;  // a line with a negative number
    forLines(readFile(name), false, [&](const vector<string_view>& words, size_t line) {
        const auto bad = [&](const char* what) { badFile(name + ", line " + str(line) + ": " + what); };
        if (!words.empty() && words[0][0] == '#') {
            if (words[0] != "#" || words.size() < 2) return;
            string& value = head[string(words[1])];
            value = !value.empty() ? "? ?" : words.size() == 3 ? string(words[2]) : "?";
            return;
        }
        Bar bar{0, 0, 0, line};
        if (words.size() != 3 || !readNumber(words[0], bar.degree) || !readNumber(words[1], bar.birth) ||
            (words[2] != "inf" && !readNumber(words[2], bar.death)))
            bad("not degree, birth and death");
        if (words[2] == "inf") bar.death = kInf;
        if (std::isinf(bar.birth) || bar.death == -kInf || (bar.death == kInf && words[2] != "inf"))
            bad("a number beyond the largest double");
        if (std::signbit(bar.birth) || std::signbit(bar.death)) negative = line;
        if (!diagram.bars.empty() && bar < diagram.bars.back()) bad("bars are not sorted");
        for (const Word w : {bar.degree, bitsAs<Word>(bar.birth + 0.0), bitsAs<Word>(bar.death + 0.0)}) sum.add(w);
        diagram.bars.push_back(bar);
    });
    for (const char* claim : {"box", "cell", "a"})  // a: a choice of bars
        if (head.count(claim)) badFile(name + ": by its head it claims something else: # " + claim);
    diagram.kind = int(head.count("radii") + 2 * head.count("weights"));
    diagram.squares = head.count("squares") > 0;
    if (diagram.kind == 3 || (diagram.squares && diagram.kind == 0) || head["radii"] + head["weights"] == "? ?")
        badFile(name + ": not one line # radii or # weights");
    if (diagram.kind == 0 && negative > 0) badFile(name + ", line " + str(negative) + ": a negative number");
    readNumber(head[diagram.kind == 1 ? "radii" : "weights"], diagram.column);
    head.emplace("duplicates", "0");
    if (head["filter"] != "alpha") badFile(name + ": not one line # filter alpha; netmesh-verify-rips is for others");
    for (const char* key : {"dim", "max-degree", "points", "duplicates"})
        if (!readNumber(head[key], diagram.head[key])) badFile(name + ": not one line # " + key + " and a number");
    diagram.fingerprint = sum.value(), diagram.input = head["input"];
    return diagram;
}
struct Proof {
    Ids rows, cells, hidden;  // a row for each place; dim + 1 places each; for each of the last places its cell
};
Proof readProof(const string& name, const Points& points, Word n, Word pointsSum, Word diagramSum) {
    const string bytes = readFile(name);
    const bool weighted = !points.weight.empty();
    if (bytes.compare(0, 16, weighted ? "netmesh proof 2\n" : "netmesh proof 1\n") != 0)
        badFile(name + ": not a proof of version " + (weighted ? "2, for balls" : "1, for points"));
    size_t at = bytes.size(), end = at - 8, width = 1;
    const auto bad = [&](const string& what) { refuse("1", name + ", before byte " + str(at) + ": " + what); };
    const auto take = [&](size_t count) {
        if (count > end - at) bad("the file is too short");
        return littleEndian(&bytes[std::exchange(at, at + count)], count);
    };
    if (bytes.size() < 64) bad("the file is too short");
    Fingerprint sum;
    sum.add(end);
    for (size_t i = 0; i < end; i += 8) sum.add(littleEndian(&bytes[i], std::min<size_t>(8, end - i)));
    if (littleEndian(&bytes[end], 8) != sum.value()) bad("the file is damaged, by its fingerprint");
    at = 16;
    if (take(4) != 1u + weighted) bad("not of the kind of its version, an alpha complex");
    if (take(4) != points.dim) bad("not the dimension of the points");
    const Word vertices = take(8);
    const size_t c = take(8), size = points.dim + 1;
    if (take(8) != pointsSum) bad("not of these points, by their fingerprint");
    if (take(8) != diagramSum) bad("not of this diagram, by its fingerprint");
    const Word hidden = weighted ? take(8) : 0;
    if (vertices > n || hidden != n - vertices) bad("not as many points as the file has different ones");
    Ids rows(n);
    while ((points.rows - 1) >> (8 * width) != 0) ++width;
    for (Id& row : rows)
        if ((row = Id(take(width))) >= points.rows) bad("there is no row " + str(row));
    if (c > (end - at) / size || c >= kNone) bad("more cells than the file can hold");
    const auto number = [&]() {
        Word v = 0, byte = 128;
        for (int shift = 0; byte >= 128; shift += 7) {
            byte = take(1);
            v |= (byte & 127) << shift;
            if (shift > 28 || (byte == 0 && shift > 0)) bad("a number of more bytes than it takes");
        }
        return v;
    };
    Ids cells(c * size), cellsOfHidden(hidden);
    for (size_t i = 0; i < c * size; ++i) {
        const Word v = number() + (i % size > 0 ? Word(cells[i - 1]) + 1 : i > 0 ? cells[i - size] : 0);
        if (v >= vertices) bad("there is no vertex at place " + str(v));
        cells[i] = Id(v);
        const Id* const next = &cells[i] + 1;
        if (i > size && i % size == points.dim &&
            !std::lexicographical_compare(next - 2 * size, next - size, next - size, next))
            bad("cell " + str(i / size) + " is not after the one before");
    }
    for (Id& cell : cellsOfHidden)
        if ((cell = Id(number())) >= c) bad("there is no cell " + str(cell));
    if (at != end) bad("bytes behind the end");
    return {std::move(rows), std::move(cells), std::move(cellsOfHidden)};
}
Ids firstEqual(const Points& points) {  // for each row the first one at the same place
    size_t size = 4;
    while (size < 2 * points.rows) size *= 2;
    Ids table(size, kNone), first(points.rows);
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
// An expression of coordinates is written once, as a template, and computed with Approx and, if that leaves its sign
// open, with mpz_class. Approx is a double v with a bound: |v - the true value| <= c kUnit m, where c counts roundings,
// see Verifier::sign. If coordinates are integers, v is exact as long as products have m < 2^50 and sums few terms.
struct Approx {
    double v = 0, m = 0;
    static inline bool exact = false;
    void operator+=(const Approx& b) { v += b.v, m += b.m; }
    friend Approx operator-(const Approx& a, const Approx& b) { return {a.v - b.v, a.m + b.m}; }
    friend Approx operator*(const Approx& a, const Approx& b) {
        const Approx product{a.v * b.v, a.m * b.m};
        if (!(product.m < 0x1p50)) exact = false;
        return product;
    }
};
// minor[s]: determinant of the first |s| rows and the columns in s; leading: that of all rows and columns but the last.
template <class T, int N> T det(const T (&a)[N][N], T* leading = nullptr) {
    T minor[1 << N];
    for (int c = 0; c < N; ++c) minor[1 << c] = a[0][c];
    for (unsigned s = 1; s < 1u << N; ++s) {
        const int row = __builtin_popcount(s) - 1;
        for (int c = 0; c < N && row > 0; ++c)  // signs alternate
            if (s >> c & 1) minor[s] = a[row][c] * minor[s ^ 1u << c] - minor[s];
    }
    if (leading) *leading = minor[(1 << (N - 1)) - 1];
    return minor[(1 << N) - 1];
}
// The double nearest to 2^exponent sqrt(numerator / denominator), or without the root, ties to even.
double nearest(const mpz_class& numerator, const mpz_class& denominator, long exponent, bool isRoot) {
    const auto bits = [](const mpz_class& z) { return long(mpz_sizeinbase(z.get_mpz_t(), 2)); };
    if (numerator == 0) return 0;
    const long lack = 133 + bits(denominator) - bits(numerator);
    const long shift = std::max(0L, isRoot ? lack / 2 : lack);  // what follows has 65 bits or more
    const mpz_class scaled = numerator << (isRoot ? 2 * shift : shift);
    mpz_class root = scaled / denominator;
    if (isRoot) root = sqrt(root);
    if ((isRoot ? mpz_class(root * root) : root) * denominator != scaled) root |= 1;  // stands for what is below
    exponent -= shift;
    const long last = std::max(-1074L, exponent + bits(root) - 53);  // the exponent of the last bit of the double
    const unsigned long drop = last - exponent;                      // bits; at least 12
    root += (mpz_class(1) << (drop - 1)) - 1 + mpz_tstbit(root.get_mpz_t(), drop);
    return std::ldexp(mpz_class(root >> drop).get_d(), int(std::min(last, 2000L)));
}
void twoSum(double a, double b, double& high, double& low) {  // error free: high + low is the sum, the product
    const double c = (high = a + b) - a;
    low = (a - (high - c)) + (b - c);
}
void twoProduct(double a, double b, double& high, double& low) { high = a * b, low = std::fma(a, b, -high); }
template <int D> double dot(const double* a, const double* b) {
    double s = a[0] * b[0];
    for (int j = 1; j < D; ++j) s += a[j] * b[j];
    return s;
}
// The smallest sphere through p_0 .. p_K in R^D, in doubles, with proven bounds. Let e_i = p_i - p_0 for i = 1 .. K, E
// the matrix of these rows, c the centre from p_0 on: the vector in their span with 2 e_i.c = |e_i|^2, and u = kUnit.
// Coordinates are below 2^100, |e_i| >= 2^-150, |F| <= 2^200, |x| <= 2^150, else nothing is claimed. So nothing
// overflows and what underflows, below 2^-1000, is much smaller than the bounds, which have terms of at least u^2
// 2^-302, and room for it. Bounds of sums are by Cauchy and Schwarz: sum |a_j b_j| <= |a||b|.
// Whatever doubles f_i (rows of F) and x are, let M = I - F E^T. If |M| <= 1/2, then E has rank K, and for a vector
// d = sum a_i e_i in the span F d = F E^T a = (I - M) a, so |a| <= 2 |F||d|. Let x = c + d + d', d in the span, d'
// normal to it, and rho_i = e_i.(2x - e_i) = 2 e_i.d. Then |d|^2 = sum a_i e_i.d = a.rho / 2, so |d| <= |F||rho|.
// |d'| is at most the distance of x to any vector y of the span; y = sum b_i e_i, b_i = f_i.x. For K = D it is 0.
template <int D, int K> struct Sphere {
    static constexpr int N = K > 0 ? K : 1;  // no array is empty
    const double* p[K + 1];
    double e[N][D], length[N], b[N], x[D] = {};
    double norm, gap, delta = kInf;  // |x|; at least |y - x|; at least |x - c|, or infinite, then nothing is claimed
    Sphere(const double* coordinates, const Id* vertices, bool claim) {
        double q[N][D], r[N][N] = {}, qq[N], f[N][D];  // Gram and Schmidt: e_i = q_i + sum r_ih q_h
        double sumE = 0, sumF = 0, sumM = 0, sumRho = 0;
        if (!claim) return;
        for (int i = 0; i <= K; ++i) p[i] = coordinates + size_t(vertices[i]) * D;
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
        // An entry of M: u for e, u for each product, D u for sums, of |f_i||e_j|.
        for (int i = 0; i < K; ++i)
            for (int h = 0; h < K; ++h) {
                const double m = dot<D>(f[i], e[h]) - (i == h);
                sumM += m * m;
            }
        if (!(std::sqrt(sumM) + (D + 4) * kUnit * std::sqrt(sumE * sumF) <= 0.49)) return;
        // e_i.(2x - e_i): u for e, 2u for the other factor, u for each product, (D - 1) u for sums. y - x: u for e, u
        // for each product, K u for sums, of |b_i||e_i| and |x|. The factors 1.0001 are for the bounds' own roundings.
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
        delta = 1.0001 * std::sqrt(sumF * sumRho) + (K < D ? gap : 0);
    }
    // The sign of |w - p_0 - c|^2 - R^2 = v.(v - 2c) for v = w - p_0; 2 if not sure. The error is 2 |v||x - c| and, u
    // for v, 2u for v - 2x, D u for products and sums, of |v|(|v| + 2|x|).
    int side(const double* w) const {
        double s = 0, vv = 0;
        for (int j = 0; j < D && delta < kInf; ++j) {
            const double v = w[j] - p[0][j];
            s += v * (v - 2 * x[j]);
            vv += v * v;
        }
        if (!(vv >= 0x1p-300)) return 2;
        const double v = std::sqrt(vv), bound = 1.0001 * v * (2 * delta + (D + 5) * kUnit * (v + 2 * norm));
        return s > bound ? 1 : s < -bound ? -1 : 2;
    }
    // The nearest double to the radius, or -1 if that is not sure. R^2 = |c|^2 = Q + error, Q = |x|^2 + sum b_i
    // e_i.(e_i
    // - 2x). For, with x = c + g and e_i.(e_i - 2c) = 0, Q = |c|^2 + 2 c.g + |g|^2 - 2 y.g, so |Q - R^2| = ||g|^2 - 2
    // (y - c).g| <= |g|^2 + 2 (|y - x| + |g|)|g|. Q with about twice as many bits: e_i = h + l exactly, |l| <= u|h|;
    // h - 2x = zh + zl exactly, and zl + l is rounded. For one coordinate let A = |e|(|e| + 2|x|) >= |h||zh|, up to a
    // factor below 1.01. Left out is l zl and the rounding of zl: below 5 u^2 A. h zh is summed without error; all the
    // rest, less than (5.5 A + 1.1 D sum A) u, in doubles, with at most 4 D + 2 roundings of each part: below 320 u^2
    // sum A for D <= 6. |x|^2 likewise: below 100 u^2 |x|^2.
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
struct Level {             // the simplices of one dimension
    Ids vertices, facets;  // ascending, as long as they are needed; for each simplex those opposite to its vertices
    vector<double> value;  // rounded
    size_t count() const { return value.size(); }
};
// A face of a simplex: all of its vertices but that at pos. key: the second and third vertex of the face.
struct Face {
    Word key;
    Id parent, pos;
    Id vertex(const Id* simplex, Id j) const { return simplex[j + (j >= pos)]; }
};
// The faces of simplices of W vertices each, ascending, equal ones side by side.
template <Id W> vector<Face> sortedFaces(const Ids& simplices, size_t vertices) {
    vector<size_t> start(vertices + 1, 0);  // by the first vertex of the face
    for (size_t i = 0; i < simplices.size(); ++i) ++start[simplices[i - i % W + (i % W == 0)]];
    size_t sum = 0;
    for (size_t& s : start) sum += std::exchange(s, sum);
    vector<Face> faces(sum);
    for (size_t i = 0; i < simplices.size(); ++i) {
        const Id* const v = &simplices[i - i % W];
        Face face{0, Id(i / W), Id(i % W)};
        if (W > 2) face.key = Word(face.vertex(v, 1)) << 32;
        if (W > 3) face.key |= face.vertex(v, 2);
        faces[start[face.vertex(v, 0)]++] = face;
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
template <Id W, class Fn> void forGroups(const Ids& simplices, const vector<Face>& faces, Fn group) {
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
//---- STEPS 3 AND 4 ------------------------------------------------------------------------------------------------
template <int D> struct Verifier {
    Level levels[D + 1];
    // Coordinates are scaled by 2^-scale, to integers if they are below 2^100 then, else below 1 if that is possible
    // without error, else all is left to GMP.
    Verifier(const Points& points, Proof& proof, int kind, bool squares)
        : n_(proof.rows.size() - proof.hidden.size()), rows_(proof.rows), hidden_(proof.hidden), kind_(kind),
          squares_(squares) {
        levels[D].vertices.swap(proof.cells);
        int high = -1074, low = 1024, exponent;  // bits are below 2^high, from 2^low on; those of weights: squared
        const auto take = [&](vector<double>& to, double v, int power) {
            to.push_back(v);
            if (v == 0) return;
            const double m = std::ldexp(std::abs(std::frexp(v, &exponent)), 53);
            high = std::max(high, (exponent + 2148) / power - 2148 / power + power - 1);
            low = std::min(low, (exponent - 53 + __builtin_ctzll(Word(m)) + 2148) / power - 2148 / power);
        };
        for (const Id row : rows_) {
            for (int j = 0; j < D; ++j) take(x_, points.x[size_t(row) * D + j], 1);
            if (kind > 0) take(weight_, points.weight[row], kind);
        }
        fast_ = high - low < (kind == 0 ? 1074 : 500);  // so that weights do not underflow
        if (fast_) scale_ = high - low <= 100 ? low : high;
        lowest_ = low - scale_;
        for (double& v : x_) v = std::ldexp(v, -scale_);
        for (double& v : weight_) v = std::ldexp(v, -kind * scale_);
    }
    void triangulation() {
        Level& cells = levels[D];
        const auto cell = [&](size_t i) { return &cells.vertices[i * (D + 1)]; };
        // a, and the values of the cells, for later
        vector<bool> seen(n_, false);
        for (const Id p : cells.vertices) seen[p] = true;
        for (size_t p = 0; p < n_; ++p)
            if (!seen[p]) refuse("3a", "row " + str(rows_[p]) + " is in no cell");
        const size_t count = cells.vertices.size() / (D + 1);
        vector<int> orientation(count);
        cells.value.resize(count);
        for (size_t i = 0; i < count; ++i) {
            const Id* const c = cell(i);
            orientation[i] = sign([&](auto t) { return sideOf<decltype(t)>(c + 1, c); });
            if (orientation[i] == 0) refuse("3a", "cell " + str(i) + ", " + name(c, D + 1) + ", is flat");
            cells.value[i] = value(sphereOf<D>(c), c);
        }
        // On which side of its facet a cell is: the orientation of (vertex, facet).
        const auto sideOfCell = [&](Id i, Id pos) { return pos % 2 == 0 ? orientation[i] : -orientation[i]; };
        // a, of hidden points
        for (Id h = Id(n_), pos; h < rows_.size(); ++h) {
            const Id k = hidden_[h - n_], *const c = cell(k);
            Id facet[D];
            for (pos = 0; pos <= D; ++pos) {
                std::copy(c + pos + 1, c + D + 1, std::copy(c, c + pos, facet));
                if (sign([&](auto t) { return sideOf<decltype(t)>(facet, &h); }) == -sideOfCell(k, pos)) break;
            }
            if (pos <= D || sideOfSphere<D>(sphereOf<D>(c), c, h, orientation[k]) < 0)
                refuse("3a", "row " + str(rows_[h]) + " is not hidden by cell " + str(k) + ", " + name(c, D + 1));
        }
        // b
        facets_ = sortedFaces<D + 1>(cells.vertices, n_);
        Ids hull;          // vertices of hull facets
        vector<int> side;  // sides on which their cells are
        vector<bool> outside(count, false);
        forGroups<D + 1>(cells.vertices, facets_, [&](const Id* facet, const Face* f, const Face* end) {
            // c and e. The ray of e is not needed: on a ray from o that avoids lower faces the number of cells over a
            // place is the same behind a facet of two cells, by b, and one less behind a hull facet, by c, and 0 in the
            // end. So the ray meets as many hull facets as there are cells near o.
            const int s = sign([&](auto t) { return sideOf<decltype(t)>(facet, cell(0), D + 1); });
            for (const Face* g = f; g < end; ++g)
                if (s == -sideOfCell(g->parent, g->pos)) outside[g->parent] = true;
            if (end - f == 1) {
                hull.insert(hull.end(), facet, facet + D);
                side.push_back(sideOfCell(f->parent, f->pos));
                if (s != side.back())
                    refuse("3c", "the centroid of cell 0 is not inside of hull facet " + name(facet, D));
                return;
            }
            const Id a = f[0].parent, b = f[1].parent, vb = cell(b)[f[1].pos];
            const auto bad = [&](const char* what) {
                refuse("3b", "cells " + str(a) + " and " + str(b) + " at facet " + name(facet, D) + what);
            };
            if (end - f > 2) bad(" are not alone");
            if (sideOfCell(a, f[0].pos) == sideOfCell(b, f[1].pos)) bad(" are on one side");
            // The sphere of b gives the same, by the line before.
            if (sideOfSphere<D>(sphereOf<D>(cell(a)), cell(a), vb, orientation[a]) < 0) bad(" are not Delaunay");
        });
        for (size_t i = 1; i < count; ++i)
            if (!outside[i]) refuse("3e", "the centroid of cell 0 is also in cell " + str(i));
        // d. The side of the hyperplane through o and the ridge on which the vertex at pos is: det(f_i - o) with row
        // pos moved to the end, with the sign by c. One test of convexity will do: the difference of the two functions,
        // linear from o on, that are 1 on one of the facets is 0 there, so of different signs, or 0, at the vertices.
        forGroups<D>(hull, sortedFaces<D>(hull, n_), [&](const Id* ridge, const Face* f, const Face* end) {
            const auto bad = [&](const char* what) { refuse("3d", "hull ridge " + name(ridge, D - 1) + what); };
            if (end - f != 2) bad(" is not in two hull facets");
            const Id a = f[0].parent, b = f[1].parent, vb = hull[size_t(b) * D + f[1].pos];
            if ((side[a] == side[b]) == ((f[0].pos - f[1].pos) % 2 == 0)) bad(" has both hull facets on one side");
            if (sign([&](auto t) { return sideOf<decltype(t)>(&hull[size_t(a) * D], &vb); }) == -side[a])
                bad(" is not convex");
        });
    }
    // The simplices of dimension K and less, and their values.
    template <int K> void values() {
        Level &level = levels[K], &above = levels[K + 1];
        const vector<Face> faces = K == D - 1 ? std::move(facets_) : sortedFaces<K + 2>(above.vertices, n_);
        above.facets.resize(above.vertices.size());
        forGroups<K + 2>(above.vertices, faces, [&](const Id* s, const Face* begin, const Face* end) {
            const Sphere<D, K> sphere = sphereOf<K>(s);
            bool empty = true;
            for (const Face* f = begin; f < end && empty; ++f)
                empty = sideOfSphere<K>(sphere, s, above.vertices[size_t(f->parent) * (K + 2) + f->pos]) >= 0;
            const Id id = Id(level.count());
            if (id == kNone) refuse("4", "too many simplices");
            double least = empty ? value(sphere, s) : kInf;
            for (const Face* f = begin; f < end; ++f) {
                if (!empty) least = std::min(least, above.value[f->parent]);
                above.facets[size_t(f->parent) * (K + 2) + f->pos] = id;
            }
            level.vertices.insert(level.vertices.end(), s, s + K + 1);
            level.value.push_back(least);
        });
        above.vertices = Ids();
        if (K == 1 && kind_ == 0) {  // points are born at 0
            level.facets = std::move(level.vertices);
            levels[0].value.assign(n_, 0.0);
        } else if constexpr (K > 0) {
            values<K - 1>();
        }
    }

    const double* point(Id place) const { return &x_[size_t(place) * D]; }
    string name(const Id* v, int count) const {
        string s = "rows";
        for (int i = 0; i < count; ++i) s += " " + str(rows_[v[i]]);
        return s;
    }
    // Coordinate j of a - b; as an integer in units of 2^lowest_, of weights in their squares.
    void diff(Id a, Id b, int j, Approx& to) const { to.m = std::abs(to.v = point(a)[j] - point(b)[j]); }
    void diff(Id a, Id b, int j, mpz_class& to) const { to = integer(point(a)[j]) - integer(point(b)[j]); }
    void read(double v, int, Approx& to) const { to = Approx{v, std::abs(v)} * Approx{1, 1}; }
    void read(double v, int power, mpz_class& to) const { to = integer(v, power); }
    mpz_class integer(double v, int power = 1) const {
        int exponent;
        mpz_class z(std::ldexp(std::frexp(v, &exponent), 53));
        exponent -= 53 + power * lowest_;
        return exponent >= 0 ? mpz_class(z << exponent) : mpz_class(z >> -exponent);  // no bit is lost
    }
    template <class T> T weight(Id a) const {
        T w;
        read(weight_[a], kind_, w);
        return kind_ == 1 ? T(w * w) : w;
    }
    // Tells on which side of the facet f a is: det of f_i - a; of count (f_i - a), a the centroid of `count` points.
    template <class T> T sideOf(const Id* f, const Id* a, int count = 1) const {
        T m[D][D], d;
        for (int i = 0; i < D; ++i)
            for (int j = 0; j < D; ++j)
                for (int k = 0; k < count; ++k) {
                    diff(f[i], a[k], j, d);
                    m[i][j] += d;
                }
        return det(m);
    }
    // With e_i = s_i - s_0, d_i = e_i.e_i, G the matrix of e_i.e_j, c the centre of the smallest sphere of s from s_0
    // on, which is half of the sum of (G^-1 d)_i e_i, and v = w - s_0: the matrix | G d | v.e_j v.v |. Its determinant
    // is det G (v.v - 2 v.c), and det G > 0. With weights d_i and v.v are more by the weight of s_0 less that of s_i,
    // of w. `lifted`, for K = D: without the factor E^T on the right of the first K columns; det E is in place of det
    // G.
    template <class T, int K> void bordered(const Id* s, Id w, bool lifted, T (&m)[K + 1][K + 1]) const {
        T e[K + 1][D];
        for (int i = 0; i <= K; ++i)
            for (int j = 0; j < D; ++j) diff(i < K ? s[i + 1] : w, s[0], j, e[i][j]);
        for (int i = 0; i <= K; ++i)
            for (int h = 0; h <= K; ++h) {
                if (lifted && h < K) m[i][h] = e[i][h];
                for (int j = 0; j < D && (!lifted || h == K); ++j) m[i][h] += e[i][j] * e[h == K ? i : h][j];
                if (kind_ > 0 && h == K) m[i][h] += weight<T>(s[0]) - weight<T>(i < K ? s[i + 1] : w);
            }
    }
    template <int K> Sphere<D, K> sphereOf(const Id* s) const { return {x_.data(), s, fast_ && kind_ == 0}; }
    // Of a determinant of at most 7 rows. m sums its terms without signs. A term has at most 7 entries, with at most 13
    // roundings each (sideOf: 7, bordered: 8), 7 products, and 21 sums of minors: below 120 roundings; m itself is by
    // less than 1 % too small. What overflows makes the bound infinite or no number, so it decides nothing. Numbers
    // that are no integers are below 2^7, their squares below 2^5, and underflow changes v by less than 2^-900.
    template <class Fn> int sign(Fn expression) {
        if (fast_) {
            Approx::exact = lowest_ == 0;
            const Approx a = expression(Approx());
            const double bound = 128 * kUnit * a.m;
            if (std::abs(a.v) > bound && bound > 0x1p-800) return a.v > 0 ? 1 : -1;
            if (Approx::exact) return (a.v > 0) - (a.v < 0);
        }
        return sgn(mpz_class(expression(mpz_class())));
    }
    // The sign of |w - c|^2 - R^2 for the sphere of s, a cell of this orientation if K = D.
    template <int K> int sideOfSphere(const Sphere<D, K>& sphere, const Id* s, Id w, int orientation = 1) {
        const auto power = [&](auto t) {
            decltype(t) m[K + 1][K + 1];
            bordered<decltype(t), K>(s, w, K == D, m);
            return det(m);
        };
        const int side = sphere.side(point(w));
        return side != 2 ? side : orientation * sign(power);
    }
    template <int K> double value(const Sphere<D, K>& sphere, const Id* s) {
        const double r = sphere.delta < kInf ? std::ldexp(sphere.radius(), scale_) : 0;
        if (r >= 0x1p-1022 && r < kInf) return r;
        mpz_class m[K + 1][K + 1], g;  // 4 R^2 = d.G^-1 d = -det | G d | d 0 | / det G, and the power: less w_0
        bordered<mpz_class, K>(s, s[0], false, m);
        for (int i = 0; i < K; ++i) m[K][i] = m[i][K];
        mpz_class power = -det(m, &g);
        if (K == 0) g = 1;
        if (kind_ > 0) power -= 4 * g * weight<mpz_class>(s[0]);
        const double v = nearest(abs(power), 4 * g, (squares_ ? 2 : 1) * (long(lowest_) + scale_), !squares_);
        return power < 0 ? -v : v;
    }
    size_t n_;  // vertices; the places from there on are of hidden points
    Ids rows_, hidden_;
    const int kind_, squares_;
    vector<double> x_, weight_;   // by places: coordinates and radii times 2^-scale_, weights times its square
    int scale_ = 0, lowest_ = 0;  // x_ are integers times 2^lowest_
    bool fast_ = true;            // the bounds hold
    vector<Face> facets_;         // of the cells
};
//---- STEP 5 -------------------------------------------------------------------------------------------------------
struct Pairs {
    vector<Bar> bars;
    Pairs(Level* levels, int dim, Word maxDegree) : levels_(levels), maxDegree_(maxDegree), paired_(dim + 1) {
        const int top = maxDegree > 0 ? dim : 1;
        sortByValue(top);
        for (int k = 0; k <= top; ++k) paired_[k].resize(levels[k].count());
        if (maxDegree > 0) cells(levels[dim - 1], levels[dim], dim);
        for (int k = top - 1; k >= 2; --k) columns(levels[k - 1].count(), levels[k], k);
        joins(levels[0].count(), levels[1].facets, [&](size_t edge, size_t vertex) { pair(0, vertex, edge); });
        for (int k = 0; k <= top; ++k)
            for (size_t i = 0; i < levels[k].count(); ++i)
                if (!paired_[k][i]) add(k, levels[k].value[i], kInf);
        std::sort(bars.begin(), bars.end());
    }

    void sortByValue(int top) {  // numbers of simplices then ascend with their values
        Ids rank, below;
        for (int k = 0; k <= top; ++k) {
            Level& level = levels_[k];
            vector<std::pair<double, Id>> order(level.count());
            for (size_t i = 0; i < level.count(); ++i) order[i] = {level.value[i], Id(i)};
            std::sort(order.begin(), order.end());
            below.swap(rank);
            rank.resize(level.count());
            const Ids facets = std::move(level.facets);
            level.facets.resize(facets.size());
            for (size_t i = 0; i < level.count(); ++i) {
                rank[order[i].second] = Id(i);
                level.value[i] = order[i].first;
                for (int j = 0; j <= k && k > 0; ++j)
                    level.facets[i * (k + 1) + j] = below[facets[size_t(order[i].second) * (k + 1) + j]];
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
    template <class Fn> static void joins(size_t nodes, const Ids& ends, Fn joined) {
        Ids root(nodes);
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
    // Pairs of facets and cells. The block of the boundary matrix, transposed and in reverse order, has the same pairs.
    // Its columns are the facets, from the last to the first, each with the one or two cells that it is in; with one
    // more node, the outside, which is older than all, they are edges of a graph.
    void cells(const Level& low, const Level& high, int dim) {
        Ids ends(2 * low.count(), 0);  // nodes: 0 is the outside, then the cells from the last to the first
        for (size_t i = 0; i < high.facets.size(); ++i) {
            Id* const e = &ends[2 * (low.count() - 1 - high.facets[i])];
            e[e[0] != 0] = Id(high.count() - i / (dim + 1));
        }
        joins(high.count() + 1, ends,
              [&](size_t i, size_t j) { pair(dim - 1, low.count() - 1 - i, high.count() - j); });
    }
    // The standard algorithm for columns of dimension k. Those that are known to become 0, as their simplices are
    // births of pairs, are left out. A column at work is a heap, in which a row that is there twice is 0.
    void columns(size_t rows, const Level& level, int k) {
        vector<size_t> where(rows, size_t(-1));  // by lowest one: the column's begin in `stored`; there it comes last
        Ids stored;
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
        for (size_t column = 0; column < level.count(); ++column) {
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
template <int D> string verify(const Points& points, Proof& proof, const Diagram& diagram) {
    const Word maxDegree = diagram.head.at("max-degree");
    Verifier<D> verifier(points, proof, diagram.kind, diagram.squares);
    verifier.triangulation();
    verifier.template values<D - 1>();
    const Pairs pairs(verifier.levels, D, maxDegree);
    const vector<Bar>&found = pairs.bars, &claimed = diagram.bars;
    const auto equal = [](const Bar& a, const Bar& b) { return !(a < b) && !(b < a); };
    const auto [f, c] = std::mismatch(found.begin(), found.end(), claimed.begin(), claimed.end(), equal);
    const string where = diagram.name + (c == claimed.end() ? ", at its end" : ", line " + str(c->line));
    if (f != found.end() && (c == claimed.end() || *f < *c))
        refuse("6", where + ": here the bar " + f->text() + " is missing");
    if (c != claimed.end()) refuse("6", where + ": there is no such bar, or not so often");
    string simplices;
    for (const Level& level : verifier.levels) simplices += " " + str(level.count());
    return "verified   " + diagram.name + ": " + str(proof.rows.size()) + " points in R^" + str(D) + ", " +
           str(proof.hidden.size()) + " of them hidden, degrees 0 to " + str(maxDegree) + "\nsimplices " + simplices +
           "\n";
}
void run(const string& pointsName, const string& diagramName, const string& proofName, bool quiet) {
    const Diagram diagram = readDiagram(diagramName);
    const Points points = readPoints(pointsName, diagram);
    const Ids first = firstEqual(points);
    Word different = 0;
    for (size_t row = 0; row < points.rows; ++row) different += first[row] == row;
    Fingerprint sum;
    sum.add(points.dim);
    for (const double x : points.x) sum.add(bitsAs<Word>(x));
    if (!points.weight.empty()) {
        for (const Word w : {std::exchange(sum, {}).value(), Word(diagram.kind == 1)}) sum.add(w);
        for (const double w : points.weight) sum.add(bitsAs<Word>(w));
    }
    char input[20];
    std::snprintf(input, sizeof input, "%016llx", static_cast<unsigned long long>(sum.value()));
    for (const auto& [k, due] :
         std::map<string, Word>{{"dim", points.dim}, {"points", points.rows}, {"duplicates", points.rows - different}})
        if (diagram.head.at(k) != due) refuse("1", pointsName + " has " + k + " " + str(due) + ", not " + diagramName);
    if (!diagram.input.empty() && diagram.input != input)
        refuse("1", diagramName + ": it is of other points: the head's input");
    Proof proof = readProof(proofName, points, different, sum.value(), diagram.fingerprint);
    // 2. As many places as different points, each of another point: so each row is equal to one of them.
    Ids listed(points.rows, kNone);  // by the first of the equal rows
    for (const Id row : proof.rows)
        if (std::exchange(listed[first[row]], row) != kNone)
            refuse("2", "row " + str(row) + ", or an equal one, is on the list twice");
    for (size_t row = 0; row < points.weight.size(); ++row)
        if (points.weight[row] > points.weight[listed[first[row]]])
            refuse("2", "row " + str(row) + " is heavier than the equal one on the list");
    constexpr decltype(&verify<2>) verifyIn[] = {verify<2>, verify<3>, verify<4>, verify<5>, verify<6>};
    const string report = verifyIn[points.dim - 2](points, proof, diagram);
    if (!quiet) std::fputs(report.c_str(), stdout);
}
}  // namespace
int main(int argc, char** argv) {
    const bool quiet = argc == 5 && string(argv[4]) == "--quiet";
    if (argc != 4 && !quiet) return std::fputs("usage: netmesh-verify POINTS DIAGRAM PROOF [--quiet]\n", stderr), 2;
    try {
        return run(argv[1], argv[2], argv[3], quiet), 0;
    } catch (const Failure& failure) {
        return std::fprintf(stderr, "netmesh-verify: %s\n", failure.second.c_str()), failure.first;
    } catch (const std::exception& error) {
        return std::fprintf(stderr, "netmesh-verify: not proven: %s\n", error.what()), 7;  // no memory
    }
}
