#pragma once

/// \file
/// \brief Jointed scenes in Bullet: as bodies with constraints between them, by either of its
/// solvers.

#if defined(COOKBOOK_HAS_BULLET)

#include "06_world/world_chart/trial/world_peer_bullet.hpp"
#include "07_constraints/joint_chart/trial/joint_peer.hpp"

#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>

#include <memory>
#include <vector>

namespace cookbook
{

/// How Bullet is run.
struct BulletSettings
{
  int substeps = 1;    ///< of 1/60 s
  int iterations = 10; ///< of its sequential impulses, as they come
  bool exact = false;  ///< by Dantzig's pivots instead
};

/// A scene of bodies and ball joints in Bullet. No two bodies touch.
class BulletJoints
{
public:
  static constexpr bool chains_only = false;

  BulletJoints(const JointedScene& of, const BulletSettings& settings)
      : settings_(settings), bullet_(at_rate(of.scene, 60 * settings.substeps))
  {
    btDiscreteDynamicsWorld& world = bullet_.world();
    world.getSolverInfo().m_numIterations = settings.iterations;
    if (settings.exact)
    {
      world.setConstraintSolver(&exact_);
    }
    for (const auto& body : bullet_.bodies())
    {
      world.removeRigidBody(body.get());
      world.addRigidBody(body.get(), 0, 0);
    }
    for (const JointPlace& joint : of.joints)
    {
      btRigidBody &a = body(joint.a), &b = body(joint.b);
      const btVector3 point = to_bullet(joint.point);
      joints_.push_back(std::make_unique<btPoint2PointConstraint>(
          a, b, a.getCenterOfMassTransform().invXform(point),
          b.getCenterOfMassTransform().invXform(point)));
      world.addConstraint(joints_.back().get(), true);
    }
  }
  ~BulletJoints()
  {
    for (const auto& joint : joints_)
    {
      bullet_.world().removeConstraint(joint.get());
    }
  }
  BulletJoints(const BulletJoints&) = delete;
  BulletJoints& operator=(const BulletJoints&) = delete;

  void go()
  {
    for (int i = 0; i < settings_.substeps; ++i)
    {
      bullet_.step();
    }
  }
  Frame state() const { return bullet_.frame(); }

private:
  static Scene at_rate(Scene scene, int rate)
  {
    scene.step = 1.0 / rate;
    return scene;
  }
  btRigidBody& body(int i) { return *bullet_.bodies()[static_cast<std::size_t>(i)]; }

  BulletSettings settings_;
  btDantzigSolver pivots_;
  btMLCPSolver exact_{&pivots_};
  BulletWorld bullet_;
  std::vector<std::unique_ptr<btPoint2PointConstraint>> joints_;
};

} // namespace cookbook

#endif
