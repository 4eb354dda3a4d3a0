#pragma once

/// \file
/// \brief How steady a method's manifolds of resting boxes are, and how much of the contact they
/// span.

#include "04_obb_manifolds/box_oracles/trial/face_overlap_truth.hpp"
#include "04_obb_manifolds/box_oracles/trial/manifold_distance.hpp"
#include "04_obb_manifolds/box_oracles/trial/workload_quality.hpp"

#include <cmath>
#include <vector>

namespace cookbook
{

/// The area that a manifold's points span, as part of what the two faces along its normal have in
/// common; zero where these have nothing.
template <std::size_t Capacity>
double area_fraction(
    const Obb<double>& a, const Obb<double>& b, const Manifold<double, Capacity>& manifold)
{
  const double faces = std::abs(area(true_face_overlap(a, b, manifold.normal)));
  return faces > 0 ? area(support(manifold)) / faces : 0;
}

/// A box moved by a part of `size` [m] in some direction and turned by as many radians.
///
/// Never inlined, for the reason that to_float() gives.
template <class Real>
[[gnu::noinline]] Obb<Real> nudged(const Obb<Real>& box, double size, double part, BoxDraw& draw)
{
  const Vector3<double> step = part * size * draw.direction();
  const Matrix3<double> turn = BoxDraw::tilt(part, draw.direction());
  const Vector3<double> center = box.center.template cast<double>() + step;
  const Matrix3<double> axes = turn * box.axes.template cast<double>();
  return {center.cast<Real>(), axes.template cast<Real>(), box.half_extents};
}

/// The mean of a manifold's points [m], world.
template <std::size_t Capacity>
Vector3<double> centroid(const Manifold<double, Capacity>& manifold)
{
  Vector3<double> sum(0, 0, 0);
  for (const ContactPoint<double>& point : manifold.points)
  {
    sum += point.position;
  }
  return sum / static_cast<double>(manifold.points.size());
}

/// How steady a method is on a workload of resting boxes.
struct RestingSteadiness
{
  std::size_t compared = 0; ///< pairs that the method says overlap, before and after a nudge
  std::size_t lost = 0;     ///< pairs that it says overlap before or after, not both
  double area = 0;          ///< [1], hull of the points over the faces' overlap; 1st percentile
  double jump = 0;          ///< [1], of the points' centroid, of the pair's size; 99th percentile
  double recounted = 0;     ///< [1], fraction of pairs whose number of points changes
};

/// Nudges B of each pair once, by 1e-4, and compares what `method(a, b)` says before and after.
template <class Real, class Method>
RestingSteadiness resting_steadiness(const BoxWorkload& workload, const Method& method)
{
  BoxDraw draw(5);
  RestingSteadiness steadiness;
  std::vector<double> areas, jumps;
  std::size_t recounted = 0;
  for (const BoxPair<float>& pair : workload.pairs)
  {
    const auto [a, b] = pair_in<Real>(pair);
    const double size = static_cast<double>(pair_size(a, b));
    const auto before = method(a, b), after = method(a, nudged(b, size, 1e-4, draw));
    if (!before || !after)
    {
      steadiness.lost += before || after ? 1 : 0;
      continue;
    }
    areas.push_back(area_fraction(box_in<double>(a), box_in<double>(b), in_double(*before)));
    jumps.push_back((centroid(in_double(*after)) - centroid(in_double(*before))).norm() / size);
    recounted += before->points.size() != after->points.size() ? 1 : 0;
  }
  steadiness.compared = areas.size();
  steadiness.area = areas.empty() ? 0 : measure::percentile(areas, 1);
  steadiness.jump = p99(jumps);
  steadiness.recounted = static_cast<double>(recounted) / static_cast<double>(areas.size());
  return steadiness;
}

} // namespace cookbook
