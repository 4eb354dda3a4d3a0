#pragma once

/// \file
/// \brief The manifold of two boxes by the general method: GJK decides, EPA measures; one point.

#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"
#include "04_obb_manifolds/gjk_epa/epa.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cookbook
{

// [contact_on_ray]
/// The point where the ray along the best normal leaves the polytope, and A's point that it came
/// from.
///
/// A point of a face is a mixture of its corners, and A's point is the same mixture of theirs. Of
/// all faces the one that comes closest to `depth` along the ray counts.
template <class Real>
SupportPoint<Real> contact_on_ray(const Expansion<Real>& expansion)
{
  const Polytope<Real>& polytope = expansion.polytope;
  const Vector3<Real> target = expansion.depth * expansion.normal;
  SupportPoint<Real> contact = expansion.found;
  for (std::size_t f = 0; f < polytope.face_count; ++f)
  {
    const SupportPoint<Real>& p = polytope.corner(polytope.faces[f], 0);
    const SupportPoint<Real>& q = polytope.corner(polytope.faces[f], 1);
    const SupportPoint<Real>& r = polytope.corner(polytope.faces[f], 2);
    const auto turn = [&](const SupportPoint<Real>& from, const SupportPoint<Real>& to)
    { return std::max(Real(0), expansion.normal.dot(from.point.cross(to.point))); };
    const Vector3<Real> turns(turn(q, r), turn(r, p), turn(p, q));
    if (turns.sum() > Real(0))
    {
      const Vector3<Real> weights = turns / turns.sum();
      const auto mixed = [&](auto member) -> Vector3<Real>
      { return weights[0] * p.*member + weights[1] * q.*member + weights[2] * r.*member; };
      const Vector3<Real> point = mixed(&SupportPoint<Real>::point);
      const bool closer = (point - target).squaredNorm() < (contact.point - target).squaredNorm();
      contact = closer ? SupportPoint<Real>{point, mixed(&SupportPoint<Real>::on_a)} : contact;
    }
  }
  return contact;
}
// [contact_on_ray]

// [scaled]
/// Both boxes with their lengths divided by a power of two, which rounds nothing.
template <class Real>
RelativeBoxes<Real> scaled_down(const RelativeBoxes<Real>& boxes, int exponent)
{
  using std::ldexp;
  const auto down = [&](const Vector3<Real>& v)
  { return v.unaryExpr([&](Real x) { return Real(ldexp(x, -exponent)); }).eval(); };
  return {
      boxes.rotation, boxes.absolute, down(boxes.offset), down(boxes.half_a), down(boxes.half_b)};
}

/// Two boxes in A's frame and in the wider type, the larger half extent between 1 and 2.
template <class Real>
struct ScaledBoxes
{
  RelativeBoxes<Wide<Real>> boxes; ///< lengths divided by 2 to the exponent
  int exponent;                    ///< of two

  /// Takes the numbers from two boxes.
  ScaledBoxes(const Obb<Real>& a, const Obb<Real>& b)
  {
    const auto wide = [](const Obb<Real>& box) -> Obb<Wide<Real>> {
      return {widen(box.center), widen(box.axes), widen(box.half_extents)};
    };
    boxes = relative_boxes(wide(a), wide(b));
    const Wide<Real> largest = std::max(boxes.half_a.maxCoeff(), boxes.half_b.maxCoeff());
    exponent = largest > Wide<Real>(0) ? std::ilogb(largest) : 0;
    boxes = scaled_down(boxes, exponent);
  }
};
// [scaled]

// [gjk_epa]
/// Which features of two boxes meet along a normal in A's frame: corner, edge or face of each.
///
/// For each axis of A, then of B, a digit 0, 1 or 2: the negative side, level within √ε, the
/// positive side; plus one.
template <class Real>
std::uint32_t met_features(const RelativeBoxes<Real>& boxes, const Vector3<Real>& normal)
{
  const Real level = same_point<Real>();
  const Vector3<Real> in_b = boxes.rotation.transpose() * -normal;
  std::uint32_t digits = 0;
  for (const Vector3<Real>& direction : {normal, in_b})
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      digits = 3 * digits + static_cast<std::uint32_t>(1 + side_of_face(direction[axis], level));
    }
  }
  return digits + 1;
}

/// The manifold of two boxes by support points alone: the least overlap, and one contact point.
///
/// Nothing where they are apart; touching is an overlap of depth 0, and separates() decides
/// throughout. The point is midway between two points of the boxes that meet along the normal:
/// where faces meet it is one of many, and which of equal normals comes out is chance, but the same
/// on every run. Float computes in double. Distances and sums of half extents must be finite.
template <class Real>
std::optional<Manifold<Real>> gjk_epa(const Obb<Real>& a, const Obb<Real>& b)
{
  using std::ldexp;
  const ScaledBoxes<Real> scaled(a, b);
  const RelativeBoxes<Wide<Real>>& boxes = scaled.boxes;
  const Wide<Real> extent = boxes.half_a.sum() + boxes.half_b.sum();
  if (!(boxes.offset.cwiseAbs().maxCoeff() <= extent))
  {
    return std::nullopt;
  }
  const MinkowskiDifference<Wide<Real>> support{boxes};
  const Wide<Real> tolerance = rounding_tolerance(boxes);
  const GjkAnswer<Wide<Real>> decision = gjk(support, boxes.offset, tolerance);
  if (decision.apart)
  {
    return std::nullopt;
  }
  const Expansion<Wide<Real>> closest = epa(support, decision.simplex, tolerance);
  if (closest.depth < Wide<Real>(0))
  {
    return std::nullopt;
  }
  const SupportPoint<Wide<Real>> contact = contact_on_ray(closest);
  const auto up = [&](Wide<Real> x) { return ldexp(x, scaled.exponent); };
  const Vector3<Wide<Real>> middle = (contact.on_a - contact.point / 2).unaryExpr(up);
  const Vector3<Wide<Real>> normal = widen(a.axes) * closest.normal;
  const Vector3<Wide<Real>> position = widen(a.center) + widen(a.axes) * middle;
  const Real depth = static_cast<Real>(up(closest.depth));
  const ContactPoint<Real> point{
      position.template cast<Real>(), depth, met_features(boxes, closest.normal)};
  return Manifold<Real>{
      normalize(normal).unit.template cast<Real>(), depth, ContactPoints<Real, 8>(point)};
}
// [gjk_epa]

} // namespace cookbook
