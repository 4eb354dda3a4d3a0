/// \file
/// What holds for mass and inertia: formulas R26, M12 and M13, and bodies of any size.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "05_resolution/impulse/impulse.hpp"
#include "05_resolution/mass_properties/checked_mass.hpp"
#include "05_resolution/mass_properties/mass_properties.hpp"
#include "05_resolution/mass_properties/trial/mass_properties_cases.hpp"
#include "05_resolution/mass_properties/trial/mass_properties_figures.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <functional>
#include <limits>

using namespace cookbook;

namespace
{

/// A few roundings of numbers of size one: double's unit roundoff is 1.1e-16.
constexpr double rounding = 1e-15;

/// The integral of a polynomial of degree 5 or less, exactly: Boole's rule.
Rational
integral(const Rational& from, const Rational& to, const std::function<Rational(Rational)>& f)
{
  const Rational h = (to - from) / 4;
  return (to - from) / 90 *
         (7 * f(from) + 32 * f(from + h) + 12 * f(from + 2 * h) + 32 * f(from + 3 * h) + 7 * f(to));
}

/// A capsule of density 1/π, cut into discs across its length: a disc at height y of squared
/// radius s adds s to the mass, s²/2 to the moment along, s²/4 + s y² to the moment across.
MassProperties<Rational> capsule_of_discs(const Rational& length, const Rational& radius)
{
  const Rational half = length / 2, end = half + radius;
  const auto sum = [&](const std::function<Rational(Rational, Rational)>& share)
  {
    const auto cap = [&](const Rational& y)
    { return share(y, radius * radius - (y - half) * (y - half)); };
    const auto middle = [&](const Rational& y) { return share(y, radius * radius); };
    return Rational(2 * (integral(0, half, middle) + integral(half, end, cap)));
  };
  const auto mass = [](const Rational&, const Rational& s) { return s; };
  const auto along = [](const Rational&, const Rational& s) { return Rational(s * s / 2); };
  const auto across = [](const Rational& y, const Rational& s)
  { return Rational(s * s / 4 + s * y * y); };
  const Rational i = sum(across);
  return {sum(mass), Vector3<Rational>(i, sum(along), i)};
}

/// What is said of these mass properties, or nothing.
template <class Real>
std::string complaint(Real mass, const Vector3<Real>& moments)
{
  try
  {
    checked<Real>({mass, moments});
    return "";
  }
  catch (const InvalidShape& error)
  {
    return error.what();
  }
}

} // namespace

// [R26]
TEST_CASE("a box of 12 kg, 2 by 4 by 6 m, has moments 52, 40, 20; a ball of 5 kg, 2 m, 8", "[R26]")
{
  CHECK(solid_box<double>(12, {1, 2, 3}).moments == Vector3<double>(52, 40, 20));
  CHECK(solid_sphere<double>(5, 2).moments == Vector3<double>(8, 8, 8));
  CHECK(solid_capsule<double>(5, 0, 2).moments == Vector3<double>(8, 8, 8));
  CHECK(solid_box<double>(12, {1, 2, 3}).mass == 12);
  CHECK(solid_sphere<double>(5, 2).mass == 5);
  CHECK(solid_capsule<double>(5, 0, 2).mass == 5);
}

TEST_CASE("capsules of 100 sizes are the sums of their discs, exactly", "[R26]")
{
  for (int i = 0; i < 10; ++i)
  {
    for (int j = 1; j <= 10; ++j)
    {
      const Rational length = Rational(i) / 3, radius = Rational(j) / 7;
      const MassProperties<Rational> discs = capsule_of_discs(length, radius);
      const MassProperties<Rational> capsule = solid_capsule<Rational>(discs.mass, length, radius);
      CHECK(capsule.moments == discs.moments);
    }
  }
}

TEST_CASE(
    "a rod of 3 kg, a hundred million times as long as wide, has 2e-16 kg m² about it", "[R26]")
{
  const Vector3<double> moments = solid_box<double>(3, {1, 1e-8, 1e-8}).moments;
  CHECK(moments.x() == Catch::Approx(2e-16).epsilon(rounding));
}
// [R26]

// [M12]
TEST_CASE("a turned inertia turns its angular momentum with it, exactly", "[M12]")
{
  // L = I ω holds in the body's frame, and every vector of that frame is turned by R.
  const Vector3<Rational> moments(2, 3, 7), spin(1, -4, 5);
  const Matrix3<Rational> axes = rational_rotation<Rational>(1, 2, 3, 4);
  const Vector3<Rational> turned = world_inertia<Rational>(moments, axes) * (axes * spin);
  CHECK(turned == Vector3<Rational>(axes * Vector3<Rational>(2, -12, 35)));
}
// [M12]

// [M13]
TEST_CASE("eight cubes weigh in as one of twice their side: 16/3 kg m² about each axis", "[M13]")
{
  const Matrix3<Rational> inertia = inertia_together(eight_cubes<Rational>());
  const MassProperties<Rational> one = solid_box<Rational>(8, Vector3<Rational>::Constant(1));
  CHECK(inertia == Matrix3<Rational>(one.moments.asDiagonal()));
  CHECK(inertia == Matrix3<Rational>(Matrix3<Rational>::Identity() * (Rational(16) / 3)));
}

TEST_CASE("a box cut in two by a plane anywhere, and turned, weighs in as the whole", "[M13]")
{
  const Matrix3<Rational> axes = rational_rotation<Rational>(3, -1, 2, 5);
  const Vector3<Rational> center(7, -8, 9), half(1, 2, 3);
  const Matrix3<Rational> whole =
      world_inertia<Rational>(solid_box<Rational>(12, half).moments, axes);
  for (int cut = 1; cut < 6; ++cut) // at y = -2 + 4 cut / 6
  {
    const Rational below = Rational(cut) / 3, above = 2 - below;
    const auto piece = [&](const Rational& thick, const Rational& y) -> PlacedSolid<Rational>
    {
      const Vector3<Rational> halves(1, thick, 3), offset(0, y, 0);
      return {solid_box<Rational>(6 * thick, halves), center + axes * offset, axes};
    };
    const std::vector<PlacedSolid<Rational>> pieces{
        piece(below, below - 2), piece(above, 2 - above)};
    CHECK(mass_together(pieces) == 12);
    CHECK(center_together(pieces) == center);
    CHECK(inertia_together(pieces) == whole);
  }
}

TEST_CASE("five composed solids have the inertia that was found by hand, exactly", "[M13]")
{
  for (const InertiaCase<Rational>& one : inertia_cases<Rational>())
  {
    INFO(one.what);
    CHECK(inertia_together(one.solids) == one.right);
  }
}
// [M13]

// [combined]
TEST_CASE("an L of three cubes turns about its diagonals: moments 5/6, 3/2, 11/6", "[M13]")
{
  const PlacedSolid<double> whole = combined(three_cubes<double>());
  const double root = std::sqrt(0.5);
  const Vector3<double> third = Vector3<double>::Constant(1 / 3.0);
  CHECK(whole.properties.mass == 3);
  CHECK((whole.center - Vector3<double>(third.x(), third.y(), 0)).norm() <= rounding);
  CHECK((whole.properties.moments - Vector3<double>(5, 9, 11) / 6).norm() <= 4 * rounding);
  CHECK((whole.axes.col(0).cwiseAbs() - Vector3<double>(root, root, 0)).norm() <= 4 * rounding);
  CHECK(whole.axes(0, 0) * whole.axes(1, 0) < 0); // from one end of the L to the other
}

TEST_CASE(
    "the axes of 200 heaps of boxes are right-handed, the largest part of two positive, and make "
    "their inertia",
    "[M12]")
{
  std::uint32_t seed = 1;
  const auto draw = [&]
  {
    seed = seed * 1664525u + 1013904223u;
    return double(seed >> 8) / double(1u << 24) + 0.01;
  };
  for (int i = 0; i < 200; ++i)
  {
    std::vector<PlacedSolid<double>> solids;
    for (int j = 0; j < 1 + i % 5; ++j)
    {
      const double mass = draw(), x = draw(), y = draw();
      const Vector3<double> half_extents(x, y, draw());
      const Vector3<double> center(3 * x - y, 2 * y, x * x);
      solids.push_back(
          {solid_box<double>(mass, half_extents), center,
           rational_rotation<double>(1 + j, i % 3, 2, -j)});
    }
    const PlacedSolid<double> whole = combined(solids);
    const Matrix3<double> inertia = inertia_together(solids);
    CHECK(rotation_error(whole.axes) <= 10 * rounding);
    CHECK((combined_inertia(solids) - inertia).norm() <= 20 * rounding * inertia.norm());
    CHECK_NOTHROW(checked(whole.properties));
    CHECK(whole.properties.moments[0] <= whole.properties.moments[1]);
    CHECK(whole.properties.moments[1] <= whole.properties.moments[2]);
    for (int axis = 0; axis < 2; ++axis)
    {
      CHECK(whole.axes.col(axis).maxCoeff() == whole.axes.col(axis).cwiseAbs().maxCoeff());
    }
  }
}

TEST_CASE("a needle's moment about its length is lost in rounding, and stays above zero", "[M12]")
{
  const MassProperties<double> needle = solid_box<double>(3, {1, 1e-10, 1e-10});
  const PlacedSolid<double> one =
      combined<double>({{needle, {0, 0, 0}, rational_rotation<double>(1, 2, 3, 4)}});
  CHECK(one.properties.moments[0] > 0);
  CHECK(one.properties.moments[0] <= 4 * rounding);
  CHECK(one.properties.moments[2] == Catch::Approx(1).epsilon(4 * rounding));
}
// [combined]

// [inertia_verdicts]
TEST_CASE("moments added up are right for one solid, without the rest of the matrix for some")
{
  const std::vector<VerdictRow> rows = inertia_verdicts();
  check_verdicts(
      rows, {"moments added up", "parallel axes, diagonal only", "combined"},
      {{"one cube", {"moments added up", "parallel axes, diagonal only", "combined"}},
       {"eight cubes that make one", {"parallel axes, diagonal only", "combined"}},
       {"two balls on a stick", {"parallel axes, diagonal only", "combined"}},
       {"three cubes that make an L", {"combined"}},
       {"a rod that leans", {"combined"}}});
  CHECK(rows[1].verdicts[0].what == "off by 75 %"); // 8/6 of 16/3
}
// [inertia_verdicts]

// [simpler]
TEST_CASE("for a ball a box is 2/3 too hard to turn, a cylinder 11/24; both fade with length")
{
  const auto across = [](double length) { return solid_capsule(1.0, length, 1.0).moments.x(); };
  const auto box = [](double length) {
    return solid_box<double>(1, {1, length / 2 + 1, 1}).moments.x();
  };
  const auto cylinder = [](double length) { return (length + 2) * (length + 2) / 12 + 0.25; };
  CHECK(box(0) / across(0) == Catch::Approx(5 / 3.0).epsilon(rounding));
  CHECK(cylinder(0) / across(0) == Catch::Approx(35 / 24.0).epsilon(rounding));
  // Of a stick of length L both make 1 + 4/(3 L), and less than 2 % too much from L = 100 on.
  CHECK(box(100) / across(100) < 1.02);
  CHECK(cylinder(100) / across(100) < 1.02);
  CHECK(cylinder(100) / across(100) > 1.01);
}
// [simpler]

// [checked_mass]
TEMPLATE_TEST_CASE("a mass that no solid has is named with its value", "", float, double)
{
  using Moments = Vector3<TestType>;
  const TestType nan = std::numeric_limits<TestType>::quiet_NaN();
  const TestType infinity = std::numeric_limits<TestType>::infinity();
  const Moments ones(1, 1, 1);
  CHECK(complaint<TestType>(1, ones) == "");
  CHECK(complaint<TestType>(nan, ones) == "mass must be finite, got nan");
  CHECK(complaint<TestType>(infinity, ones) == "mass must be finite, got inf");
  CHECK(complaint<TestType>(0, ones) == "mass must be greater than zero, got 0");
  CHECK(complaint<TestType>(-2, ones) == "mass must be greater than zero, got -2");
  CHECK(complaint<TestType>(1, {1, nan, 1}) == "moments.y must be finite, got nan");
  CHECK(complaint<TestType>(1, {1, 1, 0}) == "moments.z must be greater than zero, got 0");
  CHECK(
      complaint<TestType>(1, {4, 1, 2}) ==
      "moments.x must be at most the two others together, 3, got 4");
  CHECK(complaint<TestType>(1, {1, 3, 2}) == "");
}
// [checked_mass]

// [any_size]
TEST_CASE("a grain of 1e-20 kg and 1e-10 m is thrown as far as a cube of 1 kg and 1 m", "[R2]")
{
  // Masses scaled by 1e-20, lengths by 1e-10: what bounces is the same. In float the moments,
  // 1.7e-41, are so small that their inverse is no number; as if they were 5e-20, the grain
  // hardly turns, and its centre comes up at all of e = 1/2.
  const auto up = []<class Real>(Real mass, Real side)
  {
    const Vector3<Real> zero = Vector3<Real>::Zero(), down(0, -1, 0);
    const MassProperties<Real> cube = solid_box<Real>(mass, Vector3<Real>::Constant(side / 2));
    const Body<Real> body = dynamic_body<Real>({zero, down, zero}, cube, Matrix3<Real>::Identity());
    const Vector3<Real> corner(side / 2, -side / 2, side / 2);
    return resolve_collision<Real>({body, static_body(zero)}, down, corner, Real(0.5)).a.motion;
  };
  CHECK(up(1.0, 1.0).velocity.y() == Catch::Approx(-0.625).epsilon(rounding));
  CHECK(up(1e-20, 1e-10).velocity.y() == Catch::Approx(-0.625).epsilon(rounding));
  CHECK(up(1e-20f, 1e-10f).velocity.y() == Catch::Approx(0.5).epsilon(1e-6));
  CHECK(up(1e-20f, 1e-10f).angular_velocity.allFinite());
}

TEMPLATE_TEST_CASE("no mass and no size makes a body that is not a number", "", float, double)
{
  using Limits = std::numeric_limits<TestType>;
  const Matrix3<TestType> axes = rational_rotation<TestType>(1, 2, 3, 4);
  const Vector3<TestType> zero = Vector3<TestType>::Zero();
  std::vector<TestType> sizes{Limits::denorm_min(), Limits::min(), 1, Limits::max()};
  for (int power = -40; power <= 36; power += 4)
  {
    sizes.push_back(static_cast<TestType>(std::pow(10, power)));
  }
  for (const TestType mass : sizes)
  {
    for (const TestType x : sizes)
    {
      for (const TestType y : sizes)
      {
        for (const MassProperties<TestType>& solid :
             {solid_box<TestType>(mass, {x, y, x}), solid_capsule<TestType>(mass, x, y),
              solid_sphere<TestType>(mass, x)})
        {
          CAPTURE(mass, x, y);
          REQUIRE_FALSE(solid.moments.hasNaN());
          const Body<TestType> body = dynamic_body<TestType>({zero, zero, zero}, solid, axes);
          REQUIRE(std::isfinite(body.inverse_mass));
          REQUIRE(body.inverse_inertia.allFinite());
        }
      }
    }
  }
}

TEST_CASE("a mass that is no number in float's reach is the least, or immovable")
{
  CHECK(bounded_inverse(2.0f) == 0.5f);
  CHECK(bounded_inverse(1e-30f) == bounded_inverse(0.0f));
  CHECK(bounded_inverse(0.0f) == std::sqrt(std::numeric_limits<float>::max()));
  CHECK(bounded_inverse(1e30f) == 0);
  CHECK(bounded_inverse(std::ldexp(1.0, 100)) == std::ldexp(1.0, -100));
  CHECK(bounded_inverse(Rational(3)) == Rational(1) / 3);
}
// [any_size]
