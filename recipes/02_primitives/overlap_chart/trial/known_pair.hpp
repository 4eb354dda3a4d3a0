#pragma once

/// \file
/// \brief Pairs of shapes of which fractions tell whether they overlap.

#include <vector>

namespace cookbook
{

/// Two shapes, and whether they overlap.
template <class Shape>
struct KnownPair
{
  Shape a, b;
  bool overlap; ///< in fractions
};

/// The share [%] of pairs for which a way gives another answer than fractions do.
template <class Method, class Shape>
double wrong_fraction(const Method& method, const std::vector<KnownPair<Shape>>& pairs)
{
  int wrong = 0;
  for (const KnownPair<Shape>& pair : pairs)
  {
    wrong += method(pair.a, pair.b) != pair.overlap;
  }
  return 100.0 * wrong / static_cast<double>(pairs.size());
}

} // namespace cookbook
