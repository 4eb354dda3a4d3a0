#pragma once

/// \file
/// \brief A box that is pushed at a point: how it moves then, and the mass that the push feels.

#include "05_resolution/impulse/contact_impulse.hpp"
#include "05_resolution/impulse/trial/conserved.hpp"
#include "05_resolution/impulse/trial/impulse_pitfalls.hpp"
#include "common/math/norm.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cookbook
{

/// A box at rest in the plane z = 0, its centre at the origin.
struct BoxToPush
{
  Vector3<double> half_extents{0.8, 0.4, 0.4}; ///< [m]
  MassProperties<double> properties;           ///< of its mass
  Body<double> body;                           ///< at rest
};

/// A box of a mass [kg].
inline BoxToPush box_to_push(double mass)
{
  BoxToPush box;
  const Vector3<double> zero = Vector3<double>::Zero();
  box.properties = solid_box<double>(mass, box.half_extents);
  box.body = dynamic_body<double>({zero, zero, zero}, box.properties, Matrix3<double>::Identity());
  return box;
}

/// An impulse at a point of the plane.
struct Push
{
  Vector3<double> point;   ///< [m], world
  Vector3<double> impulse; ///< [N s], world
};

/// The box's body after a push at a point, by its mass and inertia.
inline Body<double> pushed(const BoxToPush& box, const Push& push)
{
  Body<double> body = box.body;
  apply_impulse<double>(body, push.point - body.motion.center, push.impulse);
  return body;
}

/// The mass [kg] that a push feels at its point; that of the box where it has no direction.
inline double felt_mass(const BoxToPush& box, const Push& push)
{
  const double size = push.impulse.norm();
  const Vector3<double> direction =
      size > 0 ? Vector3<double>(push.impulse / size) : Vector3<double>(0, 0, 0);
  const double inverse = inverse_mass_at<double>(box.body, direction, push.point);
  return effective_mass<double>(inverse);
}

/// The corners of the box a time [s] after it began to move as a body does.
inline std::vector<Eigen::Vector2d>
corners_after(const BoxToPush& box, const Motion<double>& motion, double time)
{
  const double angle = time * motion.angular_velocity.z();
  const double c = std::cos(angle), s = std::sin(angle);
  std::vector<Eigen::Vector2d> corners;
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
  {
    const double u = x * box.half_extents.x(), v = y * box.half_extents.y();
    const Vector3<double> center = motion.center + time * motion.velocity;
    corners.emplace_back(center.x() + c * u - s * v, center.y() + s * u + c * v);
  }
  return corners;
}

/// The box as it is pushed, its velocities, and where it is 0.2 s and 0.4 s later.
///
/// An impulse of 1 N s is drawn `scale` [m] long, as is a velocity of 1 m/s.
inline plot::Figure2d pushed_box_figure(
    const BoxToPush& box, const Push& push, const Motion<double>& after, double scale,
    const plot::View& view)
{
  const auto flat = [](const Vector3<double>& v) { return Eigen::Vector2d(v.x(), v.y()); };
  const Eigen::Vector2d center(0, 0), point = flat(push.point);
  plot::Figure2d figure("pushed_box", "", view);
  figure.describe("A box, the impulse that it gets at a point, and how it moves then.");
  for (const double time : {0.4, 0.2})
  {
    figure.polygon(
        corners_after(box, after, time), plot::Ink::a, plot::Fill::none, plot::Stroke::dashed);
  }
  figure.box(center, 0, box.half_extents.head<2>(), plot::Ink::a)
      .segment(center, point, plot::Ink::muted, plot::Stroke::dashed)
      .arrow(center, scale * flat(after.velocity), plot::Ink::a, "v")
      .arrow(point, point + scale * flat(push.impulse), plot::Ink::overlap, "P")
      .dot(center, plot::Ink::ink)
      .point(point);
  const double spin = after.angular_velocity.z();
  if (std::abs(spin) > 0.01)
  {
    const double turn = std::clamp(spin / 3, -3.0, 3.0);
    figure.angle(center, 0.2, std::min(0.0, turn), std::max(0.0, turn), "ω", plot::Ink::ink);
  }
  return figure;
}

} // namespace cookbook
