/// \file
/// What holds for the game: the sling, the flight, what breaks a pig, turns, and the same bits
/// from the same shots.

#include "09_game/game/game.hpp"
#include "09_game/game/game_picture.hpp"

#include "09_game/game/trial/levels.hpp"
#include "09_game/game/trial/scripted_shots.hpp"
#include "tests/catch.hpp"

#include <limits>

using Catch::Approx;
using namespace cookbook;
using namespace cookbook::game;

namespace
{

/// A level of one pig that stands on the ground, and of no brick.
Level lone_pig(double strength)
{
  return {"a lone pig", 2, {}, {{{10, 0.35}, 0.35, strength}}};
}

/// A shot after which the first bird rolls at the lone pig.
const Vector2<double> at_pig{-0.9, -0.05};
/// A shot that flies backwards and hits nothing.
const Vector2<double> backwards{0.3, 0};

/// The hardest push that the first pig of a level gets in the first turn of a game.
double hardest_of_turn(const Level& level, const Vector2<double>& pull)
{
  Game game = start(level);
  aim(game, pull);
  shoot(game);
  double hardest = 0;
  while (game.phase == Phase::flying)
  {
    step(game);
    hardest = std::max(hardest, hardest_push(game.world, game.first_pig));
  }
  return hardest;
}

} // namespace

// [energy]
TEST_CASE("a sling of 25,600 N/m, pulled by 1 m, gives 100 kg all of its 12,800 J: 16 m/s", "[G1]")
{
  Game game = start(lone_pig(100));
  aim(game, {-0.6, -0.8});
  shoot(game);
  const small_world::RigidBody& bird = game.world.bodies[2];
  REQUIRE(bird.motion.velocity.isApprox(Vector3<double>(9.6, 12.8, 0), 1e-15));
  REQUIRE(bird.motion.velocity.squaredNorm() * bird_mass / 2 == Approx(12'800).epsilon(1e-15));
}
// [energy]

// [flight]
TEST_CASE("a flight stays below its parabola by g h t / 2 with substeps of h = 1/240 s", "[G2]")
{
  Game game = start(lone_pig(100));
  aim(game, {-0.5, -0.8});
  const Game aimed = game;
  shoot(game);
  for (int i = 1; i <= 60; ++i)
  {
    step(game);
    Vector3<double> right = flight(aimed, i / 60.0);
    right.y() -= 9.81 / 240 * (i / 60.0) / 2;
    REQUIRE((game.world.bodies[2].motion.center - right).norm() < 1e-12);
  }
}
// [flight]

// [push]
TEST_CASE("the push of 40 kg at 5 m/s that a wall stops is 200 N s, at rest m g h", "[G3]")
{
  small_world::World world;
  world.gravity.setZero();
  add(world, small_world::box({0, 0, 0}, {0.5, 5, 5}, 0));
  const std::size_t pig = add(world, small_world::sphere({-1, 0, 0}, 0.35, 40));
  world.bodies[pig].motion.velocity.x() = 5;
  double hardest = 0;
  for (int i = 0; i < 60; ++i)
  {
    small_world::step(world, step_time);
    hardest = std::max(hardest, hardest_push(world, pig));
  }
  REQUIRE(hardest == Approx(200).epsilon(1e-6));
  REQUIRE(hardest_of_turn(lone_pig(1e4), backwards) == Approx(40 * 9.81 / 60).epsilon(0.01));
}
// [push]

// [strength]
TEST_CASE("a pig breaks if a push is a thousandth above its strength, not if it is as much below")
{
  const double push = hardest_of_turn(lone_pig(1e4), at_pig);
  REQUIRE(push > 100);
  Game weaker = start(lone_pig(push / 1.001));
  REQUIRE(play(weaker, at_pig).broken == 1);
  Game stronger = start(lone_pig(push * 1.001));
  REQUIRE(play(stronger, at_pig).broken == 0);
}
// [strength]

// [turns]
TEST_CASE("a pig is worth 1,000 points, a bird that was not needed 500; without birds it is lost")
{
  Game game = start(lone_pig(50));
  REQUIRE(game.phase == Phase::aiming);
  play(game, backwards);
  REQUIRE(game.phase == Phase::aiming);
  REQUIRE(game.points == 0);
  Game other = game;
  play(game, at_pig);
  REQUIRE(game.phase == Phase::won);
  REQUIRE(game.points == 1000);
  play(other, backwards);
  REQUIRE(other.phase == Phase::lost);
  REQUIRE(played(lone_pig(50), {at_pig}).points == 1500);
}
// [turns]

TEST_CASE("nothing is aimed, shot or moved while it is not its turn")
{
  Game game = start(lone_pig(50));
  const std::uint64_t before = ruin_hash(game.world);
  step(game);
  REQUIRE(ruin_hash(game.world) == before);
  shoot(game);
  REQUIRE(game.birds.size() == 1);
  shoot(game);
  aim(game, {-1, 0});
  REQUIRE(game.birds.size() == 1);
  REQUIRE(game.pull.isZero(0));
  game = played(lone_pig(50), {at_pig});
  const std::uint64_t after = ruin_hash(game.world);
  shoot(game);
  step(game);
  REQUIRE(ruin_hash(game.world) == after);
}

TEST_CASE("a pull is cut to 1.2 m, and one that is no number is not taken")
{
  Game game = start(lone_pig(50));
  aim(game, {-3, -4});
  REQUIRE(game.pull.isApprox(Vector3<double>(-0.72, -0.96, 0)));
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), 1e300})
  {
    aim(game, {wrong, 0});
    REQUIRE(game.pull.isApprox(Vector3<double>(-0.72, -0.96, 0)));
  }
}

// [replay]
TEST_CASE("the same shots leave the same ruin to the bit, after a restart too; others do not")
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Level& level = built_in_levels()[i];
    const Shots& shots = winning_shots[i];
    Game game = played(level, shots);
    const std::uint64_t ruin = ruin_hash(game.world);
    game = start(level);
    REQUIRE(ruin_hash(game.world) != ruin);
    REQUIRE(ruin_hash(played(level, shots).world) == ruin);
    Shots other = shots;
    other[0].x() += 1e-15;
    REQUIRE(ruin_hash(played(level, other).world) != ruin);
  }
}
// [replay]

// [levels]
TEST_CASE("each level stands while nothing hits it, and is won by its shots within 8 s a turn")
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Level& level = built_in_levels()[i];
    Game game = start(level);
    const std::vector<small_world::RigidBody> before = game.world.bodies;
    REQUIRE(play(game, backwards).steps < 240);
    for (std::size_t j = game.first_pig; j < before.size(); ++j)
    {
      const small_world::RigidBody& body = game.world.bodies[j];
      REQUIRE((body.motion.center - before[j].motion.center).norm() < 0.02);
    }
    game = start(level);
    for (const Vector2<double>& pull : winning_shots[i])
    {
      REQUIRE(play(game, pull).steps < 480);
    }
    REQUIRE(game.phase == Phase::won);
  }
}
// [levels]

TEST_CASE("of 99 pulls more than a tenth and less than half win the first level", "[long]")
{
  int won = 0;
  for (int i = 0; i < 99; ++i)
  {
    const Vector2<double> pull(-0.3 - 0.1 * (i % 9), 0.1 - 0.1 * (i / 9));
    won += played(built_in_levels()[0], {pull}).phase == Phase::won ? 1 : 0;
  }
  CAPTURE(won);
  REQUIRE(won > 9);
  REQUIRE(won < 50);
}

TEST_CASE("a turn is over when all sleep: a second more moves nothing")
{
  Game game = played(built_in_levels()[0], winning_shots[0]);
  const std::uint64_t ruin = ruin_hash(game.world);
  for (int i = 0; i < 60; ++i)
  {
    small_world::step(game.world, step_time);
  }
  REQUIRE(ruin_hash(game.world) == ruin);
}

TEST_CASE("a brick that lay on a pig falls once the pig is broken")
{
  Level level = lone_pig(1e4);
  level.bricks.push_back({Material::wood, {10, 0.8}, {0.5, 0.1}});
  level.birds = 1;
  Game game = start(level);
  play(game, backwards);
  remove(game.world, game.first_pig);
  for (int i = 0; i < 60; ++i)
  {
    small_world::step(game.world, step_time);
  }
  REQUIRE(game.world.bodies.back().motion.center.y() == Approx(0.1).margin(0.01));
}

TEST_CASE("a pig that falls off the ground is broken")
{
  Game game = start(lone_pig(1e4));
  game.world.bodies[game.first_pig].motion.center.x() = 26;
  REQUIRE(play(game, backwards).broken == 1);
  REQUIRE(game.phase == Phase::won);
}

// [hostile]
TEST_CASE("a level that cannot be played is refused by the member that is wrong")
{
  const auto refused = [](const std::string& words, const auto& change)
  {
    Level level = built_in_levels()[0];
    change(level);
    CHECK_THROWS_WITH(start(level), Catch::Matchers::ContainsSubstring(words));
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  refused("number of pigs is 0", [](Level& level) { level.pigs.clear(); });
  refused("birds is 0", [](Level& level) { level.birds = 0; });
  refused("number of bricks is 96", [](Level& level) { level.bricks.resize(96); });
  refused(
      "brick 2: half_extents.x() is -0.2",
      [](Level& level) { level.bricks[1].half_extents.x() = -0.2; });
  refused("brick 3: center.y() is nan", [&](Level& level) { level.bricks[2].center.y() = none; });
  refused("pig 1: radius is nan", [&](Level& level) { level.pigs[0].radius = none; });
  refused("pig 1: strength is 0", [](Level& level) { level.pigs[0].strength = 0; });
  refused(
      "brick 1 and brick 2 overlap by 0.2",
      [](Level& level) { level.bricks[1].center.y() -= 0.2; });
  refused("the ground and pig 1 overlap", [](Level& level) { level.pigs[0].center.y() = 0.2; });
}
// [hostile]

TEST_CASE("the pixel under the bird gives the pull that it has, in pictures of two sizes")
{
  for (const int width : {320, 640})
  {
    const Camera<double> camera = game_camera(width, width * 5 / 8);
    for (const Vector2<double>& pull : {Vector2<double>(0, 0), {-1.1, -0.3}, {-0.4, -1.1}})
    {
      const auto seen = to_pixel<double>(camera, Vector3<double>(sling + in_world(pull)));
      REQUIRE(seen);
      REQUIRE((pull_at(camera, seen->pixel) - pull).norm() < 1e-12);
    }
  }
}

TEST_CASE("a picture shows the sling's pull, wood and stone, by day and by night")
{
  Game game = start(built_in_levels()[1]);
  const std::uint64_t before = picture_hash(draw(game, 160, 100, false));
  REQUIRE(picture_hash(draw(game, 160, 100, false)) == before);
  REQUIRE(picture_hash(draw(game, 160, 100, true)) != before);
  REQUIRE(look_of(game, game.first_pig - 1) == Look::bird);
  REQUIRE(look_of(game, game.first_pig) == Look::pig);
  REQUIRE(look_of(game, game.first_pig + 2) == Look::stone);
  REQUIRE(look_of(game, game.first_pig + 3) == Look::wood);
  aim(game, {-1, -0.2});
  REQUIRE(picture_hash(draw(game, 160, 100, false)) != before);
  remove(game.world, game.first_pig);
  REQUIRE(look_of(game, game.first_pig) == Look::none);
}
