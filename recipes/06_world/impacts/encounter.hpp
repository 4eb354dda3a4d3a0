#pragma once

/// \file
/// \brief Two bodies that touch on their ways, and how they go on from there.

#include "06_world/impacts/going_on.hpp"
#include "06_world/impacts/impact.hpp"
#include "06_world/impacts/impact_group.hpp"
#include "06_world/lanes/make_room.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace cookbook
{

// [encounter]
/// Two bodies where they touch, the first of which goes on by itself.
struct Encounter
{
  CourseTouch touch;
  RigidBody a, b;                   ///< the first, and the other
  Met met{};                        ///< where they touch
  bool ball = false;                ///< whether the first is one
  bool tired = false;               ///< whether it has touched too often to bounce
  bool frozen = false;              ///< whether it has so often that it stays where it is
  bool rests = false;               ///< whether they were too slow to bounce
  double approach = 0;              ///< [m/s], at which they met; 0: nothing was pushed
  std::vector<StruckBody> driven{}; ///< whom they have driven along

  /// The two numbers, the smaller one first.
  std::pair<int, int> pair() const { return std::minmax(touch.first, touch.other); }
};

/// Adds who has hit whom, unless that is but rounding.
inline void hear(const Scene& scene, const Encounter& of, std::vector<Impact>& impacts)
{
  const auto [a, b] = of.pair();
  if (is_heard(of.approach, scene.step, thinness(scene, of.touch.first)))
  {
    const Vector3<double> place = place_of_touch(of.met, of.a);
    const Vector3<double> normal = a == of.touch.first ? of.touch.normal : -of.touch.normal;
    add_in_room(impacts, Impact{a, b, place, normal, of.approach});
  }
}

/// How the first goes on. What has come to rest leans on what does not give way; a box that touches
/// and is not pushed is held; who touches on and on is frozen.
inline Onward onward(const StepCourses& step, const Encounter& of)
{
  const bool held = !of.ball && (of.tired || of.approach == 0);
  const bool leans = of.rests && (of.ball || !of.tired) && !goes_on(step, of.touch.other);
  return of.frozen ? Onward::frozen : held ? Onward::held : leans ? Onward::leans : Onward::free;
}

/// Whether two that go on like this need not be looked at again: the first is frozen; or it is a
/// ball that rests on another, or is not pushed any more; or two balls give nothing back, and go on
/// together. What they sink by, the next step finds.
inline bool are_done(const StepCourses& step, const Encounter& of, Onward how)
{
  const int first = of.touch.first, other = of.touch.other;
  const bool on_ball = is_ball(step.scene, other);
  const bool rests = of.rests && (of.tired || of.approach == 0 || on_ball);
  const bool together =
      on_ball && goes_on(step, other) && restitution_of(step.scene, first, other) == 0;
  return how == Onward::frozen || (of.ball && how == Onward::free && (rests || together));
}
// [encounter]

} // namespace cookbook
