#pragma once

/// \file
/// \brief How many floating-point operations the manifold of a pair of boxes takes, counted by
/// running the code of box_pairs on numbers that count.

#include "04_obb_manifolds/box_box/box_choice.hpp"
#include "04_obb_manifolds/box_box/box_contacts.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_pair.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [counted]
/// A float that counts what is done with it: each +, −, ×, ÷ and square root, but no comparison,
/// minimum, choice or change of sign.
struct Counted
{
  float value = 0;

  Counted() = default;
  Counted(float v) : value(v) {}

  static inline std::size_t flops = 0; ///< so far

  /// What a comparison gives.
  struct Mask
  {
    bool set;
    friend Mask operator&(Mask a, Mask b) { return {a.set && b.set}; }
    friend Mask operator|(Mask a, Mask b) { return {a.set || b.set}; }
  };

  /// A result that took one operation.
  static Counted one_more(float result)
  {
    ++flops;
    return {result};
  }

  friend Counted operator+(Counted a, Counted b) { return one_more(a.value + b.value); }
  friend Counted operator-(Counted a, Counted b) { return one_more(a.value - b.value); }
  friend Counted operator*(Counted a, Counted b) { return one_more(a.value * b.value); }
  friend Counted operator/(Counted a, Counted b) { return one_more(a.value / b.value); }
  friend Counted sqrt(Counted a) { return one_more(std::sqrt(a.value)); }
  friend Counted operator-(Counted a) { return {-a.value}; }
  friend Counted abs(Counted a) { return {std::abs(a.value)}; }
  friend Counted min(Counted a, Counted b) { return {a.value < b.value ? a.value : b.value}; }
  friend Counted max(Counted a, Counted b) { return {a.value > b.value ? a.value : b.value}; }
  friend Counted copysign(Counted a, Counted b) { return {std::copysign(a.value, b.value)}; }
  friend Mask operator<(Counted a, Counted b) { return {a.value < b.value}; }
  friend Mask operator<=(Counted a, Counted b) { return {a.value <= b.value}; }
  friend Mask operator>(Counted a, Counted b) { return {a.value > b.value}; }
  friend Mask operator>=(Counted a, Counted b) { return {a.value >= b.value}; }
  friend bool any(Mask mask) { return mask.set; }
};

/// One of two numbers.
inline Counted select(Counted::Mask mask, Counted yes, Counted no)
{
  return mask.set ? yes : no;
}
// [counted]

} // namespace cookbook

/// What Eigen needs to know of a number that counts.
template <>
struct Eigen::NumTraits<cookbook::Counted> : Eigen::GenericNumTraits<cookbook::Counted>
{
  using Real = cookbook::Counted;       ///< its own real part
  using NonInteger = cookbook::Counted; ///< itself
  using Nested = cookbook::Counted;     ///< kept in expressions by value
};

namespace cookbook
{

/// What a counting number is made of.
template <>
struct PartOf<Counted>
{
  using type = float; ///< the number that is computed with
};

// [box_flops]
/// How many operations a pair takes.
struct BoxFlops
{
  std::size_t overlaps; ///< [1], to know whether they overlap along all fifteen axes
  std::size_t all;      ///< [1], for the whole answer
};

/// Counts the operations of one pair, in the order in which box_pairs does them.
inline BoxFlops box_flops(const Obb<float>& in_float, const Obb<float>& other_in_float)
{
  const auto counted = [](const Obb<float>& box)
  {
    const auto number = [](float x) { return Counted(x); };
    return Obb<Counted>{
        box.center.unaryExpr(number), box.axes.unaryExpr(number),
        box.half_extents.unaryExpr(number)};
  };
  const Obb<Counted> a = counted(in_float), b = counted(other_in_float);
  using Three = Group<Counted, 3>;
  Counted::flops = 0;
  const BoxesInRows<Three> boxes = boxes_in_rows<Three>(a, b);
  const Three face_a = face_overlaps(boxes.half_a, boxes.columns, boxes.half_b, boxes.offset_a);
  const Three face_b = face_overlaps(boxes.half_b, boxes.rows, boxes.half_a, boxes.offset_b);
  const EdgeOverlaps<Three> edges[] = {
      edge_overlaps(boxes, 0), edge_overlaps(boxes, 1), edge_overlaps(boxes, 2)};
  // Who only asks whether they overlap needs no squared lengths, two products and a sum each.
  const std::size_t overlaps = Counted::flops - 9 * 3;
  const Three least =
      min(min(min(face_a, face_b), edges[0].overlap), min(edges[1].overlap, edges[2].overlap));
  if (any(RowTraits<Three>::any(least < Three(Counted(0)))))
  {
    return {overlaps, overlaps};
  }
  const Tolerances<Counted> tolerances = tolerances_of(a, b);
  const LeastFace<Counted> face = least_face(face_a, face_b);
  const LeastEdge<Counted> edge = least_edge(edges, edge_threshold(boxes, face.depth, tolerances));
  // Either contact takes as many operations on one axis as on any other.
  const auto first = which(Counted(0));
  if (any(edge.found()))
  {
    edge_contact(a, boxes, first, first);
    sqrt(edge.squared_depth);
  }
  else
  {
    face_contact(
        a, b, boxes.rows, boxes.offset_a, first,
        kept_separation(face.depth, tolerances.margin, tolerances.length), tolerances.length);
  }
  return {overlaps, Counted::flops};
}
// [box_flops]

} // namespace cookbook
