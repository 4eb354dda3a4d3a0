#pragma once

/// \file
/// \brief Impacts of boxes that are foreseen, so that solvers know of them before they are deep.

#include "04_obb_manifolds/box_box/box_box_in_registers.hpp"
#include "04_obb_manifolds/feature_memory/feature_memory.hpp"
#include "06_world/contacts/broad_phase.hpp"
#include "06_world/contacts/moved_body.hpp"
#include "06_world/contacts/narrow_phase.hpp"
#include "06_world/sweeps/box_on_course.hpp"
#include "06_world/sweeps/step_courses.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <variant>

namespace cookbook
{

// [depth_between]
/// How deep [m] two bodies are in each other; less than zero if they are apart, by no matter how
/// much.
struct DepthBetween
{
  const RigidBody &a, &b;

  double operator()(const BoxShape& box, const BoxShape& other) const
  {
    const auto found = box_axis_in<RowInRegisters<double>>(placed(a, box), placed(b, other));
    return found ? found->second : -1;
  }
  template <class Shape, class Other>
  double operator()(const Shape& shape, const Other& other) const
  {
    return -way_between(placed(a, shape), placed(b, other)).length;
  }
  template <class Shape>
  double operator()(const PlaneShape& plane, const Shape& other) const
  {
    return DepthBetween{b, a}(other, plane);
  }
  double operator()(const PlaneShape&, const PlaneShape&) const { return 0; }
};

/// The same of two bodies of a scene, in any poses.
inline double depth_between(
    const Scene& scene, const std::pair<int, int>& pair, const RigidBody& a, const RigidBody& b)
{
  return std::visit(
      DepthBetween{a, b}, scene.bodies[place_of(pair.first)].shape,
      scene.bodies[place_of(pair.second)].shape);
}
// [depth_between]

// [foreseen]
/// How far [m] a body goes in a step if no other pushes it, but for the fall of that step. Its
/// forces lead it half as far where nothing touches it, by a parabola, as where a solver moves it.
inline Vector3<double> way_on(const StepAhead& step, int i, double share)
{
  const RigidBody& body = step.bodies[place_of(i)];
  const double time = step.scene.step;
  const Vector3<double> gained = share * time * force_on(step.forces, place_of(i)).acceleration;
  return is_fixed(body) ? Vector3<double>::Zero()
                        : Vector3<double>(time * (body.motion.velocity + gained));
}
inline constexpr double held_share = 0, flying_share = 0.5, pushed_share = 1; // for way_on()

/// The spin [rad/s] with which it turns meanwhile.
inline Vector3<double> spin_on(const StepAhead& step, int i)
{
  return step.bodies[place_of(i)].motion.angular_velocity +
         step.scene.step * force_on(step.forces, place_of(i)).angular_acceleration;
}

/// How far [m] that takes any of its points: a ball's stay on its surface.
inline double turn_on(const StepAhead& step, int i)
{
  const RigidBody& body = step.bodies[place_of(i)];
  const bool turns = !body.round && !is_fixed(body);
  return turns ? turning_way(step.scene, i, spin_on(step, i), step.scene.step) : 0;
}

/// Whether a way [m] is clearly more than half of a body's smallest size.
inline bool is_far(const Scene& scene, int i, double way)
{
  return way > 1.25 * thinness(scene, i);
}

/// How a body goes on if nothing pushes it.
inline Ahead ahead_of(const StepAhead& step, int i)
{
  Ahead ahead;
  ahead.way = way_on(step, i, flying_share);
  ahead.turn = turn_on(step, i);
  ahead.harmless = harmless_depth(thinness(step.scene, i));
  return ahead;
}

/// Whether a body is left to the sweep: a box that goes far, a ball sooner.
inline bool is_left_to_sweep(const StepAhead& step, int i)
{
  const Ahead& ahead = step.ahead[place_of(i)];
  const double way = ahead.farthest();
  return step.bodies[place_of(i)].round ? way > ahead.harmless : is_far(step.scene, i, way);
}

/// A body where it would be after a step in which it goes and turns on as it does; its inertia is
/// still that of where it is.
inline RigidBody going_on(const StepAhead& step, int i, double share)
{
  RigidBody body = step.bodies[place_of(i)];
  body.motion.center += way_on(step, i, share);
  if (!body.round && !is_fixed(body))
  {
    body.orientation = turned_by(body, step.scene.step * spin_on(step, i));
    body.axes = body.orientation.toRotationMatrix();
  }
  return body;
}

/// The bounds of a body where it is, wider by half the margin [m] of contacts; and where it will be
/// if nothing pushes it, unless that is far: only the sweep asks what lies so far ahead.
inline Eigen::AlignedBox<double, 3> foreseen_bounds(const StepAhead& step, int i, double margin)
{
  const RigidBody& body = step.bodies[place_of(i)];
  const Ahead& ahead = step.ahead[place_of(i)];
  const auto& shape = step.scene.bodies[place_of(i)].shape;
  const double farthest = ahead.farthest();
  if (is_far(step.scene, i, farthest))
  {
    return bounds_of(body, shape, margin / 2);
  }
  const double rounding = 1e-9 * farthest;
  const Eigen::AlignedBox<double, 3> here =
      bounds_of(body, shape, margin / 2 + ahead.turn + rounding);
  return here.merged(here.translated(ahead.way))
      .merged(here.translated(way_on(step, i, pushed_share)));
}

/// How much closer [m] any points of two bodies may come in a step.
inline double closer_by(const StepAhead& step, int i, int j)
{
  const Ahead &of_a = step.ahead[place_of(i)], &of_b = step.ahead[place_of(j)];
  double way = (of_b.way - of_a.way).norm();
  if (are_forced(step, i, j))
  {
    const Vector3<double> pushed = way_on(step, j, pushed_share) - way_on(step, i, pushed_share);
    way = std::max(way, pushed.norm());
  }
  return way + of_a.turn + of_b.turn;
}

/// An overlap of so many margins is taken away with a speed that gravity takes back in a few steps.
inline constexpr double margins_taken_back = 20;

/// Which two bodies are in contact: those within a margin [m]; within the way by forces, if they
/// lead the two into each other, or one into the other while that is held; and those that would end
/// too deep in each other, and clearly deeper than they are, if they come closer by more than does
/// no harm.
///
/// Where gravity is weak, boxes are harmless only up to a tenth of their way: it would not take
/// back the speed with which they are moved apart. Forces may press on what passes by as gravity
/// does, so that ghosts overlap more, up to what does no harm.
inline ContactReach foreseen_reach(const StepAhead& step, int i, int j, double margin)
{
  const Ahead &of_a = step.ahead[place_of(i)], &of_b = step.ahead[place_of(j)];
  const RigidBody &a = step.bodies[place_of(i)], &b = step.bodies[place_of(j)];
  const double small = std::min(of_a.harmless, of_b.harmless);
  const double harmless = a.round || b.round ? small : std::min(small, margins_taken_back * margin);
  const bool forced = are_forced(step, i, j);
  const double closing = closer_by(step, i, j);
  const bool harms = closing > harmless && !is_left_to_sweep(step, i) && !is_left_to_sweep(step, j);
  if (!harms && !forced)
  {
    return {margin, margin};
  }
  const auto depth = [&](const RigidBody& one, const RigidBody& other) {
    return depth_between(step.scene, {i, j}, one, other);
  };
  const auto end_of = [&](double share_of_a, double share_of_b)
  { return depth(going_on(step, i, share_of_a), going_on(step, j, share_of_b)); };
  const double flown = end_of(flying_share, flying_share);
  const double end = forced ? std::max(flown, end_of(pushed_share, pushed_share)) : flown;
  const double by_forces = forced ? way_by_forces(step.scene, step.forces, i, j) : 0;
  const double ghost = ghost_margin(margin, by_forces, small);
  const double least = std::max(harmless, std::min(small, closing / 10));
  if (harms && end > least && end > depth(a, b) + harmless / 10)
  {
    return {margin + closing, ghost};
  }
  const bool led = forced && (end > 0 || end_of(pushed_share, held_share) > 0 ||
                              end_of(held_share, pushed_share) > 0);
  return {led ? margin + by_forces : margin, ghost};
}
// [foreseen]

} // namespace cookbook
