#pragma once

/// \file
/// \brief Ways to find an angle, pairs of vectors that break some, and ways to compare vectors.

#include "01_math/angles/angles.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to find the angle between two vectors, by name.
template <class Real>
struct AngleMethod
{
  std::string name;                                              ///< as on the page
  Real (*angle)(const Vector3<Real>& a, const Vector3<Real>& b); ///< the way
};

/// The ways that compete, the recommended one last.
template <class Real>
std::array<AngleMethod<Real>, 5> angle_methods()
{
  return {
      {{"as published", angle_acos<Real>},
       {"clamped", angle_clamped<Real>},
       {"atan2", plain::angle<Real>},
       {"Kahan", angle_kahan<Real>},
       {"recommended",
        [](const Vector3<Real>& a, const Vector3<Real>& b) { return angle(a, b); }}}};
}

/// The unit vector in the plane whose half angle has this tangent, without sine or cosine.
template <class Real>
Vector3<Real> turned_by_half_tangent(double t)
{
  const double square = t * t;
  return {
      static_cast<Real>((1 - square) / (1 + square)), static_cast<Real>(2 * t / (1 + square)), 0};
}

/// Two vectors and the angle between them.
template <class Real>
struct AngleCase
{
  std::string id;   ///< in the book; empty for our own
  std::string what; ///< the vectors, as text
  Vector3<Real> a;  ///< the first
  Vector3<Real> b;  ///< the second
  double truth;     ///< [rad]
};

/// The pairs to try in float.
inline std::vector<AngleCase<float>> angles_cases(float)
{
  const double pi = 3.14159265358979324;
  const float tiny = std::numeric_limits<float>::denorm_min();
  return {
      {"A3", "1e-4 apart", {1, 0, 0}, turned_by_half_tangent<float>(0.5e-4), 1e-4},
      {"", "(1, 1, 1) and (1, 2, 3)", {1, 1, 1}, {1, 2, 3}, std::acos(6 / std::sqrt(42.0))},
      {"", "(1, 0, 0) and (0, 2, 0)", {1, 0, 0}, {0, 2, 0}, pi / 2},
      {"", "(1001, 1005, 1018) and three times it", {1001, 1005, 1018}, {3003, 3015, 3054}, 0},
      {"", "(1, 0, 0) and (−1e4, 1, 0)", {1, 0, 0}, {-1e4f, 1, 0}, pi - 0.99999999666666669e-4},
      {"", "(8193, 8192, 0) and (8192, 8191, 0)", {8193, 8192, 0}, {8192, 8191, 0}, 0x1p-27},
      {"", "(1e20, 0, 0) and (1e20, 2e20, 0)", {1e20f, 0, 0}, {1e20f, 2e20f, 0}, std::atan(2.0)},
      {"", "(1, 0, 0) and (1, 1, 0), times smallest float", {tiny, 0, 0}, {tiny, tiny, 0}, pi / 4},
      {"", "the zero vector and (−1, −1, −1)", {0, 0, 0}, {-1, -1, -1}, 0}};
}

/// The pairs to try in double.
inline std::vector<AngleCase<double>> angles_cases(double)
{
  return {
      {"",
       "(1e8 + 1, 1e8, 0) and (1e8, 1e8 − 1, 0), double",
       {1e8 + 1, 1e8, 0},
       {1e8, 1e8 - 1, 0},
       0.5e-16},
      {"", "(1, 0, 0) and (1, 1e-300, 0), double", {1, 0, 0}, {1, 1e-300, 0}, 1e-300}};
}

/// An angle is right within this many roundings of itself.
inline constexpr double allowed_roundings = 12;

/// Whether an angle is right, and what to say of it.
template <class Real>
Verdict angle_verdict(Real answer, double truth)
{
  const double roundoff = static_cast<double>(std::numeric_limits<Real>::epsilon()) / 2;
  const double error = std::abs(static_cast<double>(answer) - truth);
  const bool holds = error <= allowed_roundings * roundoff * truth;
  const std::string what = holds                ? "right"
                           : std::isnan(answer) ? "not a number"
                                                : number(static_cast<double>(answer));
  return {holds, what};
}

/// The verdicts on all ways, case by case.
template <class Real>
std::vector<VerdictRow> angles_verdicts(const std::vector<AngleCase<Real>>& cases)
{
  std::vector<VerdictRow> rows;
  for (const AngleCase<Real>& one : cases)
  {
    rows.push_back({one.id, one.what, {}, number(one.truth)});
    for (const AngleMethod<Real>& method : angle_methods<Real>())
    {
      rows.back().verdicts.push_back(angle_verdict(method.angle(one.a, one.b), one.truth));
    }
  }
  return rows;
}

// [equal_as_published]
/// Our model of a published comparison: equal where no component differs by 0.005 or more.
template <class Real>
bool equal_as_published(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return (a - b).cwiseAbs().maxCoeff() < Real(0.005);
}
// [equal_as_published]

/// Two vectors, and whether they should count as equal.
struct EqualCase
{
  std::string what; ///< the set-up
  Vector3<float> a; ///< the first
  Vector3<float> b; ///< the second
  float size;       ///< of the numbers that both were made of
  bool equal;       ///< whether they differ by roundings only
};

/// Pairs of vectors that differ by a rounding, or by more.
inline std::vector<EqualCase> equal_cases()
{
  const float next = std::nextafter(1e6f, 2e6f);
  return {
      {"(0.004, 0, 0) and 0, in a room", {0.004f, 0, 0}, {0, 0, 0}, 1, false},
      {"(1, 1, 1) and (1.004, 1, 1)", {1, 1, 1}, {1.004f, 1, 1}, 1, false},
      {"(1e6, 0, 0) and the next float", {1e6f, 0, 0}, {next, 0, 0}, 1e6f, true},
      {"(0.1 + 0.6 − 0.7, 0, 0) and 0", {0.1f + 0.6f - 0.7f, 0, 0}, {0, 0, 0}, 0.7f, true}};
}

/// The names of the ways to compare.
inline const std::vector<std::string> equal_methods{"as published", "isApprox", "within roundings"};

/// The verdicts on ways to compare.
inline std::vector<VerdictRow> equal_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const EqualCase& one : equal_cases())
  {
    const auto verdict = [&](bool equal) {
      return Verdict{equal == one.equal, equal ? "equal" : "not equal"};
    };
    rows.push_back(
        {"",
         one.what,
         {verdict(equal_as_published(one.a, one.b)), verdict(one.a.isApprox(one.b)),
          verdict(equal_within_roundings(one.a, one.b, one.size))}});
  }
  return rows;
}

} // namespace cookbook
