#pragma once

#include "tools/plot/style.hpp"
#include "tools/plot/text.hpp"

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cookbook::plot
{

/// A rectangle in pixels, y down.
struct Rect
{
  double left;
  double top;
  double right;
  double bottom;
};

/// Whether two rectangles share an area; touching ones do not.
bool overlap(const Rect& p, const Rect& q);

/// A text that wants a place beside its anchor.
struct Label
{
  Eigen::Vector2d anchor; ///< [pixels]
  double clearance;       ///< [pixels] between the anchor and the text
  std::string text;
  Side side = Side::automatic;
  Ink ink = Ink::ink;
  double font_size = text_size;
  bool strong = false;
};

/// A label that has found its place.
struct PlacedLabel
{
  Label label;
  Rect box;                     ///< [pixels]
  Eigen::Vector2d baseline;     ///< where the text is anchored [pixels]
  std::string_view text_anchor; ///< start, middle, end
  bool leader;                  ///< so far from its anchor that a thin line joins them
  std::pair<Eigen::Vector2d, Eigen::Vector2d> leader_line; ///< [pixels]
};

/// What labels keep clear of.
struct Obstacles
{
  std::vector<Rect> rects;                                           ///< points, other texts
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> segments; ///< strokes
};

/// Places labels one after the other: each takes the candidate that costs least in overlaps with
/// the labels before it, with obstacles, and in distance from where it wants to be.
///
/// Deterministic: ties go to the earlier candidate. No two placed labels overlap unless
/// `bounds` is too full for it.
std::vector<PlacedLabel>
place_labels(const std::vector<Label>& labels, const Obstacles& obstacles, const Rect& bounds);

} // namespace cookbook::plot
