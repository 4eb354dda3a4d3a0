#pragma once

/// \file
/// \brief How all bodies of a world went through a step.

#include "06_world/contacts/bounds_tree.hpp"
#include "06_world/contacts/world_contact.hpp"
#include "06_world/sweeps/body_sizes.hpp"
#include "06_world/sweeps/trajectory.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [step_trajectories]
/// A step of a world as solvers and free fall had it.
struct StepTrajectories
{
  const Scene& scene;                               ///< the bodies as it began
  std::span<const ExternalAcceleration> forces;     ///< on them, force_on()
  std::span<const WorldContact> contacts;           ///< of this step
  const std::vector<bool>& falls;                   ///< whether no other body pushed it
  const std::vector<bool>& removed;                 ///< whether it is no more
  std::span<const std::pair<int, int>> close_pairs; ///< those near each other as it began
  std::vector<Trajectory>& trajectories;            ///< of all bodies
  std::vector<double>& displacements;               ///< [m], how far any point of a body went
  std::vector<bool>& needs_sweep;                   ///< left too deep by a solver, or swept
  BoundsTree* tree = nullptr; ///< of all bodies that are there, once any is swept
};

/// A body as the step began.
inline PreviousState start_state(const StepTrajectories& step, int i)
{
  return start_state(step.scene.bodies[index_of(i)]);
}

/// True if a body is a ball.
inline bool is_sphere(const Scene& scene, int i)
{
  return std::holds_alternative<SphereShape>(scene.bodies[index_of(i)].shape);
}

/// How far [m] a body reaches from its centre.
inline double bounding_radius(const Scene& scene, int i)
{
  return std::visit(
      [](const auto& shape) { return bounding_radius_of(shape); }, scene.bodies[index_of(i)].shape);
}

/// How far [m] the nearest point of a body's surface is from its centre.
inline double inner_radius(const Scene& scene, int i)
{
  return std::visit(
      [](const auto& shape) { return inner_radius_of(shape); }, scene.bodies[index_of(i)].shape);
}

/// The allowed penetration [m] of two bodies.
inline double allowed_penetration(const Scene& scene, const std::pair<int, int>& pair)
{
  return allowed_penetration(
      std::min(inner_radius(scene, pair.first), inner_radius(scene, pair.second)));
}

/// How far [m] forces lead two bodies by their places in two steps, one after the other or both
/// towards each other.
inline double displacement_by_forces(
    const Scene& scene, std::span<const ExternalAcceleration> forces, int i, int j)
{
  const Vector3<double> of_a = force_on(forces, index_of(i)).acceleration;
  const Vector3<double> of_b = force_on(forces, index_of(j)).acceleration;
  const double most = std::max({of_a.norm(), of_b.norm(), (of_b - of_a).norm()});
  return 2 * scene.step * scene.step * most;
}

/// By how much [m] two bodies may overlap that only pass each other, is_ghost(): by the margin of
/// contacts, and by the way by forces, up to what does no harm; each [m].
inline double ghost_margin(double margin, double displacement_by_forces, double allowed_penetration)
{
  return margin + std::min(displacement_by_forces, allowed_penetration);
}

/// True if a body is a box some point of which went by more than half of its smallest size. What
/// goes by less cannot get behind a surface.
inline bool is_fast_box(const StepTrajectories& step, int i)
{
  return !is_sphere(step.scene, i) && step.displacements[index_of(i)] > inner_radius(step.scene, i);
}

/// True if a box is swept: a fast one, one that has ended too deep in something, or one that such a
/// box has taken along, or balls have hit again and again.
inline bool is_swept_box(const StepTrajectories& step, int i)
{
  return is_fast_box(step, i) || (!is_sphere(step.scene, i) && step.needs_sweep[index_of(i)]);
}

/// How far [m] a spin [rad/s] carries any point of a body round its centre in a time [s].
inline double
rotation_displacement(const Scene& scene, int i, const Vector3<double>& spin, double time)
{
  return time * spin.norm() * bounding_radius(scene, i);
}

/// How far [m] any point of a body goes in a time [s] in which its centre goes by a way [m].
inline double max_displacement(
    const StepTrajectories& step, int i, const Trajectory& trajectory, double displacement,
    double time)
{
  return displacement + rotation_displacement(step.scene, i, trajectory.spin, time);
}

/// Writes down the courses of all bodies, from where a step began to where it ended.
inline void set_trajectories(StepTrajectories& step, std::span<const RigidBody> ends)
{
  const double duration = step.scene.step;
  step.trajectories.clear();
  step.trajectories.reserve(ends.size());
  step.displacements.clear();
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const PreviousState start = start_state(step, static_cast<int>(i));
    const ExternalAcceleration pull = acceleration_on(step.scene.gravity, step.forces, i);
    const Trajectory trajectory = step.falls[i] ? falling_trajectory(start, ends[i], duration, pull)
                                                : pushed_trajectory(start, ends[i], duration, pull);
    const double displacement = (ends[i].motion.center - start.motion.center).norm();
    step.displacements.push_back(
        max_displacement(step, static_cast<int>(i), trajectory, displacement, duration));
    step.trajectories.push_back(trajectory);
  }
}
// [step_trajectories]

} // namespace cookbook
