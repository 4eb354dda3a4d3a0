#pragma once

/// \file
/// \brief The cases that break methods for two spheres.

#include "03_sphere_manifolds/sphere_failures/trial/sphere_verdicts.hpp"
#include "03_sphere_manifolds/sphere_methods/trial/sphere_methods.hpp"
#include "03_sphere_manifolds/sphere_pairs/sphere_pairs.hpp"

#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

// [sphere_cases]
/// Two spheres, and what is right of them.
struct SphereCase
{
  std::string id;   ///< in the book
  std::string what; ///< the set-up, in a few words
  Sphere<double> a; ///< A
  Sphere<double> b; ///< B
  Right right;      ///< the answer
};

/// The cases of two spheres.
inline std::vector<SphereCase> sphere_cases()
{
  const Vector3<double> x(1, 0, 0);
  const Vector3<double> y(0, 1, 0);
  const auto at = [](double distance) { return Vector3<double>(distance, 0, 0); };
  const Vector3<double> distant(1e6, 1e6, 1e6);
  const double tiny = 1e-23;
  return {
      {"C1", "unit spheres, 1.9 apart", {at(0), 1}, {at(1.9), 1}, {0.1, x, 1e-6}},
      {"X01", "radii 0.5, 0.6 apart", {at(0), 0.5}, {at(0.6), 0.5}, {0.4, x, 1e-6}},
      {"C2", "radii 0.5, 0.7 apart", {at(0), 0.5}, {at(0.7), 0.5}, {0.3, x, 1e-6}},
      {"C3", "radii 1 and 1, concentric", {at(0), 1}, {at(0), 1}, {2, y, 1e-6}},
      {"X02", "radii 1 and 3, concentric", {at(0), 1}, {at(0), 3}, {4, y, 1e-6}},
      {"C4", "centres 1e-23 apart", {at(0), 1}, {at(tiny), 1}, {2, x, 1e-6}},
      {"C6",
       "radii 1e-4 and 1e4, a gap of 1e-5",
       {at(0), 1e4},
       {at(1e4 + 1e-4 + 1e-5), 1e-4},
       {-1e-5, x, 1e-6}},
      {"C7",
       "radii 0.5, 0.999 apart, 1e6 away on all axes",
       {distant, 0.5},
       {distant + at(0.999), 0.5},
       {0.001, x, 1e-6}},
      {"C8", "unit spheres that touch", {at(0), 1}, {at(2), 1}, {0, x, 1e-6}}};
}
// [sphere_cases]

/// The names of the methods.
inline std::vector<std::string> sphere_method_names()
{
  return {"as published", "plain_sphere_sphere, float", "relative, float", "reciprocal, 2 steps",
          "sphere_pairs", "sphere_sphere, double"};
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

/// What each method answers, in the order of their names.
inline std::vector<std::optional<Found>>
sphere_answers(const Sphere<double>& a, const Sphere<double>& b)
{
  const Sphere<float> float_a{a.center.cast<float>(), static_cast<float>(a.radius)};
  const Sphere<float> float_b{b.center.cast<float>(), static_cast<float>(b.radius)};
  const Vector3<double> a_to_b = b.center - a.center;
  return {
      found(sphere_sphere_as_published(float_a, float_b)),
      found(plain_sphere_sphere(float_a, float_b)),
      found(sphere_sphere_relative<float>(a_to_b.cast<float>(), float_a.radius, float_b.radius)),
      found(sphere_sphere_reciprocal<2>(float_a, float_b)),
      found_by_batch(float_a, float_b),
      found(sphere_sphere(a, b))};
}

/// The verdicts on all methods, case by case.
inline std::vector<VerdictRow> sphere_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const SphereCase& one : sphere_cases())
  {
    rows.push_back(
        {one.id, one.what, verdicts_of(sphere_answers(one.a, one.b), one.right),
         right_value(one.right)});
  }
  return rows;
}

} // namespace cookbook
