#pragma once

/// \file
/// \brief A tree of links as plain data, its coordinates, and the check that it is one.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "05_resolution/mass_properties/solid_mass.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

// [links]
/// What a joint lets its link do.
enum class JointType
{
  fixed,  ///< nothing
  hinge,  ///< revolute: turns about an axis
  slider, ///< prismatic: moves along an axis
  ball,   ///< spherical: turns about any axis
  free    ///< turns and moves: not held at all
};

/// A link of a tree and the joint that holds it to its parent.
///
/// The joint's frame has its origin at the parent's anchor and turns with the parent.
struct Link
{
  int parent = -1; ///< a place before its own; -1 is the world
  JointType joint = JointType::hinge;
  MassProperties<double> solid{0, {0, 0, 0}}; ///< zero is allowed, not below
  Vector3<double> anchor_parent{0, 0, 0}; ///< [m], from the parent's centre of mass, in its frame
  Vector3<double> anchor_child{0, 0, 0};  ///< [m], from the link's centre of mass, in its frame
  Vector3<double> axis{0, 0, 1};          ///< unit, in the joint's frame; of a hinge or a slider
  Quaternion<double> frame{1, 0, 0, 0};   ///< unit, the joint's frame to the parent's
  double stiffness = 0;                   ///< [N m/rad], [N/m], a spring in a hinge or a slider
  double damping = 0;                     ///< [N m s], [N s/m], in a hinge or a slider
  double rest = 0;                        ///< [rad], [m], where the spring does not pull
};

/// The place of a link's parent where the world stands before all links.
inline std::size_t parent_place(const Link& link)
{
  const int place = link.parent + 1;
  return static_cast<std::size_t>(place);
}

/// How many numbers place a joint's link, and how many tell its velocity.
struct JointSizes
{
  int positions, velocities;
};

/// A ball joint is placed by a quaternion w, x, y, z; a free one by that and its anchor's place x,
/// y, z [m]; velocities are ω, or ω and v. All are in the joint's frame.
inline JointSizes sizes_of(JointType joint)
{
  switch (joint)
  {
  case JointType::fixed:
    return {0, 0};
  case JointType::ball:
    return {4, 3};
  case JointType::free:
    return {7, 6};
  default:
    return {1, 1};
  }
}

/// The coordinates of a tree, joint after joint.
struct TreeState
{
  Eigen::VectorXd positions, velocities;
};

/// The sums of these for all joints of a tree.
inline JointSizes sizes_of(const std::vector<Link>& links)
{
  JointSizes sum{0, 0};
  for (const Link& link : links)
  {
    sum.positions += sizes_of(link.joint).positions;
    sum.velocities += sizes_of(link.joint).velocities;
  }
  return sum;
}

/// All joints at zero, at rest.
inline TreeState zero_state(const std::vector<Link>& links)
{
  const auto [positions, velocities] = sizes_of(links);
  TreeState state{Eigen::VectorXd::Zero(positions), Eigen::VectorXd::Zero(velocities)};
  int place = 0;
  for (const Link& link : links)
  {
    const int size = sizes_of(link.joint).positions;
    if (size >= 4)
    {
      state.positions[place] = 1; // no turn
    }
    place += size;
  }
  return state;
}
// [links]

// [checked_links]
/// The links themselves, or InvalidShape, a std::invalid_argument, which names the member and its
/// value: a parent comes before its link, so that there is no cycle; all numbers are finite, mass
/// and moments not negative, axes and frames of length one to 1e-9.
inline const std::vector<Link>& checked(const std::vector<Link>& links)
{
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    const Link& link = links[i];
    const std::string name = "links[" + std::to_string(i) + "].";
    const auto require = [&](bool holds, const char* member, const char* must, double is)
    {
      if (!holds)
      {
        throw InvalidShape(name + member, must, text_of(is));
      }
    };
    const bool before = link.parent >= -1 && link.parent < static_cast<int>(i);
    require(before, "parent", "-1 or the place of a link before it", link.parent);
    check_finite(name + "anchor_parent", link.anchor_parent);
    check_finite(name + "anchor_child", link.anchor_child);
    const double turned = link.frame.norm(), along = link.axis.norm();
    require(std::abs(turned - 1) <= 1e-9, "frame", "of length one", turned);
    require(std::abs(along - 1) <= 1e-9, "axis", "of length one", along);
    const auto not_negative = [&](const char* member, double value)
    { require(value >= 0 && std::isfinite(value), member, "finite and not negative", value); };
    not_negative("solid.mass", link.solid.mass);
    not_negative("solid.moments.x", link.solid.moments.x());
    not_negative("solid.moments.y", link.solid.moments.y());
    not_negative("solid.moments.z", link.solid.moments.z());
    not_negative("stiffness", link.stiffness);
    not_negative("damping", link.damping);
    check_finite(name + "rest", link.rest);
    const bool sprung = link.stiffness != 0 || link.damping != 0;
    const bool one = sizes_of(link.joint).velocities == 1;
    require(one || !sprung, "stiffness", "zero but in a hinge or a slider", link.stiffness);
  }
  return links;
}

/// Throws InvalidShape unless a vector has this many numbers, all finite.
template <class Numbers>
void check_numbers(const std::string& member, const Numbers& is, Eigen::Index size)
{
  if (is.size() != size)
  {
    throw InvalidShape(member + ".size()", std::to_string(size), std::to_string(is.size()));
  }
  for (Eigen::Index i = 0; i < size; ++i)
  {
    if (!std::isfinite(is[i]))
    {
      throw InvalidShape(member + "[" + std::to_string(i) + "]", "finite", text_of(is[i]));
    }
  }
}

/// The state itself, or InvalidShape: it fits the links, and all its numbers are finite.
inline const TreeState& checked(const TreeState& state, const std::vector<Link>& links)
{
  const auto [positions, velocities] = sizes_of(links);
  check_numbers("positions", state.positions, positions);
  check_numbers("velocities", state.velocities, velocities);
  return state;
}
// [checked_links]

} // namespace cookbook
