#pragma once

/// \file
/// \brief The bounce of two bodies that touch on their way: the whole impulse, at all points at
/// once.

#include "05_resolution/impulse/impulse.hpp"
#include "06_world/contacts/contact_cache.hpp"
#include "06_world/impacts/next_toi.hpp"
#include "06_world/islands/simultaneous_impacts.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace cookbook
{

// [toi_manifold]
/// Where two bodies touch on their way; nothing where they, by rounding, do not quite.
using ToiManifold = std::optional<Manifold<double>>;

/// At a touch, what is within this fraction of the first body's inner radius of it touches too: all
/// corners of a box that lands flat, which a spin of 1e-3 rad/s tilts by no more in a second.
inline constexpr double together_fraction = 1e-3;

/// The manifold of two bodies of a scene where they touch: that of a sphere has one point. Other
/// bodies do not touch what is farther away than so much [m].
inline ToiManifold toi_manifold(
    const Scene& scene, const ToiEvent& event, const RigidBody& a, const RigidBody& b,
    double farthest = std::numeric_limits<double>::infinity())
{
  const auto& shape = scene.bodies[index_of(event.first)].shape;
  if (const SphereShape* const sphere = std::get_if<SphereShape>(&shape))
  {
    const Vector3<double> point = a.motion.center + sphere->radius * event.normal;
    return Manifold<double>{event.normal, 0, ContactPoints<double, 8>({point, 0, 0})};
  }
  const double together = together_fraction * inner_radius(scene, event.first);
  const auto manifold = [&](const auto& of_a, const auto& of_b) -> ToiManifold
  {
    const auto here = placed(a, of_a);
    const auto there = placed(b, of_b);
    const double separation = std::max(0.0, gap_of(here, there).length);
    return separation > farthest ? std::nullopt
                                 : steady_manifold(-1, here, there, 2 * separation + together);
  };
  return std::visit(manifold, shape, scene.bodies[index_of(event.other)].shape);
}

/// A place [m], world, where a body touches: its centre where there are no points.
inline Vector3<double> toi_point(const ToiManifold& manifold, const RigidBody& body)
{
  return manifold ? manifold->points[0].position : body.motion.center;
}

/// How deep [m] two bodies that touch, neither of them a sphere, may be in each other and still be
/// about to pass; zero if they are not. Both are as they are at the touch.
///
/// Boxes pass across the normal. At an edge that of other shapes may lean anyhow: they pass along
/// an axis along which they come less than half as fast as along the normal.
inline double ghost_depth(
    const StepTrajectories& step, const ToiEvent& event, const ToiManifold& manifold,
    const RigidBody& a, const RigidBody& b)
{
  const Scene& scene = step.scene;
  if (!manifold || a.is_sphere || b.is_sphere)
  {
    return 0;
  }
  const double by_forces = displacement_by_forces(scene, step.forces, event.first, event.other);
  const double thin = std::min(inner_radius(scene, event.first), inner_radius(scene, event.other));
  const double margin = ghost_margin(contact_margin(scene), by_forces, allowed_penetration(thin));
  const Vector3<double> point = toi_point(manifold, a);
  const Vector3<double> velocity = velocity_at_arm<double>(b.motion, point - b.motion.center) -
                                   velocity_at_arm<double>(a.motion, point - a.motion.center);
  const double closing = std::abs(velocity.dot(manifold->normal));
  const auto is_passing = [&](const auto& of_a, const auto& of_b)
  {
    constexpr bool boxes = std::is_same_v<decltype(of_a), const BoxShape&> &&
                           std::is_same_v<decltype(of_b), const BoxShape&>;
    return are_passing(
        placed(a, of_a), a.axes, placed(b, of_b), b.axes, b.motion.center - a.motion.center,
        boxes || !(closing > 0) ? manifold->normal : Vector3<double>(velocity / closing), 0,
        margin);
  };
  const bool passes = std::visit(
      is_passing, scene.bodies[index_of(event.first)].shape,
      scene.bodies[index_of(event.other)].shape);
  return passes ? near_fraction * std::min(margin, thin) : 0;
}
// [toi_manifold]

// [toi_impulse]
/// The speed [m/s] above which two bodies bounce: gravity and forces give them less in a step.
inline double threshold_of(const StepTrajectories& step, const ToiEvent& event)
{
  const Trajectory &one = step.trajectories[index_of(event.first)],
                   &two = step.trajectories[index_of(event.other)];
  const double pressing = (one.external.acceleration - two.external.acceleration).dot(event.normal);
  return rest_threshold(step.scene.gravity, -pressing, step.scene.step);
}

/// Whether two bodies that touch at a speed [m/s] would get deeper into each other than does no
/// harm, in what is left of a step.
inline bool penetrates(const StepTrajectories& step, const ToiEvent& event, double approach_speed)
{
  const double deeper = approach_speed * (step.scene.step - event.time);
  return approach_speed > threshold_of(step, event) &&
         deeper > allowed_penetration(step.scene, {event.first, event.other});
}

/// The contact of two bodies of a scene where they touch.
inline WorldContact toi_contact(
    const Scene& scene, const ToiEvent& event, const Manifold<double>& manifold, const RigidBody& a,
    const RigidBody& b)
{
  WorldContact contact = new_contact(scene, event.first, event.other);
  update_points(contact, manifold, a, b);
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
    const double approach_speed = std::max(0.0, -separating_velocity(point));
    points.push_back(
        {point, approach_speed > threshold ? contact.restitution * approach_speed : 0});
    fastest = std::max(fastest, approach_speed);
  }
  return fastest;
}

/// Lets two bodies of a scene bounce where they touch, with friction, and says at what speed [m/s]
/// they met; R2, R6. An approach up to a threshold [m/s] only ends; 0, and nothing changes, if they
/// part, or do not quite touch.
inline double resolve_impacts(
    const Scene& scene, const ToiEvent& event, const ToiManifold& manifold, RigidBody& a,
    RigidBody& b, double threshold)
{
  if (!manifold)
  {
    return 0;
  }
  WorldContact contact = toi_contact(scene, event, *manifold, a, b);
  std::vector<ImpactPoint> points;
  points.reserve(contact.points.size());
  const double fastest = add_impact_points(a, b, contact, threshold, points);
  if (fastest > 0)
  {
    RigidBody* const bodies[] = {&a, &b};
    resolve_impacts(points, bodies);
  }
  return fastest;
}

/// Stops the centre of a body from going on into another along a normal, at a place [m] of that,
/// and says at what speed [m/s] it did: for a box that spins too fast to know which of its corners
/// comes next.
inline double stop_center(
    Body<double>& a, Body<double>& b, const Vector3<double>& normal, const Vector3<double>& point)
{
  const Arms<double> arms{Vector3<double>::Zero(), point - b.motion.center};
  const double approach_speed = std::max(0.0, -separating_velocity(a, b, normal, arms));
  apply_impulse<double>(a, b, arms, bounce_impulse(a, b, normal, arms, 0.0) * normal);
  return approach_speed;
}
// [toi_impulse]

} // namespace cookbook
