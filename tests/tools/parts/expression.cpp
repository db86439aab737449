// Functions as text: values by hand, faults by column.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "tools/expression.hpp"

using netmesh::tool::Expression;

namespace {

double value(const std::string& text, double x = 3, double y = -2, double z = 0.5) {
    Expression e;
    const std::string complaint = e.parse(text);
    CAPTURE(text);
    CHECK(complaint == "");
    const double at[6] = {x, y, z, 7, 11, 13};
    return complaint.empty() ? e(at) : std::nan("");
}

bool faulty(const std::string& text, std::size_t column) {
    const std::string complaint = Expression().parse(text);
    CAPTURE(complaint);
    return complaint.rfind("column " + std::to_string(column) + ": ", 0) == 0;
}

}  // namespace

TEST_CASE("expressions: values by hand") {
    CHECK(value("1 + 2 * 3") == 7);
    CHECK(value("(1 + 2) * 3") == 9);
    CHECK(value("10 - 3 - 2") == 5);
    CHECK(value("16 / 4 / 2") == 2);
    CHECK(value("-x^2") == -9);
    CHECK(value("(-x)^2") == 9);
    CHECK(value("2 * -x") == -6);
    CHECK(value("--x + +y") == 1);
    CHECK(value("x^0 + y^3") == -7);
    CHECK(value("x*y-1") == -7);
    CHECK(value("sqrt(x*x + 4*y*y)") == 5);
    CHECK(value("abs(y) + abs(x)") == 5);
    CHECK(value("min(x, y, z) + max(x, y, z)") == 1);
    CHECK(value("max(min(1, 2), 0.5)") == 1);
    CHECK(value(" x1 + x2 + x3 + w + x5 + x6 ") == 3 - 2 + 0.5 + 7 + 11 + 13);
    CHECK(value("1.5e2 + .5") == 150.5);
    CHECK(value("x^3") == 27);
    CHECK(std::isnan(value("sqrt(y)")));
}

TEST_CASE("expressions: what they read, and their text") {
    Expression e;
    REQUIRE(e.parse("  y + x4 - x ") == "");
    CHECK(e.text() == "y + x4 - x");
    CHECK(e.coordinates() == 4);
    CHECK(e.coordinate_column() == 5);
    REQUIRE(e.parse("2") == "");
    CHECK(e.coordinates() == 0);
}

TEST_CASE("expressions: faults and their columns") {
    CHECK(faulty("", 1));
    CHECK(faulty("   ", 4));
    CHECK(faulty("x +", 4));
    CHECK(faulty("x * (y", 7));
    CHECK(faulty("x)", 2));
    CHECK(faulty("2x", 2));
    CHECK(faulty("x y", 3));
    CHECK(faulty("1 + foo(x)", 5));
    CHECK(faulty("x7", 1));
    CHECK(faulty("X", 1));
    CHECK(faulty("sin(x)", 1));
    CHECK(faulty("sqrt x", 6));
    CHECK(faulty("sqrt(x, y)", 7));
    CHECK(faulty("min(x)", 6));
    CHECK(faulty("max(x, )", 8));
    CHECK(faulty("x^2.5", 4));
    CHECK(faulty("x^-1", 3));
    CHECK(faulty("x^65", 3));
    CHECK(faulty("x^2^2", 4));
    CHECK(faulty("1e999 + x", 1));
    CHECK(faulty("x @ y", 3));
    CHECK(faulty("x\ny", 2));
    const std::string deep(100, '(');
    CHECK(faulty(deep + "x" + std::string(100, ')'), 65));
    CHECK(Expression().parse(std::string(5000, '1')) != "");
}
