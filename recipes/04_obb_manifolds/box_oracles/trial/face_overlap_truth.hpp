#pragma once

/// \file
/// \brief The polygon that two faces lying on each other have in common.

#include "02_primitives/shapes/shapes.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_reduction_truth.hpp"

#include <utility>
#include <vector>

namespace cookbook
{

/// The part of a convex polygon where side · x_k ≤ limit; O11.
inline std::vector<Corner> cut(const std::vector<Corner>& polygon, int k, double side, double limit)
{
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double before = side * from[k] - limit, after = side * to[k] - limit;
    if (before <= 0)
    {
      kept.push_back(from);
    }
    if ((before < 0 && after > 0) || (before > 0 && after < 0))
    {
      kept.push_back(from + (to - from) * (before / (before - after)));
    }
  }
  return kept;
}

/// A face of a box: its middle, and the steps from there to the middles of two of its edges.
struct Face
{
  Vector3<double> middle; ///< [m], world
  Vector3<double> u;      ///< [m], world
  Vector3<double> v;      ///< [m], world
};

/// The face of a box that looks most along a direction.
inline Face face_towards(const Obb<double>& box, const Vector3<double>& direction)
{
  int k = 0;
  const Vector3<double> along = box.axes.transpose() * direction;
  along.cwiseAbs().maxCoeff(&k);
  const auto step = [&](int i) -> Vector3<double> { return box.axes.col(i) * box.half_extents[i]; };
  const Vector3<double> up = along[k] < 0 ? Vector3<double>(-step(k)) : step(k);
  return {box.center + up, step((k + 1) % 3), step((k + 2) % 3)};
}

/// What A's face along the normal and B's face against it have in common, as seen from A's face:
/// its corners along u and v of that face [m]; none where they do not lie over each other.
inline std::vector<Corner>
true_face_overlap(const Obb<double>& a, const Obb<double>& b, const Vector3<double>& normal)
{
  const Face on_a = face_towards(a, normal), on_b = face_towards(b, -normal);
  const double half_u = on_a.u.norm(), half_v = on_a.v.norm();
  std::vector<Corner> polygon;
  for (const auto& [p, q] :
       {std::pair(1, 1), std::pair(-1, 1), std::pair(-1, -1), std::pair(1, -1)})
  {
    const Vector3<double> corner = on_b.middle - on_a.middle + p * on_b.u + q * on_b.v;
    polygon.push_back({on_a.u.dot(corner) / half_u, on_a.v.dot(corner) / half_v});
  }
  for (const double side : {-1.0, 1.0})
  {
    polygon = cut(cut(polygon, 0, side, half_u), 1, side, half_v);
  }
  return polygon;
}

} // namespace cookbook
