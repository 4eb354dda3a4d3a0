#pragma once

/// \file
/// \brief A ball joint: a point of one body stays at a point of another, around which both turn.

#include "06_world/ball_joint/joint_pose.hpp"
#include "06_world/constraints/constraint_set.hpp"
#include "06_world/islands/position_impulse.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace cookbook
{

// [ball_joints]
/// Ball joints of a world.
class BallJoints : public ConstraintSet
{
public:
  /// Adds a joint.
  void add(const BallJoint& joint) { joints_.push_back({joint}); }

  std::size_t size() const { return joints_.size(); }                        ///< how many
  const BallJoint& operator[](std::size_t i) const { return joints_[i].of; } ///< one of them

  const char* name() const override { return "ball joints"; }

  std::unique_ptr<ConstraintSet> clone() const override
  {
    return std::make_unique<BallJoints>(*this);
  }

  void each_pair(const std::function<void(const ConstraintPair&)>& call) const override
  {
    for (std::size_t i = 0; i < joints_.size(); ++i)
    {
      const BallJoint& joint = joints_[i].of;
      call({joint.a, joint.b, joint.collides, 0, static_cast<int>(i)});
    }
  }

  void remove_body(int body) override
  {
    std::erase_if(joints_, [&](const Solved& one) { return one.of.a == body || one.of.b == body; });
  }

  void prepare(int number, int substeps) override { at(number).of.impulse /= substeps; }

  void warm_start(Bodies bodies, int number, double substep) override
  {
    Solved& one = at(number);
    take(one, bodies, substep);
    push(one, bodies, one.of.impulse);
  }

  void solve(Bodies bodies, int number, const Softness<double>& softness) override
  {
    Solved& one = at(number);
    const Vector3<double> bias = softness.bias_rate * one.error + one.turning;
    const Vector3<double> change =
        -softness.mass_scale * (one.mass * (velocity(one, bodies) + bias)) -
        softness.impulse_scale * one.of.impulse;
    one.of.impulse += change;
    push(one, bodies, change);
  }

  void relax(Bodies bodies, int number) override
  {
    Solved& one = at(number);
    take(one, bodies, 0);
    const Vector3<double> change = -(one.mass * velocity(one, bodies));
    one.of.impulse += change;
    push(one, bodies, change);
  }

  void store(int number, int substeps) override { at(number).of.impulse *= substeps; }

  void rows(
      std::span<const RigidBody> bodies, int number, double step,
      const std::function<void(const ConstraintRow&)>& emit) const override
  {
    const BallJoint& joint = joints_[index(number)].of;
    const JointPose pose = joint_pose(bodies[index(joint.a)], bodies[index(joint.b)], joint);
    const Vector3<double> off = pose.error + step * step / 2 * pose.turning;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3<double> along = Vector3<double>::Unit(axis);
      ConstraintRow row;
      row.a << -along, -pose.arms.a.cross(along);
      row.b << along, pose.arms.b.cross(along);
      row.error = off[axis];
      emit(row);
    }
  }

  void store_rows(int number, std::span<const double> impulses) override
  {
    at(number).of.impulse = {impulses[0], impulses[1], impulses[2]};
  }

  bool correct(Bodies bodies, int number) override
  {
    const BallJoint& joint = joints_[index(number)].of;
    RigidBody &a = bodies[index(joint.a)], &b = bodies[index(joint.b)];
    const JointPose pose = joint_pose(a, b, joint);
    const Vector3<double> push = -joint_inverse_mass(a, b, pose.arms).inverse() * pose.error;
    apply_position_impulse(a, pose.arms.a, -push);
    apply_position_impulse(b, pose.arms.b, push);
    return true;
  }

private:
  struct Solved
  {
    BallJoint of;
    Arms<double> arms{};                                // [m], world
    Vector3<double> error = Vector3<double>::Zero();    // [m], from A's anchor to B's
    Vector3<double> turning = Vector3<double>::Zero();  // [m/s], what turning adds to it
    Matrix3<double> mass = Matrix3<double>::Identity(); // [kg], 1/K
  };

  static std::size_t index(int number) { return static_cast<std::size_t>(number); }
  Solved& at(int number) { return joints_[index(number)]; }

  /// Takes the bodies as they are before a substep [s].
  static void take(Solved& one, Bodies bodies, double substep)
  {
    const RigidBody &a = bodies[index(one.of.a)], &b = bodies[index(one.of.b)];
    const JointPose pose = joint_pose(a, b, one.of);
    one.arms = pose.arms;
    one.error = pose.error;
    one.turning = substep / 2 * pose.turning;
    one.mass = joint_inverse_mass(a, b, pose.arms).inverse();
  }

  static Vector3<double> velocity(const Solved& one, Bodies bodies)
  {
    return relative_velocity(
        bodies[index(one.of.a)].motion, bodies[index(one.of.b)].motion, one.arms);
  }

  static void push(const Solved& one, Bodies bodies, const Vector3<double>& impulse)
  {
    apply_impulse<double>(bodies[index(one.of.a)], bodies[index(one.of.b)], one.arms, impulse);
  }

  std::vector<Solved> joints_;
};
// [ball_joints]

} // namespace cookbook
