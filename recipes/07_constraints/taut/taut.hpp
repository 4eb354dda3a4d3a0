#pragma once

/// \file
/// \brief What is known of taut chains: how many solves one needs, and how a bridge of planks
/// hangs.

#include "common/math/vector.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace cookbook
{

// [tension_limit]
/// A link of a chain, pulled at both ends.
struct TautLink
{
  double pull;    ///< [N], zero or more
  double length;  ///< [m], from joint to joint
  double inertia; ///< [kg m²], about its centre, across the chain; greater than zero
};

/// How fast [rad/s] it swings where each link swings against the next; R63.
inline double zigzag_rate(const TautLink& link)
{
  return std::sqrt(link.pull * link.length / link.inertia);
}

/// Above how many solves a step [s] the link is stable; R63.
inline double tension_limit(const TautLink& link, double step)
{
  return step / 2 * zigzag_rate(link);
}
// [tension_limit]

// [hanging_bridge]
/// A bridge of an even number of planks between two hooks of the same height.
struct HangingBridge
{
  int planks = 30;
  double length = 0.5;  ///< [m], of a plank
  double weight = 9.81; ///< [N], of a plank
  double load = 0;      ///< [N], at the middle
  double span = 14;     ///< [m], between the hooks; less than all planks together
};

/// The planks of one half, from the middle outwards, where the hooks pull so hard [N] along the
/// span: the cosine and the sine by which each rises; R65.
inline std::vector<Vector2<double>> half_bridge(const HangingBridge& bridge, double pull)
{
  std::vector<Vector2<double>> planks;
  for (int i = 1; i <= bridge.planks / 2; ++i)
  {
    const double carried = bridge.load / 2 + (i - 0.5) * bridge.weight;
    planks.push_back(Vector2<double>(pull, carried).normalized());
  }
  return planks;
}

/// The same where the planks reach across the span; std::invalid_argument where they cannot.
inline std::vector<Vector2<double>> half_bridge(const HangingBridge& bridge)
{
  if (!(bridge.span > 0 && bridge.span < bridge.planks * bridge.length))
  {
    throw std::invalid_argument("bridge: span is not between zero and the length of all planks");
  }
  double low = 0, high = 1;
  const auto reaches = [&](double pull)
  {
    double sum = 0;
    for (const Vector2<double>& plank : half_bridge(bridge, pull))
    {
      sum += bridge.length * plank.x();
    }
    return sum >= bridge.span / 2;
  };
  while (!reaches(high) && std::isfinite(high))
  {
    high *= 2;
  }
  for (int round = 0; round < 80; ++round)
  {
    const double middle = (low + high) / 2;
    (reaches(middle) ? high : low) = middle;
  }
  return half_bridge(bridge, high);
}

/// How far [m] the middle of a bridge hangs below its hooks.
inline double sag_of(const HangingBridge& bridge)
{
  double sag = 0;
  for (const Vector2<double>& plank : half_bridge(bridge))
  {
    sag += bridge.length * plank.y();
  }
  return sag;
}
// [hanging_bridge]

} // namespace cookbook
