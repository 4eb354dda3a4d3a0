#pragma once

/// \file
/// \brief The links of a tree as bodies in the world, their energy and their momentum.

#include "03_sphere_manifolds/collision/motion.hpp"
#include "07_constraints/articulated/articulated_body.hpp"

namespace cookbook
{

// [link_bodies]
/// A link as a body in the world, as a solver has it that knows bodies and no joint coordinates.
struct LinkBody
{
  Motion<double> motion;          ///< centre of mass [m], velocity [m/s], angular velocity [rad/s]
  Quaternion<double> orientation; ///< unit, body to world
};

/// A link as the tree placed it last, by move() or accelerations().
inline LinkBody link_body(const ArticulatedBody& tree, int link)
{
  const MovingLink& of = tree.moving(link);
  return {{of.center, of.velocity.tail<3>(), of.velocity.head<3>()}, of.orientation};
}

/// All links in this state, in their order.
inline std::vector<LinkBody> link_bodies(ArticulatedBody& tree, const TreeState& state)
{
  tree.move(state);
  std::vector<LinkBody> bodies;
  for (std::size_t i = 0; i < tree.links().size(); ++i)
  {
    bodies.push_back(link_body(tree, static_cast<int>(i)));
  }
  return bodies;
}

/// What a tree without loads and drives keeps: energy without damping, momentum where nothing is
/// held by the world and there is no gravity.
struct TreeBalance
{
  double energy = 0;                            ///< [J], of motion, height and springs
  Vector3<double> momentum = {0, 0, 0};         ///< [kg m/s]
  Vector3<double> angular_momentum = {0, 0, 0}; ///< [kg m²/s], about the world's origin
};

/// That of a tree in this state; heights are from the world's origin.
inline TreeBalance balance_of(ArticulatedBody& tree, const TreeState& state)
{
  TreeBalance sum;
  const std::vector<LinkBody> bodies = link_bodies(tree, state);
  const double* position = state.positions.data();
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    const Link& link = tree.links()[i];
    const auto& [center, velocity, spin] = bodies[i].motion;
    const Vector3<double> own = bodies[i].orientation.conjugate() * spin;
    const Vector3<double> spun = link.solid.moments.cwiseProduct(own);
    const Vector3<double> momentum = link.solid.mass * velocity;
    sum.energy += (own.dot(spun) + momentum.dot(velocity)) / 2;
    sum.energy -= link.solid.mass * tree.gravity().dot(center);
    sum.momentum += momentum;
    sum.angular_momentum += center.cross(momentum) + bodies[i].orientation * spun;
    const double stretch = link.stiffness > 0 ? position[0] - link.rest : 0;
    sum.energy += link.stiffness * stretch * stretch / 2;
    position += sizes_of(link.joint).positions;
  }
  return sum;
}
// [link_bodies]

} // namespace cookbook
