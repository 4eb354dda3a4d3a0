#pragma once

/// \file
/// \brief Bodies that move: paths that change in time, and a clock.

#include "06_world/scene_figures/trial/scene_paths_figures.hpp"
#include "tools/plot/charts/axis.hpp"
#include "tools/plot/text.hpp"

#include <utility>

namespace cookbook
{

/// The frames that are drawn: every `stride`-th, and the last one.
inline std::vector<std::size_t> chosen_frames(std::size_t count, std::size_t stride)
{
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < count; i += stride)
  {
    indices.push_back(i);
  }
  if (indices.back() + 1 != count)
  {
    indices.push_back(count - 1);
  }
  return indices;
}

/// Whether a body has moved too little to be seen.
inline bool looks_alike(const Outline& p, const Outline& q)
{
  constexpr long unseen = 3; // tenths of a pixel
  return std::equal(
      p.begin(), p.end(), q.begin(), q.end(),
      [](long a, long b) { return std::abs(a - b) <= unseen; });
}

/// Part of the whole time, in ten-thousandths, as SVG wants it.
inline std::string key_time(double part)
{
  const long value = std::clamp(std::lround(part * 1e4), 0L, 10'000L);
  const std::string digits = std::to_string(10'000 + value % 10'000).substr(1);
  return value == 10'000 ? "1" : "0." + digits;
}

/// A duration as SVG wants it.
inline std::string seconds_text(double time)
{
  return plot::svg::number(time) + "s";
}

/// A body that changes whenever it looks different from before.
class MovingPath
{
public:
  /// Nothing is kept but references: both must outlive it.
  MovingPath(const SceneBody& body, const Projection& project)
      : body_(body), project_(project), radius_(ball_radius(body, project.scale))
  {
  }

  /// Adds how it is seen at a part of the whole time.
  void at(double part, const BodyState& state)
  {
    Outline outline = body_outline(body_, state, project_);
    if (changes_ > 0 && looks_alike(outline, last_))
    {
      return;
    }
    const std::string data = outline_data(outline, radius_);
    first_ = changes_ == 0 ? data : first_;
    const std::string between = changes_ == 0 ? "" : ";";
    values_ += between + data;
    times_ += between + key_time(part);
    last_ = std::move(outline);
    ++changes_;
  }

  /// The path, and its changes over and over again, each time in `duration` [s].
  std::string path(plot::Ink ink, bool translucent, double duration) const
  {
    const std::string motion = plot::svg::element(
        "animate", {{"attributeName", "d"},
                    {"dur", seconds_text(duration)},
                    {"repeatCount", "indefinite"},
                    {"calcMode", "discrete"},
                    {"keyTimes", times_},
                    {"values", values_}});
    return body_path(first_, ink, translucent, changes_ > 1 ? motion : "");
  }

private:
  const SceneBody& body_;
  const Projection& project_;
  long radius_;
  std::size_t changes_ = 0;
  Outline last_;
  std::string first_, values_, times_;
};

/// All bodies as they move, with every `stride`-th frame.
inline std::string moving_bodies(
    const Scene& scene, const std::vector<Frame>& frames, const SceneView& view,
    const Projection& project, std::size_t stride, double slowness)
{
  const double start = frames.front().time;
  const double duration = frames.back().time - start;
  const std::vector<plot::Ink> inks = inks_of(scene);
  const std::vector<std::size_t> indices = chosen_frames(frames.size(), stride);
  std::string paths;
  for (const std::size_t body : drawing_order(scene, frames, view))
  {
    MovingPath path(scene.bodies[body], project);
    for (const std::size_t i : indices)
    {
      path.at((frames[i].time - start) / duration, frames[i].bodies[body]);
    }
    paths += path.path(inks[body], is_front(view), slowness * duration);
  }
  return paths;
}

/// The height that a time axis takes [pixels].
inline constexpr double time_axis_height = 42;

/// The line of a time axis from pixel `left` to `right`, its ticks and their numbers.
inline std::string time_ticks(double first, double last, double left, double right, double y)
{
  const plot::svg::Pen pen{plot::Ink::muted, plot::Stroke::solid, 1.2};
  const plot::svg::Type type{plot::Ink::muted, plot::small_size, false, "middle", 0};
  std::string drawing = plot::svg::line({left, y}, {right, y}, pen);
  for (const plot::Tick& tick : plot::linear_ticks(first, last, right - left < 160 ? 2 : 5))
  {
    const double x = left + (right - left) * (tick.value - first) / (last - first);
    drawing += plot::svg::line({x, y}, {x, y + 5}, pen);
    drawing += plot::svg::text({x, y + 19}, tick.text, type);
  }
  return drawing;
}

/// An axis of time in a picture `width` pixels wide, along which a dot goes.
inline std::string time_axis(double first, double last, double top, double width, double slowness)
{
  const bool slow = slowness > 1;
  const std::string slower = ", " + plot::significant(slowness, 3) + " times slower";
  const std::string label = "time [s]" + (slow ? slower : "");
  const double left = 8;
  const double right = width - 16 - plot::text_width(label, plot::small_size);
  const double y = top + 14;
  const std::string motion = plot::svg::element(
      "animate", {{"attributeName", "cx"},
                  {"dur", seconds_text(slowness * (last - first))},
                  {"repeatCount", "indefinite"},
                  {"values", plot::svg::number(left) + ";" + plot::svg::number(right)}});
  return time_ticks(first, last, left, right, y) +
         plot::svg::text(
             {right + 12, y + 4}, label, {plot::Ink::muted, plot::small_size, false, "start", 0}) +
         plot::svg::element(
             "circle",
             {{"class", "cb-solid cb-ink"},
              {"cx", plot::svg::number(left)},
              {"cy", plot::svg::number(y)},
              {"r", "4"}},
             motion);
}

} // namespace cookbook
