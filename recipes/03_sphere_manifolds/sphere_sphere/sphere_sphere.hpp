#pragma once

/// \file
/// \brief The manifold of two spheres.

#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/manifold/build.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "common/math/norm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace cookbook
{

// [depth_at]
/// The depth rA + rB − |t| of two spheres; S1.
///
/// In this order the first difference is exact wherever it matters, for the larger radius and the
/// distance are then within a factor of two of each other: rA + rB would be rounded.
template <class Real>
Real depth_at(const Real& distance, const Real& radius_a, const Real& radius_b)
{
  using std::max, std::min;
  return (max(radius_a, radius_b) - distance) + min(radius_a, radius_b);
}

/// How far the contact point is from A's centre, rA − d/2 = (rA − rB + |t|) / 2; S4.
///
/// Halves are added, not the whole halved: they stay finite where the depth does not.
template <class Real>
Real contact_offset(const Real& distance, const Real& radius_a, const Real& radius_b)
{
  return (radius_a - radius_b) * Real(0.5) + distance * Real(0.5);
}
// [depth_at]

// [sphere_overlap]
/// How a sphere A overlaps B along the line that joins them.
template <class Real>
struct SphereOverlap
{
  Vector3<Real> normal;   ///< [1], unit, from A to B
  Real depth;             ///< [m], negative where the two are apart
  Vector3<Real> position; ///< [m], of the contact point from A's centre
};

/// The overlap of a sphere A with a sphere B in a direction and at a distance; S1, S2, S4.
///
/// A surface is a sphere of radius zero at its closest point; its distance is negative where A's
/// centre is inside. `Real` may be a pack of numbers: then many pairs are answered at once.
template <class Real>
SphereOverlap<Real>
sphere_overlap(const Direction<Real>& a_to_b, const Real& radius_a, const Real& radius_b)
{
  const Real depth = depth_at(a_to_b.length, radius_a, radius_b);
  return {a_to_b.unit, depth, a_to_b.unit * contact_offset(a_to_b.length, radius_a, radius_b)};
}
// [sphere_overlap]

// [overlap_manifold]
/// The manifold of an overlap, its point moved to where A's centre is: nothing where the depth is
/// negative, one point where it is zero or more.
template <class Real>
std::optional<Manifold<Real>>
overlap_manifold(const SphereOverlap<Real>& overlap, const Vector3<Real>& center_a)
{
  if (!(overlap.depth >= Real(0)))
  {
    return std::nullopt;
  }
  const auto written_in_place = [&]
  {
    Manifold<Real> manifold{overlap.normal, overlap.depth, {}};
    manifold.points.push_back({center_a + overlap.position, overlap.depth, 0});
    return manifold;
  };
  return std::optional<Manifold<Real>>(std::in_place, Build(written_in_place));
}
// [overlap_manifold]

// [sphere_sphere_relative]
/// The manifold of two spheres in A's frame, where A's centre is the origin.
///
/// For worlds far from the origin: keep positions in double, subtract them there, and pass the
/// difference [m] as float. Concentric spheres separate along +y.
template <class Real>
std::optional<Manifold<Real>>
sphere_sphere_relative(const Vector3<Real>& a_to_b, Real radius_a, Real radius_b)
{
  return overlap_manifold<Real>(
      sphere_overlap(normalize(a_to_b), radius_a, radius_b), Vector3<Real>::Zero());
}
// [sphere_sphere_relative]

// [world_overlap]
/// The overlap of two spheres of any finite size, its position in the world.
///
/// Where a sum might not fit the number type, it is taken of quarters: exact, as four is a power
/// of two. A result that does not fit is infinite; none is NaN.
template <class Real>
[[gnu::noinline, gnu::cold]] SphereOverlap<Real>
world_overlap(const Sphere<Real>& a, const Sphere<Real>& b)
{
  const Real size = std::max(
      {a.center.cwiseAbs().maxCoeff(), b.center.cwiseAbs().maxCoeff(), a.radius, b.radius});
  const Real scale = Real(size > std::numeric_limits<Real>::max() / 16 ? 0.25 : 1);
  const SphereOverlap<Real> overlap = sphere_overlap<Real>(
      normalize<Real>(b.center * scale - a.center * scale), a.radius * scale, b.radius * scale);
  const Vector3<Real> position = a.center * scale + overlap.position;
  return {overlap.normal, overlap.depth / scale, position / scale};
}
// [world_overlap]

// [sphere_sphere]
/// The manifold of two spheres: nothing where they are apart; touching is contact of depth zero.
///
/// Any finite centres and radii; concentric spheres separate along +y.
template <class Real>
std::optional<Manifold<Real>> sphere_sphere(const Sphere<Real>& a, const Sphere<Real>& b)
{
  const Vector3<Real> a_to_b = b.center - a.center;
  const Real squared = a_to_b.squaredNorm();
  if (squared >= SafeSquares<Real>::least && squared <= SafeSquares<Real>::most)
  {
    return overlap_manifold<Real>(
        sphere_overlap<Real>(split<Real>(a_to_b, squared), a.radius, b.radius), a.center);
  }
  return overlap_manifold<Real>(world_overlap(a, b), Vector3<Real>::Zero());
}
// [sphere_sphere]

} // namespace cookbook
