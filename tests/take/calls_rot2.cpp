// Calls what the recipe of casts offers, if its TAKE_… is defined. check_take.sh includes its
// headers: the house's, or one that was taken.

#include "calls.hpp"

using namespace cookbook;

int main()
{
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
}
