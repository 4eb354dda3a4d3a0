/// \file
/// Which bodies may touch: by a tree, and sorted and swept, against every pair.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "06_world/contacts/start_body.hpp"
#include "06_world/islands/free_flight.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/sweeps/ccd_pairs.hpp"
#include "06_world/sweeps/predicted_contacts.hpp"
#include "06_world/world_chart/trial/broad_phase_scenes.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

using namespace cookbook;

namespace
{

/// Up to 24 bounds with sides of a few whole numbers, so that many only touch, and maybe a plane.
std::vector<Bounds> random_bounds(BoxDraw& draw)
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Bounds> bounds;
  const int count = draw.whole(24);
  for (int i = 0; i < count; ++i)
  {
    const Vector3<double> low(draw.whole(12), draw.whole(12), draw.whole(12));
    const Vector3<double> size(draw.whole(4), draw.whole(4), draw.whole(4));
    bounds.push_back({{low, low + size}, i});
  }
  if (draw.whole(2) == 0)
  {
    const Vector3<double> infinite = Vector3<double>::Constant(infinity);
    bounds.push_back({{-infinite, infinite}, count});
  }
  return bounds;
}

/// Balls and boxes on a ground, at up to a speed [m/s]; half of the scenes have no gravity, and so
/// no margin.
Scene moving_bodies(BoxDraw& draw, double speed)
{
  Scene scene{.bodies = {ground()}};
  scene.gravity *= draw.whole(2);
  for (int i = 0; i < 40; ++i)
  {
    const Vector3<double> place = draw.vector(0, 4);
    const double size = draw.between(0.05, 0.3);
    const Vector3<double> half(size, draw.between(0.05, 0.3), size);
    const bool sphere = draw.whole(2) == 0;
    scene.bodies.push_back(sphere ? ball_body("ball", size, place) : box_body("box", half, place));
    scene.bodies.back().velocity = draw.vector(-speed, speed);
    scene.bodies.back().angular_velocity = draw.vector(-speed, speed);
  }
  return scene;
}

/// Whether, of bodies that were moved in a step, all pairs that may have met are asked, and none
/// twice; of so many bodies one is moved elsewhere than it was going.
struct MetPairs
{
  std::size_t bodies_asked = 0, strays_asked = 0, missed = 0, twice = 0, lost = 0;

  void ask(BoxDraw& draw, double speed, int one_in)
  {
    const Scene scene = moving_bodies(draw, speed);
    const double margin = contact_margin(scene);
    std::vector<RigidBody> ends;
    std::vector<Bounds> bounds;
    std::vector<Prediction> prediction(scene.bodies.size());
    for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i)
    {
      RigidBody& body = ends.emplace_back(rigid_body(scene.bodies[index_of(i)]));
      const PredictedStep next{scene, ends, {}, prediction};
      prediction[index_of(i)] = predict(next, i);
      bounds.push_back({predicted_bounds(next, i, margin), i});
      const bool shoved = !is_fixed(body) && draw.whole(one_in) == 0;
      body.motion.velocity += shoved ? draw.vector(-50, 50) : Vector3<double>::Zero();
      is_fixed(body) ? void() : integrate_free_flight(body, {scene.gravity}, scene.step);
    }
    const std::vector<bool> falls(ends.size(), false), gone(ends.size(), false);
    std::vector<Trajectory> trajectories;
    std::vector<double> displacements;
    BroadPhase broad_phase;
    for (int asked = 0; asked < 3; ++asked) // then all that stay have room
    {
      pairs_by(broad_phase, bounds);
    }
    std::vector<bool> deep(ends.size(), false);
    StepTrajectories step{
        scene, {}, {}, falls, gone, broad_phase.close_pairs(), trajectories, displacements, deep};
    step.tree = &broad_phase.tree(bounds);
    set_trajectories(step, ends);
    compare(step, ends);
  }

  void compare(StepTrajectories& step, const std::vector<RigidBody>& ends)
  {
    bodies_asked += ends.size();
    strays_asked += escaped_leaves(step, ends).size();
    std::vector<std::pair<int, int>> asked;
    each_swept_overlap(step, ends, [&](int i, int j) { asked.emplace_back(i, j); });
    std::sort(asked.begin(), asked.end());
    twice += std::adjacent_find(asked.begin(), asked.end()) != asked.end() ? 1 : 0;
    lost += escaped_leaves(step, ends).size();
    for (int i = 0; i < static_cast<int>(ends.size()); ++i)
    {
      const auto of_i = swept_bounds(step, i, ends[index_of(i)]);
      for (int j = i + 1; j < static_cast<int>(ends.size()); ++j)
      {
        const bool meet = of_i.intersects(swept_bounds(step, j, ends[index_of(j)]));
        const bool found = std::binary_search(asked.begin(), asked.end(), std::pair(i, j));
        missed += meet && may_touch(step, i, j, 0) && !found ? 1 : 0;
      }
    }
  }
};

constexpr int scenes_asked = inputs(100'000, 2'000);

} // namespace

TEST_CASE(
    "by a tree, no pair is missed and none comes twice; sorted and swept neither", "[case:L5]")
{
  BoxDraw draw(11);
  BroadPhase tree;
  int wrong = 0;
  std::size_t found = 0;
  for (int i = 0; i < scenes_asked; ++i)
  {
    std::vector<Bounds> bounds = random_bounds(draw);
    const auto wanted = every_overlapping_pair(bounds);
    wrong += pairs_by(tree, bounds) != wanted ? 1 : 0;
    wrong += swept_pairs(bounds) != wanted ? 1 : 0;
    found += wanted.size();
  }
  CHECK(wrong == 0);
  CHECK(found > 5 * static_cast<std::size_t>(scenes_asked));
}

TEST_CASE(
    "two balls of 1 m that fly past each other may meet up to 1 m apart, and on their way only")
{
  Scene scene{.bodies = {ball_body("ball", 0.5, {0, 0, 0}), ball_body("other", 0.5, {0, 0, 0})}};
  scene.step = 1;
  const auto meet = [&](double aside, double speed, double time, double pull = 0)
  {
    std::vector<RigidBody> bodies{rigid_body(scene.bodies[0]), rigid_body(scene.bodies[1])};
    bodies[1].motion.center = {10, aside, 0};
    const Vector3<double> none(0, 0, 0);
    std::vector<Trajectory> trajectories{
        {&bodies[0], state_of(bodies[0]), 0, {speed, 0, 0}, {}, none},
        {&bodies[1], state_of(bodies[1]), 0, none, {{0, -pull, 0}}, none}};
    const std::vector<bool> no(2, false);
    std::vector<bool> needs_sweep(2, false);
    std::vector<double> displacements;
    return may_touch(
        {scene, {}, {}, no, no, {}, trajectories, displacements, needs_sweep}, 0, 1, time);
  };
  CHECK(meet(0.99, 20, 0));
  CHECK_FALSE(meet(1.01, 20, 0));
  CHECK(meet(0, 9.01, 0));
  CHECK_FALSE(meet(0, 8.99, 0)); // too slow
  CHECK_FALSE(meet(0, -20, 0));  // it parts
  CHECK(meet(0, 20, 0.4));
  CHECK_FALSE(meet(0, 20, 0.6)); // it is past
  CHECK(meet(2, 20, 0, 2));      // pulled, the other comes down by 1 m
}

TEST_CASE(
    "a sphere is a CCD candidate if it fell, is too deep, or if two went by more than its radius")
{
  const Scene scene{.bodies = {ball_body("ball", 0.5, {0, 0, 0}), cube_body("cube", {2, 0, 0})}};
  const auto danger =
      [&](double way, double other_way, bool falls, bool needs_sweep, int sphere = 0)
  {
    const std::vector<bool> fall{falls, falls}, gone(2, false);
    std::vector<bool> deep{needs_sweep, needs_sweep};
    std::vector<Trajectory> trajectories;
    std::vector<double> displacements{way, other_way};
    return needs_ccd(
        {scene, {}, {}, fall, gone, {}, trajectories, displacements, deep}, sphere, 1 - sphere);
  };
  CHECK(danger(0.3, 0.3, false, false));
  CHECK_FALSE(danger(0.3, 0.1, false, false));
  CHECK(danger(0, 0, true, false));
  CHECK(danger(0, 0, false, true));
  CHECK_FALSE(danger(1, 1, true, true, 1)); // a cube
}

TEST_CASE("a tree that follows bodies finds the pairs that every pair gives, however they move")
{
  BoxDraw draw(12);
  std::vector<Bounds> bounds = grid_bounds(inputs(400, 64));
  BroadPhase tree;
  for (int step = 0; step < 300; ++step)
  {
    const double way = step < 200 ? 0.1 : 3; // first they drift, then they scatter
    for (Bounds& one : bounds)
    {
      one.box.translate(draw.vector(-way, way));
    }
    if (step % 50 == 49)
    {
      bounds.erase(bounds.begin() + step / 10);
    }
    CAPTURE(step);
    REQUIRE(pairs_by(tree, bounds) == every_overlapping_pair(bounds));
  }
}

TEST_CASE("a tree follows the bodies it was built of, until they have spread or drawn together by "
          "a fifth")
{
  const std::vector<Bounds> row = row_bounds(100, 0);
  const auto wider = [&](double scale)
  {
    std::vector<Bounds> bounds = row;
    for (Bounds& one : bounds)
    {
      one.box = {scale * one.box.min(), scale * one.box.max()};
    }
    return bounds;
  };
  BoundsTree tree;
  CHECK_FALSE(tree.is_built_of(row));
  tree.build(row);
  CHECK(tree.is_built_of(row));
  const Eigen::AlignedBox<double, 3> box = tree.finite_box();
  const auto sorts_anew = [&](double scale)
  {
    const std::vector<Bounds> bounds = wider(scale);
    BoundsTree follows = tree;
    const bool anew =
        follows.update([&](const Bounds& one) { return bounds[index_of(one.index)].box; });
    CHECK(follows.finite_box().isApprox(
        Eigen::AlignedBox<double, 3>(scale * box.min(), scale * box.max())));
    return anew;
  };
  CHECK_FALSE(sorts_anew(1));
  CHECK_FALSE(sorts_anew(1.19));
  CHECK(sorts_anew(1.21));
  CHECK_FALSE(sorts_anew(0.84));
  CHECK(sorts_anew(0.83));
  std::vector<Bounds> others = row;
  others[7].body = 1000;
  CHECK_FALSE(tree.is_built_of(others));
  others.pop_back();
  CHECK_FALSE(tree.is_built_of(others));
}

TEST_CASE("a tree of 4,096 bodies side by side finds one of them by asking at most 60 boxes")
{
  const std::vector<Bounds> in_order = grid_bounds(4096);
  std::vector<Bounds> bounds;
  bounds.reserve(in_order.size());
  for (std::size_t i = 0; i < in_order.size(); ++i)
  {
    bounds.push_back(in_order[i * 1597 % in_order.size()]); // the tree has to sort them
  }
  BoundsTree tree;
  tree.build(bounds);
  for (const Bounds& one : bounds)
  {
    const Vector3<double> place = one.box.center();
    int asked = 0, found = 0;
    each_that(
        tree,
        [&](const Eigen::AlignedBox<double, 3>& box)
        {
          ++asked;
          return box.contains(place);
        },
        [&](int body) { found += body == one.body ? 1 : 0; });
    CAPTURE(one.body, asked);
    REQUIRE((found == 1 && asked <= 60));
  }
}

TEST_CASE("a tree whose leaves are widened is asked as a list of them is, and loses none")
{
  BoxDraw draw(13);
  for (int i = 0; i < inputs(1'000, 100); ++i)
  {
    std::vector<Bounds> bounds = random_bounds(draw);
    BoundsTree tree;
    tree.build(bounds);
    for (std::size_t leaf = 0; leaf < tree.leaves().size(); leaf += 2)
    {
      const Vector3<double> low(draw.whole(12), draw.whole(12), draw.whole(12));
      const Eigen::AlignedBox<double, 3> more(low, low + Vector3<double>::Ones());
      const int body = tree.leaves()[leaf].body;
      bounds[static_cast<std::size_t>(body)].box.extend(more);
      tree.enlarge(leaf, more);
    }
    const Vector3<double> low(draw.whole(12), draw.whole(12), draw.whole(12));
    const Eigen::AlignedBox<double, 3> asked(low, low + Vector3<double>::Ones());
    const auto meets = [&](const Eigen::AlignedBox<double, 3>& box)
    { return box.intersects(asked); };
    std::vector<int> found, wanted;
    each_that(tree, meets, [&](int body) { found.push_back(body); });
    for (const Bounds& one : bounds)
    {
      if (meets(one.box))
      {
        wanted.push_back(one.body);
      }
    }
    std::sort(found.begin(), found.end());
    CAPTURE(i);
    CHECK(found == wanted);
  }
}

TEST_CASE("a grid of boxes has its 8 neighbours, less at the sides", "[case:L6]")
{
  for (const int side : {2, 8, 64})
  {
    std::vector<Bounds> bounds = grid_bounds(side * side);
    // Two rows of pairs along the sides, and two along the diagonals.
    const auto pairs =
        static_cast<std::size_t>(2 * side * (side - 1) + 2 * (side - 1) * (side - 1));
    CHECK(pairs_by_tree(bounds).size() == pairs);
    CHECK(swept_pairs(bounds).size() == pairs);
  }
}

TEST_CASE("10,000 boxes in a row along any axis have 9,999 pairs; all in one place too many")
{
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK(pairs_by_tree(row_bounds(10'000, axis)).size() == 9'999);
  }
  // 300 in one place are 44,850 pairs, more than 100 for each.
  std::vector<Bounds> heaped = row_bounds(300, 0);
  for (Bounds& one : heaped)
  {
    one.box = heaped.front().box;
  }
  CHECK_THROWS_AS(pairs_by_tree(heaped), TooManyContacts);
  heaped.resize(201);
  CHECK(pairs_by_tree(heaped).size() == 20'100);
}

TEST_CASE("pairs are put in order where they are, and others are merged in")
{
  BoxDraw draw(14);
  for (int i = 0; i < 300; ++i)
  {
    const int bodies = 1 + draw.whole(40);
    const auto drawn = [&]
    {
      std::vector<std::pair<int, int>> pairs(static_cast<std::size_t>(draw.whole(60)));
      for (auto& [a, b] : pairs)
      {
        a = draw.whole(bodies);
        b = draw.whole(bodies);
      }
      return pairs;
    };
    std::vector<std::pair<int, int>> pairs = drawn(), wanted = pairs, others = drawn();
    PairOrder().sort(pairs, static_cast<std::size_t>(bodies));
    std::sort(wanted.begin(), wanted.end());
    CHECK(pairs == wanted);
    std::sort(others.begin(), others.end());
    wanted.insert(wanted.end(), others.begin(), others.end());
    std::sort(wanted.begin(), wanted.end());
    merge_sorted(pairs, std::span(others));
    CHECK(pairs == wanted);
  }
}

TEST_CASE("of bodies that move, all that may have met are found, where one goes astray or all do")
{
  BoxDraw draw(14);
  for (const double speed : {0.5, 5.0, 500.0})
  {
    for (const int one_in : {1'000'000, 20, 2})
    {
      CAPTURE(speed, one_in);
      MetPairs met;
      for (int i = 0; i < inputs(200, 20); ++i)
      {
        met.ask(draw, speed, one_in);
      }
      CHECK(met.missed == 0);
      CHECK(met.twice == 0);
      CHECK(met.lost == 0);
      // No body leaves its bounds that moves as predicted; both ways of asking are taken.
      const bool as_predicted = speed < 1 && one_in > 20;
      const double fraction = double(met.strays_asked) / double(met.bodies_asked);
      CHECK((met.strays_asked == 0) == as_predicted);
      CHECK((fraction > 0.3) == (speed > 100 || one_in == 2));
    }
  }
}
