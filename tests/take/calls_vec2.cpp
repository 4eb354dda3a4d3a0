// Calls what the recipes of chapter 2 in the plane offer, those whose TAKE_… is defined.
// check_take.sh includes their headers: the house's, or one that was taken.

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
        const TurnedRectangle<double> turned{
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
        bits(double(overlaps<double>(a, b)), way_apart(circle, Circle<double>{point, 1}).depth);
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
        const TurnedRectangle<double> turned{points[0], draw.number(-2, 2), flat(draw).cwiseAbs()};
        bits(bounding_circle(turned).radius, bounding_rectangle(turned).half_extents);
      });
#endif
}
