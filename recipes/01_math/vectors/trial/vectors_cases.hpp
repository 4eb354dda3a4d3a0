#pragma once

/// \file
/// \brief Where textbook formulas on vectors break, and what the recommended ones answer there.

#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/vectors/vectors.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// The part of `a` along `n`, as its formula is written: 0 / 0 where the square of `n` is lost.
template <class Real>
Vector3<Real> project_textbook(const Vector3<Real>& a, const Vector3<Real>& n)
{
  return n * (a.dot(n) / n.dot(n));
}

/// A mixture of both ends, as GLM's mix: from `a` to `a` it may miss `a`.
template <class Real>
Vector3<Real> lerp_by_mixture(const Vector3<Real>& a, const Vector3<Real>& b, Real t)
{
  return (Real(1) - t) * a + t * b;
}

/// Our model of a published difference of vectors in the plane, which takes y from x.
template <class Real>
Vector3<Real> minus_as_published(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return {a.x() - b.y(), a.y() - b.y(), a.z()};
}

/// A formula on two vectors with what it should answer.
struct VectorsCase
{
  std::string id;              ///< in the book; empty for our own
  std::string what;            ///< the set-up
  Vector3<double> textbook;    ///< the formula's answer
  Vector3<double> recommended; ///< ours
  Vector3<double> truth;       ///< by hand
};

/// Inputs that break a formula as it is usually written.
inline std::vector<VectorsCase> vectors_cases()
{
  using D = Vector3<double>;
  using F = Vector3<float>;
  const auto wide = [](const F& v) { return D(v.cast<double>()); };
  const D p(1e8 + 1, 1e8, 0), q(1e8, 1e8 - 1, 0), huge(1e200, 1e200, 0);
  const F a(1, 2, 3), n(2, 1, 2), zero(0, 0, 0), long_n(1.1f, 0, 0), x(1, 0, 0);
  const F distant(1e8f, 0, 0), most(3e38f, 0, 0), tenth(0.1f, 0, 0);
  const float tiny = 1e-30f, large = 1e25f, fifth = 0.2f;
  return {
      {"", "nearly parallel: (1e8 + 1, 1e8, 0) × (1e8, 1e8 − 1, 0)", p.cross(q),
       accurate_cross<double>(p, q), D(0, 0, -1)},
      {"", "(1e200, 1e200, 0) × itself", huge.cross(huge), accurate_cross<double>(huge, huge),
       D(0, 0, 0)},
      {"", "(1, 2, 3) along (2, 1, 2) · 1e-30, float", wide(project_textbook<float>(a, n * tiny)),
       wide(project<float>(a, n * tiny)), D(20, 10, 20) / 9},
      {"", "(1, 2, 3) along (2, 1, 2) · 1e25, float", wide(project_textbook<float>(a, n * large)),
       wide(project<float>(a, n * large)), D(20, 10, 20) / 9},
      {"", "(1, 2, 3) along the zero vector", wide(project_textbook<float>(a, zero)),
       wide(project<float>(a, zero)), D(0, 0, 0)},
      {"", "(1, 0, 0) mirrored, normal (1.1, 0, 0)", wide(reflect_unit<float>(x, long_n)),
       wide(reflect<float>(x, long_n)), D(-1, 0, 0)},
      {"", "lerp as a + t (b − a): from 1e8 to 1, t = 1", wide(plain::lerp<float>(distant, x, 1)),
       wide(lerp<float>(distant, x, 1)), D(1, 0, 0)},
      {"", "lerp as a + t (b − a): from −3e38 to 3e38, t = 1/2",
       wide(plain::lerp<float>(-most, most, 0.5f)), wide(lerp<float>(-most, most, 0.5f)),
       D(0, 0, 0)},
      {"", "lerp as (1 − t) a + t b: from 0.1 to 0.1, t = 0.2",
       wide(lerp_by_mixture<float>(tenth, tenth, fifth)), wide(lerp<float>(tenth, tenth, fifth)),
       wide(tenth)},
      {"", "(3, 5, 0) − (1, 2, 0), as published", minus_as_published<double>({3, 5, 0}, {1, 2, 0}),
       D(3, 5, 0) - D(1, 2, 0), D(2, 3, 0)}};
}

/// The components of a vector as text.
inline std::string components(const Vector3<double>& v)
{
  std::string cells = number(v.x());
  return cells.append(", ").append(number(v.y())).append(", ").append(number(v.z()));
}

/// Right is within 18 roundings of float of the longest of truth; exactly where the truth is exact.
inline Verdict vectors_verdict(const Vector3<double>& answer, const Vector3<double>& truth)
{
  const double allowed = truth.x() == 20.0 / 9 ? 18 * 0x1p-24 * truth.norm() : 0;
  const bool holds = !answer.hasNaN() && (answer - truth).cwiseAbs().maxCoeff() <= allowed;
  const std::string what = holds                                     ? "right"
                           : answer.hasNaN()                         ? "not a number"
                           : !answer.allFinite()                     ? "infinite"
                           : components(answer) == components(truth) ? "a rounding off"
                                                                     : components(answer);
  return {holds, what};
}

/// The names of the columns.
inline const std::vector<std::string> vectors_methods{"textbook", "recommended"};

/// The verdicts, case by case.
inline std::vector<VerdictRow> vectors_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const VectorsCase& one : vectors_cases())
  {
    rows.push_back(
        {one.id,
         one.what,
         {vectors_verdict(one.textbook, one.truth), vectors_verdict(one.recommended, one.truth)},
         components(one.truth)});
  }
  return rows;
}

} // namespace cookbook
