#pragma once

/// \file
/// \brief Scenes of trees of links: random trees, swings and their energy, the tension limit.

#include "02_primitives/shapes/trial/number_draw.hpp"
#include "07_constraints/articulated/articulated.hpp"
#include "07_constraints/articulated/hanging_chain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cookbook
{

/// A rotation drawn from all.
inline Quaternion<double> drawn_turn(NumberDraw<double>& draw)
{
  const Vector3<double> vector = draw.in_cube(1);
  return Quaternion<double>(draw.between(-1, 1), vector.x(), vector.y(), vector.z()).normalized();
}

/// A tree of links with joints of all types, each on any link before it or on the world.
inline std::vector<Link> drawn_links(NumberDraw<double>& draw, int count)
{
  std::vector<Link> links;
  for (int i = 0; i < count; ++i)
  {
    Link link;
    link.parent = static_cast<int>(draw.between(0, i + 1)) - 1;
    link.joint = static_cast<JointType>(static_cast<int>(draw.between(0, 5)));
    const double mass = draw.between(0.1, 5);
    link.solid = solid_box<double>(mass, draw.in_box(0.1, 0.6));
    link.anchor_parent = draw.in_cube(1);
    link.anchor_child = draw.in_cube(1);
    link.axis = (draw.in_cube(1) + Vector3<double>(0, 0, 1.5)).normalized();
    link.frame = drawn_turn(draw);
    if (sizes_of(link.joint).velocities == 1)
    {
      link.stiffness = draw.between(0, 10);
      link.damping = draw.between(0, 1);
      link.rest = draw.between(-1, 1);
    }
    links.push_back(link);
  }
  return links;
}

/// Any state of these links.
inline TreeState drawn_state(NumberDraw<double>& draw, const std::vector<Link>& links)
{
  TreeState state = zero_state(links);
  for (double& number : state.positions.reshaped())
  {
    number = draw.between(-2, 2);
  }
  for (double& number : state.velocities.reshaped())
  {
    number = draw.between(-3, 3);
  }
  move_positions(links, state, 0); // makes quaternions units
  return state;
}

/// A way to step a tree.
using TreeStep = void (*)(ArticulatedBody&, TreeState&, double);

// [energy_kept]
/// A swing: its links, and its first joint's angle [rad] at the start, at rest.
struct SwingScene
{
  HangingChain chain;
  double angle;
};

/// What a swing's energy does, as fractions of the energy it swings with.
struct EnergyKept
{
  double off;  ///< at most, to either side
  double left; ///< at the end, less one
  double time; ///< [s], for which it was within a tenth
  bool holds;  ///< within a tenth all the time, and finite
};

/// Follows a swing for a time [s] with so many steps a second.
inline EnergyKept energy_kept(const SwingScene& scene, TreeStep step, double rate, double duration)
{
  ArticulatedBody tree(chain_links(scene.chain));
  TreeState state = zero_state(tree.links());
  const double lowest = balance_of(tree, state).energy;
  state.positions[0] = scene.angle;
  const double start = balance_of(tree, state).energy, swings_with = start - lowest;
  EnergyKept kept{0, 0, 0, true};
  for (int i = 0; i < duration * rate && kept.holds; ++i)
  {
    step(tree, state, 1 / rate);
    kept.left = (balance_of(tree, state).energy - start) / swings_with;
    kept.off = std::max(kept.off, std::abs(kept.left));
    kept.holds = kept.off <= 0.1;
    kept.time = (i + 1) / rate;
  }
  return kept;
}
// [energy_kept]

// [tension_limit]
/// The steps a frame of 1/60 s above which a link's zig-zag under a load is stable, by R53.
inline double steps_needed(const HangingChain& chain)
{
  const double pull = (chain.load + chain.links * chain.mass) * 9.81;
  const double length = 2 * chain.half_extents.y();
  const double moment = solid_box<double>(chain.mass, chain.half_extents).moments.z();
  return std::sqrt(pull * length / moment) / 120;
}

/// Whether a chain, nudged in its middle by 0.1 rad/s, still hangs after 2 s of so many steps a
/// frame: no link ever turns by 0.1 rad.
inline bool hangs_still(const HangingChain& chain, TreeStep step, int steps)
{
  ArticulatedBody tree(chain_links(chain));
  TreeState state = zero_state(tree.links());
  state.velocities[chain.links / 2] = 0.1;
  for (int i = 0; i < 120 * steps; ++i)
  {
    step(tree, state, 1 / (60.0 * steps));
    if (!(state.positions.cwiseAbs().maxCoeff() < 0.1))
    {
      return false;
    }
  }
  return true;
}
// [tension_limit]

} // namespace cookbook
