// Calls what the recipes of chapter 2 offer, those whose TAKE_… is defined. check_take.sh includes
// their headers: the house's, or one that was taken.

#include "calls.hpp"

#include <vector>

using namespace cookbook;

namespace
{

#if defined(TAKE_in_the_plane) || defined(TAKE_bounding_circle)
Eigen::Vector2d flat(Draw& draw)
{
  return draw.vector(3).head<2>();
}
#endif

} // namespace

int main()
{
#ifdef TAKE_closest_points
  print(
      "closest_points",
      [](Draw& draw, Bits& bits)
      {
        const double m = draw.scale();
        const Eigen::Vector3d p = draw.vector(2) * m, q = draw.vector(2) * m;
        const Eigen::Vector3d r = draw.vector(2) * m, s = draw.vector(2) * m;
        const Capsule<double> capsule{{p, q}, draw.number(0, 1) * m};
        const Triangle<double> triangle{q, r, s};
        const Tetrahedron<double> solid{p, r, s, q};
        const Obb<double> box{draw.vector(2) * m, draw.axes(), draw.half_extents() * m};
        const Plane<double> plane{draw.unit(), draw.number(-1, 1) * m};
        const auto add = [&bits](const ClosestPoints<double, 3>& points)
        { bits(points.a, points.b, points.distance); };
        add(closest_points(p, triangle));
        add(closest_points(capsule, box));
        add(closest_points(triangle, box));
        add(closest_points(solid, Aabb<double>(p.cwiseMin(s), p.cwiseMax(s))));
        add(closest_points(plane, solid));
        add(closest_points(plane, Plane<double>{draw.unit(), m}));
      });
#endif
#ifdef TAKE_closest_point_box
  print(
      "closest_point_box",
      [](Draw& draw, Bits& bits)
      {
        const Obb<double> box = draw.box<Obb>();
        const Eigen::Vector3d point = draw.vector(2);
        bits(closest_point(box, point), contains(box, point));
        bits(signed_distance_box(point, box.half_extents));
      });
#endif
#ifdef TAKE_overlaps
  print(
      "overlaps",
      [](Draw& draw, Bits& bits)
      {
        const double m = draw.scale();
        const Sphere<double> ball{draw.vector(2) * m, draw.number(0, 1) * m};
        const Obb<double> box{draw.vector(2) * m, draw.axes(), draw.half_extents() * m};
        const Plane<double> plane{draw.unit(), draw.number(-1, 1) * m};
        bits(overlaps(ball, box), overlaps(plane, ball), overlaps(box, plane));
      });
#endif
#ifdef TAKE_casts
  print(
      "casts",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const auto point = [&]() -> Eigen::Vector3d { return draw.vector(2) * scale; };
        const Eigen::Vector3d p = point(), q = point(), r = point(), s = point();
        const Eigen::Vector3d origin = draw.vector(4) * scale, aim = draw.vector(1) * scale;
        const Ray<double> ray{origin, aim - origin};
        const Segment<double> segment{origin, aim};
        const auto both = [&](const auto& shape)
        {
          for (const auto& hit : {cast(ray, shape), cast(segment, shape)})
          {
            bits(hit.has_value());
            if (hit)
            {
              bits(hit->t, hit->point, hit->normal);
            }
          }
        };
        const double radius = draw.number(0, 1.4) * scale;
        both(Plane<double>{draw.unit(), radius});
        both(draw.sphere<Sphere>(scale));
        both(Capsule<double>{{p, q}, radius});
        both(Aabb<double>(p.cwiseMin(q), p.cwiseMax(q)));
        both(draw.box<Obb>(scale));
        both(Triangle<double>{p, q, r});
        both(Tetrahedron<double>{p, q, r, s});
      });
#endif
#ifdef TAKE_camera
  print(
      "camera",
      [](Draw& draw, Bits& bits)
      {
        const double stretch = draw.scale(), near_plane = draw.number(0.1, 1);
        const Eigen::Vector3d eye = draw.vector(5) * stretch, target = draw.vector(5) * stretch;
        const Matrix4<double> lens =
            draw.one_in(2) ? *perspective(draw.number(0.5, 2), 1.5, near_plane, near_plane + 9)
                           : *orthographic(draw.number(1, 9), 5.0, near_plane, near_plane + 9);
        const Camera<double> camera{look_at<double>(eye, target, draw.unit()), lens, {640, 480}};
        const Eigen::Vector3d point = draw.vector(9) * stretch;
        const Eigen::Vector2d pixel(draw.number(0, 640), draw.number(0, 480));
        bits(camera.pose.matrix(), clip_from_world(camera));
        if (const auto seen = to_pixel(camera, point))
        {
          bits(seen->pixel, seen->depth, unproject(camera, *seen));
        }
        const Ray<double> ray = picking_ray<double>(camera, pixel);
        bits(ray.origin, ray.direction);
        const Frustum<double> f =
            frustum_planes<double>(clip_from_world(camera), DepthRange::minus_one_to_one);
        for (const Plane<double>& plane : f.planes)
        {
          bits(plane.normal, plane.distance);
        }
        const double radius = draw.number(0, 2);
        const Eigen::AlignedBox3d box(point, Eigen::Vector3d(point + draw.half_extents()));
        bits(may_see(f, Sphere<double>{point, radius}), may_see(f, box));
        bits(perspective_reversed(1.0, 1.5, near_plane));
        if (const auto corners = view_corners<double>(camera, -1, 1))
        {
          bits(may_see(f, *corners, box), (*corners)[7]);
        }
      });
#endif
#ifdef TAKE_picture
  print(
      "picture",
      [](Draw& draw, Bits& bits)
      {
        const double yaw = draw.number(-3, 3), pitch = draw.number(0.1, 1.5);
        const Camera<double> camera = orbit_camera({{0, 0, 0}, 6, yaw, pitch, 0.8}, 24, 16);
        const Obb<double> box{draw.vector(2), draw.axes(), draw.half_extents()};
        const Sphere<double> sphere{draw.vector(2), draw.number(0, 1)};
        const Capsule<double> capsule{{draw.vector(2), draw.vector(2)}, draw.number(0, 1)};
        Picture picture = make_picture(24, 16, 2);
        clear(picture, light_palette());
        draw_ground(picture, camera, floor_at(-1, 4), light_palette());
        draw_shadow(picture, camera, floor_at(-1, 4), box, {0, 0, 0, 99});
        draw_box(picture, camera, box, {200, 0, 0});
        draw_sphere(picture, camera, sphere, draw.axes(), {0, 200, 0});
        draw_capsule(picture, camera, capsule, {0, 0, 200});
        draw_arrow(picture, camera, draw.vector(2), draw.vector(2), {0, 0, 0});
        bits(picture_hash(picture), picture_hash(shown(picture)));
      });
#endif
#ifdef TAKE_meshes
  print(
      "meshes",
      [](Draw& draw, Bits& bits)
      {
        const double stretch = draw.one_in(8) ? std::ldexp(1.0, -100) : 1.0;
        TriangleMesh<double> mesh;
        for (int i = 0; i < 20; ++i)
        {
          for (int k = 0; k < 3; ++k)
          {
            mesh.vertices.push_back(draw.vector(2) * stretch);
          }
          mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        const BoundingVolumes<double> tree = refitted(build_volumes(mesh), mesh);
        const Eigen::Vector3d origin = draw.vector(3) * stretch, direction = draw.unit();
        if (const auto met = cast<double>({origin, direction}, mesh, tree))
        {
          bits(met->hit.t, met->hit.point, met->hit.normal, met->triangle);
        }
        const auto closest = closest_point_of_mesh<double>(mesh, tree, origin);
        bits(closest->point, closest->distance, closest->triangle);
        bits(closest_point_of_triangle(triangle_of(mesh, 3), origin));
        const double radius = draw.number(0, 1) * stretch;
        const Eigen::Vector3d more = origin + draw.half_extents() * stretch;
        for (const int i : triangles_touching<double>(mesh, tree, {origin, radius}))
        {
          bits(i);
        }
        for (const int i : triangles_near<double>(mesh, tree, {origin, more}))
        {
          bits(i);
        }
      });
#endif
#ifdef TAKE_in_the_plane
  print(
      "in_the_plane",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Eigen::Vector2d point = flat(draw) * scale;
        const Segment2<double> segment{flat(draw) * scale, flat(draw) * scale};
        const Circle<double> circle{flat(draw) * scale, draw.number(0, 2) * scale};
        const Rectangle<double> rectangle{flat(draw) * scale, flat(draw).cwiseAbs() * scale};
        const OrientedRectangle<double> turned{
            flat(draw) * scale, draw.number(-2, 2), flat(draw).cwiseAbs() * scale};
        const Ray2<double> ray{point, flat(draw)};
        const auto all = [&](const auto& shape)
        {
          for (const ClosestPoints<double, 2>& found :
               {closest_points(point, shape), closest_points(segment, shape),
                closest_points(turned, shape), closest_points(shape, circle)})
          {
            bits(found.a, found.b, found.distance);
          }
          bits(double(overlaps(rectangle, shape)), double(contains(shape, point)));
          for (const auto& hit : {cast(ray, shape), cast(segment, shape)})
          {
            bits(double(hit.has_value()));
            if (hit)
            {
              bits(hit->t, hit->point, hit->normal);
            }
          }
        };
        all(segment);
        all(circle);
        all(rectangle);
        all(turned);
        const std::vector<Eigen::Vector2d> a{flat(draw), flat(draw), flat(draw)};
        const std::vector<Eigen::Vector2d> b{flat(draw), flat(draw), flat(draw)};
        bits(
            double(overlaps<double>(a, b)),
            minimum_translation(circle, Circle<double>{point, 1}).depth);
      });
#endif
#ifdef TAKE_bounding_circle
  print(
      "bounding_circle",
      [](Draw& draw, Bits& bits)
      {
        std::vector<Eigen::Vector2d> points;
        const double scale = draw.scale();
        while (points.empty() || !draw.one_in(6))
        {
          points.push_back(flat(draw) * scale);
        }
        const Circle<double> least = minimal_circle<double>(points);
        const Circle<double> centroid = centroid_circle<double>(points);
        const Rectangle<double> rectangle = bounding_rectangle<double>(points);
        bits(least.center, least.radius, centroid.center, centroid.radius);
        bits(rectangle.center, rectangle.half_extents);
        const OrientedRectangle<double> turned{
            points[0], draw.number(-2, 2), flat(draw).cwiseAbs()};
        bits(bounding_circle(turned).radius, bounding_rectangle(turned).half_extents);
      });
#endif
}
