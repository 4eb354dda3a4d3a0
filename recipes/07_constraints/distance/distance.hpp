#pragma once

/// \file
/// \brief A distance joint: two points whose distance stays within bounds, as on a rod or a rope.

#include "06_world/constraints/anchors.hpp"
#include "06_world/constraints/joint_set.hpp"
#include "common/math/norm.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace cookbook
{

// [distance]
/// Keeps two anchors from being closer or farther than two lengths; R58. Alike, they make a rod; a
/// `least` of zero makes a rope. A length of zero has no direction: a ball joint has three.
struct DistanceJoint
{
  static constexpr const char* name = "distance joints";

  int a, b;                 ///< the two bodies by their places in the world; one may be fixed
  Vector3<double> anchor_a; ///< [m], in A's frame
  Vector3<double> anchor_b; ///< [m], in B's frame
  double least = 0;         ///< [m]
  double most = std::numeric_limits<double>::infinity(); ///< [m]
  bool collides = true;                                  ///< whether the two may touch
};

/// Refuses anchors that are not finite and lengths that are none, std::invalid_argument.
inline void check_joint(const DistanceJoint& joint)
{
  check_finite(joint.anchor_a, "anchor_a");
  check_finite(joint.anchor_b, "anchor_b");
  if (!(joint.least >= 0 && joint.least <= joint.most && std::isfinite(joint.least)))
  {
    throw std::invalid_argument(
        "joint: least is " + std::to_string(joint.least) + " and most " +
        std::to_string(joint.most) + "; they must be zero or more, and most no less");
  }
  if (joint.most == 0)
  {
    throw std::invalid_argument("joint: most is zero; a ball joint holds two points together");
  }
}

/// The row of the distance between two anchors, along the line from A's to B's; +y where they are
/// one. It bends by v²/r as they go round each other; where that is more than a step [s] can
/// follow, by what the step can.
inline ConstraintRow
distance_row(const DistanceJoint& joint, const RigidBody& a, const RigidBody& b, double step)
{
  const Vector3<double> to_a = a.orientation * joint.anchor_a;
  const Vector3<double> to_b = b.orientation * joint.anchor_b;
  const Vector3<double>&w_a = a.motion.angular_velocity, &w_b = b.motion.angular_velocity;
  const Direction<double> line = normalize<double>(b.motion.center + to_b - a.motion.center - to_a);
  const Vector3<double> speed =
      b.motion.velocity + w_b.cross(to_b) - a.motion.velocity - w_a.cross(to_a);
  const double round = (speed - line.unit.dot(speed) * line.unit).squaredNorm();
  const double turned = std::sqrt(line.length * line.length + step * step * round) + line.length;
  ConstraintRow row;
  row.a << -line.unit, -to_a.cross(line.unit);
  row.b << line.unit, to_b.cross(line.unit);
  row.error = line.length;
  row.turning =
      line.unit.dot(centripetal_acceleration(w_b, to_b) - centripetal_acceleration(w_a, to_a)) +
      (turned > 0 ? 2 * round / turned : 0);
  return row;
}

/// The rows of a distance joint: one of a rod; or one for each of its lengths that bounds it.
inline void joint_rows(
    const DistanceJoint& joint, const RigidBody& a, const RigidBody& b, double step,
    JointRows& rows)
{
  ConstraintRow row = distance_row(joint, a, b, step);
  const double length = row.error;
  row.error = length - joint.least;
  if (joint.least == joint.most)
  {
    return rows.add(row);
  }
  row.lower = 0;
  if (joint.least > 0)
  {
    rows.add(row);
  }
  if (std::isfinite(joint.most))
  {
    row.a = -row.a;
    row.b = -row.b;
    row.turning = -row.turning;
    row.error = joint.most - length;
    rows.add(row);
  }
}

/// Distance joints of a world; the impulse of a rod is above zero where it pushes, those of bounds
/// are never below it.
using DistanceJoints = JointSet<DistanceJoint>;

/// The rod between two points [m], world, of two bodies, by their ids, as long as they are apart
/// now.
template <class World>
DistanceJoint rod_between(
    const World& world, BodyId a, BodyId b, const Vector3<double>& on_a,
    const Vector3<double>& on_b)
{
  const double length = (on_b - on_a).norm();
  return {
      static_cast<int>(world.index(a)),
      static_cast<int>(world.index(b)),
      anchor_at(world.body(a), on_a),
      anchor_at(world.body(b), on_b),
      length,
      length};
}

/// The rope of a length [m] between two points [m], world, of two bodies, by their ids.
template <class World>
DistanceJoint rope_between(
    const World& world, BodyId a, BodyId b, const Vector3<double>& on_a,
    const Vector3<double>& on_b, double length)
{
  DistanceJoint rope = rod_between(world, a, b, on_a, on_b);
  rope.least = 0;
  rope.most = length;
  return rope;
}
// [distance]

} // namespace cookbook
