#pragma once

/// \file
/// \brief Pairs of boxes that move and turn, with the time of their first touch known by hand.

#include "05_resolution/tunnelling/swept_box.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

/// Two boxes on their way, and when they first touch.
struct BoxSweep
{
  std::string id;             ///< in the book; empty for a neighbour of the case above it
  std::string what;           ///< in a few words
  SweptBox<double> a;         ///< A
  SweptBox<double> b;         ///< B
  double duration;            ///< [s], until time 1
  std::optional<double> time; ///< [s], of the first touch; nothing: they do not
};

/// A box that stands in the plane z = 0, turned by an angle [rad] about z.
inline SweptBox<double> standing(double x, double y, double angle, double width, double height)
{
  const Eigen::AngleAxis<double> turned(angle, Vector3<double>::UnitZ());
  const Vector3<double> half_extents(width, height, 1), zero(0, 0, 0);
  return {{{x, y, 0}, turned.toRotationMatrix(), half_extents}, zero, zero};
}

/// The same on its way in that plane.
inline SweptBox<double> moving(SweptBox<double> box, double x, double y, double rotation)
{
  box.displacement = {x, y, 0};
  box.rotation = {0, 0, rotation};
  return box;
}

/// A square of half extent 1 that flies at 1 m/s towards another box, 10 m away, for a time [s].
inline BoxSweep square_and_box(const std::string& id, const std::string& what, double duration)
{
  return {
      id,       what, moving(standing(0, 0, 0, 1, 1), duration, 0, 0), standing(10, 0, 0, 1, 1.5),
      duration, 8};
}

/// A rod of 4 m by 0.2 m that turns by 3 rad in a second, through a peg 1 m off its axle: the peg's
/// corner (0.1, 0.9) is in the rod's side when the rod has turned by atan(9) − atan(1/9).
inline BoxSweep rod_and_peg()
{
  return {
      "",
      "rod turns by 3 rad about its middle, peg 1 m off",
      moving(standing(0, 0, 0, 2, 0.1), 0, 0, 3),
      standing(0, 1, 0, 0.1, 0.1),
      1,
      std::atan(40.0 / 9) / 3};
}

/// All pairs.
inline std::vector<BoxSweep> box_sweeps()
{
  const SweptBox<double> plate = moving(
      standing(53.474274, -50.252514, 513.36676, 2.5, 2.5), 54.595478 - 53.474274,
      -51.083473 + 50.252514, 513.62781 - 513.36676);
  return {
      {"J5", "a square turns past a long box, 6.7 m away", standing(24, -60, 2.95, 25, 5), plate, 1,
       std::nullopt},
      square_and_box("J6", "square at a box 10 m away, 1 m/s, for 10 s", 10),
      square_and_box("", "the same for 30 s: right through it", 30),
      rod_and_peg()};
}

} // namespace cookbook
