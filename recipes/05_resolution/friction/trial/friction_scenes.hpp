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
/// What is left of an impulse [N s] that would end the sliding: by the bound from the normal
/// impulse [N s], and by the bound that was planned from the weight [N s].
using FrictionCut = std::function<Vector3<double>(const Vector3<double>&, double, double)>;

/// A rule of friction.
struct FrictionRule
{
  std::string name; ///< as on the page
  FrictionCut cut;  ///< none: the whole step is as published
};

/// The rules that compete; the last is the one to take.
inline std::vector<FrictionRule> friction_rules()
{
  using V = Vector3<double>;
  return {
      {"dead zone, as published", nullptr},
      {"box: constant bound",
       [](const V& wanted, double, double planned) { return within_pyramid(wanted, planned); }},
      {"pyramid: two axes",
       [](const V& wanted, double most, double) { return within_pyramid(wanted, most); }},
      {"cone", [](const V& wanted, double most, double) { return within_cone(wanted, most); }}};
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
  BodyPair<double> bodies{scene.solids[touch.a].body, scene.solids[touch.b].body};
  const double missing = -touch.gap / scene.step - parting_speed(bodies, up, touch.point);
  const double sum = std::max(0.0, touch.pushed + missing / touch.inverse_mass);
  if (sum == 0 && touch.pushed == 0)
  {
    return;
  }
  bodies = pushed_apart(bodies, up, touch.point, sum - touch.pushed);
  touch.pushed = sum;
  const double planned = sum > 0 ? touch.friction * touch.weight * scene.step : 0;
  const Vector3<double> wanted =
      gripping_impulse(bodies, up, touch.point, touch.rubbed, touch.sliding_inverse_mass);
  const Vector3<double> rub = cut(wanted, touch.friction * sum, planned);
  bodies = rubbed<double>(bodies, touch.point, rub - touch.rubbed);
  touch.rubbed = rub;
  scene.solids[touch.a].body = bodies.a;
  scene.solids[touch.b].body = bodies.b;
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
  BodyPair<double> bodies{scene.solids[touch.a].body, scene.solids[touch.b].body};
  touch.inverse_mass = inverse_mass_at(bodies, up, touch.point);
  touch.sliding_inverse_mass = sliding_inverse_mass(bodies, up, touch.point);
  bodies = pushed_apart(bodies, up, touch.point, touch.pushed);
  bodies = rubbed(bodies, touch.point, touch.rubbed);
  scene.solids[touch.a].body = bodies.a;
  scene.solids[touch.b].body = bodies.b;
}
// [visit]

// [advance]
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

/// One step as published: five passes over the touches that meet, then gravity and motion, then 45
/// % of the depth beyond a centimetre is taken away.
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
// [advance]

} // namespace cookbook
