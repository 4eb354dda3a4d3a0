#pragma once

/// \file
/// \brief Slopes, a sliding block, a rolling ball, a box under balls: a step by a rule of friction.

#include "05_resolution/friction/friction.hpp"
#include "05_resolution/friction/trial/friction_pitfalls.hpp"
#include "05_resolution/friction/trial/one_contact_scenes.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

// [friction_rules]
/// What a rule knows when it visits a touch; vectors are along the axes of the floor.
struct FrictionVisit
{
  Vector2<double> sliding;     ///< [m/s]
  SlidingMass<double> mass;    ///< [kg]
  Vector2<double> accumulated; ///< [N s]
  double max_friction;         ///< [N s], the bound from the normal impulse
  double planned;              ///< [N s], the bound that was planned from the weight

  /// What goes against the sliding [N s], not cut yet.
  Vector2<double> against() const { return accumulated - mass.smallest * sliding; }
};

/// The impulse of friction [N s] after a visit.
using FrictionCut = std::function<Vector2<double>(const FrictionVisit&)>;

/// A rule of friction.
struct FrictionRule
{
  std::string name; ///< as on the page
  FrictionCut cut;  ///< none: the whole step is as published
};

/// The rules that compete; the last is the one to take.
inline std::vector<FrictionRule> friction_rules()
{
  return {
      {"dead zone, as published", nullptr},
      {"box: constant bound",
       [](const FrictionVisit& at) { return within_pyramid(at.against(), at.planned); }},
      {"pyramid: two axes",
       [](const FrictionVisit& at) { return within_pyramid(at.against(), at.max_friction); }},
      {"cone", [](const FrictionVisit& at)
       { return friction_impulse(at.sliding, at.mass, at.accumulated, at.max_friction); }}};
}
// [friction_rules]

// [visit]
/// How far [m] over a surface a corner may be to be asked at all: farther than a step takes it.
inline constexpr double far_off = 0.1;

/// One visit to a touch: a push so that the step does not close more than its gap, then friction.
inline void visit(OneContactScene& scene, Touch& touch, const FrictionCut& cut)
{
  if (touch.gap > far_off)
  {
    return;
  }
  const Vector3<double> up = Vector3<double>::UnitY();
  Body<double>&a = scene.solids[touch.a].body, &b = scene.solids[touch.b].body;
  const Arms<double> arms = arms_to<double>({a, b}, touch.point);
  const double residual = -touch.gap / scene.step - separating_velocity(a, b, up, arms);
  const double sum = accumulated_impulse(touch.pushed, touch.mass * residual);
  if (sum == 0 && touch.pushed == 0)
  {
    return;
  }
  apply_impulse<double>(a, b, arms, (sum - touch.pushed) * up);
  touch.pushed = sum;
  const double planned = sum > 0 ? touch.friction * touch.weight * scene.step : 0;
  const SurfaceAxes<double> floor = surface_axes(up);
  const Vector2<double> rub = cut(
      {sliding_velocity(a, b, floor, arms), touch.sliding, touch.rubbed, touch.friction * sum,
       planned});
  apply_impulse<double>(a, b, arms, floor.in_world(rub - touch.rubbed));
  touch.rubbed = rub;
}

/// Prepares a touch for a step, and gives once more what it gave in the step before.
inline void prepare(OneContactScene& scene, Touch& touch)
{
  const Vector3<double> up = Vector3<double>::UnitY();
  locate(scene, touch);
  if (touch.gap > far_off)
  {
    touch.pushed = 0;
    touch.rubbed.setZero();
    return;
  }
  Body<double>&a = scene.solids[touch.a].body, &b = scene.solids[touch.b].body;
  const Arms<double> arms = arms_to<double>({a, b}, touch.point);
  touch.mass = effective_mass(inverse_mass_at(a, b, up, arms));
  const SurfaceAxes<double> floor = surface_axes(up);
  touch.sliding = sliding_mass(a, b, floor, arms);
  apply_impulse<double>(a, b, arms, touch.pushed * up + floor.in_world(touch.rubbed));
}
// [visit]

/// How many touches of the same two solids meet.
inline int meeting(const OneContactScene& scene, const Touch& touch)
{
  int count = 0;
  for (const Touch& other : scene.touches)
  {
    count += other.a == touch.a && other.b == touch.b && other.gap <= 0 ? 1 : 0;
  }
  return count;
}

/// One step as published: five passes over the touches that meet, then gravity and motion, then
/// 45 % of the depth beyond a centimetre is taken away.
inline void advance_as_published(OneContactScene& scene)
{
  for (Touch& touch : scene.touches)
  {
    locate(scene, touch);
  }
  for (int pass = 0; pass < 5; ++pass)
  {
    for (const Touch& touch : scene.touches)
    {
      const BodyPair<double> before{scene.solids[touch.a].body, scene.solids[touch.b].body};
      const BodyPair<double> after = touch.gap > 0
                                         ? before
                                         : answered_as_published<double>(
                                               before, Vector3<double>::UnitY(), touch.point,
                                               meeting(scene, touch), 0, touch.friction);
      scene.solids[touch.a].body = after.a;
      scene.solids[touch.b].body = after.b;
    }
  }
  pull(scene);
  move(scene);
  for (const Touch& touch : scene.touches)
  {
    const double share = 1.0 / std::max(1, meeting(scene, touch));
    scene.solids[touch.b].body.motion.center.y() += share * 0.45 * std::max(0.0, -touch.gap - 0.01);
  }
}

/// One step: gravity, the impulses of the step before once more, passes over all touches, motion.
inline void advance(OneContactScene& scene, const FrictionRule& rule)
{
  if (!rule.cut)
  {
    advance_as_published(scene);
    return;
  }
  pull(scene);
  for (Touch& touch : scene.touches)
  {
    prepare(scene, touch);
  }
  for (int pass = 0; pass < scene.passes; ++pass)
  {
    for (Touch& touch : scene.touches)
    {
      visit(scene, touch, rule.cut);
    }
  }
  move(scene);
}

/// A scene after some time [s].
inline OneContactScene advanced(OneContactScene scene, const FrictionRule& rule, double time)
{
  for (int i = 0; i < int(std::lround(time / scene.step)); ++i)
  {
    advance(scene, rule);
  }
  return scene;
}

/// The motion of the first solid that moves.
inline const Motion<double>& mover(const OneContactScene& scene)
{
  return scene.solids[1].body.motion;
}

} // namespace cookbook
