#pragma once

/// \file
/// \brief A chain of equal links that hangs from the world, with a load at its end, or without.

#include "07_constraints/articulated/links.hpp"

namespace cookbook
{

// [hanging_chain]
/// A chain of boxes, each on the end of the one above.
struct HangingChain
{
  int links = 20;
  double mass = 1;                              ///< [kg], of a link
  Vector3<double> half_extents{0.1, 0.25, 0.1}; ///< [m], of a link; it hangs along its y axis
  double load = 0;                              ///< [kg], a cube at the end; zero for none
  double load_half_extent = 0.25;               ///< [m]
  JointType joint = JointType::hinge;           ///< about z, or a ball
  Vector3<double> hook{0, 0, 0};                ///< [m], in the frame of what it hangs on
};

/// A tree of links and a chain that hangs straight down from one of them, or from the world, -1,
/// where all joints are at zero; the load is one link more. InvalidShape if the chain has less than
/// no links. The hook is in that link's frame.
inline std::vector<Link> with_chain(std::vector<Link> links, int parent, const HangingChain& chain)
{
  if (chain.links < 0)
  {
    throw InvalidShape("links", "not negative", std::to_string(chain.links));
  }
  Vector3<double> above = chain.hook;
  const auto hang = [&](double mass, const Vector3<double>& half)
  {
    const Vector3<double> top(0, half.y(), 0);
    links.push_back(
        {.parent = parent,
         .joint = chain.joint,
         .solid = solid_box<double>(mass, half),
         .anchor_parent = above,
         .anchor_child = top});
    parent = static_cast<int>(links.size()) - 1;
    above = -top;
  };
  for (int i = 0; i < chain.links; ++i)
  {
    hang(chain.mass, chain.half_extents);
  }
  if (chain.load > 0)
  {
    hang(chain.load, Vector3<double>::Constant(chain.load_half_extent));
  }
  return links;
}

/// A chain alone, on a hook of the world.
inline std::vector<Link> chain_links(const HangingChain& chain)
{
  return with_chain({}, -1, chain);
}
// [hanging_chain]

} // namespace cookbook
