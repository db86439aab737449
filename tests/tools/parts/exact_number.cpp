// The second opinion's exact numbers and spheres, against GMP.
#ifdef NETMESH_TEST_GMP
#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cfloat>
#include <cmath>
#include <random>

#include "tools/opinion/exact_spheres.hpp"

using namespace netmesh::tool;

namespace {

using Random = std::mt19937_64;

// 2^e, of any sign of e.
mpq_class power(int e) {
    const mpz_class p = mpz_class(1) << static_cast<unsigned>(std::abs(e));
    return e >= 0 ? mpq_class(p) : mpq_class(mpz_class(1), p);
}

// Of the same value, made of pieces of 20 bits.
Exact exact_of(const mpq_class& x) {
    mpz_class rest = abs(x.get_num());
    int e = 1 - static_cast<int>(mpz_sizeinbase(x.get_den_mpz_t(), 2));
    Exact sum;
    for (; rest != 0; rest >>= 20, e += 20) {
        const mpz_class piece = rest & 0xFFFFF;
        sum = sum + Exact(piece.get_d()) * Exact::power(e);
    }
    return x < 0 ? -sum : sum;
}

bool is_same(const Exact& a, const mpq_class& b) { return compare(a, exact_of(b)) == 0; }

// Of all exponents up to `most`, some with few digits.
double any_double(Random& random, int most) {
    const double digits = static_cast<double>(static_cast<std::int64_t>(random()) >> (11 + random() % 52));
    return std::ldexp(digits, static_cast<int>(random() % (2 * most + 1)) - most - 52);
}

double next_up(double x) { return std::nextafter(x, HUGE_VAL); }

mpq_class rational(double x) { return std::isinf(x) ? power(1024) : mpq_class(x); }

// By the definition: the square lies between those of the middles to r's neighbours.
bool is_nearest_root(double r, const mpq_class& square) {
    std::uint64_t bits;
    std::memcpy(&bits, &r, sizeof bits);
    const bool even = bits % 2 == 0;
    if (!std::isinf(r)) {
        const mpq_class middle = (rational(r) + rational(next_up(r))) / 2;
        if (square > middle * middle || (square == middle * middle && !even)) return false;
    }
    if (r == 0) return true;
    const mpq_class middle = (rational(r) + rational(std::nextafter(r, 0))) / 2;
    return square > middle * middle || (square == middle * middle && even);
}

}  // namespace

TEST_CASE("exact numbers: sums, differences, products and order are GMP's") {
    Random random(1);
    for (const int most : {0, 3, 40, 300, 900})
        for (int turn = 0; turn < 400; turn++) {
            const double a = any_double(random, most), b = any_double(random, most), c = any_double(random, most);
            CHECK(is_same(Exact(a), mpq_class(a)));
            CHECK(is_same(Exact(a) + Exact(b), mpq_class(a) + mpq_class(b)));
            CHECK(is_same(Exact(a) - Exact(b), mpq_class(a) - mpq_class(b)));
            CHECK(is_same(Exact(a) * Exact(b), mpq_class(a) * mpq_class(b)));
            CHECK(is_same(-Exact(a), -mpq_class(a)));
            CHECK(Exact(a).sign() == sgn(mpq_class(a)));
            CHECK(compare(Exact(a), Exact(b)) == sgn(mpq_class(a) - mpq_class(b)));
            // Longer ones, of which much cancels.
            const mpq_class p = mpq_class(a) * b + mpq_class(c) * c, q = p * p - mpq_class(a) * c;
            const Exact x = Exact(a) * Exact(b) + Exact(c) * Exact(c), y = x * x - Exact(a) * Exact(c);
            CHECK(is_same(y, q));
            CHECK(is_same(y - x * x, q - p * p));
            CHECK(is_same(y * y - x, q * q - p));
            CHECK(compare(x, y) == sgn(p - q));
            CHECK((y - y).sign() == 0);
            int exponent;
            const double leading = y.leading(&exponent);
            const mpq_class off = abs(mpq_class(leading) * power(exponent) - q);
            CHECK(off <= abs(q) * power(-50));
        }
    for (const double x : {0.0, 1.0, -1.0, 0x1p-1074, DBL_MAX, -DBL_MAX, 0x1p32, 0x1p-32, 0x1.fffffffffffffp-1022})
        CHECK(is_same(Exact(x), mpq_class(x)));
    for (const int e : {-2200, -1074, -33, -32, -31, -1, 0, 1, 31, 32, 33, 1023, 1024, 2300})
        CHECK(is_same(Exact::power(e), power(e)));
    // Carries and borrows through many words.
    const Exact large = Exact::power(640), one(1);
    CHECK(is_same(large - one, power(640) - 1));
    CHECK(is_same((large - one) + one, power(640)));
    CHECK(is_same((large - one) * (large - one), (power(640) - 1) * (power(640) - 1)));
}

TEST_CASE("exact numbers: roots are rounded to nearest, ties to even") {
    Random random(2);
    std::size_t ties = 0;
    for (const int most : {0, 40, 500})
        for (int turn = 0; turn < 1000; turn++) {
            const double a = std::fabs(any_double(random, most)), b = std::fabs(any_double(random, most));
            if (b == 0) continue;
            CHECK(is_nearest_root(nearest_root(Exact(a), Exact(b)), mpq_class(a) / mpq_class(b)));
            // A double itself, the middle of two, and next to them on either side.
            const Exact half = (Exact(b) + Exact(next_up(b))) * Exact(0.5), little = Exact::power(-9000);
            const mpq_class middle = (mpq_class(b) + mpq_class(next_up(b))) / 2;
            for (const double scale : {1.0, 3.0, 0.1}) {
                const Exact by(scale);
                CHECK(nearest_root(Exact(b) * Exact(b) * by, by) == b);
                const double at = nearest_root(half * half * by, by);
                ties++;
                CHECK(is_nearest_root(at, middle * middle));
                CHECK(nearest_root(half * half * by - little, by) == b);
                CHECK(nearest_root(half * half * by + little, by) == next_up(b));
            }
        }
    CHECK(ties > 5000);
    // At the ends of the range.
    const Exact least(0x1p-1074), most(DBL_MAX), one(1), limit = Exact::power(1024) - Exact::power(970);
    CHECK(nearest_root(Exact(), one) == 0);
    CHECK(nearest_root(least * least, one) == 0x1p-1074);
    CHECK(nearest_root(least * least, Exact(4)) == 0);
    CHECK(nearest_root(least * least + Exact::power(-4000), Exact(4)) == 0x1p-1074);
    CHECK(nearest_root(least * least * Exact(9), Exact(4)) == 0x1p-1073);
    CHECK(nearest_root(most * most, one) == DBL_MAX);
    CHECK(nearest_root(limit * limit - one, one) == DBL_MAX);
    CHECK(nearest_root(limit * limit, one) == HUGE_VAL);
    CHECK(nearest_root(Exact::power(4000), one) == HUGE_VAL);
    CHECK(nearest_root(Exact(9), Exact(4)) == 1.5);
}

namespace {

mpq_class determinant(std::vector<std::vector<mpq_class>> a) {
    mpq_class product = 1;
    for (std::size_t s = 0; s < a.size(); s++) {
        std::size_t pivot = s;
        while (pivot < a.size() && a[pivot][s] == 0) pivot++;
        if (pivot == a.size()) return 0;
        if (pivot != s) product = -product;
        std::swap(a[pivot], a[s]);
        product *= a[s][s];
        for (std::size_t i = s + 1; i < a.size(); i++) {
            const mpq_class factor = a[i][s] / a[s][s];
            for (std::size_t j = s; j < a.size(); j++) a[i][j] -= factor * a[s][j];
        }
    }
    return product;
}

using Rows = std::vector<std::vector<double>>;

mpq_class square_of(const std::vector<double>& a, const std::vector<double>& b) {
    mpq_class sum = 0;
    for (std::size_t k = 0; k < a.size(); k++) {
        const mpq_class d = mpq_class(a[k]) - mpq_class(b[k]);
        sum += d * d;
    }
    return sum;
}

// Cayley and Menger: the squares of distances, without and with a frame of ones. Less than 0: dependent points.
mpq_class radius_squared(const Rows& rows) {
    const std::size_t n = rows.size();
    std::vector<std::vector<mpq_class>> plain(n, std::vector<mpq_class>(n)), framed(n + 1);
    for (std::size_t i = 0; i < n; i++)
        for (std::size_t j = 0; j < n; j++) plain[i][j] = square_of(rows[i], rows[j]);
    framed[0].assign(n + 1, 1);
    framed[0][0] = 0;
    for (std::size_t i = 0; i < n; i++) {
        framed[i + 1] = plain[i];
        framed[i + 1].insert(framed[i + 1].begin(), 1);
    }
    const mpq_class volume = determinant(framed);
    return volume == 0 ? mpq_class(-1) : mpq_class(-determinant(plain) / (2 * volume));
}

std::vector<ExactPlace> exact_rows(const Rows& rows) {
    std::vector<ExactPlace> places;
    for (const std::vector<double>& row : rows) {
        places.emplace_back();
        for (const double x : row) places.back().emplace_back(x);
    }
    return places;
}

ExactSphere sphere_of(const std::vector<ExactPlace>& places) {
    std::vector<const ExactPlace*> corners;
    for (const ExactPlace& place : places) corners.push_back(&place);
    return ExactSphere(corners);
}

}  // namespace

TEST_CASE("exact spheres: radii are the rounded roots of Cayley's and Menger's determinants") {
    Random random(3);
    std::size_t dependent = 0;
    for (std::size_t dim = 2; dim <= 6; dim++)
        for (std::size_t n = 2; n <= dim + 1; n++)
            for (int turn = 0; turn < 60; turn++) {
                Rows rows(n, std::vector<double>(dim));
                for (std::vector<double>& row : rows)
                    for (double& x : row)
                        x = turn % 3 == 0   ? static_cast<double>(random() % 3)
                            : turn % 3 == 1 ? std::ldexp(static_cast<double>(random() >> 11), -53)
                                            : any_double(random, 200);
                const std::vector<ExactPlace> places = exact_rows(rows);
                const ExactSphere sphere = sphere_of(places);
                const mpq_class square = radius_squared(rows);
                CHECK(sphere.is_independent() == (square >= 0));
                dependent += square < 0;
                if (square < 0) continue;
                CHECK(is_nearest_root(sphere.radius(), square));
                for (const ExactPlace& corner : places) CHECK(sphere.side(corner) == 0);
                if (n == 2) CHECK(half_distance(rows[0].data(), rows[1].data(), dim) == sphere.radius());
                // It is centred where leaving out any point makes the smallest ball of the others smaller.
                if (n == 2) CHECK(sphere.is_centred());
            }
    CHECK(dependent > 30);
}

TEST_CASE("exact spheres: inside, on, outside; acute, right and obtuse") {
    const double up = next_up(1.0), down = std::nextafter(1.0, 0);
    const std::vector<ExactPlace> right = exact_rows({{0, 0}, {1, 0}, {0, 1}}),
                                  acute = exact_rows({{0, 0}, {1, 0}, {0x1p-52, 1}}),
                                  obtuse = exact_rows({{0, 0}, {1, 0}, {-0x1p-52, 1}}),
                                  others = exact_rows({{1, 1}, {1, down}, {1, up}, {0.5, 0.5}});
    CHECK(!sphere_of(right).is_centred());
    CHECK(sphere_of(acute).is_centred());
    CHECK(!sphere_of(obtuse).is_centred());
    const int due[] = {0, -1, 1, -1};
    for (std::size_t i = 0; i < 4; i++) CHECK(sphere_of(right).side(others[i]) == due[i]);
    CHECK(orientation({&right[0], &right[1], &right[2]}) == 1);
    CHECK(orientation({&right[0], &right[2], &right[1]}) == -1);
    const std::vector<ExactPlace> line = exact_rows({{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}, {0.3, next_up(0.3)}});
    CHECK(orientation({&line[0], &line[1], &line[2]}) == 0);
    CHECK(orientation({&line[0], &line[1], &line[3]}) == 1);
}
#endif
