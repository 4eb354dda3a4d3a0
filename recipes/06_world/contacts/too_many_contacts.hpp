#pragma once

/// \file
/// \brief What a scene is answered with in which bodies are all in one place.

#include <cstddef>
#include <stdexcept>
#include <string>

namespace cookbook
{

/// What a scene with too many overlaps is answered with.
class TooManyContacts : public std::runtime_error
{
public:
  /// Says how many bodies there are, and how many pairs of them were counted.
  TooManyContacts(std::size_t bodies, std::size_t pairs)
      : std::runtime_error(std::to_string(bodies)
                               .append(" bodies overlap in more than ")
                               .append(std::to_string(pairs))
                               .append(" pairs: place them apart"))
  {
  }
};

} // namespace cookbook
