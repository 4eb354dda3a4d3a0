#pragma once

/// \file
/// \brief The names of what collision.hpp tells, as programs and figures write them.

#include "03_sphere_manifolds/collision/collision.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <string>

namespace cookbook
{

/// The name of a nature.
inline const char* name_of(Nature nature)
{
  const char* const names[] = {"separated", "colliding", "penetrating"};
  return names[static_cast<int>(nature)];
}

/// The name of an approach.
inline const char* name_of(Approach approach)
{
  const char* const names[] = {"approaching", "resting", "separating"};
  return names[static_cast<int>(approach)];
}

/// What an overlap [m] is after a move that was to end it; negative for a gap.
inline std::string left_after_move(double overlap)
{
  const double rounded = std::round(overlap * 1e6) * 1e-6;
  return rounded > 0   ? "still " + number(rounded) + " m deep"
         : rounded < 0 ? "a gap of " + number(-rounded) + " m"
                       : "they touch";
}

} // namespace cookbook
