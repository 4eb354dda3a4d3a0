#pragma once

/// \file
/// \brief An island of ball joints as a tree of links, where it is one: nothing can come apart.

#include "06_world/ball_joint/ball_joint.hpp"
#include "07_constraints/articulated/articulated.hpp"
#include "07_constraints/joint_trial/trial/conjugate_gradients.hpp"

#include <cstddef>
#include <map>
#include <stdexcept>
#include <vector>

namespace cookbook
{

// [tree_steps]
/// An island as a tree: the bodies of its links, and its coordinates.
struct IslandTree
{
  std::vector<int> bodies; ///< of the world, a link each
  std::vector<Link> links;
  std::vector<double> positions, velocities; ///< of a TreeState
};

/// Adds a link; its coordinates come from its body as it is.
inline void add_link(
    IslandTree& tree, IslandView world, int body, int parent, const Vector3<double>& anchor_parent,
    const Vector3<double>& anchor_child, JointType joint)
{
  const RigidBody& own = world.bodies[index_of(body)];
  Link link{.parent = parent, .joint = joint, .solid = {1 / own.inverse_mass, own.moments}};
  link.anchor_parent = anchor_parent;
  link.anchor_child = anchor_child;
  Quaternion<double> frame = Quaternion<double>::Identity();
  Vector3<double> spin = own.motion.angular_velocity;
  if (parent >= 0)
  {
    const RigidBody& carries = world.bodies[index_of(tree.bodies[index_of(parent)])];
    frame = carries.orientation;
    spin -= carries.motion.angular_velocity;
  }
  const Quaternion<double> turn = frame.conjugate() * own.orientation;
  const Vector3<double> turning = frame.conjugate() * spin;
  tree.positions.insert(tree.positions.end(), {turn.w(), turn.x(), turn.y(), turn.z()});
  tree.velocities.insert(tree.velocities.end(), turning.begin(), turning.end());
  if (joint == JointType::free)
  {
    const Motion<double>& motion = own.motion;
    tree.positions.insert(tree.positions.end(), motion.center.begin(), motion.center.end());
    tree.velocities.insert(tree.velocities.end(), motion.velocity.begin(), motion.velocity.end());
  }
  tree.bodies.push_back(body);
  tree.links.push_back(link);
}

/// The tree of an island; std::logic_error where its joints close a loop, are no ball joints, or it
/// has contacts.
inline IslandTree island_tree(IslandView world, const Island& island)
{
  if (!island.contacts.empty())
  {
    throw std::logic_error("a tree of links has no contacts");
  }
  IslandTree tree;
  std::map<int, int> places; // of bodies among the links; -1: the world
  for (const int number : island.constraints)
  {
    const ConstraintPair& pair = world.constraints[index_of(number)];
    const auto* joints = dynamic_cast<const BallJoints*>(&*world.sets[pair.set]);
    if (joints == nullptr)
    {
      throw std::logic_error("only ball joints are taken as a tree of links here");
    }
    const BallJoint& joint = (*joints)[index_of(pair.number)];
    const RigidBody& a = world.bodies[index_of(joint.a)];
    if (is_fixed(a))
    {
      places[joint.a] = -1;
    }
    else if (!places.contains(joint.a)) // nothing carries it
    {
      if (!tree.links.empty())
      {
        throw std::logic_error("joints go from the root of a tree to its ends here");
      }
      places[joint.a] = 0;
      add_link(tree, world, joint.a, -1, {0, 0, 0}, {0, 0, 0}, JointType::free);
    }
    if (places.contains(joint.b) || is_fixed(world.bodies[index_of(joint.b)]))
    {
      throw std::logic_error("joints that close a loop are no tree of links");
    }
    const int parent = places[joint.a];
    const Vector3<double> hung =
        parent < 0 ? Vector3<double>(a.motion.center + a.orientation * joint.anchor_a)
                   : joint.anchor_a;
    places[joint.b] = static_cast<int>(tree.links.size());
    add_link(tree, world, joint.b, parent, hung, joint.anchor_b, JointType::ball);
  }
  return tree;
}

/// Moves an island on by a step [s], in so many steps of RK4. What pushes its bodies apart is
/// taken back first: their velocities become ones that the tree can have.
inline void tree_steps(IslandView world, const Island& island, double step, int steps)
{
  if (is_alone(island))
  {
    throw std::logic_error("a body that nothing holds is no tree of links");
  }
  push_island(world, island, island_rows(world, island, step, 0, 0), 1000);
  const IslandTree made = island_tree(world, island);
  const auto vector = [](const std::vector<double>& numbers)
  { return Eigen::VectorXd::Map(numbers.data(), static_cast<Eigen::Index>(numbers.size())); };
  ArticulatedBody tree(made.links, world.gravity);
  TreeState state{vector(made.positions), vector(made.velocities)};
  for (int i = 0; i < steps; ++i)
  {
    rk4_step(tree, state, step / steps);
  }
  const std::vector<LinkBody> moved = link_bodies(tree, state);
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    RigidBody& body = world.bodies[index_of(made.bodies[i])];
    body.motion = moved[i].motion;
    body.orientation = moved[i].orientation;
    update_axes(body);
    if (world.falls != nullptr)
    {
      (*world.falls)[index_of(made.bodies[i])] = false;
    }
  }
}
// [tree_steps]

} // namespace cookbook
