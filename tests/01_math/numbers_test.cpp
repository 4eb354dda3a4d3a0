/// \file
/// What holds for rounding, comparisons, products, intervals and angles: formula M6, and the
/// numbers that break a way.

#include "01_math/numbers/numbers.hpp"
#include "01_math/numbers/quadratic_roots.hpp"
#include "01_math/numbers/trial/compare_cases.hpp"
#include "01_math/numbers/trial/numbers_figures.hpp"
#include "01_math/numbers/trial/product_cases.hpp"
#include "01_math/numbers/trial/whole_numbers.hpp"
#include "01_math/numbers/trial/wrap_cases.hpp"
#include "01_math/truth/trial/whole_range.hpp"
#include "common/math/ulp.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/verdicts.hpp"

#include <limits>

using namespace cookbook;
using Catch::Approx;

namespace
{

/// A dot product without rounding, times 4^digits.
template <class Real, int Size>
Whole exact_dot(const Vector<Real, Size>& a, const Vector<Real, Size>& b)
{
  Whole sum = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i)
  {
    sum += whole(a[i]) * whole(b[i]);
  }
  return sum;
}

/// A vector of a hundred numbers from -1 to 1.
template <class Real>
Vector<Real, 100> hundred(WholeRange<Real>& draw)
{
  return Vector<Real, 100>::NullaryExpr([&](Eigen::Index) { return draw.fraction(); });
}

/// Whether |a·b − its exact value| ≤ γₙ|a|ᵀ|b|, without rounding: γₙ = n/(2^digits − n).
template <class Real, int Size>
bool is_within_gamma(const Vector<Real, Size>& a, const Vector<Real, Size>& b)
{
  const Whole computed = whole(a.dot(b)) << all_digits<Real>();
  const Whole error = abs(computed - exact_dot<Real, Size>(a, b));
  const Whole sizes = exact_dot<Real, Size>(a.cwiseAbs(), b.cwiseAbs());
  const int n = static_cast<int>(a.size());
  return error * (power_of_two(std::numeric_limits<Real>::digits) - n) <= sizes * n;
}

} // namespace

// [tenth]
TEST_CASE("0.1 as a float is 13421773 / 2^27, which is a tenth and a tenth of 2^-26", "[rounding]")
{
  const Rational tenth = exact<Rational>(0.1f);
  CHECK(tenth == Rational(13421773, 134217728));
  CHECK(tenth - Rational(1, 10) == Rational(1, 671088640)); // 1.5e-9
}
// [tenth]

// [small_float]
TEST_CASE(
    "a float of three digits has 3/32 and 1/8 next to 0.1, and gaps that double", "[rounding]")
{
  const std::vector<double> all = small_floats(4);
  REQUIRE(all.size() == 25);
  CHECK(std::count(all.begin(), all.end(), 0.09375) == 1);
  CHECK(all[4] == 0.125);
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    // Below 1/4 the gap is 1/32, from then on a quarter of the power of two at or below.
    const double power = std::max(0.125, std::exp2(std::floor(std::log2(all[i - 1]))));
    CHECK(all[i] - all[i - 1] == power / 4);
  }
}
// [small_float]

// [model]
TEMPLATE_TEST_CASE(
    "each sum, product and quotient is the exact one times 1 + δ, |δ| ≤ u", "[rounding]", float,
    double)
{
  CHECK(unit_roundoff<TestType>() == ulp(TestType(1)) / 2);
  WholeRange<TestType> draw;
  const Rational u = exact<Rational>(unit_roundoff<TestType>());
  for (int i = 0; i < 1000; ++i)
  {
    const TestType a = TestType(2) + draw.fraction(), b = TestType(4) + draw.fraction();
    const Rational x = exact<Rational>(a), y = exact<Rational>(b);
    CHECK(abs(exact<Rational>(a + b) - (x + y)) <= u * (x + y));
    CHECK(abs(exact<Rational>(a * b) - x * y) <= u * x * y);
    CHECK(abs(exact<Rational>(a / b) - x / y) <= u * x / y);
  }
}
// [model]

// [exact_difference]
TEMPLATE_TEST_CASE(
    "two numbers within a factor of two of each other have an exact difference", "[rounding]",
    float, double)
{
  WholeRange<TestType> draw;
  int wrong = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const TestType a = std::abs(draw.number());
    const TestType b = a + a * draw.fraction() / 2;
    if (b <= 2 * a && a <= 2 * b && std::isfinite(b))
    {
      wrong += whole(a - b) == whole(a) - whole(b) ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
}
// [exact_difference]

// [M6]
TEMPLATE_TEST_CASE(
    "a dot product of 3, or of 100 components is within γ₃, or γ₁₀₀ of |a|ᵀ|b|", "[M6]", float,
    double)
{
  WholeRange<TestType> draw;
  int wrong = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const Vector3<TestType> a(draw.fraction(), draw.fraction(), draw.fraction());
    const Vector3<TestType> b(draw.fraction(), draw.fraction(), draw.fraction());
    wrong += is_within_gamma<TestType, 3>(a, b) ? 0 : 1;
  }
  for (int i = 0; i < 1000; ++i)
  {
    const Vector<TestType, 100> a = hundred(draw), b = hundred(draw);
    wrong += is_within_gamma<TestType, 100>(a, b) ? 0 : 1;
  }
  CHECK(wrong == 0);
}
// [M6]

TEST_CASE("γ₃ in float is 3 / (2^24 − 3), and 2^24 roundings have no bound", "[M6]")
{
  CHECK(rounding_bound<float>(0) == 0);
  const double third = 3.0 / 16777213;
  CHECK(std::abs(static_cast<double>(rounding_bound<float>(3)) - third) <= third * 0x1p-23);
  CHECK(rounding_bound<double>(1 << 20) == 1 / (0x1p33 - 1));
  CHECK(std::isinf(rounding_bound<float>(1 << 24)));
  CHECK(std::isinf(rounding_bound<float>((1 << 24) + (1 << 22))));
  CHECK(rounding_bound<float>(1 << 23) == 1);
  CHECK(rounding_error<float>(0, 3) == 3 * std::numeric_limits<float>::denorm_min());
  CHECK(rounding_error<float>(2, 3) == 2 * rounding_bound<float>(3));
}

// [bounded_dot]
TEMPLATE_TEST_CASE(
    "a dot product of 100,000 pairs of any size is within its own bound", "[M6]", float, double)
{
  using Limits = std::numeric_limits<TestType>;
  constexpr int digits = all_digits<TestType>();
  WholeRange<TestType> draw;
  int wrong = 0, unknown = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const bool even = i % 2 == 0;
    const Vector3<TestType> a = even ? draw.even_vector() : draw.vector();
    const Vector3<TestType> b = even ? draw.even_vector() : draw.vector();
    const Bounded<TestType> dot = bounded_dot(a, b);
    const Whole truth = exact_dot<TestType, 3>(a, b);
    if (std::isfinite(dot.value) && std::isfinite(dot.error))
    {
      const Whole error = abs((whole(dot.value) << digits) - truth);
      const Whole sizes = exact_dot<TestType, 3>(a.cwiseAbs(), b.cwiseAbs());
      const Whole allowed =
          (sizes * 5 >> Limits::digits) + (whole(Limits::denorm_min()) * 6 << digits);
      wrong += error <= whole(dot.error) << digits ? 0 : 1;
      wrong += whole(dot.error) << digits <= allowed ? 0 : 1; // nor is the bound idle
      wrong += is_sign_certain(dot) && (dot.value > 0) != (truth > 0) ? 1 : 0;
    }
    unknown += std::isfinite(dot.error) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(unknown < random_inputs / 2);
}
// [bounded_dot]

TEST_CASE(
    "where a product overflows, the bound of a dot product is infinite; of zero it is not", "[M6]")
{
  CHECK(std::isinf(bounded_dot<float, 3>({1e30f, 0, 0}, {1e30f, 0, 0}).error));
  const Bounded<float> zero = bounded_dot<float, 3>({0, 0, 0}, {3e38f, 3e38f, 3e38f});
  CHECK(zero.value == 0);
  CHECK_FALSE(is_sign_certain(zero));
  const float infinite = std::numeric_limits<float>::infinity();
  CHECK(std::isinf(bounded_dot<float, 3>({infinite, 0, 0}, {1, 1, 1}).error));
  CHECK(bounded_dot<float, 3>({infinite, 0, 0}, {1, 1, 1}).value == infinite);
  CHECK(bounded_dot<float, 3>({1, 1, 1}, {infinite, 0, 0}).value == infinite);
  CHECK_FALSE(is_sign_certain(bounded_dot<float, 3>({infinite - infinite, 0, 0}, {1, 1, 1})));
  CHECK_FALSE(is_sign_certain(Bounded<float>{2, 2}));
  CHECK(is_sign_certain(Bounded<float>{-2.5f, 2}));
}

// [difference]
TEMPLATE_TEST_CASE(
    "ad − bc of 100,000 fours of any size is within 2u of the exact one", "[products]", float,
    double)
{
  using Limits = std::numeric_limits<TestType>;
  constexpr int digits = all_digits<TestType>();
  WholeRange<TestType> draw;
  int wrong = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const TestType a = draw.number(), b = draw.number(), c = draw.number();
    // Every other time the products are nearly equal, and nearly all digits cancel.
    const TestType close = static_cast<TestType>(static_cast<long double>(b) * c / a);
    const bool cancel = i % 2 == 0 && std::isfinite(close);
    const TestType d = cancel ? close : draw.number();
    const TestType answer = difference_of_products(a, d, b, c);
    const Whole truth = whole(a) * whole(d) - whole(b) * whole(c);
    if (std::isinf(answer))
    {
      wrong += abs(truth) + (abs(truth) >> 20) >= whole(Limits::max()) << digits ? 0 : 1;
      wrong += (answer > 0) == (truth > 0) ? 0 : 1;
      continue;
    }
    const Whole allowed =
        (abs(truth) * 2 >> Limits::digits) + (whole(Limits::denorm_min()) << digits);
    wrong += abs((whole(answer) << digits) - truth) <= allowed ? 0 : 1; // false for NaN, too
  }
  CHECK(wrong == 0);
}
// [difference]

TEST_CASE("infinite and NaN input gives ad − bc of the same, in float and double", "[products]")
{
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(difference_of_products(infinite, 2.0, 3.0, 4.0) == infinite);
  CHECK(difference_of_products(2.0, 1.0, infinite, 4.0) == -infinite);
  CHECK(std::isnan(difference_of_products(infinite, 2.0, 3.0, infinite)));
  CHECK(std::isnan(difference_of_products(infinite - infinite, 2.0, 3.0, 4.0)));
  CHECK(difference_of_products(2.0f, 1.0f, std::numeric_limits<float>::infinity(), 4.0f) < 0);
  CHECK(difference_of_products(1e200, 1e200, 0.0, 1e300) == infinite);
  CHECK(difference_of_products(0.0, 1e300, 1e200, 1e200) == -infinite);
}

// [cross]
TEMPLATE_TEST_CASE(
    "vectors an ulp apart have a cross product with every component within 2u", "[products]", float,
    double)
{
  WholeRange<TestType> draw;
  int wrong = 0, naive_wrong = 0;
  for (int i = 0; i < 10000; ++i)
  {
    const Vector3<TestType> a(TestType(1), draw.fraction(), draw.fraction());
    const Vector3<TestType> b(TestType(1), std::nextafter(a.y(), TestType(2)), a.z());
    const auto is_off = [&](const Vector3<TestType>& cross)
    {
      const Vector3<Rational> truth = exact<Rational>(a).cross(exact<Rational>(b));
      const Rational u = exact<Rational>(unit_roundoff<TestType>());
      bool off = false;
      for (int k = 0; k < 3; ++k)
      {
        off = off || abs(exact<Rational>(cross[k]) - truth[k]) > 2 * u * abs(truth[k]);
      }
      return off;
    };
    wrong += is_off(accurate_cross(a, b)) ? 1 : 0;
    naive_wrong += is_off(a.cross(b)) ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(naive_wrong > 5000);
}
// [cross]

TEST_CASE("x × y is z, exactly, and its sign turns with the order", "[products]")
{
  CHECK(accurate_cross<double>({1, 2, 3}, {4, 5, 6}) == Vector3<double>(-3, 6, -3));
  CHECK(accurate_cross<float>({0, 1, 0}, {1, 0, 0}) == Vector3<float>(0, 0, -1));
}

// [products]
TEST_CASE("each way to subtract products holds or fails as the table says", "[products]")
{
  const std::vector<std::string> methods = names_of(product_methods<float>());
  const std::vector<std::string> all = methods;
  check_verdicts(
      product_verdicts(product_cases(0.0f)), methods,
      {{"3 · 7 − 5 · 4, float", all},
       {"three Fibonacci numbers, float", {"wider", "fused", "difference_of_products"}},
       {"1e60 − 1e60, float", {"wider", "difference_of_products"}}});
  check_verdicts(
      product_verdicts(product_cases(0.0)), methods,
      {{"larger Fibonacci numbers, double", {"fused", "difference_of_products"}},
       {"products of 2^1030, 2^978 apart, double", {"difference_of_products"}}});
}
// [products]

// [compare]
TEST_CASE("each way to compare holds or fails as the table says", "[compare]")
{
  const std::string published = "0.005, as published", both = "fixed and relative",
                    eigen = "Eigen's isApprox";
  check_verdicts(
      compare_verdicts(), compare_names(),
      {{"ten times 0.1, and 1: the same",
        {published, "relative", eigen, both, "equal_to_rounding"}},
       {"0.004 and 0: not the same", {"==", "relative", eigen, both, "equal_to_rounding"}},
       {"1e6 and 1e6 + 0.0625: the same", {"relative", eigen, both, "equal_to_rounding"}},
       {"1e6 + 0.0625 − 1e6, and 0: the same", {"equal_to_rounding"}},
       {"1e-12 and 2e-12: not the same", {"==", "relative", eigen, "equal_to_rounding"}},
       {"1e-25 and 2e-25: not the same", {"==", "relative", "equal_to_rounding"}},
       {"infinite and 1: not the same", {"==", published, eigen, "equal_to_rounding"}}});
}
// [compare]

TEST_CASE("10 roundings at size 1 allow 5 gaps of 2^-23 above 1, not 6", "[compare]")
{
  const auto same = [](float gaps)
  { return equal_to_rounding(1 + gaps * 0x1p-23f, 1.0f, 1.0f, 10); };
  CHECK(same(5));
  CHECK(same(-5));
  CHECK_FALSE(same(6));
  CHECK_FALSE(same(-6));
  const float infinite = std::numeric_limits<float>::infinity(), none = infinite - infinite;
  CHECK(equal_to_rounding(infinite, infinite, infinite, 4));
  CHECK_FALSE(equal_to_rounding(1.0f, 2.0f, infinite, 4));
  CHECK(equal_to_rounding(rounding_error(1.0f, 4), 0.0f, 1.0f, 4)); // just as far as allowed
  CHECK_FALSE(equal_to_rounding(none, none, 1.0f, 4));
  CHECK_FALSE(equal_to_rounding(3e38f, -3e38f, 3e38f, 4));
  CHECK(equal_to_rounding(1e-45f, 4e-45f, 0.0f, 4)); // four products may have been lost
}

TEMPLATE_TEST_CASE(
    "100,000 comparisons at any size are those of |a − b| ≤ γₙ size + n smallest numbers",
    "[compare]", float, double)
{
  using Limits = std::numeric_limits<TestType>;
  WholeRange<TestType> draw;
  int wrong = 0, same = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const TestType a = draw.number();
    const int gaps = draw.drawn(-20, 20);
    const TestType b = a + static_cast<TestType>(gaps) * ulp(a);
    if (!std::isfinite(b))
    {
      continue;
    }
    const TestType size = std::max(std::abs(a), std::abs(b));
    const bool answer = equal_to_rounding(a, b, size, 10);
    same += answer ? 1 : 0;
    // The bound times 2^digits − n, and a tenth to either side for its own rounding.
    const Whole scale = power_of_two(Limits::digits) - 10;
    const Whole apart = abs(whole(a) - whole(b)) * scale * 10;
    const Whole bound = whole(size) * 10 + whole(Limits::denorm_min()) * 10 * scale;
    wrong += answer && apart > bound * 11 ? 1 : 0;
    wrong += !answer && apart < bound * 9 ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(same > random_inputs / 10);
}

// [intervals]
TEST_CASE(
    "[0, 4] and [3, 10] overlap by 1, [0, 4] and [4, 5] touch, [5, 6] is 1 away", "[interval]")
{
  const Interval<double> a{0, 4};
  CHECK(interval_overlap<double>(a, {3, 10}) == 1);
  CHECK(interval_overlap<double>({3, 10}, a) == 1);
  CHECK(interval_overlap<double>(a, {4, 5}) == 0);
  CHECK(interval_overlap<double>(a, {5, 6}) == -1);
  CHECK(interval_overlap<double>({5, 6}, a) == -1);
  // Contained: the shorter separation, not the length that is shared.
  CHECK(interval_overlap<double>(a, {1, 2}) == 2);
  CHECK(intersection<double>(a, {1, 2}).most - intersection<double>(a, {1, 2}).least == 1);
}

TEST_CASE(
    "an empty interval overlaps nothing, clamps nothing, and grows to what is added", "[interval]")
{
  const double infinite = std::numeric_limits<double>::infinity();
  const Interval<double> none = empty_interval<double>(), a{0, 4}, point{2, 2};
  CHECK(is_empty(none));
  CHECK(is_empty(intersection<double>(a, {5, 6})));
  CHECK(is_empty(Interval<double>{infinite - infinite, 1}));
  CHECK_FALSE(is_empty(point));
  CHECK(interval_overlap(a, none) == -infinite);
  CHECK(interval_overlap(none, a) == -infinite);
  CHECK(interval_overlap<double>(a, {3, 1}) == -infinite);
  CHECK(interval_overlap<double>({3, 1}, a) == -infinite);
  CHECK_FALSE(clamp(1.0, none).has_value());
  CHECK_FALSE(clamp(infinite - infinite, a).has_value());
  CHECK(hull(none, 3.0).least == 3);
  CHECK(hull(none, 3.0).most == 3);
  CHECK(hull(hull(a, 5.0), -1.0).least == -1);
  CHECK(hull(a, 5.0).most == 5);
  CHECK(hull(a, infinite - infinite).most == 4);
  CHECK(intersection<double>(a, {1, 9}).least == 1);
  CHECK(intersection<double>(a, {-1, 3}).most == 3);
  CHECK(intersection<double>(a, {-1, 3}).least == 0);
  CHECK(intersection<double>(a, {-1, 9}).most == 4);
}

TEST_CASE("5 clamped to [0, 4] is 4, −5 is 0, 1 is 1, and all clamped to [2, 2] is 2", "[interval]")
{
  const Interval<float> a{0, 4}, point{2, 2};
  CHECK(clamp(5.0f, a) == 4);
  CHECK(clamp(-5.0f, a) == 0);
  CHECK(clamp(1.0f, a) == 1);
  CHECK(clamp(7.0f, point) == 2);
  CHECK(clamp(-7.0f, point) == 2);
}
// [intervals]

// [exact_sign]
TEMPLATE_TEST_CASE(
    "100,000 intervals of any size overlap, touch or are apart exactly as computed", "[interval]",
    float, double)
{
  WholeRange<TestType> draw;
  int wrong = 0, touching = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    TestType ends[4] = {draw.number(), draw.number(), draw.number(), draw.number()};
    ends[2] = i % 3 == 0 ? ends[1] : i % 3 == 1 ? std::nextafter(ends[1], ends[2]) : ends[2];
    const Interval<TestType> a{std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
    const Interval<TestType> b{std::min(ends[2], ends[3]), std::max(ends[2], ends[3])};
    const Whole first = whole(a.most) - whole(b.least), second = whole(b.most) - whole(a.least);
    const Whole truth = std::min(first, second);
    const TestType overlap = interval_overlap(a, b);
    touching += overlap == 0 ? 1 : 0;
    wrong += (overlap > 0) == (truth > 0) && (overlap < 0) == (truth < 0) ? 0 : 1;
    const bool fits = std::isfinite(overlap);
    const Whole off = fits ? abs(whole(overlap) - truth) : Whole(0);
    wrong += off << std::numeric_limits<TestType>::digits <= abs(truth) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(touching > random_inputs / 100);
}
// [exact_sign]

// [wrap]
TEST_CASE("each way to wrap an angle holds or fails as the table says", "[case:A7]")
{
  const std::string loop = "loop, as published";
  check_verdicts(
      wrap_verdicts(), names_of(wrap_methods()),
      {{"540°", {loop, "floor", "remainder", "wrap_degrees"}},
       {"−7200.5°", {loop, "floor", "remainder", "wrap_degrees"}},
       {"1e6 + 0.0625°", {loop, "floor", "remainder", "wrap_degrees"}},
       {"1e9°", {"remainder", "wrap_degrees"}},
       {"A7", {"remainder", "wrap_degrees"}},
       {"1e38°", {"remainder", "wrap_degrees"}},
       {"infinite", {"floor", "remainder", "wrap_degrees"}}});
}
// [wrap]

// [degrees_of_radians]
TEST_CASE(
    "half a turn is 180° by the nearest float to 180 / π, 179.99992° as published", "[case:X38]")
{
  const float half_turn = 3.14159265f;
  CHECK(half_turn * 57.2957795f == 180);
  CHECK(std::abs(half_turn * 57.295754f - 179.99992f) < 1e-5f);
}
// [degrees_of_radians]

// [wrap_exact]
TEMPLATE_TEST_CASE(
    "200,000 angles of any size wrap to (−180°, 180°] without an error", "[case:A7]", float, double)
{
  WholeRange<TestType> draw;
  const Whole turn = Whole(360) << all_digits<TestType>();
  int wrong = 0;
  for (int i = 0; i < 200000; ++i)
  {
    // Half of them from thousandths of a degree to where the quick way ends.
    const TestType ordinary = draw.fraction() * std::ldexp(TestType(1), draw.drawn(-8, 25));
    const TestType angle = i % 2 == 0 ? draw.number() : ordinary;
    const TestType wrapped = wrap_degrees(angle);
    const bool in_range = wrapped > -180 && wrapped <= 180;
    wrong += in_range && (whole(angle) - whole(wrapped)) % turn == 0 ? 0 : 1;
  }
  CHECK(wrong == 0);
}
// [wrap_exact]

TEMPLATE_TEST_CASE("whole and half turns, either way", "[case:A7]", float, double)
{
  for (const int turns : {0, 1, 2, 1000, 40000})
  {
    const TestType whole_turns = static_cast<TestType>(turns) * 360;
    CHECK(wrap_degrees(whole_turns) == 0);
    CHECK(wrap_degrees(whole_turns + 180) == 180);
    CHECK(wrap_degrees(-whole_turns - 180) == 180);
    CHECK(wrap_degrees(whole_turns + 90) == 90);
    CHECK(wrap_degrees(-whole_turns + 90) == 90);
  }
  // Just below half a turn, the quotient is rounded to a half.
  const TestType below = std::nextafter(TestType(180), TestType(0));
  CHECK(wrap_degrees(below) == below);
  CHECK(wrap_degrees(-below) == -below);
  CHECK(wrap_radians(TestType(3.1415925)) == TestType(3.1415925));
  const TestType infinite = std::numeric_limits<TestType>::infinity();
  CHECK(std::isnan(wrap_degrees(infinite)));
  CHECK(std::isnan(wrap_degrees(-infinite)));
  CHECK(std::isnan(wrap_degrees(infinite - infinite)));
  CHECK(std::isnan(wrap_radians(infinite)));
  CHECK(std::isnan(wrap_radians(infinite - infinite)));
}

namespace
{

/// arctan(1/n) · 2^digits, rounded down by at most a thousand.
Whole arctangent(int n, int digits)
{
  Whole power = power_of_two(digits) / n, sum = power;
  for (int k = 3; power != 0; k += 2)
  {
    power /= n * n;
    sum += k % 4 == 3 ? Whole(-power / k) : Whole(power / k);
  }
  return sum;
}

} // namespace

// [wrap_radians]
TEMPLATE_TEST_CASE(
    "200,000 angles of any size in radians wrap to within an ulp of π", "[case:A7]", float, double)
{
  // Machin: π/4 = 4 arctan(1/5) − arctan(1/239), to more digits than the largest double needs.
  constexpr int digits = 2200;
  const Whole turn = 32 * arctangent(5, digits) - 8 * arctangent(239, digits);
  const TestType pi = static_cast<TestType>(3.14159265358979323846);
  const Whole allowed = whole(ulp(pi), digits);
  WholeRange<TestType> draw;
  int wrong = 0;
  for (int i = 0; i < 200000; ++i)
  {
    const TestType ordinary = draw.fraction() * std::ldexp(TestType(1), draw.drawn(-8, 24));
    const TestType angle = i % 2 == 0 ? draw.number() : ordinary;
    const TestType wrapped = wrap_radians(angle);
    const Whole off = abs(whole(angle, digits) - whole(wrapped, digits)) % turn;
    wrong += std::min<Whole>(off, turn - off) <= allowed && std::abs(wrapped) <= pi ? 0 : 1;
    wrong += std::abs(angle) <= 3 && wrapped != angle ? 1 : 0;
  }
  CHECK(wrong == 0);
}
// [wrap_radians]

TEST_CASE("next to odd multiples of π, too, wrapped angles lie from −π to π", "[case:A7]")
{
  const double pi = 3.14159265358979323846;
  int outside = 0, moved = 0;
  for (int k = -660000; k <= 660000; k += 3)
  {
    const double odd = (2.0 * k + 1) * pi;
    for (const double angle : {odd, std::nextafter(odd, HUGE_VAL), std::nextafter(odd, -HUGE_VAL)})
    {
      const double wrapped = wrap_radians(angle);
      outside += std::abs(wrapped) <= pi ? 0 : 1;
      moved += std::abs(std::cos(wrapped) + 1) <= 1e-12 ? 0 : 1;
    }
  }
  CHECK(outside == 0);
  CHECK(moved == 0);
}

// [quadratic]
TEST_CASE(
    "x² − 1e9 x + 2 has the roots 2e-9 and 1e9; the formula of school says 0 for one",
    "[quadratic]")
{
  const auto school = plain::quadratic_roots(1.0, -1e9, 2.0),
             right = quadratic_roots(1.0, -1e9, 2.0);
  CHECK((*school)[0] == 0);
  CHECK((*right)[0] == Approx(2e-9).epsilon(1e-15));
  CHECK((*right)[1] == Approx(1e9).epsilon(1e-15));
  CHECK_FALSE(quadratic_roots(1.0, 1.0, 1.0));
  CHECK_FALSE(quadratic_roots(0.0, 0.0, 1.0));
  CHECK(*quadratic_roots(0.0, 2.0, -6.0) == std::array<double, 2>{3, 3});
  CHECK(*quadratic_roots(1.0, -6.0, 9.0) == std::array<double, 2>{3, 3});
  CHECK(*quadratic_roots(-1.0, 0.0, 0.0) == std::array<double, 2>{0, 0});
}

TEST_CASE(
    "the roots r and s of a(x − r)(x − s) come back, and school agrees where none is small",
    "[quadratic]")
{
  WholeRange<double> draw;
  for (int i = 0; i < 10000; ++i)
  {
    const double a = draw.drawn(1, 9), r = draw.drawn(-999, 999), s = draw.drawn(-999, 999);
    const auto roots = quadratic_roots(a, -a * (r + s), a * r * s);
    const auto school = plain::quadratic_roots(a, -a * (r + s), a * r * s);
    REQUIRE(roots);
    REQUIRE(school);
    CHECK((*roots)[0] == Approx(std::min(r, s)).epsilon(1e-15));
    CHECK((*roots)[1] == Approx(std::max(r, s)).epsilon(1e-15));
    CHECK((*school)[0] == Approx(std::min(r, s)).epsilon(1e-12));
  }
}
// [quadratic]
