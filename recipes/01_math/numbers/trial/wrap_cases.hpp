#pragma once

/// \file
/// \brief Ways to wrap an angle, and the angles that break them.

#include "01_math/numbers/wrap_angle.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

// [wrap_loop]
/// Takes turns off one by one, as the seed book's published code does; NaN where ten million are
/// not enough, for the published loop would go on for ever.
inline float wrap_loop(float degrees)
{
  for (int turns = 0; turns < 10000000; ++turns)
  {
    if (std::abs(degrees) <= 360)
    {
      return degrees;
    }
    degrees += degrees > 0 ? -360.0f : 360.0f;
  }
  return std::numeric_limits<float>::quiet_NaN();
}
// [wrap_loop]

/// Takes all turns off at once, rounded twice.
inline float wrap_floor(float degrees)
{
  return degrees - 360 * std::floor(degrees / 360 + 0.5f);
}

/// A way to wrap an angle in degrees, by name.
struct WrapMethod
{
  std::string name;     ///< as on the page
  float (*wrap)(float); ///< the way
};

/// The ways that compete, the recommended one last.
inline std::array<WrapMethod, 4> wrap_methods()
{
  return {
      {{"loop, as published", wrap_loop},
       {"floor", wrap_floor},
       {"remainder", [](float x) { return std::remainder(x, 360.0f); }},
       {"wrap_degrees", wrap_degrees<float>}}};
}

/// An angle, and the same direction within half a turn, found by hand; NaN where there is none.
struct WrapCase
{
  std::string id;   ///< in the book; empty for a neighbour of the case above
  std::string what; ///< the angle, as text
  float degrees;    ///< the angle
  float right;      ///< the same direction
};

/// The angles to try.
inline std::vector<WrapCase> wrap_cases()
{
  const float infinite = std::numeric_limits<float>::infinity(), none = infinite - infinite;
  return {
      {"", "540°", 540, 180},
      {"", "−7200.5°", -7200.5f, -0.5f},
      {"", "1e6 + 0.0625°", 1000000.0625f, -79.9375f},
      {"", "1e9°", 1e9f, -80},
      {"A7", "1e10°", 1e10f, -80},
      {"", "1e38°", 1e38f, 128},
      {"", "infinite", infinite, none}};
}

/// Whether two angles within a turn are one direction: equal, or a whole turn apart, exactly.
inline bool same_direction(float a, float b)
{
  const double apart = std::abs(static_cast<double>(a) - b);
  return std::abs(a) <= 360 && (apart == 0 || apart == 360);
}

/// The verdicts on all ways to wrap, angle by angle.
inline std::vector<VerdictRow> wrap_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const WrapCase& one : wrap_cases())
  {
    const bool known = !std::isnan(one.right);
    rows.push_back(
        {one.id, one.what, {}, known ? number(static_cast<double>(one.right)) + "°" : "none"});
    for (const WrapMethod& method : wrap_methods())
    {
      const float answer = method.wrap(one.degrees);
      const bool loops = std::isnan(answer) && method.name == wrap_methods()[0].name;
      const bool flagged = std::isnan(answer) && std::isnan(one.right) && !loops;
      const bool right = flagged || same_direction(answer, one.right);
      const std::string what = loops     ? "never ends"
                               : flagged ? "NaN: no direction"
                               : right   ? "right"
                                         : "says " + number(static_cast<double>(answer));
      rows.back().verdicts.push_back({right, what});
    }
  }
  return rows;
}

} // namespace cookbook
