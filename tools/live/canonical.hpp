#pragma once

#include <cstdio>
#include <cstdlib>

namespace cookbook::live
{

/// A value as it is written in events and links: with six significant digits, so that what is
/// dragged, read from a link and replayed is the same number.
inline double canonical(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value + 0.0);
  return std::strtod(text, nullptr);
}

} // namespace cookbook::live
