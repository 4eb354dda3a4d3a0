// Calls what the recipes of chapter 2 on closest points and overlaps offer, those whose TAKE_… is
// defined. check_take.sh includes their headers: the house's, or one that was taken.

#include "calls.hpp"

using namespace cookbook;

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
}
