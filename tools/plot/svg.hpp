#pragma once

#include "tools/plot/style.hpp"

#include <Eigen/Core>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cookbook::plot::svg
{

/// Writes a number with two decimals, halves away from zero, never -0.00.
///
/// The value is first rounded to a millionth, so that the last bit of a sine cannot turn a tie.
/// NaN, infinity and anything beyond ±1e9 throw std::invalid_argument.
std::string number(double value);

/// Writes "x,y".
std::string pair(const Eigen::Vector2d& p);

/// Replaces the characters that XML reserves; control characters become spaces.
std::string escaped(std::string_view text);

/// An attribute and its value, which is escaped when written.
using Attribute = std::pair<std::string_view, std::string>;

/// Writes `<name a="…"/>`, or `<name a="…">content</name>` where there is content.
std::string element(
    std::string_view name, std::initializer_list<Attribute> attributes,
    std::string_view content = "");

/// Writes the data of a path through points: "M…L…", closed by "Z" on demand.
std::string path_data(const std::vector<Eigen::Vector2d>& points, bool closed);

/// The pen of a stroke.
struct Pen
{
  Ink ink = Ink::ink;
  Stroke stroke = Stroke::solid;
  double width = 1.6;
};

/// Draws a path given by its data.
std::string path(const std::string& data, const Pen& pen, Fill fill);

std::string line(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Pen& pen);
std::string polyline(const std::vector<Eigen::Vector2d>& points, const Pen& pen);
std::string polygon(const std::vector<Eigen::Vector2d>& points, const Pen& pen, Fill fill);
std::string circle(const Eigen::Vector2d& center, double radius, const Pen& pen, Fill fill);

/// Fills an outline without a stroke; opacity in [0, 1].
std::string filled(const std::string& path, Ink ink, double opacity);

/// Draws a marker of about `size` pixels across.
std::string marker(Marker shape, const Eigen::Vector2d& at, double size, Ink ink);

/// Draws an arrow with a filled head of `head` pixels; one without length becomes a dot.
std::string
arrow(const Eigen::Vector2d& start, const Eigen::Vector2d& end, const Pen& pen, double head = 10);

/// Wraps elements so that nothing is drawn outside a rectangle; the clip's id is `id`-clip.
std::string clipped(
    const std::string& body, const std::string& id, double left, double top, double width,
    double height);

/// How a text is set.
struct Type
{
  Ink ink = Ink::ink;
  double size = text_size;
  bool strong = false;
  std::string_view anchor = "start"; ///< start, middle, end
  double rotation = 0;               ///< [degrees], clockwise
};

/// Writes a text with its halo; `_{sub}` and `^{super}` become shifted tspans.
std::string text(const Eigen::Vector2d& baseline, std::string_view content, const Type& type);

/// Wraps elements into the document: root, title, description, style sheet, paper.
std::string document(
    const std::string& name, double width, double height, const std::string& title,
    const std::string& description, const std::string& body);

/// Throws std::invalid_argument naming `element` where `value` is NaN or infinite.
void require_finite(std::string_view element, double value);

/// Throws std::invalid_argument unless `name` is made of letters, digits, `_`, `-`, not empty and
/// begins with a letter.
void require_name(const std::string& name);

} // namespace cookbook::plot::svg
