// A function of a point as text: --function 'max(sqrt(x*x + y*y) - 1, -2*z)'.
//
//   + - * / ( )   a sign   ^ and a whole number from 0 to 64   sqrt abs: of one   min max: of two or more
//   numbers   x y z w, or x1 to x6
//
// ^ binds tighter than a sign, which binds tighter than * and /. There is nothing whose last bit depends on the
// platform: a power is a product from the left.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace netmesh::tool {

class Expression {
public:
    // Empty, or what is wrong with the text, with its column.
    std::string parse(const std::string& text);

    const std::string& text() const { return text_; }
    // The highest coordinate that is read, from 1, and its column; 0 where none is.
    std::uint32_t coordinates() const { return coordinates_; }
    std::size_t coordinate_column() const { return coordinate_column_; }
    // At x[coordinates()] or more.
    double operator()(const double* x) const;

private:
    friend class ExpressionParser;
    enum class Code : std::uint8_t {
        number,
        coordinate,
        add,
        subtract,
        multiply,
        divide,
        negate,
        root,
        size,
        least,
        most,
        power
    };
    struct Step {
        Code code;
        std::uint32_t index;  // of the coordinate; the exponent
        double number;
    };

    std::string text_;
    std::vector<Step> steps_;  // in postfix order
    std::uint32_t coordinates_ = 0;
    std::size_t coordinate_column_ = 0;
};

}  // namespace netmesh::tool
