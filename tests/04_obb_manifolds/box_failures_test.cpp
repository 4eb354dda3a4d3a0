/// \file
/// Every cell of the table of failing cases, and the right answers of its rows from fractions.

#include "04_obb_manifolds/box_failures/trial/box_failures.hpp"
#include "04_obb_manifolds/box_failures/trial/box_failures_methods.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_overlap_truth.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"

#include <array>
#include <map>
#include <set>

using namespace cookbook;

namespace
{

using Names = std::set<std::string>;

/// The ids of the cases at which each method fails.
using Failing = std::map<std::string, Names>;

/// The same, of a part of the table.
Failing failing(std::size_t part)
{
  const VerdictPart checked = verdict_parts().at(part);
  Failing ids;
  for (const BoxMethod& method : checked.methods)
  {
    ids[method.name];
    for (const BoxCase& pair : all_box_cases())
    {
      if (!verdict_of(checked, method, pair).holds)
      {
        ids[method.name].insert(pair.id);
      }
    }
  }
  return ids;
}

/// What is said of each method in a row of a part of the table.
std::map<std::string, Verdict> row_of(std::size_t part, const std::string& id)
{
  const VerdictPart checked = verdict_parts().at(part);
  const std::vector<std::string> names = names_of(checked.methods);
  std::map<std::string, Verdict> said;
  for (const VerdictRow& row : verdict_rows(checked))
  {
    for (std::size_t i = 0; i < names.size() && row.id == id; ++i)
    {
      said[names[i]] = row.verdicts[i];
    }
  }
  REQUIRE(said.size() == names.size());
  return said;
}

/// World coordinates in float, 10, 100 and 1000 km away.
const Names far_in_float{"G13", "G13-100-b", "G13-1000-b"};

/// All names of both.
Names with(Names names, const Names& more)
{
  names.insert(more.begin(), more.end());
  return names;
}

Obb<double> scaled_by(const Obb<double>& box, double scale)
{
  return {scale * box.center, box.axes, scale * box.half_extents};
}

} // namespace

TEST_CASE("the table has 37 pairs of boxes, and how near an answer must be", "[verdict]")
{
  // Ids that end in b are neighbours of the case before them.
  const Names all{"G1",   "G2",  "G3",         "G4",         "G5",           "G6",    "G7",
                  "G8",   "G9",  "G9b",        "G11",        "G12",          "G12-b", "G13",
                  "G14",  "G15", "G13-10-A-b", "G13-100-b",  "G13-100-A-b",  "G16",   "K2",
                  "K2-b", "K3",  "K3-b",       "G13-1000-b", "G13-1000-A-b", "X08",   "X09",
                  "X10",  "X11", "X12",        "X13",        "X14",          "X14-b", "X15",
                  "X16",  "X17"};
  // A millionth of a cube's half edge; of a depth of 0.1 µm a hundredth.
  const std::map<std::string, double> other_tolerances{
      {"G12", 1e-9},  {"G12-b", 1e-3}, {"X16", 4e-9}, {"K2", 1e-9},
      {"K2-b", 1e-9}, {"K3", 1e-9},    {"K3-b", 1e-9}};
  Names found;
  for (const BoxCase& pair : all_box_cases())
  {
    INFO(pair.id);
    found.insert(pair.id);
    const auto other = other_tolerances.find(pair.id);
    CHECK(pair.tolerance == Catch::Approx(other == other_tolerances.end() ? 1e-6 : other->second));
  }
  CHECK(found == all);
  CHECK(decided_cubes == 20'000);
}

TEST_CASE("a depth, a normal and a contact beyond the tolerance are wrong", "[verdict]")
{
  const BoxCase pair{"",  "",        upright({0, 0, 0}, {1, 1, 1}), upright({0, 1.9, 0}, {1, 1, 1}),
                     0.1, {0, 1, 0}, rectangle(1, 0.95, 1)};
  const auto answer = [&](double depth, double turn, double off)
  {
    BoxAnswer made{{turn, 1, 0}, depth, {}};
    for (const Vector3<double>& contact : pair.contacts)
    {
      made.points.push_back({contact + Vector3<double>(0, off, 0), depth, 0});
    }
    return made;
  };
  CHECK(verdict_on_overlap(pair, answer(0.1 + 0.9e-6, 0.9e-6, 0)).holds);
  CHECK_FALSE(verdict_on_overlap(pair, answer(0.1 + 1.1e-6, 0, 0)).holds);
  CHECK_FALSE(verdict_on_overlap(pair, answer(0.1 - 1.1e-6, 0, 0)).holds);
  CHECK_FALSE(verdict_on_overlap(pair, answer(0.1, 1.1e-6, 0)).holds);
  CHECK_FALSE(verdict_on_overlap(pair, std::nullopt).holds);
  // Half of the depth on either side: a contact may be off by twice as much.
  CHECK(verdict_on_points(pair, answer(0.1, 0, 1.9e-6)).holds);
  CHECK_FALSE(verdict_on_points(pair, answer(0.1, 0, 2.1e-6)).holds);
  BoxAnswer fewer = answer(0.1, 0, 0);
  fewer.points.pop_back();
  CHECK_FALSE(verdict_on_points(pair, fewer).holds);
}

// [right_answers]
TEST_CASE("the depths in the table are those of fractions", "[verdict][O18]")
{
  std::set<std::string> ids;
  for (const BoxCase& pair : all_box_cases())
  {
    INFO(pair.id);
    CHECK(ids.insert(pair.id).second);
    const auto least =
        true_least_overlap<Rational>(box_in<Rational>(pair.a), box_in<Rational>(pair.b));
    if (pair.depth < 0)
    {
      CHECK(least.signed_square < 0);
      continue;
    }
    const double square = static_cast<double>(least.signed_square);
    const double depth = square < 0 ? -std::sqrt(-square) : std::sqrt(square);
    CHECK(std::abs(depth - pair.depth) <= pair.tolerance / 10);
    const Vector3<double> axis =
        least.axis.unaryExpr([](const Rational& x) { return static_cast<double>(x); }).normalized();
    CHECK((pair.normal.isZero() || axis.cross(pair.normal).norm() <= 1e-7));
  }
}

TEST_CASE("the contacts in the table lie within half the depth of both boxes, midway", "[verdict]")
{
  for (const BoxCase& pair : all_box_cases())
  {
    INFO(pair.id);
    for (const Vector3<double>& point : pair.contacts)
    {
      CHECK(distance_to_box(pair.a, point) <= pair.depth / 2 + 1e-9);
      CHECK(distance_to_box(pair.b, point) <= pair.depth / 2 + 1e-9);
      const double front_a =
          pair.normal.dot(pair.a.center) +
          (pair.a.axes.transpose() * pair.normal).cwiseAbs().dot(pair.a.half_extents);
      CHECK(
          pair.normal.dot(point) ==
          Catch::Approx(front_a - pair.depth / 2).margin(pair.tolerance / 10));
    }
  }
}
// [right_answers]

// [axis_verdicts]
TEST_CASE(
    "every way to the least overlap fails or survives as the table says",
    "[case:G1][case:G2][case:G3][case:G4][case:G5][case:G6][case:G7][case:G8][case:G9][case:G11]"
    "[case:G12][case:G13][case:G14][case:G15][case:G16][case:K2][case:K3][case:X08][case:X09][case:"
    "X10][case:X11]["
    "case:X12]"
    "[case:X13][case:X14][case:X15][case:X16][case:X17]")
{
  const Failing expected{
      {"separating_axes", far_in_float},
      {"six_axes", with(far_in_float, {"G1", "G2", "G9", "G14", "X08", "X14", "X14-b"})},
      {"unnormalized_axes", with(far_in_float, {"G9", "G9b", "G11", "G12", "G12-b", "G14", "X14"})},
      {"short_radius_axes", with(far_in_float, {"G9b"})},
      {"union_depth", with(far_in_float, {"G3", "G4", "G6", "G14", "X11", "X12", "X13"})}};
  CHECK(failing(0) == expected);
}
// [axis_verdicts]

// [manifold_verdicts]
TEST_CASE(
    "every whole answer fails or survives as the table says",
    "[case:G1][case:G2][case:G3][case:G4][case:G5][case:G6][case:G7][case:G8][case:G9][case:G11]"
    "[case:G12][case:G13][case:G14][case:G15][case:G16][case:K2][case:K3][case:X08][case:X09][case:"
    "X10][case:X11]["
    "case:X12]"
    "[case:X13][case:X14][case:X15][case:X16][case:X17]")
{
  const Failing expected{
      {"overlap_as_published", Names{"G1", "K3", "X08", "X10", "X14-b"}},
      {"box_as_published",
       with(
           far_in_float, {"G1", "G3", "G4", "G6", "G9", "G9b", "G14", "K2", "K2-b", "K3", "K3-b",
                          "X08", "X09", "X11", "X12", "X13", "X14", "X14-b", "X15"})},
      {"gjk_epa", far_in_float},
      {"edge_clipping", far_in_float},
      {"face_clipping", far_in_float},
      // At G9 the face is preferred on purpose: it has all its corners, for 3 µm of depth.
      {"box_box", with(far_in_float, {"G9"})},
      {"box_pairs", with(far_in_float, {"G9"})}};
  CHECK(failing(1) == expected);
}
// [manifold_verdicts]

// [point_verdicts]
TEST_CASE(
    "every way to contact points fails or survives as the table says",
    "[case:G1][case:G2][case:G3][case:G4][case:G5][case:G6][case:G7][case:G8][case:G9][case:G11]"
    "[case:G12][case:G13][case:G14][case:G15][case:G16][case:K2][case:K3][case:X08][case:X09][case:"
    "X10][case:X11]["
    "case:X12]"
    "[case:X13][case:X14][case:X15][case:X16][case:X17]")
{
  const Failing expected{
      {"untolerant_points",
       with(far_in_float, {"G2", "G4", "G8", "G9b", "G16", "K2-b", "K3-b", "X14", "X17"})},
      {"box_as_published",
       with(
           far_in_float, {"G2", "G3", "G4", "G6", "G8", "G9b", "G12", "G14", "G16", "K2-b", "K3-b",
                          "X09", "X11", "X12", "X13", "X14", "X15", "X16", "X17"})},
      {"edge_clipping", with(far_in_float, {"G2", "G4", "G16", "X14"})},
      {"gjk_epa",
       with(far_in_float, {"G3",  "G4",   "G6",    "G7",         "G8",          "G9b",
                           "G11", "G12",  "G12-b", "G13-10-A-b", "G13-100-A-b", "G13-1000-A-b",
                           "G15", "K2-b", "K3-b",  "X09",        "X11",         "X12",
                           "X13", "X15",  "X16",   "X17"})},
      {"face_clipping", far_in_float},
      {"box_box", with(far_in_float, {"G9b"})},
      {"box_pairs", far_in_float}}; // in float a turn of 1e-14 is none
  CHECK(failing(2) == expected);
}
// [point_verdicts]

// [general_verdicts]
TEST_CASE("a capsule can be asked of no method that takes boxes only", "[case:K1][long]")
{
  for (const std::size_t part : {0u, 1u, 2u})
  {
    for (const auto& [name, verdict] : row_of(part, "K1"))
    {
      INFO(name);
      CHECK_FALSE(verdict.applies);
      CHECK_FALSE(verdict.holds);
    }
  }
}

TEST_CASE(
    "of 20,000 random cubes, six axes, tests without tolerance and the published code are wrong",
    "[case:K4][long]")
{
  const std::array<Names, 3> wrong{
      Names{"six_axes"}, Names{"overlap_as_published", "box_as_published"},
      Names{"untolerant_points", "box_as_published"}};
  for (std::size_t part = 0; part < 3; ++part)
  {
    for (const auto& [name, verdict] : row_of(part, "K4"))
    {
      INFO(name << ": " << verdict.what);
      CHECK(verdict.applies);
      CHECK(verdict.holds == (wrong[part].count(name) == 0));
    }
  }
}
// [general_verdicts]

TEST_CASE("two tables of the same cases on a page have rows to link to of their own", "[verdict]")
{
  const std::vector<VerdictRow> rows{
      {"G1", "a < b", {{true, "apart"}}},
      {"", "c", {{false, "0"}}},
      {"K1", "d", {does_not_apply("boxes")}}};
  const std::string first = verdict_table("t", {"m"}, rows);
  const std::string second = verdict_table("t", {"m"}, rows, "points");
  CHECK(first.find("<tr id=\"case-G1\"><th>G1</th><td>a &lt; b</td>") != std::string::npos);
  CHECK(second.find("<tr id=\"points-G1\"><th>G1</th>") != std::string::npos);
  CHECK(
      second.find("<tr><th></th><td>c</td><td class=\"verdict-fails\">0</td>") !=
      std::string::npos);
  CHECK(first.find("<td>d</td><td class=\"verdict-none\">n/a: boxes</td>") != std::string::npos);
}

// [G11]
TEST_CASE(
    "no contact of 8,000 pairs is deeper than the boxes, or farther from them than the depth",
    "[case:G11]")
{
  for (const std::string& name : box_workload_names())
  {
    INFO(name);
    for (const auto& [float_a, float_b] : box_workload(name, 800).pairs)
    {
      const Obb<double> a = orthonormal(float_a), b = orthonormal(float_b);
      const double depth = true_depth(true_least_overlap(a, b)), size = pair_size(a, b);
      const auto check = [&](const auto& manifold, double preference)
      {
        const double most = depth + preference + 1e-6 * size;
        for (std::size_t i = 0; manifold && i < manifold->points.size(); ++i)
        {
          const ContactPoint<double>& point = manifold->points[i];
          CHECK(point.depth <= manifold->depth + 1e-6 * size);
          CHECK(point.depth <= most);
          CHECK(distance_to_box(a, point.position) <= most);
          CHECK(distance_to_box(b, point.position) <= most);
        }
      };
      // box_box() takes a face for up to a twentieth of its depth or a two-hundredth of the boxes.
      const double smaller = std::min(a.half_extents.sum(), b.half_extents.sum());
      check(edge_clipping(a, b), 0);
      check(gjk_epa(a, b), 0);
      check(box_box(a, b), std::max(depth / 19, smaller / 200));
    }
  }
}
// [G11]

// [G12]
TEST_CASE(
    "4,000 pairs, a thousand times smaller and larger: answers scale; the published ones do not",
    "[case:G12][long]")
{
  int published_changes = 0;
  for (const char* const name : {"random", "resting", "edge-edge", "deep"})
  {
    for (const auto& [float_a, float_b] : box_workload(name, 1000).pairs)
    {
      const Obb<double> a = orthonormal(float_a), b = orthonormal(float_b);
      for (const double scale : {1e-3, 1e3})
      {
        const auto same = [&](const auto& method)
        {
          const auto here = method(a, b);
          const auto there = method(scaled_by(a, scale), scaled_by(b, scale));
          return here.has_value() == there.has_value() &&
                 (!here ||
                  (here->points.size() == there->points.size() &&
                   std::abs(there->depth - scale * here->depth) <= 1e-5 * scale * here->depth &&
                   (there->normal - here->normal).norm() <= 1e-5));
        };
        CHECK(same([](const auto& p, const auto& q) { return edge_clipping(p, q); }));
        CHECK(same([](const auto& p, const auto& q) { return gjk_epa(p, q); }));
        CHECK(same([](const auto& p, const auto& q) { return box_box(p, q); }));
        published_changes +=
            same([](const auto& p, const auto& q) { return box_as_published(p, q); }) ? 0 : 1;
      }
    }
  }
  CHECK(published_changes > 1000);
}
// [G12]
