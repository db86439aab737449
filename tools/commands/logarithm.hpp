// The natural logarithm that results are printed with, the same on every platform.
#pragma once

namespace netmesh::tool {

// ln(mantissa * 2^exponent) for mantissa in [1, 2) and exponent >= 0, within 4 units in the last place; 0 exactly
// for 1. With m in [sqrt(1/2), sqrt(2)] and s = (m - 1) / (m + 1): ln m = 2 (s + s^3 / 3 + s^5 / 5 + ...), where |s| <
// 0.1716 and the terms from s^25 on are below 2^-64 of the first. ln 2 is taken in two parts, so that exponent * high
// is exact.
double natural_logarithm(double mantissa, int exponent);

}  // namespace netmesh::tool
