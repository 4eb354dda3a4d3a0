#pragma once

/// \file
/// \brief Solids at which one or another way of running GJK and EPA fails, with the right depths.

#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "common/math/rotation.hpp"

#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// Two shapes as GJK sees them: their Minkowski difference, and how large it is.
template <class Real>
struct ConvexPair
{
  std::function<SupportPoint<Real>(const Vector3<Real>&)> support; ///< support point of A ⊖ B
  Vector3<Real> start;                                             ///< a direction, of any length
  Real size; ///< [m], no point of A or B is farther from its centre; the two added up
};

/// What rounding may make of lengths as large as a pair [m].
template <class Real>
Real tolerance_of(const ConvexPair<Real>& pair)
{
  return Real(32) * std::numeric_limits<Real>::epsilon() * pair.size;
}

/// Two boxes in A's frame, their numbers as they are.
template <class Real>
ConvexPair<Real> convex_pair(const Obb<Real>& a, const Obb<Real>& b)
{
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  return {MinkowskiDifference<Real>{boxes}, boxes.offset, boxes.half_a.sum() + boxes.half_b.sum()};
}

/// The point of a box farthest along a direction; world.
template <class Real>
Vector3<Real> support_of(const Obb<Real>& box, const Vector3<Real>& direction)
{
  const Vector3<Real> in_box = box.axes.transpose() * direction;
  return box.center + box.axes * support_corner(in_box, box.half_extents);
}

/// The point of a capsule farthest along a direction; world.
template <class Real>
Vector3<Real> support_of(const Capsule<Real>& capsule, const Vector3<Real>& direction)
{
  const Vector3<Real>&p = capsule.segment.start, &q = capsule.segment.end;
  const Vector3<Real> round = capsule.radius * normalize(direction).unit;
  return round + (direction.dot(p) < direction.dot(q) ? q : p);
}

/// Any two shapes whose support functions are known, in the world; `size` as in ConvexPair.
template <class Real, class A, class B>
ConvexPair<Real> convex_pair(const A& a, const B& b, Real size)
{
  const auto support = [=](const Vector3<Real>& direction) -> SupportPoint<Real>
  {
    const Vector3<Real> on_a = support_of(a, direction);
    return {on_a - support_of<Real>(b, -direction), on_a};
  };
  return {support, Vector3<Real>::UnitX(), size};
}

/// A capsule deep in a box, tens of metres large and turned anyhow, in float.
///
/// It comes out at the box's +y face, which lies `half_extents.y` from the centre.
inline ConvexPair<float> capsule_in_box()
{
  const Matrix3<float> turn = rational_rotation<float>(1, 2, 3, 0);
  const Vector3<float> low(-3.1f, 2.2f, 1.3f), high(4.7f, 6.1f, -2.9f);
  const Capsule<float> capsule{{turn * low, turn * high}, 1.9f};
  return convex_pair<float>(Obb<float>{{0, 0, 0}, turn, {17.3f, 11.7f, 14.9f}}, capsule, 50);
}

/// The depth of capsule_in_box(): from the capsule's lowest point to the box's top.
inline constexpr double capsule_in_box_depth = 11.7 - (2.2 - 1.9);

/// Two round ends of one metre, their centres 0.3 m apart: no face anywhere, 1.7 m deep.
inline ConvexPair<double> two_spheres()
{
  const auto sphere = [](const Vector3<double>& center) -> Capsule<double> {
    return {{center, center}, 1};
  };
  return convex_pair<double>(sphere({0, 0, 0}), sphere({0.1, 0.2, 0.2}), 2.0);
}

/// The depth of two_spheres(): two radii less the distance of the centres.
inline constexpr double two_spheres_depth = 2 - 0.3;

/// The rotation of the cubes below, fractions with denominator 23.
inline Matrix3<double> cube_rotation()
{
  return rational_rotation<double>(1, 2, 3, 3);
}

/// Two equal cubes, the second above the first and sunk in by a depth [m], or apart where negative.
inline std::pair<Obb<double>, Obb<double>>
cubes_in_line(double half_extent, const Matrix3<double>& rotation, double depth)
{
  const Vector3<double> half = Vector3<double>::Constant(half_extent);
  const Vector3<double> up = rotation.col(1) * (2 * half_extent - depth);
  return {{{0, 0, 0}, rotation, half}, {up, rotation, half}};
}

/// Random cubes that every compiler draws alike: edges 0.2 to 2 m, centres within 1.5 m.
class RandomCubes
{
public:
  /// Begins with a seed.
  explicit RandomCubes(unsigned seed) : engine_(seed) {}

  /// The next cube.
  Obb<double> next()
  {
    const Vector3<double> center = 1.5 * in_cube();
    const Vector3<double> axis = in_cube();
    const Quaternion<double> rotation(part(), axis.x(), axis.y(), axis.z());
    const double half_extent = 0.55 + 0.45 * part();
    return {
        center, rotation.normalized().toRotationMatrix(), Vector3<double>::Constant(half_extent)};
  }

private:
  double part() { return static_cast<double>(engine_()) * 0x1p-31 - 1; }
  Vector3<double> in_cube()
  {
    const double x = part(), y = part();
    return {x, y, part()};
  }

  std::mt19937 engine_;
};

/// The largest gap of the fifteen axes [m]; negative where boxes overlap, and then less the depth.
inline double largest_separation(const Obb<double>& a, const Obb<double>& b)
{
  const RelativeBoxes<double> boxes = relative_boxes(a, b);
  double separation = -std::numeric_limits<double>::max();
  for (int axis = 0; axis < box_axes; ++axis)
  {
    const AxisOverlap<double> along = axis_overlap(boxes, axis);
    if (!from_parallel_edges(along))
    {
      separation = std::max(separation, -along.overlap / std::sqrt(along.squared_length));
    }
  }
  return separation;
}

} // namespace cookbook
