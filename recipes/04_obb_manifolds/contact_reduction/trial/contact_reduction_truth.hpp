#pragma once

/// \file
/// \brief The area that contact points span, the best four of them, and squares turned on squares,
/// whose contact is known in closed form.

#include "04_obb_manifolds/contact_reduction/contact_reduction.hpp"

#include <vector>

namespace cookbook
{

/// A corner as seen against the normal [m].
using Corner = Eigen::Vector2d;

/// Twice the area [m²] of the triangle p, q, r; negative if it turns clockwise.
inline double doubled_area(const Corner& p, const Corner& q, const Corner& r)
{
  const Corner u = q - p, v = r - p;
  return u.x() * v.y() - u.y() * v.x();
}

/// Adds a corner to a chain that turns to the left at each of its corners.
inline void add_to_chain(std::vector<Corner>& chain, std::size_t first, const Corner& corner)
{
  while (chain.size() >= first + 2 && doubled_area(chain.end()[-2], chain.back(), corner) <= 0)
  {
    chain.pop_back();
  }
  chain.push_back(corner);
}

/// The convex hull of corners, counter-clockwise: those below from left to right, then those above
/// from right to left.
inline std::vector<Corner> convex_hull(std::vector<Corner> corners)
{
  std::sort(
      corners.begin(), corners.end(),
      [](const Corner& p, const Corner& q)
      { return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y()); });
  std::vector<Corner> hull;
  for (const Corner& corner : corners)
  {
    add_to_chain(hull, 0, corner);
  }
  const std::size_t first = hull.size() - 1;
  for (std::size_t i = corners.size() - 1; i-- > 0;)
  {
    add_to_chain(hull, first, corners[i]);
  }
  hull.resize(std::max<std::size_t>(1, hull.size() - 1));
  return hull;
}

/// A point as seen along the normal: its coordinates along two directions perpendicular to it.
inline Corner seen_along(const Vector3<double>& normal, const Vector3<double>& point)
{
  int least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Vector3<double> right = normal.cross(Vector3<double>::Unit(least)).normalized();
  return {right.dot(point), normal.cross(right).dot(point)};
}

/// The convex hull of a manifold's points, seen along its normal.
template <std::size_t Capacity>
std::vector<Corner> support(const Manifold<double, Capacity>& manifold)
{
  std::vector<Corner> corners;
  for (const ContactPoint<double>& point : manifold.points)
  {
    corners.push_back(seen_along(manifold.normal, point.position));
  }
  return convex_hull(corners);
}

/// The area [m²] of a convex polygon.
inline double area(const std::vector<Corner>& polygon)
{
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    twice += doubled_area(polygon[0], polygon[i - 1], polygon[i]);
  }
  return twice / 2;
}

/// How far [m] a point is inside a convex polygon; negative outside.
inline double inside(const std::vector<Corner>& polygon, const Corner& point)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    least = std::min(least, doubled_area(p, q, point) / (q - p).norm());
  }
  return least;
}

/// The four points that span the largest area, by trying all choices of four.
template <std::size_t Capacity>
Manifold<double, most_kept> best_four(const Manifold<double, Capacity>& manifold)
{
  Keeping<double, Capacity> few = keeping(manifold);
  const std::size_t count = manifold.points.size();
  Manifold<double, most_kept> best = few.result();
  double most = 0;
  for (unsigned choice = 0; count > most_kept && choice < (1u << count); ++choice)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      few.kept[i] = (choice >> i) % 2 == 1;
    }
    if (std::count(few.kept.begin(), few.kept.end(), true) == most_kept)
    {
      const Manifold<double, most_kept> four = few.result();
      const double now = area(support(four));
      best = now > most ? four : best;
      most = std::max(most, now);
    }
  }
  return best;
}

/// The contact of a square of half side 1 with another above it that is turned by `yaw` [rad],
/// between 0 and π/2: eight corners, counter-clockwise as seen from above.
///
/// It is `leaning` [1] deeper for each metre along z, and 0.01 m deep in the middle.
inline Manifold<double> turned_squares(double yaw, double leaning)
{
  const double quarter = 2 * std::atan(1.0);
  Manifold<double> manifold{{0, 1, 0}, 0, {}};
  for (int side = 0; side < 8; ++side)
  {
    // Sides lie perpendicular to 0, yaw, 90°, 90° + yaw, …: a corner is halfway from one to the
    // next.
    const double turn = side % 2 == 0 ? yaw : quarter - yaw;
    const double middle = quarter * (side / 2) + (side % 2 == 0 ? yaw / 2 : (yaw + quarter) / 2);
    const double out = 1 / std::cos(turn / 2);
    const double x = out * std::cos(middle), z = -out * std::sin(middle);
    const double depth = 0.01 + leaning * z;
    manifold.points.push_back({{x, 1 - depth / 2, z}, depth, static_cast<std::uint32_t>(side)});
    manifold.depth = std::max(manifold.depth, depth);
  }
  return manifold;
}

} // namespace cookbook
