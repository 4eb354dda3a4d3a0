/// \file
/// That the ten workloads are what they say, that the truth is true, and that the measures of a
/// method give the right numbers for manifolds made by hand.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "03_sphere_manifolds/manifold/trial/pairs_file.hpp"
#include "04_obb_manifolds/box_oracles/trial/resting_steadiness.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"

#include <bit>
#include <set>
#include <sstream>

using namespace cookbook;

namespace
{

constexpr std::size_t some = 2000;

/// A few roundings of float numbers of size two.
constexpr double float_rounding = 1e-6;
/// A few roundings of double numbers of size two.
constexpr double rounding = 2e-15;

Obb<double> upright(const Vector3<double>& center, const Vector3<double>& half_extents)
{
  return {center, Matrix3<double>::Identity(), half_extents};
}

const Obb<double> cube = upright({0, 0, 0}, {1, 1, 1});
const Obb<double> above = upright({0, 1.9, 0}, {1, 1, 1});

/// Goes through a workload's first pairs as `check(a, b, size)`, in double.
template <class Check>
void each_pair(const std::string& name, Check check)
{
  for (const BoxPair<float>& pair : box_workload(name, some).pairs)
  {
    const Obb<double> a = orthonormal(pair.first), b = orthonormal(pair.second);
    check(a, b, pair_size(a, b));
  }
}

double least_of(const Obb<double>& a, const Obb<double>& b)
{
  return true_depth(true_least_overlap(a, b));
}

/// The angle [rad] between the two most parallel axes of two boxes.
double least_angle(const Obb<double>& a, const Obb<double>& b)
{
  double least = 2;
  for (int i = 0; i < 9; ++i)
  {
    least = std::min(least, a.axes.col(i / 3).cross(b.axes.col(i % 3)).norm());
  }
  return least;
}

double fraction_overlapping(const std::string& name)
{
  double overlapping = 0;
  each_pair(
      name, [&](const Obb<double>& a, const Obb<double>& b, double)
      { overlapping += least_of(a, b) >= 0 ? 1 : 0; });
  return overlapping / some;
}

} // namespace

// [workloads]
TEST_CASE("ten workloads of proper boxes; a longer one begins with a shorter one", "[workloads]")
{
  const std::vector<std::string> names{"random", "near-parallel", "resting",     "edge-edge",
                                       "deep",   "thin plates",   "millimetres", "kilometres",
                                       "far",    "degenerate"};
  CHECK(box_workload_names() == names);
  for (const std::string& name : names)
  {
    CAPTURE(name);
    const BoxWorkload more = box_workload(name, some), fewer = box_workload(name, 10);
    CHECK(more.name == name);
    REQUIRE(more.pairs.size() == some);
    REQUIRE(fewer.pairs.size() == 10);
    for (std::size_t i = 0; i < some; ++i)
    {
      const auto& [a, b] = more.pairs[i];
      CHECK_NOTHROW((checked(a), checked(b)));
      CHECK(rotation_error(a.axes) <= 4 * std::numeric_limits<float>::epsilon());
      CHECK(rotation_error(b.axes) <= 4 * std::numeric_limits<float>::epsilon());
      const bool same = i >= 10 || (fewer.pairs[i].first.center == a.center &&
                                    fewer.pairs[i].second.axes == b.axes &&
                                    fewer.pairs[i].second.half_extents == b.half_extents);
      CHECK(same);
    }
  }
  CHECK_THROWS_AS(box_workload("heavy", 1), std::out_of_range);
}

TEST_CASE("random boxes: more than half overlap, and less than two thirds", "[workloads]")
{
  for (const char* const name : {"random", "near-parallel", "millimetres", "kilometres", "far"})
  {
    CAPTURE(name);
    CHECK(fraction_overlapping(name) > 0.5);
    CHECK(fraction_overlapping(name) < 0.67);
  }
  for (const char* const name : {"resting", "edge-edge", "deep", "thin plates"})
  {
    CAPTURE(name);
    CHECK(fraction_overlapping(name) == 1);
  }
}

TEST_CASE(
    "nearly parallel: all tilts from 1.6e-2 rad down to below what float keeps", "[workloads]")
{
  int small = 0, large = 0;
  each_pair(
      "near-parallel",
      [&](const Obb<double>& a, const Obb<double>& b, double)
      {
        CHECK(least_angle(a, b) <= 0x1p-6);
        CHECK(has_parallel_faces(a, b));
        small += least_angle(a, b) < 1e-7 ? 1 : 0;
        large += least_angle(a, b) > 1e-3 ? 1 : 0;
      });
  CHECK(small > int(some) / 20);
  CHECK(large > int(some) / 10);
}

TEST_CASE(
    "resting boxes are sunk by .1 to 1 % and tilted by 1e-4 at most, plates by .1 to .5 %",
    "[workloads]")
{
  for (const bool thin : {false, true})
  {
    each_pair(
        thin ? "thin plates" : "resting",
        [&](const Obb<double>& a, const Obb<double>& b, double size)
        {
          // Along the face of either the overlap is the drawn one, but for tilt times reach.
          const double depth = least_of(a, b) / size;
          CHECK(depth >= 0.001 - 4e-4);
          CHECK(depth <= (thin ? 0.005 : 0.01) + float_rounding);
          CHECK(least_angle(a, b) <= 1e-4 + float_rounding);
          const double shortest = std::min(a.half_extents.minCoeff(), b.half_extents.minCoeff());
          CHECK((thin || size / shortest <= 3));
          for (const Obb<double>& box : {a, b})
          {
            const double flat = box.half_extents.maxCoeff() / box.half_extents.minCoeff();
            CHECK((!thin || (flat >= 50 - 1e-4 && flat <= 100 + 1e-4)));
          }
        });
  }
}

TEST_CASE("edge on edge: a pair of edges decides, sunk by .1 to 1 %", "[workloads]")
{
  each_pair(
      "edge-edge",
      [&](const Obb<double>& a, const Obb<double>& b, double size)
      {
        CHECK(axis_kind(separating_axes(a, b)->axis) == AxisKind::edges);
        CHECK(least_of(a, b) / size >= 0.001 - float_rounding);
        CHECK(least_of(a, b) / size <= 0.01 + float_rounding);
      });
}

TEST_CASE("deep, far, millimetres and kilometres are what they are called", "[workloads]")
{
  each_pair(
      "deep", [&](const Obb<double>& a, const Obb<double>& b, double)
      { CHECK((b.center - a.center).norm() <= 0.1 * std::sqrt(3.0) + float_rounding); });
  each_pair(
      "far", [&](const Obb<double>& a, const Obb<double>& b, double)
      { CHECK((a.center.norm() > 0.9999e5 && b.center.norm() < 1.0001e5)); });
  const BoxWorkload metres = box_workload("random", some);
  for (const double scale : {1e-3, 1e3})
  {
    const BoxWorkload other = box_workload(scale < 1 ? "millimetres" : "kilometres", some);
    for (std::size_t i = 0; i < some; ++i)
    {
      const Obb<double> a = box_in<double>(metres.pairs[i].first);
      const Obb<double> b = box_in<double>(other.pairs[i].first);
      CHECK(a.axes == b.axes);
      CHECK((scale * a.center - b.center).norm() <= scale * float_rounding);
      CHECK((scale * a.half_extents - b.half_extents).norm() <= scale * float_rounding);
    }
  }
}

TEST_CASE("degenerate: pairs in one place, pairs that touch exactly, pairs inside", "[workloads]")
{
  int same = 0, touching = 0, inside = 0, needles = 0;
  each_pair(
      "degenerate",
      [&](const Obb<double>& a, const Obb<double>& b, double size)
      {
        same += a.center == b.center ? 1 : 0;
        touching += least_of(a, b) == 0 ? 1 : 0;
        const double shortest = std::min(a.half_extents.minCoeff(), b.half_extents.minCoeff());
        needles += shortest < size / 50 ? 1 : 0;
        bool all = true;
        for (const double x : {-1.0, 1.0})
        {
          const Vector3<double> corner = b.center + b.axes * (x * b.half_extents);
          all = all && distance_to_box(a, corner) == 0;
        }
        inside += all && a.center != b.center ? 1 : 0;
      });
  CHECK(same > int(some) / 8);
  CHECK(touching > int(some) / 8);
  CHECK(inside > int(some) / 20);
  CHECK(needles > int(some) / 10);
}

TEST_CASE("every compiler draws the same bits", "[workloads]")
{
  // FNV-1a over all numbers of the first thousand pairs of all workloads.
  std::uint64_t sum = 0xcbf29ce484222325;
  const auto add = [&sum](const auto& numbers)
  {
    for (const float x : numbers.reshaped())
    {
      sum = (sum ^ std::bit_cast<std::uint32_t>(x)) * 0x100000001b3;
    }
  };
  for (const std::string& name : box_workload_names())
  {
    for (const auto& [a, b] : box_workload(name, 1000).pairs)
    {
      add(a.center), add(a.axes), add(a.half_extents);
      add(b.center), add(b.axes), add(b.half_extents);
    }
  }
  CHECK(sum == 0x6b61c14286246b6c);
}

TEST_CASE("the axes of a box can be labelled in 24 ways, and all are the same box", "[workloads]")
{
  const Obb<double> box{{1, 2, 3}, rational_rotation<double>(1, 2, 3, 4), {1, 2, 5}};
  std::set<std::vector<double>> labels;
  for (int way = 0; way < 24; ++way)
  {
    const Obb<double> other = relabelled(box, way);
    CHECK(rotation_error(other.axes) <= rounding);
    CHECK(other.center == box.center);
    const Matrix3<double> turn = box.axes.transpose() * other.axes;
    const Vector3<double> moved = turn * other.half_extents;
    CHECK((moved.cwiseAbs() - box.half_extents).norm() <= 10 * rounding);
    const Matrix3<double> rounded = turn.array().round();
    CHECK((turn - rounded).norm() <= 10 * rounding);
    CHECK(rounded.cwiseAbs().sum() == 3);
    labels.insert({rounded.data(), rounded.data() + 9});
  }
  CHECK(labels.size() == 24);
}

TEST_CASE("a workload as CSV reads back as the same boxes to two roundings of float", "[workloads]")
{
  const std::vector<BoxPair<float>> pairs = box_workload("random", 50).pairs;
  std::istringstream text(box_pairs_csv(pairs));
  const std::vector<CsvRow> rows = read_csv(text, "pairs", box_pairs_header);
  REQUIRE(rows.size() == 50);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const PairsRow row{"pairs", box_pairs_header, rows[i]};
    const Obb<float> a = obb_at<float>(row, 0), b = obb_at<float>(row, 10);
    CHECK(a.center == pairs[i].first.center);
    CHECK(b.half_extents == pairs[i].second.half_extents);
    const float two_roundings = 2 * std::numeric_limits<float>::epsilon();
    CHECK((a.axes - pairs[i].first.axes).cwiseAbs().maxCoeff() <= two_roundings);
    CHECK((b.axes - pairs[i].second.axes).cwiseAbs().maxCoeff() <= two_roundings);
  }
}
// [workloads]

// [truth]
TEST_CASE(
    "the truth in double is that in fractions to a few roundings, on every workload", "[O18][long]")
{
  for (const BoxRecipe& recipe : box_workload_recipes())
  {
    CAPTURE(recipe.name);
    for (const auto& [a, b] : box_workload(recipe, 40).pairs)
    {
      const Obb<double> wide_a = box_in<double>(a), wide_b = box_in<double>(b);
      const double depth = least_of(wide_a, wide_b);
      const auto exact = true_least_overlap(box_in<Rational>(a), box_in<Rational>(b));
      // Reference has no fractions to offer, but a hundred digits of the root.
      const Reference root = sqrt(Reference(abs(exact.signed_square)));
      const double truth = static_cast<double>(exact.signed_square < 0 ? Reference(-root) : root);
      // Nearly parallel edges have short products: the direction loses digits, not the overlap.
      const double size = pair_size(wide_a, wide_b) + wide_a.center.norm() * 1e-3;
      CHECK(std::abs(depth - truth) <= 1e-13 * size);
    }
  }
}

TEST_CASE("the overlap along a normal is what B must move, and 3.9 the wrong way round", "[O6]")
{
  CHECK(overlap_along<double>(cube, above, {0, 1, 0}) == Catch::Approx(0.1).margin(rounding));
  CHECK(overlap_along<double>(cube, above, {0, -1, 0}) == Catch::Approx(3.9).margin(rounding));
  // Both reach 0.6 + 0.8 along (3, 4, 0)/5, and the centres are 0.8 · 1.9 apart.
  CHECK(
      overlap_along<double>(cube, above, {0.6, 0.8, 0}) ==
      Catch::Approx(2.8 - 0.8 * 1.9).margin(rounding));
  CHECK(least_of(cube, above) == Catch::Approx(0.1).margin(rounding));
  CHECK(least_of(cube, upright({0, 2.5, 0}, {1, 1, 1})) == Catch::Approx(-0.5).margin(rounding));
}

TEST_CASE("faces 0.9° apart are parallel, 1.1° apart they are not", "[O9]")
{
  const double degree = std::atan(1.0) / 45;
  const Vector3<double> about(1, 1, 1);
  for (const double angle : {0.9, 1.1})
  {
    // About (1, 1, 1) all axes turn by the same angle, √(2/3) of that of the turn.
    const double turn = angle * degree * std::sqrt(1.5);
    const Obb<double> b{
        {0, 0, 0},
        Eigen::AngleAxis<double>(turn, about.normalized()).toRotationMatrix(),
        {1, 1, 1}};
    CHECK(has_parallel_faces(cube, b) == (angle < 1));
  }
}

TEST_CASE("a point is 0 from a box that holds it, and 13 from one at (3, 4, 12)", "[P4]")
{
  const Matrix3<double> axes = rational_rotation<double>(1, 2, 3, 4);
  const Obb<double> box{{1, 1, 1}, axes, {1, 2, 3}};
  const auto at = [&](double x, double y, double z)
  { return distance_to_box<double>(box, box.center + axes * Vector3<double>(x, y, z)); };
  CHECK(at(0.9, -1.9, 2.9) == 0);
  CHECK(at(1 + 3, -2 - 4, 3 + 12) == Catch::Approx(13).margin(10 * rounding));
}

TEST_CASE("a float box made orthonormal in double is within a rounding of float", "[M7]")
{
  for (const auto& [a, b] : box_workload("random", 200).pairs)
  {
    const Obb<double> straight = orthonormal(a);
    CHECK(rotation_error(straight.axes) <= rounding);
    const double off = (straight.axes - a.axes.cast<double>()).cwiseAbs().maxCoeff();
    CHECK(off <= 4 * std::numeric_limits<float>::epsilon());
  }
}

TEST_CASE("a square on one turned by 45° has an octagon of 8 (√2 − 1) with it", "[O11]")
{
  const double eighth = std::atan(1.0);
  const auto overlap = [](double yaw, double x)
  {
    const Obb<double> b{
        {x, 1.9, 0},
        Eigen::AngleAxis<double>(yaw, Vector3<double>::UnitY()).toRotationMatrix(),
        {1, 1, 1}};
    return true_face_overlap(cube, b, {0, 1, 0});
  };
  CHECK(overlap(eighth, 0).size() == 8);
  CHECK(
      std::abs(area(overlap(eighth, 0))) == Catch::Approx(8 * (std::sqrt(2.0) - 1)).margin(1e-14));
  CHECK(overlap(0, 0).size() == 4);
  CHECK(std::abs(area(overlap(0, 0))) == Catch::Approx(4).margin(1e-14));
  CHECK(std::abs(area(overlap(0, 0.5))) == Catch::Approx(3).margin(1e-14));
  CHECK(overlap(0, 2.5).empty());
}

TEST_CASE("of a box that leans over another, the lower face counts", "[O11]")
{
  // B's axes are (99, 20, 0)/101 and (−20, 99, 0)/101: the middle of its lower face is 20/101 to
  // the right of its own, and the face reaches 99/101 to either side of that.
  const Vector3<double> center(1, 2, 3);
  const Obb<double> a = upright(center, {1, 1, 1});
  const Obb<double> b{
      center + Vector3<double>(0.1, 1.9, 0), rational_rotation<double>(10, 0, 0, 1), {1, 1, 1}};
  const double width = 1 - (0.1 + 20 / 101.0 - 99 / 101.0);
  CHECK(
      std::abs(area(true_face_overlap(a, b, {0, 1, 0}))) == Catch::Approx(2 * width).margin(1e-14));
}
// [truth]

namespace
{

using Answer = std::optional<Manifold<double>>;

/// What is right for the two cubes: four corners, midway.
Manifold<double> right()
{
  Manifold<double> manifold{{0, 1, 0}, 0.1, {}};
  for (const double x : {-1.0, 1.0})
  {
    manifold.points.push_back({{x, 0.95, x}, 0.1, 0});
    manifold.points.push_back({{x, 0.95, -x}, 0.1, 1});
  }
  return manifold;
}

ManifoldError error_of(const Answer& answer)
{
  return manifold_error<double>({cube, above}, answer);
}

} // namespace

// [measures]
TEST_CASE("a right manifold has no error, and each wrong number shows as what it is", "[measures]")
{
  const ManifoldError none = error_of(right());
  CHECK((none.finite && none.answered && none.parallel && !none.wrong(1e-5)));
  CHECK(none.size == 1);
  CHECK(none.depth == Catch::Approx(0.1).margin(rounding));
  CHECK(std::abs(none.excess) <= rounding);
  CHECK(std::abs(none.said) <= rounding);
  // Each point is half the depth from neither box: it is inside both.
  CHECK(none.outside == Catch::Approx(-0.05).margin(rounding));

  Manifold<double> reversed = right();
  reversed.normal = {0, -1, 0};
  CHECK(error_of(reversed).excess == Catch::Approx(3.8).margin(rounding));
  Manifold<double> leaning = right();
  leaning.normal = {3, 4, 0}; // taken for the unit vector along it
  CHECK(error_of(leaning).excess == Catch::Approx(2.8 - 0.8 * 1.9 - 0.1).margin(rounding));
  Manifold<double> deeper = right();
  deeper.depth = 0.3;
  CHECK(error_of(deeper).said == Catch::Approx(0.2).margin(rounding));
  Manifold<double> lifted = right();
  lifted.points[2].position.y() += 0.2; // 0.15 above A
  CHECK(error_of(lifted).outside == Catch::Approx(0.1).margin(rounding));
  Manifold<double> broken = right();
  broken.points[3].depth = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(error_of(broken).finite);
  CHECK_FALSE(error_of(Manifold<double>{{0, 1, 0}, 0.1, {}}).finite);
}

TEST_CASE("131,072 m away floats are 1/64 m apart, and a point may be off by that", "[measures]")
{
  const auto at = [](float y) -> Obb<float> {
    return {{131072, y, 0}, Matrix3<float>::Identity(), {1, 1, 1}};
  };
  const Manifold<float> manifold{
      {0, 1, 0}, 0.125f, ContactPoints<float, 8>({{131072, 1.25f, 0}, 0.125f, 0})};
  const ManifoldError error = manifold_error<float>({at(0), at(1.875f)}, std::optional(manifold));
  CHECK(error.outside == 0.25 - 0.0625 - 1 / 64.0);
  CHECK(error.depth == 0.125);
}

TEST_CASE("a verdict is wrong only beyond 1e-5 of the size", "[measures]")
{
  CHECK(error_of(std::nullopt).wrong(1e-5));
  const auto at = [](double y) { return BoxPair<double>{cube, upright({0, y, 0}, {1, 1, 1})}; };
  CHECK(manifold_error(at(2 + 2e-5), Answer(right())).wrong(1e-5));
  CHECK_FALSE(manifold_error(at(2 + 5e-6), Answer(right())).wrong(1e-5));
  CHECK_FALSE(manifold_error(at(2 - 5e-6), Answer()).wrong(1e-5));
  CHECK_FALSE(manifold_error(at(3), Answer()).wrong(1e-5));
}

TEST_CASE("of a hundred manifolds two are 0.3 too long: the 99th percentile is 0.3", "[measures]")
{
  std::vector<ManifoldError> errors(100);
  for (ManifoldError& error : errors)
  {
    error = {.size = 2, .depth = 0.5, .answered = true};
  }
  errors[7].excess = errors[70].excess = 0.3;
  errors[8].parallel = true; // not compared
  errors[9] = {.size = 2, .depth = 0.5};
  errors[10].finite = false;
  const WorkloadQuality quality = summed_up(errors, {0.1, 0.2});
  CHECK(quality.overlapping == 100);
  CHECK(quality.wrong == 1);
  CHECK(quality.not_finite == 1);
  CHECK(quality.compared == 97);
  CHECK(quality.excess == Catch::Approx(0.3 / 0.5));
  CHECK(quality.excess_of_size == Catch::Approx(0.3 / 2));
  CHECK(quality.excess_tolerated == Catch::Approx(0.3 / 0.4));
}

TEST_CASE(
    "the area of four corners is that of the faces' overlap, of three half of it", "[measures]")
{
  CHECK(area_fraction(cube, above, right()) == Catch::Approx(1).margin(1e-14));
  Manifold<double> three{{0, 1, 0}, 0.1, {}};
  for (std::size_t i = 0; i < 3; ++i)
  {
    three.points.push_back(right().points[i]);
  }
  CHECK(area_fraction(cube, above, three) == Catch::Approx(0.5).margin(1e-14));
}

TEST_CASE(
    "a method whose point is B's middle jumps by 1e-4, another by B's nearest side", "[measures]")
{
  const auto middle = [](const Obb<double>&, const Obb<double>& b) {
    return Answer(Manifold<double>{{0, 1, 0}, 0, ContactPoints<double, 8>({b.center, 0, 0})});
  };
  const RestingSteadiness steady = resting_steadiness<double>(box_workload("resting", 100), middle);
  CHECK(steady.compared == 100);
  CHECK(steady.lost == 0);
  CHECK(steady.recounted == 0);
  CHECK(steady.area == 0);
  CHECK(steady.jump == Catch::Approx(1e-4).epsilon(1e-9));
  int calls = 0;
  const auto restless = [&](const Obb<double>& a, const Obb<double>& b)
  {
    Answer answer = middle(a, b);
    answer->points.push_back({b.center + Vector3<double>(2, 0, 0), 0, 0});
    // The pairs' first and second call each; every fourth pair gains a point, every fifth is lost.
    const int pair = calls / 2, second = calls++ % 2;
    if (second == 1 && pair % 4 == 0)
    {
      answer->points.push_back({b.center, 0, 0});
    }
    return second == 1 && pair % 5 == 1 ? Answer() : answer;
  };
  const RestingSteadiness other =
      resting_steadiness<double>(box_workload("resting", 100), restless);
  CHECK(other.lost == 20);
  CHECK(other.compared == 80);
  CHECK(other.recounted == Catch::Approx(20.0 / 80));
  CHECK(other.jump > 0.3);
}

TEST_CASE("manifolds differ by their worst: normal, depth or farthest point", "[measures]")
{
  const auto with = [](auto change) -> Answer
  {
    Manifold<double> manifold = right();
    change(manifold);
    return manifold;
  };
  const auto from_right = [&](auto change) { return difference<8>(right(), with(change), 2); };
  CHECK(from_right([](Manifold<double>& m) { std::swap(m.points[0], m.points[3]); }) == 0);
  CHECK(
      from_right([](Manifold<double>& m) { m.depth += 0.5; }) == Catch::Approx(0.25).margin(1e-15));
  CHECK(from_right([](Manifold<double>& m) { m.normal = {0, 0, 1}; }) == std::sqrt(2.0));
  CHECK(
      from_right([](Manifold<double>& m) { m.points[1].position.y() += 0.3; }) ==
      Catch::Approx(0.15).margin(1e-15));
  // A corner that is not there is 1.414 from the line between its neighbours; in the middle of
  // an edge, a point more or less changes nothing.
  CHECK(
      from_right([](Manifold<double>& m) { m.points[1].position = m.points[0].position; }) ==
      Catch::Approx(std::sqrt(0.5)).margin(1e-15));
  CHECK(
      from_right(
          [](Manifold<double>& m) {
            m.points.push_back({{0.3, 0.95, 1}, 0.1, 7});
          }) <= 1e-15);
  CHECK(difference<8>(std::nullopt, std::nullopt, 1) == 0);
  CHECK(std::isinf(difference<8>(right(), std::nullopt, 1)));
}

TEST_CASE("separating axes in float: no verdict wrong, the excess within its tolerance", "[O5]")
{
  const auto axes = [](const Obb<float>& a, const Obb<float>& b)
  {
    const auto least = separating_axes(a, b);
    using Found = std::optional<Manifold<float>>;
    return least ? Found({least->normal, least->depth, ContactPoints<float, 8>({a.center, 0, 0})})
                 : Found();
  };
  for (const std::string& name : box_workload_names())
  {
    CAPTURE(name);
    const WorkloadQuality quality =
        workload_quality<float>(box_workload(name, some), axes, {1e-5, 1e-6});
    CHECK(quality.wrong == 0);
    CHECK(quality.not_finite == 0);
    CHECK(quality.excess_tolerated <= 1);
  }
}
// [measures]
