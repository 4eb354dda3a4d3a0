#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace cookbook::live
{

/// A value as it is written in events and links: with six significant digits.
inline std::string written(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value + 0.0);
  return text;
}

/// The number that is written, so that what is dragged, read from a link and replayed is the same.
inline double canonical(double value)
{
  return std::strtod(written(value).c_str(), nullptr);
}

} // namespace cookbook::live
