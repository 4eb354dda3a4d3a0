#pragma once

/// \file
/// \brief GJK's distance: where two convex shapes, known by their corners, are closest.

#include "02_primitives/closest_points/nearest_on_simplex.hpp"
#include "02_primitives/closest_segments/closest_segments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace cookbook
{

/// The corners of a convex shape.
template <class Real>
using Corners = std::span<const Vector3<Real>>;

/// Where two shapes are closest, and by how much they are apart.
template <class Real>
struct CoreAnswer
{
  Vector3<Real> a; ///< [m], the point of A
  Vector3<Real> b; ///< [m], the point of B
  Real distance;   ///< [m], between them
};

/// Up to four differences of a corner of A and a corner of B.
template <class Real>
struct CornerPairs
{
  std::array<Vector3<Real>, 4> points; ///< [m], corner of A less corner of B
  std::array<std::size_t, 4> of_a{};   ///< which corner of A
  std::array<std::size_t, 4> of_b{};   ///< which corner of B
  std::size_t size = 0;                ///< 1 … 4

  /// Adds a pair of corners, if there is room and it is not among them.
  bool add(Corners<Real> a, Corners<Real> b, std::size_t i, std::size_t j)
  {
    for (std::size_t k = 0; k < size; ++k)
    {
      if (of_a[k] == i && of_b[k] == j)
      {
        return false;
      }
    }
    points[size] = a[i] - b[j];
    of_a[size] = i;
    of_b[size++] = j;
    return true;
  }

  /// Drops the pairs that have no share, and their shares.
  void keep(Vector<Real, 4>& weights)
  {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < size; ++k)
    {
      if (weights[Eigen::Index(k)] > Real(0))
      {
        points[kept] = points[k];
        of_a[kept] = of_a[k];
        of_b[kept] = of_b[k];
        weights[Eigen::Index(kept++)] = weights[Eigen::Index(k)];
      }
    }
    size = kept;
  }
};

/// The corner that is farthest along a direction; the first of those that are.
template <class Real>
std::size_t support_index(Corners<Real> corners, const Vector3<Real>& direction)
{
  std::size_t best = 0;
  Real most = corners[0].dot(direction);
  for (std::size_t i = 1; i < corners.size(); ++i)
  {
    const Real along = corners[i].dot(direction);
    if (along > most)
    {
      most = along;
      best = i;
    }
  }
  return best;
}

// [gjk_distance]
/// What GJK came to.
template <class Real>
struct GjkDistance
{
  CornerPairs<Real> pairs;  ///< the corners that the closest points are between
  Vector<Real, 4> weights;  ///< [1], of each pair
  Vector3<Real> difference; ///< [m], from the closest point of B to that of A
  Real least;               ///< [m], no two points are closer: the separation found so far
  int steps;                ///< how often the farthest corners were asked for
};

/// The most steps that gjk_distance() takes; ten are rare.
inline constexpr int gjk_distance_limit = 64;

/// Walks towards the origin of A ⊖ B: from a simplex of corners to the farthest corners towards the
/// origin, and back to the part of both that is closest to it.
///
/// Ends where no corner is farther towards the origin, to rounding, or the new part is less close.
template <class Real>
GjkDistance<Real> gjk_distance(Corners<Real> a, Corners<Real> b)
{
  constexpr Real rounding = Real(4) * std::numeric_limits<Real>::epsilon();
  GjkDistance<Real> gjk{{}, Vector<Real, 4>::UnitX(), {}, Real(0), 0};
  gjk.pairs.add(a, b, 0, 0);
  gjk.difference = gjk.pairs.points[0];
  while (gjk.steps < gjk_distance_limit)
  {
    const std::size_t i = support_index<Real>(a, -gjk.difference),
                      j = support_index<Real>(b, gjk.difference);
    ++gjk.steps;
    const Real squared = gjk.difference.squaredNorm(), along = gjk.difference.dot(a[i] - b[j]);
    gjk.least = along > Real(0) ? std::max(gjk.least, along / std::sqrt(squared)) : gjk.least;
    CornerPairs<Real> pairs = gjk.pairs;
    if (!(squared - along > rounding * squared) || pairs.size == 4 || !pairs.add(a, b, i, j))
    {
      break;
    }
    Nearest<Real> nearest = nearest_on_simplex(pairs.points.data(), int(pairs.size));
    if (!(nearest.point.squaredNorm() <= squared + rounding * squared))
    {
      break;
    }
    pairs.keep(nearest.weights);
    gjk.pairs = pairs;
    gjk.weights = nearest.weights;
    gjk.difference = nearest.point;
  }
  return gjk;
}
// [gjk_distance]

// [largest_separation]
/// How far [m] the projections of two shapes along a direction are apart; below zero they overlap.
template <class Real>
Real separation_along(Corners<Real> a, Corners<Real> b, const Vector3<Real>& direction)
{
  const Real squared = direction.squaredNorm();
  const auto along = [&](const Vector3<Real>& u)
  { return u.dot(a[support_index<Real>(a, -u)] - b[support_index<Real>(b, u)]); };
  return squared > Real(0) ? std::max(along(direction), along(-direction)) / std::sqrt(squared)
                           : -std::numeric_limits<Real>::infinity();
}

/// The widest gap between projections along the directions of all faces and pairs of edges.
///
/// For shapes that all but touch, where the way between them is mostly rounding: faces and edges
/// know their direction better.
template <class Real>
Real largest_separation(Corners<Real> a, Corners<Real> b)
{
  Real widest = -std::numeric_limits<Real>::infinity();
  const auto try_edges = [&](const Vector3<Real>& one, const Vector3<Real>& other)
  { widest = std::max(widest, separation_along<Real>(a, b, one.cross(other))); };
  for (const Corners<Real>& shape : {a, b})
  {
    for (std::size_t i = 0; i < shape.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        for (std::size_t k = 0; k < j; ++k)
        {
          try_edges(shape[j] - shape[i], shape[k] - shape[i]);
        }
      }
    }
  }
  for (std::size_t i = 0; i < a.size() * a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size() * b.size(); ++j)
    {
      const std::size_t from_a = i / a.size(), to_a = i % a.size();
      const std::size_t from_b = j / b.size(), to_b = j % b.size();
      if (from_a < to_a && from_b < to_b)
      {
        try_edges(a[to_a] - a[from_a], b[to_b] - b[from_b]);
      }
    }
  }
  return widest;
}
// [largest_separation]

} // namespace cookbook
