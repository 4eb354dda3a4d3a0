#pragma once

/// \file
/// \brief Jointed scenes in ODE, by its direct step or its quick one.

#if defined(COOKBOOK_HAS_ODE)

#include "07_constraints/joint_chart/trial/joint_peer.hpp"

#include <ode/ode.h>

#include <cstddef>
#include <vector>

namespace cookbook
{

/// How ODE is run.
struct OdeSettings
{
  int substeps = 1;   ///< of 1/60 s
  int iterations = 0; ///< of its quick step; zero for the direct one
};

/// A scene of boxes and ball joints in ODE: double precision as Debian builds it, its own error
/// reduction of 0.2 and softness of 1e-10. No two bodies touch.
class OdeJoints
{
public:
  static constexpr bool chains_only = false;

  OdeJoints(const JointedScene& of, const OdeSettings& settings) : settings_(settings)
  {
    static const bool begun = dInitODE2(0) != 0;
    static_cast<void>(begun);
    dRandSetSeed(0); // the quick step takes rows in random order
    world_ = dWorldCreate();
    const Vector3<double>& gravity = of.scene.gravity;
    dWorldSetGravity(world_, gravity.x(), gravity.y(), gravity.z());
    dWorldSetQuickStepNumIterations(world_, settings.iterations > 0 ? settings.iterations : 20);
    for (const SceneBody& body : of.scene.bodies)
    {
      add(body);
    }
    for (const JointPlace& joint : of.joints)
    {
      const dJointID ball = dJointCreateBall(world_, nullptr);
      dJointAttach(ball, body_of(joint.a), body_of(joint.b));
      dJointSetBallAnchor(ball, joint.point.x(), joint.point.y(), joint.point.z());
    }
  }
  ~OdeJoints() { dWorldDestroy(world_); }
  OdeJoints(const OdeJoints&) = delete;
  OdeJoints& operator=(const OdeJoints&) = delete;

  void go()
  {
    const double step = 1.0 / (60 * settings_.substeps);
    for (int i = 0; i < settings_.substeps; ++i)
    {
      settings_.iterations > 0 ? dWorldQuickStep(world_, step) : dWorldStep(world_, step);
    }
  }

  Frame state() const
  {
    Frame frame = start_;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
      if (bodies_[i] != nullptr)
      {
        const dReal *at = dBodyGetPosition(bodies_[i]), *turn = dBodyGetQuaternion(bodies_[i]);
        const dReal *v = dBodyGetLinearVel(bodies_[i]), *w = dBodyGetAngularVel(bodies_[i]);
        frame.bodies[i] = {
            {at[0], at[1], at[2]},
            {turn[0], turn[1], turn[2], turn[3]},
            {v[0], v[1], v[2]},
            {w[0], w[1], w[2]}};
      }
    }
    return frame;
  }

private:
  dBodyID body_of(int i) const { return bodies_[static_cast<std::size_t>(i)]; }

  /// What is fixed is ODE's null body.
  void add(const SceneBody& of)
  {
    start_.bodies.push_back({of.position, of.orientation, of.velocity, of.angular_velocity});
    bodies_.push_back(of.mass > 0 ? dBodyCreate(world_) : nullptr);
    if (of.mass > 0)
    {
      const dBodyID body = bodies_.back();
      dMass mass;
      if (const auto* const sphere = std::get_if<SphereShape>(&of.shape))
      {
        dMassSetSphereTotal(&mass, of.mass, sphere->radius);
      }
      else
      {
        const Vector3<double> sides = 2 * std::get<BoxShape>(of.shape).half_extents;
        dMassSetBoxTotal(&mass, of.mass, sides.x(), sides.y(), sides.z());
      }
      dBodySetMass(body, &mass);
      dBodySetPosition(body, of.position.x(), of.position.y(), of.position.z());
      const Quaternion<double>& q = of.orientation;
      const dQuaternion turn{q.w(), q.x(), q.y(), q.z()};
      dBodySetQuaternion(body, turn);
      dBodySetLinearVel(body, of.velocity.x(), of.velocity.y(), of.velocity.z());
      dBodySetAngularVel(
          body, of.angular_velocity.x(), of.angular_velocity.y(), of.angular_velocity.z());
    }
  }

  OdeSettings settings_;
  dWorldID world_;
  Frame start_{0, {}};
  std::vector<dBodyID> bodies_; // null where a body is fixed
};

} // namespace cookbook

#endif
