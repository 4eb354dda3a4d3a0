#pragma once

/// \file
/// \brief How far apart two manifolds are that should be the same.

#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace cookbook
{

/// The manifold's numbers in double.
template <class Real, std::size_t Capacity>
Manifold<double, Capacity> in_double(const Manifold<Real, Capacity>& manifold)
{
  Manifold<double, Capacity> wide{
      manifold.normal.template cast<double>(), static_cast<double>(manifold.depth), {}};
  for (const ContactPoint<Real>& point : manifold.points)
  {
    wide.points.push_back(
        {point.position.template cast<double>(), static_cast<double>(point.depth), point.feature});
  }
  return wide;
}

/// The distance [m] of a point from the nearest point of a manifold, or of a line between two.
///
/// Lines are tried only where no point is nearer than `close_by` [m].
template <std::size_t Capacity>
double distance_to_points(
    const Vector3<double>& p, const Manifold<double, Capacity>& manifold, double close_by)
{
  const auto& points = manifold.points;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    least = std::min(least, (p - points[i].position).norm());
  }
  for (std::size_t k = 0; least > close_by && k < points.size() * points.size(); ++k)
  {
    const Vector3<double>& start = points[k / points.size()].position;
    const Vector3<double> way = points[k % points.size()].position - start;
    const double along = way.isZero(0) ? 0 : (p - start).dot(way) / way.squaredNorm();
    least = std::min(least, (start + std::clamp(along, 0.0, 1.0) * way - p).norm());
  }
  return least;
}

/// How far apart two manifolds are [1]: normals, depths and points, lengths as parts of `size` [m].
///
/// Points may come in any order, and one that lies between two others changes nothing. Infinite
/// where only one says that there is contact.
template <std::size_t Capacity>
double difference(
    const std::optional<Manifold<double, Capacity>>& one,
    const std::optional<Manifold<double, Capacity>>& other, double size)
{
  if (!one || !other)
  {
    return one || other ? std::numeric_limits<double>::infinity() : 0;
  }
  double farthest = std::abs(one->depth - other->depth);
  for (const auto& [from, to] : {std::pair(&*one, &*other), std::pair(&*other, &*one)})
  {
    for (const ContactPoint<double>& point : from->points)
    {
      farthest = std::max(farthest, distance_to_points(point.position, *to, 1e-7 * size));
    }
  }
  return std::max((one->normal - other->normal).norm(), farthest / size);
}

} // namespace cookbook
