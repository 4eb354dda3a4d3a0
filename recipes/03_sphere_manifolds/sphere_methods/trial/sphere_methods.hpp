#pragma once

/// \file
/// \brief The competing methods for the manifold of two spheres, each named after its idea.

#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace cookbook
{

// [sphere_sphere_as_published]
/// What the code published beside the seed book computes, in our own words; X01, X02.
///
/// The difference of the centres is normalised first, and the depth is then taken from the length
/// of the *unit* vector: |1 − (rA + rB)| / 2 whatever the distance. It is a half depth, doubled
/// here to mean what depth means everywhere. Spheres whose squared distance is zero or too small
/// for a normal float count as apart.
inline std::optional<Manifold<float>>
sphere_sphere_as_published(const Sphere<float>& a, const Sphere<float>& b)
{
  const Vector3<float> a_to_b = b.center - a.center;
  const float squared = a_to_b.squaredNorm();
  const float radii = a.radius + b.radius;
  if (squared > radii * radii || squared < std::numeric_limits<float>::min())
  {
    return std::nullopt;
  }
  const Vector3<float> normal = a_to_b / std::sqrt(squared);
  const float half_depth = std::abs(1 - radii) / 2;
  const Vector3<float> point = a.center + normal * (a.radius - half_depth);
  return Manifold<float>{normal, 2 * half_depth, {{point, 2 * half_depth, 0}}};
}
// [sphere_sphere_as_published]

// [reciprocal_square_root]
/// 1/√x for ordinary x > 0: an estimate from the bits of x, good to 3.5 %, and Newton steps, each
/// of which squares the relative error and multiplies it by 3/2.
///
/// Seen as a whole number, a float is nearly its own logarithm; halved and negated, the logarithm
/// of the answer. The constant is the one that is best on average. Same bits on every machine.
template <int Steps>
float reciprocal_square_root(float x)
{
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(x);
  float y = std::bit_cast<float>(0x5f3759dfu - (bits >> 1));
  for (int step = 0; step < Steps; ++step)
  {
    y = y * (1.5f - 0.5f * x * y * y);
  }
  return y;
}

/// The formula without division and square root: the length is x times 1/√x.
template <int Steps>
std::optional<Manifold<float>>
sphere_sphere_reciprocal(const Sphere<float>& a, const Sphere<float>& b)
{
  const Vector3<float> a_to_b = b.center - a.center;
  const float squared = a_to_b.squaredNorm();
  if (!(squared >= SafeSquares<float>::least && squared <= SafeSquares<float>::most))
  {
    return overlap_manifold<float>(world_overlap(a, b), Vector3<float>::Zero());
  }
  const float reciprocal = reciprocal_square_root<Steps>(squared);
  const float depth = a.radius + b.radius - squared * reciprocal;
  if (depth < 0)
  {
    return std::nullopt;
  }
  const Vector3<float> normal = a_to_b * reciprocal;
  const Vector3<float> point = a.center + normal * (a.radius - depth / 2);
  return Manifold<float>{normal, depth, {{point, depth, 0}}};
}
// [reciprocal_square_root]

} // namespace cookbook
