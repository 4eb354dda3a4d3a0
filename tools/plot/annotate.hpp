#pragma once

#include "tools/plot/panel.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

/// Marks that plane and spatial figures share; all coordinates are pixels, y down.
namespace cookbook::plot
{

/// Keeps labels off a stroke.
void avoid_path(Sketch& sketch, const std::vector<Eigen::Vector2d>& points, bool closed);

/// Returns the points of a circle, for `avoid_path`.
std::vector<Eigen::Vector2d> circle_points(const Eigen::Vector2d& center, double radius);

/// Asks for a place for a text; an empty one is ignored.
void add_label(
    Sketch& sketch, const Eigen::Vector2d& anchor, double clearance, const std::string& text,
    Side side, Ink ink);

/// Returns the side of an anchor that lies in a direction.
Side side_towards(const Eigen::Vector2d& direction);

void draw_arrow(
    Sketch& sketch, const Eigen::Vector2d& start, const Eigen::Vector2d& end, Ink ink,
    const std::string& label, Side side);

void draw_dimension(
    Sketch& sketch, const Eigen::Vector2d& start, const Eigen::Vector2d& end,
    const std::string& label, double offset, Ink ink);

/// Draws a dot with a ring.
void draw_contact(
    Sketch& sketch, const Eigen::Vector2d& at, Ink ink, const std::string& label, Side side);

void draw_dot(
    Sketch& sketch, const Eigen::Vector2d& at, Ink ink, const std::string& label, Side side);

} // namespace cookbook::plot
