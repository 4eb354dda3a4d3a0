#pragma once

/// \file
/// \brief A manifold with one point, of any number type, as one of double.

#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <optional>

namespace cookbook
{

/// A manifold's numbers, as double.
template <class Real>
std::optional<Manifold<double>> as_double(const std::optional<Manifold<Real>>& manifold)
{
  if (!manifold)
  {
    return std::nullopt;
  }
  const double depth = static_cast<double>(manifold->depth);
  const Vector3<double> point = manifold->points[0].position.template cast<double>();
  return Manifold<double>{manifold->normal.template cast<double>(), depth, {{point, depth, 0}}};
}

} // namespace cookbook
