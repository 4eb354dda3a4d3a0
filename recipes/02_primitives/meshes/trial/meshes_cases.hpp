#pragma once

/// \file
/// \brief Cases E7 and E9, and triangles that are flat or stand twice: which way to cast holds.

#include "02_primitives/meshes/meshes.hpp"
#include "02_primitives/meshes/trial/mesh_scenes.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to the t of a ray's hit, by name.
struct MeshMethod
{
  std::string name;                                                            ///< as on the page
  std::optional<float> (*cast)(const Ray<float>&, const TriangleMesh<float>&); ///< the way
};

/// The recommended way, without the tree.
inline std::optional<float>
nearest_watertight(const Ray<float>& ray, const TriangleMesh<float>& mesh)
{
  const auto nearest = cast_without_tree(ray, mesh);
  return nearest ? std::optional<float>(static_cast<float>(nearest->first)) : std::nullopt;
}

/// The ways that compete, the recommended one last.
inline std::array<MeshMethod, 3> mesh_methods()
{
  return {
      {{"first, with bounds", first_hit},
       {"nearest, with bounds", nearest_by_bounds},
       {"recommended", nearest_watertight}}};
}

/// Rays that all have the same answer, at a mesh.
struct MeshCase
{
  std::string id;                                  ///< in the book; empty for a neighbour
  std::string what;                                ///< in a few words
  TriangleMesh<float> mesh;                        ///< [m]
  int rays;                                        ///< how many
  std::function<Ray<float>(MeshDraw&)> ray;        ///< one of them
  std::function<bool(std::optional<float>)> right; ///< whether an answer is
};

/// A square of two triangles at z = 0.
inline TriangleMesh<float> quad_mesh(float size)
{
  return {{{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

/// A ray from anywhere above to a point of the square's diagonal.
inline Ray<float> ray_at_diagonal(MeshDraw& draw, float size)
{
  const float fraction = static_cast<float>(draw(0.01, 0.99));
  const Vector3<float> at(fraction * size, fraction * size, 0);
  const Vector3<float> from = size * (draw.point(1) + Vector3<double>(0, 0, 2)).cast<float>();
  return {from, at - from};
}

/// The cases, `rays` of them at the seams.
inline std::vector<MeshCase> mesh_cases(int rays)
{
  using V = Vector3<float>;
  const auto is = [](float t) { return [t](std::optional<float> hit) { return hit == t; }; };
  const auto hits = [](std::optional<float> hit) { return hit.has_value(); };
  const auto misses = [](std::optional<float> hit) { return !hit.has_value(); };
  const auto down = [](MeshDraw&) { return Ray<float>{{0.25f, 0.25f, 7}, {0, 0, -1}}; };
  const auto diagonal = [](float size)
  { return [size](MeshDraw& draw) { return ray_at_diagonal(draw, size); }; };
  const TriangleMesh<float> two{
      {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {0, 0, 5}, {1, 0, 5}, {0, 1, 5}}, {{0, 1, 2}, {3, 4, 5}}};
  const TriangleMesh<float> flat{{{0, 0, 0}, {1, 1, 0}, {0.5f, 0.5f, 0}}, {{0, 1, 2}}};
  const TriangleMesh<float> twice{{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}}, {{0, 1, 2}, {0, 1, 2}}};
  return {
      {"E7", "rays at the diagonal of a square of 1 m", quad_mesh(1), rays, diagonal(1), hits},
      {"", "the same, a square of 1 mm", quad_mesh(1e-3f), rays, diagonal(1e-3f), hits},
      {"E9", "two triangles 5 m and 2 m below", two, 1, down, is(2)},
      {"", "a triangle that stands twice", twice, 1, down, is(2)},
      {"", "a flat triangle", flat, 1,
       [](MeshDraw&) {
         return Ray<float>{V(0.25f, 0.25f, 7), V(0, 0, -1)};
       },
       misses},
      {"", "a square of 0.5 mm, met upright", quad_mesh(5e-4f), 1,
       [](MeshDraw&) {
         return Ray<float>{V(2e-4f, 1e-4f, 1), V(0, 0, -1)};
       },
       is(1)}};
}

/// The verdicts on all ways to cast.
inline std::vector<VerdictRow> mesh_verdicts(int rays)
{
  std::vector<VerdictRow> all;
  for (const MeshCase& one : mesh_cases(rays))
  {
    all.push_back({one.id, one.what, {}});
    for (const MeshMethod& method : mesh_methods())
    {
      MeshDraw draw;
      int wrong = 0;
      std::string answer;
      for (int i = 0; i < one.rays; ++i)
      {
        const std::optional<float> t = method.cast(one.ray(draw), one.mesh);
        wrong += !one.right(t);
        answer = t ? "t = " + number(static_cast<double>(*t)) : "no hit";
      }
      const std::string what = one.rays == 1 ? answer
                               : wrong == 0  ? "all hit"
                                            : rounded(100.0 * wrong / one.rays) + " % pass through";
      all.back().verdicts.push_back({wrong == 0, what});
    }
  }
  return all;
}

} // namespace cookbook
