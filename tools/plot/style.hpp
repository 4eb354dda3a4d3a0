#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cookbook::plot
{

/// What a mark stands for; its colour follows from it, in light and dark alike.
enum class Ink
{
  a,       ///< body A: blue
  b,       ///< body B: orange
  overlap, ///< overlap, depth, failure: red
  ink,     ///< normals, contact points, text
  muted,   ///< secondary text, axes, dimension lines
  good,    ///< a verdict that holds: green
  faint,   ///< grid lines, construction lines
  series1,
  series2,
  series3,
  series4,
  series5,
  series6,
  series7,
  series8
};

/// How a line is dashed, so that series differ in grey too.
enum class Stroke
{
  solid,
  dashed,
  dotted,
  dash_dot
};

/// The shape of a point in a chart, so that series differ in grey too.
enum class Marker
{
  none,
  circle,
  square,
  triangle,
  diamond,
  cross,
  plus,
  inverted_triangle,
  star
};

/// Whether a closed shape is filled.
enum class Fill
{
  none,
  wash, ///< translucent
  solid
};

/// Where a text stands relative to its anchor; `automatic` lets the placement choose freely.
enum class Side
{
  automatic,
  above,
  below,
  left,
  right,
  above_left,
  above_right,
  below_left,
  below_right,
  centre
};

/// Returns the short name of an ink, as used in class names: "a", "overlap", "series3".
std::string_view css_name(Ink ink);

/// Returns the ink of the index-th series, counted from 0, starting again after eight.
Ink series_ink(std::size_t index);

/// Returns the marker of the index-th series, counted from 0. After eight it starts again one
/// farther, so that no two of the first 64 share both colour and marker.
Marker series_marker(std::size_t index);

/// Returns the dash pattern of the index-th series, counted from 0, starting again after four, and
/// one farther after eight.
Stroke series_stroke(std::size_t index);

/// Returns the value of `stroke-dasharray`, or nothing for a solid line.
std::string_view dash_array(Stroke stroke);

/// Returns the style sheet that every figure carries: the same text, scoped to `.cookbook-figure`.
std::string_view style_sheet();

/// Font sizes, in pixels of a figure drawn at its natural width.
inline constexpr double title_size = 15;
inline constexpr double text_size = 14;
inline constexpr double small_size = 12.5;

} // namespace cookbook::plot
