/// \file
/// What holds for the finder: which pairs it knows, what it reads, and that its answers agree.

#include "02_primitives/finder/trial/finder.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <cmath>
#include <map>
#include <random>

using namespace cookbook;
using Catch::Matchers::ContainsSubstring;

namespace
{

/// The answers to one row.
template <class Real>
std::vector<Real> answers(
    const std::string& ask, const std::string& a, const std::string& b,
    const std::vector<double>& numbers)
{
  const auto question = finder_question<Real>(ask, a, b);
  REQUIRE(question);
  return question->answer({"pairs.csv", question->columns, {2, numbers}});
}

/// Random columns of a shape: lengths from 0.1 to 1, places from -1 to 1.
class RandomColumns
{
public:
  std::vector<double> of(const std::string& shape)
  {
    if (shape == "plane")
    {
      std::vector<double> n = places(3);
      const double length = std::hypot(n[0], n[1], n[2]);
      return {n[0] / length, n[1] / length, n[2] / length, place()};
    }
    if (shape == "obb")
    {
      std::vector<double> q = places(4);
      const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
      std::vector<double> all = places(3);
      for (const double part : q)
      {
        all.push_back(part / length);
      }
      return with_sizes(all, 3);
    }
    static const std::map<std::string, std::pair<int, int>> counts{
        {"point", {3, 0}},     {"segment", {6, 0}},
        {"ray", {6, 0}},       {"sphere", {3, 1}},
        {"capsule", {6, 1}},   {"aabb", {3, 3}},
        {"triangle", {9, 0}},  {"tetrahedron", {12, 0}},
        {"point2", {2, 0}},    {"segment2", {4, 0}},
        {"ray2", {4, 0}},      {"circle", {2, 1}},
        {"rectangle", {2, 2}}, {"turned_rectangle", {3, 2}}};
    const auto [given, sizes] = counts.at(shape);
    return with_sizes(places(given), sizes);
  }

private:
  double place() { return static_cast<double>(random_() % 20001) / 10000 - 1; }
  std::vector<double> places(int count)
  {
    std::vector<double> all;
    for (int i = 0; i < count; ++i)
    {
      all.push_back(place());
    }
    return all;
  }
  std::vector<double> with_sizes(std::vector<double> all, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      all.push_back(0.1 + 0.45 * (place() + 1));
    }
    return all;
  }
  std::mt19937 random_{7};
};

std::vector<double> joined(std::vector<double> a, const std::vector<double>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

bool is_cast(const std::string& shape)
{
  return shape == "ray" || shape == "ray2";
}

/// Shapes that random places find apart as well as overlapping.
bool has_size(const std::string& shape)
{
  static const std::vector<std::string> all{
      "sphere", "capsule", "aabb", "obb", "tetrahedron", "circle", "rectangle", "turned_rectangle"};
  return std::find(all.begin(), all.end(), shape) != all.end();
}

bool in_plane(const std::string& shape)
{
  const std::vector<std::string>& all = finder_shapes();
  return std::find(all.begin(), all.end(), shape) >= std::find(all.begin(), all.end(), "point2");
}

} // namespace

// [finder_cells]
TEST_CASE("any two shapes of one space have an overlap and closest points, but for rays")
{
  for (const std::string& a : finder_shapes())
  {
    for (const std::string& b : finder_shapes())
    {
      INFO(a << " and " << b);
      const bool there = in_plane(a) == in_plane(b) && !is_cast(a) && !is_cast(b);
      CHECK(finder_question<double>("overlap", a, b).has_value() == there);
      CHECK(finder_question<double>("closest", a, b).has_value() == there);
    }
  }
}

TEST_CASE("rays and segments are cast at every shape that has a size")
{
  for (const std::string ray : {"ray", "segment"})
  {
    for (const std::string shape :
         {"plane", "sphere", "capsule", "aabb", "obb", "triangle", "tetrahedron"})
    {
      INFO(ray << " at " << shape);
      CHECK(finder_question<float>("cast", ray, shape).has_value());
    }
    for (const std::string shape : {"circle", "rectangle", "turned_rectangle"})
    {
      INFO(ray << "2 at " << shape);
      CHECK(finder_question<float>("cast", ray + "2", shape).has_value());
    }
  }
}
// [finder_cells]

// [finder_agrees]
TEST_CASE("two shapes overlap where they are closest at distance 0, in either order, up to 1e-9")
{
  RandomColumns draw;
  for (const std::string& a : finder_shapes())
  {
    for (const std::string& b : finder_partners("closest", a))
    {
      int separate = 0, together = 0, wrong = 0, uneven = 0;
      for (int i = 0; i < inputs(400, 30); ++i)
      {
        const std::vector<double> of_a = draw.of(a), of_b = draw.of(b);
        const auto closest = answers<double>("closest", a, b, joined(of_a, of_b));
        const auto swapped = answers<double>("closest", b, a, joined(of_b, of_a));
        const bool hit = answers<double>("overlap", a, b, joined(of_a, of_b))[0] == 1;
        const std::size_t size = (closest.size() - 1) / 2;
        double squared = 0;
        for (std::size_t k = 1; k <= size; ++k)
        {
          squared += std::pow(closest[k] - closest[k + size], 2);
        }
        (hit ? together : separate) += 1;
        wrong += hit ? closest[0] > 1e-9 : closest[0] == 0;
        uneven += std::abs(closest[0] - swapped[0]) > 1e-9 ||
                  std::abs(std::sqrt(squared) - closest[0]) > 1e-9;
      }
      INFO(a << " and " << b);
      CHECK(wrong == 0);
      CHECK(uneven == 0);
      if (has_size(a) && has_size(b))
      {
        CHECK(separate > 0);
        CHECK(together > 0);
      }
    }
  }
}

TEST_CASE("a segment cast at a shape hits where the two overlap, up to 1e-9")
{
  RandomColumns draw;
  for (const std::string segment : {"segment", "segment2"})
  {
    for (const std::string& shape : finder_partners("cast", segment))
    {
      int wrong = 0, hits = 0;
      for (int i = 0; i < random_inputs / 100; ++i)
      {
        const std::vector<double> row = joined(draw.of(segment), draw.of(shape));
        const auto hit = answers<double>("cast", segment, shape, row);
        const double distance = answers<double>("closest", segment, shape, row)[0];
        wrong += hit[0] == 1 ? distance > 1e-9 : distance == 0;
        hits += hit[0] == 1;
      }
      INFO(segment << " at " << shape);
      CHECK(wrong == 0);
      CHECK(hits > 0);
    }
  }
}
// [finder_agrees]

// [finder_by_hand]
TEST_CASE("a ball of 1 m above a capsule, a box and a ray: answers by hand")
{
  using Numbers = std::vector<double>;
  CHECK(
      answers<double>("closest", "sphere", "capsule", {0, 4, 0, 1, -1, 0, 0, 1, 0, 0, 1}) ==
      Numbers{2, 0, 3, 0, 0, 1, 0});
  CHECK(answers<double>("overlap", "sphere", "aabb", {0, 2, 0, 1, 0, 0, 0, 1, 1, 1}) == Numbers{1});
  CHECK(
      answers<double>("cast", "ray", "sphere", {0, 5, 0, 0, -2, 0, 0, 0, 0, 1}) ==
      Numbers{1, 2, 0, 1, 0, 0, 1, 0});
  CHECK(answers<double>("cast", "ray", "sphere", {0, 5, 0, 0, 2, 0, 0, 0, 0, 1}) == Numbers{0});
  CHECK(
      answers<double>("closest", "circle", "segment2", {0, 4, 1, -1, 0, 1, 0}) ==
      Numbers{3, 0, 3, 0, 0});
}

TEST_CASE("impossible numbers are answered with their column")
{
  const auto ask = [](const std::string& a, const std::vector<double>& numbers) {
    return answers<double>("overlap", "point", a, joined({0, 0, 0}, numbers));
  };
  CHECK_THROWS_WITH(
      ask("sphere", {0, 0, 0, -1}), ContainsSubstring("br: the radius must be zero or more"));
  CHECK_THROWS_WITH(
      ask("aabb", {0, 0, 0, 1, 0, 1}), ContainsSubstring("bhy: a half extent must be greater"));
  CHECK_THROWS_WITH(
      ask("plane", {0, 2, 0, 1}), ContainsSubstring("bnx: the normal must have length 1"));
  CHECK_THROWS_WITH(
      ask("obb", {0, 0, 0, 2, 0, 0, 0, 1, 1, 1}),
      ContainsSubstring("bqw: the quaternion must have length 1"));
}
// [finder_by_hand]
