#pragma once

/// \file
/// \brief A set of joints of one kind, which is no more than its rows.

#include "06_world/constraints/constraint_set.hpp"
#include "06_world/constraints/correct_rows.hpp"
#include "06_world/contacts/integrate_body.hpp"

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

  /// Changes a joint, such as the speed of its motor; its bodies wake by GameWorld::wake().
  void set(std::size_t i, const Kind& joint)
  {
    check_joint(joint);
    joints_.at(i).of = joint;
  }

  /// The impulses [N s, N m s] of a joint's rows in the last step, by their order.
  const JointImpulses& impulses(std::size_t i) const { return joints_[i].impulses; }

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
      call({joint.a, joint.b, joint.collides, 0, static_cast<int>(i)});
    }
  }

  void remove_body(int body) override
  {
    std::erase_if(joints_, [&](const Solved& one) { return one.of.a == body || one.of.b == body; });
  }

  void prepare(int number, int substeps) override
  {
    at(number).elapsed = 0;
    scale(at(number), 1.0 / substeps);
  }

  void warm_start(Bodies bodies, int number, double substep) override
  {
    Solved& one = at(number);
    take(one, bodies, substep);
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
    Solved& one = at(number);
    RigidBody &a = bodies[index(one.of.a)], &b = bodies[index(one.of.b)];
    for (std::size_t i = one.rows.rigid(); i < one.rows.size(); ++i)
    {
      solve_row(one.rows[i], a, b, softness, one.substep, one.impulses[i]);
    }
    solve_rigid(one.rows, one.factor, a, b, softness, one.substep, one.impulses);
  }

  void relax(Bodies bodies, int number) override
  {
    Solved& one = at(number);
    const double substep = one.substep;
    take(one, bodies, substep);
    RigidBody &a = bodies[index(one.of.a)], &b = bodies[index(one.of.b)];
    for (std::size_t i = one.rows.rigid(); i < one.rows.size(); ++i)
    {
      if (!is_spring(one.rows[i]))
      {
        ConstraintRow row = one.rows[i];
        row.turning = 0;
        solve_row(row, a, b, rigid<double>(), substep, one.impulses[i]);
      }
    }
    solve_rigid(one.rows, one.factor, a, b, rigid<double>(), 0, one.impulses);
  }

  void store(int number, int substeps) override { scale(at(number), substeps); }

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
    std::copy(impulses.begin(), impulses.end(), at(number).impulses.begin());
  }

  bool correct(Bodies bodies, int number, double substep, bool first) override
  {
    Solved& one = at(number);
    take(one, bodies, substep);
    correct_rows(
        one.rows, bodies[index(one.of.a)], bodies[index(one.of.b)], one.factor, substep, first);
    return true;
  }

private:
  struct Solved
  {
    Kind of;
    JointRows rows{};                  // as the bodies were
    JointImpulses impulses{};          // [N s, N m s]
    Eigen::LDLT<RigidMatrix> factor{}; // of the rigid rows' K
    double substep = 0, elapsed = 0;   // [s], elapsed since the step began
  };

  static std::size_t index(int number) { return static_cast<std::size_t>(number); }
  Solved& at(int number) { return joints_[index(number)]; }

  static void scale(Solved& one, double by)
  {
    for (double& impulse : one.impulses)
    {
      impulse *= by;
    }
  }

  /// Takes the bodies as they are before a substep [s].
  static void take(Solved& one, Bodies bodies, double substep)
  {
    const RigidBody &a = bodies[index(one.of.a)], &b = bodies[index(one.of.b)];
    one.substep = substep;
    one.rows.clear();
    joint_rows(one.of, along(a, one.elapsed), along(b, one.elapsed), substep, one.rows);
    one.factor.compute(rigid_inverse_mass(one.rows, a, b));
  }

  /// A body as it is, or, if a game drives it, as it is after a time [s]: the world moves that only
  /// when the step ends.
  static RigidBody along(RigidBody body, double time)
  {
    if (is_driven(body))
    {
      body.motion.center += time * body.motion.velocity;
      body.orientation = turned_by(body, time * body.motion.angular_velocity);
      update_axes(body);
    }
    return body;
  }

  std::vector<Solved> joints_;
};
// [joint_set]

} // namespace cookbook
