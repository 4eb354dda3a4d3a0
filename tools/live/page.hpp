#pragma once

/// \file
/// \brief What a live figure is written with: it asks for its inputs, and takes its outputs.

#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/figures/figure3d.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cookbook::live
{

/// Where the two numbers of a handle are seen: at `origin` + x `across` + y `up`, in pixels of the
/// figure that is drawn.
struct DragPlane
{
  Eigen::Vector2d origin; ///< [pixels] from the upper left corner, where x = y = 0
  Eigen::Vector2d across; ///< [pixels] for x = 1
  Eigen::Vector2d up;     ///< [pixels] for y = 1
};

/// The plane of a plane figure; `offset` is where its panel stands in a grid [pixels].
DragPlane
drag_plane(const plot::Figure2d& figure, const Eigen::Vector2d& offset = Eigen::Vector2d::Zero());

/// The plane through a point of a figure in space that has a frame, spanned by two directions.
DragPlane drag_plane(
    const plot::Figure3d& figure, const Eigen::Vector3d& origin, const Eigen::Vector3d& across,
    const Eigen::Vector3d& up, const Eigen::Vector2d& offset = Eigen::Vector2d::Zero());

/// What a handle needs around its point [pixels], for figures that keep labels away from it.
inline constexpr double handle_room = 38;

/// What the mouse or a finger does in the picture that is shown.
struct Pointer
{
  Eigen::Vector2d at{0, 0}; ///< [pixels] of the picture
  bool down = false;        ///< a button is held, or a finger lies on the picture
  bool pressed = false;     ///< it went down in this event
  bool released = false;    ///< it went up in this event
  double wheel = 0; ///< how far the wheel was turned in this event, away from the reader positive
};

/// What kind of input a figure has.
enum class InputKind
{
  slider, ///< a number in a range
  choice, ///< one of several names
  toggle, ///< on or off
  handle, ///< a point that is dragged
  button, ///< something that is done once
  file    ///< a file that the reader opens, or drops on the figure
};

/// A file that a reader gave to a figure; without a name there is none.
struct File
{
  std::string name; ///< without its folders
  std::string text; ///< all that is in it
};

/// One input: what the figure asked for, and its value.
struct Input
{
  InputKind kind;
  std::string name;
  std::string unit{};
  std::vector<std::string> options{};
  double least = 0, most = 0;     ///< of a slider
  Eigen::Vector2d start{0, 0};    ///< of a handle; x alone for all others
  Eigen::Vector2d value{0, 0};    ///< as `start`; for a choice the index, for a toggle 0 or 1
  DragPlane plane{};              ///< of a handle
  plot::Ink ink = plot::Ink::ink; ///< of a handle
  bool asked = true;              ///< by the last call of the figure
  bool restarts = false;          ///< a change begins the motion anew
  File file{};                    ///< what the reader opened
};

/// A number or a text that the figure shows, as it is written.
struct Reading
{
  std::string name;
  std::string value;
  std::string unit;
};

/// A curve that grows with the steps.
struct Curve
{
  std::string name;
  std::string unit;
  std::vector<Eigen::Vector2d> points; ///< step and value
};

/// A live figure's inputs and outputs. A recipe's `live.cpp` defines `figure(Page&)`, which is
/// called anew on each event: it asks for its inputs by name, computes, and draws.
///
/// An input comes to be where it is asked for first, with its start value. The host (a page, a
/// window, a test) sends events; what the figure returns depends on nothing else, so that the same
/// events give the same numbers in each host.
class Page
{
public:
  // Inputs.

  /// A number from `least` to `most`.
  double slider(
      const std::string& name, double least, double most, double start,
      const std::string& unit = "");

  /// The index of the option that is chosen.
  int choice(const std::string& name, const std::vector<std::string>& options, int start = 0);

  /// Whether something is switched on.
  bool toggle(const std::string& name, bool start = false);

  /// A point that is dragged in a plane, in its coordinates.
  Eigen::Vector2d handle(
      const std::string& name, const DragPlane& plane, const Eigen::Vector2d& start,
      plot::Ink ink = plot::Ink::ink);

  /// A point that is dragged in a plane figure; in world coordinates, and kept where it is seen.
  Eigen::Vector2d handle(
      const std::string& name, const plot::Figure2d& figure, const Eigen::Vector2d& start,
      plot::Ink ink = plot::Ink::ink);

  /// Whether this button was pressed in this event.
  bool button(const std::string& name);

  /// The file that the reader opened, or dropped on the figure; without a name there is none. Where
  /// the figure throws since it cannot be read, the file before it stays.
  File file(const std::string& name);

  /// Closes the file that was opened for this input.
  void close(const std::string& name);

  /// The mouse or finger in the picture that was shown last.
  const Pointer& pointer() const { return pointer_; }

  /// Whether this event changed the input of that name.
  bool changed(const std::string& name) const { return !name.empty() && name == changed_; }

  /// Whether the motion begins: at first, and where the reader starts anew. To ask makes the figure
  /// one that moves: with start anew, pause and a single step.
  bool begins();

  /// A change of the input of that name, asked for before, begins the motion anew.
  Page& restarts_with(const std::string& name);

  /// How many steps of 1/60 s are to be made in this event.
  int steps() const { return steps_; }

  /// Whether the page is dark, for what is shown in pixels.
  bool dark() const { return dark_; }

  /// How wide the place is, in CSS pixels; 640 where the host does not say.
  double width() const { return width_; }

  /// The width of a view or camera: `pixels`, or as much as fits into the place with a document's
  /// margins.
  double fit(double pixels) const { return std::min(pixels, width_ - 2 * plot::document_margin); }

  // Outputs.

  /// Shows a number, with at most four significant digits.
  void number(const std::string& name, double value, const std::string& unit = "");

  /// Shows a text under a name.
  void text(const std::string& name, const std::string& value);

  /// Shows an SVG document: a figure of `tools/plot`.
  void draw(std::string svg);

  /// Shows a picture: RGBA bytes, row by row from the top. It must live until the next event.
  void show(int width, int height, std::span<const std::uint32_t> pixels);

  /// Where the picture can be taken hold of [pixels], for what tries the figure; its middle if
  /// never called.
  void grip(const Eigen::Vector2d& at) { grip_ = at; }

  /// Adds the value of this step to a curve; nothing where no step is made.
  void plot(const std::string& name, double value, const std::string& unit = "");

  /// Offers the inputs as lines of C++, to be copied.
  void code(std::string lines);

  /// Nothing moves any more: the host stops to make steps until the next event.
  void rests() { resting_ = true; }

private:
  friend class Session;
  Input& ask(Input input);

  std::vector<Input> inputs_;
  std::vector<Reading> readings_;
  std::vector<Curve> curves_;
  std::string (*draw_curves_)(const std::vector<Curve>&, double width) = nullptr;
  Pointer pointer_;
  std::optional<Eigen::Vector2d> grip_;
  std::string changed_, pressed_, svg_, code_;
  std::span<const std::uint32_t> pixels_;
  int picture_width_ = 0, picture_height_ = 0;
  double width_ = 640;
  long step_ = 0;
  int steps_ = 0;
  bool begins_ = true, moving_ = false, resting_ = false, dark_ = false;
};

/// The figure: defined by the recipe's `live.cpp`.
void figure(Page& page);

} // namespace cookbook::live
