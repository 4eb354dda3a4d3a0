#pragma once

/// \file
/// \brief What a pointer does in the picture of a world.

#include "07_constraints/play/trial/play_world.hpp"
#include "tools/live/page.hpp"

#include <algorithm>

namespace cookbook::play
{

/// The picture in every host, so that pointers agree [pixels].
inline constexpr int picture_width = 640, picture_height = 400;

/// The camera of a world that is played with.
inline Camera<double> camera_of(const Play& play)
{
  return orbit_camera(play.orbit, picture_width, picture_height);
}

/// Drags what is held, or the camera, and lets go; `press(ray)` says what is done where the pointer
/// goes down.
template <class Press>
void follow_pointer(Play& play, const live::Pointer& pointer, const Press& press)
{
  const Camera<double> camera = camera_of(play);
  if (pointer.wheel != 0)
  {
    zoom(play.orbit, pointer.wheel > 0 ? 0.9 : 1 / 0.9);
  }
  if (pointer.pressed)
  {
    press(picking_ray(camera, pointer.at));
  }
  else if (pointer.down && play.hand.held)
  {
    Vector3<double>& target = play.hand.held->target;
    target = drag_point(camera, pointer.at, target).value_or(target);
  }
  else if (pointer.down)
  {
    const Vector2<double> moved = pointer.at - play.pointer;
    turn(play.orbit, moved.x(), moved.y());
    play.orbit.pitch = std::max(play.orbit.pitch, 0.02); // above the ground
  }
  if (!pointer.down)
  {
    let_go(play.world, play.hand);
  }
  play.pointer = pointer.at;
}

} // namespace cookbook::play
