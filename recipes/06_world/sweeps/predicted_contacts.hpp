#pragma once

/// \file
/// \brief Speculative contacts of boxes, which solvers get before they are deep.

#include "04_obb_manifolds/box_box/box_box_in_registers.hpp"
#include "04_obb_manifolds/feature_memory/feature_memory.hpp"
#include "06_world/contacts/broad_phase.hpp"
#include "06_world/contacts/integrate_body.hpp"
#include "06_world/contacts/narrow_phase.hpp"
#include "06_world/sweeps/step_trajectories.hpp"

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

namespace cookbook
{

// [depth_between]
/// The depth [m] of two bodies of a scene in any poses; negative if they are separated.
inline double depth_between(
    const Scene& scene, const std::pair<int, int>& pair, const RigidBody& a, const RigidBody& b)
{
  const auto depth = [&](const auto& of_a, const auto& of_b)
  {
    const auto here = placed(a, of_a);
    const auto there = placed(b, of_b);
    if constexpr (
        std::is_same_v<decltype(here), decltype(there)> &&
        std::is_same_v<decltype(here), const Obb<double>>) // most pairs: the fast test
    {
      const auto found = box_axis_in<RowInRegisters<double>>(here, there);
      return found ? found->second : -1;
    }
    else
    {
      return -gap_of(here, there).length;
    }
  };
  return std::visit(
      depth, scene.bodies[index_of(pair.first)].shape, scene.bodies[index_of(pair.second)].shape);
}
// [depth_between]

// [predicted_contacts]
/// The predicted displacement [m] of a body in a step, without gravity, with a fraction of what its
/// forces add.
inline Vector3<double> predicted_displacement(const PredictedStep& step, int i, double fraction)
{
  const RigidBody& body = step.bodies[index_of(i)];
  const double time = step.scene.step;
  const Vector3<double> gained = fraction * time * force_on(step.forces, index_of(i)).acceleration;
  return stays(body) ? Vector3<double>::Zero()
                     : Vector3<double>(time * (body.motion.velocity + gained));
}
/// That fraction for a body that is held, for one that nothing touches, for one that is pushed.
inline constexpr double held_fraction = 0, flying_fraction = 0.5, pushed_fraction = 1;

/// The predicted angular velocity [rad/s].
inline Vector3<double> predicted_spin(const PredictedStep& step, int i)
{
  return step.bodies[index_of(i)].motion.angular_velocity +
         step.scene.step * force_on(step.forces, index_of(i)).angular_acceleration;
}

/// How far [m] that rotation moves any point of the body; zero for a sphere.
inline double predicted_rotation(const PredictedStep& step, int i)
{
  const RigidBody& body = step.bodies[index_of(i)];
  const bool turns = !body.is_sphere && !stays(body);
  return turns ? rotation_displacement(step.scene, i, predicted_spin(step, i), step.scene.step) : 0;
}

/// A displacement this many times another is clearly more: forces and impulses that are not known
/// yet would not bring it below.
inline constexpr double clearly_more = 1.25;

/// Whether a displacement [m] is clearly more than half of a body's smallest size.
inline bool is_far(const Scene& scene, int i, double displacement)
{
  return displacement > clearly_more * inner_radius(scene, i);
}

/// Predicts the step of a body that nothing touches.
inline Prediction predict(const PredictedStep& step, int i)
{
  Prediction prediction;
  prediction.displacement = predicted_displacement(step, i, flying_fraction);
  prediction.rotation = predicted_rotation(step, i);
  prediction.allowed_penetration = allowed_penetration(inner_radius(step.scene, i));
  return prediction;
}

/// Whether a body is left to the sweep: a box that moves far, a sphere that might penetrate.
inline bool is_left_to_sweep(const PredictedStep& step, int i)
{
  const Prediction& prediction = step.prediction[index_of(i)];
  const double displacement = prediction.max_displacement();
  return step.bodies[index_of(i)].is_sphere ? displacement > prediction.allowed_penetration
                                            : is_far(step.scene, i, displacement);
}

/// A body in its predicted pose after a step; its inertia is still that of the present pose.
inline RigidBody predicted_body(const PredictedStep& step, int i, double fraction)
{
  RigidBody body = step.bodies[index_of(i)];
  body.motion.center += predicted_displacement(step, i, fraction);
  if (!body.is_sphere && !stays(body))
  {
    body.orientation = turned_by(body, step.scene.step * predicted_spin(step, i));
    body.axes = body.orientation.toRotationMatrix();
  }
  return body;
}

/// The AABB of a body, wider by half the contact margin [m], swept to its predicted pose, unless
/// that is far: then the sweep finds what it touches.
inline Eigen::AlignedBox<double, 3>
predicted_bounds(const PredictedStep& step, int i, double margin)
{
  const RigidBody& body = step.bodies[index_of(i)];
  const Prediction& prediction = step.prediction[index_of(i)];
  const auto& shape = step.scene.bodies[index_of(i)].shape;
  const double max_displacement = prediction.max_displacement();
  if (is_far(step.scene, i, max_displacement))
  {
    return bounds_of(body, shape, margin / 2);
  }
  const double rounding = length_rounding * max_displacement;
  const Eigen::AlignedBox<double, 3> here =
      bounds_of(body, shape, margin / 2 + prediction.rotation + rounding);
  return here.merged(here.translated(prediction.displacement))
      .merged(here.translated(predicted_displacement(step, i, pushed_fraction)));
}

/// How much closer [m] any points of two bodies may come in a step.
inline double max_approach(const PredictedStep& step, int i, int j)
{
  const Prediction &of_a = step.prediction[index_of(i)], &of_b = step.prediction[index_of(j)];
  double displacement = (of_b.displacement - of_a.displacement).norm();
  if (are_forced(step, i, j))
  {
    const Vector3<double> pushed = predicted_displacement(step, j, pushed_fraction) -
                                   predicted_displacement(step, i, pushed_fraction);
    displacement = std::max(displacement, pushed.norm());
  }
  return displacement + of_a.rotation + of_b.rotation;
}

/// Where gravity is weak, boxes may overlap by their displacement over this.
inline constexpr double displacement_parts = 10;

/// An overlap of so many margins is removed at a speed that gravity stops in a few steps.
inline constexpr double margins_taken_back = 20;

/// The margins of two bodies: the contact margin [m]; wider by their displacement by forces that
/// push them together, or, of speculative contacts, by all they may come closer if they would end
/// too deep: weak gravity would not stop the speed at which a deep overlap of boxes is removed.
inline ContactMargins predicted_margins(const PredictedStep& step, int i, int j, double margin)
{
  const Prediction &of_a = step.prediction[index_of(i)], &of_b = step.prediction[index_of(j)];
  const RigidBody &a = step.bodies[index_of(i)], &b = step.bodies[index_of(j)];
  const double smaller = std::min(of_a.allowed_penetration, of_b.allowed_penetration);
  const double allowed_penetration =
      a.is_sphere || b.is_sphere ? smaller : std::min(smaller, margins_taken_back * margin);
  const bool forced = are_forced(step, i, j);
  const double closing = max_approach(step, i, j);
  const bool penetrates =
      closing > allowed_penetration && !is_left_to_sweep(step, i) && !is_left_to_sweep(step, j);
  if (!penetrates && !forced)
  {
    return {margin, margin};
  }
  const auto depth = [&](const RigidBody& one, const RigidBody& other) {
    return depth_between(step.scene, {i, j}, one, other);
  };
  const auto end_depth = [&](double of_forces_on_a, double of_forces_on_b) {
    return depth(predicted_body(step, i, of_forces_on_a), predicted_body(step, j, of_forces_on_b));
  };
  const double flown = end_depth(flying_fraction, flying_fraction);
  const double end = forced ? std::max(flown, end_depth(pushed_fraction, pushed_fraction)) : flown;
  const double by_forces = forced ? displacement_by_forces(step.scene, step.forces, i, j) : 0;
  const double ghost = ghost_margin(margin, by_forces, smaller);
  const double too_deep =
      std::max(allowed_penetration, std::min(smaller, closing / displacement_parts));
  if (penetrates && end > too_deep && end > depth(a, b) + allowed_penetration / deepening_parts)
  {
    return {margin + closing, ghost};
  }
  const bool pressed_together =
      forced && (end > 0 || end_depth(pushed_fraction, held_fraction) > 0 ||
                 end_depth(held_fraction, pushed_fraction) > 0);
  return {pressed_together ? margin + by_forces : margin, ghost};
}
// [predicted_contacts]

} // namespace cookbook
