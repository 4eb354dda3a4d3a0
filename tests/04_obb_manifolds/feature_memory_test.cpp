/// \file
/// What holds for boxes that remember the frame before, formula O17, and what fails without.

#include "04_obb_manifolds/box_oracles/trial/resting_steadiness.hpp"
#include "04_obb_manifolds/contact_reduction/steady_reduction.hpp"
#include "04_obb_manifolds/feature_memory/feature_memory.hpp"
#include "04_obb_manifolds/feature_memory/trial/feature_memory_pitfalls.hpp"
#include "04_obb_manifolds/feature_memory/trial/feature_memory_scenes.hpp"
#include "04_obb_manifolds/feature_memory/trial/feature_memory_verdicts.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <array>
#include <set>
#include <string>

using namespace cookbook;

namespace
{

const Obb<double> cube = upright({0, 0, 0}, {0.5, 0.5, 0.5});

/// The cube on the cube, sunk by a depth and tilted about z, deeper on the right for angles < 0.
Obb<double> on_top(double depth, double angle)
{
  const double radius = 0.5 * (std::cos(angle) + std::abs(std::sin(angle)));
  return {{0, 0.5 + radius - depth, 0}, turned(angle, {0, 0, 1}), {0.5, 0.5, 0.5}};
}

using Memory = ContactMemory<double, int>;

/// A frame of which is known on which axis it was.
Memory frame_on(int axis, const Obb<double>& a, const Obb<double>& b)
{
  return {box_box_on<RowOf<double, 3>>(a, b, axis, overlap_on(a, b, axis).value()), {}};
}

constexpr int a1 = 1, b1 = 4;

} // namespace

// [O17]
TEST_CASE("on the axis that box_box() takes, box_box_on() is the same", "[O17]")
{
  for (const char* const name : {"random", "resting"})
  {
    for (const BoxPair<float>& pair : box_workload(name, 500).pairs)
    {
      const auto [a, b] = pair_in<double>(pair);
      const auto right = box_box(a, b);
      if (!right)
      {
        continue;
      }
      const int axis = axis_of(right);
      const auto same = box_box_on<RowOf<double, 3>>(a, b, axis, overlap_on(a, b, axis).value());
      // Both are computed from numbers of size 3 at most, each rounded.
      CHECK(difference(right, same, 1) <= 1e-13);
      REQUIRE(right->points.size() == same->points.size());
      for (std::size_t i = 0; i < same->points.size(); ++i)
      {
        CHECK(right->points[i].feature == same->points[i].feature);
      }
    }
  }
}

TEST_CASE("features name the axis, and no two points of a manifold share one", "[O17]")
{
  const BoxWorkload resting = box_workload("resting", 500);
  for (const BoxPair<float>& pair : resting.pairs)
  {
    const auto [a, b] = pair_in<double>(pair);
    const int least = separating_axes(a, b)->axis;
    for (const int axis : {least, axis_of(box_box(a, b)), 6, 14})
    {
      const auto manifold =
          box_box_on<RowOf<double, 3>>(a, b, axis, overlap_on(a, b, axis).value());
      std::set<std::uint32_t> features;
      for (const ContactPoint<double>& point : manifold->points)
      {
        CHECK(axis_of_feature(point.feature) == axis);
        features.insert(point.feature);
      }
      CHECK(features.size() == manifold->points.size());
    }
  }
}

TEST_CASE(
    "resting boxes, nudged by 1e-6 of their size: 99.9 % of the features are there again, within "
    "1e-3 of where they were",
    "[O17]")
{
  BoxDraw draw(6);
  int points = 0, again = 0;
  for (const BoxPair<float>& pair : box_workload("resting", 2000).pairs)
  {
    const auto [a, b] = pair_in<double>(pair);
    const double size = pair_size(a, b);
    const Memory before{box_box(a, b), {}};
    const Memory now = next_frame(before, a, nudged(b, size, 1e-6, draw));
    REQUIRE((before.manifold && now.manifold));
    for (const ContactPoint<double>& point : now.manifold->points)
    {
      ++points;
      for (const ContactPoint<double>& other : before.manifold->points)
      {
        if (point.feature == other.feature)
        {
          ++again;
          CHECK((point.position - other.position).norm() <= 1e-3 * size);
        }
      }
    }
  }
  CHECK(again >= 0.999 * points);
  CHECK(points > 8000);
}
// [O17]

// [margin]
TEST_CASE("the margin is 0.5 mm and a tenth of the depth for cubes of 0.1 m", "[O17]")
{
  const Obb<double> small = upright({0, 0, 0}, {0.05, 0.05, 0.05});
  CHECK(axis_margin(cube, small, 0.0) == Catch::Approx(5e-4).epsilon(1e-14));
  CHECK(axis_margin(small, cube, 0.02) == Catch::Approx(2.5e-3).epsilon(1e-14));
}

TEST_CASE("an old face is kept up to the margin and not beyond", "[O17]")
{
  // Tilted about z, the overlap along A's y is the depth d; along B's y it is another: c = 1 − d
  // and r reach, centres apart by h = 0.5 + r − d along y, so d_B = 0.5 + r − h cos φ.
  const auto overlap_b = [](double depth, double angle)
  {
    const double radius = 0.5 * (std::cos(angle) + std::abs(std::sin(angle)));
    return 0.5 + radius - (0.5 + radius - depth) * std::cos(angle);
  };
  int kept = 0, left = 0;
  for (double angle = 0.001; angle < 0.3; angle += 0.01)
  {
    const double depth = 0.01;
    const Obb<double> b = on_top(depth, angle);
    const Memory now = next_frame(frame_on(b1, cube, b), cube, b);
    const bool within = overlap_b(depth, angle) <= depth + 0.005 + 0.1 * depth;
    const int axis = axis_of(now.manifold);
    CHECK(axis == (within ? b1 : a1));
    (within ? kept : left) += 1;
    if (within)
    {
      CHECK(now.manifold->depth == Catch::Approx(overlap_b(depth, angle)).margin(1e-14));
    }
  }
  CHECK((kept > 5 && left > 5));
}

TEST_CASE("an edge is not kept where a face has come to lie on a face", "[O17][case:G9]")
{
  const Obb<double> b = on_top(0.001, 0.001);
  for (const int edge : {6 + 0, 6 + 2, 6 + 6})
  {
    const Memory now = next_frame(frame_on(edge, cube, b), cube, b);
    CHECK(axis_of(now.manifold) < 6);
    CHECK(now.manifold->points.size() >= 2);
  }
}

TEST_CASE("edges give way to a face that overlaps by half the margin more, and no further", "[O17]")
{
  // A beam tilts on its edge, about the middle of it: its lower end goes down by 0.8 sin φ.
  int of_face = 0, of_edges = 0;
  for (double angle = 0.0001; angle < 0.02; angle += 0.0002)
  {
    const Matrix3<double> askew = turned(0.4, {0, 1, 0}) * turned(angle, {1, 0, 0});
    const double up = 0.2 * (std::cos(0.6) + std::sin(0.6));
    const Obb<double> beam{{0, 0.499 + up, 0}, askew * turned(0.6, {0, 0, 1}), {0.2, 0.2, 0.8}};
    const double face_depth = 0.001 - up + up * std::cos(angle) + 0.8 * std::sin(angle);
    const double depth = separating_axes(cube, beam)->depth;
    const double margin = 0.01 * 0.4 + 0.1 * depth;
    for (const int before : {6, 8, 12, 14})
    {
      const int axis = axis_of(next_frame(frame_on(before, cube, beam), cube, beam).manifold);
      const bool close_by = face_depth <= depth + margin / 2;
      CHECK((close_by ? axis == a1 : axis >= 6));
      (close_by ? of_face : of_edges) += 1;
    }
  }
  CHECK((of_face > 50 && of_edges > 50));
}

TEST_CASE("boxes that separate forget, and begin anew without a memory", "[O17]")
{
  const Obb<double> close_by = on_top(0.001, 0), distant = on_top(-0.1, 0);
  Memory memory = next_frame(Memory{}, cube, close_by);
  REQUIRE(memory.manifold);
  CHECK(memory.manifold->points.size() == 4);
  CHECK(memory.warm == PerPoint<int>{});
  memory.warm.fill(7);
  memory = next_frame(memory, cube, close_by);
  CHECK(std::count(memory.warm.begin(), memory.warm.end(), 7) == 4);
  memory = next_frame(memory, cube, distant);
  CHECK_FALSE(memory.manifold);
  CHECK(next_frame(memory, cube, close_by).warm == PerPoint<int>{});
}
// [margin]

// [carried]
TEST_CASE("data go from a feature to the same feature, whatever the order", "[O17]")
{
  const auto with = [](std::initializer_list<std::uint32_t> features)
  {
    Manifold<double> manifold{{0, 1, 0}, 0, {}};
    for (const std::uint32_t feature : features)
    {
      manifold.points.push_back({{0, 0, 0}, 0, feature});
    }
    return manifold;
  };
  const PerPoint<int> warm{10, 20, 30};
  const Manifold<double> before = with({1, 2, 3}), now = with({3, 4, 1});
  CHECK(carried_by_id(before, warm, now) == PerPoint<int>{30, 0, 10});
  CHECK(carried_by_index(before, warm, now) == PerPoint<int>{10, 20, 30});
}
// [carried]

// [flips]
TEST_CASE(
    "a stack that jitters for 1,000 frames: the least axis flips hundreds of times, with memory at "
    "most once",
    "[case:G10]")
{
  for (const double angle : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8})
  {
    const Frames frames = jittered_stack(angle);
    CHECK(flips(remembered_axes(frames)) <= 1);
    if (angle <= 1e-4)
    {
      CHECK(flips(least_axes(frames)) > 100);
      CHECK(flips(forgetful_axes(frames)) > 18);
    }
  }
}

TEST_CASE("the same in float", "[case:G10]")
{
  for (const double angle : {1e-3, 1e-6})
  {
    ContactMemory<float, int> memory{};
    const auto remembered = axes_over(
        jittered_stack(angle),
        [&memory](const Obb<double>& a, const Obb<double>& b)
        {
          memory = next_frame(memory, to_float(a), to_float(b));
          return axis_of(memory.manifold);
        });
    CHECK(remembered[0] >= 0);
    CHECK(flips(remembered) <= 1);
  }
}
// [flips]

// [beam]
TEST_CASE(
    "a beam that jitters on its edge: the one point of box_box() jumps from end to end in hundreds "
    "of frames, with memory two stay for good",
    "[case:G20]")
{
  using Place = std::optional<Vector3<double>>;
  const Frames frames = jittered_beam();
  const Persistence without = persistence(frames, false, carried_by_id<double, Place>);
  CHECK(without.points == 999);
  CHECK(without.wrong > 400);
  const Persistence remembered = persistence(frames, true, carried_by_id<double, Place>);
  CHECK(remembered.points == 2 * 999);
  CHECK(remembered.right == 2 * 998); // in the first frame there was one
  CHECK(remembered.wrong == 0);
}
// [beam]

// [persistence]
TEST_CASE(
    "a cube that slides for 5 s: with memory 95 % of the ids persist and none is wrong, matching "
    "by index fails",
    "[case:G20]")
{
  using Place = std::optional<Vector3<double>>;
  const Frames frames = sliding_cube();
  const Persistence by_index = persistence(frames, false, carried_by_index<double, Place>);
  CHECK(by_index.right < 0.9 * by_index.points);
  CHECK(by_index.wrong > 0.1 * by_index.points);
  const Persistence by_id = persistence(frames, false, carried_by_id<double, Place>);
  CHECK(by_id.right < 0.9 * by_id.points);
  CHECK(by_id.wrong == 0);
  const Persistence remembered_index = persistence(frames, true, carried_by_index<double, Place>);
  CHECK(remembered_index.wrong > 0);
  const Persistence remembered = persistence(frames, true, carried_by_id<double, Place>);
  CHECK(remembered.right >= 0.95 * remembered.points);
  CHECK(remembered.wrong == 0);
}
// [persistence]

// [frame_verdicts]
TEST_CASE(
    "from frame to frame, only next_frame() with features keeps axis and points",
    "[case:G10][case:G20]")
{
  const std::vector<std::string> with_memory{"next_frame", "next_frame, by index"};
  const std::vector<std::string> no_axis{"gjk_epa"}, no_points{"separating_axes"};
  check_verdicts(
      frame_verdicts(), names_of(frame_methods()),
      {{"G10", with_memory, no_axis},
       {"the same, tilted by 1e-8", with_memory, no_axis},
       {"the same, tilted by 1e-2",
        {"separating_axes", "edge_clipping", "face_clipping", "box_box, by index", "box_box",
         "next_frame, by index", "next_frame"},
        no_axis},
       {"G20", {"next_frame"}, no_points},
       {"a beam lies on its edge across a cube and jitters: its points",
        {"edge_clipping", "next_frame, by index", "next_frame"},
        no_points}});
}

TEST_CASE("an axis may change once, 95 % of the points must be known and none mistaken", "[O17]")
{
  const auto on_axes = [](const std::vector<int>& axes)
  {
    const FrameMethod method{"", [=](const Frames&) { return axes; }, {}};
    return verdict_on_axes(method, {}).holds;
  };
  CHECK(on_axes({1, 1, 4, 4}));
  CHECK_FALSE(on_axes({1, 4, 1}));
  const auto on_points = [](int right, int wrong)
  {
    Persistence all;
    all.points = 100;
    all.right = right;
    all.wrong = wrong;
    const FrameMethod method{"", {}, [=](const Frames&) { return all; }};
    return verdict_on_points(method, {}).holds;
  };
  CHECK(on_points(95, 0));
  CHECK_FALSE(on_points(94, 0));
  CHECK_FALSE(on_points(99, 1));
}

TEST_CASE("a point is lost without its feature, mistaken a centimetre away, else known", "[O17]")
{
  const BoxPair<double> pair{cube, on_top(0.001, 0)};
  const Frames frames{pair, pair, pair};
  int frame = 0;
  const auto answer = [&](const Obb<double>&, const Obb<double>&)
  {
    Manifold<double> manifold{{0, 1, 0}, 0, {}};
    manifold.points.push_back({{0, 0, 0}, 0, 7});                         // known twice
    manifold.points.push_back({{0.02 * frame, 0, 0}, 0, 8});              // mistaken twice
    manifold.points.push_back({{1, 0, 0}, 0, std::uint32_t(20 + frame)}); // lost twice
    ++frame;
    return std::optional(manifold);
  };
  const Persistence all = known_by_feature(frames, answer);
  CHECK(all.points == 6);
  CHECK(all.right == 2);
  CHECK(all.wrong == 2);
}
// [frame_verdicts]

// [steadily_reduced]
TEST_CASE("four kept points stay while all are there, span 3/4 and are as deep to 1/100", "[O17]")
{
  using Few = Manifold<double, most_kept>;
  const auto features = [](const Few& few)
  {
    std::set<std::uint32_t> found;
    for (const ContactPoint<double>& point : few.points)
    {
      found.insert(point.feature);
    }
    return found;
  };
  const std::set<std::uint32_t> even{0, 2, 4, 6}, odd{1, 3, 5, 7};
  const Manifold<double> octagon = turned_squares(std::atan(1.0), 0);
  Manifold<double> leaning = octagon;
  leaning.points[1].depth += 1e-4;
  const Few before = reduced(leaning);
  REQUIRE(features(before) == odd);
  REQUIRE(features(reduced(octagon)) == even);
  CHECK(features(steadily_reduced(octagon, before)) == odd);
  CHECK(features(steadily_reduced(octagon, Few{})) == even);

  // The new four span 8 − 4 √2, so the spread is the root of twice that, and 1/100 of it 0.0216.
  for (const auto& [deeper, kept] : {std::pair(0.021, odd), std::pair(0.022, even)})
  {
    Manifold<double> other = octagon;
    other.points[0].depth += deeper;
    CHECK(features(steadily_reduced(other, before)) == kept);
  }
  Manifold<double> one_gone = octagon;
  one_gone.points[3].feature = 99;
  CHECK(features(steadily_reduced(one_gone, before)) == even);
  for (ContactPoint<double>& point : one_gone.points)
  {
    point.position = {double(point.feature), 0, 0};
  }
  CHECK(steadily_reduced(one_gone, before).points.size() == 4);
  CHECK(steadily_reduced(one_gone, Few{}).points.size() == 4);
}

TEST_CASE("kept points of 12.2 of 16 m² stay, of 11.8 do not, in any order", "[O17]")
{
  Manifold<double, most_kept> three{{0, 1, 0}, 1, {}};
  for (const Vector3<double>& place : {Vector3<double>(0, 0, 0), {1, 0, 5}, {7, 0, 1}})
  {
    three.points.push_back({place, 1, 0});
  }
  CHECK(doubled_spread(three) == 0);
  for (const auto& [y, stays] : {std::pair(2.1, true), std::pair(1.9, false)})
  {
    Manifold<double> many{{0, 1, 0}, 1, {}};
    const Vector3<double> places[] = {{0, 0, 0}, {4, 0, 4}, {4, 0, 0}, {0, 0, 4}, {4, 0, y}};
    for (const Vector3<double>& place : places)
    {
      many.points.push_back({place, 1, std::uint32_t(many.points.size())});
    }
    Manifold<double, most_kept> before{{0, 1, 0}, 1, {}};
    for (const std::size_t kept : {4u, 0u, 3u, 2u})
    {
      before.points.push_back(many.points[kept]);
    }
    CHECK(doubled_spread(before) == Catch::Approx(4 * (y + 4)).margin(1e-14));
    const auto now = steadily_reduced(many, before);
    CHECK((now.points[3].feature == 4) == stays);
    std::swap(before.points[1], before.points[2]);
    CHECK(doubled_spread(before) == Catch::Approx(4 * (y + 4)).margin(1e-14));
    std::swap(before.points[0], before.points[1]);
    CHECK(doubled_spread(before) == Catch::Approx(4 * (y + 4)).margin(1e-14));
  }
}

TEST_CASE("boxes that rest, nudged by 1e-4: four points of the frame before do not jump", "[O17]")
{
  BoxDraw draw(5);
  std::vector<double> fresh_jumps, jumps, areas;
  for (const BoxPair<float>& pair : box_workload("resting", 2000).pairs)
  {
    const auto [a, b] = pair_in<double>(pair);
    const double size = pair_size(a, b);
    const Memory before{box_box(a, b), {}};
    const Obb<double> next = nudged(b, size, 1e-4, draw);
    const Memory now = next_frame(before, a, next);
    REQUIRE((before.manifold && now.manifold));
    const auto four = reduced(*before.manifold), same = steadily_reduced(*now.manifold, four);
    const auto jump = [&](const auto& manifold)
    { return (centroid(manifold) - centroid(four)).norm() / size; };
    fresh_jumps.push_back(jump(reduced(*box_box(a, next))));
    jumps.push_back(jump(same));
    areas.push_back(area_fraction(a, next, same));
  }
  CHECK(measure::percentile(fresh_jumps, 99) > 0.1);
  CHECK(measure::percentile(jumps, 99) < 1e-3);
  CHECK(measure::percentile(areas, 1) > 0.7);
}
// [steadily_reduced]

// [roaming]
TEST_CASE(
    "equal cubes, flush but for jitter: features persist while their points roam by centimetres",
    "[case:G10]")
{
  const Persistence all = persistence(
      jittered_stack(1e-3), true, carried_by_id<double, std::optional<Vector3<double>>>);
  CHECK(all.right + all.wrong == all.points);
  CHECK(all.wrong > 0.2 * all.points);
}

TEST_CASE(
    "equal cubes, flush to 1e-8: the axis stays, but in most frames a corner has another name",
    "[case:G10]")
{
  const Persistence all = persistence(
      jittered_stack(1e-8), true, carried_by_id<double, std::optional<Vector3<double>>>);
  CHECK(all.right + all.wrong < 0.9 * all.points);
}
// [roaming]
