#pragma once

#include "tools/plot/figures/objects3d.hpp"
#include "tools/plot/panel.hpp"
#include "tools/plot/style.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace cookbook::plot
{

/// An orthographic camera, y up, that fits the scene into the picture.
///
/// With yaw = pitch = 0 it looks along −z: x to the right, y up, z towards the viewer. A positive
/// yaw walks the camera to the right (towards +x), a positive pitch lifts it.
struct Camera
{
  double yaw = 0.6;    ///< [rad]
  double pitch = 0.35; ///< [rad]
  double width = 480;  ///< [pixels]
  double height = 360; ///< [pixels] at most, without the title
  double margin = 34;  ///< [pixels] kept for labels around what is shown
};

/// The part of the world a 3-D figure shows, where it should not fit the scene by itself.
struct Frame
{
  Eigen::Vector3d center; ///< world; lands in the middle of the picture
  double width;           ///< world units across the picture
};

/// An orthographic figure in world coordinates, right-handed, y up.
///
/// Things are drawn from far to near; equal depths in the order of the calls. Every call returns
/// the figure. A coordinate that is NaN or infinite throws std::invalid_argument naming the
/// element. Texts may hold `_{sub}` and `^{super}`.
class Figure3d
{
public:
  /// Starts an empty figure; `name` (letters, digits, `_`, `-`) makes its ids unique on a page.
  Figure3d(std::string name, std::string title, Camera camera = {});

  Figure3d& describe(std::string text);

  /// Fixes what is shown, so that several figures share one scale.
  Figure3d& frame(const Frame& frame);

  /// Draws a box with translucent faces, its hidden edges dashed; columns of `axes` are its unit
  /// axes in the world.
  Figure3d&
  box(const Eigen::Vector3d& center, const Eigen::Matrix3d& axes,
      const Eigen::Vector3d& half_extents, Ink ink);

  /// Draws a sphere: outline, soft shading, equator with its hidden half dashed.
  Figure3d& sphere(const Eigen::Vector3d& center, double radius, Ink ink);

  /// Draws a capsule: all points within `radius` of the segment.
  Figure3d&
  capsule(const Eigen::Vector3d& start, const Eigen::Vector3d& end, double radius, Ink ink);

  /// Draws a square patch of a plane with `cells` × `cells` grid cells.
  Figure3d& plane(
      const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double half_extent,
      int cells = 6, Ink ink = Ink::muted);

  /// Draws a plane polygon, e.g. a clipped face.
  Figure3d& polygon(
      const std::vector<Eigen::Vector3d>& corners, Ink ink, Fill fill = Fill::wash,
      Stroke stroke = Stroke::solid);

  Figure3d& segment(
      const Eigen::Vector3d& start, const Eigen::Vector3d& end, Ink ink = Ink::ink,
      Stroke stroke = Stroke::solid, double pixels = 1.6);

  Figure3d& polyline(
      const std::vector<Eigen::Vector3d>& points, Ink ink = Ink::ink, Stroke stroke = Stroke::solid,
      double pixels = 1.6);

  /// Draws an arrow; like points, labels and dimension lines it lies over everything else.
  Figure3d& arrow(
      const Eigen::Vector3d& start, const Eigen::Vector3d& end, Ink ink = Ink::ink,
      const std::string& label = "", Side side = Side::automatic);

  /// Draws a dimension line `offset` pixels to the left of start → end as seen, and its label.
  Figure3d& dimension(
      const Eigen::Vector3d& start, const Eigen::Vector3d& end, const std::string& label,
      double offset = 0, Ink ink = Ink::overlap);

  /// Draws a contact point: a dot with a ring, and its label.
  Figure3d& point(
      const Eigen::Vector3d& position, Ink ink = Ink::ink, const std::string& label = "",
      Side side = Side::automatic);

  Figure3d& label(
      const Eigen::Vector3d& anchor, const std::string& text, Side side = Side::automatic,
      Ink ink = Ink::ink);

  /// Draws the world's axes from `origin`, `length` long, with their names.
  Figure3d& axes(const Eigen::Vector3d& origin, double length);

  /// Turns a point of the world into the camera's frame: x right, y up, z towards the viewer.
  Eigen::Vector3d to_camera(const Eigen::Vector3d& world) const;

  /// Where a point of the world lands, in pixels from the figure's upper left corner;
  /// std::logic_error without a frame, as only the finished scene knows then.
  Eigen::Vector2d to_pixels(const Eigen::Vector3d& world) const;

  Panel panel(const std::string& id) const;
  std::vector<Rect> label_boxes() const;
  std::string svg() const;

private:
  Figure3d& add(Object object);
  Figure3d& note(Note note);
  std::vector<Eigen::Vector3d>
  seen(const char* element, const std::vector<Eigen::Vector3d>& points) const;

  std::string name_;
  std::string title_;
  std::string description_;
  Camera camera_;
  std::optional<Frame> frame_;
  std::vector<Object> objects_;
  std::vector<Note> notes_;
};

} // namespace cookbook::plot
