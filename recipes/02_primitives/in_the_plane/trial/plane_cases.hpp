#pragma once

/// \file
/// \brief Shapes in the plane that break some way of answering.

#include "02_primitives/in_the_plane/trial/plane_pitfalls.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <string>
#include <vector>

namespace cookbook
{

/// A question, its answer, and what three ways say: as published, with a small number, ours.
struct CaseInPlane
{
  std::string id;                     ///< in the book; empty for a neighbour of the case above
  std::string what;                   ///< the shapes, as text
  std::string truth;                  ///< known by hand
  std::array<std::string, 3> answers; ///< of the ways, in their order
};

/// The names of the ways.
inline std::vector<std::string> names_in_plane()
{
  return {"as published", "with an epsilon", "recommended"};
}

/// Whether a point is on a segment.
inline CaseInPlane point_case(
    const std::string& id, const std::string& what, const std::string& truth,
    const Vector<double, 2>& p, const Segment2<double>& s)
{
  const auto text = [](bool on) { return std::string(on ? "on it" : "off"); };
  return {
      id,
      what,
      truth,
      {text(on_segment_by_slope(s, p)), text(on_segment_by_epsilon(s, p)), text(overlaps(p, s))}};
}

/// Whether a segment meets a circle.
inline CaseInPlane circle_case(
    const std::string& id, const std::string& what, const std::string& truth,
    const Segment2<double>& s, const Circle<double>& c)
{
  const auto text = [](bool hit) { return std::string(hit ? "hit" : "miss"); };
  return {
      id,
      what,
      truth,
      {text(meets_circle_without_ends(s, c)), text(meets_circle_without_ends(s, c, 1e-3)),
       text(overlaps(s, c))}};
}

/// Where a segment enters a rectangle.
inline CaseInPlane rectangle_case(
    const std::string& id, const std::string& what, const std::string& truth,
    const Segment2<double>& s, const Rectangle<double>& r)
{
  const auto text = [](const std::optional<double>& t)
  { return t ? "t = " + number(*t) : std::string("miss"); };
  const auto hit = cast(s, r);
  return {
      id,
      what,
      truth,
      {text(entry_by_inverse(s, r)), text(entry_by_epsilon(s, r)),
       text(hit ? std::optional(hit->t) : std::nullopt)}};
}

/// Which way two circles part, and how far.
inline CaseInPlane translation_case(
    const std::string& id, const std::string& what, const std::string& truth,
    const Circle<double>& a, const Circle<double>& b)
{
  const auto text = [](const MinimumTranslation<double>& translation)
  {
    const std::string along = translation.normal.y() == 1   ? "+y"
                              : translation.normal.x() == 1 ? "+x"
                                                            : "no normal";
    return along + ", depth " + number(translation.depth);
  };
  const bool has_normal = minimum_translation_unguarded(a, b).normal.allFinite();
  return {
      id,
      what,
      truth,
      {has_normal ? text(minimum_translation_unguarded(a, b)) : "no normal",
       text(minimum_translation_by_epsilon(a, b)), text(minimum_translation(a, b))}};
}

/// The cases to try.
inline std::vector<CaseInPlane> cases_in_plane()
{
  const Segment2<double> unit{{0, 0}, {1, 0}}, wide{{-1, 0}, {1, 0}};
  const Rectangle<double> square{{0, 0}, {1, 1}}, thin{{90, 0}, {1, 1e-6}};
  return {
      point_case("B2", "(1, 1) on a vertical segment", "on it", {1, 1}, {{1, 0}, {1, 2}}),
      point_case("", "8 m beyond a segment's end", "off", {9, 0}, unit),
      point_case("", "0.05 mm above a segment", "off", {0, 5e-5}, wide),
      circle_case("B3", "a circle around a segment's end", "hit", unit, {{1.5, 0}, 1}),
      circle_case("", "a circle over its middle", "hit", unit, {{0.5, 0.5}, 1}),
      rectangle_case("B1", "along x through a square", "t = 0.4", {{-5, 0}, {5, 0}}, square),
      rectangle_case("", "along the diagonal", "t = 0.4", {{-5, -5}, {5, 5}}, square),
      rectangle_case("", "along x, a thin one 90 m away", "t = 0.89", {{0, 0}, {100, 0}}, thin),
      translation_case("B5", "circles about one centre", "+y, depth 2", {{3, 3}, 1}, {{3, 3}, 1}),
      translation_case(
          "", "circles of 0.2 µm, half overlapped", "+x, depth 1e-07", {{0, 0}, 1e-7},
          {{1e-7, 0}, 1e-7})};
}

/// The verdicts on all ways.
inline std::vector<VerdictRow> verdicts_in_plane()
{
  std::vector<VerdictRow> all;
  for (const CaseInPlane& one : cases_in_plane())
  {
    all.push_back({one.id, one.what, {}});
    for (const std::string& answer : one.answers)
    {
      all.back().verdicts.push_back({answer == one.truth, answer == one.truth ? "right" : answer});
    }
  }
  return all;
}

} // namespace cookbook
