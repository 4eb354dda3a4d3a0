#include "tools/plot/figures/objects3d.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cookbook::plot
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double edge_width = 1.6;
constexpr double hidden_width = 1.1;
constexpr double facing = 1e-9; // of a unit normal: less is edge-on

/// How much a visible face covers: more where it turns away from a light above on the left.
double face_opacity(const Vector3d& normal)
{
  const Vector3d light(-0.35, 0.80, 0.49);
  return 0.13 + 0.20 * (1 - std::max(0.0, normal.dot(light)));
}

/// Adds the circle about `pole`, its half that faces away dashed among the hidden parts.
void add_circle(
    Object& object, const Vector3d& center, double radius, const Vector3d& pole, Ink ink)
{
  constexpr int half_steps = 28;
  const Vector3d sideways = pole.cross(Vector3d::UnitZ());
  if (sideways.norm() < 1e-6)
  {
    return; // seen face-on it is the outline
  }
  const Vector3d u = sideways.normalized();
  const Vector3d across = pole.normalized().cross(u);
  const Vector3d v = across.z() < 0 ? Vector3d(-across) : across;
  std::vector<Vector3d> front_half;
  std::vector<Vector3d> back_half;
  for (int k = 0; k <= half_steps; ++k)
  {
    const double t = 3.141592653589793 * k / half_steps;
    front_half.push_back(center + radius * (std::cos(t) * u + std::sin(t) * v));
    back_half.push_back(center + radius * (std::cos(t) * u - std::sin(t) * v));
  }
  object.behind.push_back({Part::Kind::stroke, back_half, {ink, Stroke::dashed, hidden_width}});
  object.front.push_back({Part::Kind::stroke, front_half, {ink, Stroke::solid, 1.1}});
}

/// The least distance of an object from the outer side of a plane.
double clearance(const Object& object, const FacePlane& plane)
{
  double least = std::numeric_limits<double>::max();
  for (const Vector3d& point : object.hull)
  {
    least = std::min(least, plane.normal.dot(point) - plane.distance - object.radius);
  }
  return least;
}

double depth(const Object& object)
{
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& point : object.hull)
  {
    sum += point;
  }
  return sum.z() / static_cast<double>(object.hull.size());
}

/// Depth in billionths, so that a last bit decides nothing.
std::int64_t rounded(double value)
{
  return std::llround(std::clamp(value, -1e9, 1e9) * 1e9);
}

bool apart_on_screen(const Object& p, const Object& q)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto before = [axis](const Vector3d& a, const Vector3d& b) { return a[axis] < b[axis]; };
    const auto [p_low, p_high] = std::minmax_element(p.hull.begin(), p.hull.end(), before);
    const auto [q_low, q_high] = std::minmax_element(q.hull.begin(), q.hull.end(), before);
    if ((*p_high)[axis] + p.radius < (*q_low)[axis] - q.radius ||
        (*q_high)[axis] + q.radius < (*p_low)[axis] - p.radius)
    {
      return true;
    }
  }
  return false;
}

/// Whether p must be drawn after q.
bool in_front(const Object& p, const Object& q)
{
  if (apart_on_screen(p, q))
  {
    return false;
  }
  std::int64_t widest = std::numeric_limits<std::int64_t>::min();
  double verdict = depth(p) - depth(q);
  const auto consider = [&](const Object& object, const FacePlane& plane, double sign)
  {
    const std::int64_t gap = rounded(clearance(object, plane));
    if (std::abs(plane.normal.z()) > 1e-6 && gap > widest)
    {
      widest = gap;
      verdict = sign * plane.normal.z();
    }
  };
  for (const FacePlane& plane : q.planes)
  {
    consider(p, plane, 1);
  }
  for (const FacePlane& plane : p.planes)
  {
    consider(q, plane, -1);
  }
  return rounded(verdict) > 0;
}

} // namespace

Object
box_object(const Vector3d& center, const Matrix3d& axes, const Vector3d& half_extents, Ink ink)
{
  Object object;
  const Matrix3d halves = axes * half_extents.asDiagonal();
  const auto corner = [&](int i, double a, int j, double b, int k, double c) -> Vector3d
  { return center + a * halves.col(i) + b * halves.col(j) + c * halves.col(k); };
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    for (const double sign : {-1.0, 1.0})
    {
      const Vector3d normal = sign * axes.col(i);
      object.planes.push_back({normal, normal.dot(center) + half_extents[i]});
      if (normal.z() > facing)
      {
        object.front.push_back(
            {Part::Kind::face,
             {corner(i, sign, j, -1, k, -1), corner(i, sign, j, 1, k, -1),
              corner(i, sign, j, 1, k, 1), corner(i, sign, j, -1, k, 1)},
             {ink, Stroke::solid, 0},
             face_opacity(normal)});
      }
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    for (int signs = 0; signs < 4; ++signs)
    {
      // An edge along axis i is hidden if both faces that meet in it look away.
      const double b = signs % 2 == 0 ? -1 : 1;
      const double c = signs / 2 == 0 ? -1 : 1;
      const bool hidden = b * axes.col(j).z() < facing && c * axes.col(k).z() < facing;
      const std::vector<Vector3d> ends{corner(i, -1, j, b, k, c), corner(i, 1, j, b, k, c)};
      object.hull.insert(object.hull.end(), ends.begin(), ends.end());
      const svg::Pen pen{
          ink, hidden ? Stroke::dashed : Stroke::solid, hidden ? hidden_width : edge_width};
      (hidden ? object.behind : object.front).push_back({Part::Kind::stroke, ends, pen});
    }
  }
  return object;
}

Object sphere_object(const Vector3d& center, double radius, const Vector3d& pole, Ink ink)
{
  Object object;
  object.hull = {center};
  object.radius = radius;
  object.front.push_back(
      {Part::Kind::disc, {center, center}, {ink, Stroke::solid, edge_width}, 0, radius});
  add_circle(object, center, radius, pole, ink);
  return object;
}

Object capsule_object(const Vector3d& start, const Vector3d& end, double radius, Ink ink)
{
  Object object;
  object.hull = {start, end};
  object.radius = radius;
  object.front.push_back(
      {Part::Kind::disc, {start, end}, {ink, Stroke::solid, edge_width}, 0, radius});
  if ((end - start).norm() > 0)
  {
    add_circle(object, start, radius, end - start, ink);
    add_circle(object, end, radius, end - start, ink);
  }
  return object;
}

Object
plane_object(const Vector3d& center, const Vector3d& u, const Vector3d& v, int cells, Ink ink)
{
  Object object = polygon_object(
      {center - u - v, center + u - v, center + u + v, center - u + v}, ink, Fill::none,
      Stroke::solid);
  object.front.front().pen.width = 1;
  object.front.insert(object.front.begin(), {Part::Kind::face, object.hull, {ink}, 0.06});
  for (int k = 1; k < cells; ++k)
  {
    const double t = -1 + 2.0 * k / cells;
    const svg::Pen pen{Ink::faint, Stroke::solid, 0.9};
    object.front.push_back({Part::Kind::stroke, {center + t * u - v, center + t * u + v}, pen});
    object.front.push_back({Part::Kind::stroke, {center - u + t * v, center + u + t * v}, pen});
  }
  std::rotate(object.front.begin() + 1, object.front.begin() + 2, object.front.end());
  return object;
}

Object polygon_object(const std::vector<Vector3d>& corners, Ink ink, Fill fill, Stroke stroke)
{
  Object object;
  object.hull = corners;
  // The plane that fits best, after Newell: a sum over the edges.
  Vector3d area = Vector3d::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    area += corners[k].cross(corners[(k + 1) % corners.size()]);
  }
  if (area.norm() > 0)
  {
    const Vector3d normal = area.normalized();
    object.planes.push_back({normal, normal.dot(corners.front())});
    object.planes.push_back({-normal, -normal.dot(corners.front())});
  }
  if (fill != Fill::none)
  {
    const double opacity = fill == Fill::solid ? 0.85 : 0.30;
    object.front.push_back({Part::Kind::face, corners, {ink}, opacity});
  }
  std::vector<Vector3d> outline = corners;
  outline.push_back(corners.front());
  object.front.push_back({Part::Kind::stroke, outline, {ink, stroke, edge_width}});
  return object;
}

Object stroke_object(const std::vector<Vector3d>& points, const svg::Pen& pen)
{
  Object object;
  object.hull = points;
  object.front.push_back({Part::Kind::stroke, points, pen});
  return object;
}

std::vector<std::size_t> far_to_near(const std::vector<Object>& objects)
{
  // Take the farthest object that is in front of none that remain; in a cycle, the farthest.
  std::vector<std::size_t> order;
  std::vector<bool> done(objects.size(), false);
  while (order.size() < objects.size())
  {
    std::size_t best = objects.size();
    bool best_free = false;
    for (std::size_t p = 0; p < objects.size(); ++p)
    {
      bool free = true;
      for (std::size_t q = 0; q < objects.size() && !done[p]; ++q)
      {
        free = free && (p == q || done[q] || !in_front(objects[p], objects[q]));
      }
      const bool nearer =
          best < objects.size() && rounded(depth(objects[p])) >= rounded(depth(objects[best]));
      if (!done[p] &&
          (best == objects.size() || free > best_free || (free == best_free && !nearer)))
      {
        best = p;
        best_free = free;
      }
    }
    done[best] = true;
    order.push_back(best);
  }
  return order;
}

} // namespace cookbook::plot
