/// \file
/// Colours of contacts: none twice at a body, the first that is free, few, and one of its own for
/// what finds none.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "06_world/contact_graph/trial/contact_graph_scenes.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <set>

namespace
{

using namespace cookbook;

using Pairs = std::vector<std::pair<int, int>>;

/// The colours of pairs of bodies of which those below `fixed` cannot move.
std::vector<int> colors(const Pairs& pairs, int bodies, int fixed = 0)
{
  ContactGraph graph;
  graph.color(static_cast<std::size_t>(bodies), pairs, [fixed](int i) { return i >= fixed; });
  const auto each = graph.color_of_each();
  return {each.begin(), each.end()};
}

/// Random pairs of different bodies.
Pairs drawn_pairs(BoxDraw& draw, int bodies, int count)
{
  Pairs pairs;
  for (int i = 0; i < count; ++i)
  {
    const int a = draw.whole(bodies), step = 1 + draw.whole(bodies - 1);
    pairs.emplace_back(std::minmax(a, (a + step) % bodies));
  }
  return pairs;
}

} // namespace

// [no_shared_body]
TEST_CASE("of 2,000 random graphs no two contacts of a colour share a body that moves")
{
  BoxDraw draw(1);
  for (int i = 0; i < inputs(2'000, 200); ++i)
  {
    const int bodies = 10 + draw.whole(30), fixed = draw.whole(bodies);
    const int count = draw.whole(3 * bodies);
    const Pairs pairs = drawn_pairs(draw, bodies, count);
    const std::vector<int> color = colors(pairs, bodies, fixed);
    REQUIRE(color.size() == pairs.size());
    std::set<std::pair<int, int>> seen; // body and colour
    int most = 0;
    for (std::size_t j = 0; j < pairs.size(); ++j)
    {
      const auto [a, b] = pairs[j];
      // Each lower colour is that of an earlier contact of one of the two.
      for (int lower = 0; lower < color[j]; ++lower)
      {
        const bool is_taken = seen.contains({a, lower}) || seen.contains({b, lower});
        CHECK(is_taken);
      }
      for (const int body : {a, b})
      {
        const bool is_new = body < fixed || seen.emplace(body, color[j]).second;
        CHECK(is_new);
      }
      most = std::max(most, color[j]);
    }
    CHECK(most < shared_colors);
  }
}
// [no_shared_body]

// [known_graphs]
TEST_CASE("a chain takes two colours, a ring of five three, a star as many as it has rays")
{
  CHECK(colors({{0, 1}, {1, 2}, {2, 3}, {3, 4}}, 5) == std::vector{0, 1, 0, 1});
  CHECK(colors({{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}}, 5) == std::vector{0, 1, 0, 1, 2});
  CHECK(colors({{0, 1}, {0, 2}, {0, 3}, {0, 4}}, 5) == std::vector{0, 1, 2, 3});
  // Around a body that cannot move all are side by side.
  CHECK(colors({{0, 1}, {0, 2}, {0, 3}, {0, 4}}, 5, 1) == std::vector{0, 0, 0, 0});
  CHECK(colors({}, 5).empty());
}

TEST_CASE("a contact takes the first colour that neither of its bodies has")
{
  CHECK(colors({{0, 1}, {2, 3}, {1, 2}, {3, 4}, {0, 4}}, 5) == std::vector{0, 0, 1, 1, 2});
}
// [known_graphs]

// [own_color]
TEST_CASE("of a hundred contacts at one body 64 share colours, and 36 have one of their own")
{
  Pairs star;
  for (int i = 1; i <= 100; ++i)
  {
    star.emplace_back(0, i);
    star.emplace_back(i, 100 + i);
  }
  const std::vector<int> color = colors(star, 201);
  ContactGraph graph;
  graph.color(201, star, [](int) { return true; });
  CHECK(graph.colors() == 100);
  for (std::size_t i = 0; i < star.size(); i += 2)
  {
    CHECK(color[i] == static_cast<int>(i / 2));
    CHECK(color[i + 1] <= 1); // what hangs on a ray is free to share
  }
  for (int one = shared_colors; one < graph.colors(); ++one)
  {
    CHECK(graph[one].size() == 1);
  }
}
// [own_color]

TEST_CASE("greedy colours: as many as contacts of the busiest body, up to twice as many less one")
{
  for (const char* const name : {"tower_20", "pyramid", "wall", "floor_50", "domino"})
  {
    const TouchingBodies touching(named_scene(name));
    CAPTURE(name);
    CHECK(touching.colored().colors() <= 2 * touching.most_at_one() - 1);
    CHECK(touching.colored().colors() >= touching.most_at_one());
  }
}

TEST_CASE("a flat crowd takes one colour")
{
  CHECK(TouchingBodies(named_scene("floor_50")).colored().colors() == 1);
}

TEST_CASE("a graph that is coloured again forgets what it was")
{
  ContactGraph graph;
  const auto all = [](int) { return true; };
  graph.color(4, Pairs{{0, 1}, {1, 2}, {1, 3}}, all);
  CHECK(graph.colors() == 3);
  graph.color(2, Pairs{{0, 1}}, all);
  CHECK(graph.colors() == 1);
  CHECK(graph.color_of_each().size() == 1);
  REQUIRE(graph[0].size() == 1);
  CHECK(graph[0][0] == 0);
  graph.color(4, Pairs{}, all);
  CHECK(graph.colors() == 0);
}

TEST_CASE("groups of four: five contacts of a colour take two, and fill five of eight places")
{
  ContactGraph graph;
  graph.color(10, Pairs{{0, 1}, {2, 3}, {4, 5}, {6, 7}, {8, 9}}, [](int) { return true; });
  CHECK(side_by_side(graph, 4).groups == 2);
  CHECK(side_by_side(graph, 4).used == 0.625);
  CHECK(side_by_side(graph, 1).used == 1);
}
