/// \file
/// What holds for meshes: no gaps, the same answers as without the tree, errors by line.

#include "02_primitives/meshes/checked_mesh.hpp"
#include "02_primitives/meshes/meshes.hpp"
#include "02_primitives/meshes/trial/mesh_file.hpp"
#include "02_primitives/meshes/trial/mesh_scenes.hpp"
#include "02_primitives/meshes/trial/meshes_cases.hpp"
#include "02_primitives/meshes/trial/meshes_figures.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/verdicts.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

using namespace cookbook;

namespace
{

using V = Vector3<double>;
using Box = Eigen::AlignedBox<double, 3>;

/// How deep a tree is below a node, and whether all boxes hold what is below.
int depth_below(
    const TriangleMesh<double>& mesh, const BoundingVolumes<double>& tree, std::size_t node)
{
  const VolumeNode<double>& one = tree.nodes[node];
  const auto first = static_cast<std::size_t>(one.first);
  for (std::size_t i = first; i < first + static_cast<std::size_t>(one.count); ++i)
  {
    REQUIRE(one.box.contains(box_of_triangle(mesh, tree.order[i])));
  }
  if (one.count > 0)
  {
    return 0;
  }
  REQUIRE(one.box.contains(tree.nodes[first].box));
  REQUIRE(one.box.contains(tree.nodes[first + 1].box));
  return 1 + std::max(depth_below(mesh, tree, first), depth_below(mesh, tree, first + 1));
}

/// Meshes of all kinds.
std::vector<TriangleMesh<double>> some_meshes()
{
  TriangleMesh<double> level = ball_mesh(2);
  for (V& vertex : level.vertices)
  {
    vertex.z() = 0;
  }
  TriangleMesh<double> at_one_place{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  at_one_place.triangles.assign(100, {0, 1, 2});
  // Sizes from 1 to 1e-300: each is a sliver of the space of the one before.
  TriangleMesh<double> shrinking;
  for (int i = 0; i < 250; ++i)
  {
    const double size = std::pow(0.0625, i);
    const int first = 3 * i;
    shrinking.vertices.insert(
        shrinking.vertices.end(), {{size, 0, 0}, {size, size, 0}, {size, 0, size}});
    shrinking.triangles.push_back({first, first + 1, first + 2});
  }
  return {ball_mesh(0), ball_mesh(3), thrown_triangles(300), level, at_one_place, shrinking, {}};
}

} // namespace

// [tree]
TEST_CASE(
    "each box holds what is below it, each triangle is in one leaf, no tree is deep", "[meshes]")
{
  for (const TriangleMesh<double>& mesh : some_meshes())
  {
    const BoundingVolumes<double> tree = build_volumes(mesh);
    std::vector<int> sorted = tree.order;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      REQUIRE(sorted[i] == static_cast<int>(i));
    }
    CHECK(tree.order.size() == mesh.triangles.size());
    if (!mesh.triangles.empty())
    {
      CHECK(depth_below(mesh, tree, 0) < 80);
    }
  }
  CHECK(build_volumes(TriangleMesh<double>{}).nodes.empty());
  const TriangleMesh<double> ball = ball_mesh(5);
  CHECK(depth_below(ball, build_volumes(ball), 0) <= 16); // 8192 triangles: log₂ is 13
}

TEST_CASE("two heaps of triangles are parted between the heaps", "[meshes]")
{
  TriangleMesh<double> mesh;
  for (int i = 0; i < 8; ++i)
  {
    const double x = i < 3 ? i : 100 + i;
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {x, 1, 0}, {x, 0, 1}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const BoundingVolumes<double> tree = build_volumes(mesh);
  const auto child = static_cast<std::size_t>(tree.nodes[0].first);
  CHECK(tree.nodes[child].box.max().x() == 2);
  CHECK(tree.nodes[child + 1].box.min().x() == 103);
  // A leaf of three, and five that are parted once more.
  CHECK(tree.nodes[child].count == 3);
  CHECK(tree.nodes[child + 1].count == 0);
  CHECK(tree.nodes.size() == 5);
}

TEST_CASE("a tree fitted again has the same boxes as one built where nothing moved", "[meshes]")
{
  const TriangleMesh<double> before = thrown_triangles(500);
  const BoundingVolumes<double> built = build_volumes(before);
  const BoundingVolumes<double> same = refitted(built, before);
  for (std::size_t i = 0; i < built.nodes.size(); ++i)
  {
    REQUIRE(same.nodes[i].box.isApprox(built.nodes[i].box, 0));
  }
  // Moved, stretched and turned inside out: boxes still hold what is below.
  TriangleMesh<double> after = before;
  for (V& vertex : after.vertices)
  {
    vertex = V(-2 * vertex.y(), vertex.x() + 7, vertex.z() * vertex.z());
  }
  CHECK(depth_below(after, refitted(built, after), 0) < 80);
}
// [tree]

// [brute_force_rays]
TEMPLATE_TEST_CASE("the nearest hit is that of asking all triangles", "[meshes]", float, double)
{
  const int queries = random_inputs / 10;
  for (const TriangleMesh<double>& each : some_meshes())
  {
    const TriangleMesh<TestType> mesh = mesh_as<TestType>(each);
    const BoundingVolumes<TestType> tree = build_volumes(mesh);
    MeshDraw draw;
    int wrong = 0, met = 0;
    for (int i = 0; i < queries; ++i)
    {
      Ray<TestType> ray{draw.point(2).template cast<TestType>(), {}};
      const V to =
          i % 3 == 0 && !each.triangles.empty() ? point_on_seam(draw, each) : draw.point(1);
      ray.direction = to.template cast<TestType>() - ray.origin;
      if (i % 7 == 0)
      {
        ray.direction[i % 3] = 0;
      }
      const auto hit = cast(ray, mesh, tree);
      const auto truth = cast_without_tree(ray, mesh);
      wrong += hit.has_value() != truth.has_value();
      if (hit && truth)
      {
        wrong +=
            hit->triangle != truth->second || hit->hit.t != static_cast<TestType>(truth->first);
        ++met;
      }
    }
    CHECK(wrong == 0);
    CHECK((met > queries / 100 || mesh.triangles.empty() || mesh.triangles.size() == 250));
  }
}
// [brute_force_rays]

// [brute_force_points]
TEMPLATE_TEST_CASE("the closest point is that of asking all triangles", "[meshes]", float, double)
{
  const int queries = random_inputs / 10;
  for (const TriangleMesh<double>& each : some_meshes())
  {
    const TriangleMesh<TestType> mesh = mesh_as<TestType>(each);
    const BoundingVolumes<TestType> tree = build_volumes(mesh);
    MeshDraw draw;
    int wrong = 0;
    for (int i = 0; i < queries && !mesh.triangles.empty(); ++i)
    {
      const double size = std::pow(10.0, draw.below(6) - 3);
      const V drawn = draw.point(size);
      const V at = i % 2 == 0 ? point_on_seam(draw, each) : V(0, 0, 0);
      const Vector3<TestType> point = (drawn + at).template cast<TestType>();
      const auto closest = closest_point_of_mesh(mesh, tree, point);
      const auto truth = closest_without_tree(mesh, point);
      wrong += closest->triangle != truth.second;
      wrong += closest->distance != static_cast<TestType>(truth.first);
    }
    CHECK(wrong == 0);
  }
  const TriangleMesh<TestType> none;
  CHECK_FALSE(closest_point_of_mesh<TestType>(none, build_volumes(none), {1, 2, 3}));
}

TEST_CASE(
    "the triangles that touch a sphere, and those near a box, are those of asking all", "[meshes]")
{
  for (const TriangleMesh<double>& mesh : some_meshes())
  {
    const BoundingVolumes<double> tree = build_volumes(mesh);
    MeshDraw draw;
    int wrong = 0;
    for (int i = 0; i < random_inputs / 100; ++i)
    {
      const Sphere<double> sphere{draw.point(1.5), draw(0, 0.5)};
      const Box box(sphere.center, V(sphere.center + draw.point(0.5).cwiseAbs()));
      std::vector<int> touching, expected;
      for (int k = 0; k < static_cast<int>(mesh.triangles.size()); ++k)
      {
        if (vector_to_triangle<double>(triangle_of(mesh, k), sphere.center).norm() <= sphere.radius)
        {
          touching.push_back(k);
        }
        if (box.intersects(box_of_triangle(mesh, k)))
        {
          expected.push_back(k);
        }
      }
      wrong += triangles_touching(mesh, tree, sphere) != touching;
      wrong += triangles_near(mesh, tree, box) != expected;
    }
    CHECK(wrong == 0);
  }
}
// [brute_force_points]

// [seams]
TEMPLATE_TEST_CASE(
    "a million rays at the seams of a closed ball, and from inside: none gets through",
    "[case:E7][long]", float, double)
{
  const TriangleMesh<TestType> ball = mesh_as<TestType>(ball_mesh(4));
  const BoundingVolumes<TestType> tree = build_volumes(ball);
  MeshDraw draw;
  int through = 0;
  for (int i = 0; i < 10 * random_inputs; ++i)
  {
    Ray<TestType> ray{};
    const Vector3<TestType> seam = point_on_seam(draw, ball);
    if (i % 2 == 0)
    {
      // From inside every ray meets the ball; this one does at a seam.
      ray.origin = draw.point(0.5).template cast<TestType>();
      ray.direction = seam - ray.origin;
    }
    else
    {
      // From outside, through a seam, to a point well inside.
      const V inside = draw.point(0.5), difference = 3 * (seam.template cast<double>() - inside);
      ray.origin = (inside + difference).template cast<TestType>();
      ray.direction = inside.template cast<TestType>() - ray.origin;
    }
    through += !cast(ray, ball, tree).has_value();
  }
  CHECK(through == 0);
}

TEST_CASE("along the axes, and exactly at corners, none gets through either", "[case:E7]")
{
  const TriangleMesh<double> ball = ball_mesh(3);
  const BoundingVolumes<double> tree = build_volumes(ball);
  for (const V& vertex : ball.vertices)
  {
    REQUIRE(cast<double>({{0, 0, 0}, vertex}, ball, tree));
    REQUIRE(cast<double>({vertex, vertex}, ball, tree)->hit.t <= 1e-15);
    for (int axis = 0; axis < 3; ++axis)
    {
      // From outside along an axis; corners on the outline may be passed.
      V from = vertex;
      from[axis] = 5;
      if (std::abs(vertex[axis]) > 1e-3)
      {
        REQUIRE(cast<double>({from, -V::Unit(axis)}, ball, tree));
        REQUIRE(cast<double>({from, V(-1e-30 * V::Unit(axis))}, ball, tree));
      }
    }
  }
}
// [seams]

// [triangle_ray]
TEST_CASE("a ray meets a triangle where fractions say so, whatever the direction", "[meshes]")
{
  MeshDraw draw;
  int wrong = 0, met = 0;
  for (int i = 0; i < random_inputs / 20; ++i)
  {
    // Small whole numbers: edges and corners are met often, and all of it is exact.
    const auto whole = [&] { return V(draw.below(7) - 3, draw.below(7) - 3, draw.below(7) - 3); };
    const Triangle<double> t{whole(), whole(), whole()};
    Ray<double> ray{whole(), whole()};
    // A direction whose longest part is a power of two, so that shearing is exact.
    ray.direction[draw.below(3)] = draw.below(2) == 0 ? 4 : -4;
    const auto hit = ray_triangle_watertight(view_along(ray), t);
    const auto product = [](const V& a, const V& b, const V& c) { return a.dot(b.cross(c)); };
    const V a = t.a - ray.origin, b = t.b - ray.origin, c = t.c - ray.origin, d = ray.direction;
    const double of_a = product(d, b, c), of_b = product(d, c, a), of_c = product(d, a, b);
    const double sum = of_a + of_b + of_c;
    const bool inside = sum != 0 && of_a * sum >= 0 && of_b * sum >= 0 && of_c * sum >= 0;
    const double depth = product(a, b, c);
    const bool truth = inside && depth * sum >= 0;
    wrong += hit.has_value() != truth;
    if (hit && truth)
    {
      ++met;
      wrong += std::abs(*hit - depth / sum) > 1e-14;
    }
  }
  CHECK(wrong == 0);
  CHECK(met > random_inputs / 1000);
}

TEST_CASE(
    "a hit says t, point and normal, from either side, for any length of direction", "[meshes]")
{
  const TriangleMesh<double> mesh{{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {{0, 1, 2}}};
  const BoundingVolumes<double> tree = build_volumes(mesh);
  const MeshHit<double> above = *cast<double>({{1, 1, 5}, {0, 0, -2}}, mesh, tree);
  CHECK(above.hit.t == 2);
  CHECK(above.hit.point == V(1, 1, 1));
  CHECK(above.hit.normal == V(0, 0, 1));
  CHECK(above.triangle == 0);
  CHECK(cast<double>({{1, 1, -5}, {0, 0, 2}}, mesh, tree)->hit.normal == V(0, 0, -1));
  CHECK_FALSE(cast<double>({{1, 1, 5}, {0, 0, 2}}, mesh, tree));
  CHECK_FALSE(cast<double>({{1, 1, 5}, {0, 0, 0}}, mesh, tree));
  CHECK_FALSE(cast<double>({{5, 5, 5}, {0, 0, -1}}, mesh, tree));
  CHECK_FALSE(cast<double>({{-5, 1, 1}, {1, 0, 0}}, mesh, tree)); // edge on
  CHECK(cast<double>({{1, 1, 1}, {0, 0, 1}}, mesh, tree)->hit.t == 0);
  CHECK(cast<double>({{2, 2, 3}, {0, 0, -1}}, mesh, tree)->hit.t == 2); // at an edge
  CHECK(cast<double>({{0, 0, 3}, {0, 0, -1}}, mesh, tree)->hit.t == 2); // at a corner
}

TEST_CASE("of two triangles at 5 and 2 the nearer one is met", "[case:E9]")
{
  const TriangleMesh<double> mesh{
      {{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}}, {{0, 1, 2}, {3, 4, 5}}};
  const auto met = cast<double>({{0.25, 0.25, 0}, {0, 0, 1}}, mesh, build_volumes(mesh));
  CHECK(met->hit.t == 2);
  CHECK(met->triangle == 1);
}
// [triangle_ray]

// [any_size]
TEMPLATE_TEST_CASE("meshes of 1e-30 and 1e30 metres, near and far", "[meshes]", float, double)
{
  using V3 = Vector3<TestType>;
  for (const double size : {1e-30, 1e-15, 1.0, 1e15, 1e30})
  {
    TriangleMesh<TestType> mesh = mesh_as<TestType>(ball_mesh(2));
    for (V3& vertex : mesh.vertices)
    {
      vertex *= static_cast<TestType>(size);
    }
    const TestType s = static_cast<TestType>(size);
    const BoundingVolumes<TestType> tree = build_volumes(mesh);
    const auto hit = cast<TestType>({V3(3 * s, 0, 0), V3(-s, 0, 0)}, mesh, tree);
    REQUIRE(hit);
    CHECK(std::abs(hit->hit.t - 2) <= 1e-6f);
    CHECK(std::abs(hit->hit.point.x() / s - 1) <= 1e-6f);
    const auto closest = closest_point_of_mesh<TestType>(mesh, tree, V3(3 * s, 0, 0));
    CHECK(std::abs(closest->distance / s - 2) <= 1e-6f);
    CHECK(closest->point == V3(s, 0, 0));
    CHECK(triangles_touching<TestType>(mesh, tree, {V3(3 * s, 0, 0), s / 64 + 2 * s}).size() == 4);
  }
}
// [any_size]

// [closest_triangle]
TEST_CASE("seen from the closest point, no corner of a triangle is on the point's side", "[meshes]")
{
  MeshDraw draw;
  double worst = 0, off = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const V a = draw.point(1);
    const double thin = std::pow(10.0, -draw.below(18));
    const V ab = draw.point(1),
            ac = i % 3 == 0 ? V(draw(-1, 2) * ab + thin * draw.point(1)) : draw.point(1);
    const Triangle<double> t{a, a + ab, i % 50 == 0 ? a : V(a + ac)};
    const V point = draw.point(i % 2 == 0 ? 1 : 3);
    const V closest = closest_point_of_triangle(t, point);
    const V difference = point - closest;
    for (const V& corner : {t.a, t.b, t.c})
    {
      // How far the corner is on the point's side, as a length.
      worst = std::max(worst, difference.dot(corner - closest) / std::max(difference.norm(), 1e-9));
    }
    off = std::max(off, vector_to_triangle<double>(t, closest).norm());
  }
  CHECK(worst <= 1e-7);
  CHECK(off <= 1e-15 * 8);
}

TEST_CASE("the closest points of a triangle's seven regions, and of flat ones", "[meshes]")
{
  const Triangle<double> t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  CHECK(closest_point_of_triangle<double>(t, {1, 1, 5}) == V(1, 1, 0));
  CHECK(closest_point_of_triangle<double>(t, {-1, -2, 3}) == V(0, 0, 0));
  CHECK(closest_point_of_triangle<double>(t, {9, -1, 3}) == V(4, 0, 0));
  CHECK(closest_point_of_triangle<double>(t, {-1, 9, 3}) == V(0, 4, 0));
  CHECK(closest_point_of_triangle<double>(t, {1, -3, 2}) == V(1, 0, 0));
  CHECK(closest_point_of_triangle<double>(t, {-3, 1, 2}) == V(0, 1, 0));
  CHECK(closest_point_of_triangle<double>(t, {4, 4, 1}) == V(2, 2, 0));
  const Triangle<double> flat{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}},
      point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  CHECK(closest_point_of_triangle<double>(flat, {3, 1, 0}) == V(3, 0, 0));
  CHECK(closest_point_of_triangle<double>(flat, {5, 1, 0}) == V(4, 0, 0));
  CHECK(closest_point_of_triangle<double>(point, {5, 1, 0}) == V(1, 2, 3));
}
// [closest_triangle]

// [mesh_errors]
TEST_CASE("a mesh with a corner that is no number, or that does not exist, is named", "[meshes]")
{
  TriangleMesh<double> mesh = ball_mesh(1);
  CHECK_NOTHROW(checked(mesh));
  mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(checked(mesh), "vertices[3].y must be finite, got nan");
  mesh = ball_mesh(0);
  mesh.triangles[5][1] = 6;
  CHECK_THROWS_WITH(checked(mesh), "triangles[5] must be of corners below 6, got 6");
  mesh.triangles[5][1] = -1;
  CHECK_THROWS_WITH(checked(mesh), "triangles[5] must be of corners below 6, got -1");
}

TEST_CASE("an OBJ file: polygons, numbers from the end, and what is passed over", "[meshes]")
{
  const TriangleMesh<double> mesh = mesh_from_obj(
      "# a square\r\nmtllib x.mtl\nv 0 0 0\nv 1 0 0 1.0\nv 1 +1 0\nv 0 1 0\nvn 0 0 1\n"
      "f 1/1/1 2//1 3 4\nf -4 -3 -1",
      "a.obj");
  CHECK(mesh.vertices.size() == 4);
  CHECK(mesh.vertices[2] == V(1, 1, 0));
  using T = std::vector<std::array<int, 3>>;
  CHECK(mesh.triangles == T{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}});
  const auto fails = [](const std::string& text, const std::string& what)
  { CHECK_THROWS_WITH(mesh_from_obj(text, "a.obj"), what); };
  fails("v 1 2", "a.obj:1: a point has three numbers, got 2");
  fails("v 1 2 x", "a.obj:1: expected a finite number, got \"x\"");
  fails("\nv 1 2 nan", "a.obj:2: expected a finite number, got \"nan\"");
  fails("v 1 2 3\nf 1 1", "a.obj:2: a face has three corners or more, got 2");
  fails("v 1 2 3\nf 1 1 2", "a.obj:2: corner \"2\" does not exist, so far there are 1");
  fails("v 1 2 3\nf 1 1 -2", "a.obj:2: corner \"-2\" does not exist, so far there are 1");
  fails("v 1 2 3\nf 1 1 0", "a.obj:2: expected the number of a corner, got \"0\"");
  fails("curv 1", "a.obj:1: unknown word \"curv\"");
}

TEST_CASE("an STL file, as text and binary: corners at one place become one", "[meshes]")
{
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                            "vertex 0 1 0\nendloop\nendfacet\n";
  const TriangleMesh<double> text =
      mesh_from_stl("solid x\n" + facet + facet + "endsolid x\n", "a.stl");
  CHECK(text.vertices.size() == 3);
  CHECK(text.triangles.size() == 2);
  std::string binary(80, 'x');
  const auto put = [&](std::uint32_t word)
  {
    for (int i = 0; i < 4; ++i)
    {
      binary += static_cast<char>(word >> (8 * i) & 255U);
    }
  };
  put(1);
  for (const float x : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
  {
    put(std::bit_cast<std::uint32_t>(x));
  }
  binary += "..";
  CHECK(mesh_from_stl(binary, "a.stl").vertices == text.vertices);
  CHECK_THROWS_WITH(
      mesh_from_stl(binary + "x", "a.stl"),
      "a.stl: neither a text, nor as long as its number of triangles says");
  binary[84 + 12 + 3] = '\x7f';
  binary[84 + 12 + 2] = '\x80';
  CHECK_THROWS_WITH(
      mesh_from_stl(binary, "a.stl"), "a.stl: triangle 0 has a number that is not finite");
  CHECK_THROWS_WITH(
      mesh_from_stl("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "a.stl"),
      "a.stl:4: a point has three numbers, got 2");
  CHECK_THROWS_WITH(
      mesh_from_stl("solid\nfacet normal 0 0 1\nouter", "a.stl"), "a.stl:3: expected loop");
  CHECK_THROWS_WITH(
      mesh_from_stl("solid\nfacet normal 0 0 1\n", "a.stl"),
      "a.stl:2: the file ends within a triangle");
  CHECK_THROWS_WITH(
      read_mesh("a.ply"), "a.ply: a mesh is read from a file that ends in .obj or .stl");
  CHECK_THROWS_WITH(read_mesh("none.obj"), "none.obj: cannot be read");
}
// [mesh_errors]

TEST_CASE("each way to cast at a mesh holds or fails as the table says", "[case:E7][case:E9]")
{
  const std::string first = "first, with bounds", nearest = "nearest, with bounds";
  const std::string best = "recommended";
  check_verdicts(
      mesh_verdicts(random_inputs), names_of(mesh_methods()),
      {{"E7", {best}},
       {"the same, a square of 1 mm", {best}},
       {"E9", {nearest, best}},
       {"a triangle that stands twice", {first, nearest, best}},
       {"a flat triangle", {first, nearest, best}},
       {"a square of 0.5 mm, met upright", {best}}});
}
