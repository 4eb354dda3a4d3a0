#pragma once

#include "tools/plot/charts/axis.hpp"
#include "tools/plot/panel.hpp"
#include "tools/plot/style.hpp"

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace cookbook::plot
{

/// How the series of a chart are named.
enum class Legend
{
  automatic, ///< at the ends of the lines where there are at most six and room, else below
  direct,    ///< at the ends of the lines
  corner,    ///< a box in the emptiest corner
  below,     ///< in rows below the chart
  none
};

/// The look of a series.
struct Look
{
  Ink ink = Ink::ink;
  Marker marker = Marker::circle;
  Stroke stroke = Stroke::solid;
};

/// Returns the look of the index-th series: colour, marker and dashes all differ.
Look series_look(std::size_t index);

/// A chart of lines and points over two axes, linear or logarithmic.
///
/// On a logarithmic axis a value of exactly 0 (no error at all) stands on a floor at the lower
/// edge, marked "0"; a negative one throws std::invalid_argument, and so does NaN or infinity.
/// Every call returns the chart. Texts may hold `_{sub}` and `^{super}`.
class Chart
{
public:
  /// Starts an empty chart; `name` (letters, digits, `_`, `-`) makes its ids unique on a page.
  Chart(std::string name, std::string title, Axis x, Axis y);

  Chart& describe(std::string text);

  /// Sets the size of the whole chart [pixels]; 640 by 420 if never called.
  Chart& size(double width, double height);

  Chart& legend(Legend legend);

  /// Writes a small line under the chart, e.g. machine, compiler and flags.
  Chart& note(std::string text);

  /// Says before the note that something is not drawn, and why.
  Chart& leave_out(const std::string& label, const std::string& why);

  /// Adds a line through `points`, in their order.
  Chart& line(const std::string& name, std::vector<Eigen::Vector2d> points, Look look);
  Chart& line(const std::string& name, std::vector<Eigen::Vector2d> points);

  /// Adds one labelled point.
  Chart& point(const std::string& label, const Eigen::Vector2d& at, Look look = {});

  /// Adds one labelled point at (x, max) with a whisker down to (x, percentile), e.g. p99.
  Chart& whisker(const std::string& label, double x, double percentile, double max, Look look = {});

  /// Adds a translucent band; each row is x, low, high.
  Chart& band(const std::string& name, std::vector<Eigen::Vector3d> rows, Ink ink);

  /// Draws the Pareto front of `points`: a ring around each that no other beats or equals at less
  /// cost, and a faint line that joins them. Lower left is better.
  Chart& front(std::vector<Eigen::Vector2d> points, const std::string& label = "Pareto front");

  /// Stands a method that fails in a row of failures at the upper edge, at its cost `x`.
  Chart& fails(const std::string& label, double x, Look look = {Ink::overlap, Marker::cross, {}});

  /// Names the row of failures, instead of "fails".
  Chart& name_failures(std::string label);

  Chart& reference_x(double value, const std::string& label);
  Chart& reference_y(double value, const std::string& label);

  Panel panel(const std::string& id) const;
  std::vector<Rect> label_boxes() const;
  std::string svg() const;

private:
  struct Series
  {
    std::string name;
    std::vector<Eigen::Vector2d> points;
    Look look;
  };
  struct Scatter
  {
    std::string label;
    Eigen::Vector2d at;
    double percentile; // equals at.y() where there is no whisker
    Look look;
  };
  struct Band
  {
    std::string name;
    std::vector<Eigen::Vector3d> rows;
    Ink ink;
  };
  struct Reference
  {
    bool vertical;
    double value;
    std::string label;
  };
  struct Failure
  {
    std::string label;
    double x;
    Look look;
  };
  struct Layout;

  void check(const std::string& element, double x, double y) const;
  std::string whole_note() const { return left_out_ + note_; }
  std::vector<Eigen::Vector2d> all_values() const;
  Layout layout() const;
  void draw_frame(Sketch& sketch, const Layout& layout) const;
  void draw_references(Sketch& sketch, const Layout& layout) const;
  void draw_front(Sketch& sketch, const Layout& layout) const;
  void draw_series(Sketch& sketch, const Layout& layout) const;
  void draw_points(Sketch& sketch, const Layout& layout) const;
  void draw_failures(Sketch& sketch, const Layout& layout) const;
  void draw_direct_names(Sketch& sketch, const Layout& layout) const;
  void draw_corner_legend(Sketch& sketch, const Layout& layout) const;
  void draw_legend_below(Sketch& sketch, const Layout& layout) const;
  std::vector<std::pair<std::string, Look>> legend_rows() const;
  std::vector<Eigen::Vector2d> legend_corners(Legend legend) const;

  std::string name_;
  std::string title_;
  std::string description_;
  std::string note_;
  std::string left_out_;
  std::string failures_name_ = "fails";
  Axis x_;
  Axis y_;
  double width_ = 640;
  double height_ = 420;
  Legend legend_ = Legend::automatic;
  std::vector<Series> series_;
  std::vector<Scatter> scatter_;
  std::vector<Band> bands_;
  std::vector<Reference> references_;
  std::vector<Failure> failures_;
  std::vector<Eigen::Vector2d> front_;
  std::string front_label_;
};

} // namespace cookbook::plot
