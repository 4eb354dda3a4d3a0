#pragma once

/// \file
/// \brief What AVBD solves between two bodies: the rows of a joint, or of a contact point.

#include "06_world/islands/island_constraints.hpp"
#include "06_world/islands/island_points.hpp"
#include "07_constraints/avbd/avbd_memory.hpp"
#include "07_constraints/avbd/avbd_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace cookbook
{

// [avbd_item]
/// A joint, or a contact point: one row along its normal and two across.
struct AvbdItem
{
  RigidBody *a, *b;
  ConstraintSet* set;                ///< of a joint; none of a point
  int number;                        ///< of the joint in its set
  IslandPoint* point;                ///< none of a joint
  RigidBody start_a = *a;            ///< before the step
  RigidBody start_b = *b;            ///< before the step
  std::vector<AvbdRow> rows{};       ///< as the bodies are
  std::vector<double> start_error{}; ///< [m, rad], before the step
};

/// How far [m, rad] the bodies of an item have moved along a row in this step.
inline double moved_along(const AvbdItem& item, const Vector6& a, const Vector6& b)
{
  const auto moved = [](const RigidBody& from, const RigidBody& to)
  {
    const Vector3<double> turned = turn_between<double>(from.orientation, to.orientation);
    return (Vector6() << to.motion.center - from.motion.center, turned).finished();
  };
  return a.dot(moved(item.start_a, *item.a)) + b.dot(moved(item.start_b, *item.b));
}

/// Evaluates a row of a joint where the bodies are, in a step [s]. A spring has a stiffness of its
/// own, with which it ends the step at the speed that it asks for; the error of a motor is how far
/// the bodies are from where its speed would have brought them.
inline void evaluate(
    AvbdRow& row, const ConstraintRow& of, const AvbdItem& item, double start, double step,
    const AvbdSettings& settings)
{
  row.a = of.a;
  row.b = of.b;
  row.lower = of.lower;
  row.upper = of.upper;
  if (is_spring(of))
  {
    const double give = inverse_mass_of(*item.a, of.a) + inverse_mass_of(*item.b, of.b);
    const double keeps = std::max(of.keeps, 1e-9); // of a spring that does not give: rigid
    row.is_spring = true;
    row.memory.stiffness = give > 0 ? (1 / keeps - 1) / (give * step * step) : 0;
    row.memory.push = give > 0 ? -of.pulls / (keeps * give * step) * start : 0;
    row.error = moved_along(item, of.a, of.b);
  }
  else if (of.motor)
  {
    row.error = moved_along(item, of.a, of.b) - step * of.speed;
  }
  else
  {
    ConstraintRow before = of;
    before.error = start;
    row.error = of.error - (is_open(before) ? 0 : settings.stabilization * start);
  }
}

/// The same of all rows of a joint.
inline void evaluate_joint(AvbdItem& item, double step, const AvbdSettings& settings)
{
  const bool first = item.rows.empty();
  std::size_t i = 0;
  item.set->rows(
      *item.a, *item.b, item.number, step,
      [&](const ConstraintRow& of)
      {
        if (first)
        {
          item.rows.emplace_back().memory.stiffness = settings.least;
          item.start_error.push_back(of.error);
        }
        evaluate(item.rows[i], of, item, item.start_error[i], step, settings);
        ++i;
      });
}

/// By how much the rows of a joint bend as one of its bodies turns about an axis of the world: by
/// its turning, were it to spin at 1 rad/s.
inline void evaluate_bending(AvbdItem& item, double step)
{
  for (int axis = 0; axis < 6; ++axis)
  {
    RigidBody a = *item.a, b = *item.b;
    a.motion.angular_velocity = b.motion.angular_velocity = Vector3<double>(0, 0, 0);
    (axis < 3 ? a : b).motion.angular_velocity[axis % 3] = 1;
    std::size_t i = 0;
    item.set->rows(
        a, b, item.number, step,
        [&](const ConstraintRow& of)
        {
          AvbdRow& row = item.rows[i++];
          (axis < 3 ? row.curve_a : row.curve_b)[3 + axis % 3] = std::abs(of.turning);
        });
  }
}

/// Evaluates the three rows of a contact point where the bodies are: it pushes only where they
/// touch, and across the normal by no more than friction allows.
inline void evaluate_point(AvbdItem& item, const AvbdSettings& settings)
{
  const IslandPoint& point = *item.point;
  if (item.rows.empty())
  {
    item.rows.resize(3);
    item.start_error.push_back(std::min(separation_of(point), 0.0));
  }
  const Arms<double> arms = current_arms(point);
  const Vector3<double> along[] = {
      point.normal, point.surface.in_world({1, 0}), point.surface.in_world({0, 1})};
  for (std::size_t i = 0; i < 3; ++i)
  {
    AvbdRow& row = item.rows[i];
    row.a << -along[i], -arms.a.cross(along[i]);
    row.b << along[i], arms.b.cross(along[i]);
  }
  item.rows[0].error = separation_of(point) - settings.stabilization * item.start_error[0];
  item.rows[0].lower = 0;
  const double most = point.coefficient * item.rows[0].push();
  for (const std::size_t i : {std::size_t(1), std::size_t(2)})
  {
    AvbdRow& row = item.rows[i];
    row.error = moved_along(item, row.a, row.b);
    row.lower = -most;
    row.upper = most;
  }
}

/// Evaluates the rows of an item where its bodies are.
inline void evaluate(AvbdItem& item, double step, const AvbdSettings& settings)
{
  item.set != nullptr ? evaluate_joint(item, step, settings) : evaluate_point(item, settings);
}

/// Stores the impulses of an item's rows in a step [s], and their memories.
inline void keep(const AvbdItem& item, const AvbdKey& key, double step, AvbdMemories& memories)
{
  std::vector<double> impulses;
  for (std::size_t i = 0; i < item.rows.size(); ++i)
  {
    impulses.push_back(step * item.rows[i].push());
    memories[row_of(key, i)] = item.rows[i].memory;
  }
  if (item.set != nullptr)
  {
    return item.set->store_rows(item.number, impulses);
  }
  WorldPoint& point = *item.point->cached;
  point.impulse = point.warm_start_impulse = impulses[0];
  point.friction = item.point->surface.in_world({impulses[1], impulses[2]});
}
// [avbd_item]

} // namespace cookbook
