#pragma once

/// \file
/// \brief A manifold somewhere else.

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

} // namespace cookbook
