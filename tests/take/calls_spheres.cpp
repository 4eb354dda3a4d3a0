// Calls what the recipes of chapter 3 offer, those whose TAKE_… is defined. check_take.sh includes
// their headers: the house's, or one that was taken.

#include "calls.hpp"

using namespace cookbook;

int main()
{
#ifdef TAKE_collision
  print(
      "collision",
      [](Draw& draw, Bits& bits)
      {
        const Manifold<double> manifold{draw.unit(), draw.number(0, 1), {}};
        const Motion<double> a{draw.vector(1), draw.vector(1), draw.vector(1)};
        const Motion<double> b{draw.vector(1), draw.vector(1), draw.vector(1)};
        const Eigen::Vector3d velocity = relative_velocity(a, b, draw.vector(1));
        bits(velocity, approach(velocity, manifold.normal, 0.1));
        bits(nature<double>(manifold, 0.1), nature<double>(std::nullopt, 0.1));
        const double inverse_a = draw.number(0, 1), inverse_b = draw.number(0, 1);
        const SeparatingMoves<double> moves = separating_moves(manifold, inverse_a, inverse_b);
        bits(moves.a, moves.b);
      });
#endif
#ifdef TAKE_plain_spheres
  print(
      "plain_spheres",
      [](Draw& draw, Bits& bits)
      {
        const Sphere<double> a = draw.sphere<Sphere>(1), b = draw.sphere<Sphere>(1);
        const Plane<double> plane{draw.unit(), draw.number(-1, 1)};
        const Capsule<double> capsule{{draw.vector(1), draw.vector(1)}, b.radius};
        bits(plain_sphere_sphere(a, b), plain_sphere_plane(a, plane));
        bits(plain_sphere_capsule(a, capsule), plain_sphere_box(a, draw.box<Obb>(1)));
      });
#endif
#ifdef TAKE_sphere_sphere
  print(
      "sphere_sphere",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Sphere<double> a = draw.sphere<Sphere>(scale), b = draw.sphere<Sphere>(scale);
        bits(sphere_sphere(a, b));
        bits(sphere_sphere_relative<double>(b.center - a.center, a.radius, b.radius));
      });
#endif
#ifdef TAKE_sphere_box
  print(
      "sphere_box",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Sphere<double> sphere = draw.sphere<Sphere>(scale);
        bits(sphere_box(sphere, draw.box<Obb>(scale)));
      });
#endif
#ifdef TAKE_sphere_plane
  print(
      "sphere_plane",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Sphere<double> sphere = draw.sphere<Sphere>(scale);
        const Plane<double> plane{draw.unit(), draw.number(-1, 1) * scale};
        bits(sphere_plane(sphere, plane), signed_distance(plane, sphere.center));
      });
#endif
#ifdef TAKE_sphere_capsule
  print(
      "sphere_capsule",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Sphere<double> sphere = draw.sphere<Sphere>(scale);
        const Segment<double> segment{draw.vector(1) * scale, draw.vector(1) * scale};
        const Capsule<double> capsule{segment, draw.number(0, 1) * scale};
        bits(sphere_capsule(sphere, capsule), closest_point(segment, sphere.center));
      });
#endif
}
