#pragma once

/// \file
/// \brief The closed form of a cable that hangs between two points of one height.

#include <cmath>

namespace cookbook
{

// [catenary]
/// The number between two others at which a function that grows becomes `value`.
template <class Function>
double bisect(double low, double high, double value, const Function& function)
{
  for (int halving = 0; halving < 100; ++halving)
  {
    const double middle = (low + high) / 2;
    (function(middle) < value ? low : high) = middle;
  }
  return low;
}

/// How far [m] a chain of an even number of equal links sags, whose joints have equal masses: with
/// W the weight of a joint and H the horizontal force, link i from the middle has the slope
/// (i - 1/2) W / H.
inline double sag_of_chain(int links, double length, double span)
{
  const double link = length / links;
  double sag = 0;
  const auto half_span = [&](double force)
  {
    double half = sag = 0;
    for (int i = 1; i <= links / 2; ++i)
    {
      const double slope = (i - 0.5) / force, cosine = 1 / std::sqrt(1 + slope * slope);
      half += link * cosine;
      sag += link * cosine * slope;
    }
    return half;
  };
  half_span(bisect(1e-9, 1e9, span / 2, half_span));
  return sag;
}

/// How far [m] a cable sags: y = a cosh(x / a), with a from 2 a sinh(span / 2a) = length.
inline double sag_of_catenary(double length, double span)
{
  const double u = bisect(1e-6, 50, length / span, [](double x) { return std::sinh(x) / x; });
  return span / (2 * u) * (std::cosh(u) - 1);
}
// [catenary]

} // namespace cookbook
