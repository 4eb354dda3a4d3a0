#pragma once

/// \file
/// \brief How islands go on by a step: the only place where bodies that push each other are moved.

#include "06_world/contacts/integrate_body.hpp"
#include "06_world/islands/displacement.hpp"
#include "06_world/lanes/reserve_space.hpp"

#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace cookbook
{

// [run_substeps]
/// What a solver of islands is: it changes velocities and, where it has correct(), poses; it moves
/// no body on. All but prepare() hear how long a substep is [s].
///
/// `prepare(step)` reads the islands before a step [s], and says how many substeps it takes.
/// `solve` pushes before bodies move, `relax` afterwards. `store` ends the step. `rounding` [1] is
/// that of velocities.
template <class Solver>
concept SubstepSolver = requires(Solver& solver, double time)
{
  {
    solver.prepare(time)
    } -> std::same_as<int>;
  solver.solve(time);
  solver.relax(time);
  solver.store();
  {
    Solver::rounding
    } -> std::convertible_to<double>;
};

/// Calls `call(k, number)` for all bodies of islands, the k-th with its number in the world.
template <class Call>
void each_body(std::span<const Island> islands, const Call& call)
{
  std::size_t k = 0;
  for (const Island& island : islands)
  {
    for (const int number : island.bodies)
    {
      call(k++, index_of(number));
    }
  }
}

/// Has what pulls bodies change their velocities for a substep [s].
inline void accelerate(IslandView world, std::span<const Island> islands, double substep)
{
  std::vector<FreeMotion>& free = world.scratch.free;
  free.clear();
  each_body(
      islands,
      [&](std::size_t, std::size_t i)
      {
        apply_forces(world, static_cast<int>(i), substep);
        const Motion<double>& motion = world.bodies[i].motion;
        free.push_back({motion.velocity, motion.angular_velocity, false});
      });
}

/// Whether a solver has changed the velocities of a body. Pushes that overflow are taken back.
inline bool was_pushed(Motion<double>& now, const FreeMotion& free)
{
  if (!now.velocity.allFinite() || !now.angular_velocity.allFinite())
  {
    now = {now.center, free.velocity, free.angular_velocity};
  }
  return now.velocity != free.velocity || now.angular_velocity != free.angular_velocity;
}

/// Turns bodies that a solver pushes for a substep [s].
inline void rotate(IslandView world, std::span<const int> pushed, double substep)
{
  for (const int i : pushed)
  {
    integrate_rotation(world.bodies[index_of(i)], substep);
    update_axes(world.bodies[index_of(i)]);
  }
}

/// Moves bodies on with their velocities for a substep [s]; what nothing pushes turns freely.
template <SubstepSolver Solver>
void move(IslandView world, std::span<const Island> islands, double substep, Solver& solver)
{
  std::vector<int>& pushed = world.scratch.pushed;
  pushed.clear();
  each_body(
      islands,
      [&](std::size_t k, std::size_t i)
      {
        RigidBody& body = world.bodies[i];
        FreeMotion& free = world.scratch.free[k];
        free.pushed = was_pushed(body.motion, free);
        body.motion.center += substep * body.motion.velocity;
        if (free.pushed)
        {
          pushed.push_back(static_cast<int>(i));
        }
        else
        {
          rotate_freely(body, substep);
          free.angular_velocity = body.motion.angular_velocity;
        }
      });
  if constexpr (requires { solver.rotate(pushed, substep); })
  {
    solver.rotate(pushed, substep);
  }
  else
  {
    rotate(world, pushed, substep);
  }
}

/// The same for a solver that corrects poses, which it does where velocities have led all bodies.
template <SubstepSolver Solver>
void move_and_correct(
    IslandView world, std::span<const Island> islands, double substep, Solver& solver)
{
  std::vector<PreviousState>& moved = world.scratch.moved;
  moved.clear();
  each_body(
      islands,
      [&](std::size_t k, std::size_t i)
      {
        RigidBody& body = world.bodies[i];
        world.scratch.free[k].pushed = was_pushed(body.motion, world.scratch.free[k]);
        integrate_position(body, substep);
        moved.push_back(state_of(body));
      });
  solver.correct(substep);
  each_body(
      islands,
      [&](std::size_t k, std::size_t i)
      {
        const RigidBody& body = world.bodies[i];
        FreeMotion& free = world.scratch.free[k];
        free.pushed = free.pushed || body.motion.center != moved[k].motion.center ||
                      body.orientation.coeffs() != moved[k].orientation.coeffs();
      });
}

/// Marks what anything pushed in a substep, also after it has moved: it does not fall freely.
inline void mark_pushed(IslandView world, std::span<const Island> islands)
{
  each_body(
      islands,
      [&](std::size_t k, std::size_t i)
      {
        FreeMotion& free = world.scratch.free[k];
        StepStart& start = world.scratch.starts[k];
        free.pushed = was_pushed(world.bodies[i].motion, free) || free.pushed;
        start.pushed = start.pushed || free.pushed;
      });
}

/// Remembers how bodies move as a step begins.
inline void begin(IslandView world, std::span<const Island> islands)
{
  std::vector<StepStart>& starts = world.scratch.starts;
  starts.clear();
  each_body(
      islands,
      [&](std::size_t, std::size_t i)
      {
        starts.push_back(
            {world.bodies[i].motion.velocity, world.bodies[i].motion.angular_velocity, false});
      });
}

/// Takes bodies back onto their parabolas in the end, and tells the world which fall freely. What
/// joints hold goes round them but for rounding: a joint would come apart by what was taken back.
inline void
end(IslandView world, std::span<const Island> islands, double step, double substep, double rounding)
{
  std::size_t k = 0;
  for (const Island& island : islands)
  {
    const double work = island.constraints.empty() ? holding_work : 0;
    for (const int number : island.bodies)
    {
      const std::size_t i = index_of(number);
      const StepStart& start = world.scratch.starts[k++];
      world.bodies[i].motion.center -= overshoot(world, i, start, step, substep, rounding, work);
      if (world.falls != nullptr)
      {
        (*world.falls)[i] = !start.pushed;
      }
    }
  }
}

/// Moves islands on by a step [s]; velocities and poses are integrated nowhere else.
template <SubstepSolver Solver>
void run_substeps(IslandView world, std::span<const Island> islands, double step, Solver& solver)
{
  begin(world, islands);
  const int substeps = solver.prepare(step);
  const double substep = step / substeps;
  for (int k = 0; k < substeps; ++k)
  {
    accelerate(world, islands, substep);
    solver.solve(substep);
    if constexpr (requires { solver.correct(substep); })
    {
      move_and_correct(world, islands, substep, solver);
    }
    else
    {
      move(world, islands, substep, solver);
    }
    solver.relax(substep);
    mark_pushed(world, islands);
  }
  end(world, islands, step, substep, Solver::rounding);
  solver.store();
}
// [run_substeps]

} // namespace cookbook
