#pragma once

/// \file
/// \brief Boxes that rest or slide for many frames, and what becomes of axes and points meanwhile.

#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "04_obb_manifolds/feature_memory/trial/feature_memory_pitfalls.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"

#include <vector>

namespace cookbook
{

/// Two boxes, frame after frame.
using Frames = std::vector<BoxPair<double>>;

// [scenes]
/// A box as a solver leaves it in each frame: up to 1e-6 m and 1e-4 rad from where it should be.
inline Obb<double> jittered(const Obb<double>& box, BoxDraw& draw)
{
  const Vector3<double> step = 1e-6 * draw.vector(-1, 1);
  const double angle = draw.between(-1e-4, 1e-4);
  return {box.center + step, BoxDraw::tilt(angle, draw.direction()) * box.axes, box.half_extents};
}

/// A cube of 1 m resting on another, 1 mm deep, tilted by an angle [rad] about (1, 2, 3).
inline Frames jittered_stack(double angle)
{
  const Vector3<double> half(0.5, 0.5, 0.5);
  const Obb<double> below = upright({0, 0, 0}, half);
  const Obb<double> above{{0, 0.999, 0}, turned(angle, {1, 2, 3}), half};
  BoxDraw draw(1);
  Frames frames;
  for (int frame = 0; frame < 1000; ++frame)
  {
    frames.push_back({below, jittered(above, draw)});
  }
  return frames;
}

/// A beam on one of its edges, leaning by 0.6 rad, which lies across the same cube and is longer.
inline Frames jittered_beam()
{
  const Obb<double> below = upright({0, 0, 0}, {0.5, 0.5, 0.5});
  const Matrix3<double> askew = turned(0.4, {0, 1, 0}) * turned(0.6, {0, 0, 1});
  const double up = 0.2 * (std::cos(0.6) + std::sin(0.6));
  const Obb<double> beam{{0, 0.499 + up, 0}, askew, {0.2, 0.2, 0.8}};
  BoxDraw draw(3);
  Frames frames;
  for (int frame = 0; frame < 1000; ++frame)
  {
    frames.push_back({below, jittered(beam, draw)});
  }
  return frames;
}

/// The cube, flat, turned by 0.3 rad, sliding at 0.1 m/s over the edge of a plate; 5 s at 60 Hz.
inline Frames sliding_cube()
{
  const Obb<double> plate = upright({0, 0, 0}, {1, 0.1, 1});
  const Matrix3<double> yaw = turned(0.3, {0, 1, 0});
  BoxDraw draw(2);
  Frames frames;
  for (int frame = 0; frame <= 300; ++frame)
  {
    const Vector3<double> center(0.4 + frame * 0.1 / 60, 0.599, 0.1);
    frames.push_back({plate, jittered({center, yaw, {0.5, 0.5, 0.5}}, draw)});
  }
  return frames;
}
// [scenes]

/// The axis that a way to choose takes in each frame; −1 where it finds the boxes apart.
template <class Choose>
std::vector<int> axes_over(const Frames& frames, const Choose& choose)
{
  std::vector<int> axes;
  for (const auto& [a, b] : frames)
  {
    axes.push_back(choose(a, b));
  }
  return axes;
}

/// The axis of least overlap.
inline std::vector<int> least_axes(const Frames& frames)
{
  return axes_over(
      frames,
      [](const Obb<double>& a, const Obb<double>& b)
      {
        const auto least = separating_axes(a, b);
        return least ? least->axis : -1;
      });
}

/// The axis of box_box().
inline std::vector<int> forgetful_axes(const Frames& frames)
{
  return axes_over(
      frames, [](const Obb<double>& a, const Obb<double>& b) { return axis_of(box_box(a, b)); });
}

/// The axis of next_frame().
inline std::vector<int> remembered_axes(const Frames& frames)
{
  ContactMemory<double, int> memory{};
  return axes_over(
      frames,
      [&memory](const Obb<double>& a, const Obb<double>& b)
      {
        memory = next_frame(memory, a, b);
        return axis_of(memory.manifold);
      });
}

/// How often an axis is not that of the frame before.
inline int flips(const std::vector<int>& axes)
{
  int count = 0;
  for (std::size_t frame = 1; frame < axes.size(); ++frame)
  {
    count += axes[frame] != axes[frame - 1] ? 1 : 0;
  }
  return count;
}

/// What became of the data of contact points, from each frame to the next.
struct Persistence
{
  int points = 0; ///< all, after the first frame
  int right = 0;  ///< those that were given what belonged to the point at their place
  int wrong = 0;  ///< those that were given what belonged to a point elsewhere
};

/// Counts a frame's points; where a point was is carried with it as its datum, and a centimetre is
/// farther than any of them moves.
inline void count(
    Persistence& all, const Manifold<double>& now,
    const PerPoint<std::optional<Vector3<double>>>& was)
{
  for (std::size_t i = 0; i < now.points.size(); ++i)
  {
    const bool close_by = was[i] && (*was[i] - now.points[i].position).norm() < 0.01;
    all.points += 1;
    all.right += close_by ? 1 : 0;
    all.wrong += was[i] && !close_by ? 1 : 0;
  }
}

/// What becomes of the data of points that `match(before, warm, now)` carries over, with the axis
/// remembered or not.
template <class Match>
Persistence persistence(const Frames& frames, bool with_memory, const Match& match)
{
  using Places = PerPoint<std::optional<Vector3<double>>>;
  Persistence all;
  ContactMemory<double, int> memory{};
  std::optional<Manifold<double>> before;
  for (const auto& [a, b] : frames)
  {
    memory = with_memory ? next_frame(memory, a, b) : ContactMemory<double, int>{box_box(a, b), {}};
    if (before)
    {
      Places places{};
      std::transform(
          before->points.begin(), before->points.end(), places.begin(),
          [](const ContactPoint<double>& point) { return point.position; });
      count(all, *memory.manifold, match(*before, places, *memory.manifold));
    }
    before = memory.manifold;
  }
  return all;
}

} // namespace cookbook
