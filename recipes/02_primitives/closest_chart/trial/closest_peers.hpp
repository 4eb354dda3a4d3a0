#pragma once

/// \file
/// \brief Bullet's closest point of a triangle and ODE's of two segments, to be timed beside ours.

#include "02_primitives/shapes/shapes.hpp"
#include "02_primitives/shapes/trial/bullet_shapes.hpp"

#ifdef COOKBOOK_HAS_BULLET
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#endif
#ifdef COOKBOOK_HAS_ODE
#include <ode/ode.h>
#endif

#include <cmath>

namespace cookbook
{

#ifdef COOKBOOK_HAS_BULLET
/// How far a point is from a triangle, by the function that Bullet's own walk calls.
inline float bullet_distance(const Vector3<float>& point, const Triangle<float>& t)
{
  static btVoronoiSimplexSolver solver;
  btSubSimplexClosestResult result;
  const btVector3 p = of_bullet(point);
  solver.closestPtPointTriangle(p, of_bullet(t.a), of_bullet(t.b), of_bullet(t.c), result);
  return (result.m_closestPointOnSimplex - p).length();
}
#endif

#ifdef COOKBOOK_HAS_ODE
/// How far two segments are apart by ODE, which computes in double.
inline double ode_distance(const Segment<double>& a, const Segment<double>& b)
{
  struct OdeVector
  {
    explicit OdeVector(const Vector3<double>& v) : numbers{v.x(), v.y(), v.z(), 0} {}
    dVector3 numbers;
  };
  const OdeVector a1(a.start), a2(a.end), b1(b.start), b2(b.end);
  dVector3 on_a, on_b;
  dClosestLineSegmentPoints(a1.numbers, a2.numbers, b1.numbers, b2.numbers, on_a, on_b);
  const double x = on_a[0] - on_b[0], y = on_a[1] - on_b[1], z = on_a[2] - on_b[2];
  return std::sqrt(x * x + y * y + z * z);
}
#endif

} // namespace cookbook
