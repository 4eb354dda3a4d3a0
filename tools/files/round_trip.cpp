/// \file
/// \brief Writes the shortest digits that tell a number from its neighbours.

#include "tools/files/round_trip.hpp"

#include <charconv>

namespace cookbook
{

namespace
{

template <class Real>
std::string shortest(Real value)
{
  char text[64];
  const std::to_chars_result result =
      std::to_chars(text, text + sizeof text, value == Real(0) ? Real(0) : value);
  return std::string(text, result.ptr);
}

} // namespace

std::string round_trip(double value)
{
  return shortest(value);
}
std::string round_trip(float value)
{
  return shortest(value);
}

} // namespace cookbook
