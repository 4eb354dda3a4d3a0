#pragma once

#include "tools/plot/panel.hpp"
#include "tools/plot/style.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace cookbook::plot
{

/// The part of the world a figure shows: a rectangle (y up), drawn `width` pixels wide.
struct View
{
  Eigen::Vector2d min; ///< lower left corner, world
  Eigen::Vector2d max; ///< upper right corner, world
  double width = 480;  ///< [pixels]; the height follows, for the axes are equal
};

/// A plane figure in world coordinates, y up, with equal axes.
///
/// Everything is drawn in the order of the calls, texts last. Every call returns the figure, so
/// that calls chain. A coordinate that is NaN or infinite throws std::invalid_argument naming
/// the element. Texts may hold `_{sub}` and `^{super}`.
class Figure2d
{
public:
  /// Starts an empty figure; `name` (letters, digits, `_`, `-`) makes its ids unique on a page.
  /// An empty `title` is not drawn.
  Figure2d(std::string name, std::string title, View view);

  /// Says in a sentence what the figure shows, for readers that cannot see it.
  Figure2d& describe(std::string text);

  /// Draws the outline of a sphere.
  Figure2d& circle(
      const Eigen::Vector2d& center, double radius, Ink ink, Fill fill = Fill::wash,
      Stroke stroke = Stroke::solid);

  /// Draws a box turned by `angle` [rad, counter-clockwise].
  Figure2d&
  box(const Eigen::Vector2d& center, double angle, const Eigen::Vector2d& half_extents, Ink ink,
      Fill fill = Fill::wash, Stroke stroke = Stroke::solid);

  /// Draws a capsule: all points within `radius` of the segment.
  Figure2d& capsule(
      const Eigen::Vector2d& start, const Eigen::Vector2d& end, double radius, Ink ink,
      Fill fill = Fill::wash, Stroke stroke = Stroke::solid);

  Figure2d& polygon(
      const std::vector<Eigen::Vector2d>& corners, Ink ink, Fill fill = Fill::wash,
      Stroke stroke = Stroke::solid);

  /// Fills an overlap, given by its corners, without an outline and darker than a wash.
  Figure2d& region(const std::vector<Eigen::Vector2d>& corners, Ink ink = Ink::overlap);

  /// Fills the lens in which two circles overlap; draws nothing where they do not.
  Figure2d& lens(
      const Eigen::Vector2d& center_a, double radius_a, const Eigen::Vector2d& center_b,
      double radius_b, Ink ink = Ink::overlap);

  /// Draws the line normal·x = distance and hatches the solid side, where normal·x < distance.
  Figure2d& half_plane(const Eigen::Vector2d& normal, double distance, Ink ink = Ink::muted);

  Figure2d& segment(
      const Eigen::Vector2d& start, const Eigen::Vector2d& end, Ink ink = Ink::ink,
      Stroke stroke = Stroke::solid, double pixels = 1.6);

  Figure2d& polyline(
      const std::vector<Eigen::Vector2d>& points, Ink ink = Ink::ink, Stroke stroke = Stroke::solid,
      double pixels = 1.6);

  /// Draws an arrow from `start` to `end`, e.g. a normal or a velocity; one without length is a
  /// dot. A label stands beside its tip.
  Figure2d& arrow(
      const Eigen::Vector2d& start, const Eigen::Vector2d& end, Ink ink = Ink::ink,
      const std::string& label = "", Side side = Side::automatic);

  /// Draws a dimension line with both ends marked, `offset` pixels to the left of start → end
  /// (negative: to the right), and its label beside its middle.
  Figure2d& dimension(
      const Eigen::Vector2d& start, const Eigen::Vector2d& end, const std::string& label,
      double offset = 0, Ink ink = Ink::overlap);

  /// Draws a contact point: a dot with a ring, and its label.
  Figure2d& point(
      const Eigen::Vector2d& position, Ink ink = Ink::ink, const std::string& label = "",
      Side side = Side::automatic);

  /// Draws a small plain dot (a centre, a vertex), and its label.
  Figure2d&
  dot(const Eigen::Vector2d& position, Ink ink = Ink::ink, const std::string& label = "",
      Side side = Side::automatic);

  /// Draws the arc of an angle about `center`, from angle `from` to `to` [rad], and its label.
  Figure2d& angle(
      const Eigen::Vector2d& center, double radius, double from, double to,
      const std::string& label = "", Ink ink = Ink::muted);

  /// Writes `text` beside `anchor`; the placement takes another side where this one is taken.
  Figure2d& label(
      const Eigen::Vector2d& anchor, const std::string& text, Side side = Side::automatic,
      Ink ink = Ink::ink);

  /// Keeps texts off a square of `pixels` around a point, where a live figure has a handle.
  Figure2d& keep_free(const Eigen::Vector2d& position, double pixels);

  /// Draws axes through the origin with ticks `spacing` apart, faint, under what follows.
  Figure2d&
  axes(double spacing, const std::string& x_label = "x", const std::string& y_label = "y");

  /// Draws a faint grid with lines `spacing` apart.
  Figure2d& grid(double spacing);

  /// The part of the world that is shown.
  const View& view() const { return view_; }

  /// Where a point of the world lands, in pixels from the figure's upper left corner.
  Eigen::Vector2d to_pixels(const Eigen::Vector2d& world) const;

  /// The drawing without its document, for a `Grid`; `id` starts every id in it.
  Panel panel(const std::string& id) const;

  /// The rectangles in which the labels stand, in pixels.
  std::vector<Rect> label_boxes() const;

  std::string svg() const;

private:
  Figure2d& shape(const std::vector<Eigen::Vector2d>& corners, Ink ink, Fill fill, Stroke stroke);
  std::vector<Eigen::Vector2d>
  pixels(const char* element, const std::vector<Eigen::Vector2d>& points) const;
  Eigen::Vector2d pixel(const char* element, const Eigen::Vector2d& world) const;

  std::string name_;
  std::string title_;
  std::string description_;
  View view_;
  double scale_;
  Eigen::Vector2d origin_;
  Sketch sketch_;
};

} // namespace cookbook::plot
