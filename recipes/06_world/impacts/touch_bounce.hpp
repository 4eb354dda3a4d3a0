#pragma once

/// \file
/// \brief The bounce of two bodies that touch on their way: the whole impulse, at all points at
/// once.

#include "05_resolution/impulse/impulse.hpp"
#include "06_world/contacts/contact_cache.hpp"
#include "06_world/impacts/next_touch.hpp"
#include "06_world/islands/simultaneous_impacts.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

namespace cookbook
{

// [touch_contact]
/// Where two bodies touch on their way; nothing where boxes, by rounding, do not quite.
using Met = std::optional<Manifold<double>>;

/// The manifold of a box and another shape that touch: of all that is nearly as near as what
/// touches first, so that a box that lands flat does so on all corners. None where there is no box,
/// or where they are farther apart than that [m].
struct MeetOnCourse
{
  const RigidBody& a;
  const RigidBody& b;
  double farthest;

  template <class Shape>
  Met operator()(const BoxShape& box, const Shape& other) const
  {
    const Obb<double> here = placed(a, box);
    const auto there = placed(b, other);
    const double apart = std::max(0.0, way_between(here, there).length);
    return apart > farthest ? std::nullopt
                            : meet(-1, here, there, 2 * apart + 1e-3 * thinness_of(box));
  }
  template <class Shape, class Other>
  Met operator()(const Shape&, const Other&) const
  {
    return std::nullopt;
  }
};

/// The manifold of two bodies of a scene where they touch: that of a ball has one point. A box
/// does not touch what is farther away than that [m].
inline Met touch_manifold(
    const Scene& scene, const CourseTouch& touch, const RigidBody& a, const RigidBody& b,
    double farthest = std::numeric_limits<double>::infinity())
{
  const auto& shape = scene.bodies[place_of(touch.first)].shape;
  if (const SphereShape* const ball = std::get_if<SphereShape>(&shape))
  {
    const Vector3<double> place = a.motion.center + ball->radius * touch.normal;
    return Manifold<double>{touch.normal, 0, ContactPoints<double, 8>({place, 0, 0})};
  }
  return std::visit(MeetOnCourse{a, b, farthest}, shape, scene.bodies[place_of(touch.other)].shape);
}

/// A place [m], world, where a body touches: its centre where there are no points.
inline Vector3<double> place_of_touch(const Met& met, const RigidBody& body)
{
  return met ? met->points[0].position : body.motion.center;
}

/// How deep [m] two boxes that touch may be in each other and still be about to pass; zero if they
/// are not. Both are as they are at the touch.
inline double ghost_depth(
    const StepCourses& step, const CourseTouch& touch, const Met& met, const RigidBody& a,
    const RigidBody& b)
{
  const Scene& scene = step.scene;
  const auto* const box_a = std::get_if<BoxShape>(&scene.bodies[place_of(touch.first)].shape);
  const auto* const box_b = std::get_if<BoxShape>(&scene.bodies[place_of(touch.other)].shape);
  if (!box_a || !box_b || !met)
  {
    return 0;
  }
  const double by_forces = way_by_forces(scene, step.forces, touch.first, touch.other);
  const double thin = std::min(thinness_of(*box_a), thinness_of(*box_b));
  const double margin = ghost_margin(contact_margin(scene), by_forces, harmless_depth(thin));
  const bool passes = is_ghost(placed(a, *box_a), placed(b, *box_b), met->normal, 0, margin);
  return passes ? 0.1 * std::min(margin, thin) : 0;
}
// [touch_contact]

// [bounce_at]
/// The speed [m/s] above which two bodies bounce: gravity and forces give them less in a step.
inline double threshold_of(const StepCourses& step, const CourseTouch& touch)
{
  const Course &one = step.courses[place_of(touch.first)],
               &two = step.courses[place_of(touch.other)];
  const double pressing = (one.pull.acceleration - two.pull.acceleration).dot(touch.normal);
  return rest_threshold(step.scene.gravity, -pressing, step.scene.step);
}

/// Whether two bodies that touch at a speed [m/s] would get deeper into each other than does no
/// harm, in what is left of a step.
inline bool does_harm(const StepCourses& step, const CourseTouch& touch, double approach)
{
  const double deeper = approach * (step.scene.step - touch.time);
  return approach > threshold_of(step, touch) &&
         deeper > harmless_depth(step.scene, {touch.first, touch.other});
}

/// The contact of two bodies of a scene where they touch.
inline WorldContact touch_contact(
    const Scene& scene, const CourseTouch& touch, const Manifold<double>& met, const RigidBody& a,
    const RigidBody& b)
{
  WorldContact contact = new_contact(scene, touch.first, touch.other);
  renew(contact, met, a, b);
  return contact;
}

/// Adds the points of a contact of two bodies, and says how fast [m/s] they close; up to a
/// threshold [m/s] that only ends.
inline double add_impact_points(
    RigidBody& a, RigidBody& b, WorldContact& contact, double threshold,
    std::vector<ImpactPoint>& points)
{
  double fastest = 0;
  const ContactFrame frame = frame_of(a, b, contact);
  for (WorldPoint& sum : contact.points)
  {
    const IslandPoint point = island_point(a, b, contact, frame, sum);
    const double approach = std::max(0.0, -separating_velocity(point));
    points.push_back({point, approach > threshold ? contact.restitution * approach : 0});
    fastest = std::max(fastest, approach);
  }
  return fastest;
}

/// Lets two bodies of a scene bounce where they touch, with friction, and says at what speed [m/s]
/// they met; R2, R6. An approach up to a threshold [m/s] only ends; 0, and nothing changes, if they
/// part, or do not quite touch.
inline double bounce(
    const Scene& scene, const CourseTouch& touch, const Met& met, RigidBody& a, RigidBody& b,
    double threshold)
{
  if (!met)
  {
    return 0;
  }
  WorldContact contact = touch_contact(scene, touch, *met, a, b);
  std::vector<ImpactPoint> points;
  points.reserve(contact.points.size());
  const double fastest = add_impact_points(a, b, contact, threshold, points);
  if (fastest > 0)
  {
    RigidBody* const bodies[] = {&a, &b};
    bounce(points, bodies);
  }
  return fastest;
}

/// Stops the centre of a body from going on into another along a normal, at a place [m] of that,
/// and says at what speed [m/s] it did: for a box that spins too fast to know which of its corners
/// comes next.
inline double stop_center(
    Body<double>& a, Body<double>& b, const Vector3<double>& normal, const Vector3<double>& place)
{
  const Arms<double> arms{Vector3<double>::Zero(), place - b.motion.center};
  const double approach = std::max(0.0, -separating_velocity(a, b, normal, arms));
  apply_impulse<double>(a, b, arms, bounce_impulse(a, b, normal, arms, 0.0) * normal);
  return approach;
}
// [bounce_at]

} // namespace cookbook
