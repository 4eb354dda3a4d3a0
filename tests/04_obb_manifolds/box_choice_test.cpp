/// \file
/// How box_box() chooses: which axis, which corners, and what it does with sizes whose squares do
/// not fit.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_oracles/trial/manifold_error.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace cookbook;

namespace
{

/// Rows of C for two boxes turned against each other about (1, 1, 1), by an angle in degrees.
template <class Real>
BoxesInRows<RowOf<Real, 3>> turned_by(double degrees)
{
  const Matrix3<Real> c = turned(degrees * std::atan(1.0) / 45, {1, 1, 1}).cast<Real>();
  BoxesInRows<RowOf<Real, 3>> boxes{};
  for (int i = 0; i < 3; ++i)
  {
    boxes.rows[i] = RowOf<Real, 3>(c(i, 0), c(i, 1), c(i, 2));
  }
  return boxes;
}

template <class Real>
std::size_t points_of(const Obb<double>& a, const Obb<double>& b)
{
  const auto manifold = box_box(box_in<Real>(a), box_in<Real>(b));
  return manifold ? manifold->points.size() : 0;
}

} // namespace

TEMPLATE_TEST_CASE("tolerance and margin go with the boxes' sizes", "[O9]", float, double)
{
  using Real = TestType;
  const Obb<Real> a = box_in<Real>(upright({0, 0, 0}, {1, 2, 3}));
  const Obb<Real> b = box_in<Real>(upright({0, 0, 0}, {0.125, 0.25, 0.5}));
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  for (const auto& tolerances : {tolerances_of(a, b), tolerances_of(b, a)})
  {
    CHECK(tolerances.size == Real(6.875));
    CHECK(tolerances.length == Real(27.5) * epsilon);
    CHECK(tolerances.margin == Catch::Approx(0.00875).epsilon(1e-6));
  }
}

// [threshold]
TEMPLATE_TEST_CASE(
    "where faces are parallel an edge must be better by a twentieth or half the margin, elsewhere "
    "by "
    "a tolerance",
    "[O9][O19]", float, double)
{
  using Real = TestType;
  const Tolerances<Real> tolerances{Real(6), Real(0.001), Real(0.125)};
  // cos 1.1° and two thirds of it make entries above the cosine of one degree, 1.4° does not.
  for (const double degrees : {0.0, 1.1, 120.0})
  {
    CAPTURE(degrees);
    const BoxesInRows<RowOf<Real, 3>> parallel = turned_by<Real>(degrees);
    CHECK(edge_threshold(parallel, Real(4), tolerances) == Catch::Approx(3.8));
    CHECK(edge_threshold(parallel, Real(0.5), tolerances) == Catch::Approx(0.4375));
    CHECK(edge_threshold(parallel, Real(0.05), tolerances) == 0);
  }
  for (const double degrees : {1.4, 60.0, 121.5})
  {
    CAPTURE(degrees);
    const BoxesInRows<RowOf<Real, 3>> oblique = turned_by<Real>(degrees);
    CHECK(edge_threshold(oblique, Real(4), tolerances) == Catch::Approx(3.999).epsilon(1e-6));
    CHECK(edge_threshold(oblique, Real(0.0005), tolerances) == 0);
  }
}
// [threshold]

// [least]
TEMPLATE_TEST_CASE("of six faces the first of least overlap is taken", "[O9]", float, double)
{
  using Real = TestType;
  for (int least = 0; least < 6; ++least)
  {
    const auto overlap = [&](int i) { return i < least ? Real(2) : Real(1); };
    const LeastFace<Real> face = least_face(
        RowOf<Real, 3>(overlap(0), overlap(1), overlap(2)),
        RowOf<Real, 3>(overlap(3), overlap(4), overlap(5)));
    CHECK(face.index == least);
    CHECK(face.depth == 1);
  }
}

TEMPLATE_TEST_CASE(
    "of nine pairs of edges the one of least overlap is taken, if it is under the bar", "[O9]",
    float, double)
{
  using Real = TestType;
  for (int least = 0; least < 9; ++least)
  {
    CAPTURE(least);
    EdgeOverlaps<RowOf<Real, 3>> edges[3];
    for (int i = 0; i < 3; ++i)
    {
      // Overlap 2 along all axes, which are half as long as the unit; 1 along the least.
      const auto raw = [&](int j) { return 3 * i + j == least ? Real(0.5) : Real(1); };
      edges[i] = {RowOf<Real, 3>(raw(0), raw(1), raw(2)), RowOf<Real, 3>(Real(0.25))};
    }
    const LeastEdge<Real> found = least_edge(edges, Real(1.5));
    CHECK(found.found());
    CHECK(found.index == least);
    CHECK(found.squared_depth == 1);
    CHECK(least_edge(edges, Real(4)).index == least);
    CHECK_FALSE(least_edge(edges, Real(1)).found());
    CHECK_FALSE(least_edge(edges, Real(0)).found());
  }
}

TEMPLATE_TEST_CASE("axes of edges that are parallel are no axes", "[O4]", float, double)
{
  using Real = TestType;
  const auto with_squared_length = [](double squared)
  {
    const RowOf<Real, 3> none(Real(1)), unit(Real(1));
    EdgeOverlaps<RowOf<Real, 3>> edges[3] = {{none, unit}, {none, unit}, {none, unit}};
    edges[1].overlap = RowOf<Real, 3>(1, Real(1e-9), 1);
    edges[1].squared = RowOf<Real, 3>(1, static_cast<Real>(squared), 1);
    return least_edge(edges, Real(0.5));
  };
  CHECK(with_squared_length(1e-13).index == 4);
  CHECK(with_squared_length(1e-13).squared_depth == Catch::Approx(1e-5));
  CHECK_FALSE(with_squared_length(1e-15).found());
}
// [least]

// [separation]
TEMPLATE_TEST_CASE(
    "a corner with a gap is kept while the gap is less than the depth and than the margin", "[O20]",
    float, double)
{
  using Real = TestType;
  const Tolerances<Real> tolerances{Real(6), Real(0.001), Real(0.125)};
  CHECK(kept_separation(Real(2), tolerances.margin, tolerances.length) == Real(0.125));
  CHECK(kept_separation(Real(0.0625), tolerances.margin, tolerances.length) == Real(0.0625));
  CHECK(kept_separation(Real(0), tolerances.margin, tolerances.length) == Real(0.001));

  // A cube on a cube, leaning: one of its lower edges is 0.01 deep, the other hangs in the air.
  const auto leaning = [](double separation) -> Obb<double>
  {
    const double sine = (0.01 + separation) / 2, angle = std::asin(sine);
    return {{0, 1 + std::cos(angle) + sine - 0.01, 0}, turned(angle, {0, 0, 1}), {1, 1, 1}};
  };
  const Obb<double> below = upright({0, 0, 0}, {2, 1, 2});
  CHECK(points_of<Real>(below, leaning(0.009)) == 4);
  CHECK(points_of<Real>(below, leaning(0.011)) == 2);
}
// [separation]

TEMPLATE_TEST_CASE(
    "boxes so large or small that squares do not fit are made of another size, to the last bit",
    "[O9]", float, double)
{
  using Real = TestType;
  for (const std::string name : {"random", "resting", "edge-edge"})
  {
    for (const BoxPair<float>& given : box_workload(name, 300).pairs)
    {
      BoxPair<Real> pair = pair_in<Real>(given);
      pair.second.center -= pair.first.center;
      pair.first.center.setZero();
      const auto manifold = box_box(pair.first, pair.second);
      for (const int exponent : {-100, -45, 45, 100, 120})
      {
        CAPTURE(name, exponent);
        const auto distant = box_box(scaled(pair.first, exponent), scaled(pair.second, exponent));
        REQUIRE(manifold.has_value() == distant.has_value());
        if (!manifold)
        {
          continue;
        }
        const Manifold<Real> back = scaled(*distant, -exponent);
        CHECK(back.normal == manifold->normal);
        CHECK(back.depth == manifold->depth);
        REQUIRE(back.points.size() == manifold->points.size());
        for (std::size_t i = 0; i < back.points.size(); ++i)
        {
          CHECK(back.points[i].position == manifold->points[i].position);
          CHECK(back.points[i].depth == manifold->points[i].depth);
          CHECK(back.points[i].feature == manifold->points[i].feature);
        }
      }
    }
  }
}

TEMPLATE_TEST_CASE(
    "large boxes may overlap where their distance does not fit a number", "[O9]", float, double)
{
  using Real = TestType;
  const Real most = std::numeric_limits<Real>::max();
  const Matrix3<Real> straight = Matrix3<Real>::Identity();
  const Vector3<Real> half(most / 2, most, most);
  const Obb<Real> a{{Real(-0.75) * most, 0, 0}, straight, half};
  const Obb<Real> b{{Real(0.5) * most, 0, 0}, straight, half};
  CHECK_FALSE(box_box(a, b));
  const Obb<Real> nearer{{Real(0.125) * most, 0, 0}, straight, half};
  const auto manifold = box_box(a, nearer);
  REQUIRE(manifold);
  CHECK(manifold->normal == Vector3<Real>(1, 0, 0));
  CHECK(manifold->depth == Catch::Approx(most / 8));
  // Small boxes as far apart as numbers go are apart, not NaN.
  const Vector3<Real> unit(1, 1, 1);
  CHECK_FALSE(box_box(
      Obb<Real>{{-most, -most, most}, straight, unit},
      Obb<Real>{{most, most, -most}, straight, unit}));
}

TEMPLATE_TEST_CASE("every normal is a unit vector, every depth zero or more", "[O9]", float, double)
{
  using Real = TestType;
  const Real rounding = 16 * std::numeric_limits<Real>::epsilon();
  for (const std::string& name : box_workload_names())
  {
    CAPTURE(name);
    for (const BoxPair<float>& given : box_workload(name, 2000).pairs)
    {
      const BoxPair<Real> pair = pair_in<Real>(given);
      if (const auto manifold = box_box(pair.first, pair.second))
      {
        CHECK(std::abs(manifold->normal.norm() - 1) <= rounding);
        CHECK(manifold->depth >= 0);
      }
    }
  }
}

TEMPLATE_TEST_CASE(
    "where two faces have no corner in common, the deepest corner is the contact", "[O14]", float,
    double)
{
  using Real = TestType;
  const Obb<Real> a = box_in<Real>(upright({0, 0, 0}, {1, 1, 1}));
  const Obb<Real> b = box_in<Real>(
      Obb<double>{{0.5, 1.5, 0.25}, turned(std::atan(1.0), {0, 0, 1}), {0.5, 0.25, 0.5}});
  const ContactPoint<Real> point =
      deepest_point<Real>(a, b, Vector3<Real>(0, 1, 0), Real(0.125), 64);
  // B's lowest edge is at x = 0.5 + (0.25 − 0.5) / √2 …, and the axis z of both is the same.
  const double x = 0.5 + (0.25 - 0.5) * std::sqrt(0.5), y = 1.5 - 0.75 * std::sqrt(0.5) + 0.0625;
  CHECK(double(point.position.x()) == Catch::Approx(x).epsilon(1e-6));
  CHECK(double(point.position.y()) == Catch::Approx(std::min(y, 1.0)).epsilon(1e-6));
  CHECK(std::abs(double(point.position.z()) - 0.25) == Catch::Approx(0.5).epsilon(1e-6));
  CHECK(point.depth == Real(0.125));
  CHECK(point.feature == 64);
}
