#pragma once

/// \file
/// \brief How augmented vertex block descent is run, and what it remembers from step to step.

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [avbd_settings]
/// How augmented vertex block descent is run.
struct AvbdSettings
{
  int iterations = 10; ///< passes over all bodies
  double stabilization =
      0.95;            ///< [1], α: of an error that is there already, what is left for later
  double growth = 1e4; ///< [N/m²], β: by which stiffness grows for each metre of error
  double decay = 0.99; ///< [1], γ: what stays of stiffness from step to step; of the push α γ
  double least = 1;    ///< [N/m], stiffness at first
  double most = 1e9;   ///< [N/m], stiffness at last
};

/// What a constraint remembers from step to step.
struct AvbdMemory
{
  double push = 0;      ///< [N], λ
  double stiffness = 1; ///< [N/m], k
};

/// With what it begins a step.
inline AvbdMemory warm_start(const AvbdMemory& before, const AvbdSettings& settings)
{
  return {
      settings.stabilization * settings.decay * before.push,
      std::max(settings.least, settings.decay * before.stiffness)};
}

/// After a pass that leaves an error [m]: the push takes over what the spring bears, and the spring
/// grows stiffer by what it left; R69.
inline void update(AvbdMemory& memory, double error, const AvbdSettings& settings)
{
  memory.push -= memory.stiffness * error;
  memory.stiffness = std::min(settings.most, memory.stiffness + settings.growth * std::abs(error));
}
// [avbd_settings]

} // namespace cookbook
