#pragma once

/// \file
/// \brief Impacts of boxes that are foreseen, so that solvers know of them before they are deep.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "05_resolution/contacts/broad_phase.hpp"
#include "05_resolution/sweeps/box_on_course.hpp"
#include "05_resolution/sweeps/step_courses.hpp"
#include "common/simd/registers.hpp"

#include <algorithm>
#include <span>
#include <variant>

namespace cookbook
{

// [depth_between]
/// How deep [m] two bodies are in each other; less than zero if they are apart.
struct DepthBetween
{
  const RigidBody &a, &b;

  double operator()(const BoxShape& box, const BoxShape& other) const
  {
    const auto found = box_axis_in<Registers<double>>(placed(a, box), placed(b, other));
    return found ? found->second : -1;
  }
  template <class Shape>
  double operator()(const BoxShape& box, const Shape& other) const
  {
    return -way_between(placed(a, box), placed(b, other)).length;
  }
  template <class Shape>
  double operator()(const SphereShape& ball, const Shape& other) const
  {
    return -way_between(placed(a, ball), placed(b, other)).length;
  }
  template <class Shape>
  double operator()(const PlaneShape& plane, const Shape& other) const
  {
    return DepthBetween{b, a}(other, plane);
  }
  double operator()(const PlaneShape&, const PlaneShape&) const { return 0; }
};
// [depth_between]

// [foreseen]
/// How deep [m] bodies may get into each other unforeseen, of which the thinner one has this
/// thinness [m]: by a twentieth of its smallest size.
inline double harmless_depth(double thinness)
{
  return thinness / 10;
}

/// How far [m] turning carries any point of a body in a step.
inline double turning_way(const Scene& scene, const RigidBody& body, double reach)
{
  return body.round ? 0 : scene.step * body.motion.angular_velocity.norm() * reach;
}

/// Whether a body is swept in this step, if it goes on as it does: a box that goes by more than
/// half of its smallest size, a ball that goes farther than is harmless.
inline bool will_be_swept(const Scene& scene, const RigidBody& body, int i)
{
  const double thin = thinness(scene, i);
  const double way = scene.step * body.motion.velocity.norm();
  return way + turning_way(scene, body, reach(scene, i)) >
         (body.round ? harmless_depth(thin) : thin);
}

/// A body as it would be after a step in which nothing pushes it, but for the fall of that step: as
/// far as that leads, the margin of contacts covers.
inline RigidBody going_on(const Scene& scene, RigidBody body)
{
  body.motion.center += scene.step * body.motion.velocity;
  spin(body, scene.step);
  return body;
}

/// The bounds of a body where it is, wider by half the margin of contacts; and where it will be if
/// nothing pushes it, unless it is swept.
inline Eigen::AlignedBox<double, 3>
foreseen_bounds(const Scene& scene, const RigidBody& body, int i)
{
  const auto& shape = scene.bodies[place_of(i)].shape;
  const double margin = contact_margin(scene) / 2;
  if (will_be_swept(scene, body, i))
  {
    return bounds_of(body, shape, margin);
  }
  const double turning = turning_way(scene, body, reach(scene, i));
  const Eigen::AlignedBox<double, 3> here = bounds_of(body, shape, margin + turning);
  return here.merged(here.translated(scene.step * body.motion.velocity));
}

/// How far apart [m] two bodies may be and be in contact: the margin; or as far as they may come
/// closer in this step, if they would end too deep in each other, and deeper than they are.
inline double foreseen_reach(const Scene& scene, std::span<const RigidBody> bodies, int i, int j)
{
  const double margin = contact_margin(scene);
  const RigidBody &a = bodies[place_of(i)], &b = bodies[place_of(j)];
  const double harmless = harmless_depth(std::min(thinness(scene, i), thinness(scene, j)));
  const double closing = scene.step * (b.motion.velocity - a.motion.velocity).norm() +
                         turning_way(scene, a, reach(scene, i)) +
                         turning_way(scene, b, reach(scene, j));
  if (!(closing > harmless) || will_be_swept(scene, a, i) || will_be_swept(scene, b, j))
  {
    return margin;
  }
  const auto depth = [&](const RigidBody& one, const RigidBody& other)
  {
    return std::visit(
        DepthBetween{one, other}, scene.bodies[place_of(i)].shape, scene.bodies[place_of(j)].shape);
  };
  const double end = depth(going_on(scene, a), going_on(scene, b));
  return end > harmless && end > depth(a, b) + harmless / 10 ? margin + closing : margin;
}
// [foreseen]

} // namespace cookbook
