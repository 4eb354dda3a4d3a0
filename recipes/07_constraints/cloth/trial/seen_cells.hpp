#pragma once

/// \file
/// \brief The cells of a cloth as a picture shows them, and how they are written.

#include "common/math/vector.hpp"
#include "tools/plot/panel.hpp"
#include "tools/plot/svg.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace cookbook
{

/// Where a picture of a cloth is taken from, and how large it is.
struct ClothView
{
  double yaw = 0.4, pitch = 0.3;         ///< [rad], as plot::Camera's
  Vector3<double> center{0, 0, 0};       ///< [m], in the middle of the picture
  double meters = 2;                     ///< [m], across the picture
  double width = 480, height = 400;      ///< [pixels]
  Vector3<double> light{-0.7, 0.5, 0.5}; ///< towards it, as the viewer sees it
  std::string title{}, description{};    ///< of the picture
};

/// A cell of a cloth as it is seen.
struct SeenCell
{
  std::array<Eigen::Vector2d, 4> corners; ///< [pixels]
  double nearness;                        ///< [m], towards the viewer
  double shade;                           ///< 0 in full light, 1 in the dark
  bool front;                             ///< whether its upper side is seen
  bool over;                              ///< whether it lies before all obstacles
  std::size_t column, row;

  /// The pixels that it covers, and a little less.
  Eigen::AlignedBox2d box() const
  {
    Eigen::AlignedBox2d all(corners[0]);
    all.extend(corners[1]).extend(corners[2]).extend(corners[3]);
    return all;
  }
};

/// Appends a number with at most one decimal.
inline void append_tenths(std::string& text, double value)
{
  const long all = std::lround(10 * value), rest = std::abs(all % 10);
  text += all < 0 ? "-" : "";
  text += std::to_string(std::abs(all) / 10);
  text += rest > 0 ? "." : "";
  text += rest > 0 ? std::to_string(rest) : "";
}

/// The outline of a cell in tenths of pixels, as relative steps.
inline std::string outline_of(const SeenCell& cell)
{
  std::string text = "M";
  Eigen::Vector2d at(0, 0);
  for (const Eigen::Vector2d& corner : cell.corners)
  {
    const Eigen::Vector2d to = (10 * corner).array().round() / 10;
    text += text.size() > 1 ? "l" : "";
    append_tenths(text, to.x() - at.x());
    text += " ";
    append_tenths(text, to.y() - at.y());
    at = to;
  }
  text += "z";
  return text;
}

/// Appends an element that draws an outline.
inline void append_path(std::string& body, const char* attribute, const std::string& outline)
{
  body += "<path ";
  body += attribute;
  body += " d=\"";
  body += outline;
  body += "\"/>";
}

/// Whether a cell hides one of those before it that is not its neighbour.
inline bool hides_others(const std::vector<SeenCell>& cells, std::size_t which)
{
  const SeenCell& cell = cells[which];
  const Eigen::AlignedBox2d box = cell.box();
  return std::any_of(
      cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(which),
      [&](const SeenCell& other)
      {
        const auto apart = [](std::size_t i, std::size_t j) { return i > j + 1 || j > i + 1; };
        return (apart(cell.column, other.column) || apart(cell.row, other.row)) &&
               box.intersects(other.box());
      });
}

/// Draws the cells that lie before all obstacles, or the others, from far to near.
inline void draw_cells(plot::Sketch& sketch, const std::vector<SeenCell>& cells, bool over)
{
  std::string paper;
  for (const SeenCell& cell : cells)
  {
    paper += cell.over && over ? outline_of(cell) : "";
  }
  append_path(sketch.body, "class=\"cb-paper\"", paper);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const SeenCell& cell = cells[i];
    if (cell.over == over)
    {
      const std::string outline = outline_of(cell);
      if (hides_others(cells, i))
      {
        append_path(sketch.body, "class=\"cb-paper\"", outline);
      }
      std::string look = cell.front ? "class=\"cb-fill cb-a\"" : "class=\"cb-fill cb-b\"";
      look += " opacity=\"";
      look += plot::svg::number(0.12 + 0.85 * cell.shade);
      look += "\"";
      append_path(sketch.body, look.c_str(), outline);
    }
  }
}

} // namespace cookbook
