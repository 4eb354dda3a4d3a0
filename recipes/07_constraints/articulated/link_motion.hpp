#pragma once

/// \file
/// \brief Where the links of a tree are and how fast they move, from the world outwards.

#include "01_math/rotations/unit_quaternion.hpp"
#include "01_math/turning/rotation_by.hpp"
#include "07_constraints/articulated/links.hpp"
#include "07_constraints/articulated/spatial_vectors.hpp"

#include <span>

namespace cookbook
{

// [link_motion]
/// A link in motion, in the world's axes; spatial vectors are at its centre of mass.
struct MovingLink
{
  Quaternion<double> orientation{1, 0, 0, 0};     ///< link to world
  Vector3<double> center{0, 0, 0};                ///< [m], of mass
  Vector3<double> arm{0, 0, 0};                   ///< [m], from the parent's centre
  SpatialVector velocity = SpatialVector::Zero(); ///< v
  SpatialVector bias = SpatialVector::Zero();     ///< a₀, acceleration by velocity alone
  SpatialMatrix inertia = SpatialMatrix::Zero();  ///< of the link, then articulated
  SpatialVector force = SpatialVector::Zero(); ///< f₀, what it takes to move without acceleration
  SpatialVector acceleration = SpatialVector::Zero(); ///< a
  Vector2<double> carried = {0, 0}; ///< [kg m², kg], moments and mass of its whole subtree
};

/// A degree of freedom; those of a ball joint are eliminated one after the other.
struct MovingAxis
{
  SpatialVector direction = SpatialVector::Zero();  ///< s, at the link's centre
  SpatialVector unit_force = SpatialVector::Zero(); ///< I s, which accelerates it by one
  double inverse_resistance = 0;                    ///< 1/D, D = s · I s
  double torque = 0;                                ///< τ, then τ - s · f₀
};

/// A tree in motion: the world's place is 0, that of a link is one more than its own.
struct MovingTree
{
  std::vector<MovingLink> links;
  std::vector<MovingAxis> axes; ///< one for each velocity
};

/// What the k-th velocity of a joint is a velocity of, in the joint's frame.
inline SpatialVector joint_direction(const Link& link, int k)
{
  const Vector3<double> none(0, 0, 0);
  switch (link.joint)
  {
  case JointType::hinge:
    return spatial(link.axis, none);
  case JointType::slider:
    return spatial(none, link.axis);
  default:
    return SpatialVector::Unit(k);
  }
}

/// How a joint has turned its link and moved it along [m], in the joint's frame.
struct JointDisplacement
{
  Quaternion<double> turn{1, 0, 0, 0};
  Vector3<double> shift{0, 0, 0};
};

/// That of a joint with these coordinates; a quaternion counts as its direction, zero as no turn.
inline JointDisplacement joint_displacement(const Link& link, const double* at)
{
  switch (link.joint)
  {
  case JointType::hinge:
    return {rotation_by<double>(at[0] * link.axis), {0, 0, 0}};
  case JointType::slider:
    return {Quaternion<double>::Identity(), at[0] * link.axis};
  case JointType::ball:
    return {unit_quaternion<double>({at[0], at[1], at[2], at[3]}), {0, 0, 0}};
  case JointType::free:
    return {unit_quaternion<double>({at[0], at[1], at[2], at[3]}), {at[4], at[5], at[6]}};
  default:
    return {};
  }
}

/// Moves one link to where its joint has it, from its parent, with its joint's velocities.
inline void move_link(
    const Link& link, const MovingLink& parent, const JointDisplacement& at,
    const double* velocities, std::span<MovingAxis> axes, MovingLink& own)
{
  const Quaternion<double> frame = parent.orientation * link.frame;
  own.orientation = frame * at.turn;
  const Vector3<double> to_anchor = parent.orientation * link.anchor_parent + frame * at.shift;
  const Vector3<double> from_center = own.orientation * link.anchor_child;
  own.arm = to_anchor - from_center;
  own.center = parent.center + own.arm;
  Vector3<double> turning(0, 0, 0), sliding(0, 0, 0);
  for (std::size_t k = 0; k < axes.size(); ++k)
  {
    const SpatialVector direction = joint_direction(link, static_cast<int>(k));
    const Vector3<double> turn = frame * direction.head<3>(), slide = frame * direction.tail<3>();
    axes[k].direction = spatial(turn, slide + from_center.cross(turn));
    turning += velocities[k] * turn;
    sliding += velocities[k] * slide;
  }
  const SpatialVector relative = spatial(turning, sliding + from_center.cross(turning));
  own.velocity = shifted_motion(parent.velocity, own.arm) + relative;
  const Vector3<double> before = parent.velocity.head<3>(), spin = own.velocity.head<3>();
  const Vector3<double> turns = before.cross(turning);
  own.bias = spatial(
      turns, before.cross(before.cross(to_anchor)) - spin.cross(spin.cross(from_center)) +
                 2 * before.cross(sliding) + from_center.cross(turns));
}

/// The first pass: places and velocities, from the world outwards.
inline void move_outwards(const std::vector<Link>& links, const TreeState& state, MovingTree& tree)
{
  const double *position = state.positions.data(), *velocity = state.velocities.data();
  std::span<MovingAxis> axes(tree.axes);
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    const auto [positions, velocities] = sizes_of(links[i].joint);
    const auto count = static_cast<std::size_t>(velocities);
    const MovingLink& parent = tree.links[parent_place(links[i])];
    move_link(
        links[i], parent, joint_displacement(links[i], position), velocity, axes.first(count),
        tree.links[i + 1]);
    position += positions;
    velocity += velocities;
    axes = axes.subspan(count);
  }
}
// [link_motion]

} // namespace cookbook
