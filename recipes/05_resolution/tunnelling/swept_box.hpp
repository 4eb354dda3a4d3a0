#pragma once

/// \file
/// \brief When two boxes that move and turn first touch.

#include "02_primitives/boxes_overlap/box_axes.hpp"
#include "05_resolution/tunnelling/swept_sphere.hpp"
#include "common/math/norm.hpp"

#include <cmath>
#include <limits>

namespace cookbook
{

// [swept_box]
/// A box that moves straight on and turns about its centre, both evenly.
template <class Real>
struct SweptBox
{
  Obb<Real> box;              ///< at time 0
  Vector3<Real> displacement; ///< [m], world, until time 1
  Vector3<Real> rotation;     ///< [rad], world, axis times angle until time 1
};

/// The box at a time, 0 to 1.
template <class Real>
Obb<Real> box_at(const SweptBox<Real>& swept, Real time)
{
  const Direction<Real> rotation = normalize(swept.rotation);
  const Eigen::AngleAxis<Real> turned(time * rotation.length, rotation.unit);
  return {
      swept.box.center + time * swept.displacement, turned.toRotationMatrix() * swept.box.axes,
      swept.box.half_extents};
}

/// The fastest [m] that any corner is carried round its centre until time 1.
template <class Real>
Real rotation_bound(const SweptBox<Real>& swept)
{
  return swept.rotation.norm() * swept.box.half_extents.norm();
}
// [swept_box]

// [box_gap]
/// The axis along which two boxes are farthest apart, from A to B, and how far [m] they are there.
///
/// Negative where they overlap. Boxes are at least that far apart, and exactly so along the axis.
template <class Real>
Direction<Real> box_gap(const Obb<Real>& a, const Obb<Real>& b)
{
  using std::sqrt;
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  Direction<Real> widest{Vector3<Real>::Zero(), -std::numeric_limits<Real>::max()};
  for (int axis = 0; axis < box_axes; ++axis)
  {
    const AxisOverlap<Real> along = axis_overlap(boxes, axis);
    const Real length = sqrt(along.squared_length);
    if (!from_parallel_edges(along) && -along.overlap > widest.length * length)
    {
      const Real sign = along.offset < Real(0) ? Real(-1) : Real(1);
      widest = {a.axes * along.axis * (sign / length), -along.overlap / length};
    }
  }
  return widest;
}
// [box_gap]

// [advance_boxes]
/// What two boxes see of each other at one time.
template <class Real>
struct BoxApproach
{
  Direction<Real> gap; ///< from A to B, and how far apart [m] they are there
  bool closes;         ///< whether they go on inwards where they touch
  Real safe_time;      ///< [1], for how long the gap is certain to last
};

/// The most steps that an advance of two boxes takes.
inline constexpr int max_box_advances = 50;

/// Advances two boxes by what their gap allows, from a time to 1, to a gap of `tolerance` [m].
///
/// Nothing where they do not touch within the displacement. After `max_box_advances` they stop
/// short, where they are.
template <class Real, class Query>
std::optional<SweptHit<Real>> advance_boxes(Real time, const Real& tolerance, const Query& query)
{
  for (int i = 0;; ++i)
  {
    const BoxApproach<Real> now = query(time);
    if (i == max_box_advances || (now.gap.length <= tolerance && now.closes))
    {
      return SweptHit<Real>{time, now.gap.unit};
    }
    if (!(time + now.safe_time <= Real(1)))
    {
      return std::nullopt;
    }
    time += now.safe_time;
  }
}
// [advance_boxes]

// [swept_boxes]
/// The first touch of two boxes that move and turn, to a gap of `tolerance` [m]; P20.
///
/// Nothing where they do not touch within the displacement; time 0 where they do at the start. The
/// normal points from A to B.
template <class Real>
std::optional<SweptHit<Real>>
swept_boxes(const SweptBox<Real>& a, const SweptBox<Real>& b, Real tolerance)
{
  const Vector3<Real> approach = a.displacement - b.displacement;
  const Real turning = rotation_bound(a) + rotation_bound(b);
  const auto query = [&](const Real& time)
  {
    const Direction<Real> gap = box_gap(box_at(a, time), box_at(b, time));
    const Real closing = approach.dot(gap.unit) + turning;
    return BoxApproach<Real>{gap, true, safe_time(gap.length, closing, Real(0))};
  };
  return advance_boxes(Real(0), tolerance, query);
}
// [swept_boxes]

} // namespace cookbook
