#pragma once

/// \file
/// \brief Pictures of scenes: one frame, several side by side, and frames that move.

#include "06_world/scenes/trial/frames.hpp"
#include "tools/plot/panel.hpp"

#include <functional>

namespace cookbook
{

/// From where a scene is seen, without perspective, and which part of it.
///
/// With yaw = pitch = 0 it is seen along −z: x to the right, y up, and bodies are translucent. From
/// elsewhere they hide what is behind them.
struct SceneView
{
  double yaw;          ///< [rad], above zero: from further right
  double pitch;        ///< [rad], above zero: from further up
  Eigen::Vector2d min; ///< [m], lower left corner of the picture, right and up as seen
  Eigen::Vector2d max; ///< [m], upper right corner
  double width;        ///< [pixels]
};

/// The view that shows where the movable bodies go, and fixed ones near them; what leaves the start
/// by more than its larger side, and by more than 6 m, is not followed. The picture is at most 1.2
/// times as high as wide.
SceneView view_of(
    const Scene& scene, const std::vector<Frame>& frames, double width = 480, double yaw = 0,
    double pitch = 0);

/// A picture of a scene, still or moving; can be put into a plot::Grid.
class SceneFigure
{
public:
  /// What draws it, starting every id with the one it is given.
  using Draw = std::function<plot::Panel(const std::string& id)>;

  /// `name` (letters, digits, `_`, `-`) makes its ids unique on a page.
  SceneFigure(std::string name, Draw draw);

  /// Says in a sentence what is shown, for those who cannot see it.
  SceneFigure& describe(std::string text);

  /// The drawing without its document; `id` starts every id in it.
  plot::Panel panel(const std::string& id) const;

  /// The whole document.
  std::string svg() const;

private:
  std::string name_;
  std::string description_;
  Draw draw_;
};

/// A scene at one time. A body that is nowhere, for its position is not finite, is left out.
SceneFigure scene_picture(
    const std::string& name, const std::string& title, const Scene& scene, const Frame& frame,
    const SceneView& view);

/// How a scene moves in a picture.
struct Pace
{
  double slowness = 1;              ///< 10: it takes ten times as long as it did
  std::size_t most_bytes = 400'000; ///< of the picture: frames are left out until it is so small
};

/// A scene that moves, again and again, with the time below it.
SceneFigure scene_animation(
    const std::string& name, const std::string& title, const Scene& scene,
    const std::vector<Frame>& frames, const SceneView& view, const Pace& pace = {});

/// A scene at several times [s], side by side, `columns` in a row.
plot::Grid scene_strip(
    const std::string& name, const Scene& scene, const std::vector<Frame>& frames,
    const std::vector<double>& times, const SceneView& view, int columns);

/// A frame, and what it shows.
struct NamedFrame
{
  std::string name; ///< such as the method that made it
  Frame frame;      ///< of the scene they share
};

/// The same scene as different methods left it, side by side, `columns` in a row.
plot::Grid scene_gallery(
    const std::string& name, const Scene& scene, const std::vector<NamedFrame>& frames,
    const SceneView& view, int columns = 3);

} // namespace cookbook
