#pragma once

/// \file
/// \brief The figures of joints: a door at its limit, a shoulder's cone, wheels on a kerb.

#include "07_constraints/joints/joints.hpp"
#include "07_constraints/joints/trial/door.hpp"
#include "07_constraints/wheel/trial/cart_scene.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/figures/figure3d.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace cookbook
{

/// The door from above, at every second step until it has stopped; z points down.
inline plot::Figure2d door_figure()
{
  plot::Figure2d figure("joints_door", "", {{-0.5, -0.25}, {1.5, 1.25}, 520});
  figure.describe("A door from above that turns with 10 rad/s, and stops at its limit.");
  GameWorld world = door_world("soft_steps");
  const auto leaf = [&](plot::Fill fill, plot::Stroke stroke)
  {
    const Vector3<double>& center = world.body(1).motion.center;
    const double angle = world.constraints<HingeJoints>(0)[0].angle;
    figure.box({center.x(), -center.z()}, angle, {0.5, 0.02}, plot::Ink::b, fill, stroke);
  };
  for (int frame = 0; frame < 20; ++frame, world.step())
  {
    if (frame % 2 == 0 && frame < 10)
    {
      leaf(plot::Fill::none, plot::Stroke::dotted);
    }
  }
  leaf(plot::Fill::wash, plot::Stroke::solid);
  const Eigen::Vector2d at_limit(std::cos(1.5), std::sin(1.5));
  figure.segment({0, 0}, 1.15 * at_limit, plot::Ink::overlap, plot::Stroke::dashed)
      .label(1.15 * at_limit, "upper", plot::Side::right, plot::Ink::overlap)
      .angle({0, 0}, 0.3, 0, 1.5, "1.5 rad")
      .box({0, 0}, 0, {0.05, 0.05}, plot::Ink::a)
      .label({-0.08, 0}, "A", plot::Side::left, plot::Ink::a)
      .label({0.55, -0.03}, "B as it is thrown", plot::Side::below, plot::Ink::b)
      .arrow({1.02, 0.04}, {1.02, 0.4}, plot::Ink::b, "10 rad/s");
  return figure;
}

/// An arm that rests on the cone of its shoulder.
inline plot::Figure3d shoulder_figure()
{
  const double cone = std::numbers::pi / 6;
  const SceneBody torso{.name = "torso", .shape = BoxShape{{0.2, 0.4, 0.1}}};
  SceneBody limb{.name = "arm", .shape = BoxShape{{0.3, 0.05, 0.05}}, .mass = 2};
  limb.position = {0.5, 0.3, 0};
  GameWorld world({.bodies = {torso, limb}}, solver_named("direct"));
  ConeTwistJoint shoulder = cone_twist_at(world, 0, 1, {0.2, 0.3, 0}, {1, 0, 0});
  shoulder.cone = cone;
  ConeTwistJoints shoulders;
  shoulders.add(shoulder);
  world.add(shoulders);
  for (int frame = 0; frame < 120; ++frame)
  {
    world.step();
  }
  plot::Figure3d figure("joints_shoulder", "", {.yaw = 0.5, .pitch = 0.25, .width = 520});
  figure.describe("An arm on a shoulder rests on the cone that its swing has.");
  const RigidBody& arm = world.body(1);
  figure.box({0, 0, 0}, Eigen::Matrix3d::Identity(), {0.2, 0.4, 0.1}, plot::Ink::a)
      .box(arm.motion.center, arm.axes, {0.3, 0.05, 0.05}, plot::Ink::b);
  const Eigen::Vector3d apex(0.2, 0.3, 0);
  std::vector<Eigen::Vector3d> rim;
  for (int i = 0; i <= 48; ++i)
  {
    const double around = 2 * std::numbers::pi * i / 48;
    const double out = 0.8 * std::sin(cone);
    rim.push_back(
        apex +
        Eigen::Vector3d(0.8 * std::cos(cone), out * std::cos(around), out * std::sin(around)));
  }
  figure.polyline(rim, plot::Ink::overlap, plot::Stroke::dashed);
  for (std::size_t i = 0; i < 48; i += 6)
  {
    figure.segment(apex, rim[i], plot::Ink::overlap, plot::Stroke::dotted, 1);
  }
  figure.arrow(apex, apex + Eigen::Vector3d(0.95, 0, 0), plot::Ink::ink, "a_{x}")
      .label({-0.1, -0.3, 0.1}, "A", plot::Side::automatic, plot::Ink::a)
      .label(arm.motion.center, "B", plot::Side::below, plot::Ink::b);
  return figure;
}

/// The cart of the wheel's example, which drives over a kerb of 6 cm with 2 m/s: paths of a front
/// wheel's centre and of the cart above it, and the cart as it is on the kerb.
inline plot::Figure2d kerb_figure()
{
  Scene scene = cart_scene();
  scene.bodies.push_back(
      {.name = "kerb", .shape = BoxShape{{0.4, 0.03, 1}}, .position = {2.6, 0.03, 0}});
  for (SceneBody& body : scene.bodies)
  {
    if (body.mass > 0)
    {
      body.velocity = {2, 0, 0};
    }
    if (body.mass == 5)
    {
      body.angular_velocity = {0, 0, -2 / 0.3};
    }
  }
  GameWorld world(scene, solver_named("direct"));
  WheelJoints wheels;
  for (BodyId id = 2; id < 6; ++id)
  {
    WheelJoint wheel = wheel_at(world, 1, id, {0, 0, 1}, {0, 1, 0});
    wheel.suspension = {.stiffness = 2'500, .damping = 250};
    wheel.spin = {.motor_speed = -2 / 0.3, .motor_force = 20};
    wheels.add(wheel);
  }
  world.add(wheels);
  plot::Figure2d figure("joints_kerb", "", {{-0.6, -0.12}, {4.4, 1.25}, 640});
  figure.describe("A cart on springs drives over a kerb: its wheels rise, it rises less.")
      .half_plane({0, 1}, 0)
      .box({2.6, 0.03}, 0, {0.4, 0.03}, plot::Ink::muted);
  std::vector<Eigen::Vector2d> hub, above;
  for (int frame = 0; frame < 90; ++frame, world.step())
  {
    const auto flat = [](const Vector3<double>& at) { return Eigen::Vector2d(at.x(), at.y()); };
    const RigidBody& cart = world.body(1);
    hub.push_back(flat(world.body(5).motion.center));
    above.push_back(flat(cart.motion.center + cart.axes * Vector3<double>(0.8, 0.35, 0)));
    if (frame == 52)
    {
      const double tilt = std::asin(cart.axes(1, 0));
      figure.box(flat(cart.motion.center), tilt, {1, 0.2}, plot::Ink::a);
      for (const BodyId wheel : {std::size_t(3), std::size_t(5)})
      {
        const RigidBody& round = world.body(wheel);
        const Vector3<double> spoke =
            round.orientation * Vector3<double>(0.3, 0, 0); // a sphere's axes do not turn
        figure.circle(flat(round.motion.center), 0.3, plot::Ink::b)
            .segment(
                flat(round.motion.center - spoke), flat(round.motion.center + spoke), plot::Ink::b);
      }
    }
  }
  figure.polyline(hub, plot::Ink::b, plot::Stroke::dashed)
      .polyline(above, plot::Ink::a, plot::Stroke::dashed)
      .label(hub.back(), "hub", plot::Side::right, plot::Ink::b)
      .label(above.back(), "cart", plot::Side::right, plot::Ink::a);
  return figure;
}

} // namespace cookbook
