#pragma once

/// \file
/// \brief Chains in Bullet as one multibody: a tree of links by Featherstone's algorithm, whose
/// joints cannot come apart.

#if defined(COOKBOOK_HAS_BULLET)

#include "06_world/contacts/start_body.hpp"
#include "07_constraints/joint_chart/trial/joint_peer_bullet.hpp"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <cstddef>
#include <vector>

namespace cookbook
{

/// A chain whose first body is fixed, each joint between a body and the one after it, in Bullet.
/// Bullet's own damping of links, a twenty-fifth of the velocity a second, is off.
class BulletMultibody
{
public:
  static constexpr bool chains_only = true;

  BulletMultibody(const JointedScene& of, int substeps)
      : start_(first_frame(of.scene)),
        substeps_(substeps),
        chain_(static_cast<int>(of.joints.size()), 0, btVector3(0, 0, 0), true, false)
  {
    world_.setGravity(to_bullet(of.scene.gravity));
    for (const JointPlace& joint : of.joints)
    {
      hang(of.scene.bodies[index_of(joint.b)], of.scene.bodies[index_of(joint.a)], joint);
    }
    chain_.setBasePos(to_bullet(of.scene.bodies[0].position));
    chain_.setLinearDamping(0);
    chain_.setAngularDamping(0);
    chain_.finalizeMultiDof();
    world_.addMultiBody(&chain_);
  }
  ~BulletMultibody() { world_.removeMultiBody(&chain_); }
  BulletMultibody(const BulletMultibody&) = delete;
  BulletMultibody& operator=(const BulletMultibody&) = delete;

  void go()
  {
    const btScalar step = static_cast<btScalar>(1.0 / (60 * substeps_));
    for (int i = 0; i < substeps_; ++i)
    {
      world_.stepSimulation(step, 0);
    }
  }

  Frame state()
  {
    btAlignedObjectArray<btQuaternion> turns;
    btAlignedObjectArray<btVector3> origins, spins, velocities;
    chain_.forwardKinematics(turns, origins);
    spins.resize(chain_.getNumLinks() + 1);
    velocities.resize(chain_.getNumLinks() + 1);
    chain_.compTreeLinkVelocities(&spins[0], &velocities[0]);
    Frame frame = start_;
    for (int i = 0; i < chain_.getNumLinks(); ++i)
    {
      const btTransform& pose = chain_.getLink(i).m_cachedWorldTransform;
      const btMatrix3x3& axes = pose.getBasis();
      frame.bodies[index_of(i + 1)] = {
          from_bullet(pose.getOrigin()), from_bullet(pose.getRotation()),
          from_bullet(axes * velocities[i + 1]), from_bullet(axes * spins[i + 1])};
    }
    return frame;
  }

private:
  void hang(const SceneBody& body, const SceneBody& parent, const JointPlace& joint)
  {
    const Vector3<double> moments = rigid_body(body).moments;
    const Quaternion<double> back = parent.orientation.conjugate();
    const Quaternion<double> own = body.orientation.conjugate();
    chain_.setupSpherical(
        joint.b - 1, static_cast<btScalar>(body.mass), to_bullet(moments), joint.a - 1,
        to_bullet(own * parent.orientation), to_bullet(back * (joint.point - parent.position)),
        to_bullet(own * (body.position - joint.point)), true);
    if (!body.velocity.isZero(0)) // an impulse at that link, in the first step
    {
      chain_.addLinkForce(joint.b - 1, to_bullet(60.0 * substeps_ * body.mass * body.velocity));
    }
  }

  Frame start_;
  int substeps_;
  btMultiBody chain_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_phase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
};

} // namespace cookbook

#endif
