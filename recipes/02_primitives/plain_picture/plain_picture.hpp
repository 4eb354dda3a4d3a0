#pragma once

/// \file
/// \brief A triangle in a picture: edge functions and a depth buffer, the formulas as they stand.

#include "02_primitives/picture/canvas.hpp"
#include "common/math/vector.hpp"

namespace cookbook
{

// [edge_function]
/// Twice the area of the triangle a, b, p in a picture whose y axis points down; above zero where p
/// is to the right of the edge from a to b; P24.
template <class Real>
Real edge_function(const Vector2<Real>& a, const Vector2<Real>& b, const Vector2<Real>& p)
{
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}
// [edge_function]

// [fill_triangle]
/// Paints the pixels whose centres are in a triangle, where nothing nearer is painted yet; P25.
///
/// Corners are x, y [pixels] and depth. A triangle without an area has no pixels.
inline void fill_triangle(
    Picture& picture, const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
    const Colour& colour)
{
  const Vector2<double> a2 = a.head<2>(), b2 = b.head<2>(), c2 = c.head<2>();
  const double area = edge_function(a2, b2, c2);
  for (int y = 0; y < picture.height; ++y)
  {
    for (int x = 0; x < picture.width; ++x)
    {
      const Vector2<double> p(x + 0.5, y + 0.5);
      const double u = edge_function(b2, c2, p) / area;
      const double v = edge_function(c2, a2, p) / area;
      const double w = edge_function(a2, b2, p) / area;
      const double depth = u * a.z() + v * b.z() + w * c.z();
      const std::size_t i = row_start(picture, y) + static_cast<std::size_t>(x);
      if (u >= 0 && v >= 0 && w >= 0 && depth < static_cast<double>(picture.depth[i]))
      {
        picture.depth[i] = static_cast<float>(depth);
        picture.pixels[i] = to_pixel(colour);
      }
    }
  }
}
// [fill_triangle]

} // namespace cookbook
