#pragma once

/// \file
/// \brief The collision manifold: normal, depth and contact points of two shapes that overlap.

#include "common/math/vector.hpp"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace cookbook
{

/// One point where two shapes press on each other.
template <class Real>
struct ContactPoint
{
  Vector3<Real> position; ///< [m], world, midway between the two surfaces
  Real depth;             ///< [m], overlap along the normal at this point; negative: a gap
  std::uint32_t feature;  ///< which features of the shapes meet here; 0 where there is one choice
};

/// Up to `Capacity` contact points in place, without the heap.
template <class Real, std::size_t Capacity>
class ContactPoints
{
public:
  /// No points.
  ContactPoints() {}

  /// One point.
  ContactPoints(const ContactPoint<Real>& point) { push_back(point); }

  /// Copies the points that are there, not the room left for others.
  ContactPoints(const ContactPoints& other) { *this = other; }

  /// Copies the points that are there, not the room left for others.
  ContactPoints& operator=(const ContactPoints& other)
  {
    size_ = other.size_;
    for (std::size_t i = 0; i < size_; ++i)
    {
      points_[i] = other.points_[i];
    }
    return *this;
  }

  /// Adds a point; there must be room for it.
  void push_back(const ContactPoint<Real>& point)
  {
    assert(size_ < Capacity);
    points_[size_++] = point;
  }

  /// Has a point written where it is to stay, and keeps it only if asked to: no branch that is hard
  /// to predict. There must be room for it either way.
  template <class Write>
  void emplace_back_if(bool kept, const Write& write)
  {
    assert(size_ < Capacity);
    write(points_[size_]);
    size_ += kept ? 1 : 0;
  }

  std::size_t size() const { return size_; } ///< how many points there are
  bool empty() const { return size_ == 0; }  ///< whether there are none

  /// The i-th point, i < size().
  const ContactPoint<Real>& operator[](std::size_t i) const { return points_[i]; }
  /// The i-th point, i < size().
  ContactPoint<Real>& operator[](std::size_t i) { return points_[i]; }

  const ContactPoint<Real>* begin() const { return points_.data(); }       ///< first point
  const ContactPoint<Real>* end() const { return points_.data() + size_; } ///< past the last
  ContactPoint<Real>* begin() { return points_.data(); }                   ///< first point
  ContactPoint<Real>* end() { return points_.data() + size_; }             ///< past the last

private:
  std::array<ContactPoint<Real>, Capacity> points_;
  std::size_t size_ = 0;
};

// [manifold]
/// How two overlapping shapes touch.
template <class Real, std::size_t Capacity = 8>
struct Manifold
{
  Vector3<Real> normal;                 ///< [1], unit, world, from shape A to shape B
  Real depth;                           ///< [m], the whole overlap along the normal, zero or more
  ContactPoints<Real, Capacity> points; ///< at least one
};

/// Half the depth [m]: how far each of the two bodies moves to separate them.
template <class Real, std::size_t Capacity>
Real penetration_distance(const Manifold<Real, Capacity>& manifold)
{
  return manifold.depth / Real(2);
}
// [manifold]

} // namespace cookbook
