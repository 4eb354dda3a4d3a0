/// \file
/// Random shapes, their exact answers, and how far a float's answer is from those.
#pragma once

#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "common/math/norm.hpp"
#include "common/math/ulp.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_numbers.hpp"

namespace cookbook
{

constexpr int pairs_per_world = 1'000'000;

/// The float closest to a number, and the shapes made of such floats.
///
/// Never inlined: where g++ 12 at -O3 sees a double rounded to float and widened again in one
/// vectorised piece, it drops the rounding.
[[gnu::noinline]] inline float rounded(double x)
{
  return static_cast<float>(x);
}

[[gnu::noinline]] inline Sphere<float> rounded(const Sphere<double>& sphere, double scale)
{
  return {(sphere.center * scale).cast<float>(), static_cast<float>(sphere.radius * scale)};
}

[[gnu::noinline]] inline Obb<float> rounded(const Obb<double>& box, double scale)
{
  return {
      (box.center * scale).cast<float>(), box.axes.cast<float>(),
      (box.half_extents * scale).cast<float>()};
}

/// The same numbers in a wider type.
template <class Wider>
Sphere<Wider> exactly(const Sphere<float>& sphere)
{
  return {exact<Wider>(sphere.center), Wider(sphere.radius)};
}

/// What is true of a pair: normal, depth (negative: the gap), and how far apart the points are on
/// which the normal stands.
template <class Real>
struct TrueOverlap
{
  Vector3<Real> normal;
  Real depth;
  Real distance;
};

/// The truth of two spheres, from the definition: centres, their distance, their radii.
template <class Real>
TrueOverlap<Real> true_overlap(const Sphere<Real>& a, const Sphere<Real>& b)
{
  const Vector3<Real> a_to_b = b.center - a.center;
  using std::sqrt;
  const Real distance = sqrt(a_to_b.squaredNorm());
  return {a_to_b / distance, a.radius + b.radius - distance, distance};
}

/// The largest errors of float seen, in ulp.
///
/// A float is compared with the truth in double, and on every hundredth pair that truth is compared
/// with the same in 100 digits, of which none is rounded before the root.
struct Accuracy
{
  int compared = 0;
  int touching = 0;        ///< true contacts among them
  int wrong_verdicts = 0;  ///< where the exact gap or depth is more than 4 ulp
  int not_finite = 0;      ///< answers with a NaN or an infinity
  double depth_error = 0;  ///< in ulp of the larger radius
  double normal_error = 0; ///< in ulp of one, where the centres are at least 1e-3 radii apart
  double truth_error = 0;  ///< of the truth itself, in the same ulp, from the 100 digits

  /// Compares one answer with `truth(Real())`, for Real double and Reference.
  template <class Truth>
  void compare(const std::optional<Manifold<float>>& found, float larger_radius, Truth truth)
  {
    const TrueOverlap<double> near_truth = truth(double());
    if (++compared % 100 == 0)
    {
      check_truth(near_truth, truth(Reference()), larger_radius);
    }
    compare_with(found, near_truth, larger_radius);
  }

private:
  void compare_with(
      const std::optional<Manifold<float>>& found, const TrueOverlap<double>& truth,
      float larger_radius)
  {
    const double unit = ulp(larger_radius);
    touching += truth.depth >= 0 ? 1 : 0;
    if (static_cast<bool>(found) != (truth.depth >= 0))
    {
      wrong_verdicts += std::abs(truth.depth) > 4 * unit ? 1 : 0;
      return;
    }
    if (!found)
    {
      return;
    }
    const bool finite = found->normal.allFinite() && std::isfinite(found->depth) &&
                        found->points[0].position.allFinite();
    not_finite += finite ? 0 : 1;
    depth_error = std::max(depth_error, std::abs(found->depth - truth.depth) / unit);
    if (truth.distance >= 1e-3 * larger_radius)
    {
      const Vector3<double> difference = found->normal.cast<double>() - truth.normal;
      normal_error = std::max(normal_error, difference.cwiseAbs().maxCoeff() / ulp(1.0f));
    }
  }

  void check_truth(
      const TrueOverlap<double>& rounded, const TrueOverlap<Reference>& exact, float larger_radius)
  {
    const Reference depth = abs(rounded.depth - exact.depth) / Reference(ulp(larger_radius));
    truth_error = std::max(truth_error, static_cast<double>(depth));
    if (rounded.distance >= 1e-3 * larger_radius)
    {
      const Vector3<double> difference =
          (rounded.normal.cast<Reference>() - exact.normal).cast<double>();
      truth_error = std::max(truth_error, difference.cwiseAbs().maxCoeff() / ulp(1.0f));
    }
  }
};

// [expect_within_4_ulp]
inline void expect_within_4_ulp(const Accuracy& accuracy)
{
  CAPTURE(accuracy.depth_error, accuracy.normal_error, accuracy.truth_error);
  CHECK(accuracy.compared == pairs_per_world);
  CHECK(accuracy.touching > pairs_per_world / 2);
  CHECK(accuracy.touching < pairs_per_world);
  CHECK(accuracy.wrong_verdicts == 0);
  CHECK(accuracy.not_finite == 0);
  CHECK(accuracy.depth_error <= 4);
  CHECK(accuracy.normal_error <= 4);
  CHECK(accuracy.truth_error <= 1e-4); // double is 2^29 times finer than float
}
// [expect_within_4_ulp]

} // namespace cookbook
