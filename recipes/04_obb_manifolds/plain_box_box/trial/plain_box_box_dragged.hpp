#pragma once

/// \file
/// \brief Two boxes, one of which is dragged, under each method: what the live figure draws.

#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_cases/trial/contacts_figure.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"
#include "04_obb_manifolds/separating_axes/trial/separating_axes_figures.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

/// A method's overlaps along the axes that it tries, and what it makes of them.
struct BoxAnswer
{
  std::optional<Manifold<double, most_published_points>> manifold;
  std::array<std::optional<double>, box_axes> overlaps; ///< [m], nothing for axes left out
  int axis = -1; ///< the one that the manifold is built on, or that separates; −1 for none
};

/// The names of the methods that box_answer() takes by number.
inline std::vector<std::string> box_answer_names()
{
  return {"plain_box_box", "box_box", "gjk_epa", "box_as_published"};
}

/// A manifold in a larger one.
inline std::optional<Manifold<double, most_published_points>>
with_room(const std::optional<Manifold<double>>& manifold)
{
  if (!manifold)
  {
    return std::nullopt;
  }
  Manifold<double, most_published_points> large{manifold->normal, manifold->depth, {}};
  for (const ContactPoint<double>& point : manifold->points)
  {
    large.points.push_back(point);
  }
  return large;
}

/// The axis of the least overlap.
inline int least_axis(const std::array<std::optional<double>, box_axes>& overlaps)
{
  int least = -1;
  for (int axis = 0; axis < box_axes; ++axis)
  {
    const std::optional<double>& overlap = overlaps[static_cast<std::size_t>(axis)];
    if (overlap && (least < 0 || *overlap < *overlaps[static_cast<std::size_t>(least)]))
    {
      least = axis;
    }
  }
  return least;
}

/// The published method, with the overlaps that it takes for those of the fifteen axes.
inline BoxAnswer published_answer(const Obb<double>& a, const Obb<double>& b)
{
  BoxAnswer answer{box_as_published(a, b), {}};
  const std::array<Vector3<double>, 15> axes = published_axes(a, b);
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
  {
    if (!axes[axis].isZero(0))
    {
      answer.overlaps[axis] = published_overlap<double>(a, b, axes[axis].normalized()).depth;
    }
  }
  answer.axis = least_axis(answer.overlaps);
  return answer;
}

/// What method 0 … 3 of box_answer_names() says of two boxes.
inline BoxAnswer box_answer(int method, const Obb<double>& a, const Obb<double>& b)
{
  if (method == 3)
  {
    return published_answer(a, b);
  }
  const std::optional<Manifold<double>> manifold = method == 0   ? plain_box_box(a, b)
                                                   : method == 1 ? box_box(a, b)
                                                                 : gjk_epa(a, b);
  BoxAnswer answer{with_room(manifold), axes_overlaps(a, b)};
  const bool by_axes = method != 2;
  answer.axis = !manifold ? least_axis(answer.overlaps)
                : by_axes ? static_cast<int>(manifold->points[0].feature / 64)
                          : -1;
  return answer;
}

/// The overlaps of an answer as bars, the deciding one marked, within −0.75 to 1.75 m.
inline plot::BarChart overlaps_chart(const BoxAnswer& answer, double width)
{
  plot::BarChart chart(
      "overlaps", "", {"overlap along the axis [m]", plot::Scale::linear, -0.75, 1.75});
  chart.width(width).text_room(48, 52);
  for (int axis = 0; axis < box_axes; ++axis)
  {
    const std::optional<double>& overlap = answer.overlaps[static_cast<std::size_t>(axis)];
    const std::string name = axis_name(axis);
    const double shown = std::clamp(overlap.value_or(0), -0.75, 1.75);
    const std::string text = overlap ? number(std::round(*overlap * 1e3) * 1e-3 + 0.0) : "left out";
    axis == answer.axis ? chart.highlight(name, shown, plot::Ink::overlap, text)
                        : chart.bar(name, shown, axis_ink(axis), text);
  }
  return chart;
}

} // namespace cookbook
