/// \file
/// The plain formulas on rotations: by hand, against those for any size, and where they fail.

#include "01_math/plain_rotations/plain_rotations.hpp"
#include "01_math/rotations/rotations.hpp"
#include "01_math/turning/turning.hpp"
#include "tests/catch.hpp"

#include <random>

using namespace cookbook;
using Catch::Approx;

namespace
{

using D = Vector3<double>;
using Q = Quaternion<double>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
const double pi = std::acos(-1.0);

struct Turns
{
  std::mt19937 random{57};

  double fraction() { return static_cast<double>(random()) * 0x1p-31 - 1; }
  D vector() { return {fraction(), fraction(), fraction()}; }
  Q turn() { return Q(fraction(), fraction(), fraction(), fraction()).normalized(); }
};

double distance(const Q& a, const Q& b)
{
  return (a.coeffs() - b.coeffs()).norm();
}

} // namespace

TEST_CASE("a third of a turn about (1,1,1) sends x to y, y to z and z to x", "[M8][M16]")
{
  const D k = D(1, 1, 1) / std::sqrt(3.0);
  const Q q = plain::quaternion_about(k, 2 * pi / 3);
  CHECK(distance(q, Q(0.5, 0.5, 0.5, 0.5)) < 4 * epsilon);
  for (int axis = 0; axis < 3; ++axis)
  {
    const D from = D::Unit(axis), to = D::Unit((axis + 1) % 3);
    CHECK((plain::rotated<double>(from, k, 2 * pi / 3) - to).norm() < 4 * epsilon);
    CHECK((turned_vector(q, from) - to).norm() < 4 * epsilon);
  }
}

// [axis_and_angle]
TEST_CASE(
    "axis and angle come back from the quaternion and its negative; no turn is 0 about +y", "[M16]")
{
  const D k = D(2, -3, 6) / 7;
  const Q q = plain::quaternion_about(k, 1.25);
  for (const Q& one : {q, Q(-q.coeffs())})
  {
    const plain::AxisAngle<double> turn = plain::axis_and_angle(one);
    CHECK(turn.angle == Approx(1.25));
    CHECK((turn.axis - k).norm() < 4 * epsilon);
  }
  CHECK(plain::axis_and_angle(Q(0, 0, 0, 1)).angle == Approx(pi));
  CHECK(plain::axis_and_angle(Q(1, 0, 0, 0)).angle == 0);
  CHECK(plain::axis_and_angle(Q(1, 0, 0, 0)).axis == D(0, 1, 0));
}
// [axis_and_angle]

// [bases]
TEST_CASE(
    "columns (2,0,0), (1,3,0) become x, y and z; 10,000 drifted rotations become rotations", "[M7]")
{
  Matrix3<double> m;
  m << 2, 1, 5, 0, 3, 5, 0, 0, 5;
  CHECK(plain::orthonormalize(m) == Matrix3<double>::Identity());
  Turns turns;
  double worst = 0, moved = 0;
  for (int i = 0; i < 10000; ++i)
  {
    const Matrix3<double> right = turns.turn().toRotationMatrix();
    const Matrix3<double> drifted =
        right + 1e-6 * Matrix3<double>::NullaryExpr([&] { return turns.fraction(); });
    const Matrix3<double> r = plain::orthonormalize(drifted);
    worst = std::max(worst, rotation_error(r));
    moved = std::max(moved, (r - right).norm());
  }
  CHECK(
      worst <
      8 * epsilon); // a unit vector is off by 3 u, its square by 6 u, and the check rounds 3 times
  CHECK(moved < 1e-5);
}

TEST_CASE("a zero, flat, mirrored or nearly parallel matrix still becomes a rotation", "[M7]")
{
  Matrix3<double> flat, parallel = Matrix3<double>::Identity();
  flat << 1, 2, 3, 1, 2, 3, 1, 2, 3;
  parallel.col(1) << 1, 1e-12, 0;
  for (const Matrix3<double>& m :
       {Matrix3<double>(Matrix3<double>::Zero()), flat, parallel, Matrix3<double>(-parallel)})
  {
    CHECK(rotation_error(plain::orthonormalize(m)) < 8 * epsilon);
  }
}

TEST_CASE("the basis of a normal is a rotation with the normal for its third column", "[M7]")
{
  Turns turns;
  double worst = 0, off = 0;
  for (int i = 0; i < 10000; ++i)
  {
    const D n = 1 + i % 6 < 4 ? turns.vector() : D(D::Unit(i % 3));
    const Matrix3<double> basis = plain::basis_from_normal(n);
    worst = std::max(worst, rotation_error(basis));
    off = std::max(off, (basis.col(2) - n.normalized()).norm());
  }
  CHECK(worst < 8 * epsilon);
  CHECK(off < 4 * epsilon);
  CHECK(plain::basis_from_normal<double>(D(0, 0, 0)).col(2) == D(0, 1, 0));
}
// [bases]

TEST_CASE(
    "slerp a third of the way to a quarter turn is 30°, whatever the sign; equal ends stay",
    "[slerp]")
{
  const Q a(1, 0, 0, 0), b = plain::quaternion_about<double>(D(0, 1, 0), pi / 2);
  const Q right = plain::quaternion_about<double>(D(0, 1, 0), pi / 6);
  CHECK(distance(plain::slerp(a, b, 1.0 / 3), right) < 4 * epsilon);
  CHECK(distance(plain::slerp(a, Q(-b.coeffs()), 1.0 / 3), right) < 4 * epsilon);
  CHECK(distance(plain::slerp(b, b, 0.7), b) < 4 * epsilon);
}

// [room_and_beyond]
TEST_CASE(
    "for 10,000 turns of a radian and more the plain rotations and those for any input agree",
    "[M8][M9]")
{
  Turns turns;
  int apart = 0, compared = 0;
  for (int i = 0; i < 10000; ++i)
  {
    const D v = turns.vector(), k = turns.vector().normalized(), spin = 9 * turns.vector();
    const Q a = turns.turn(), b = turns.turn();
    const double angle = 4 * turns.fraction(), t = std::abs(turns.fraction()),
                 cosine = std::abs(a.dot(b));
    apart +=
        (plain::rotated(v, k, angle) - rotation_about(k, angle) * v).norm() < 8 * epsilon ? 0 : 1;
    apart +=
        distance(plain::turned_by(a, spin, 0.1), turned_by(a, spin, 0.1)) < 8 * epsilon ? 0 : 1;
    if (cosine > 0.1 && cosine < 0.9)
    {
      ++compared;
      apart += distance(plain::slerp(a, b, t), slerp(a, b, t)) < 16 * epsilon ? 0 : 1;
    }
  }
  CHECK(apart == 0);
  CHECK(compared > 5000);
}

TEST_CASE(
    "plain slerp stands still for a small angle, plain turns lose tiny quaternions; ours do not",
    "[M9]")
{
  // By 0.0002 rad: its half has the cosine 1 in float, so that plain slerp finds no way at all.
  const Quaternion<float> a(1, 0, 0, 0), b(1, 1e-4f, 0, 0);
  CHECK(plain::slerp(a, b, 0.5f).x() == 0);
  CHECK(slerp(a, b, 0.5f).x() == Approx(5e-5));

  const Quaternion<float> tiny(1e-25f, 0, 0, 0);
  const Vector3<float> spin(0, 0, 0);
  CHECK_FALSE(std::abs(plain::turned_by<float>(tiny, spin, 1).norm() - 1) < 1e-6f);
  CHECK(turned_by<float>(tiny, spin, 1).w() == Approx(1));
}
// [room_and_beyond]
