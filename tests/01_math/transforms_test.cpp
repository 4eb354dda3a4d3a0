/// \file
/// What holds for points, normals and planes through a transform: formulas M14 and M15.

#include "01_math/matrices/trial/matrix_instances.hpp"
#include "01_math/transforms/transforms.hpp"
#include "01_math/transforms/trial/transforms_verdicts.hpp"
#include "01_math/truth/trial/whole_range.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <limits>
#include <numbers>

using namespace cookbook;

namespace
{

using Exact3 = Vector3<Rational>;

/// A matrix with fractions that no rounding has touched: a turn, a shear and a scale.
inline Matrix3<Rational> bent()
{
  Matrix3<Rational> m = rational_rotation<Rational>(1, 2, 3, 4);
  m.col(0) *= Rational(3);
  m.col(2) += m.col(1) / Rational(2);
  return m;
}

/// A double transform from its matrix and its move.
inline Affine3<double> transform(const Matrix3<double>& m, const Vector3<double>& move)
{
  Affine3<double> t = Affine3<double>::Identity();
  t.linear() = m;
  t.translation() = move;
  return t;
}

} // namespace

// [M14]
TEST_CASE(
    "Scale(1,1,4) and a move by 5 carry the plane x + 2y + 2z = 6 to 2x + 4y + z = 22", "[M14]")
{
  // z = z' / 4 and x = x' - 5 in the plane's equation, times two.
  const Affine3<double> t =
      transform(Vector3<double>(1, 1, 4).asDiagonal(), Vector3<double>(5, 0, 0));
  const Hyperplane3<double> plane(Vector3<double>(1, 2, 2) / 3, -2);
  const Hyperplane3<double> carried = transformed_plane<double>(t, plane);
  const double length = std::sqrt(4.0 + 16 + 1);
  // Each component and the distance have fewer than eight roundings.
  const Vector3<double> expected = Vector3<double>(2, 4, 1) / length;
  CHECK((carried.normal() - expected).cwiseAbs().maxCoeff() <= 8 * 0x1p-53);
  CHECK(std::abs(-carried.offset() - 22 / length) <= 8 * 8 * 0x1p-53);
}
// [M14]

// [M14_exact]
TEST_CASE("n' = M⁻ᵀ n and d' = d + n'·t hold for the images of points of a plane, exactly", "[M14]")
{
  const Matrix3<Rational> m = bent();
  const Matrix3<Rational> back = adjugate_inverse<Rational, 3>(m);
  const Exact3 move(5, -1, 2), n(2, 1, 2);
  const Exact3 carried_n = back.transpose() * n;
  const Rational carried_d = 6 + carried_n.dot(move);
  for (const Exact3& point : {Exact3(3, 0, 0), Exact3(0, 6, 0), Exact3(1, 2, 1)})
  {
    REQUIRE(n.dot(point) == 6);
    CHECK(carried_n.dot(m * point + move) == carried_d);
  }
  // For a rotation the inverse transpose is the rotation itself.
  const Matrix3<Rational> r = rational_rotation<Rational>(1, 2, 3, 4);
  CHECK(adjugate_inverse<Rational, 3>(r).transpose() == r);
  // By cofactors, the same direction: the determinant is a number.
  const Rational determinant = m.col(0).dot(cofactors<Rational>(m).col(0));
  CHECK(cofactors<Rational>(m) * n == Exact3(carried_n * determinant));
}
// [M14_exact]

// [M15]
TEST_CASE("the inverse of (R, t) is (Rᵀ, -Rᵀ t), exactly, for a turn by 3-4-5", "[M15]")
{
  const Matrix3<Rational> r = rational_rotation<Rational>(3, 0, 0, 1);
  const Exact3 t(5, -1, 2), p(1, 2, 3);
  const Exact3 world = r * p + t;
  CHECK(world == Exact3(Rational(23, 5), Rational(6, 5), 5));
  CHECK(r.transpose() * world - r.transpose() * t == p);
}

TEST_CASE("a quarter turn about z and a move by (5,-1,2), and back", "[M15]")
{
  Matrix3<double> quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Isometry3<double> there = pose<double>(quarter, {5, -1, 2});
  const Isometry3<double> back = rigid_inverse<double>(there);
  CHECK(there * Vector3<double>(1, 2, 3) == Vector3<double>(3, 0, 5));
  CHECK(back * Vector3<double>(3, 0, 5) == Vector3<double>(1, 2, 3));
  CHECK(back.translation() == Vector3<double>(1, 5, -2));
  CHECK(to_local<double>(there, Vector3<double>(3, 0, 5)) == Vector3<double>(1, 2, 3));
  CHECK((there * back).matrix() == Matrix4<double>::Identity());
}
// [M15]

// [order]
TEST_CASE("turn, then move by 2: (1,0) goes to (2,1); move, then turn: to (0,3)", "[M15]")
{
  Matrix3<double> quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Isometry3<double> turn = pose<double>(quarter, {0, 0, 0});
  const Isometry3<double> move = pose<double>(Matrix3<double>::Identity(), {2, 0, 0});
  const Vector3<double> p(1, 0, 0);
  // What stands next to the point comes first.
  CHECK(move * turn * p == Vector3<double>(2, 1, 0));
  CHECK(turn * move * p == Vector3<double>(0, 3, 0));
  CHECK((move * turn).matrix() == pose<double>(quarter, {2, 0, 0}).matrix());
}
// [order]

// [points_and_vectors]
TEST_CASE("a move moves points but no vectors", "[M15]")
{
  const Isometry3<double> move = pose<double>(Matrix3<double>::Identity(), {2, 0, 0});
  const Vector3<double> from(1, 1, 0), to(4, 5, 0), step = to - from;
  CHECK(move * to - move * from == step);
  CHECK(move.linear() * step == step);
  CHECK(move * step != step); // a vector taken for a point
}
// [points_and_vectors]

// [affine_inverse]
TEST_CASE("Isometry3's inverse of a scale by 2 is no inverse; Affine3's is", "[M15]")
{
  Affine3<double> twice = Affine3<double>::Identity();
  twice.linear() *= 2;
  twice.translation() = Vector3<double>(1, 0, 0);
  const Vector3<double> p(3, 4, 5);
  CHECK(twice.inverse() * (twice * p) == p);
  CHECK(twice.inverse(Eigen::Isometry) * (twice * p) == 4 * p);
  CHECK(*to_local<double>(twice, Vector3<double>(twice * p)) == p);
  twice.linear().col(0).setZero();
  CHECK_FALSE(to_local<double>(twice, p).has_value());
}
// [affine_inverse]

// [conventions]
TEST_CASE("row vectors: the matrix is transposed, and products read from left to right", "[M15]")
{
  Matrix4<double> a = Matrix4<double>::Identity(), b = a;
  a(0, 3) = 5;
  b.topLeftCorner<2, 2>() << 0, -1, 1, 0;
  const Vector<double, 4> p(1, 2, 3, 1);
  const auto rows = [](const Matrix4<double>& m) { return rows_and_columns_exchanged<double>(m); };
  const Eigen::RowVector4d left_to_right = p.transpose() * rows(b) * rows(a);
  CHECK(left_to_right.transpose() == a * b * p);
}

TEST_CASE("columns stored by columns are the same 16 numbers as rows stored by rows", "[M15]")
{
  Matrix4<double> m;
  m << 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 1;
  using ByRows = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  const ByRows for_row_vectors = rows_and_columns_exchanged<double>(m);
  CHECK(std::equal(m.data(), m.data() + 16, for_row_vectors.data()));
  CHECK(m.data()[1] == 5); // Eigen stores columns one after the other
}

TEST_CASE(
    "left-handed: the third axis is turned round, and a turn about x turns the other way", "[M15]")
{
  Matrix4<double> quarter_about_x = Matrix4<double>::Identity();
  quarter_about_x.block<2, 2>(1, 1) << 0, -1, 1, 0;
  Matrix4<double> moved = quarter_about_x;
  moved(2, 3) = 7;
  const Matrix4<double> other = hand_exchanged<double>(moved);
  CHECK(other(2, 3) == -7);
  CHECK(other.block<3, 3>(0, 0) == quarter_about_x.block<3, 3>(0, 0).transpose());
  CHECK(hand_exchanged<double>(other) == moved);
  // The same point, with its third coordinate turned round, goes to the same place.
  const Vector<double, 4> p(1, 2, 3, 1), flipped(1, 2, -3, 1);
  const Vector<double, 4> there = moved * p, there_flipped = other * flipped;
  CHECK(there_flipped == Vector<double, 4>(there[0], there[1], -there[2], 1));
}

TEST_CASE("z up: up is (0,0,1) there and (0,1,0) here, and x stays", "[M15]")
{
  const Matrix3<double> m = y_up_from_z_up<double>();
  CHECK(m * Vector3<double>(0, 0, 1) == Vector3<double>(0, 1, 0));
  CHECK(m * Vector3<double>(1, 0, 0) == Vector3<double>(1, 0, 0));
  CHECK(m * Vector3<double>(0, 1, 0) == Vector3<double>(0, 0, -1));
  CHECK(rotation_error(m) == 0); // no mirror: both are right-handed
}

TEST_CASE("degrees: 180 are π, and the sine of 30 without a conversion is -0.988", "[M15]")
{
  CHECK(std::sin(30 * std::numbers::pi / 180) == Catch::Approx(0.5).epsilon(1e-15));
  CHECK(std::sin(30.0) == Catch::Approx(-0.988).epsilon(1e-3));
}

TEST_CASE("quaternions: Eigen takes w first and stores it last", "[M15]")
{
  const Quaternion<double> q(1, 2, 3, 4);
  CHECK(q.w() == 1);
  CHECK(q.coeffs() == Vector<double, 4>(2, 3, 4, 1));
}
// [conventions]

// [degenerate]
TEMPLATE_TEST_CASE(
    "a normal after a flattening, a line, a mirror, and of no length", "[M14]", float, double)
{
  using V = Vector3<TestType>;
  const auto after = [](TestType x, TestType y, TestType z, const V& n)
  { return transformed_normal<TestType>(V(x, y, z).asDiagonal(), n); };
  CHECK(after(1, 1, 0, {1, 2, 2}) == V(0, 0, 1));
  CHECK(after(1, 1, 0, {1, 2, -2}) == V(0, 0, -1));
  CHECK(after(1, 0, 0, {1, 2, 2}) == V(0, 1, 0));
  CHECK(after(-1, 1, 1, {1, 0, 0}) == V(-1, 0, 0));
  CHECK(after(-1, 0, 1, {0, 1, 0}) == V(0, -1, 0)); // neither side is better
  CHECK(after(2, 3, 4, {0, 0, 0}) == V(0, 1, 0));
  const TestType tiny = std::numeric_limits<TestType>::denorm_min();
  CHECK(after(tiny, tiny, -tiny, {0, 0, tiny}) == V(0, 0, -1));
  const TestType huge = std::numeric_limits<TestType>::max();
  CHECK(after(huge, huge, huge, {0, huge, 0}) == V(0, 1, 0));
}
// [degenerate]

TEST_CASE(
    "a normal of tiny and huge parts beside one of zero, wherever that is, keeps its direction",
    "[M14]")
{
  using V = Vector3<double>;
  for (const int power : {-600, 0, 600})
  {
    for (int zero = 0; zero < 3; ++zero)
    {
      // Cofactors are products of the two other scales: one is 2⁴⁰ times the other.
      const int one = (zero + 1) % 3, other = (zero + 2) % 3;
      V scale, normal, expected;
      scale[zero] = scale[one] = std::ldexp(1.0, power);
      scale[other] = std::ldexp(1.0, power - 40);
      normal[zero] = expected[zero] = 0;
      normal[one] = normal[other] = 1;
      expected[one] = 0x1p-40;
      expected[other] = 1;
      CAPTURE(power, zero);
      const V after = transformed_normal<double>(scale.asDiagonal(), normal);
      CHECK((after - expected).cwiseAbs().maxCoeff() <= 0x1p-52);
    }
  }
}

TEST_CASE("there is no way back through a scale of 1e-310, whose inverse does not fit", "[M15]")
{
  const Affine3<double> t = transform(1e-310 * Matrix3<double>::Identity(), {1, 2, 3});
  CHECK_FALSE(to_local<double>(t, {1, 2, 3}).has_value());
}

TEST_CASE("each way to carry a plane along holds or fails as the table says", "[case:X35]")
{
  const std::vector<std::string> three{"n by M", "Eigen's transform", "recommended"};
  const std::vector<std::string> two{"Eigen's transform", "recommended"};
  check_verdicts(
      plane_verdicts(), plane_names(),
      {{"X35", three},
       {"turned about z", {"as published", "n by M", "Eigen's transform", "recommended"}},
       {"turned, then moved", three},
       {"Scale(2, 2, 2)", three},
       {"Scale(1, 1, 4)", two},
       {"sheared along x", two},
       {"mirrored in x", three},
       {"Scale(1e-20)", {"n by M", "recommended"}},
       {"flattened to z = 0", {"recommended"}}});
}

TEST_CASE("each way to a body's frame holds or fails as the table says", "[M15]")
{
  const std::string isometry = "Isometry3::inverse()", general = "Affine3::inverse()";
  const std::string rigid = "Rᵀ(p − t)", best = "M⁻¹(p − t)";
  check_verdicts(
      local_verdicts(), local_names(),
      {{"a pose near the origin", {isometry, general, rigid, best}},
       {"a pose 4,000 km away", {rigid, best}},
       {"a turn that has grown by 1 %", {general, best}},
       {"a turn that has sheared by 1 %", {general, best}},
       {"a turn and Scale(1e-15)", {best}},
       {"grown by 1 %, 4,000 km away", {best}}});
}

// [plain_normal]
TEST_CASE(
    "1,000 ordinary normals by plain cofactors and by ours agree; by Scale(1e-170) only ours",
    "[M14]")
{
  WholeRange<double> draw;
  for (int i = 0; i < 1000; ++i)
  {
    const Matrix3<double> bent = Matrix3<double>::NullaryExpr([&] { return draw.fraction() / 4; });
    const Matrix3<double> m = Matrix3<double>::Identity() + bent;
    const Vector3<double> n = Vector3<double>(draw.fraction(), draw.fraction(), 1);
    CHECK((plain::transformed_normal(m, n) - transformed_normal(m, n)).norm() < 1e-14);
  }
  const Matrix3<double> tiny = 1e-170 * Matrix3<double>::Identity();
  const Vector3<double> x(1, 0, 0);
  CHECK(plain::transformed_normal(tiny, x) == Vector3<double>(0, 1, 0));
  CHECK((transformed_normal(tiny, x) - x).norm() < 1e-15);
}
// [plain_normal]
