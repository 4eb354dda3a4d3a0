#pragma once

/// \file
/// \brief Triangles that share their corners.

#include "02_primitives/shapes/shapes.hpp"
#include "common/math/vector.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [triangle_mesh]
/// Triangles as numbers of corners. All functions of meshes want finite corners and numbers that
/// exist; `checked` says whether they are.
///
/// A mesh is a surface, it has no inside. Triangles may be flat or stand twice.
template <class Real>
struct TriangleMesh
{
  std::vector<Vector3<Real>> vertices;       ///< [m], world
  std::vector<std::array<int, 3>> triangles; ///< numbers of their corners, from zero
};

/// A triangle of a mesh.
template <class Real>
Triangle<Real> triangle_of(const TriangleMesh<Real>& mesh, int triangle)
{
  const auto corner = [&](std::size_t i)
  {
    const int vertex = mesh.triangles[static_cast<std::size_t>(triangle)][i];
    return mesh.vertices[static_cast<std::size_t>(vertex)];
  };
  return {corner(0), corner(1), corner(2)};
}
// [triangle_mesh]

/// The smallest box along the axes that holds a triangle of a mesh.
template <class Real>
Eigen::AlignedBox<Real, 3> box_of_triangle(const TriangleMesh<Real>& mesh, int triangle)
{
  const Triangle<Real> t = triangle_of(mesh, triangle);
  return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

} // namespace cookbook
