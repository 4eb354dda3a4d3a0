#pragma once

/// \file
/// \brief Bodies of a world that turn, as many at a time as a register has doubles.

#include "06_world/contacts/integrate_body.hpp"
#include "06_world/lanes/turn_in_lanes.hpp"
#include "06_world/wide_solver/wide_view.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace cookbook
{

// [wide_rotations]
/// Turns bodies as integrate_rotation() does; those that turn little, many at a time, balls and
/// cubes among them: these by the right angle to a ten-millionth.
class WideRotations
{
public:
  /// Turns them by these passes.
  explicit WideRotations(const WidePasses& passes) : rotate_(passes.turn), lanes_(passes.lanes / 2)
  {
  }

  /// Turns these bodies with their velocities for a time [s]; their matrices are left for
  /// update_axes().
  void rotate(std::span<RigidBody> bodies, std::span<const int> which, double time)
  {
    little_.clear();
    little_.reserve(bodies.size());
    for (const int i : which)
    {
      RigidBody& body = bodies[index_of(i)];
      if (turns_little(body, time))
      {
        little_.push_back(&body);
      }
      else
      {
        integrate_rotation(body, time);
      }
    }
    for (std::size_t first = 0; first < little_.size(); first += lanes_)
    {
      turn(first, time);
    }
  }

private:
  static constexpr std::size_t most_lanes = 8; // of doubles, in the widest register

  /// Turns as many as there are lanes; where fewer are left, the last one is in several.
  void turn(std::size_t first, double time)
  {
    const auto body = [&](std::size_t lane) -> RigidBody&
    { return *little_[std::min(first + lane, little_.size() - 1)]; };
    alignas(64) double numbers[turning_numbers * most_lanes];
    for (std::size_t lane = 0; lane < lanes_; ++lane)
    {
      TurningLane<double> put{rotation_of(body(lane)), body(lane).moments};
      WriteLane<double> write{numbers + lane, lanes_};
      each_turned(put, write);
      each_stored(put, write);
    }
    rotate_(numbers, time);
    for (std::size_t lane = 0; lane < lanes_; ++lane)
    {
      TurningLane<double> taken;
      ReadLane<double> read{numbers + lane, lanes_};
      each_turned(taken, read);
      set_rotation(taken.now, body(lane));
    }
  }

  void (*rotate_)(double* numbers, double time);
  std::size_t lanes_;
  std::vector<RigidBody*> little_;
};
// [wide_rotations]

} // namespace cookbook
