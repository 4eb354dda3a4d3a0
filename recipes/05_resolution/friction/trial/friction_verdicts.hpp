#pragma once

/// \file
/// \brief The verdicts on rules of friction, against closed forms.

#include "05_resolution/friction/trial/friction_cases.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// A number for a table: rounding errors below a ten-thousandth are none.
inline std::string friction_number(double value)
{
  return number(std::round(value * 1e4) / 1e4);
}

/// Whether a value is what it should be, to a fraction of that.
inline bool is_about(double value, double right, double share)
{
  return std::abs(value - right) <= share * right;
}

/// A case of friction and its oracle.
struct FrictionCase
{
  std::string id;                                     ///< in the book, or empty
  std::string what;                                   ///< in a few words
  std::function<Verdict(const FrictionRule&)> judged; ///< of a rule
};

/// On a slope for 10 s: holds to a millimetre, or slides the way [m] that it should to 1 %.
inline Verdict
on_slope_for_10_s(const OneContactScene& scene, const FrictionRule& rule, double right)
{
  const double moved = way(advanced(scene, rule, 10));
  const bool holds = right == 0 ? moved <= 1e-3 : is_about(moved, right, 0.01);
  std::string text = moved <= 1e-3 ? "holds" : "slides ";
  return {holds, moved <= 1e-3 ? text : text.append(friction_number(moved)).append(" m")};
}

/// S11: twice what it gains from 0.5 s to 1 s is the acceleration.
inline Verdict accelerates(const FrictionRule& rule)
{
  const OneContactScene early = advanced(cube_on_slope(0.5, 30), rule, 0.5);
  const OneContactScene late = advanced(early, rule, 0.5);
  const double gained = 2 * (mover(late).velocity.norm() - mover(early).velocity.norm());
  return {is_about(gained, 0.65715, 0.01), friction_number(gained) + " m/s²"};
}

/// S12: box and balls.
inline Verdict carries_balls(const FrictionRule& rule)
{
  const auto [box, ball] = accelerations(rule);
  std::string text = friction_number(box);
  return {
      is_about(box, 0.7385, 0.02) && is_about(ball, 0.211, 0.02),
      text.append(", ").append(friction_number(ball)).append(" m/s²")};
}

/// S13: every heading.
inline Verdict stops(const FrictionRule& rule)
{
  const auto [shortest, longest] = stopping_ways(rule);
  std::string text = friction_number(shortest);
  return {
      is_about(shortest, 3.1855, 0.01) && is_about(longest, 3.1855, 0.01),
      text.append(" to ").append(friction_number(longest)).append(" m")};
}

/// S28: when it rolls, and how fast.
inline Verdict rolls(const OneContactScene& scene, const FrictionRule& rule)
{
  const Rolling rolling = begins_to_roll(scene, rule, 5);
  const bool holds = is_about(rolling.time, 1.0194, 0.01) && is_about(rolling.speed, 5, 0.01);
  if (rolling.slip > 1e-3)
  {
    std::string text = "still slips by ";
    return {holds, text.append(friction_number(rolling.slip)).append(" m/s after 5 s")};
  }
  std::string text = rolling.speed < 1e-3 ? "stops" : friction_number(rolling.speed) + " m/s";
  return {holds, text.append(" after ").append(friction_number(rolling.time)).append(" s")};
}

/// R28: whether a box half as wide as high still stands after 10 s.
inline Verdict topples(const FrictionRule& rule, double slope, bool should)
{
  const OneContactScene late = advanced(on_slope({0.25, 0.5, 0.25}, 1, slope), rule, 10);
  const bool fell = (late.solids[1].turned * Vector3<double>::UnitY()).y() < 0.5;
  const bool slid = !fell && way(late) > 1e-3;
  std::string text = slid ? "slides " : fell ? "topples" : "stands";
  return {fell == should && !slid, slid ? text.append(friction_number(way(late))) + " m" : text};
}

/// All cases, in the order of the table.
inline std::vector<FrictionCase> friction_cases()
{
  using Rule = FrictionRule;
  const auto slope = [](double friction, double degrees, double towards, double right)
  {
    const OneContactScene scene = cube_on_slope(friction, degrees, towards);
    return [=](const Rule& rule) { return on_slope_for_10_s(scene, rule, right); };
  };
  OneContactScene no_spin = sliding_ball();
  no_spin.solids[1].body.inverse_inertia.setZero();
  // By hand: half of g (sin 31.1° − 0.6 cos 31.1°), times 10² s².
  const double slid = 1.3600;
  return {
      {"S9", "slope of 10°, μ = 0.6: holds", slope(0.6, 10, 0, 0)},
      {"S10", "slope of 30.9°, μ = 0.6: holds", slope(0.6, 30.9, 0, 0)},
      {"", "31.1°: slides 1.36 m in 10 s", slope(0.6, 31.1, 0, slid)},
      {"", "31.1°, down the diagonal: the same", slope(0.6, 31.1, 45, slid)},
      {"S11", "30°, μ = 0.5: 0.6571 m/s²", accelerates},
      {"", "box twice as high as wide, 26.4°: stands",
       [](const Rule& rule) { return topples(rule, 26.4, false); }},
      {"", "the same, 26.7°: topples", [](const Rule& rule) { return topples(rule, 26.7, true); }},
      {"S12", "box under 25 balls: 0.7385, 0.211 m/s²", carries_balls},
      {"S13", "5 m/s, μ = 0.4, any heading: 3.186 m", stops},
      {"S28", "ball at 7 m/s, μ = 0.2: rolls at 5 m/s after 1.019 s",
       [](const Rule& rule) { return rolls(sliding_ball(), rule); }},
      {"", "the same, spin left out", [=](const Rule& rule) { return rolls(no_spin, rule); }}};
}

/// The verdicts: a row for each case, a column for each rule.
inline std::vector<VerdictRow> friction_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const FrictionCase& one : friction_cases())
  {
    rows.push_back({one.id, one.what, {}});
    for (const FrictionRule& rule : friction_rules())
    {
      rows.back().verdicts.push_back(one.judged(rule));
    }
  }
  return rows;
}

} // namespace cookbook
