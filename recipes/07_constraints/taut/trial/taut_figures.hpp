#pragma once

/// \file
/// \brief The figures of taut chains: one that swings, and a bridge beside its closed form.

#include "07_constraints/taut/trial/taut_run.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/table.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// Where the joints of the first set of a world are, and last the centre of the last body.
inline std::vector<Eigen::Vector2d> joints_of(GameWorld& world)
{
  std::vector<Eigen::Vector2d> points;
  const BallJoints& joints = world.constraints<BallJoints>(0);
  for (std::size_t i = 0; i < joints.size(); ++i)
  {
    const RigidBody& a = world.bodies()[static_cast<std::size_t>(joints[i].a)];
    const Vector3<double> at = a.motion.center + a.orientation * joints[i].anchor_a;
    points.push_back(at.head<2>());
  }
  return points;
}

/// A chain with 1,000 kg, let go level, every quarter of a second.
inline plot::Figure2d chain_figure()
{
  plot::Figure2d figure("taut", "", {{-1, 8.8}, {11.6, 20.8}, 640});
  figure.describe("A chain of 20 links with 1,000 kg at its end, let go level: it stays straight "
                  "and as long as "
                  "it was while it swings down.");
  GameWorld world = world_of(TrialChain{.load = 1000, .towards = {1, 0}});
  for (int frame = 0; frame <= 105; ++frame)
  {
    if (frame % 15 == 0)
    {
      const std::vector<Eigen::Vector2d> points = joints_of(world);
      figure.polyline(points, plot::Ink::a, plot::Stroke::solid, 1.6);
      figure.dot(points.back(), plot::Ink::b);
      figure.label(points.back(), number(frame / 60.0) + " s", plot::Side::right, plot::Ink::ink);
    }
    world.step();
  }
  return figure.point({0, 20}, plot::Ink::ink, "hook", plot::Side::above);
}

/// The bridge with 50 kg, as its joints are 15 s later, over the closed form.
inline plot::Figure2d bridge_figure()
{
  plot::Figure2d figure("taut_bridge", "", {{-8, 16.2}, {8, 20.6}, 640});
  figure.describe(
      "A bridge of 30 planks with 50 kg at its middle: its joints lie on the closed form.");
  const HangingBridge bridge{.load = 50 * 9.81};
  std::vector<Eigen::Vector2d> right{{0, 20 - sag_of(bridge)}};
  for (const Vector2<double>& plank : half_bridge(bridge))
  {
    const Eigen::Vector2d at = right.back() + bridge.length * Eigen::Vector2d(plank);
    right.push_back(at);
    right.insert(right.begin(), {-at.x(), at.y()});
  }
  figure.polyline(right, plot::Ink::b, plot::Stroke::solid, 1.6);
  GameWorld world = world_of(bridge);
  for (int frame = 0; frame < 900; ++frame)
  {
    world.step();
  }
  for (const Eigen::Vector2d& at : joints_of(world))
  {
    figure.dot(at, plot::Ink::a);
  }
  figure.label({-4, 18.6}, "dots: simulated", plot::Side::below, plot::Ink::a);
  figure.label({4, 18.6}, "line: closed form", plot::Side::below, plot::Ink::b);
  return figure.label({0, 20 - sag_of(bridge)}, "50 kg", plot::Side::below, plot::Ink::ink);
}

} // namespace cookbook
