#pragma once

/// \file
/// \brief A manifold somewhere else, or of the same shapes in the other order.

#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <cstddef>
#include <optional>

namespace cookbook
{

/// The manifold with its points moved by an offset [m].
template <class Real, std::size_t Capacity>
std::optional<Manifold<Real, Capacity>>
translated(std::optional<Manifold<Real, Capacity>> manifold, const Vector3<Real>& offset)
{
  if (manifold)
  {
    for (ContactPoint<Real>& point : manifold->points)
    {
      point.position += offset;
    }
  }
  return manifold;
}

/// The manifold of the same shapes named the other way round: B and A.
template <class Real, std::size_t Capacity>
std::optional<Manifold<Real, Capacity>> swapped(std::optional<Manifold<Real, Capacity>> manifold)
{
  if (manifold)
  {
    manifold->normal = -manifold->normal;
  }
  return manifold;
}

} // namespace cookbook
