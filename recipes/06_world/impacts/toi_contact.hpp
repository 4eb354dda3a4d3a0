#pragma once

/// \file
/// \brief Two bodies that touch on their ways, and how they go on from there.

#include "06_world/impacts/impact.hpp"
#include "06_world/impacts/toi_island.hpp"
#include "06_world/impacts/toi_substeps.hpp"
#include "06_world/lanes/reserve_space.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace cookbook
{

// [toi_contact]
/// Two bodies where they touch, the first of which goes on by itself.
struct ToiContact
{
  ToiEvent event;
  RigidBody a, b;                ///< the first, and the other
  ToiManifold manifold{};        ///< where they touch
  bool sphere = false;           ///< whether the first is one
  bool over_limit = false;       ///< whether it has touched too often to bounce
  bool clamped = false;          ///< whether it has so often that it stays where it is
  bool resting = false;          ///< whether they were too slow to bounce
  double approach_speed = 0;     ///< [m/s], at which they met; 0: nothing was pushed
  std::vector<ToiBody> pushed{}; ///< bodies that they have pushed along

  /// The two numbers, the smaller one first.
  std::pair<int, int> pair() const { return std::minmax(event.first, event.other); }
};

/// Adds a hit event, unless its speed is but rounding.
inline void add_hit(const Scene& scene, const ToiContact& of, std::vector<Impact>& impacts)
{
  const auto [a, b] = of.pair();
  if (is_hit(of.approach_speed, scene.step, inner_radius(scene, of.event.first)))
  {
    const Vector3<double> point = toi_point(of.manifold, of.a);
    const Vector3<double> normal = a == of.event.first ? of.event.normal : -of.event.normal;
    append(impacts, Impact{a, b, point, normal, of.approach_speed});
  }
}

/// How the first goes on. What has come to rest leans on what does not give way; a box that touches
/// and is not pushed does not rotate; a body beyond the sub-step limit is clamped.
inline ToiResponse response_of(const StepTrajectories& step, const ToiContact& of)
{
  const bool no_rotation = !of.sphere && (of.over_limit || of.approach_speed == 0);
  const bool supported =
      of.resting && (of.sphere || !of.over_limit) && !goes_on(step, of.event.other);
  return of.clamped    ? ToiResponse::clamped
         : no_rotation ? ToiResponse::no_rotation
         : supported   ? ToiResponse::supported
                       : ToiResponse::free;
}

/// Whether two that go on like this need not be looked at again: the first is clamped; or it is a
/// ball that rests on another, or is not pushed any more; or two balls give nothing back, and go on
/// together. What they sink by, the next step finds.
inline bool is_finished(const StepTrajectories& step, const ToiContact& of, ToiResponse response)
{
  const int first = of.event.first, other = of.event.other;
  const bool on_ball = is_sphere(step.scene, other);
  const bool resting = of.resting && (of.over_limit || of.approach_speed == 0 || on_ball);
  const bool together =
      on_ball && goes_on(step, other) && restitution_of(step.scene, first, other) == 0;
  return response == ToiResponse::clamped ||
         (of.sphere && response == ToiResponse::free && (resting || together));
}
// [toi_contact]

} // namespace cookbook
