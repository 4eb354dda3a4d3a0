#pragma once

/// \file
/// \brief Shapes in space from the columns of a reader's file.

#include "02_primitives/finder/trial/shape_row.hpp"
#include "02_primitives/shapes/more_shapes.hpp"

namespace cookbook
{

// [shape_columns]
/// What a shape is called in the finder, the columns that it has, and how it is read from them.
template <class Shape>
struct ShapeColumns;

/// A point.
template <class Real>
struct ShapeColumns<Vector3<Real>>
{
  static constexpr const char *name = "point", *columns = "x,y,z";
  static Vector3<Real> read(const ShapeRow<Real>& row) { return row.point(0); }
};

/// A segment, by its ends.
template <class Real>
struct ShapeColumns<Segment<Real>>
{
  static constexpr const char *name = "segment", *columns = "px,py,pz,qx,qy,qz";
  static Segment<Real> read(const ShapeRow<Real>& row) { return {row.point(0), row.point(3)}; }
};
// [shape_columns]

/// A ray, by origin and direction.
template <class Real>
struct ShapeColumns<Ray<Real>>
{
  static constexpr const char *name = "ray", *columns = "ox,oy,oz,dx,dy,dz";
  static Ray<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point(0), row.template direction<3>(3, row.point(3))};
  }
};

/// A half-space, by normal and distance.
template <class Real>
struct ShapeColumns<Plane<Real>>
{
  static constexpr const char *name = "plane", *columns = "nx,ny,nz,d";
  static Plane<Real> read(const ShapeRow<Real>& row) { return row.plane(); }
};

/// A sphere.
template <class Real>
struct ShapeColumns<Sphere<Real>>
{
  static constexpr const char *name = "sphere", *columns = "x,y,z,r";
  static Sphere<Real> read(const ShapeRow<Real>& row) { return {row.point(0), row.radius(3)}; }
};

/// A capsule, by its segment and radius.
template <class Real>
struct ShapeColumns<Capsule<Real>>
{
  static constexpr const char *name = "capsule", *columns = "px,py,pz,qx,qy,qz,r";
  static Capsule<Real> read(const ShapeRow<Real>& row)
  {
    return {{row.point(0), row.point(3)}, row.radius(6)};
  }
};

/// A box along the axes, by its centre.
template <class Real>
struct ShapeColumns<Aabb<Real>>
{
  static constexpr const char *name = "aabb", *columns = "x,y,z,hx,hy,hz";
  static Aabb<Real> read(const ShapeRow<Real>& row)
  {
    const Vector3<Real> c = row.point(0), h = row.half_extents(3);
    return Aabb<Real>(Vector3<Real>(c - h), Vector3<Real>(c + h));
  }
};

/// An oriented box.
template <class Real>
struct ShapeColumns<Obb<Real>>
{
  static constexpr const char *name = "obb", *columns = "x,y,z,qw,qx,qy,qz,hx,hy,hz";
  static Obb<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point(0), row.axes(3), row.half_extents(7)};
  }
};

/// A triangle, by its corners.
template <class Real>
struct ShapeColumns<Triangle<Real>>
{
  static constexpr const char *name = "triangle", *columns = "px,py,pz,qx,qy,qz,rx,ry,rz";
  static Triangle<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point(0), row.point(3), row.point(6)};
  }
};

/// A tetrahedron, by its corners.
template <class Real>
struct ShapeColumns<Tetrahedron<Real>>
{
  static constexpr const char *name = "tetrahedron",
                              *columns = "px,py,pz,qx,qy,qz,rx,ry,rz,sx,sy,sz";
  static Tetrahedron<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point(0), row.point(3), row.point(6), row.point(9)};
  }
};

} // namespace cookbook
