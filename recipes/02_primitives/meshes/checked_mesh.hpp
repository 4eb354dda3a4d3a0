#pragma once

/// \file
/// \brief The check that a mesh's numbers make sense.

#include "02_primitives/meshes/triangle_mesh.hpp"
#include "02_primitives/shapes/checked_shapes.hpp"

#include <string>

namespace cookbook
{

// [checked_mesh]
/// The mesh itself, or InvalidShape that names a corner that is not finite, or a triangle that asks
/// for a corner that does not exist.
template <class Real>
const TriangleMesh<Real>& checked(const TriangleMesh<Real>& mesh)
{
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
  {
    check_finite("vertices[" + std::to_string(i) + "]", mesh.vertices[i]);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (const int vertex : mesh.triangles[i])
    {
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= mesh.vertices.size())
      {
        throw InvalidShape(
            "triangles[" + std::to_string(i) + "]",
            "of corners below " + std::to_string(mesh.vertices.size()), std::to_string(vertex));
      }
    }
  }
  return mesh;
}
// [checked_mesh]

} // namespace cookbook
