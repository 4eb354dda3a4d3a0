#pragma once

/// \file
/// \brief Pairs of boxes at which one method or another fails, with the right answers.

#include "01_math/rotations/euler_angles.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "common/math/rotation.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// The numbers in which a pair is handed to a method.
enum class BoxNumbers
{
  in_double,       ///< as they are
  in_float,        ///< the world's coordinates rounded to float
  in_float_from_a, ///< the offset from A's centre, subtracted in double, rounded to float
};

/// A pair of boxes and the right answer for it.
struct BoxCase
{
  std::string id;                             ///< as in [case:G1]
  std::string scene;                          ///< one line
  Obb<double> a;                              ///< box A
  Obb<double> b;                              ///< box B
  double depth;                               ///< [m], negative where the boxes are apart
  Vector3<double> normal;                     ///< [1], zero where more than one is right
  std::vector<Vector3<double>> contacts;      ///< [m], world; none where any will do
  double tolerance = 1e-6;                    ///< [m] and, for the normal, [1]: far above rounding
  BoxNumbers numbers = BoxNumbers::in_double; ///< what a method is given
  bool features = false; ///< whether each contact must tell what meets there, all of them different
};

/// By which id a table knows a pair; a neighbour such as G9b has none of its own.
inline std::string id_in_tables(const BoxCase& pair)
{
  return pair.id.back() == 'b' ? "" : pair.id;
}

/// The rotation by an angle [rad] about a line.
inline Matrix3<double> turned(double angle, const Vector3<double>& about)
{
  return rotation_about(about, angle);
}

/// A box with its axes along the world's.
inline Obb<double> upright(const Vector3<double>& center, const Vector3<double>& half_extents)
{
  return {center, Matrix3<double>::Identity(), half_extents};
}

/// The four points (±x, y, ±z).
inline std::vector<Vector3<double>> rectangle(double x, double y, double z)
{
  return {{x, y, z}, {x, y, -z}, {-x, y, z}, {-x, y, -z}};
}

/// A box turned about the origin.
inline Obb<double> placed(const Obb<double>& box, const Matrix3<double>& rotation)
{
  return {rotation * box.center, rotation * box.axes, box.half_extents};
}

/// Cases in which a face of one box decides.
inline std::vector<BoxCase> face_cases()
{
  const Vector3<double> one(1, 1, 1), up(0, 1, 0);
  const Obb<double> cube = upright({0, 0, 0}, one);
  const double quarter = std::atan(1.0);
  const Matrix3<double> slope = turned(quarter * 2 / 3, {0, 0, 1});
  const auto on_slope = [&](double x, double z) -> Vector3<double>
  { return slope * Vector3<double>(x, 0.425, z); };
  return {
      {"G3", "a cube sunk through a plate", upright({0, 0, 0}, {5, 0.1, 5}),
       upright({0, 0.5, 0}, one), 0.6, up, rectangle(1, -0.2, 1)},
      {"G4",
       "a small box inside a large one",
       upright({0, 0, 0}, {10, 10, 10}),
       upright({9.8, 0, 0}, {0.1, 0.1, 0.1}),
       0.3,
       {1, 0, 0},
       {{9.85, 0.1, 0.1}, {9.85, 0.1, -0.1}, {9.85, -0.1, 0.1}, {9.85, -0.1, -0.1}}},
      {"G5", "two equal boxes in one place", cube, cube, 2, {0, 0, 0}, {}},
      {"G6", "two cubes that touch", cube, upright({0, 2, 0}, one), 0, up, rectangle(1, 1, 1)},
      {"G7", "two cubes, one on the other", cube, upright({0, 1.9, 0}, one), 0.1, up,
       rectangle(1, 0.95, 1)},
      {"G8", "two crossed beams", upright({0, 0, 0}, {2, 0.1, 0.1}),
       upright({0, 0.19, 0}, {0.1, 0.1, 2}), 0.01, up, rectangle(0.1, 0.095, 0.1)},
      {"G15",
       "two cubes, one behind the other",
       cube,
       upright({0, 0, 1.9}, one),
       0.1,
       {0, 0, 1},
       {{1, 1, 0.95}, {1, -1, 0.95}, {-1, 1, 0.95}, {-1, -1, 0.95}}},
      {"G16",
       "a cube on its corner",
       cube,
       {{0, 1 + std::sqrt(3.0) - 0.05, 0}, turned(std::atan(std::sqrt(2.0)), {-1, 0, 1}), one},
       0.05,
       up,
       {{0, 0.975, 0}}},
      {"X09",
       "a cube on a slope of 30°",
       {{0, 0, 0}, slope, {2, 0.5, 1}},
       {slope * Vector3<double>(0.3, 0.85, 0), slope, {0.5, 0.5, 0.5}},
       0.15,
       {-0.5, std::sqrt(0.75), 0},
       {on_slope(-0.2, 0.5), on_slope(-0.2, -0.5), on_slope(0.8, 0.5), on_slope(0.8, -0.5)}}};
}

/// Cases in which a pair of edges decides, or seems to.
inline std::vector<BoxCase> edge_cases()
{
  const Vector3<double> one(1, 1, 1), half(0.5, 0.5, 0.5), about(1, 2, 3);
  const double quarter = std::atan(1.0);
  const Matrix3<double> anyhow = rational_rotation<double>(1, 2, 3, 3);
  std::vector<Vector3<double>> contacts;
  for (const Vector3<double>& corner : rectangle(0.5, 0.4995, 0.5))
  {
    contacts.push_back(anyhow * corner);
  }
  return {
      {"G1",
       "two cubes edge to edge, apart",
       upright({0, 0, 0}, one),
       {{2.25, 2.25, 0}, turned(quarter, {-1, 1, 0}), one},
       -1,
       {0, 0, 0},
       {}},
      {"G2",
       "two roof ridges crossed",
       {{0, 0, 0}, turned(quarter, {1, 0, 0}), one},
       {{0, std::sqrt(8.0) - 0.01, 0}, turned(quarter, {0, 0, 1}), one},
       0.01,
       {0, 1, 0},
       {{0, std::sqrt(2.0) - 0.005, 0}}},
      {"G9",
       "a stack tilted by 0.01",
       upright({0, 0, 0}, half),
       {{0, 0.999, 0}, turned(1e-2, about), half},
       0.0063166,
       {0, 0, 0},
       {}},
      {"G9b", "a stack turned by 1e-14 about its height", placed(upright({0, 0, 0}, half), anyhow),
       placed({{0, 0.999, 0}, turned(1e-14, {0, 1, 0}), half}, anyhow), 0.001, anyhow.col(1),
       contacts}};
}

/// All pairs.
inline std::vector<BoxCase> box_cases()
{
  std::vector<BoxCase> cases = edge_cases();
  for (const BoxCase& face_case : face_cases())
  {
    cases.push_back(face_case);
  }
  return cases;
}

} // namespace cookbook
