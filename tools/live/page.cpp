#include "tools/live/page.hpp"

#include "tools/program/table.hpp"

#include <algorithm>
#include <stdexcept>

namespace cookbook::live
{

namespace
{

/// Moves a plane from a panel's pixels to its document's.
DragPlane in_document(const Eigen::Vector2d& offset, DragPlane plane)
{
  plane.origin += offset + Eigen::Vector2d::Constant(plot::document_margin);
  return plane;
}

} // namespace

DragPlane drag_plane(const plot::Figure2d& figure, const Eigen::Vector2d& offset)
{
  const Eigen::Vector2d origin = figure.to_pixels({0, 0});
  return in_document(
      offset, {origin, figure.to_pixels({1, 0}) - origin, figure.to_pixels({0, 1}) - origin});
}

DragPlane drag_plane(
    const plot::Figure3d& figure, const Eigen::Vector3d& origin, const Eigen::Vector3d& across,
    const Eigen::Vector3d& up, const Eigen::Vector2d& offset)
{
  const Eigen::Vector2d at = figure.to_pixels(origin);
  return in_document(
      offset, {at, figure.to_pixels(origin + across) - at, figure.to_pixels(origin + up) - at});
}

Input& Page::ask(Input input)
{
  const auto known = std::find_if(
      inputs_.begin(), inputs_.end(), [&](const Input& one) { return one.name == input.name; });
  if (known == inputs_.end())
  {
    input.value = input.start;
    return inputs_.emplace_back(std::move(input));
  }
  if (known->kind != input.kind)
  {
    throw std::logic_error("live: two inputs are called \"" + input.name + "\"");
  }
  input.value = known->value;
  input.file = std::move(known->file);
  *known = std::move(input);
  return *known;
}

double Page::slider(
    const std::string& name, double least, double most, double start, const std::string& unit)
{
  Input& input = ask({InputKind::slider, name, unit, {}, least, most, {start, 0}});
  input.value.x() = std::clamp(input.value.x(), least, most);
  return input.value.x();
}

int Page::choice(const std::string& name, const std::vector<std::string>& options, int start)
{
  Input& input = ask({InputKind::choice, name, "", options, 0, 0, {start, 0}});
  input.value.x() = std::clamp(std::floor(input.value.x()), 0.0, double(options.size()) - 1);
  return int(input.value.x());
}

bool Page::toggle(const std::string& name, bool start)
{
  return ask({InputKind::toggle, name, "", {}, 0, 1, {start ? 1 : 0, 0}}).value.x() != 0;
}

Eigen::Vector2d Page::handle(
    const std::string& name, const DragPlane& plane, const Eigen::Vector2d& start, plot::Ink ink)
{
  return ask({InputKind::handle, name, "", {}, 0, 0, start, {0, 0}, plane, ink}).value;
}

Eigen::Vector2d Page::handle(
    const std::string& name, const plot::Figure2d& figure, const Eigen::Vector2d& start,
    plot::Ink ink)
{
  Input& input =
      ask({InputKind::handle, name, "", {}, 0, 0, start, {0, 0}, drag_plane(figure), ink});
  const Eigen::Vector2d least = figure.view().min, most = figure.view().max;
  input.value = input.value.cwiseMax(least).cwiseMin(most);
  return input.value;
}

bool Page::button(const std::string& name)
{
  ask({InputKind::button, name});
  return name == pressed_;
}

File Page::file(const std::string& name)
{
  return ask({InputKind::file, name}).file;
}

void Page::close(const std::string& name)
{
  for (Input& one : inputs_)
  {
    one.file = one.name == name ? File{} : one.file;
  }
}

bool Page::begins()
{
  moving_ = true;
  return begins_;
}

Page& Page::restarts_with(const std::string& name)
{
  for (Input& input : inputs_)
  {
    input.restarts = input.restarts || input.name == name;
  }
  return *this;
}

void Page::number(const std::string& name, double value, const std::string& unit)
{
  readings_.push_back({name, cookbook::number(value), unit});
}

void Page::text(const std::string& name, const std::string& value)
{
  readings_.push_back({name, value, ""});
}

void Page::draw(std::string svg)
{
  svg_ = std::move(svg);
}

void Page::show(int width, int height, std::span<const std::uint32_t> pixels)
{
  if (width < 0 || height < 0 || pixels.size() != std::size_t(width) * std::size_t(height))
  {
    throw std::logic_error("live: a picture must have width times height pixels");
  }
  picture_width_ = width;
  picture_height_ = height;
  pixels_ = pixels;
}

void Page::code(std::string lines)
{
  code_ = std::move(lines);
}

} // namespace cookbook::live
