#pragma once

/// \file
/// \brief The verdict on each method from frame to frame: does its axis stay, do its points?

#include "02_primitives/boxes_overlap/box_axes.hpp"
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"
#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "04_obb_manifolds/feature_memory/trial/feature_memory_scenes.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "tools/program/verdicts.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// What a method makes of boxes, frame after frame; a part that it does not have is empty.
struct FrameMethod
{
  std::string name;                                       ///< of its function
  std::function<std::vector<int>(const Frames&)> axes;    ///< the axis it names in each frame
  std::function<Persistence(const Frames&)> known_points; ///< what becomes of its points' data
};

/// What becomes of the data of a method's points, carried over by feature; `answer(a, b)` gives
/// its manifold.
template <class Answer>
Persistence known_by_feature(const Frames& frames, const Answer& answer)
{
  using Points = std::vector<ContactPoint<double>>;
  Persistence all;
  Points before;
  for (const auto& [a, b] : frames)
  {
    const auto manifold = answer(a, b);
    const Points now(manifold->points.begin(), manifold->points.end());
    const bool first = &a == &frames.front().first;
    for (const ContactPoint<double>& point : now)
    {
      const auto same = std::find_if(
          before.begin(), before.end(),
          [&](const ContactPoint<double>& old) { return old.feature == point.feature; });
      const bool known = same != before.end();
      const bool close_by = known && (same->position - point.position).norm() < 0.01;
      all.points += first ? 0 : 1;
      all.right += close_by ? 1 : 0;
      all.wrong += known && !close_by ? 1 : 0;
    }
    before = now;
  }
  return all;
}

/// The axis of face_clipping().
inline std::vector<int> certain_axes(const Frames& frames)
{
  return axes_over(
      frames,
      [](const Obb<double>& a, const Obb<double>& b)
      {
        const auto least = least_with_certain_edges(a, b);
        return least ? least->axis : -1;
      });
}

/// All methods: those without a memory, then box_box() and next_frame(), their points known by
/// index and by feature.
inline std::vector<FrameMethod> frame_methods()
{
  using Place = std::optional<Vector3<double>>;
  const auto by_feature = [](const auto& answer)
  { return [answer](const Frames& frames) { return known_by_feature(frames, answer); }; };
  const auto carried = [](bool with_memory, const auto& match)
  { return [=](const Frames& frames) { return persistence(frames, with_memory, match); }; };
  const auto by_index = carried_by_index<double, Place>;
  const auto by_id = carried_by_id<double, Place>;
  return {
      {"separating_axes", least_axes, {}},
      {"edge_clipping", least_axes,
       by_feature([](const auto& a, const auto& b) { return edge_clipping(a, b); })},
      {"face_clipping", certain_axes,
       by_feature([](const auto& a, const auto& b) { return face_clipping(a, b); })},
      {"gjk_epa", {}, by_feature([](const auto& a, const auto& b) { return gjk_epa(a, b); })},
      {"box_box, by index", forgetful_axes, carried(false, by_index)},
      {"box_box", forgetful_axes, carried(false, by_id)},
      {"next_frame, by index", remembered_axes, carried(true, by_index)},
      {"next_frame", remembered_axes, carried(true, by_id)}};
}

/// Right if the axis changes at most once.
inline Verdict verdict_on_axes(const FrameMethod& method, const Frames& frames)
{
  if (!method.axes)
  {
    return does_not_apply("names no axis");
  }
  const int changes = flips(method.axes(frames));
  return {changes <= 1, changes == 0 ? "stays" : std::to_string(changes) + " changes"};
}

/// Right if 95 % of the points are given what was known of them, and none what belongs to another.
inline Verdict verdict_on_points(const FrameMethod& method, const Frames& frames)
{
  if (!method.known_points)
  {
    return does_not_apply("no points");
  }
  const Persistence all = method.known_points(frames);
  const std::string lost = std::to_string(all.points - all.right - all.wrong) + " lost";
  const std::string wrong = std::to_string(all.wrong) + " mistaken";
  return {
      all.wrong == 0 && 100 * all.right >= 95 * all.points,
      lost + ", " + wrong + " of " + std::to_string(all.points)};
}

/// What all methods make of all cases; a neighbour of G10 has no id of its own.
inline std::vector<VerdictRow> frame_verdicts()
{
  std::vector<VerdictRow> rows{
      {"G10", "a stack tilted by 1e-4 jitters for 1,000 frames: its axis", {}},
      {"", "the same, tilted by 1e-8", {}},
      {"", "the same, tilted by 1e-2", {}},
      {"G20", "a cube slides for 5 s: its points", {}},
      {"", "a beam lies on its edge across a cube and jitters: its points", {}}};
  const Frames tilted[] = {jittered_stack(1e-4), jittered_stack(1e-8), jittered_stack(1e-2)};
  for (const FrameMethod& method : frame_methods())
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      rows[i].verdicts.push_back(verdict_on_axes(method, tilted[i]));
    }
    rows[3].verdicts.push_back(verdict_on_points(method, sliding_cube()));
    rows[4].verdicts.push_back(verdict_on_points(method, jittered_beam()));
  }
  return rows;
}

} // namespace cookbook
