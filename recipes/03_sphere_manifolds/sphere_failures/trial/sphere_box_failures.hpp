#pragma once

/// \file
/// \brief The cases that break methods for a sphere and a box.

#include "03_sphere_manifolds/sphere_failures/trial/sphere_box_methods.hpp"
#include "03_sphere_manifolds/sphere_failures/trial/sphere_verdicts.hpp"

#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

/// A sphere and a box, and what is right of them.
struct SphereBoxCase
{
  std::string id;       ///< in the book
  std::string what;     ///< the set-up, in a few words
  Sphere<float> sphere; ///< A
  Obb<float> box;       ///< B
  Right right;          ///< the answer
};

/// The cases of a sphere and a box. The normal points from the sphere into the box.
inline std::vector<SphereBoxCase> box_cases()
{
  const Vector3<double> down(0, -1, 0);
  const auto upright = [](float x, float y, float z) {
    return Obb<float>{{0, 0, 0}, Matrix3<float>::Identity(), {x, y, z}};
  };
  const Obb<float> plate = upright(10, 0.5f, 10), cube = upright(1, 1, 1);
  Matrix3<float> axes;
  axes << 0.8f, -0.6f, 0, 0.6f, 0.8f, 0, 0, 0, 1;
  return {
      {"D1", "plate, centre 0.05 below its top", {{9, 0.45f, 0}, 0.1f}, plate, {0.15, down, 1e-6}},
      {"X05", "plate, centre 0.25 below its top", {{3, 0.25f, 0}, 0.1f}, plate, {0.35, down, 1e-6}},
      {"D2", "plate, centre in its centre", {{0, 0, 0}, 0.1f}, plate, {0.6, down, 1e-6}},
      {"X07", "cube, centre in its centre", {{0, 0, 0}, 0.1f}, cube, {1.1, {-1, 0, 0}, 1e-6}},
      {"D3",
       "plate, centre 0.001 above its top",
       {{9, 0.501f, 0}, 0.1f},
       plate,
       {0.099, down, 1e-6}},
      {"X06",
       "plate, centre 0.0002 above its top",
       {{9, 0.5002f, 0}, 0.1f},
       plate,
       {0.0998, down, 1e-6}},
      {"D4", "cube, centre on its corner", {{1, 1, 1}, 1}, cube, {1, {0, 0, 0}, 1e-6}},
      {"",
       "oriented box, centre on its face but for rounding",
       {{3.6f, 2.95f, 3}, 0.5f},
       {{4, 2, 3}, axes, {2, 1, 1}},
       {0.5, {0.6, -0.8, 0}, 1e-6}},
      {"D5",
       "box of 100 m, centre 0.5 below its top",
       {{0, 49.5f, 0}, 0.5f},
       upright(50, 50, 50),
       {1, down, 1e-5}},
      {"D9",
       "thin box, centre 0.01 below its top",
       {{0, 0.24f, 0}, 0.005f},
       upright(0.5f, 0.25f, 0.5f),
       {0.015, down, 1e-6}},
      {"D8",
       "beam of 20 m, centre 4 above its top",
       {{0, 5, 0}, 0.5f},
       upright(10, 1, 1),
       {-3.5, down, 1e-6}},
      {"X28",
       "beam of 20 m, centre 4 beside it",
       {{0, 0, -5}, 0.5f},
       upright(10, 1, 1),
       {-3.5, down, 1e-6}}};
}

/// The names of the methods.
inline std::vector<std::string> box_method_names()
{
  return {
      "as published", "published, upright", "outside formula only", "plain_sphere_box",
      "sphere_box"};
}

/// What each method answers, in the order of their names.
inline std::vector<std::optional<Found>>
box_answers(const Sphere<float>& sphere, const Obb<float>& box)
{
  return {
      found(sphere_box_as_published(sphere, box)), found(sphere_box_mixed_bounds(sphere, box)),
      found(sphere_box_outside_only(sphere, box)), found(plain_sphere_box(sphere, box)),
      found(sphere_box(sphere, box))};
}

/// The verdicts on all methods, case by case.
inline std::vector<VerdictRow> box_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const SphereBoxCase& one : box_cases())
  {
    rows.push_back(
        {one.id, one.what, verdicts_of(box_answers(one.sphere, one.box), one.right),
         right_value(one.right)});
  }
  return rows;
}

} // namespace cookbook
