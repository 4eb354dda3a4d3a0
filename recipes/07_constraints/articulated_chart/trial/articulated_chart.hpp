#pragma once

/// \file
/// \brief What the accelerations of a chain cost, by articulated bodies and by a mass matrix.

#include "07_constraints/articulated/articulated.hpp"
#include "07_constraints/articulated/hanging_chain.hpp"

#include <Eigen/Cholesky>

#include <utility>
#include <vector>

namespace cookbook
{

// [composite_bodies]
/// The accelerations of a tree by its mass matrix, which is put together from composite rigid
/// bodies (CRBA) and solved by Cholesky: quadratic in the links, and a cube for large trees.
///
/// For trees without drives, loads and springs.
class CompositeBodies
{
public:
  /// Those of these links under a gravity [m/s²].
  explicit CompositeBodies(std::vector<Link> links, const Vector3<double>& gravity = {0, -9.81, 0})
      : links_(std::move(links)), gravity_(gravity)
  {
    const Eigen::Index size = sizes_of(checked(links_)).velocities;
    tree_.links.resize(links_.size() + 1);
    tree_.axes.resize(static_cast<std::size_t>(size));
    mass_.setZero(size, size);
    torques_.setZero(size);
    for (std::size_t i = 0, axis = 0; i < links_.size(); ++i)
    {
      first_.push_back(axis);
      axis += static_cast<std::size_t>(sizes_of(links_[i].joint).velocities);
    }
  }

  /// How fast the velocities of this state change [rad/s²], [m/s²].
  Eigen::VectorXd accelerations(const TreeState& state)
  {
    move_outwards(links_, state, tree_);
    for (std::size_t i = 0; i < links_.size(); ++i)
    {
      begin(i);
    }
    for (std::size_t i = links_.size(); i-- > 0;)
    {
      add_rows(i);
      const MovingLink& link = tree_.links[i + 1];
      MovingLink& parent = parent_of(i);
      parent.inertia += shifted_inertia(link.inertia, link.arm);
      parent.force += shifted_force(link.force, link.arm);
    }
    return mass_.llt().solve(torques_);
  }

private:
  MovingLink& parent_of(std::size_t i)
  {
    return tree_.links[static_cast<std::size_t>(links_[i].parent + 1)];
  }

  /// The force on a link where no joint accelerates.
  void begin(std::size_t i)
  {
    MovingLink& link = tree_.links[i + 1];
    const auto& [mass, moments] = links_[i].solid;
    link.inertia = rigid_inertia(mass, moments, link.orientation.toRotationMatrix());
    link.acceleration = shifted_motion(parent_of(i).acceleration, link.arm) + link.bias;
    const Vector3<double> spin = link.velocity.head<3>();
    const Vector3<double> turns = spin.cross(link.inertia.topLeftCorner<3, 3>() * spin);
    link.force = link.inertia * link.acceleration + spatial(turns, -mass * gravity_);
  }

  /// The rows of a link's axes: what the axes of all links above feel of them.
  void add_rows(std::size_t i)
  {
    const std::size_t end = i + 1 < first_.size() ? first_[i + 1] : tree_.axes.size();
    for (std::size_t k = first_[i]; k < end; ++k)
    {
      const SpatialVector& direction = tree_.axes[k].direction;
      SpatialVector force = tree_.links[i + 1].inertia * direction;
      torques_[static_cast<Eigen::Index>(k)] = -direction.dot(tree_.links[i + 1].force);
      for (int from = static_cast<int>(i); from >= 0;)
      {
        const auto at = static_cast<std::size_t>(from);
        const std::size_t last = at + 1 < first_.size() ? first_[at + 1] : tree_.axes.size();
        for (std::size_t j = first_[at]; j < last; ++j)
        {
          const auto row = static_cast<Eigen::Index>(k), column = static_cast<Eigen::Index>(j);
          mass_(row, column) = mass_(column, row) = tree_.axes[j].direction.dot(force);
        }
        force = shifted_force(force, tree_.links[at + 1].arm);
        from = links_[at].parent;
      }
    }
  }

  std::vector<Link> links_;
  Vector3<double> gravity_;
  MovingTree tree_;
  std::vector<std::size_t> first_; // axis of each link
  Eigen::MatrixXd mass_;
  Eigen::VectorXd torques_;
};
// [composite_bodies]

/// A chain of so many links on hinges, bent, and turning.
inline std::pair<std::vector<Link>, TreeState> bent_chain(int count)
{
  std::vector<Link> links = chain_links({.links = count});
  TreeState state = zero_state(links);
  for (Eigen::Index i = 0; i < state.positions.size(); ++i)
  {
    state.positions[i] = i % 3 == 0 ? 0.5 : -0.2;
    state.velocities[i] = i % 2 == 0 ? 1 : -0.7;
  }
  return {links, state};
}

} // namespace cookbook
