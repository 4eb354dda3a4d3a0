#pragma once

/// \file
/// \brief Shapes in the plane from the columns of a reader's file.

#include "02_primitives/finder/trial/shape_columns.hpp"
#include "02_primitives/shapes/plane_shapes.hpp"

namespace cookbook
{

/// A point in the plane.
template <class Real>
struct ShapeColumns<Vector<Real, 2>>
{
  static constexpr const char *name = "point2", *columns = "x,y";
  static Vector<Real, 2> read(const ShapeRow<Real>& row) { return row.point2(0); }
};

/// A segment in the plane.
template <class Real>
struct ShapeColumns<Segment2<Real>>
{
  static constexpr const char *name = "segment2", *columns = "px,py,qx,qy";
  static Segment2<Real> read(const ShapeRow<Real>& row) { return {row.point2(0), row.point2(2)}; }
};

/// A ray in the plane.
template <class Real>
struct ShapeColumns<Ray2<Real>>
{
  static constexpr const char *name = "ray2", *columns = "ox,oy,dx,dy";
  static Ray2<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point2(0), row.template direction<2>(2, row.point2(2))};
  }
};

/// A circle.
template <class Real>
struct ShapeColumns<Circle<Real>>
{
  static constexpr const char *name = "circle", *columns = "x,y,r";
  static Circle<Real> read(const ShapeRow<Real>& row) { return {row.point2(0), row.radius(2)}; }
};

/// A rectangle along the axes.
template <class Real>
struct ShapeColumns<Rectangle<Real>>
{
  static constexpr const char *name = "rectangle", *columns = "x,y,hx,hy";
  static Rectangle<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point2(0), row.half_extents2(2)};
  }
};

/// A turned rectangle.
template <class Real>
struct ShapeColumns<OrientedRectangle<Real>>
{
  static constexpr const char *name = "turned_rectangle", *columns = "x,y,angle,hx,hy";
  static OrientedRectangle<Real> read(const ShapeRow<Real>& row)
  {
    return {row.point2(0), row.number(2), row.half_extents2(3)};
  }
};

} // namespace cookbook
