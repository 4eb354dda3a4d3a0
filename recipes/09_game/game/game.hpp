#pragma once

/// \file
/// \brief The game: a slingshot, towers of bricks, and pigs that break by an impulse.

// [head]
#include "09_game/game/level.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace cookbook::game
{
// [head]

// [game]
/// What the game waits for, or how it ended.
enum class Phase
{
  aiming, ///< for the player; nothing moves
  flying, ///< for the ruin to come to rest
  won,
  lost
};

/// What a phase is called.
inline const char* name_of(Phase phase)
{
  constexpr std::array<const char*, 4> names{"aiming", "flying", "won", "lost"};
  return names[static_cast<std::size_t>(phase)];
}

/// A pig that is whole.
struct WholePig
{
  std::size_t body; ///< its place in the world's list
  double strength;  ///< [N s]
};

/// A game as it stands between two steps.
struct Game
{
  small_world::World world;
  std::vector<std::size_t> birds{}; ///< that have not flown, by their places; the last is next
  std::vector<WholePig> pigs{};
  std::size_t first_pig = 0; ///< the place of the first pig: birds are before it, bricks behind
  Phase phase = Phase::aiming;
  Vector3<double> pull = Vector3<double>::Zero(); ///< [m], from the sling to the bird on it
  double turn_time = 0;                           ///< [s], since the shot
  int points = 0;
};

inline constexpr double step_time = 1.0 / 60;    ///< [s], of a step
inline constexpr double longest_turn = 8;        ///< [s], after which the next bird may fly anyway
inline constexpr double bird_radius = 0.25;      ///< [m]
inline constexpr double bird_mass = 100;         ///< [kg]
inline constexpr double stiffness = 25600;       ///< [N/m], of the sling's spring, k
inline constexpr double longest_pull = 1.2;      ///< [m]
inline constexpr double rolling_resistance = 20; ///< [rad/s²], by which a sphere's spin slows down
inline constexpr int points_for_pig = 1000;      ///< that broke
inline constexpr int points_for_bird = 500;      ///< that was not needed
inline const Vector3<double> sling(0, 2, 0);     ///< [m], where a bird sits that is not pulled
inline const Vector3<double> off(0, -100, 0);    ///< [m], where bodies are that are out of the game
// [game]

// [start]
/// Takes a body out of the game, and wakes what may have leant on it.
inline void remove(small_world::World& world, std::size_t i)
{
  world.bodies[i] = small_world::sphere(off, 1, 0);
  for (std::size_t other = 0; other < world.bodies.size(); ++other)
  {
    small_world::wake(world, other);
  }
}

/// Puts the next bird, if there is one, on the sling.
inline void load_sling(Game& game)
{
  game.phase = Phase::aiming;
  game.pull.setZero();
  game.world.bodies[game.birds.back()].motion.center = sling;
}

/// A new game of a level; refuses one that check() refuses. To restart, call it again.
inline Game start(const Level& level)
{
  check(level);
  Game game;
  add(game.world, body_of_ground()); // the ground
  for (int i = 0; i < level.birds; ++i)
  {
    const Vector3<double> waiting(-1.0 - 0.7 * (level.birds - i), bird_radius, 0);
    game.birds.push_back(add(game.world, small_world::sphere(waiting, bird_radius, 0)));
  }
  game.first_pig = game.world.bodies.size();
  for (const Pig& pig : level.pigs)
  {
    game.pigs.push_back({add(game.world, body_of(pig)), pig.strength});
  }
  for (const Brick& brick : level.bricks)
  {
    add(game.world, body_of(brick));
  }
  load_sling(game);
  return game;
}
// [start]

// [sling]
/// Pulls the bird on the sling by a vector [m], or as far in its direction as the sling allows.
inline void aim(Game& game, const Vector2<double>& pull)
{
  const double length = pull.norm();
  if (game.phase == Phase::aiming && length < 1e6) // which is false for a number that is none
  {
    game.pull = in_world(pull) * (length > longest_pull ? longest_pull / length : 1);
    game.world.bodies[game.birds.back()].motion.center = sling + game.pull;
  }
}

/// The velocity [m/s] of a bird that has all the energy of a spring with this pull [m]; G1.
inline Vector3<double> sling_velocity(const Vector3<double>& pull)
{
  return -std::sqrt(stiffness / bird_mass) * pull;
}

/// Where a bird is a time [s] after the sling has let it go, if nothing is in its way; G2.
inline Vector3<double> flight(const Game& game, double time)
{
  return sling + game.pull + time * sling_velocity(game.pull) +
         time * time / 2 * game.world.gravity;
}

/// Lets the bird on the sling go.
inline void shoot(Game& game)
{
  if (game.phase == Phase::aiming)
  {
    small_world::RigidBody bird = small_world::sphere(sling + game.pull, bird_radius, bird_mass);
    bird.motion.velocity = sling_velocity(game.pull);
    game.world.bodies[game.birds.back()] = bird;
    game.birds.pop_back();
    game.pull.setZero();
    game.phase = Phase::flying;
    game.turn_time = 0;
  }
}
// [sling]

// [break]
/// The hardest push [N s] that a body got at a contact point in the last step: half of the sum over
/// its substeps, each of which has solved the point twice; G3.
inline double hardest_push(const small_world::World& world, std::size_t body)
{
  double hardest = 0;
  for (const small_world::Contact& contact : world.contacts)
  {
    if (contact.a == body || contact.b == body)
    {
      hardest = std::max(hardest, contact.total_impulse / 2);
    }
  }
  return hardest;
}

/// Removes the pigs that were pushed too hard or have fallen off the ground, and counts them.
inline void break_pigs(Game& game)
{
  const auto breaks = [&](const WholePig& pig)
  {
    return hardest_push(game.world, pig.body) > pig.strength ||
           game.world.bodies[pig.body].motion.center.y() < -1;
  };
  const auto broken = std::stable_partition(
      game.pigs.begin(), game.pigs.end(), [&](const WholePig& pig) { return !breaks(pig); });
  std::for_each(
      broken, game.pigs.end(),
      [&](const WholePig& pig)
      {
        remove(game.world, pig.body);
        game.points += points_for_pig;
      });
  game.pigs.erase(broken, game.pigs.end());
}
// [break]

// [step]
/// Slows down the spin of a sphere, as rolling resistance does, to zero and not beyond.
inline void resist_rolling(small_world::RigidBody& sphere)
{
  const double lost = rolling_resistance * step_time, spin = sphere.motion.angular_velocity.norm();
  sphere.motion.angular_velocity *= spin > lost ? 1 - lost / spin : 0;
}

/// Lets spheres that roll come to rest, and removes what has fallen off the ground.
inline void tidy_up(small_world::World& world)
{
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    if (world.bodies[i].is_sphere)
    {
      resist_rolling(world.bodies[i]);
    }
    if (world.bodies[i].inverse_mass > 0 && world.bodies[i].motion.center.y() < -1)
    {
      remove(world, i);
    }
  }
}

/// Whether the turn is over: all sleep, or it has taken long enough.
inline bool is_over(const Game& game)
{
  std::size_t still = 0;
  while (still < game.world.bodies.size() && small_world::is_still(game.world, still))
  {
    ++still;
  }
  return still == game.world.bodies.size() || game.turn_time >= longest_turn;
}

/// Ends the game, or puts the next bird on the sling.
inline void end_turn(Game& game)
{
  if (game.pigs.empty())
  {
    game.phase = Phase::won;
    game.points += points_for_bird * static_cast<int>(game.birds.size());
  }
  else if (game.birds.empty())
  {
    game.phase = Phase::lost;
  }
  else
  {
    load_sling(game);
  }
}

/// Moves the game on by a step, if a bird is on its way.
inline void step(Game& game)
{
  if (game.phase != Phase::flying)
  {
    return;
  }
  small_world::step(game.world, step_time);
  game.turn_time += step_time;
  break_pigs(game);
  tidy_up(game.world);
  if (is_over(game))
  {
    end_turn(game);
  }
}
// [step]

// [hash]
/// A number that all bits of the places of all bodies that can move are in (FNV-1a): equal ruins
/// have equal ones.
inline std::uint64_t ruin_hash(const small_world::World& world)
{
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](double value)
  { hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3; };
  for (const small_world::RigidBody& body : world.bodies)
  {
    if (body.inverse_mass > 0)
    {
      const auto& turn = body.orientation.coeffs();
      std::for_each(body.motion.center.begin(), body.motion.center.end(), add);
      std::for_each(turn.begin(), turn.end(), add);
    }
  }
  return hash;
}
// [hash]

} // namespace cookbook::game
