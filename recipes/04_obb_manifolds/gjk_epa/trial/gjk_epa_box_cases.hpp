#pragma once

/// \file
/// \brief The pairs of boxes at which general methods fail: level cubes, and random ones.

#include "04_obb_manifolds/box_cases/trial/box_size_cases.hpp"
#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_cases.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace cookbook
{

/// Two equal cubes, one above the other, turned together; an id that ends in b is a neighbour.
inline BoxCase
level_case(const std::string& id, const std::string& scene, double half_extent, double depth)
{
  const auto [a, b] = cubes_in_line(half_extent, cube_rotation(), depth);
  BoxCase pair{id, scene, a, b, depth, {0, 0, 0}, {}};
  pair.tolerance = 1e-9;
  const bool on_top = 0 < depth && depth < half_extent;
  if (on_top)
  {
    pair.normal = cube_rotation().col(1);
    for (const Vector3<double>& corner :
         rectangle(half_extent, half_extent - depth / 2, half_extent))
    {
      pair.contacts.push_back(cube_rotation() * corner);
    }
  }
  return pair;
}

/// Cubes in one place, barely in contact, and barely apart.
inline std::vector<BoxCase> level_cases()
{
  return {
      level_case("K2", "two equal cubes in one place", 1, 2),
      level_case("K2-b", "two cubes in line, 0.25 mm deep", 1, 2.5e-4),
      level_case("K3", "two cubes in line, 0.1 µm apart", 0.125, -1e-7),
      level_case("K3-b", "two cubes in line, 0.1 µm deep", 0.125, 1e-7)};
}

/// A case by its id, out of several.
inline BoxCase case_of(const std::vector<BoxCase>& cases, const std::string& id)
{
  return *std::find_if(
      cases.begin(), cases.end(), [&](const BoxCase& pair) { return pair.id == id; });
}

} // namespace cookbook
