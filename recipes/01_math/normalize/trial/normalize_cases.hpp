#pragma once

/// \file
/// \brief Vectors that break some way of normalising, and how far an answer is from the truth.

#include "01_math/normalize/normalize.hpp"
#include "common/math/ulp.hpp"
#include "tools/exact/exact.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to normalise, by name.
template <class Real>
struct NormalizeMethod
{
  std::string name;                                   ///< as on the page
  Direction<Real> (*normalize)(const Vector3<Real>&); ///< the way
};

/// The ways that compete, the recommended one last.
template <class Real>
std::array<NormalizeMethod<Real>, 4> normalize_methods()
{
  return {
      {{"naive", normalize_naive<Real>},
       {"threshold", normalize_threshold<Real>},
       {"wider", normalize_wide<Real>},
       {"scaled", [](const Vector3<Real>& v) { return normalize<Real>(v); }}}};
}

/// A vector that some way to normalise may not survive.
template <class Real>
struct NormalizeCase
{
  std::string id;   ///< in the book; empty for a neighbour of the case above
  std::string what; ///< the vector, as text
  Vector3<Real> v;  ///< the vector
};

/// The vectors to try in float.
inline std::vector<NormalizeCase<float>> normalize_cases(float)
{
  const float tiny = std::numeric_limits<float>::denorm_min();
  const float huge = std::numeric_limits<float>::max() / 2;
  return {
      {"A1", "(0, 0, 0)", {0, 0, 0}},
      {"A2", "(1e-23, 0, 0)", {1e-23f, 0, 0}},
      {"", "(1e20, 1e20, 1e20)", {1e20f, 1e20f, 1e20f}},
      {"", "(1, 2, 2)", {1, 2, 2}},
      {"", "(1, 2, 2) · 1e-7", {1e-7f, 2e-7f, 2e-7f}},
      {"", "(1, 2, 2) · 1e-22", {1e-22f, 2e-22f, 2e-22f}},
      {"", "(3, 4, 0) · smallest float", {3 * tiny, 4 * tiny, 0}},
      {"", "(1, 1, 0) · smallest float", {tiny, tiny, 0}},
      {"", "(1e20, 1, 0)", {1e20f, 1, 0}},
      {"", "half of the largest", {huge, 0, 0}}};
}

/// The vectors to try in double, which has no wider type.
inline std::vector<NormalizeCase<double>> normalize_cases(double)
{
  return {
      {"", "(1, 2, 2), double", {1, 2, 2}},
      {"", "(1, 1, 1) · 1e200, double", {1e200, 1e200, 1e200}},
      {"", "(3, 4, 0) · 1e-200, double", {3e-200, 4e-200, 0}}};
}

// [direction_error]
/// Distance of an answer from the truth: of its length in ulps of the length, of its worst
/// component in ulps of one; infinite where the answer is not finite.
template <class Real>
double direction_error(const Direction<Real>& answer, const Vector3<Real>& v)
{
  const double infinite = std::numeric_limits<double>::infinity();
  if (!answer.unit.allFinite() || !std::isfinite(answer.length))
  {
    return infinite;
  }
  if (v.isZero(0))
  {
    return answer.length == 0 && answer.unit == Vector3<Real>::UnitY() ? 0 : infinite;
  }
  const Vector3<Reference> truth = exact<Reference>(v);
  const Reference length = sqrt(truth.dot(truth));
  const Reference length_error =
      abs(exact<Reference>(answer.length) - length) / Reference(ulp(static_cast<Real>(length)));
  const Vector3<Reference> unit_error =
      (exact<Reference>(answer.unit) - truth / length) / Reference(ulp(Real(1)));
  return static_cast<double>(std::max<Reference>(length_error, unit_error.cwiseAbs().maxCoeff()));
}
// [direction_error]

/// An answer is right within four ulps.
inline constexpr double allowed_ulps = 4;

/// Whether an answer is right, and what to say of it.
template <class Real>
Verdict normalize_verdict(const Direction<Real>& answer, const Vector3<Real>& v)
{
  const double error = direction_error(answer, v);
  const bool taken_for_zero = answer.length == 0 && !v.isZero(0);
  const std::string how = error <= allowed_ulps       ? "right"
                          : answer.unit.hasNaN()      ? "not a number"
                          : std::isinf(answer.length) ? "length infinite"
                          : taken_for_zero            ? "taken for zero"
                                                      : number(error) + " ulp off";
  return {error <= allowed_ulps, how};
}

/// The verdicts on all ways, case by case.
template <class Real>
std::vector<VerdictRow> normalize_verdicts(const std::vector<NormalizeCase<Real>>& cases)
{
  std::vector<VerdictRow> rows;
  for (const NormalizeCase<Real>& one : cases)
  {
    rows.push_back(
        {one.id, one.what, {}, number(one.v.template cast<double>().stableNorm()) + " long"});
    for (const NormalizeMethod<Real>& method : normalize_methods<Real>())
    {
      rows.back().verdicts.push_back(normalize_verdict(method.normalize(one.v), one.v));
    }
  }
  return rows;
}

/// `count` vectors whose largest component is about `size`, the same ones every time.
template <class Real>
std::vector<Vector3<Real>> vectors_of_size(Real size, int count)
{
  std::mt19937 random(1);
  const auto component = [&]
  { return (static_cast<Real>(random() % 2001) / Real(1000) - Real(1)) * size; };
  std::vector<Vector3<Real>> vectors;
  for (int i = 0; i < count; ++i)
  {
    const Real x = component();
    const Real y = component();
    vectors.push_back({x, y, component()});
  }
  return vectors;
}

} // namespace cookbook
