/// \file
/// What holds for GJK and EPA, piece by piece, and what each way to run them makes of cases K1 to
/// K4.

#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_verdicts.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <algorithm>
#include <random>
#include <set>

using namespace cookbook;

namespace
{

/// A few roundings of numbers of size one.
constexpr double rounding = 4e-15;

const Obb<double> unit_cube = upright({0, 0, 0}, {1, 1, 1});

/// A simplex of points; where they come from on A does not matter.
Simplex<double> simplex_of(const std::vector<Vector3<double>>& points)
{
  Simplex<double> simplex;
  for (const Vector3<double>& point : points)
  {
    simplex.add({point, point});
  }
  return simplex;
}

bool equal(const Vector3<double>& one, const Vector3<double>& other)
{
  return (one - other).norm() <= rounding;
}

/// The names of the methods that fail at a case.
std::set<std::string> failing(const std::string& id)
{
  const std::vector<ConvexCase> cases = convex_cases();
  const auto found = std::find_if(
      cases.begin(), cases.end(),
      [&](const ConvexCase& convex_case) { return convex_case.id == id; });
  REQUIRE(found != cases.end());
  std::set<std::string> names;
  for (const ConvexMethod& method : convex_methods())
  {
    if (!found->verdict(method).holds)
    {
      names.insert(method.name);
    }
  }
  return names;
}

using Names = std::set<std::string>;

/// A tetrahedron, seen from outside counter-clockwise, as an expansion has it.
Polytope<double> tetrahedron()
{
  Polytope<double> polytope;
  const Vector3<double> corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vector3<double>& corner : corners)
  {
    polytope.corners[polytope.corner_count++] = {corner, corner};
  }
  for (const std::array<int, 3>& face :
       {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{2, 0, 3}})
  {
    add_face(polytope, face, 1e-12);
  }
  return polytope;
}

} // namespace

TEST_CASE(
    "the farthest point of a difference is A's farthest corner less B's the other way", "[gjk]")
{
  // B is turned by a quarter about z: its x axis is up, so its extents seen from A are (3, 2, 4).
  Matrix3<double> turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Obb<double> a = upright({10, 0, 0}, {1, 2, 3});
  const MinkowskiDifference<double> support{
      relative_boxes(a, Obb<double>{{10, 0.5, 0}, turn, {2, 3, 4}})};
  const SupportPoint<double> found = support({1, 2, -1});
  CHECK(found.on_a == Vector3<double>(1, 2, -3));
  CHECK(found.point == Vector3<double>(1 + 3, 2 - (0.5 - 2), -3 - 4));
  CHECK(support({-1, -2, 1}).point == Vector3<double>(-1 - 3, -2 - (0.5 + 2), 3 + 4));
  CHECK(separates<double>({1, 2, 3}, {-1, 0, 0}));
  CHECK_FALSE(separates<double>({1, 2, 3}, {0, 0, 0}));
  CHECK_FALSE(separates<double>({0, 2, 3}, {-1, 0, 0}));
}

TEST_CASE("the part of a simplex closest to the origin: point, segment, triangle, inside", "[gjk]")
{
  const NearestPart<double> middle = nearest_part(simplex_of({{-1, 2, 0}, {3, 2, 0}}));
  CHECK((middle.size == 2 && equal(middle.point, {0, 2, 0})));
  const NearestPart<double> first = nearest_part(simplex_of({{1, 2, 0}, {3, 2, 0}}));
  CHECK((first.size == 1 && first.keep[0] == 0));
  const NearestPart<double> last = nearest_part(simplex_of({{-4, 2, 0}, {-3, 2, 0}}));
  CHECK((last.size == 1 && last.keep[0] == 1 && last.point.x() == -3));
  const NearestPart<double> face = nearest_part(simplex_of({{-1, -1, 2}, {2, -1, 2}, {-1, 2, 2}}));
  CHECK((face.size == 3 && equal(face.point, {0, 0, 2})));
  const NearestPart<double> edge = nearest_part(simplex_of({{-1, 1, 2}, {2, 1, 2}, {-1, 4, 2}}));
  CHECK((edge.size == 2 && equal(edge.point, {0, 1, 2})));
  // A triangle without an area is as good as its longest edge.
  const NearestPart<double> flat = nearest_part(simplex_of({{-2, 1, 0}, {3, 1, 0}, {1, 1, 0}}));
  CHECK((flat.size == 2 && equal(flat.point, {0, 1, 0})));
}

TEST_CASE("every corner, edge and face of a tetrahedron, and its inside, is found", "[gjk]")
{
  const std::vector<Vector3<double>> corners{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}};
  const auto from = [&](const Vector3<double>& origin)
  {
    std::vector<Vector3<double>> moved;
    for (const Vector3<double>& corner : corners)
    {
      moved.push_back(corner - origin);
    }
    return nearest_part(simplex_of(moved));
  };
  CHECK(from({1, 1, 1}).size == 0);
  CHECK((from({1, 1, -2}).size == 3 && equal(from({1, 1, -2}).point, {0, 0, 2})));
  CHECK((from({1, -2, 1}).size == 3 && equal(from({1, -2, 1}).point, {0, 2, 0})));
  CHECK((from({-2, 1, 1}).size == 3 && equal(from({-2, 1, 1}).point, {2, 0, 0})));
  CHECK((from({3, 3, 3}).size == 3 && equal(from({3, 3, 3}).point, {-1, -1, -1})));
  CHECK((from({3, -1, -1}).size == 2 && equal(from({3, -1, -1}).point, {0, 1, 1})));
  CHECK((from({4, 4, -3}).size == 2 && equal(from({4, 4, -3}).point, {-1, -1, 3})));
  CHECK((from({-1, -1, -1}).size == 1 && equal(from({-1, -1, -1}).point, {1, 1, 1})));
  CHECK((from({9, 1, 1}).size == 1 && equal(from({9, 1, 1}).point, {-3, -1, -1})));
  // On a face is not inside: the face is kept, so that rounding does not decide.
  CHECK((from({1, 1, 0}).size == 3 && equal(from({1, 1, 0}).point, {0, 0, 0})));
}

TEST_CASE("of 20,000 random simplices no point is closer than the one that is found", "[gjk]")
{
  std::mt19937 engine(1);
  const auto part = [&] { return static_cast<double>(engine()) * 0x1p-31 - 1; };
  std::set<int> sizes;
  for (int i = 0; i < 20'000; ++i)
  {
    const Vector3<double> middle(part(), part(), part());
    Simplex<double> simplex;
    while (simplex.size < 2 + i % 3)
    {
      const double x = part(), y = part();
      simplex.add({middle + Vector3<double>(x, y, part()), {0, 0, 0}});
    }
    const NearestPart<double> nearest = nearest_part(simplex);
    sizes.insert(nearest.size);
    // A point of the simplex is its closest if the plane through it, perpendicular to the way
    // there, has the whole simplex beyond it.
    const double squared = nearest.point.squaredNorm();
    for (int k = 0; k < simplex.size; ++k)
    {
      CHECK(nearest.point.dot(simplex.at(k)) >= squared - 1e-12);
    }
    for (int k = 0; k < nearest.size; ++k)
    {
      const int kept = nearest.keep[static_cast<std::size_t>(k)];
      CHECK(nearest.point.dot(simplex.at(kept)) == Catch::Approx(squared).margin(1e-12));
    }
  }
  CHECK(sizes == std::set<int>{0, 1, 2, 3});
}

// [decision]
TEST_CASE("GJK says apart only along a direction that separates", "[gjk]")
{
  RandomCubes draw(3);
  int apart = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const RelativeBoxes<double> boxes = relative_boxes(draw.next(), draw.next());
    const MinkowskiDifference<double> support{boxes};
    const GjkAnswer<double> decision = gjk(support, boxes.offset, rounding_tolerance(boxes));
    CHECK(decision.steps <= 12);
    apart += decision.apart ? 1 : 0;
    if (decision.apart)
    {
      const Vector3<double> nearest = nearest_part(decision.simplex).point;
      CHECK(separates<double>(support(-nearest).point, -nearest));
    }
    else
    {
      CHECK((decision.simplex.size < 4 || nearest_part(decision.simplex).size == 0));
    }
  }
  CHECK(apart > 1000);
  CHECK(apart < 1800);
}

TEST_CASE("EPA alone, from any one point, comes to the same decision", "[epa]")
{
  RandomCubes draw(9);
  for (int i = 0; i < 2000; ++i)
  {
    const Obb<double> a = draw.next(), b = draw.next();
    const RelativeBoxes<double> boxes = relative_boxes(a, b);
    const MinkowskiDifference<double> support{boxes};
    Simplex<double> anything;
    anything.add(support({1, 1, 1}));
    const bool hit = epa(support, anything, rounding_tolerance(boxes)).depth >= 0;
    CHECK(hit == gjk_epa(a, b).has_value());
  }
}
// [decision]

TEST_CASE("a corner takes the place of the faces that see it, and the solid stays closed", "[epa]")
{
  Polytope<double> polytope = tetrahedron();
  const double third = std::sqrt(1.0 / 3);
  CHECK(equal(polytope.faces[2].normal, {third, third, third}));
  CHECK(polytope.faces[2].distance == Catch::Approx(third).margin(rounding));
  REQUIRE(add_corner<double>(polytope, {{1, 1, 1}, {1, 1, 1}}, 1e-12));
  CHECK(polytope.corner_count == 5);
  CHECK(polytope.face_count == 6);
  std::set<std::pair<int, int>> edges;
  for (std::size_t f = 0; f < polytope.face_count; ++f)
  {
    const std::array<int, 3>& c = polytope.faces[f].corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      CHECK(edges.emplace(c[k], c[(k + 1) % 3]).second);
    }
    for (std::size_t corner = 0; corner < polytope.corner_count; ++corner)
    {
      CHECK_FALSE(sees(polytope.corners[corner].point, polytope.faces[f], 1e-12));
    }
  }
  for (const auto& [from, to] : edges)
  {
    CHECK(edges.count({to, from}) == 1);
  }
}

TEST_CASE("a polytope without room stays as it is, and a flat face is never tried", "[epa]")
{
  Polytope<double> polytope = tetrahedron();
  polytope.corner_count = most_corners;
  CHECK_FALSE(add_corner<double>(polytope, {{1, 1, 1}, {1, 1, 1}}, 1e-12));
  CHECK(polytope.face_count == 4);
  polytope.corner_count = 4;
  polytope.corners[3].point = {0.5, 1e-13, 0};
  add_face(polytope, {0, 1, 3}, 1e-12);
  CHECK(polytope.faces[4].done);
  CHECK(polytope.faces[4].normal.isZero(0));
  CHECK(closest_face(polytope) < 4);
}

TEST_CASE("a face whose farthest corner is there already is done, and another one's turn", "[epa]")
{
  const auto support = [](const Vector3<double>& direction) -> SupportPoint<double>
  {
    const Vector3<double> corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto less = [&](const auto& one, const auto& other)
    { return one.dot(direction) < other.dot(direction); };
    const Vector3<double> corner = *std::max_element(std::begin(corners), std::end(corners), less);
    return {corner, corner};
  };
  Expansion<double> expansion;
  expansion.polytope = tetrahedron();
  expansion.tolerance = 1e-12;
  // As if rounding had made this face closer than it is.
  expansion.polytope.faces[2].distance = -0.1;
  REQUIRE(expand(expansion, support));
  CHECK(expansion.polytope.faces[2].done);
  CHECK(expansion.polytope.corner_count == 4);
  CHECK_FALSE(expansion.closed);
  CHECK_FALSE(expand(expansion, support));
  CHECK(expansion.closed);
  CHECK(expansion.depth == 0);
}

TEST_CASE("heights over a point, a line and a plane, and displacements out of them", "[epa]")
{
  const Simplex<double> point = simplex_of({{1, 1, 1}});
  const Simplex<double> line = simplex_of({{1, 1, 1}, {3, 1, 1}});
  const Simplex<double> plane = simplex_of({{1, 1, 1}, {3, 1, 1}, {1, 5, 1}});
  CHECK(height_over<double>(point, {4, 5, 1}) == Catch::Approx(5).margin(rounding));
  CHECK(height_over<double>(line, {9, 5, 4}) == Catch::Approx(5).margin(rounding));
  CHECK(height_over<double>(plane, {9, 7, -2}) == Catch::Approx(3).margin(rounding));
  std::array<Vector3<double>, 3> ways;
  CHECK(ways_out(point, ways) == 3);
  CHECK(ways_out(line, ways) == 2);
  for (const int way : {0, 1})
  {
    CHECK(ways[std::size_t(way)].norm() == Catch::Approx(1).margin(rounding));
    CHECK(ways[std::size_t(way)].x() == 0);
  }
  CHECK(ways[0].dot(ways[1]) == 0);
  CHECK(ways_out(plane, ways) == 1);
  CHECK(equal(ways[0].cwiseAbs(), {0, 0, 1}));
}

TEST_CASE("out of a corner the rebuild goes where the solid is longest", "[epa]")
{
  const RelativeBoxes<double> boxes = relative_boxes(upright({0, 0, 0}, {8, 1, 1}), unit_cube);
  const MinkowskiDifference<double> support{boxes};
  Expansion<double> expansion;
  expansion.tolerance = 1e-14;
  const Simplex<double> solid = rebuilt(expansion, support, simplex_of({{9, 2, 2}}));
  REQUIRE(solid.size == 4);
  CHECK(solid.at(1).x() == -9);
}

TEST_CASE("whatever GJK leaves becomes a tetrahedron, if the solid is not flat", "[epa]")
{
  const RelativeBoxes<double> boxes = relative_boxes(unit_cube, unit_cube);
  const MinkowskiDifference<double> support{boxes};
  const Vector3<double> p(2, 2, 2), q(-2, -2, -2), r(2, 2, -2);
  for (const auto& left :
       {simplex_of({p}), simplex_of({p, q}), simplex_of({p, q, r}), simplex_of({p, p, p, p}),
        simplex_of({p, q, r, {-2, -2, 2}})})
  {
    const Expansion<double> start = start_expansion(support, left, 1e-14);
    CHECK(start.polytope.corner_count == 4);
    CHECK(start.polytope.face_count == 4);
    const Vector3<double> middle =
        (start.polytope.corners[0].point + start.polytope.corners[1].point +
         start.polytope.corners[2].point + start.polytope.corners[3].point) /
        4;
    for (std::size_t f = 0; f < 4; ++f)
    {
      CHECK(sees<double>(middle, start.polytope.faces[f], -100));
      CHECK_FALSE(sees(middle, start.polytope.faces[f], -0.1));
    }
    CHECK(epa(support, left, 1e-14).depth == Catch::Approx(2).margin(rounding));
  }
}

TEST_CASE(
    "boxes so thin that their difference is flat have a depth and a normal all the same", "[epa]")
{
  const auto plates =
      gjk_epa(upright({0, 0, 0}, {1, 1e-20, 2}), upright({0.5, 0, 0.5}, {2, 1e-20, 1}));
  REQUIRE(plates);
  CHECK(plates->depth == Catch::Approx(2e-20));
  CHECK(std::abs(plates->normal.y()) == 1);
  const auto rods =
      gjk_epa(upright({0, 0, 0}, {1, 1e-20, 1e-20}), upright({0.5, 0, 0}, {2, 1e-20, 1e-20}));
  REQUIRE(rods);
  CHECK(rods->depth == Catch::Approx(2e-20));
  CHECK(rods->normal.x() == 0);
  CHECK_FALSE(gjk_epa(upright({0, 0, 0}, {1, 1e-20, 1}), upright({2.5, 0, 0}, {1, 1e-20, 1})));
}

// [bounds]
TEST_CASE(
    "at every step the closest face is below the depth, the best direction above",
    "[epa][O18][O21]")
{
  RandomCubes draw(4);
  int hits = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Obb<double> a = draw.next(), b = draw.next();
    const RelativeBoxes<double> boxes = relative_boxes(a, b);
    const MinkowskiDifference<double> support{boxes};
    const double tolerance = rounding_tolerance(boxes), depth = -largest_separation(a, b);
    if (depth < 0)
    {
      continue;
    }
    ++hits;
    Expansion<double> expansion =
        start_expansion(support, gjk(support, boxes.offset, tolerance).simplex, tolerance);
    for (bool more = true; more;)
    {
      const Polytope<double>& polytope = expansion.polytope;
      REQUIRE(polytope.face_count == 2 * polytope.corner_count - 4);
      CHECK(polytope.faces[closest_face(polytope)].distance <= depth + tolerance);
      more = expand(expansion, support);
      CHECK(expansion.depth >= depth - tolerance);
    }
    CHECK(expansion.closed);
    CHECK(expansion.depth <= depth + tolerance);
    CHECK(expansion.steps <= 32);
  }
  CHECK(hits > 200);
}
// [bounds]

// [point]
TEST_CASE(
    "the point is on the middle plane and no farther than half the depth from both", "[gjk][epa]")
{
  RandomCubes draw(5);
  int hits = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Obb<double> a = draw.next(), b = draw.next();
    const auto manifold = gjk_epa(a, b);
    if (!manifold)
    {
      continue;
    }
    ++hits;
    const Vector3<double>&n = manifold->normal, &p = manifold->points[0].position;
    const double half = penetration_distance(*manifold);
    const double radius_a = (a.axes.transpose() * n).cwiseAbs().dot(a.half_extents);
    CHECK(n.dot(p - a.center) == Catch::Approx(radius_a - half).margin(1e-12));
    for (const Obb<double>& box : {a, b})
    {
      const Vector3<double> local = (box.axes.transpose() * (p - box.center)).cwiseAbs();
      CHECK((local - box.half_extents).cwiseMax(0.0).norm() <= half + 1e-12);
    }
  }
  CHECK(hits > 400);
}

TEST_CASE(
    "manifolds move, turn and scale with the boxes, and turn round when they swap", "[gjk][epa]")
{
  const Obb<double> b{{0.3, 1.7, 0.2}, turned(0.4, {0.3, 1, 0}), {0.8, 0.8, 0.8}};
  const Manifold<double> here = gjk_epa(unit_cube, b).value();
  const Manifold<double> swapped_round = gjk_epa(b, unit_cube).value();
  CHECK(swapped_round.depth == Catch::Approx(here.depth).margin(rounding));
  CHECK(equal(swapped_round.normal, -here.normal));
  const Matrix3<double> turn = turned(0.7, {1, -2, 0.5});
  for (const double scale : {1e-200, 1e-3, 1.0, 1e3, 1e200})
  {
    const Vector3<double> offset = scale * Vector3<double>(10, -20, 30);
    const auto moved = [&](const Obb<double>& box) -> Obb<double> {
      return {offset + scale * (turn * box.center), turn * box.axes, scale * box.half_extents};
    };
    const Manifold<double> there = gjk_epa(moved(unit_cube), moved(b)).value();
    CHECK(there.depth / scale == Catch::Approx(here.depth).margin(1e-13));
    CHECK((there.normal - turn * here.normal).norm() <= 1e-13);
    const Vector3<double> expected = offset + scale * (turn * here.points[0].position);
    CHECK(((there.points[0].position - expected) / scale).norm() <= 1e-12);
  }
}

TEST_CASE(
    "a point's feature names what meets: faces, edges or corners, of both boxes", "[gjk][epa]")
{
  // Digits to base 3, A's x, y, z, then B's along −n: 1 level, 2 the positive side, 0 the negative.
  const auto feature = [](const Obb<double>& a, const Obb<double>& b)
  { return gjk_epa(a, b).value().points[0].feature; };
  const auto code = [](std::uint32_t a, std::uint32_t b) { return 1 + 27 * a + b; };
  const std::uint32_t top = 1 * 9 + 2 * 3 + 1, bottom = 1 * 9 + 0 * 3 + 1;
  CHECK(feature(unit_cube, upright({0.2, 1.9, 0}, {1, 1, 1})) == code(top, bottom));
  CHECK(feature(unit_cube, upright({-0.3, 1.8, 0.1}, {1, 1, 1})) == code(top, bottom));
  CHECK(feature(unit_cube, upright({0.2, -1.9, 0}, {1, 1, 1})) == code(bottom, top));
  const Obb<double> diamond{{0, 2.4, 0}, turned(std::atan(1.0), {0, 0, 1}), {1, 1, 1}};
  CHECK(feature(unit_cube, diamond) == code(top, 0 * 9 + 0 * 3 + 1));
}
// [point]

// [policy]
TEST_CASE("touching is contact of depth zero; a bit more apart is none", "[gjk][epa]")
{
  for (const Vector3<double>& way :
       {Vector3<double>(2, 0, 0), Vector3<double>(0, -2, 0), Vector3<double>(2, 2, 0),
        Vector3<double>(-2, 2, 2), Vector3<double>(0.5, 0.25, 2)})
  {
    const auto touching = gjk_epa(unit_cube, upright(way, {1, 1, 1}));
    REQUIRE(touching);
    CHECK(touching->depth == 0);
    CHECK_FALSE(gjk_epa(unit_cube, upright(way * (1 + 1e-15), {1, 1, 1})));
  }
}

TEMPLATE_TEST_CASE(
    "no finite boxes, however large, small or far, have an answer that is not one", "[gjk][epa]",
    float, double)
{
  using Real = TestType;
  using Limits = std::numeric_limits<Real>;
  const Real sizes[] = {Limits::denorm_min(), Limits::min(),    Real(1e-20), 1,
                        Real(1e20),           Limits::max() / 8};
  const Matrix3<Real> turn = rational_rotation<Real>(1, 2, 3, 3);
  for (const Real x : sizes)
  {
    for (const Real y : sizes)
    {
      for (const Real away : sizes)
      {
        const Obb<Real> a{{0, 0, 0}, Matrix3<Real>::Identity(), {x, y, x}};
        const Obb<Real> b{{away / 2, away / 4, 0}, turn, {y, y, x}};
        const auto manifold = gjk_epa(a, b);
        if (manifold)
        {
          CHECK(std::isfinite(manifold->depth));
          CHECK(manifold->depth >= 0);
          CHECK(manifold->normal.norm() == Catch::Approx(1).margin(1e-5));
          CHECK(manifold->points[0].position.allFinite());
        }
        CHECK((manifold || away / 2 >= x || away / 2 >= y));
      }
    }
  }
}
// [policy]

// [K1]
TEST_CASE(
    "deep round shapes: a gap of a micrometre never closes, relative tolerance does", "[case:K1]")
{
  CHECK(failing("K1") == Names{"absolute_tolerance"});
  // EPA never closes on two spheres; the best so far is right to 0.1 mm.
  CHECK(failing("K1-b") == Names{"absolute_tolerance", "no_rebuild"});
  const ConvexPair<double> spheres = two_spheres();
  const double tolerance = tolerance_of(spheres);
  const Expansion<double> best =
      epa(spheres.support, gjk(spheres.support, spheres.start, tolerance).simplex, tolerance);
  CHECK_FALSE(best.closed);
  CHECK(best.steps == epa_limit);
  CHECK(best.depth >= two_spheres_depth);
  CHECK(best.depth <= two_spheres_depth + 1e-4);
  const ConvexPair<float> capsule = capsule_in_box();
  const float rough = tolerance_of(capsule);
  const Expansion<float> found =
      epa(capsule.support, gjk(capsule.support, capsule.start, rough).simplex, rough);
  CHECK(found.closed);
  CHECK(found.steps <= 64);
  CHECK(std::abs(double(found.depth) - capsule_in_box_depth) <= 1e-3);
}
// [K1]

// [K2]
TEST_CASE("the origin on GJK's simplex: a contact is lost unless EPA rebuilds it", "[case:K2]")
{
  CHECK(failing("K2") == Names{"no_rebuild"});
  CHECK(failing("K2-b") == Names{"no_rebuild"});
  for (const double depth : {2.0, 2.5e-4, 1e-9})
  {
    const auto [a, b] = cubes_in_line(1, cube_rotation(), depth);
    const auto manifold = gjk_epa(a, b);
    REQUIRE(manifold);
    CHECK(manifold->depth == Catch::Approx(depth).margin(rounding));
  }
}
// [K2]

// [K3]
TEST_CASE(
    "0.1 µm apart or deep: one test has one answer, two tolerances call both a hit", "[case:K3]")
{
  CHECK(failing("K3") == Names{"two_tolerances"});
  CHECK(failing("K3-b") == Names{"no_rebuild"});
  RandomCubes draw(6);
  for (int i = 0; i < 1000; ++i)
  {
    const Matrix3<double> rotation = draw.next().axes;
    for (const double depth : {1e-7, -1e-7})
    {
      const auto [a, b] = cubes_in_line(0.125, rotation, depth);
      const auto manifold = gjk_epa(a, b);
      REQUIRE(manifold.has_value() == (depth > 0));
      CHECK((!manifold || std::abs(manifold->depth - depth) <= rounding));
    }
  }
}
// [K3]

// [reported]
TEST_CASE(
    "a handle in a board's edge, reported to stop another EPA, and cubes in line: who fails",
    "[case:G14][case:G15]")
{
  CHECK(failing("G14") == Names{});
  CHECK(failing("G15") == Names{"no_rebuild"});
}

// [reported]

// [limits]
TEST_CASE("one point where four are right, and which one is chance", "[gjk][epa]")
{
  // A cube on a cube rests on a square; the one point that comes out is a corner of it.
  const Obb<double> above = upright({0, 1.9, 0}, {1, 1, 1});
  const Vector3<double> p = gjk_epa(unit_cube, above)->points[0].position;
  CHECK(equal(p, {1, 0.95, 1}));
  // Turned by a millionth of a degree, somewhere else.
  double jump = 0;
  RandomCubes draw(7);
  for (int i = 0; i < 100; ++i)
  {
    const Matrix3<double> jitter = turned(1e-8, draw.next().center);
    const auto manifold = gjk_epa(unit_cube, {above.center, jitter, above.half_extents});
    CHECK(manifold->depth == Catch::Approx(0.1).margin(1e-7));
    jump = std::max(jump, (manifold->points[0].position - p).norm());
  }
  CHECK(jump > 2.8);
}

TEST_CASE("of the equal separations of a cube in its own place every one comes out", "[gjk][epa]")
{
  RandomCubes draw(8);
  std::set<int> ways;
  for (int i = 0; i < 1000; ++i)
  {
    const Obb<double> cube{{0, 0, 0}, draw.next().axes, {1, 1, 1}};
    const Vector3<double> local = cube.axes.transpose() * gjk_epa(cube, cube)->normal;
    int axis = 0;
    CHECK(local.cwiseAbs().maxCoeff(&axis) == Catch::Approx(1).margin(rounding));
    ways.insert(local[axis] > 0 ? axis : axis + 3);
    const Vector3<double> first = separating_axes(cube, cube)->normal;
    CHECK(equal(first, cube.axes.col(0)));
  }
  CHECK(ways.size() == 6);
}
// [limits]

TEST_CASE("what holds and what fails at deep, level and random solids", "[gjk][epa][case:K4][long]")
{
  check_verdicts(
      convex_verdicts(), names_of(convex_methods()),
      {{"G14", {"gjk_epa", "absolute_tolerance", "no_rebuild", "two_tolerances"}},
       {"G15", {"gjk_epa", "absolute_tolerance", "two_tolerances"}},
       {"K1", {"gjk_epa", "no_rebuild", "two_tolerances"}},
       {"two spheres, deep", {"gjk_epa", "two_tolerances"}},
       {"K2", {"gjk_epa", "absolute_tolerance", "two_tolerances"}},
       {"two cubes in line, 0.25 mm deep", {"gjk_epa", "absolute_tolerance", "two_tolerances"}},
       {"K3", {"gjk_epa", "absolute_tolerance", "no_rebuild"}},
       {"two cubes in line, 0.1 µm deep", {"gjk_epa", "absolute_tolerance", "two_tolerances"}},
       {"K4", {"gjk_epa", "absolute_tolerance", "two_tolerances"}}});
}

TEST_CASE("the depths of the table's round shapes, and how near an answer must be", "[gjk][epa]")
{
  // The box is 11.7 high; the capsule's lower end is 2.2 above its middle, less a radius of 1.9.
  CHECK(capsule_in_box_depth == Catch::Approx(11.4).epsilon(1e-15));
  CHECK(two_spheres_depth == Catch::Approx(1.7).epsilon(1e-15));
  const ConvexMethod millimetre_off{
      "", [](const ConvexPair<float>&) { return std::optional(11.4f + 0.0012f); },
      [](const ConvexPair<double>&) { return std::optional(1.7 + 0.0012); }};
  for (const ConvexCase& one : convex_cases())
  {
    INFO(one.id);
    CHECK_FALSE((one.id[1] == '1' && one.verdict(millimetre_off).holds));
  }
  CHECK(verdict_on_depth(1.7009, 1.7, 1e-3).holds);
  CHECK_FALSE(verdict_on_depth(1.6989, 1.7, 1e-3).holds);
  CHECK(verdict_on_depth(std::nullopt, -1e-7, 1e-9).holds);
  CHECK_FALSE(verdict_on_depth(0, -1e-7, 1e-9).holds);
  CHECK_FALSE(verdict_on_depth(std::nullopt, 1e-7, 1e-9).holds);
  CHECK(random_cubes == 50'000);
}
