/// \file
/// A shape with the six functions, but for the one that a test leaves out: that does not compile.

#include "06_world/contacts/scene.hpp"
#include "06_world/shapes/sphere_shape.hpp"

namespace game
{

struct Marble
{
  double radius;
};

using namespace cookbook;

inline SphereShape sphere(const Marble& marble)
{
  return {marble.radius};
}
#ifndef WITHOUT_BOUNDS
inline Eigen::AlignedBox<double, 3> bounds(const Marble& marble, const Pose& pose)
{
  return bounds(sphere(marble), pose);
}
#endif
#ifndef WITHOUT_SUPPORT
inline Vector3<double> support(const Marble& marble, const Vector3<double>& direction)
{
  return support(sphere(marble), direction);
}
#endif
#ifndef WITHOUT_MASS_PROPERTIES
inline MassProperties<double> mass_properties(const Marble& marble, double mass)
{
  return mass_properties(sphere(marble), mass);
}
#endif
#ifndef WITHOUT_EXTENT
inline Extent extent(const Marble& marble)
{
  return extent(sphere(marble));
}
#endif
#ifndef WITHOUT_DISTANCE
inline Direction<double> distance(const Marble& marble, const Vector3<double>& point)
{
  return distance(sphere(marble), point);
}
#endif
#ifndef WITHOUT_CAST
inline ShapeHit cast(const Ray<double>& ray, const Marble& marble)
{
  return cast(ray, sphere(marble));
}
#endif

} // namespace game

int main()
{
  const cookbook::SceneBody body{.name = "marble", .shape = game::Marble{1}};
  return body.shape.valueless_by_exception() ? 1 : 0;
}
