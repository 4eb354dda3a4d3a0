#pragma once

/// \file
/// \brief The bodies of a scene as SVG paths, from far to near.

#include "06_world/scene_figures/trial/scene_outline_figures.hpp"
#include "tools/plot/svg.hpp"

#include <algorithm>

namespace cookbook
{

/// Whether bodies are translucent: seen along z, they hardly cover each other.
inline bool is_front(const SceneView& view)
{
  return view.yaw == 0 && view.pitch == 0;
}

/// The bodies from far to near, by where they are on average; planes are left out.
inline std::vector<std::size_t>
drawing_order(const Scene& scene, const std::vector<Frame>& frames, const SceneView& view)
{
  const Vector3<double> towards = picture_axes(view.yaw, view.pitch).row(2);
  std::vector<long> nearness(scene.bodies.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
  {
    double sum = 0;
    for (const Frame& frame : frames)
    {
      const double one = towards.dot(frame.bodies[i].position);
      sum += std::isfinite(one) ? std::clamp(one, -1e4, 1e4) : 0;
    }
    // In millimetres, so that a last bit decides nothing.
    nearness[i] = std::lround(1e3 * sum / static_cast<double>(frames.size()));
    if (!std::holds_alternative<PlaneShape>(scene.bodies[i].shape))
    {
      order.push_back(i);
    }
  }
  std::stable_sort(
      order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return nearness[a] < nearness[b]; });
  return order;
}

/// The colour of each body: fixed ones muted, movable ones blue and orange in turn.
inline std::vector<plot::Ink> inks_of(const Scene& scene)
{
  std::vector<plot::Ink> inks;
  bool first = true;
  for (const SceneBody& body : scene.bodies)
  {
    inks.push_back(body.mass == 0 ? plot::Ink::muted : first ? plot::Ink::a : plot::Ink::b);
    first = body.mass == 0 ? first : !first;
  }
  return inks;
}

/// A path in the colours of a body; `inside` is what makes it move.
inline std::string
body_path(const std::string& data, plot::Ink ink, bool translucent, const std::string& inside = "")
{
  const std::string of_ink(plot::css_name(ink));
  const std::string tint = "fill:color-mix(in srgb,currentColor 22%,var(--cb-paper))";
  if (translucent)
  {
    return plot::svg::element(
        "path", {{"class", "cb-wash cb-" + of_ink}, {"stroke-width", "1.4"}, {"d", data}}, inside);
  }
  return plot::svg::element(
      "path",
      {{"class", "cb-open cb-" + of_ink}, {"style", tint}, {"stroke-width", "1"}, {"d", data}},
      inside);
}

/// The radius of a ball in tenths of a pixel, at least one; zero for other shapes.
inline long ball_radius(const SceneBody& body, double scale)
{
  const auto* const sphere = std::get_if<SphereShape>(&body.shape);
  return sphere ? std::max(1L, tenths(scale * sphere->radius)) : 0;
}

} // namespace cookbook
