#pragma once

/// \file
/// \brief CGAL's mesh, asked for rays and closest points, to be timed beside ours.

#include "02_primitives/meshes/triangle_mesh.hpp"
#include "02_primitives/shapes/shapes.hpp"

#ifdef COOKBOOK_HAS_CGAL
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif
#endif

#include <cmath>
#include <vector>

namespace cookbook
{

#ifdef COOKBOOK_HAS_CGAL
/// A mesh in CGAL, with its tree of boxes, in double.
class CgalMesh
{
public:
  /// Copies the mesh and builds its tree.
  explicit CgalMesh(const TriangleMesh<float>& mesh)
  {
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
    {
      const Triangle<float> t = triangle_of(mesh, i);
      triangles_.emplace_back(point(t.a), point(t.b), point(t.c));
    }
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
    tree_.accelerate_distance_queries();
  }

  /// The number of the triangle that a ray meets first; −1: none.
  int cast(const Ray<float>& ray) const
  {
    const Vector3<double> direction = ray.direction.cast<double>();
    const auto met = tree_.first_intersected_primitive(Kernel::Ray_3(
        point(ray.origin), Kernel::Vector_3(direction.x(), direction.y(), direction.z())));
    return met ? static_cast<int>(*met - triangles_.begin()) : -1;
  }

  /// How far a point is.
  double distance(const Vector3<float>& from) const
  {
    return std::sqrt(tree_.squared_distance(point(from)));
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_MAJOR >= 6
  using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#else
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#endif

  static Kernel::Point_3 point(const Vector3<float>& p)
  {
    const Vector3<double> wide = p.cast<double>();
    return {wide.x(), wide.y(), wide.z()};
  }

  Triangles triangles_;
  Tree tree_;
};
#endif

} // namespace cookbook
