#include "tools/commands/logarithm.hpp"

namespace netmesh::tool {

double natural_logarithm(double mantissa, int exponent) {
    constexpr double root_of_two = 0x1.6a09e667f3bcdp0;
    constexpr double high = 0x1.62e42feep-1, low = 0x1.a39ef35793c76p-33;  // of ln 2
    if (mantissa > root_of_two) {
        mantissa /= 2;
        exponent++;
    }
    const double s = (mantissa - 1) / (mantissa + 1), square = s * s;
    double tail = 0;
    for (int k = 23; k >= 3; k -= 2) tail = (tail + 1.0 / k) * square;
    const double power = exponent;
    return power * high + (2 * s + (2 * s * tail + power * low));
}

}  // namespace netmesh::tool
