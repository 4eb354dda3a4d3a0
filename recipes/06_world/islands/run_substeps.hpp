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

/// Moves bodies on with their velocities for a substep [s]; what nothing pushes flies freely.
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
        const double rounding = free.pushed ? Solver::rounding : velocity_rounding;
        body.motion.center += displacement(world, i, free, substep, rounding);
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

/// The same for a solver that corrects poses, which it does where velocities have led all bodies;
/// what it leaves there goes on along its parabola.
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
        RigidBody& body = world.bodies[i];
        FreeMotion& free = world.scratch.free[k];
        if (body.motion.center == moved[k].motion.center &&
            body.orientation.coeffs() == moved[k].orientation.coeffs())
        {
          body.motion.center += displacement(world, i, free, substep, velocity_rounding) -
                                substep * body.motion.velocity;
        }
        else
        {
          free.pushed = true;
        }
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
        Motion<double>& now = world.bodies[i].motion;
        free.pushed = was_pushed(now, free) || free.pushed;
        if (world.falls != nullptr && free.pushed)
        {
          (*world.falls)[i] = false;
        }
      });
}

/// Moves islands on by a step [s]; velocities and poses are integrated nowhere else.
template <SubstepSolver Solver>
void run_substeps(IslandView world, std::span<const Island> islands, double step, Solver& solver)
{
  if (world.falls != nullptr)
  {
    each_body(islands, [&](std::size_t, std::size_t i) { (*world.falls)[i] = true; });
  }
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
  solver.store();
}
// [run_substeps]

} // namespace cookbook
