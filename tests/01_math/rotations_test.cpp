/// \file
/// What holds for rotations: formulas M7, M8 and M16, and how right they are over the whole range
/// of float and double: 100,000 random inputs each, against long double, or against fractions where
/// that is not enough.

#include "01_math/rotations/rotations.hpp"
#include "01_math/rotations/trial/rotations_cases.hpp"
#include "01_math/truth/trial/whole_range.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <limits>
#include <numbers>

using namespace cookbook;

namespace
{

/// 64 bits of digits, or 53 where there are no more: what is asked of double there is asked of
/// float only.
using Long = long double;
constexpr bool long_is_longer = std::numeric_limits<Long>::digits >= 64;

template <class Real>
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

/// A quaternion of length one in the direction of another, in long double.
template <class Real>
Quaternion<Long> long_unit(const Quaternion<Real>& q)
{
  const Quaternion<Long> wide(Long(q.w()), Long(q.x()), Long(q.y()), Long(q.z()));
  return Quaternion<Long>(wide.coeffs() / std::sqrt(wide.squaredNorm()));
}

/// q v q* written out, in long double.
Matrix3<Long> long_matrix(const Quaternion<Long>& q)
{
  Matrix3<Long> r;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3<Long> v = Vector3<Long>::Unit(i), u = q.vec();
    r.col(i) = v * (q.w() * q.w() - u.dot(u)) + u * (2 * u.dot(v)) +
               Vector3<Long>(u.cross(v)) * (2 * q.w());
  }
  return r;
}

/// The largest difference of a part, in units in the last place of one; either sign of q will do.
template <class Real>
double off(const Quaternion<Real>& answer, const Quaternion<Long>& truth)
{
  const Quaternion<Long> a(Long(answer.w()), Long(answer.x()), Long(answer.y()), Long(answer.z()));
  const Long plus = (a.coeffs() - truth.coeffs()).cwiseAbs().maxCoeff();
  const Long minus = (a.coeffs() + truth.coeffs()).cwiseAbs().maxCoeff();
  return static_cast<double>(std::min(plus, minus) / Long(epsilon<Real>));
}

template <class Real, class Derived>
double off(const Matrix3<Real>& answer, const Eigen::MatrixBase<Derived>& truth)
{
  const Matrix3<Long> difference = answer.template cast<Long>() - truth;
  return static_cast<double>(difference.cwiseAbs().maxCoeff() / Long(epsilon<Real>));
}

/// Keeps the largest of what it is given; what is not a number counts as infinite.
class Worst
{
public:
  void operator()(double value) { worst_ = std::max(worst_, std::isnan(value) ? HUGE_VAL : value); }
  double value() const { return worst_; }

private:
  double worst_ = 0;
};

/// A quaternion of any size that is not zero: its parts of one size, or each of its own, or with a
/// w that is small or zero beside the others.
template <class Real>
Quaternion<Real> drawn_quaternion(WholeRange<Real>& draw)
{
  const Vector3<Real> even = draw.even_vector(), uneven = draw.vector();
  const Real size = even.cwiseAbs().maxCoeff();
  Quaternion<Real> q(size * draw.fraction(), even.x(), even.y(), even.z());
  const int kind = draw.drawn(0, 3);
  if (kind == 1)
  {
    q = Quaternion<Real>(draw.number(), uneven.x(), uneven.y(), uneven.z());
  }
  if (kind == 2)
  {
    q.w() = draw.drawn(0, 3) == 0 ? Real(0) : std::ldexp(q.w(), -draw.drawn(1, 70));
  }
  return q.coeffs().isZero(0) ? Quaternion<Real>(1, 2, 3, 4) : q;
}

template <class Real>
Quaternion<Real> rounded(const Quaternion<Long>& q)
{
  return {
      static_cast<Real>(q.w()), static_cast<Real>(q.x()), static_cast<Real>(q.y()),
      static_cast<Real>(q.z())};
}

template <class Real>
Vector3<Real> drawn_vector(WholeRange<Real>& draw)
{
  const Vector3<Real> v = draw.drawn(0, 1) == 0 ? draw.even_vector() : draw.vector();
  return v.isZero(0) ? Vector3<Real>(0, 0, 1) : v;
}

using Exact3 = Vector3<Rational>;

/// The product of quaternions in fractions, part by part, by i² = j² = k² = ijk = -1.
Quaternion<Rational> by_hand(const Quaternion<Rational>& a, const Quaternion<Rational>& b)
{
  const Exact3 u = a.vec(), v = b.vec(), w = a.w() * v + b.w() * u + u.cross(v);
  return {a.w() * b.w() - u.dot(v), w.x(), w.y(), w.z()};
}

/// All vectors of whole numbers from -most to most.
std::vector<Exact3> whole_vectors(int most)
{
  std::vector<Exact3> all;
  for (int x = -most; x <= most; ++x)
  {
    for (int y = -most; y <= most; ++y)
    {
      for (int z = -most; z <= most; ++z)
      {
        all.push_back({Rational(x), Rational(y), Rational(z)});
      }
    }
  }
  return all;
}

/// A rounding or two of numbers of size one.
constexpr double few = 5e-16;

/// Whether two matrices or quaternions agree to a rounding or two.
bool agree(const Matrix3<double>& a, const Matrix3<double>& b)
{
  return (a - b).cwiseAbs().maxCoeff() <= few;
}
bool agree(const Quaternion<double>& a, const Quaternion<double>& b)
{
  return (a.coeffs() - b.coeffs()).cwiseAbs().maxCoeff() <= few;
}

} // namespace

// [M7]
TEST_CASE("a rotation keeps every dot product and turns every right-handed trio into one", "[M7]")
{
  const Matrix3<Rational> r = rational_rotation<Rational>(1, 2, 3, 4);
  CHECK(rotation_error(r) == 0);
  CHECK(r.determinant() == 1);
  const Exact3 w(1, 2, 3);
  for (const Exact3& v : whole_vectors(1))
  {
    CHECK(Exact3(r * v).dot(Exact3(r * w)) == v.dot(w));
    CHECK(Exact3(r * v).cross(Exact3(r * w)) == r * v.cross(w));
  }
}
// [M7]

// [rotation_error]
TEST_CASE("a shear by 1/10 is 1/10 from a rotation, and a mirror is 2", "[M7]")
{
  Matrix3<Rational> sheared = Matrix3<Rational>::Identity();
  sheared(0, 1) = Rational(1, 10);
  CHECK(rotation_error(sheared) == Rational(1, 10));
  CHECK(rotation_error<Rational>(-Matrix3<Rational>::Identity()) == 2);
}
// [rotation_error]

// [M8]
TEST_CASE("a third of a turn about (1,1,1) takes x to y; the trace is 1 + 2 cos θ", "[M8]")
{
  const double third = 2 * std::numbers::pi / 3;
  Matrix3<double> cycle;
  cycle << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  CHECK(agree(rotation_about<double>({1, 1, 1}, third), cycle));
  const Vector3<double> axis(2, 3, 6); // of length 7
  for (const double angle : {-3.0, -1e-8, 0.0, 0.5, 2.0, 3.14})
  {
    const Matrix3<double> r = rotation_about(axis, angle);
    CHECK((r * axis - axis).norm() <= 20 * few);
    CHECK(std::abs(r.trace() - (1 + 2 * std::cos(angle))) <= 3 * few);
    CHECK(rotation_error(r) <= 3 * few);
  }
}
// [M8]

TEST_CASE("about the zero vector nothing turns, nor by the angle zero", "[M8]")
{
  const Matrix3<double> none = Matrix3<double>::Identity();
  CHECK(rotation_about<double>({0, 0, 0}, 2) == none);
  CHECK(rotation_about<double>({1, 2, 3}, 0) == none);
}

// [ijk]
TEST_CASE("i² = j² = k² = ijk = -1, ij = k and ji = -k; (1+i)(1+j) = 1+i+j+k")
{
  using Q = Quaternion<double>;
  const Q i(0, 1, 0, 0), j(0, 0, 1, 0), k(0, 0, 0, 1), minus(-1, 0, 0, 0);
  CHECK(product(i, i).coeffs() == minus.coeffs());
  CHECK(product(j, j).coeffs() == minus.coeffs());
  CHECK(product(k, k).coeffs() == minus.coeffs());
  CHECK(product(product(i, j), k).coeffs() == minus.coeffs());
  CHECK(product(i, j).coeffs() == k.coeffs());
  CHECK(product(j, i).coeffs() == -k.coeffs());
  CHECK(product(Q(1, 1, 0, 0), Q(1, 0, 1, 0)).coeffs() == Q(1, 1, 1, 1).coeffs());
}
// [ijk]

TEST_CASE("the product turns by the right factor first, as matrices do")
{
  const Quaternion<double> a = Quaternion<double>(1, 2, 3, 4).normalized();
  const Quaternion<double> b = Quaternion<double>(2, -1, 0, 5).normalized();
  const Vector3<double> v(1, -2, 3);
  CHECK(
      (turned_vector(product(a, b), v) - turned_vector(a, turned_vector(b, v))).norm() <= 20 * few);
  CHECK((turned_vector(a, v) - rotation_matrix(a) * v).norm() <= 20 * few);
  CHECK(agree(rotation_matrix(product(a, b)), rotation_matrix(a) * rotation_matrix(b)));
}

// [M16]
TEST_CASE("R v is q v q* divided by |q|² for 125 whole quaternions", "[M16]")
{
  const Exact3 v(1, 2, 3);
  for (const Exact3& u : whole_vectors(2))
  {
    const Quaternion<Rational> q(3, u.x(), u.y(), u.z()), conjugate(3, -u.x(), -u.y(), -u.z());
    const Exact3 turned = by_hand(by_hand(q, {0, 1, 2, 3}), conjugate).vec();
    const auto whole = [](const Rational& x) { return static_cast<int>(static_cast<double>(x)); };
    const Matrix3<Rational> r =
        rational_rotation<Rational>(3, whole(u.x()), whole(u.y()), whole(u.z()));
    CHECK(r * v == turned / (9 + u.dot(u)));
  }
}
// [M16]

// [whole_quaternions]
TEST_CASE("the whole quaternion 3 + k turns about z with cosine 4/5 and sine 3/5", "[M16]")
{
  Matrix3<Rational> expected;
  expected << Rational(4, 5), Rational(-3, 5), Rational(0), Rational(3, 5), Rational(4, 5),
      Rational(0), Rational(0), Rational(0), Rational(1);
  CHECK(rational_rotation<Rational>(3, 0, 0, 1) == expected);
  CHECK(agree(rotation_matrix<double>({3, 0, 0, 1}), expected.cast<double>()));
}

TEST_CASE("the whole quaternion 1 + i + j + k sends x to y, y to z and z to x", "[M16]")
{
  const Matrix3<Rational> r = rational_rotation<Rational>(1, 1, 1, 1);
  CHECK(r * Exact3::UnitX() == Exact3::UnitY());
  CHECK(r * Exact3::UnitY() == Exact3::UnitZ());
  CHECK(r * Exact3::UnitZ() == Exact3::UnitX());
}

TEST_CASE("the zero quaternion is no turn, and has the direction 1", "[M16]")
{
  const Quaternion<double> zero(0, 0, 0, 0);
  CHECK(unit_quaternion(zero).coeffs() == Quaternion<double>::Identity().coeffs());
  CHECK(rotation_matrix(zero) == Matrix3<double>::Identity());
}
// [whole_quaternions]

// [quaternion_of]
TEST_CASE("half turns have w = 0 and a first part above zero; others have w above zero")
{
  const auto again = [](const Quaternion<double>& q) { return quaternion_of(rotation_matrix(q)); };
  CHECK(agree(again({0, 3, 4, 0}), {0, 0.6, 0.8, 0}));
  CHECK(agree(again({0, -3, 4, 0}), {0, 0.6, -0.8, 0}));
  CHECK(agree(again({0, 0, -3, 4}), {0, 0, 0.6, -0.8}));
  CHECK(agree(again({0, 0, 0, -1}), {0, 0, 0, 1}));
  CHECK(agree(again({-1, 0, 0, 0}), {1, 0, 0, 0}));
  CHECK(agree(again({-1, 1, -1, 1}), {0.5, -0.5, 0.5, -0.5}));
}

TEST_CASE("each of the four columns is taken where its part is the largest")
{
  for (int largest = 0; largest < 4; ++largest)
  {
    // (3, 1, 1, 1) over √12, with the 3 in each place in turn.
    Eigen::Matrix<double, 4, 1> parts(1, 1, 1, 1);
    parts[largest] = 3;
    const Quaternion<double> q(parts[0], parts[1], parts[2], parts[3]);
    const Quaternion<double> column = quaternion_column<double>(rotation_matrix(q));
    // The column of 4qqᵀ holds 4 · 3 · (3, 1, 1, 1) / 12.
    CHECK(agree(column, q));
  }
}
// [quaternion_of]

// [between]
TEST_CASE("from x to y is a quarter turn about z; from a vector to its opposite, half a turn")
{
  const Vector3<double> x(1, 0, 0), y(0, 1, 0);
  const double root = std::sqrt(0.5);
  CHECK(agree(rotation_between<double>(x, y), {root, 0, 0, root}));
  CHECK(agree(rotation_between<double>(x, 5 * x), {1, 0, 0, 0}));
  CHECK(agree(rotation_between<double>(x, -x), {0, 0, 0, 1}));
  CHECK(agree(rotation_between<double>(y, -2 * y), {0, 0, 0, -1}));
  CHECK(agree(rotation_between<double>(x, {0, 0, 0}), {1, 0, 0, 0}));
  CHECK(agree(rotation_between<double>({0, 0, 0}, x), {1, 0, 0, 0}));
  // The axis is z, however little the vectors miss each other by.
  CHECK(agree(rotation_between<double>(x, {-1, 1e-12, 0}), {0.5e-12, 0, 0, 1}));
  CHECK(agree(rotation_between<double>(x, {-1, 1e-200, 0}), {0, 0, 0, 1}));
}
// [between]

// [half_turn]
TEST_CASE("half a turn apart the way leads to b as given, for 16,000 ends of any length", "[slerp]")
{
  WholeRange<double> draw;
  int other_way = 0;
  for (int i = 0; i < 16000; ++i)
  {
    // Whole numbers: b is a times a unit without w, so that a·b is zero without rounding.
    const auto whole = [&] { return static_cast<double>(draw.drawn(-50, 50)); };
    const Quaternion<double> a(whole() + 0.5, whole(), whole(), whole());
    const Quaternion<double> b = a * Quaternion<double>(0, whole(), whole() + 0.5, whole());
    other_way += slerp(a, b, 1.0).dot(b) > 0 && slerp(a, b, 0.5).dot(b) > 0 ? 0 : 1;
  }
  CHECK(other_way == 0);
}
// [half_turn]

// [slerp]
TEST_CASE("a third of the way to a quarter turn is 30°, at twice the way 180°; signs do not matter")
{
  const double degree = std::numbers::pi / 180, root = std::sqrt(0.5);
  const Quaternion<double> none(1, 0, 0, 0), quarter(root, 0, root, 0);
  const Quaternion<double> third(std::cos(15 * degree), 0, std::sin(15 * degree), 0);
  CHECK(agree(slerp(none, quarter, 1.0 / 3), third));
  CHECK(agree(slerp<double>(none, Quaternion<double>(-quarter.coeffs()), 1.0 / 3), third));
  CHECK(agree(slerp(none, quarter, 2.0), {0, 0, 1, 0}));
  CHECK(agree(slerp(none, quarter, 0.5), nlerp(none, quarter, 0.5)));
}

TEST_CASE("degenerate ways have an answer: equal, opposite, half a turn apart, zero, far beyond")
{
  const Quaternion<double> q(0.5, 0.5, -0.5, 0.5), minus(-q.coeffs()), none(1, 0, 0, 0);
  for (const double t : {-2.0, 0.0, 0.3, 1.0, 1e9})
  {
    CHECK(agree(slerp(q, q, t), q));
    CHECK(agree(slerp(q, minus, t), q));
    CHECK(agree(nlerp(q, minus, t), q));
  }
  const double root = std::sqrt(0.5);
  CHECK(agree(slerp<double>(none, {0, 0, 1, 0}, 0.5), {root, 0, root, 0}));
  CHECK(agree(slerp<double>(none, {0, 0, -1, 0}, 0.5), {root, 0, -root, 0}));
  CHECK(agree(slerp<double>({0, 0, 0, 0}, {0, 0, 3, 0}, 0.5), {root, 0, root, 0}));
  for (const double t : {0x1p52, -1e300})
  {
    CHECK(agree(slerp<double>(q, none, t), q));
    CHECK(agree(nlerp<double>(q, none, t), q));
  }
  CHECK_FALSE(agree(slerp<double>(q, none, 0.9 * 0x1p52), q));
  CHECK_FALSE(agree(nlerp<double>(q, none, 0.9 * 0x1p52), q));
}
// [slerp]

// [lock]
TEST_CASE("heading 30°, pitch 90° and roll 10° are the same turn as heading 0° and roll -20°")
{
  const double degree = std::numbers::pi / 180;
  const Matrix3<double> up = from_euler_angles<double>({30 * degree, 90 * degree, 10 * degree});
  CHECK(agree(up, from_euler_angles<double>({0, 90 * degree, -20 * degree})));
  const EulerAngles<double> angles = euler_angles(up);
  CHECK(angles.heading == 0);
  CHECK(std::abs(angles.pitch - 90 * degree) <= few);
  CHECK(std::abs(angles.roll + 20 * degree) <= few);
  const EulerAngles<double> down =
      euler_angles(from_euler_angles<double>({30 * degree, -90 * degree, 10 * degree}));
  CHECK(down.heading == 0);
  CHECK(std::abs(down.roll - 40 * degree) <= few);
}

TEST_CASE("short of the lock the three angles come back: 30°, 60° and 10°, and a pitch of 89.9°")
{
  const double degree = std::numbers::pi / 180;
  for (const double pitch : {60.0, -45.0, 89.9})
  {
    const EulerAngles<double> angles =
        euler_angles(from_euler_angles<double>({30 * degree, pitch * degree, 10 * degree}));
    CHECK(angles.heading == Catch::Approx(30 * degree).epsilon(1e-12));
    CHECK(angles.pitch == Catch::Approx(pitch * degree).epsilon(1e-12));
    CHECK(angles.roll == Catch::Approx(10 * degree).epsilon(1e-12));
  }
}
// [lock]

// [rotations_verdicts]
TEST_CASE("each way with a rotation holds or fails as the table says")
{
  const std::string first = "first written", eigen = "Eigen", ours = "this page";
  check_verdicts(
      rotation_verdicts(), rotation_ways,
      {{"matrix to quaternion: half a turn about (3, 4, 0)", {eigen, ours}},
       {"matrix to quaternion: 0.0001° short of it, about (1, 2, 2)", {eigen, ours}},
       {"matrix to quaternion: stretched by 1 %", {}},
       {"length one: (1, 2, 3, 4) · 1e-30", {ours}},
       {"length one: (1, 2, 3, 4) · 1e30", {ours}},
       {"quaternion to matrix: length 1.005", {ours}},
       {"slerp: from q to q", {eigen, ours}},
       {"slerp: from q to -q", {eigen, ours}},
       {"slerp: 1000 times a turn of 0.001", {ours}},
       {"between vectors: (1, 0, 0) to (-1, 0, 0)", {eigen, ours}},
       {"between vectors: (1, 0, 0) to (-1, 0.001, 0)", {ours}},
       {"between vectors: (0, 0, 1e-30) to (0, 1e-30, 0)", {ours}},
       {"three angles: 30, 90, 20 degrees", {first, eigen, ours}},
       {"three angles: 30, 89.99, 20 degrees", {eigen, ours}},
       {"three angles: -6, 0, 0 degrees", {first, ours}}});
}
// [rotations_verdicts]

TEMPLATE_TEST_CASE(
    "any quaternion's direction and matrix are within 1.5 and 4 ulp of one", "[M16]", float, double)
{
  REQUIRE(long_is_longer);
  WholeRange<TestType> draw;
  Worst unit, matrix;
  for (int i = 0; i < random_inputs; ++i)
  {
    const Quaternion<TestType> q = drawn_quaternion(draw);
    const Quaternion<Long> truth = long_unit(q);
    unit(off(unit_quaternion(q), truth));
    matrix(off(rotation_matrix(q), long_matrix(truth)));
  }
  CAPTURE(unit.value(), matrix.value());
  CHECK(unit.value() <= 1.5);
  CHECK(matrix.value() <= 4);
}

TEMPLATE_TEST_CASE(
    "a matrix's quaternion is within 2 ulp of one, half turns and drift included", "", float,
    double)
{
  WholeRange<TestType> draw;
  Worst error, length;
  int positive = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const Quaternion<Long> truth = long_unit(drawn_quaternion(draw));
    const Matrix3<TestType> r = long_matrix(truth).template cast<TestType>();
    const Quaternion<TestType> answer = quaternion_of(r);
    error(off(answer, truth));
    const TestType stretch = 1 + draw.fraction() / 100;
    const Quaternion<TestType> drifted = quaternion_of<TestType>(r * stretch);
    length(
        std::abs(
            static_cast<double>(long_unit(drifted).dot(Quaternion<Long>(
                Long(drifted.w()), Long(drifted.x()), Long(drifted.y()), Long(drifted.z())))) -
            1.0) /
        static_cast<double>(epsilon<TestType>));
    positive += answer.w() >= 0;
  }
  CAPTURE(error.value(), length.value());
  CHECK(error.value() <= 2);
  CHECK(length.value() <= 2);
  CHECK(positive == random_inputs);
}

TEMPLATE_TEST_CASE("slerp and nlerp are within 4 ulp of one for t from 0 to 1", "", float, double)
{
  WholeRange<TestType> draw;
  Worst constant, straight;
  for (int i = 0; i < random_inputs; ++i)
  {
    const Quaternion<TestType> a = drawn_quaternion(draw);
    Quaternion<TestType> b = drawn_quaternion(draw);
    const int kind = draw.drawn(0, 3);
    if (kind == 1) // the same, or nearly, or its opposite
    {
      const Vector3<Long> step = Vector3<Long>(draw.fraction(), draw.fraction(), draw.fraction());
      Quaternion<Long> close = long_unit(a);
      close.vec() += std::ldexp(Long(1), -draw.drawn(1, 80)) * step;
      const Long sign = draw.drawn(0, 1) == 0 ? -1 : 1;
      b = rounded<TestType>(Quaternion<Long>(sign * close.coeffs()));
    }
    const TestType t =
        draw.drawn(0, 7) == 0 ? TestType(draw.drawn(0, 1)) : std::abs(draw.fraction());
    // The weights that textbooks give, with the angle between the lines by its halves' tangent.
    const Quaternion<Long> from = long_unit(a);
    Quaternion<Long> to = long_unit(b);
    if (from.dot(to) < 0)
    {
      to.coeffs() = -to.coeffs();
    }
    const Long angle =
        2 * std::atan2((from.coeffs() - to.coeffs()).norm(), (from.coeffs() + to.coeffs()).norm());
    const Long sine = std::sin(angle), fraction = Long(t);
    const Long first = sine == 0 ? 1 - fraction : std::sin((1 - fraction) * angle) / sine;
    const Long second = sine == 0 ? fraction : std::sin(fraction * angle) / sine;
    const Quaternion<Long> right(from.coeffs() * first + to.coeffs() * second);
    const Quaternion<Long> line(from.coeffs() * (1 - fraction) + to.coeffs() * fraction);
    // Where both ways are equally short, rounding may choose the other one.
    if (from.dot(to) > 8 * Long(epsilon<TestType>))
    {
      constant(off(slerp(a, b, t), right));
      straight(off(nlerp(a, b, t), long_unit(line)));
    }
  }
  CAPTURE(constant.value(), straight.value());
  CHECK(constant.value() <= 4);
  CHECK(straight.value() <= 4);
}

TEMPLATE_TEST_CASE(
    "beyond its ends slerp goes on, right to (5 + 4 |t|) ulp up to t = 1000", "", float, double)
{
  WholeRange<TestType> draw;
  Worst error;
  for (int i = 0; i < random_inputs; ++i)
  {
    const Quaternion<TestType> a = drawn_quaternion(draw), b = drawn_quaternion(draw);
    const TestType t = 1000 * draw.fraction();
    const Quaternion<Long> from = long_unit(a);
    // The turn from a to b, as an axis and an angle; a fraction of it, put before a.
    Quaternion<Long> turn = long_unit(b) * from.conjugate();
    const Long sign = turn.w() < 0 ? -1 : 1, sine = turn.vec().norm();
    if (std::abs(turn.w()) <= 8 * Long(epsilon<TestType>) || sine == 0)
    {
      continue;
    }
    const Long half = std::atan2(sine, std::abs(turn.w())) * Long(t);
    Quaternion<Long> part(std::cos(half), 0, 0, 0);
    part.vec() = turn.vec() * (sign * std::sin(half) / sine);
    error(off(slerp(a, b, t), part * from) / (5 + 4 * std::abs(static_cast<double>(t))));
  }
  CAPTURE(error.value());
  CHECK(error.value() <= 1);
}

TEMPLATE_TEST_CASE(
    "the rotation between any two vectors turns one into the other within 8 ulp", "", float, double)
{
  WholeRange<TestType> draw;
  Worst error, askew, length;
  for (int i = 0; i < random_inputs; ++i)
  {
    const Vector3<TestType> from = drawn_vector(draw);
    Vector3<TestType> to = drawn_vector(draw);
    const int kind = draw.drawn(0, 3);
    if (kind <= 1) // nearly along, or nearly opposite
    {
      to = kind == 0 ? from : Vector3<TestType>(-from);
      to += to.cwiseAbs().maxCoeff() * std::ldexp(TestType(1), -draw.drawn(2, 60)) *
            Vector3<TestType>(draw.fraction(), draw.fraction(), draw.fraction());
    }
    if (to.isZero(0) || !to.allFinite())
    {
      continue;
    }
    const Quaternion<TestType> answer = rotation_between(from, to);
    const Quaternion<Long> q = long_unit(answer);
    const Vector3<Long> a = from.template cast<Long>().normalized();
    const Vector3<Long> b = to.template cast<Long>().normalized();
    error(static_cast<double>((long_matrix(q) * a - b).norm() / Long(epsilon<TestType>)));
    askew(static_cast<double>(std::abs(q.vec().dot(a)) / Long(epsilon<TestType>)));
    length(off(answer, q));
    CHECK(answer.w() >= 0);
  }
  CAPTURE(error.value(), askew.value(), length.value());
  CHECK(error.value() <= 8);
  CHECK(askew.value() <= 4);
  CHECK(length.value() <= 2);
}

TEST_CASE("between nearly opposite vectors the axis is the exact cross product's, within 4 ulp")
{
  WholeRange<double> draw;
  Worst error;
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3<double> from = drawn_vector(draw);
    Vector3<double> to = -from;
    for (double& part : to) // each part a few ulps off, or half of them
    {
      part *= 1 + std::ldexp(draw.fraction(), -draw.drawn(30, 52));
    }
    if (!to.allFinite())
    {
      continue;
    }
    const Vector3<Rational> cross = exact<Rational>(from).cross(exact<Rational>(to));
    const Rational size = Rational(from.cwiseAbs().maxCoeff()) * Rational(to.cwiseAbs().maxCoeff());
    if (Rational(cross.cwiseAbs().maxCoeff()) <= size * Rational(1e-300))
    {
      continue;
    }
    // The largest part made one, so that long double can hold it.
    const Vector3<Rational> shrunk = cross / Rational(cross.cwiseAbs().maxCoeff());
    const Vector3<Long> axis =
        Vector3<Long>(Long(shrunk.x()), Long(shrunk.y()), Long(shrunk.z())).normalized();
    const Vector3<Long> answer = rotation_between(from, to).vec().cast<Long>().normalized();
    error(static_cast<double>((answer - axis).norm()) / epsilon<double>);
  }
  CAPTURE(error.value());
  CHECK(error.value() <= 4);
}

TEMPLATE_TEST_CASE("any angle about any axis gives the matrix within 6 ulp", "[M8]", float, double)
{
  WholeRange<TestType> draw;
  Worst error;
  for (int i = 0; i < random_inputs; ++i)
  {
    const Vector3<TestType> axis = drawn_vector(draw);
    const TestType angle = draw.drawn(0, 1) == 0 ? draw.number() : 7 * draw.fraction();
    const Vector3<Long> k = axis.template cast<Long>().normalized();
    Quaternion<Long> q(std::cos(Long(angle) / 2), 0, 0, 0);
    q.vec() = k * std::sin(Long(angle) / 2);
    error(off(rotation_about(axis, angle), long_matrix(q)));
  }
  CAPTURE(error.value());
  CHECK(error.value() <= 6);
}

TEMPLATE_TEST_CASE(
    "three angles give their matrix again within 9 ulp, however near the lock", "", float, double)
{
  WholeRange<TestType> draw;
  Worst back, there;
  for (int i = 0; i < random_inputs; ++i)
  {
    Quaternion<Long> q = long_unit(drawn_quaternion(draw));
    if (draw.drawn(0, 1) == 0) // nose up or down, or nearly
    {
      const Long pitch = draw.drawn(0, 1) == 0 ? 1 : -1;
      const Long close = pitch * (std::numbers::pi_v<Long> / 2 -
                                  std::ldexp(Long(draw.fraction()), -draw.drawn(0, 70)));
      const Quaternion<Long> heading(q.w(), 0, q.y(), 0), roll(q.x(), 0, 0, q.z());
      if (heading.squaredNorm() == 0 || roll.squaredNorm() == 0)
      {
        continue;
      }
      const Quaternion<Long> up(std::cos(close / 2), std::sin(close / 2), 0, 0);
      q = long_unit(heading) * up * long_unit(roll);
    }
    const Matrix3<TestType> r = long_matrix(q).template cast<TestType>();
    const EulerAngles<TestType> angles = euler_angles(r);
    // The nine entries by hand, in long double.
    const Long sh = std::sin(Long(angles.heading)), ch = std::cos(Long(angles.heading));
    const Long sp = std::sin(Long(angles.pitch)), cp = std::cos(Long(angles.pitch));
    const Long sr = std::sin(Long(angles.roll)), cr = std::cos(Long(angles.roll));
    Matrix3<Long> again;
    again << ch * cr + sh * sp * sr, sh * sp * cr - ch * sr, sh * cp, //
        cp * sr, cp * cr, -sp,                                        //
        ch * sp * sr - sh * cr, sh * sr + ch * sp * cr, ch * cp;
    back(off(r, again));
    there(off(from_euler_angles(angles), again));
    CHECK(std::abs(angles.pitch) <= std::numbers::pi_v<TestType> / 2 + epsilon<TestType>);
  }
  CAPTURE(back.value(), there.value());
  CHECK(back.value() <= 9);
  CHECK(there.value() <= 6);
}

TEST_CASE("a fraction that is not a number leads nowhere", "[M16]")
{
  const Quaternion<double> a(1, 0, 0, 0), b(0, 1, 0, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(slerp<double>(a, b, nan).coeffs().hasNaN());
  CHECK(nlerp<double>(a, b, nan).coeffs().hasNaN());
}
