#pragma once

#include "tools/plot/labels.hpp"
#include "tools/plot/svg.hpp"

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

namespace cookbook::plot
{

/// A finished drawing without its document: what `Grid` puts side by side.
struct Panel
{
  double width;  ///< [pixels]
  double height; ///< [pixels]
  std::string title;
  std::string description;
  std::string body;              ///< SVG elements
  std::vector<Rect> label_boxes; ///< [pixels]
};

/// A drawing in the making: elements, the texts that want a place, and what they must avoid.
struct Sketch
{
  std::string body;
  std::vector<Label> labels;
  Obstacles obstacles;
};

/// Writes the labels of a sketch over it, within `bounds`, and returns their rectangles.
std::vector<Rect> write_labels(Sketch& sketch, const Rect& bounds);

/// Returns the height that a title takes, wrapped to `width`: 0 for an empty one.
double title_height(const std::string& title, double width);

/// Writes the title into the upper left corner.
void write_title(Sketch& sketch, const std::string& title, double width);

/// What a document leaves free around its panel [pixels].
inline constexpr double document_margin = 12;

/// Returns the document of one panel.
std::string document(const std::string& name, const Panel& panel);

/// Several figures or charts in rows, as one figure; each one's title is its sub-title.
class Grid
{
public:
  /// Starts an empty grid with `columns` panels a row; an empty `title` is not drawn.
  Grid(std::string name, std::string title, int columns);

  Grid& describe(std::string text);

  /// Adds a Figure2d, Figure3d, Chart or BarChart.
  template <class Figure>
  Grid& add(const Figure& figure)
  {
    panels_.push_back([figure](const std::string& id) { return figure.panel(id); });
    return *this;
  }

  Panel panel(const std::string& id) const;
  std::string svg() const;

private:
  std::string name_;
  std::string title_;
  std::string description_;
  int columns_;
  std::vector<std::function<Panel(const std::string&)>> panels_;
};

} // namespace cookbook::plot
