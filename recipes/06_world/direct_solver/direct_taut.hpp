#pragma once

/// \file
/// \brief Taut joints in the direct solver: how fast they swing bodies, and steps that damp it.

#include "06_world/constraints/taut_pull.hpp"
#include "06_world/direct_solver/direct_system.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [direct_taut]
/// Calls `call(body, stiffness)` for what each joint does to each of its bodies at the impulses of
/// an answer in a step [s]: their numbers in the island, and taut_stiffness().
template <class Call>
void each_taut(const DirectSystem& system, double step, const Call& call)
{
  for (std::size_t i = 0; i < system.rows.size();)
  {
    const DirectRow& first = system.rows[i];
    TautPull on_a, on_b;
    for (; i < system.rows.size() && system.rows[i].of == first.of; ++i)
    {
      on_a.add(system.rows[i].on_a, system.rows[i].impulse);
      on_b.add(system.rows[i].on_b, system.rows[i].impulse);
    }
    if (first.a >= 0)
    {
      call(index_of(first.a), taut_stiffness(on_a, step));
    }
    if (first.b >= 0)
    {
      call(index_of(first.b), taut_stiffness(on_b, step));
    }
  }
}

/// The largest square of ω h [1] of any body of the island, R63.
inline double largest_squared_swing(const DirectSystem& system, double step)
{
  std::vector<double> squared(system.bodies.size());
  each_taut(
      system, step,
      [&](std::size_t body, const Matrix3<double>& stiffness)
      { squared[body] += squared_swing(stiffness, system.bodies[body].inertia.inverse()); });
  return squared.empty() ? 0 : *std::max_element(squared.begin(), squared.end());
}

/// Has the island swing implicitly, by the stiffness of its answer: (I + h² K) ω takes the place of
/// I ω; R64.
inline void stiffen(DirectSystem& system, double step)
{
  system.taut.assign(system.bodies.size(), Matrix3<double>::Zero());
  each_taut(
      system, step,
      [&](std::size_t body, const Matrix3<double>& stiffness) { system.taut[body] += stiffness; });
}
// [direct_taut]

} // namespace cookbook
