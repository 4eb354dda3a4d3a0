#pragma once

/// \file
/// \brief Contacts side by side in memory, and what is done to all of them: the same for registers
/// of every width.

#include "05_resolution/position_correction/position_correction.hpp"
#include "06_world/wide_solver/lane_body.hpp"

#include <cstddef>
#include <span>

namespace cookbook
{

// [wide_view]
/// Contacts of one colour, each in a lane of its own.
struct WideGroup
{
  std::size_t first;  ///< the place of its first points among all
  std::size_t points; ///< how many a lane has: the most of any
};

/// Groups of contacts, as they lie in memory: of each number those of all lanes side by side.
struct WideView
{
  std::span<const WideGroup> groups; ///< colour by colour
  const int* a;                      ///< for every lane of every group the place of body A
  const int* b;                      ///< and that of body B
  float* contacts;                   ///< for every group the numbers of a WideContact
  float* points;                     ///< for every place the numbers of a ContactConstraint
  LaneBody* bodies;                  ///< which they push
};

/// What is done to all points of a view, group by group.
struct WidePasses
{
  std::size_t lanes; ///< of a group

  /// Finds what impulses feel, with the bodies as they are turned now.
  void (*compute_masses)(const WideView& all);
  /// Pushes as the frame before, or the step before, has ended.
  void (*warm_start)(const WideView& all);
  /// Corrects each point once, with a spring, in a small step [s], the last time or not.
  void (*solve)(
      const WideView& all, const Softness<float>& spring, float substep, float elapsed, bool last);
  /// Carries gaps on by the speeds at which surfaces part, for a small step [s].
  void (*update_separations)(const WideView& all, float substep);
  /// Turns as many bodies as a register has doubles, each a TurningLane, for a time [s].
  void (*turn)(double* numbers, double time);
};
// [wide_view]

} // namespace cookbook
