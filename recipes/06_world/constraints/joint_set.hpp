#pragma once

/// \file
/// \brief A set of joints of one kind, which is no more than its rows.

#include "06_world/constraints/constraint_set.hpp"
#include "06_world/constraints/correct_rows.hpp"
#include "06_world/constraints/solved_joint.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace cookbook
{

// [joint_set]
/// Joints of one kind, each by its number.
template <JointKind Kind>
class JointSet : public ConstraintSet
{
public:
  /// Adds a joint and returns its number; std::invalid_argument where it makes no sense.
  std::size_t add(const Kind& joint)
  {
    check_joint(joint);
    joints_.push_back({joint});
    return joints_.size() - 1;
  }

  std::size_t size() const { return joints_.size(); }                   ///< how many
  const Kind& operator[](std::size_t i) const { return joints_[i].of; } ///< one of them

  /// Changes a joint, such as the speed of its motor; its bodies wake with the next step.
  void set(std::size_t i, const Kind& joint)
  {
    check_joint(joint);
    joints_.at(i).of = joint;
    joints_[i].changed = true;
  }

  /// The impulses [N s, N m s] of a joint's rows in the last step, by their order.
  const JointImpulses& impulses(std::size_t i) const { return joints_[i].impulses; }

  /// Has a joint break when its mean force [N] in a step is above this, zero or more; infinity:
  /// never. Broken, it keeps its number, and does nothing. Its bodies wake with the next step.
  void set_strength(std::size_t i, double strength)
  {
    check_strength(strength);
    joints_.at(i).strength = strength;
    joints_[i].changed = true;
  }
  /// The mean force [N] on B in the last step, world, of a joint that has a strength.
  const Vector3<double>& force(std::size_t i) const { return joints_[i].force; }
  bool is_broken(std::size_t i) const { return joints_[i].broken; } ///< whether it has
  /// Joins it again; its bodies wake with the next step.
  void mend(std::size_t i)
  {
    joints_.at(i).broken = false;
    joints_[i].changed = true;
  }

  const char* name() const override { return Kind::name; }

  std::unique_ptr<ConstraintSet> clone() const override
  {
    return std::make_unique<JointSet>(*this);
  }

  void each_pair(const std::function<void(const ConstraintPair&)>& call) const override
  {
    for (std::size_t i = 0; i < joints_.size(); ++i)
    {
      const Kind& joint = joints_[i].of;
      if (!joints_[i].broken)
      {
        call({joint.a, joint.b, joint.collides, 0, static_cast<int>(i), joints_[i].changed});
      }
    }
  }

  void remove_body(int body) override
  {
    std::erase_if(
        joints_,
        [&](const SolvedJoint<Kind>& one) { return one.of.a == body || one.of.b == body; });
  }

  void prepare(int number, int substeps) override
  {
    at(number).elapsed = 0;
    scale_impulses(at(number), 1.0 / substeps);
  }

  void warm_start(Bodies bodies, int number, double substep) override
  {
    SolvedJoint<Kind>& one = at(number);
    add_substep(one);
    take_rows(one, bodies[index(one.of.a)], bodies[index(one.of.b)], substep);
    one.elapsed += substep;
    RigidBody &a = bodies[index(one.of.a)], &b = bodies[index(one.of.b)];
    for (std::size_t i = 0; i < one.rows.size(); ++i)
    {
      push_along(a, one.rows[i].a, one.impulses[i]);
      push_along(b, one.rows[i].b, one.impulses[i]);
    }
  }

  void solve(Bodies bodies, int number, const Softness<double>& softness) override
  {
    SolvedJoint<Kind>& one = at(number);
    RigidBody &a = bodies[index(one.of.a)], &b = bodies[index(one.of.b)];
    for (std::size_t i = one.rows.rigid(); i < one.rows.size(); ++i)
    {
      solve_row(one.rows, i, one.factor, a, b, softness, one.substep, one.impulses);
    }
    solve_rigid(one.rows, one.factor, a, b, softness, one.substep, one.impulses);
  }

  void relax(Bodies bodies, int number) override
  {
    SolvedJoint<Kind>& one = at(number);
    const double substep = one.substep;
    take_rows(one, bodies[index(one.of.a)], bodies[index(one.of.b)], substep);
    one.rows.stop_turning();
    RigidBody &a = bodies[index(one.of.a)], &b = bodies[index(one.of.b)];
    for (std::size_t i = one.rows.rigid(); i < one.rows.size(); ++i)
    {
      if (!is_spring(one.rows[i]))
      {
        solve_row(one.rows, i, one.factor, a, b, rigid<double>(), substep, one.impulses);
      }
    }
    solve_rigid(one.rows, one.factor, a, b, rigid<double>(), substep, one.impulses);
  }

  void store(int number, int substeps) override
  {
    add_substep(at(number));
    at(number).elapsed = 0;
    scale_impulses(at(number), substeps);
  }

  void rows(
      const RigidBody& a, const RigidBody& b, int number, double step,
      const std::function<void(const ConstraintRow&)>& emit) const override
  {
    JointRows rows;
    joint_rows(joints_[index(number)].of, a, b, step, rows);
    std::for_each(rows.all().begin(), rows.all().end(), emit);
  }

  void store_rows(int number, std::span<const double> impulses) override
  {
    SolvedJoint<Kind>& one = at(number);
    std::copy(impulses.begin(), impulses.end(), one.impulses.begin());
    add_impulses(one, one.impulses);
  }

  bool correct(Bodies bodies, int number, double substep, bool first) override
  {
    SolvedJoint<Kind>& one = at(number);
    take_rows(one, bodies[index(one.of.a)], bodies[index(one.of.b)], substep);
    add_impulses(
        one, correct_rows(
                 one.rows, bodies[index(one.of.a)], bodies[index(one.of.b)], one.factor, substep,
                 first));
    return true;
  }

  void finish(std::span<const RigidBody> bodies, double step) override
  {
    for (SolvedJoint<Kind>& one : joints_)
    {
      end_step(one, bodies[index(one.of.a)], bodies[index(one.of.b)], step);
    }
  }

private:
  static std::size_t index(int number) { return static_cast<std::size_t>(number); }
  SolvedJoint<Kind>& at(int number) { return joints_[index(number)]; }

  std::vector<SolvedJoint<Kind>> joints_;
};
// [joint_set]

} // namespace cookbook
