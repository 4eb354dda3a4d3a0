/// \file
/// The fifteen axes against exact truth: O1, O5 and O18, in fractions, without a tolerance.

#include "04_obb_manifolds/box_workloads/trial/box_overlap_truth.hpp"
#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <vector>

using namespace cookbook;

namespace
{

/// A box in whole numbers: its rotation is that of a whole-number quaternion.
struct WholeBox
{
  Eigen::Vector3i center;
  Eigen::Vector4i quaternion;
  Eigen::Vector3i half_extents;
};

/// Whole-number boxes that every compiler draws alike.
class Draw : public BoxDraw
{
public:
  using BoxDraw::BoxDraw;

  WholeBox box(int radius)
  {
    const auto number = [&](int low, int high) { return low + whole(high - low + 1); };
    const auto vector = [&](int low, int high) -> Eigen::Vector3i
    {
      const int x = number(low, high), y = number(low, high);
      return {x, y, number(low, high)};
    };
    const Eigen::Vector3i axis = vector(-2, 2);
    const Eigen::Vector4i quaternion(number(1, 2), axis.x(), axis.y(), axis.z());
    const Eigen::Vector3i center = vector(-radius, radius);
    return {center, quaternion, vector(1, 6)};
  }
};

template <class Real>
Obb<Real> as(const WholeBox& box)
{
  const Eigen::Vector4i& q = box.quaternion;
  return {
      box.center.cast<Real>(), rational_rotation<Real>(q[0], q[1], q[2], q[3]),
      box.half_extents.cast<Real>()};
}

/// The truth about a pair.
struct Exact
{
  bool apart;
  Rational squared_depth; ///< of the least overlap; meaningless where apart
};

/// All pairs of the six edge directions in the world, each projection from the edges of both boxes.
Exact exact_least_overlap(const Obb<Rational>& a, const Obb<Rational>& b)
{
  const Rational signed_square = true_least_overlap(a, b).signed_square;
  return {signed_square < 0, abs(signed_square)};
}

using Whole = Eigen::Matrix<long long, 3, 1>;

/// The corners of B less those of A, both times the product of the quaternions' squared lengths.
std::vector<Whole> corner_differences(const WholeBox& a, const WholeBox& b)
{
  const long long scale_a = a.quaternion.squaredNorm(), scale_b = b.quaternion.squaredNorm();
  const auto edges = [](const WholeBox& box, long long other) -> Eigen::Matrix<long long, 3, 3>
  {
    const Obb<double> rotated = as<double>(box);
    const double scale = box.quaternion.squaredNorm();
    const Matrix3<double> whole = (rotated.axes * scale).array().round();
    return whole.cast<long long>() * box.half_extents.cast<long long>().asDiagonal() * other;
  };
  const Eigen::Matrix<long long, 3, 3> edges_a = edges(a, scale_b), edges_b = edges(b, scale_a);
  const Whole between = (b.center - a.center).cast<long long>() * (scale_a * scale_b);
  std::vector<Whole> corners;
  for (int corner = 0; corner < 64; ++corner)
  {
    const auto sign = [&](int bit) { return (corner >> bit) % 2 == 0 ? -1LL : 1LL; };
    const Whole in_a = edges_a * Whole(sign(0), sign(1), sign(2));
    const Whole in_b = edges_b * Whole(sign(3), sign(4), sign(5));
    corners.push_back(between + in_b - in_a);
  }
  return corners;
}

/// The distance of the origin from the hull of points, by every plane through three of them that
/// has none of them outside: all its faces, and nothing known of boxes.
Exact exact_hull_depth(const std::vector<Whole>& points, long long scale)
{
  Exact exact{false, -1};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      for (std::size_t k = j + 1; i != j && i < k && k < points.size(); ++k)
      {
        Whole normal = (points[j] - points[i]).cross(points[k] - points[i]);
        const auto outside = [&](const Whole& n)
        {
          return std::any_of(
              points.begin(), points.end(),
              [&](const Whole& p) { return n.dot(p - points[i]) > 0; });
        };
        if (normal.isZero(0) || (outside(normal) && outside(-normal)))
        {
          continue;
        }
        normal = outside(normal) ? Whole(-normal) : normal;
        const Rational distance(normal.dot(points[i]));
        const Rational squared =
            distance * distance / (Rational(normal.squaredNorm()) * scale * scale);
        exact.apart = exact.apart || distance < 0;
        exact.squared_depth = exact.squared_depth < 0 || squared < exact.squared_depth
                                  ? squared
                                  : exact.squared_depth;
      }
    }
  }
  return exact;
}

} // namespace

// [O1]
TEST_CASE(
    "fifteen axes decide 100 pairs of boxes as all faces of their difference do, exactly",
    "[O1][O18]")
{
  Draw draw(1);
  int apart = 0;
  for (int i = 0; i < 100; ++i)
  {
    const WholeBox a = draw.box(5), b = draw.box(5);
    const long long scale = a.quaternion.squaredNorm() * b.quaternion.squaredNorm();
    const Exact hull = exact_hull_depth(corner_differences(a, b), scale);
    const Exact axes = exact_least_overlap(as<Rational>(a), as<Rational>(b));
    REQUIRE(hull.apart == axes.apart);
    apart += hull.apart ? 1 : 0;
    if (!hull.apart)
    {
      CHECK(hull.squared_depth == axes.squared_depth);
    }
  }
  CHECK(apart >= 20);
  CHECK(apart <= 80);
}
// [O1]

// [exact_code]
TEST_CASE("the code itself, run in fractions, gives the exact squared depths", "[O1][O2][O3]")
{
  Draw draw(2);
  for (int i = 0; i < 300; ++i)
  {
    const Obb<Rational> a = as<Rational>(draw.box(6)), b = as<Rational>(draw.box(6));
    const RelativeBoxes<Rational> boxes = relative_boxes(a, b);
    std::vector<Rational> signed_squares;
    for (int axis = 0; axis < box_axes; ++axis)
    {
      const AxisOverlap<Rational> along = axis_overlap(boxes, axis);
      if (!from_parallel_edges(along))
      {
        signed_squares.push_back(along.overlap * abs(along.overlap) / along.squared_length);
      }
    }
    CHECK(
        *std::min_element(signed_squares.begin(), signed_squares.end()) ==
        true_least_overlap(a, b).signed_square);
  }
}
// [exact_code]

// [O18]
TEMPLATE_TEST_CASE(
    "of 3,000 pairs every decision is the exact one, and every depth to within rounding",
    "[O1][O8][O18]", float, double)
{
  using Real = TestType;
  Draw draw(3);
  int touching = 0, apart = 0;
  for (int i = 0; i < 3000; ++i)
  {
    WholeBox a = draw.box(6), b = draw.box(6);
    b.quaternion = i % 4 == 0 ? a.quaternion : b.quaternion;
    const Exact truth = exact_least_overlap(as<Rational>(a), as<Rational>(b));
    const Obb<Real> rounded_a = as<Real>(a), rounded_b = as<Real>(b);
    const auto ours = separating_axes(rounded_a, rounded_b);
    const double tolerance = double(rounding_tolerance(relative_boxes(rounded_a, rounded_b)));
    if (truth.squared_depth == 0 && !truth.apart)
    {
      // Rotations with thirds or fifths round: then touching may fall to either side.
      ++touching;
      CHECK((!ours || double(ours->depth) <= tolerance));
      continue;
    }
    REQUIRE(ours.has_value() == !truth.apart);
    apart += truth.apart ? 1 : 0;
    if (ours)
    {
      const double depth = std::sqrt(static_cast<double>(truth.squared_depth));
      CHECK(std::abs(double(ours->depth) - depth) <= tolerance);
    }
  }
  CHECK(touching <= 150);
  CHECK(apart >= 900);
  CHECK(apart <= 2100);
}
// [O18]

// [O5]
TEST_CASE("no direction has less overlap than the depth, or more gap than the distance", "[O5]")
{
  Draw draw(4);
  const auto any_direction = [&] { return draw.vector(-1, 1).normalized().eval(); };
  const auto any_point = [&](const Obb<double>& box) -> Vector3<double>
  {
    const Vector3<double> parts = draw.vector(-1, 1);
    return box.center + box.axes * box.half_extents.cwiseProduct(parts);
  };
  const auto radius = [](const Obb<double>& box, const Vector3<double>& axis)
  { return (box.axes.transpose() * axis).cwiseAbs().dot(box.half_extents); };
  for (int i = 0; i < 300; ++i)
  {
    const Obb<double> a = as<double>(draw.box(6)), b = as<double>(draw.box(6));
    const auto least = separating_axes(a, b);
    const double tolerance = rounding_tolerance(relative_boxes(a, b));
    for (int k = 0; k < 100; ++k)
    {
      const Vector3<double> axis = any_direction();
      const double separation =
          std::abs(axis.dot(b.center - a.center)) - radius(a, axis) - radius(b, axis);
      CHECK(separation <= (any_point(b) - any_point(a)).norm() + tolerance);
      CHECK((!least || -separation >= least->depth - tolerance));
    }
    if (least)
    {
      const Vector3<double>& n = least->normal;
      const double overlap = radius(a, n) + radius(b, n) - n.dot(b.center - a.center);
      CHECK(std::abs(overlap - least->depth) <= tolerance);
    }
  }
}
// [O5]
