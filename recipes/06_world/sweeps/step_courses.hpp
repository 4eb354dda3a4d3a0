#pragma once

/// \file
/// \brief How all bodies of a world went through a step.

#include "06_world/contacts/bounds_tree.hpp"
#include "06_world/contacts/world_contact.hpp"
#include "06_world/sweeps/body_sizes.hpp"
#include "06_world/sweeps/course.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [step_courses]
/// A step of a world as solvers and free fall had it.
struct StepCourses
{
  const Scene& scene;                               ///< the bodies as it began
  std::span<const Pull> forces;                     ///< on them, force_on()
  std::span<const WorldContact> contacts;           ///< of this step
  const std::vector<bool>& falls;                   ///< whether no other body pushed it
  const std::vector<bool>& gone;                    ///< whether it is no more
  std::span<const std::pair<int, int>> close_pairs; ///< who were near as it began
  std::vector<Course>& courses;                     ///< of all bodies
  std::vector<double>& ways;                        ///< [m], how far any point of a body went
  std::vector<bool>& too_deep; ///< whom a solver left too deep, or who is swept by now
  BoundsTree* tree = nullptr;  ///< of all bodies that are there, once any is swept
};

/// A body as the step began.
inline PastBody start_of(const StepCourses& step, int i)
{
  return start_of(step.scene.bodies[place_of(i)]);
}

/// True if a body is a ball.
inline bool is_ball(const Scene& scene, int i)
{
  return std::holds_alternative<SphereShape>(scene.bodies[place_of(i)].shape);
}

/// How far [m] a body reaches from its centre.
inline double reach(const Scene& scene, int i)
{
  return std::visit(
      [](const auto& shape) { return reach_of(shape); }, scene.bodies[place_of(i)].shape);
}

/// How far [m] the nearest point of a body's surface is from its centre.
inline double thinness(const Scene& scene, int i)
{
  return std::visit(
      [](const auto& shape) { return thinness_of(shape); }, scene.bodies[place_of(i)].shape);
}

/// How deep [m] two bodies may get into each other and nobody minds.
inline double harmless_depth(const Scene& scene, const std::pair<int, int>& pair)
{
  return harmless_depth(std::min(thinness(scene, pair.first), thinness(scene, pair.second)));
}

/// How far [m] forces lead two bodies by their places in two steps, one after the other or both
/// towards each other.
inline double way_by_forces(const Scene& scene, std::span<const Pull> forces, int i, int j)
{
  const Vector3<double> of_a = force_on(forces, place_of(i)).acceleration;
  const Vector3<double> of_b = force_on(forces, place_of(j)).acceleration;
  const double most = std::max({of_a.norm(), of_b.norm(), (of_b - of_a).norm()});
  return 2 * scene.step * scene.step * most;
}

/// By how much [m] two bodies may overlap that only pass each other, is_ghost(): by the margin of
/// contacts, and by the way by forces, up to what does no harm; each [m].
inline double ghost_margin(double margin, double way_by_forces, double harmless)
{
  return margin + std::min(way_by_forces, harmless);
}

/// True if a body is a box some point of which went by more than half of its smallest size. What
/// goes by less cannot get behind a surface.
inline bool is_fast_box(const StepCourses& step, int i)
{
  return !is_ball(step.scene, i) && step.ways[place_of(i)] > thinness(step.scene, i);
}

/// True if a box is swept: a fast one, one that has ended too deep in something, or one that such a
/// box has taken along, or balls have hit again and again.
inline bool is_swept_box(const StepCourses& step, int i)
{
  return is_fast_box(step, i) || (!is_ball(step.scene, i) && step.too_deep[place_of(i)]);
}

/// How far [m] a spin [rad/s] carries any point of a body round its centre in a time [s].
inline double turning_way(const Scene& scene, int i, const Vector3<double>& spin, double time)
{
  return time * spin.norm() * reach(scene, i);
}

/// How far [m] any point of a body goes in a time [s] in which its centre goes by a way [m].
inline double
farthest_way(const StepCourses& step, int i, const Course& course, double way, double time)
{
  return way + turning_way(step.scene, i, course.spin, time);
}

/// Writes down the courses of all bodies, from where a step began to where it ended.
inline void set_out(StepCourses& step, std::span<const RigidBody> ends)
{
  const double duration = step.scene.step;
  step.courses.clear();
  step.courses.reserve(ends.size());
  step.ways.clear();
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const PastBody start = start_of(step, static_cast<int>(i));
    const Pull pull = pull_on(step.scene.gravity, step.forces, i);
    const Course course = step.falls[i] ? falling_course(start, ends[i], duration, pull)
                                        : pushed_course(start, ends[i], duration, pull);
    const double way = (ends[i].motion.center - start.motion.center).norm();
    step.ways.push_back(farthest_way(step, static_cast<int>(i), course, way, duration));
    step.courses.push_back(course);
  }
}
// [step_courses]

} // namespace cookbook
