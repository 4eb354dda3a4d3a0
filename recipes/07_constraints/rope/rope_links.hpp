#pragma once

/// \file
/// \brief The check that particles are a rope: in a line, each joined to the next.

#include "07_constraints/particles/particles.hpp"

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

namespace cookbook
{

/// Throws std::invalid_argument unless constraint i joins particles i and i+1, as in a rope.
inline void check_rope(std::span<const DistanceConstraint> links)
{
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    if (links[i].a != i || links[i].b != i + 1)
    {
      throw std::invalid_argument(
          "constraints[" + std::to_string(i) + "] must join particles " + std::to_string(i) +
          " and " + std::to_string(i + 1) + " of a rope, got " + std::to_string(links[i].a) +
          " and " + std::to_string(links[i].b));
    }
  }
}

} // namespace cookbook
