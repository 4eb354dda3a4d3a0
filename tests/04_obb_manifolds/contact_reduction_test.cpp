/// \file
/// What holds for four points of many, formula O15, and for the four deepest instead.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_oracles/trial/resting_steadiness.hpp"
#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "04_obb_manifolds/contact_reduction/contact_reduction.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_reduction_pitfalls.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_reduction_truth.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_reduction_verdicts.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_support.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <array>
#include <set>
#include <string>

using namespace cookbook;

namespace
{

/// Areas here are sums of fewer than 20 products of numbers of size 1, each rounded.
constexpr double rounding = 1e-14;

const double eighth = std::atan(1.0);
const double root = std::sqrt(2.0);

/// Flat contact points seen from above: x, z and depth of each; its feature is its number.
template <class Real>
Manifold<Real> flat(const std::vector<std::array<Real, 3>>& rows)
{
  Manifold<Real> manifold{{0, 1, 0}, 0, {}};
  for (const auto& [x, z, depth] : rows)
  {
    manifold.points.push_back({{x, 0, z}, depth, std::uint32_t(manifold.points.size())});
    manifold.depth = std::max(manifold.depth, depth);
  }
  return manifold;
}

using Features = std::vector<std::uint32_t>;

template <class Real, std::size_t Capacity>
Features features(const Manifold<Real, Capacity>& manifold)
{
  Features found;
  for (const ContactPoint<Real>& point : manifold.points)
  {
    found.push_back(point.feature);
  }
  return found;
}

/// Numbers that every compiler draws alike.
class Draw : public BoxDraw
{
public:
  using BoxDraw::BoxDraw;

  /// Five to eight points around an ellipse, in order, with depths up to 0.01.
  Manifold<double> around()
  {
    const int count = 5 + int(between(0, 4));
    const double longer = between(0.2, 5), first = between(0, 6);
    Manifold<double> manifold{{0, 1, 0}, 0.01, {}};
    for (int i = 0; i < count; ++i)
    {
      const double angle = first + 8 * eighth * (i + between(0, 0.9)) / count;
      const Vector3<double> place(longer * std::cos(angle), 0, std::sin(angle));
      manifold.points.push_back({place, between(0, 0.01), std::uint32_t(i)});
    }
    return manifold;
  }
};

/// The feature of the deepest point.
template <std::size_t Capacity>
std::uint32_t deepest(const Manifold<double, Capacity>& manifold)
{
  return std::max_element(
             manifold.points.begin(), manifold.points.end(),
             [](const auto& p, const auto& q) { return p.depth < q.depth; })
      ->feature;
}

/// A point somewhere under the hull of the points: a mean with random weights.
Vector3<double> somewhere_under(const Manifold<double>& manifold, Draw& draw)
{
  Vector3<double> sum = Vector3<double>::Zero();
  double weights = 0;
  for (const ContactPoint<double>& point : manifold.points)
  {
    const double weight = std::pow(draw.between(0.01, 1), 4);
    sum += weight * point.position;
    weights += weight;
  }
  return sum / weights;
}

double middle_inside(const Manifold<double, most_kept>& few, const Vector3<double>& center)
{
  return inside(support(few), seen_along(few.normal, center));
}

} // namespace

// [O15]
TEMPLATE_TEST_CASE(
    "deepest, farthest from it, largest triangle, most added area: points 4, 1, 2 and 5 of six",
    "[O15]", float, double)
{
  // From 4 at (0, 0) the farthest is 1 at (6, 0); 2 at (4, 3) makes a triangle of 9, 0 of 8.5 on
  // the other side. Beyond a side of the triangle, 5 adds 8.5, 0 adds 4.5, 3 adds 4.
  const Manifold<TestType> many = flat<TestType>(
      {{5, -1.5, 0}, {6, 0, 0}, {4, 3, 0}, {1, 2.75, 0}, {0, 0, 1}, {2, TestType(-17) / 6, 0}});
  CHECK(features(reduced(many)) == Features{1, 2, 4, 5});
}

TEST_CASE(
    "an octagon of 8 (√2 − 1) keeps a square of 8 − 4 √2, the best of all fours", "[O15][case:G19]")
{
  const Manifold<double> octagon = turned_squares(eighth, 0);
  CHECK(area(support(octagon)) == Catch::Approx(8 * (root - 1)).margin(rounding));
  CHECK(area(support(reduced(octagon))) == Catch::Approx(8 - 4 * root).margin(rounding));
  CHECK(area(support(best_four(octagon))) == Catch::Approx(8 - 4 * root).margin(rounding));
  CHECK(features(reduced(octagon)) == Features{0, 2, 4, 6});
  // So do all octagons that lean a little, whichever corner is deepest.
  for (std::uint32_t corner = 0; corner < 8; ++corner)
  {
    Manifold<double> leaning = turned_squares(eighth, 0);
    leaning.points[corner].depth += 1e-4;
    const Manifold<double, most_kept> few = reduced(leaning);
    CHECK(deepest(few) == corner);
    CHECK(area(support(few)) >= 2.32);
  }
}

TEST_CASE(
    "2,000 manifolds keep their deepest point, a quarter of the area at least, and 3/4 of the best",
    "[O15]")
{
  Draw draw(1);
  double least_of_all = 1, least_of_best = 1;
  for (int i = 0; i < 2000; ++i)
  {
    const Manifold<double> many = draw.around();
    const Manifold<double, most_kept> few = reduced(many);
    REQUIRE(few.points.size() == 4);
    REQUIRE(deepest(few) == deepest(many));
    const double kept = area(support(few)), best = area(support(best_four(many)));
    least_of_all = std::min(least_of_all, kept / area(support(many)));
    least_of_best = std::min(least_of_best, kept / best);
  }
  INFO(least_of_all << " " << least_of_best);
  CHECK(least_of_all >= 0.25);
  CHECK(least_of_best >= 0.75);
  CHECK(least_of_best < 0.9);
}
// [O15]

// [ties]
TEST_CASE("of equal points those that come first are kept, also on a line or in one place", "[O15]")
{
  const std::array<double, 3> here{1, 1, 0.5};
  CHECK(
      features(reduced(flat<double>({here, here, here, here, here, here}))) ==
      Features{0, 1, 2, 3});
  CHECK(
      features(reduced(flat<double>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}))) ==
      Features{0, 1, 2, 4});
  // The corners of a square: any two of them that are equally deep may differ by rounding.
  const double tolerance = 1e-15;
  CHECK(
      features(reduced(flat<double>(
          {{1, 1, 0},
           {-1, 1, tolerance},
           {-1, -1 - tolerance, 0},
           {1, -1, tolerance},
           {0, 1, 0}}))) == Features{0, 1, 2, 3});
}

TEST_CASE("areas that differ by rounding are ties, those that differ by more are not", "[O15]")
{
  // From (−3, 0) the farthest is (3, 0). A step in z makes 6 of it in doubled area; rounding of
  // coordinates of 3 may make 32 · 3 · 6 of 2.2e-16.
  for (const auto& [tolerance, third] : {std::pair(5e-15, 2u), std::pair(1e-13, 3u)})
  {
    const Manifold<double> above =
        flat<double>({{-3, 0, 1}, {3, 0, 0}, {-1, 3, 0}, {1, 3 + tolerance, 0}, {0, -2, 0}});
    CHECK(features(reduced(above)) == Features{0, 1, third, 4});
    const Manifold<double> below =
        flat<double>({{-3, 0, 1}, {3, 0, 0}, {-1, -2, 0}, {1, -2 - tolerance, 0}, {0, 3, 0}});
    CHECK(features(reduced(below)) == Features{0, 1, third, 4});
  }
}

TEST_CASE("four points or fewer are all kept; normal, depth, order and features stay", "[O15]")
{
  const Manifold<double> four = flat<double>({{0, 0, 1}, {1, 0, 2}, {1, 1, 3}, {0, 1, 2}});
  const Manifold<double> octagon = turned_squares(0.5, 0.001);
  for (const auto& [many, few] :
       {std::pair(four, reduced(four)), std::pair(octagon, reduced(octagon)),
        std::pair(four, reduced_over(four, {0, 0, 0})), std::pair(four, four_deepest(four))})
  {
    CHECK(few.points.size() == 4);
    CHECK(few.normal == many.normal);
    CHECK(few.depth == many.depth);
    const Features order = features(few);
    CHECK(std::is_sorted(order.begin(), order.end()));
    for (const ContactPoint<double>& point : few.points)
    {
      CHECK(point.position == many.points[point.feature].position);
      CHECK(point.depth == many.points[point.feature].depth);
    }
  }
  CHECK(reduced(flat<double>({{1, 2, 0.5}})).points.size() == 1);
}

TEST_CASE("the same points are kept wherever the manifold is, and mirrored, at any size", "[O15]")
{
  Draw draw(2);
  for (int i = 0; i < 200; ++i)
  {
    const Manifold<double> many = draw.around();
    const Features kept = features(reduced(many));
    for (const double scale : {1e-3, -1.0, 1e3})
    {
      Manifold<double> moved = many;
      const Vector3<double> about = Vector3<double>(1, -2, 0.5).normalized();
      const Matrix3<double> turn = Eigen::AngleAxis<double>(0.7, about).toRotationMatrix();
      moved.normal = turn * many.normal;
      for (ContactPoint<double>& point : moved.points)
      {
        point.position = scale * (turn * point.position + Vector3<double>(10, -20, 30));
        point.depth *= std::abs(scale);
      }
      CHECK(features(reduced(moved)) == kept);
    }
  }
}
// [ties]

// [four_deepest]
TEST_CASE(
    "leaning a little, the octagon's four deepest span 2 (√2 − 1): a quarter, all on one side",
    "[case:G19]")
{
  for (const double leaning : {1e-12, 1e-6, 1e-3})
  {
    const Manifold<double> octagon = turned_squares(eighth, leaning);
    const Manifold<double, most_kept> wrong = four_deepest(octagon), right = reduced(octagon);
    CHECK(area(support(wrong)) == Catch::Approx(2 * (root - 1)).margin(rounding));
    CHECK(area(support(right)) == Catch::Approx(8 - 4 * root).margin(rounding));
    CHECK(middle_inside(wrong, {0, 0, 0}) < -0.4);
    CHECK(middle_inside(right, {0, 0, 0}) > 0.7);
  }
}
// [four_deepest]

// [reduction_verdicts]
TEST_CASE(
    "eight points of two cubes: reduced() keeps the best four, the others fail as the table says",
    "[case:G19]")
{
  check_verdicts(
      reduction_verdicts(), names_of(reduction_methods()),
      {{"G19", {"four_deepest", "reduced", "steadily_reduced"}},
       {"the same, leaning by 1e-3", {"reduced", "steadily_reduced"}}});
  const Manifold<double> level = octagon_of_cubes(0);
  REQUIRE(level.points.size() == 8);
  CHECK(area(support(level)) == Catch::Approx(8 * (root - 1)).margin(1e-12));
  CHECK(area(support(reduced(level))) == Catch::Approx(8 - 4 * root).margin(1e-12));
}

TEST_CASE("four of eight that have lost the deepest point are no good, whatever they span", "[O15]")
{
  const Manifold<double> octagon = octagon_of_cubes(1e-3);
  const ReductionMethod without_deepest{
      "", [](const Manifold<double>& all)
      {
        Manifold<double> rest{all.normal, all.depth, {}};
        for (const ContactPoint<double>& point : all.points)
        {
          if (point.depth < all.depth - 1e-6)
          {
            rest.points.push_back(point);
          }
        }
        return best_four(rest);
      }};
  const Verdict verdict = verdict_on_reduction(without_deepest, octagon);
  CHECK_FALSE(verdict.holds);
  CHECK(verdict.what.find("deepest lost") != std::string::npos);
}
// [reduction_verdicts]

TEST_CASE("four points that span a hundredth less than the best four are no good", "[O15]")
{
  const auto shrunk = [](double scale)
  {
    const ReductionMethod method{
        "", [=](const Manifold<double>& all)
        {
          Manifold<double, most_kept> few = best_four(all);
          for (ContactPoint<double>& point : few.points)
          {
            point.position.x() *= scale;
          }
          return few;
        }};
    return verdict_on_reduction(method, octagon_of_cubes(0));
  };
  CHECK(shrunk(0.992).holds);
  CHECK_FALSE(shrunk(0.988).holds);
}

// [reduced_over]
TEST_CASE("the rim of a triangle is over it, and nothing is over one without an area", "[O15]")
{
  const Vector3<double> up(0, 1, 0), p(0, 0, 0), q(2, 0, 0), r(0, 0, 2), rim(1, 7, 0);
  CHECK(is_over<double>(rim, up, p, q, r));
  CHECK(is_over<double>(rim, up, p, r, q));
  CHECK(is_over<double>({1, 7, 1}, up, p, q, r));
  CHECK_FALSE(is_over<double>({1, 7, -1e-9}, up, p, q, r));
  CHECK_FALSE(is_over<double>({1, 7, -1e-9}, up, p, r, q));
  CHECK_FALSE(is_over<double>({1.5, 7, 1}, up, p, q, r));
  CHECK_FALSE(is_over<double>({-1, 7, 1}, up, p, q, r));
  CHECK_FALSE(is_over<double>(rim, up, p, q, q));
}

TEST_CASE("a weight over a lost corner of the octagon is held by reduced_over() alone", "[O15]")
{
  const Manifold<double> octagon = turned_squares(eighth, 0);
  // Corner 1, 1.0824 from the middle, is lost; the side of the square is 0.7654 from there.
  const Vector3<double> weight = 0.9 * octagon.points[1].position;
  CHECK(middle_inside(reduced(octagon), weight) < -0.2);
  const Manifold<double, most_kept> few = reduced_over(octagon, weight);
  CHECK(middle_inside(few, weight) > 0);
  CHECK(few.points[0].feature == 0);
}

TEST_CASE(
    "of 10,000 weights over all points, one in seven is not over the four; with reduced_over() "
    "each is",
    "[O15]")
{
  Draw draw(3);
  int lost = 0;
  for (int i = 0; i < 10000; ++i)
  {
    const Manifold<double> many = draw.around();
    const Vector3<double> weight = somewhere_under(many, draw);
    lost += middle_inside(reduced(many), weight) < 0 ? 1 : 0;
    const Manifold<double, most_kept> few = reduced_over(many, weight);
    REQUIRE(few.points.size() == 4);
    REQUIRE(middle_inside(few, weight) >= -rounding);
    REQUIRE(deepest(few) == deepest(many));
  }
  INFO(lost);
  CHECK(lost > 1000);
}

TEST_CASE("triangles over a weight that differ by rounding are ties", "[O15]")
{
  for (const auto& [tolerance, third] :
       {std::pair(-5e-15, 2u), std::pair(5e-15, 2u), std::pair(1e-13, 3u)})
  {
    const Manifold<double> many =
        flat<double>({{-3, 0, 1}, {3, 0, 0}, {-1, 3, 0}, {1, 3 + tolerance, 0}, {0, -2, 0}});
    CHECK(features(reduced_over(many, {0, 0, 0.5})) == Features{0, 1, third, 4});
  }
}

TEST_CASE("a weight beside all points changes nothing", "[O15]")
{
  const Manifold<double> octagon = turned_squares(0.5, 0.001);
  CHECK(features(reduced_over(octagon, {3, 0, 0})) == features(reduced(octagon)));
}
// [reduced_over]

// [jumps]
TEST_CASE(
    "boxes that rest, nudged by 1e-4: all points stay, four jump by a tenth of a box", "[O15]")
{
  const BoxWorkload resting = box_workload("resting", 1000);
  const auto steadiness = [&](const auto& keep)
  {
    return resting_steadiness<double>(
        resting,
        [&](const Obb<double>& a, const Obb<double>& b)
        {
          const auto all = box_box(a, b);
          return all ? std::optional(keep(*all)) : std::nullopt;
        });
  };
  const RestingSteadiness all = steadiness([](const Manifold<double>& many) { return many; });
  const RestingSteadiness four = steadiness(reduced<double, 8>);
  const RestingSteadiness wrong = steadiness(four_deepest<double, 8>);
  CHECK((all.area > 0.999 && all.jump < 1e-3));
  CHECK((four.area > 0.7 && four.jump > 0.1 && four.jump < 0.5));
  CHECK((wrong.area < 0.25 && wrong.jump > 0.5));
}
// [jumps]
