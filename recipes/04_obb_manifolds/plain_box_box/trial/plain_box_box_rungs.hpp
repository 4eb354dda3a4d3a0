#pragma once

/// \file
/// \brief The ladder of the manifold of two boxes: a case for each rung, and what each rung makes
/// of it.

#include "04_obb_manifolds/feature_memory/trial/feature_memory_verdicts.hpp"
#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"

#include <string>
#include <vector>

namespace cookbook
{

// [rungs]
/// A case of the ladder: something that is counted, how many are right, and how many each rung
/// finds.
struct RungCase
{
  std::string what; ///< the boxes, and what is counted
  int right;        ///< by hand
  int least;        ///< face_clipping(): the least overlap of all fifteen axes
  int plain;        ///< plain_box_box(): a face is preferred to nearly parallel edges
  int hardened;     ///< box_box(): any size, and boxes that only touch
  int steady;       ///< next_frame(): box_box() with a memory of the frame before
};

/// A cube of 1 m on another, 1 mm deep, tilted by 1e-4 rad about (1, 5, 2): seen from above, two
/// equal squares about one centre, one turned a little. They share an octagon.
inline BoxPair<double> tilted_stack()
{
  const Vector3<double> half(0.5, 0.5, 0.5);
  return {upright({0, 0, 0}, half), {{0, 0.999, 0}, turned(1e-4, {1, 5, 2}), half}};
}

/// Two upright boxes whose edges touch over 2 m: in the corner of x and y, along z.
inline BoxPair<double> touching_edges()
{
  return {upright({0, 0, 0}, {1, 1, 1}), upright({1, 3, 2}, {1, 2, 1})};
}

/// A cube of 1e-25 m on another, turned by 30° and sunk by 1 %, in float: squares underflow.
inline BoxPair<float> tiny_stack()
{
  const Vector3<float> half(1e-25f, 1e-25f, 1e-25f);
  const Matrix3<float> yaw = turned(std::acos(-1.0) / 6, {0, 1, 0}).cast<float>();
  return {{{0, 0, 0}, Matrix3<float>::Identity(), half}, {{0, 1.98e-25f, 0}, yaw, half}};
}

/// How many contact points a method finds.
template <class Real, class Method>
int count_points(const BoxPair<Real>& pair, const Method& method)
{
  return static_cast<int>(method(pair.first, pair.second)->points.size());
}

/// The four rungs in four cases.
inline std::vector<RungCase> rung_cases()
{
  const auto least = [](const auto& a, const auto& b) { return face_clipping(a, b); };
  const auto plain = [](const auto& a, const auto& b) { return plain_box_box(a, b); };
  const auto hardened = [](const auto& a, const auto& b) { return box_box(a, b); };
  const auto points = [&](const std::string& what, int right, const auto& pair)
  {
    const int found = count_points(pair, hardened); // the first frame has nothing to remember
    return RungCase{what,  right, count_points(pair, least), count_points(pair, plain),
                    found, found};
  };
  const Frames stack = jittered_stack(1e-4), beam = jittered_beam();
  const auto changes = [&](const auto& method)
  {
    return flips(
        axes_over(stack, [&](const auto& a, const auto& b) { return axis_of(method(a, b)); }));
  };
  const auto percent = [](const Persistence& all)
  { return 100 * (all.points - all.right) / all.points; };
  const auto unknown = [&](const auto& method) { return percent(known_by_feature(beam, method)); };
  const auto by_id = carried_by_id<double, std::optional<Vector3<double>>>;
  return {
      points("a cube rests, tilted by 1e-4: points", 8, tilted_stack()),
      points("boxes touch along an edge: points", 2, touching_edges()),
      points("a cube of 1e-25 m rests, float: points", 8, tiny_stack()),
      {"the stack jitters for 1,000 frames: changes of axis", 0, flips(certain_axes(stack)),
       changes(plain), changes(hardened), flips(remembered_axes(stack))},
      {"a beam on its edge jitters: points not known again, %", 0, unknown(least), unknown(plain),
       unknown(hardened), percent(persistence(beam, true, by_id))}};
}
// [rungs]

} // namespace cookbook
