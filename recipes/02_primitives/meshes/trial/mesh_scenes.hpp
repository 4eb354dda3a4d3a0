#pragma once

/// \file
/// \brief Meshes to try: a ball, a quad, triangles in a row of sizes; and answers without a tree.

#include "02_primitives/meshes/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace cookbook
{

/// Numbers and points from a fixed seed.
struct MeshDraw
{
  std::mt19937 random{34}; ///< the same on every machine

  /// A number from `least` to `most`.
  double operator()(double least, double most)
  {
    return least + (most - least) * static_cast<double>(random()) * 0x1p-32;
  }
  /// A point within a cube.
  Vector3<double> point(double most)
  {
    const double x = (*this)(-most, most), y = (*this)(-most, most);
    return {x, y, (*this)(-most, most)};
  }
  /// A whole number from 0 on.
  int below(std::size_t count) { return static_cast<int>(random() % count); }
};

/// A closed ball of radius 1: an octahedron whose triangles are parted into four, `times` times.
inline TriangleMesh<double> ball_mesh(int times)
{
  TriangleMesh<double> ball{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (; times > 0; --times)
  {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b)
    {
      const auto number = static_cast<int>(ball.vertices.size());
      const auto [known, is_new] = middles.insert({std::minmax(a, b), number});
      if (is_new)
      {
        const Vector3<double> sum =
            ball.vertices[static_cast<std::size_t>(a)] + ball.vertices[static_cast<std::size_t>(b)];
        ball.vertices.push_back(sum / std::sqrt(sum.squaredNorm()));
      }
      return known->second;
    };
    std::vector<std::array<int, 3>> parts;
    for (const auto& [a, b, c] : ball.triangles)
    {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      parts.insert(parts.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    ball.triangles = parts;
  }
  return ball;
}

/// A mesh in another number type.
template <class Real>
TriangleMesh<Real> mesh_as(const TriangleMesh<double>& mesh)
{
  TriangleMesh<Real> other{{}, mesh.triangles};
  for (const Vector3<double>& vertex : mesh.vertices)
  {
    other.vertices.push_back(vertex.template cast<Real>());
  }
  return other;
}

/// Triangles of all sizes, thrown about; every tenth is flat, every tenth stands twice.
inline TriangleMesh<double> thrown_triangles(int count)
{
  MeshDraw draw;
  TriangleMesh<double> mesh;
  while (static_cast<int>(mesh.triangles.size()) < count)
  {
    const int first = static_cast<int>(mesh.vertices.size());
    const Vector3<double> a = draw.point(1);
    const double size = std::pow(2.0, -draw.below(10));
    const Vector3<double> ab = size * draw.point(1), ac = size * draw.point(1);
    const bool flat = draw.below(10) == 0, twice = draw.below(10) == 0;
    mesh.vertices.insert(
        mesh.vertices.end(), {a, a + ab, a + (flat ? Vector3<double>(ab / 2) : ac)});
    mesh.triangles.push_back({first, first + 1, first + 2});
    if (twice)
    {
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return mesh;
}

/// The nearest hit of a ray by asking all triangles: its t and its triangle.
template <class Real>
std::optional<std::pair<Wide<Real>, int>>
cast_without_tree(const Ray<Real>& ray, const TriangleMesh<Real>& mesh)
{
  std::optional<std::pair<Wide<Real>, int>> nearest;
  const ShearedView<Wide<Real>> view = view_along(ray);
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
  {
    const auto t = ray_triangle_watertight(view, triangle_of(mesh, i));
    if (t && (!nearest || *t < nearest->first))
    {
      nearest = {*t, i};
    }
  }
  return nearest;
}

/// The distance of the closest point of a mesh, by asking all triangles, and the triangle.
template <class Real>
std::pair<Wide<Real>, int>
closest_without_tree(const TriangleMesh<Real>& mesh, const Vector3<Real>& point)
{
  std::pair<Wide<Real>, int> closest{std::numeric_limits<Wide<Real>>::infinity(), -1};
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
  {
    const Wide<Real> distance = vector_to_triangle<Real>(triangle_of(mesh, i), widen(point)).norm();
    closest = distance < closest.first ? std::pair(distance, i) : closest;
  }
  return closest;
}

// [pitfalls_of_rays]
/// A ray against a triangle as it is mostly written, in float: inside of the two edges and the
/// third by a bound, nothing where the determinant is under it. A model of published code.
inline std::optional<float>
ray_triangle_by_bounds(const Ray<float>& ray, const Triangle<float>& triangle)
{
  const float least = 1e-6f;
  const Vector3<float> ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const Vector3<float> p = ray.direction.cross(ac), s = ray.origin - triangle.a;
  const float determinant = ab.dot(p);
  if (std::abs(determinant) < least)
  {
    return std::nullopt;
  }
  const Vector3<float> q = s.cross(ab);
  const float u = s.dot(p) / determinant, v = ray.direction.dot(q) / determinant;
  const float t = ac.dot(q) / determinant;
  return u < 0 || v < 0 || u + v > 1 || t < least ? std::nullopt : std::optional<float>(t);
}

/// The first triangle that answers, not the nearest. A model of published code, X34.
inline std::optional<float> first_hit(const Ray<float>& ray, const TriangleMesh<float>& mesh)
{
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
  {
    if (const std::optional<float> t = ray_triangle_by_bounds(ray, triangle_of(mesh, i)))
    {
      return t;
    }
  }
  return std::nullopt;
}

/// The nearest hit by the same test of a triangle.
inline std::optional<float>
nearest_by_bounds(const Ray<float>& ray, const TriangleMesh<float>& mesh)
{
  std::optional<float> nearest;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
  {
    const std::optional<float> t = ray_triangle_by_bounds(ray, triangle_of(mesh, i));
    nearest = t && (!nearest || *t < *nearest) ? t : nearest;
  }
  return nearest;
}
// [pitfalls_of_rays]

/// A point on an edge of a triangle of a mesh, sometimes a corner, rounded.
template <class Real>
Vector3<Real> point_on_seam(MeshDraw& draw, const TriangleMesh<Real>& mesh)
{
  const Triangle<Real> t = triangle_of(mesh, draw.below(mesh.triangles.size()));
  const Real fraction = static_cast<Real>(draw.below(8) == 0 ? 0.0 : draw(0, 1));
  return t.a + fraction * (t.b - t.a);
}

} // namespace cookbook
