#pragma once

/// \file
/// \brief Pairs of spheres by the name of what is hard about them, and how wrong a method is there.

#include "03_sphere_manifolds/manifold/trial/as_double.hpp"
#include "03_sphere_manifolds/sphere_methods/trial/sphere_methods.hpp"
#include "common/math/ulp.hpp"
#include "tools/exact/exact.hpp"
#include "tools/measure/statistics.hpp"

#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// A pair as a world knows it: in double, which holds every float.
using WorldPair = std::pair<Sphere<double>, Sphere<double>>;

/// Pairs and what they have in common.
struct Workload
{
  std::string name;
  std::vector<WorldPair> pairs;
};

/// How the pairs of a workload are drawn; radii lie in [0.5, 1] scale.
struct Recipe
{
  std::string name;
  float closest = 0;  ///< least distance, in sums of the radii
  float farthest = 1; ///< largest distance
  float scale = 1;    ///< [m]
  double offset = 0;  ///< [m], of the pair from the world's origin, along every axis
};

/// The workloads of this chapter.
inline std::vector<Recipe> sphere_workload_recipes()
{
  return {
      {"mixed", 0, 2},        {"touching", 0, 1},        {"apart", 1.01f, 2},
      {"shallow", 0.999f, 1}, {"deep", 1e-6f, 1e-3f},    {"tiny", 0, 2, 1e-22f},
      {"huge", 0, 2, 1e25f},  {"far", 0, 2, 1, 1048576}, {"concentric", 0, 0},
  };
}

/// Draws pairs in float arithmetic, then moves them by the offset; the same on every machine.
inline Workload sphere_workload(const Recipe& recipe, std::size_t count)
{
  std::mt19937 engine(1);
  const auto random = [&engine](float low, float high)
  { return low + (high - low) * static_cast<float>(engine() >> 8) * 0x1p-24f; };
  const auto vector = [&] { return Vector3<float>{random(-1, 1), random(-1, 1), random(-1, 1)}; };
  const auto moved = [&recipe](const Vector3<float>& center) -> Vector3<double>
  { return center.cast<double>() + Vector3<double>::Constant(recipe.offset); };
  Workload workload{recipe.name, {}};
  while (workload.pairs.size() < count)
  {
    const float radius_a = recipe.scale * random(0.5f, 1);
    const float radius_b = recipe.scale * random(0.5f, 1);
    const Vector3<float> a = recipe.scale * vector();
    const float distance = (radius_a + radius_b) * random(recipe.closest, recipe.farthest);
    const Vector3<float> b = a + distance * normalize<float>(vector()).unit;
    workload.pairs.push_back({{moved(a), radius_a}, {moved(b), radius_b}});
  }
  return workload;
}

/// A method by name, as a world in double calls it.
struct SphereMethod
{
  std::string name;
  std::function<std::optional<Manifold<double>>(const Sphere<double>&, const Sphere<double>&)> run;
};

/// The method that rounds a world's coordinates to float, then calls `function`.
template <class Function>
SphereMethod in_world_float(const std::string& name, Function function)
{
  const auto rounded = [](const Sphere<double>& s) {
    return Sphere<float>{s.center.cast<float>(), static_cast<float>(s.radius)};
  };
  return {name, [=](const Sphere<double>& a, const Sphere<double>& b) {
            return as_double(function(rounded(a), rounded(b)));
          }};
}

/// All methods, from the published one to double.
inline std::vector<SphereMethod> sphere_methods()
{
  return {
      in_world_float("as published", sphere_sphere_as_published),
      in_world_float("plain_sphere_sphere, float", plain_sphere_sphere<float>),
      in_world_float("reciprocal, 0 steps", sphere_sphere_reciprocal<0>),
      in_world_float("reciprocal, 1 step", sphere_sphere_reciprocal<1>),
      in_world_float("reciprocal, 2 steps", sphere_sphere_reciprocal<2>),
      in_world_float("reciprocal, 3 steps", sphere_sphere_reciprocal<3>),
      in_world_float("sphere_sphere, float", sphere_sphere<float>),
      {"relative, float",
       [](const Sphere<double>& a, const Sphere<double>& b)
       {
         const Vector3<double> a_to_b = b.center - a.center;
         return as_double(sphere_sphere_relative<float>(
             a_to_b.cast<float>(), static_cast<float>(a.radius), static_cast<float>(b.radius)));
       }},
      {"sphere_sphere, double", sphere_sphere<double>}};
}

/// How wrong one answer is.
struct SphereError
{
  bool verdict = false; ///< whether it says apart where they touch, or the other way round
  double depth = 0;     ///< [ulp of the larger radius, as float]; infinite for NaN
  double normal = 0;    ///< [ulp of 1, as float], of its worst component; infinite for NaN
};

/// The error of an answer against the truth, which is computed with a hundred digits.
inline SphereError sphere_error(
    const std::optional<Manifold<double>>& answer, const std::optional<Manifold<Reference>>& truth,
    float larger_radius)
{
  const auto in_ulps = [](const Reference& error, float size)
  {
    const double ulps = static_cast<double>(abs(error)) / static_cast<double>(ulp(size));
    return std::isnan(ulps) ? std::numeric_limits<double>::infinity() : ulps;
  };
  if (answer.has_value() != truth.has_value())
  {
    return {true};
  }
  if (!truth)
  {
    return {};
  }
  SphereError error{false, in_ulps(Reference(answer->depth) - truth->depth, larger_radius)};
  for (int i = 0; i < 3; ++i)
  {
    const Reference off = Reference(answer->normal[i]) - truth->normal[i];
    error.normal = std::max(error.normal, in_ulps(off, 1.0f));
  }
  return error;
}

/// The exact manifold of a pair.
inline std::optional<Manifold<Reference>> exact_sphere_sphere(const WorldPair& pair)
{
  const auto& [a, b] = pair;
  return sphere_sphere<Reference>(
      {exact<Reference>(a.center), a.radius}, {exact<Reference>(b.center), b.radius});
}

} // namespace cookbook
