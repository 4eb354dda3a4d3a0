#pragma once

/// \file
/// \brief Featherstone's articulated-body algorithm: the accelerations of a tree of links.

#include "07_constraints/articulated/link_motion.hpp"

#include <limits>
#include <utility>

namespace cookbook
{

// [eliminate]
/// An axis that nothing resists, to rounding, does not accelerate; R52.
inline constexpr double least_resistance = 64 * std::numeric_limits<double>::epsilon();

/// Eliminates an axis of a joint: what is left of its link's inertia and force for the parent; R52.
inline void eliminate(MovingAxis& axis, MovingLink& link)
{
  const SpatialVector& s = axis.direction;
  const Vector2<double> squares(s.head<3>().squaredNorm(), s.tail<3>().squaredNorm());
  axis.unit_force = link.inertia * s;
  const double resistance = s.dot(axis.unit_force);
  const bool resists = resistance > least_resistance * squares.dot(link.carried);
  axis.inverse_resistance = resists ? 1 / resistance : 0;
  axis.torque -= s.dot(link.force);
  link.inertia -= axis.inverse_resistance * axis.unit_force * axis.unit_force.transpose();
  link.force += axis.inverse_resistance * axis.torque * axis.unit_force;
}
// [eliminate]

// [passes]
/// The second pass: inertias and forces, from the ends inwards; R52.
inline void gather_inwards(const std::vector<Link>& links, MovingTree& tree)
{
  std::size_t axis = tree.axes.size();
  for (std::size_t i = links.size(); i-- > 0;)
  {
    MovingLink& link = tree.links[i + 1];
    MovingLink& parent = tree.links[parent_place(links[i])];
    const double mass = link.carried.y();
    parent.carried += Vector2<double>(link.carried.x() + 2 * mass * link.arm.squaredNorm(), mass);
    for (int k = sizes_of(links[i].joint).velocities; k-- > 0;)
    {
      eliminate(tree.axes[--axis], link);
    }
    parent.inertia += shifted_inertia(link.inertia, link.arm);
    parent.force += shifted_force(link.force + link.inertia * link.bias, link.arm);
  }
}

/// The third pass: accelerations, from the world outwards; R52.
inline void accelerate_outwards(
    const std::vector<Link>& links, MovingTree& tree, Eigen::VectorXd& accelerations)
{
  std::size_t axis = 0;
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    MovingLink& link = tree.links[i + 1];
    const MovingLink& parent = tree.links[parent_place(links[i])];
    link.acceleration = shifted_motion(parent.acceleration, link.arm) + link.bias;
    for (int k = sizes_of(links[i].joint).velocities; k-- > 0; ++axis)
    {
      const MovingAxis& at = tree.axes[axis];
      const double faster =
          at.inverse_resistance * (at.torque - at.unit_force.dot(link.acceleration));
      link.acceleration += faster * at.direction;
      accelerations[static_cast<Eigen::Index>(axis)] = faster;
    }
  }
}
// [passes]

// [articulated]
/// What steps put their states in, so that no step asks for memory.
struct StepMemory
{
  TreeState next, at;    ///< the state at the end of a step, and at a stage of it
  Eigen::VectorXd rates; ///< of all positions
};

/// A tree of links that moves by its joints' coordinates alone.
class ArticulatedBody
{
public:
  Eigen::VectorXd drive;            ///< [N m], [N], what motors add, for each velocity
  std::vector<SpatialVector> loads; ///< [N m, N], on each link's centre of mass, world
  StepMemory memory;                ///< of steps

  /// A tree of these links under a gravity [m/s²]; InvalidShape if these are no tree.
  explicit ArticulatedBody(std::vector<Link> links, const Vector3<double>& gravity = {0, -9.81, 0})
      : links_(std::move(links)), gravity_(gravity)
  {
    check_finite("gravity", gravity);
    memory.next = memory.at = zero_state(checked(links_));
    memory.rates = memory.at.positions;
    drive = accelerations_ = memory.at.velocities;
    loads.resize(links_.size(), SpatialVector::Zero());
    tree_.links.resize(links_.size() + 1);
    tree_.axes.resize(static_cast<std::size_t>(drive.size()));
  }

  const std::vector<Link>& links() const { return links_; }
  const Vector3<double>& gravity() const { return gravity_; }

  /// A link as it was placed last; -1 is the world. Its acceleration is of the last
  /// accelerations().
  const MovingLink& moving(int link) const
  {
    return tree_.links[static_cast<std::size_t>(link) + 1];
  }

  /// Places all links in this state.
  void move(const TreeState& state) { move_outwards(links_, checked(state, links_), tree_); }

  /// How fast the velocities of this state change [rad/s²], [m/s²]; linear in the number of links.
  /// InvalidShape if the state, the drive or a load does not fit or is not finite.
  const Eigen::VectorXd& accelerations(const TreeState& state)
  {
    check_numbers("drive", drive, accelerations_.size());
    if (loads.size() != links_.size())
    {
      const std::string links = std::to_string(links_.size());
      throw InvalidShape("loads.size()", links, std::to_string(loads.size()));
    }
    for (const SpatialVector& load : loads)
    {
      check_numbers("loads", load, 6);
    }
    move(state);
    begin(state);
    gather_inwards(links_, tree_);
    accelerate_outwards(links_, tree_, accelerations_);
    return accelerations_;
  }

private:
  /// Gives each link its own inertia and forces, each axis the torque of its drive and its spring.
  void begin(const TreeState& state)
  {
    tree_.links[0].inertia.setZero();
    tree_.links[0].force.setZero();
    tree_.links[0].carried.setZero();
    std::size_t axis = 0;
    const double* position = state.positions.data();
    for (std::size_t i = 0; i < links_.size(); ++i)
    {
      const Link& link = links_[i];
      MovingLink& own = tree_.links[i + 1];
      const auto& [mass, moments] = link.solid;
      own.inertia = rigid_inertia(mass, moments, own.orientation.toRotationMatrix());
      const Vector3<double> spin = own.velocity.head<3>();
      const Vector3<double> turns = spin.cross(own.inertia.topLeftCorner<3, 3>() * spin);
      own.force = spatial(turns, -mass * gravity_) - loads[i];
      own.carried = {moments.sum(), mass};
      const auto [positions, velocities] = sizes_of(link.joint);
      for (int k = 0; k < velocities; ++k, ++axis)
      {
        const double speed = state.velocities[static_cast<Eigen::Index>(axis)];
        tree_.axes[axis].torque = drive[static_cast<Eigen::Index>(axis)];
        if (velocities == 1)
        {
          tree_.axes[axis].torque -=
              link.stiffness * (position[0] - link.rest) + link.damping * speed;
        }
      }
      position += positions;
    }
  }

  std::vector<Link> links_;
  Vector3<double> gravity_;
  MovingTree tree_;
  Eigen::VectorXd accelerations_;
};
// [articulated]

} // namespace cookbook
