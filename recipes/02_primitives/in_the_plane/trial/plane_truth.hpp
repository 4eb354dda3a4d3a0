#pragma once

/// \file
/// \brief Shapes in the plane on a grid of whole numbers, and what is exactly true of them.

#include "02_primitives/shapes/plane_shapes.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace cookbook
{

/// A point of the grid.
struct GridPoint
{
  std::int64_t x; ///< in units of the grid
  std::int64_t y; ///< in units of the grid
};

/// A difference of points.
inline GridPoint operator-(const GridPoint& a, const GridPoint& b)
{
  return {a.x - b.x, a.y - b.y};
}

/// The dot product.
inline std::int64_t dot_of(const GridPoint& a, const GridPoint& b)
{
  return a.x * b.x + a.y * b.y;
}

/// The cross product.
inline std::int64_t cross_of(const GridPoint& a, const GridPoint& b)
{
  return a.x * b.y - a.y * b.x;
}

/// Corners in order, counter-clockwise where there are three or more; and a radius.
struct GridShape
{
  std::vector<GridPoint> corners; ///< one, two or more
  std::int64_t radius = 0;        ///< in units of the grid
};

/// A squared distance: a fraction of whole numbers.
struct GridSquare
{
  std::int64_t over;  ///< the numerator
  std::int64_t under; ///< the denominator, above zero
};

/// The squared distance of a point from the segment from a to b.
inline GridSquare to_edge(const GridPoint& p, const GridPoint& a, const GridPoint& b)
{
  const std::int64_t along = dot_of(p - a, b - a), length = dot_of(b - a, b - a);
  if (along <= 0 || length == 0)
  {
    return {dot_of(p - a, p - a), 1};
  }
  const std::int64_t area = cross_of(b - a, p - a);
  return along >= length ? GridSquare{dot_of(p - b, p - b), 1} : GridSquare{area * area, length};
}

/// The least squared distance between edges of two shapes, which is at a corner unless they cross.
inline GridSquare between_edges(const GridShape& a, const GridShape& b)
{
  GridSquare least{INT32_MAX, 1};
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
  {
    for (const GridPoint& corner : from->corners)
    {
      for (std::size_t i = 0; i < to->corners.size(); ++i)
      {
        const GridSquare one =
            to_edge(corner, to->corners[i], to->corners[(i + 1) % to->corners.size()]);
        least = one.over * least.under < least.over * one.under ? one : least;
      }
    }
  }
  return least;
}

/// Whether a corner of one shape is within the other.
inline bool corner_within(const GridShape& a, const GridShape& b)
{
  for (const GridPoint& corner : a.corners)
  {
    bool within = b.corners.size() > 2;
    for (std::size_t i = 0; i < b.corners.size(); ++i)
    {
      const GridPoint& from = b.corners[i];
      within = within && cross_of(b.corners[(i + 1) % b.corners.size()] - from, corner - from) > 0;
    }
    if (within)
    {
      return true;
    }
  }
  return false;
}

/// Whether an edge of one shape goes right through an edge of the other.
inline bool edges_cross(const GridShape& a, const GridShape& b)
{
  const auto opposite = [](std::int64_t one, std::int64_t other)
  { return (one > 0 && other < 0) || (one < 0 && other > 0); };
  for (std::size_t i = 0; i < a.corners.size(); ++i)
  {
    for (std::size_t j = 0; j < b.corners.size(); ++j)
    {
      const GridPoint &p = a.corners[i], &q = a.corners[(i + 1) % a.corners.size()];
      const GridPoint &r = b.corners[j], &s = b.corners[(j + 1) % b.corners.size()];
      if (opposite(cross_of(q - p, r - p), cross_of(q - p, s - p)) &&
          opposite(cross_of(s - r, p - r), cross_of(s - r, q - r)))
      {
        return true;
      }
    }
  }
  return false;
}

// [grid_truth]
/// What is true of two shapes on the grid.
struct GridTruth
{
  bool overlap;    ///< exactly; touching counts
  bool touching;   ///< neither apart nor deep: rounding may decide either way
  double distance; ///< in units of the grid, 0 where they overlap
};

/// Two convex shapes overlap if edges touch or cross, or one holds a corner of the other.
inline GridTruth truth_of(const GridShape& a, const GridShape& b)
{
  const bool deep = edges_cross(a, b) || corner_within(a, b) || corner_within(b, a);
  const GridSquare square = deep ? GridSquare{0, 1} : between_edges(a, b);
  const std::int64_t radii = a.radius + b.radius, limit = radii * radii * square.under;
  const double distance = std::sqrt(double(square.over) / double(square.under)) - double(radii);
  const bool overlap = square.over <= limit;
  return {overlap, !deep && square.over == limit, overlap ? 0 : distance};
}
// [grid_truth]

} // namespace cookbook
