/// \file
/// Products, parts, mirror images, mixtures, lengths and angles against a hundred digits, for
/// random vectors over the whole range of float and of double.

#include "01_math/angles/angles.hpp"
#include "01_math/normalize/trial/normalize_cases.hpp"
#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/truth/trial/whole_range.hpp"
#include "01_math/vectors/vectors.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <limits>

using namespace cookbook;

namespace
{

using Exact3 = Vector3<Reference>;

/// Pairs of vectors: each of any size, of one size, or nearly parallel.
template <class Real>
struct Pairs
{
  WholeRange<Real> range{};

  Real near_one() { return Real(1) + range.fraction() * std::ldexp(Real(1), -range.drawn(2, 60)); }

  std::pair<Vector3<Real>, Vector3<Real>> next()
  {
    const int kind = range.drawn(0, 3);
    const Vector3<Real> a = kind == 0 ? range.vector() : range.even_vector();
    if (kind < 2)
    {
      return {a, kind == 0 ? range.vector() : range.even_vector()};
    }
    const Real size = kind == 2 ? Real(range.drawn(-2, 2)) : range.fraction();
    const Real x = near_one(), y = near_one();
    const Vector3<Real> b = a.cwiseProduct(Vector3<Real>(x, y, near_one())) * size;
    return {a, b.allFinite() ? b : a};
  }
};

/// How far a component is from the truth in units of u times `size`; what is below the smallest
/// number does not count, and what is beyond the largest must be infinite or the largest.
template <class Real>
double roundings(Real answer, const Reference& truth, const Reference& size)
{
  using Limits = std::numeric_limits<Real>;
  const Reference roundoff = Reference(Limits::epsilon()) / 2, most(Limits::max());
  if (std::isinf(answer))
  {
    const bool beyond = abs(truth) + 18 * roundoff * size >= most;
    return beyond && (answer > 0) == (truth > 0) ? 0 : HUGE_VAL;
  }
  const Reference error = abs(Reference(answer) - truth) - Reference(Limits::denorm_min());
  return error <= 0 ? 0 : size == 0 ? HUGE_VAL : static_cast<double>(error / (roundoff * size));
}

/// The worst of three components.
template <class Real>
double roundings(const Vector3<Real>& answer, const Exact3& truth, const Reference& size)
{
  double worst = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double one = roundings(answer[i], truth[i], size);
    worst = one <= worst ? worst : one;
  }
  return worst;
}

constexpr int count = 100000;

} // namespace

TEMPLATE_TEST_CASE(
    "100,000 cross products over the whole range are within 2 u in each component", "[cross]",
    float, double)
{
  Pairs<TestType> pairs;
  double worst = 0;
  for (int i = 0; i < count; ++i)
  {
    const auto [a, b] = pairs.next();
    const Exact3 truth = exact<Reference>(a).cross(exact<Reference>(b));
    const Vector3<TestType> answer = accurate_cross(a, b);
    for (int k = 0; k < 3; ++k)
    {
      worst = std::max(worst, roundings<TestType>(answer[k], truth[k], abs(truth[k])));
    }
    if (!(answer == -accurate_cross(b, a)))
    {
      FAIL("a × b is not minus b × a for pair " << i);
    }
  }
  CHECK(worst <= 2);
  CHECK(worst > 0.9);
}

TEMPLATE_TEST_CASE(
    "100,000 parts along and across, and mirror images, over the whole range", "[M3][M4]", float,
    double)
{
  Pairs<TestType> pairs;
  double along = 0, across = 0, mirrored = 0;
  for (int i = 0; i < count; ++i)
  {
    const auto [a, n] = pairs.next();
    const Exact3 p = exact<Reference>(a), q = exact<Reference>(n);
    const Reference square = q.dot(q);
    const Exact3 part = square == 0 ? Exact3(0, 0, 0) : Exact3(q * Reference(p.dot(q) / square));
    // Between the longest component and the length: within a factor of the root of three.
    const Reference size = p.cwiseAbs().maxCoeff();
    along = std::max(along, roundings(project(a, n), part, size));
    across = std::max(across, roundings(reject(a, n), Exact3(p - part), size));
    mirrored = std::max(mirrored, roundings(reflect(a, n), Exact3(p - 2 * part), size));
  }
  CHECK(along <= 8);
  CHECK(across <= 10);
  CHECK(mirrored <= 18);
}

TEMPLATE_TEST_CASE(
    "100,000 mixtures over the whole range stay between their ends", "[lerp]", float, double)
{
  Pairs<TestType> pairs;
  double worst = 0;
  for (int i = 0; i < count; ++i)
  {
    const auto [a, b] = pairs.next();
    const TestType t = std::abs(pairs.range.fraction());
    const Vector3<TestType> answer = lerp(a, b, t);
    const Reference size =
        exact<Reference>(a).cwiseAbs().cwiseMax(exact<Reference>(b).cwiseAbs()).maxCoeff();
    const Exact3 truth =
        exact<Reference>(a) * (1 - Reference(t)) + exact<Reference>(b) * Reference(t);
    worst = std::max(worst, roundings(answer, truth, size));
    if (!(answer.array() >= a.cwiseMin(b).array()).all() ||
        !(answer.array() <= a.cwiseMax(b).array()).all())
    {
      FAIL("pair " << i);
    }
  }
  CHECK(worst <= 4);
}

TEMPLATE_TEST_CASE(
    "100,000 lengths over the whole range are within 3 u, and normalize agrees", "[length]", float,
    double)
{
  WholeRange<TestType> range;
  double worst = 0, off = 0;
  int different = 0;
  for (int i = 0; i < count; ++i)
  {
    const Vector3<TestType> v = i % 2 == 0 ? range.vector() : range.even_vector();
    const TestType answer = length(v);
    // The square of the length instead of the length: twice the relative error, and no root.
    const Exact3 exactly = exact<Reference>(v);
    const Reference truth = exactly.dot(exactly), square = Reference(answer) * Reference(answer);
    if (std::isinf(answer))
    {
      worst = truth > Reference(std::numeric_limits<TestType>::max()) *
                          Reference(std::numeric_limits<TestType>::max()) * Reference(0.999)
                  ? worst
                  : HUGE_VAL;
      continue;
    }
    const Reference tolerance =
        2 * Reference(answer) * Reference(std::numeric_limits<TestType>::denorm_min());
    const Reference error = abs(square - truth) - tolerance;
    const Reference roundoff = Reference(std::numeric_limits<TestType>::epsilon()) / 2;
    worst = std::max(worst, error <= 0 ? 0 : static_cast<double>(error / (2 * roundoff * truth)));
    const Direction<TestType> direction = normalize(v);
    different += direction.length == answer ? 0 : 1;
    // Each component: 2.5 u from the length, and two roundings more.
    const long double exact_length = std::sqrt(static_cast<long double>(truth));
    const Vector3<long double> missing =
        direction.unit.template cast<long double>() * exact_length - v.template cast<long double>();
    const long double allowed = exact_length * static_cast<long double>(roundoff);
    off = std::max(
        off, v.isZero(0) ? 0 : static_cast<double>(missing.cwiseAbs().maxCoeff() / allowed));
  }
  CHECK(worst <= 3);
  CHECK(off <= 4.5);
  CHECK(different == 0);
}

TEMPLATE_TEST_CASE(
    "100,000 angles over the whole range are within 12 u of themselves", "[M5]", float, double)
{
  Pairs<TestType> pairs;
  double worst = 0;
  int wrong_signs = 0;
  for (int i = 0; i < count; ++i)
  {
    const auto [a, b] = pairs.next();
    const Exact3 p = exact<Reference>(a), q = exact<Reference>(b), cross = p.cross(q);
    // A long double's exponents reach far beyond squares of products of doubles.
    const Vector3<long double> sine = cross.template cast<long double>();
    const long double truth = std::atan2(sine.norm(), static_cast<long double>(p.dot(q)) + 0.0L);
    const long double roundoff = std::numeric_limits<TestType>::epsilon() / 2;
    const long double error =
        std::abs(static_cast<long double>(angle(a, b)) - truth) -
        2 * static_cast<long double>(std::numeric_limits<TestType>::denorm_min());
    worst = std::max(worst, error <= 0 ? 0 : static_cast<double>(error / (roundoff * truth)));
    const Vector3<TestType> axis = pairs.range.even_vector();
    const Exact3 z = exact<Reference>(axis);
    const Reference side = cross.dot(z),
                    sure = cross.cwiseAbs().maxCoeff() * z.cwiseAbs().maxCoeff() * 16 * roundoff;
    const TestType turned = signed_angle(a, b, axis);
    wrong_signs += std::abs(turned) != angle(a, b) ? 1 : 0;
    // Closer to opposite than by the smallest number, there is no side left.
    const bool sided = sine.norm() > 4 * std::abs(static_cast<long double>(p.dot(q))) *
                                         std::numeric_limits<TestType>::denorm_min();
    wrong_signs += sided && abs(side) > sure && (turned < 0) != (side < 0) ? 1 : 0;
  }
  CHECK(worst <= 12);
  CHECK(wrong_signs == 0);
}
