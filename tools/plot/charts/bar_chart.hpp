#pragma once

#include "tools/plot/charts/axis.hpp"
#include "tools/plot/panel.hpp"
#include "tools/plot/style.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cookbook::plot
{

/// A chart of named bars that lie one under the other, with signed values.
///
/// A value that is NaN or infinite throws std::invalid_argument naming the bar.
class BarChart
{
public:
  /// Starts an empty chart; `value` is the horizontal axis and must be linear.
  BarChart(std::string name, std::string title, Axis value);

  BarChart& describe(std::string text);

  /// Sets the width of the whole chart [pixels]; the height follows from the number of bars.
  BarChart& width(double pixels);

  /// Keeps room for texts of so many pixels at the ends of negative and of positive bars, instead
  /// of for those that there are: for a chart that must not move while its values change.
  BarChart& text_room(double negative, double positive);

  BarChart& note(std::string text);

  /// Adds a bar; `text` stands at its end (empty: the value with three significant digits).
  BarChart&
  bar(const std::string& name, double value, Ink ink = Ink::muted, const std::string& text = "");

  /// Adds the bar that the chart is about: strong colour, bold name.
  BarChart& highlight(
      const std::string& name, double value, Ink ink = Ink::overlap, const std::string& text = "");

  /// Draws a vertical line at `value`, e.g. a limit, with its label.
  BarChart& reference(double value, const std::string& label);

  Panel panel(const std::string& id) const;
  std::vector<Rect> label_boxes() const;
  std::string svg() const;

private:
  struct Bar
  {
    std::string name;
    double value;
    Ink ink;
    std::string text;
    bool strong;
  };
  struct Reference
  {
    double value;
    std::string label;
  };
  BarChart& add(Bar bar);
  void draw_bar(Sketch& sketch, const Bar& bar, double middle, double zero, double end) const;

  std::string name_;
  std::string title_;
  std::string description_;
  std::string note_;
  Axis axis_;
  double width_ = 560;
  std::optional<std::pair<double, double>> text_room_;
  std::vector<Bar> bars_;
  std::vector<Reference> references_;
};

} // namespace cookbook::plot
