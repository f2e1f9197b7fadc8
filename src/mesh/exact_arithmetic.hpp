#pragma once

#include <cmath>

namespace planetree::detail {

/// A number as the unevaluated sum of a rounded value and what rounding took from it.
struct ExpandedDouble {
  double value;
  double rest;
};

/// a + b without error. Knuth, The Art of Computer Programming, vol. 2.
[[nodiscard]] inline ExpandedDouble exactSum(double a, double b) noexcept {
  const double sum = a + b;
  const double bPart = sum - a;
  const double aPart = sum - bPart;
  return {sum, (a - aPart) + (b - bPart)};
}

/// a * b without error, while nothing under- or overflows. Dekker, "A floating-point technique for
/// extending the available precision", Numerische Mathematik 1971. Plain multiplications on
/// purpose: the same bits on machines with and without FMA.
[[nodiscard]] inline ExpandedDouble exactProduct(double a, double b) noexcept {
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1 halves the 53 bits of a double
  const auto split = [](double x) -> ExpandedDouble {
    const double shifted = kSplitter * x;
    const double high = shifted - (shifted - x);
    return {high, x - high};
  };
  const double product = a * b;
  const auto [aHigh, aLow] = split(a);
  const auto [bHigh, bLow] = split(b);
  const double rest = aLow * bLow - (((product - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow);
  return {product, rest};
}

/// a * b - c * d in double for float arguments: both products are exact, so the sign is, and the
/// value is rounded once.
[[nodiscard]] inline double differenceOfProducts(float a, float b, float c, float d) noexcept {
  return static_cast<double>(a) * static_cast<double>(b) -
         static_cast<double>(c) * static_cast<double>(d);
}

/// a * b - c * d for double arguments, with a relative error of a few ulps and hence the right
/// sign.
[[nodiscard]] inline double differenceOfProducts(double a, double b, double c, double d) noexcept {
  const ExpandedDouble first = exactProduct(a, b);
  const ExpandedDouble second = exactProduct(c, d);
  const ExpandedDouble values = exactSum(first.value, -second.value);
  const ExpandedDouble rests = exactSum(first.rest, -second.rest);
  const ExpandedDouble high = exactSum(values.value, rests.value);
  return high.value + (high.rest + (values.rest + rests.rest));
}

}  // namespace planetree::detail
