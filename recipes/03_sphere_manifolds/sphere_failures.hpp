#pragma once

/// \file
/// \brief The cases that break ways to a sphere's manifold, and which ways survive them.

#include "03_sphere_manifolds/sphere_box_methods.hpp"
#include "03_sphere_manifolds/sphere_methods.hpp"
#include "03_sphere_manifolds/sphere_pairs.hpp"
#include "common/program/table.hpp"
#include "common/program/verdicts.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// A manifold by any method, in double.
struct Found
{
  Vector3<double> normal; ///< [1]
  double depth;           ///< [m]
};

/// What a method found, in double; nothing stays nothing.
template <class Real>
std::optional<Found> found(const std::optional<Manifold<Real>>& manifold)
{
  return manifold ? std::optional<Found>(
                        {manifold->normal.template cast<double>(), double(manifold->depth)})
                  : std::nullopt;
}

/// What is right, and how far from it an answer may be.
struct Right
{
  double depth;           ///< [m]; negative where the shapes are apart
  Vector3<double> normal; ///< [1], from A to B; zero where every unit vector is right
  double tolerance;       ///< [m] for the depth, and [rad] for the normal
};

// [verdict_of]
/// Whether an answer is right, and what to say of it.
inline Verdict verdict_of(const std::optional<Found>& answer, const Right& right)
{
  if (!answer)
  {
    return right.depth < 0 ? Verdict{true, "apart"} : Verdict{false, "no contact"};
  }
  if (!answer->normal.allFinite() || !std::isfinite(answer->depth))
  {
    return {false, "not a number"};
  }
  if (right.depth < 0)
  {
    return {false, "contact, " + number(answer->depth) + " deep"};
  }
  if (std::abs(answer->depth - right.depth) > right.tolerance)
  {
    return {false, "depth " + number(answer->depth)};
  }
  const double angle =
      std::atan2(answer->normal.cross(right.normal).norm(), answer->normal.dot(right.normal));
  if (!right.normal.isZero(0) && angle > right.tolerance)
  {
    return {false, "normal " + number(std::round(angle * 180 / 3.141592653589793)) + "° off"};
  }
  return {std::abs(answer->normal.norm() - 1) <= 1e-3, "holds"};
}
// [verdict_of]

// [sphere_cases]
/// Two spheres, what is right of them, and which methods survive: as published, float in the
/// world, float relative to A, 1/√x with two Newton steps, batch, double.
struct SphereCase
{
  std::string id;          ///< in the book
  std::string what;        ///< the set-up, in a few words
  Sphere<double> a;        ///< A
  Sphere<double> b;        ///< B
  Right right;             ///< the answer
  std::vector<bool> holds; ///< for each method
};

/// The cases of two spheres.
inline std::vector<SphereCase> sphere_cases()
{
  const Vector3<double> x(1, 0, 0);
  const Vector3<double> y(0, 1, 0);
  const auto at = [](double distance) { return Vector3<double>(distance, 0, 0); };
  const Vector3<double> far(1e6, 1e6, 1e6);
  const double tiny = 1e-23;
  return {
      {"C1",
       "unit spheres, 1.9 apart",
       {at(0), 1},
       {at(1.9), 1},
       {0.1, x, 1e-6},
       {false, true, true, true, true, true}},
      {"X01",
       "radii 0.5, 0.6 apart",
       {at(0), 0.5},
       {at(0.6), 0.5},
       {0.4, x, 1e-6},
       {false, true, true, true, true, true}},
      {"C2",
       "radii 0.5, 0.7 apart",
       {at(0), 0.5},
       {at(0.7), 0.5},
       {0.3, x, 1e-6},
       {false, true, true, true, true, true}},
      {"C3",
       "radii 1 and 1, concentric",
       {at(0), 1},
       {at(0), 1},
       {2, y, 1e-6},
       {false, false, true, true, true, true}},
      {"X02",
       "radii 1 and 3, concentric",
       {at(0), 1},
       {at(0), 3},
       {4, y, 1e-6},
       {false, false, true, true, true, true}},
      {"C4",
       "centres 1e-23 apart",
       {at(0), 1},
       {at(tiny), 1},
       {2, x, 1e-6},
       {false, false, true, true, true, true}},
      {"C6",
       "radii 1e-4 and 1e4, a gap of 1e-5",
       {at(0), 1e4},
       {at(1e4 + 1e-4 + 1e-5), 1e-4},
       {-1e-5, x, 1e-6},
       {false, false, false, false, false, true}},
      {"C7",
       "radii 0.5, 0.999 apart, 1e6 away on all axes",
       {far, 0.5},
       {far + at(0.999), 0.5},
       {0.001, x, 1e-6},
       {false, false, true, false, false, true}},
      {"C8",
       "unit spheres that touch",
       {at(0), 1},
       {at(2), 1},
       {0, x, 1e-6},
       {false, true, true, false, true, true}}};
}
// [sphere_cases]

/// The names of the ways that compete.
inline std::vector<std::string> sphere_method_names()
{
  return {"as published", "float, world", "float, relative", "1/√x, 2 steps", "batch", "double"};
}

/// The batch's answer for one pair.
inline std::optional<Found> found_by_batch(const Sphere<float>& a, const Sphere<float>& b)
{
  const Lists pairs = lists_of_pairs({{a, b}});
  Lists lists = lists_of_overlaps(1);
  const SphereOverlaps overlaps = overlaps_of(lists);
  sphere_pairs(pairs_of(pairs), overlaps);
  return overlaps.depth[0] < 0
             ? std::nullopt
             : std::optional<Found>(
                   {{overlaps.nx[0], overlaps.ny[0], overlaps.nz[0]}, overlaps.depth[0]});
}

/// What each way answers, in the order of their names.
inline std::vector<std::optional<Found>>
sphere_answers(const Sphere<double>& a, const Sphere<double>& b)
{
  const Sphere<float> float_a{a.center.cast<float>(), static_cast<float>(a.radius)};
  const Sphere<float> float_b{b.center.cast<float>(), static_cast<float>(b.radius)};
  const Vector3<double> a_to_b = b.center - a.center;
  return {
      found(sphere_sphere_as_published(float_a, float_b)),
      found(sphere_sphere_world_float(float_a, float_b)),
      found(sphere_sphere_relative<float>(a_to_b.cast<float>(), float_a.radius, float_b.radius)),
      found(sphere_sphere_reciprocal<2>(float_a, float_b)),
      found_by_batch(float_a, float_b),
      found(sphere_sphere(a, b))};
}

// [box_cases]
/// A sphere and a box, what is right of them, and which methods survive: as published, as published
/// for upright boxes, the outside formula everywhere, the signed distance.
struct SphereBoxCase
{
  std::string id;          ///< in the book
  std::string what;        ///< the set-up, in a few words
  Sphere<float> sphere;    ///< A
  Vector3<float> half;     ///< half extents of B, which is upright at the origin
  Right right;             ///< the answer
  std::vector<bool> holds; ///< for each method
};

/// The cases of a sphere and a box. The normal points from the sphere into the box.
inline std::vector<SphereBoxCase> box_cases()
{
  const Vector3<double> down(0, -1, 0);
  const Vector3<float> plate(10, 0.5f, 10);
  const Vector3<float> cube(1, 1, 1);
  return {
      {"D1",
       "plate, centre 0.05 below its top",
       {{9, 0.45f, 0}, 0.1f},
       plate,
       {0.15, down, 1e-6},
       {false, false, false, true}},
      {"X05",
       "plate, centre 0.25 below its top",
       {{3, 0.25f, 0}, 0.1f},
       plate,
       {0.35, down, 1e-6},
       {false, false, false, true}},
      {"D2",
       "plate, centre in its centre",
       {{0, 0, 0}, 0.1f},
       plate,
       {0.6, down, 1e-6},
       {false, false, false, true}},
      {"X07",
       "cube, centre in its centre",
       {{0, 0, 0}, 0.1f},
       cube,
       {1.1, {-1, 0, 0}, 1e-6},
       {false, false, false, true}},
      {"D3",
       "plate, centre 0.001 above its top",
       {{9, 0.501f, 0}, 0.1f},
       plate,
       {0.099, down, 1e-6},
       {true, false, true, true}},
      {"X06",
       "plate, centre 0.0002 above its top",
       {{9, 0.5002f, 0}, 0.1f},
       plate,
       {0.0998, down, 1e-6},
       {false, false, true, true}},
      {"D4",
       "cube, centre on its corner",
       {{1, 1, 1}, 1},
       cube,
       {1, {0, 0, 0}, 1e-6},
       {true, false, false, true}},
      {"D5",
       "box of 100 m, centre 0.5 below its top",
       {{0, 49.5f, 0}, 0.5f},
       {50, 50, 50},
       {1, down, 1e-5},
       {false, false, false, true}},
      {"D9",
       "thin box, centre 0.01 below its top",
       {{0, 0.24f, 0}, 0.005f},
       {0.5f, 0.25f, 0.5f},
       {0.015, down, 1e-6},
       {false, false, false, true}},
      {"D8",
       "bar of 20 m, centre 4 above its top",
       {{0, 5, 0}, 0.5f},
       {10, 1, 1},
       {-3.5, down, 1e-6},
       {true, false, true, true}},
      {"X28",
       "bar of 20 m, centre 4 beside it",
       {{0, 0, -5}, 0.5f},
       {10, 1, 1},
       {-3.5, down, 1e-6},
       {true, false, true, true}}};
}
// [box_cases]

/// The names of the ways that compete.
inline std::vector<std::string> box_method_names()
{
  return {"as published", "published, upright", "outside formula only", "signed distance"};
}

/// What each way answers, in the order of their names.
inline std::vector<std::optional<Found>>
box_answers(const Sphere<float>& sphere, const Vector3<float>& half_extents)
{
  const Obb<float> box{{0, 0, 0}, Matrix3<float>::Identity(), half_extents};
  return {
      found(sphere_box_as_published(sphere, box)), found(sphere_box_mixed_bounds(sphere, box)),
      found(sphere_box_outside_only(sphere, box)), found(sphere_box(sphere, box))};
}

/// The verdict of every answer.
inline std::vector<Verdict>
verdicts_of(const std::vector<std::optional<Found>>& answers, const Right& right)
{
  std::vector<Verdict> verdicts;
  for (const std::optional<Found>& answer : answers)
  {
    verdicts.push_back(verdict_of(answer, right));
  }
  return verdicts;
}

} // namespace cookbook
