// Calls what the recipes of chapter 2 on cameras and meshes offer, those whose TAKE_… is defined.
// check_take.sh includes their headers: the house's, or one that was taken.

#include "calls.hpp"

using namespace cookbook;

int main()
{
#ifdef TAKE_camera
  print(
      "camera",
      [](Draw& draw, Bits& bits)
      {
        const double stretch = draw.scale(), near = draw.number(0.1, 1);
        const Eigen::Vector3d eye = draw.vector(5) * stretch, target = draw.vector(5) * stretch;
        const Matrix4<double> lens = draw.one_in(2)
                                         ? *perspective(draw.number(0.5, 2), 1.5, near, near + 9)
                                         : *orthographic(draw.number(1, 9), 5.0, near, near + 9);
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
        bits(perspective_reversed(1.0, 1.5, near));
        if (const auto corners = view_corners<double>(camera, -1, 1))
        {
          bits(may_see(f, *corners, box), (*corners)[7]);
        }
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
}
