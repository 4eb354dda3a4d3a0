#pragma once

/// \file
/// \brief Bullet as a world: the same scene, with its defaults, to be measured beside ours.

#if defined(COOKBOOK_HAS_BULLET)

#include "06_world/scenes/trial/frames.hpp"
#include "06_world/world_chart/trial/bullet_numbers.hpp"

#include <btBulletDynamicsCommon.h>

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace cookbook
{

/// A scene in Bullet, built once, then stepped.
///
/// All is as Bullet has it by default: its broad phase, margins, ten iterations, split impulses,
/// single precision as Debian builds it. Only sleeping is off, each step is one of the scene's, and
/// two surfaces meet as ours do: with the geometric mean of their frictions, and with the larger
/// restitution.
class BulletWorld
{
public:
  /// Builds the scene.
  explicit BulletWorld(const Scene& scene) : step_(static_cast<btScalar>(scene.step))
  {
    gCalculateCombinedFrictionCallback = combined_friction;
    gCalculateCombinedRestitutionCallback = combined_restitution;
    world_.setGravity(to_bullet(scene.gravity));
    for (const SceneBody& body : scene.bodies)
    {
      add(body);
    }
  }

  /// Takes the bodies out of Bullet's world before they end.
  ~BulletWorld()
  {
    for (const auto& body : bodies_)
    {
      world_.removeRigidBody(body.get());
    }
  }
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  /// Goes on by one step of the scene.
  void step()
  {
    world_.stepSimulation(step_, 0);
    ++steps_;
  }

  /// Bullet's own world, for what a scene does not say, and its bodies in the scene's order.
  btDiscreteDynamicsWorld& world() { return world_; }
  const std::vector<std::unique_ptr<btRigidBody>>& bodies() const { return bodies_; }

  /// Where the bodies are, in the scene's order.
  Frame frame() const
  {
    Frame frame{steps_ * static_cast<double>(step_), {}};
    for (const auto& body : bodies_)
    {
      const btTransform& pose = body->getCenterOfMassTransform();
      frame.bodies.push_back(
          {from_bullet(pose.getOrigin()), from_bullet(pose.getRotation()),
           from_bullet(body->getLinearVelocity()), from_bullet(body->getAngularVelocity())});
    }
    return frame;
  }

  /// The deepest overlap [m] at any of Bullet's contact points.
  double deepest_overlap()
  {
    double most = 0;
    each_point([&most](const btManifoldPoint& point, int, int)
               { most = std::max(most, -double(point.getDistance())); });
    return most;
  }

  /// The impulses [N s] that each body gets, upwards and along normals, from bodies before it.
  std::vector<double> warm_start_impulse()
  {
    std::vector<double> sums(bodies_.size(), 0.0);
    each_point(
        [&sums](const btManifoldPoint& point, int a, int b)
        {
          // Bullet's normal points from its second body to its first.
          const double up = double(point.getAppliedImpulse()) * double(point.m_normalWorldOnB.y());
          sums[static_cast<std::size_t>(std::max(a, b))] += a > b ? up : -up;
        });
    return sums;
  }

private:
  template <class Visit>
  void each_point(const Visit& visit)
  {
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i)
    {
      const btPersistentManifold& contact = *dispatcher_.getManifoldByIndexInternal(i);
      for (int j = 0; j < contact.getNumContacts(); ++j)
      {
        visit(
            contact.getContactPoint(j), contact.getBody0()->getUserIndex(),
            contact.getBody1()->getUserIndex());
      }
    }
  }

  static btScalar combined_friction(const btCollisionObject* a, const btCollisionObject* b)
  {
    return btSqrt(a->getFriction() * b->getFriction());
  }
  static btScalar combined_restitution(const btCollisionObject* a, const btCollisionObject* b)
  {
    return std::max(a->getRestitution(), b->getRestitution());
  }

  static std::unique_ptr<btCollisionShape> shape_of(const SceneBody& body)
  {
    if (const auto* const box = std::get_if<BoxShape>(&body.shape))
    {
      return std::make_unique<btBoxShape>(to_bullet(box->half_extents));
    }
    if (const auto* const sphere = std::get_if<SphereShape>(&body.shape))
    {
      return std::make_unique<btSphereShape>(static_cast<btScalar>(sphere->radius));
    }
    const PlaneShape& plane = std::get<PlaneShape>(body.shape);
    return std::make_unique<btStaticPlaneShape>(
        to_bullet(plane.normal), static_cast<btScalar>(plane.offset));
  }

  void add(const SceneBody& body)
  {
    shapes_.push_back(shape_of(body));
    const btScalar mass = static_cast<btScalar>(body.mass);
    btVector3 inertia(0, 0, 0);
    if (mass > 0)
    {
      shapes_.back()->calculateLocalInertia(mass, inertia);
    }
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shapes_.back().get(), inertia);
    info.m_startWorldTransform = btTransform(to_bullet(body.orientation), to_bullet(body.position));
    info.m_friction = static_cast<btScalar>(body.friction);
    info.m_restitution = static_cast<btScalar>(body.restitution);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setLinearVelocity(to_bullet(body.velocity));
    bodies_.back()->setAngularVelocity(to_bullet(body.angular_velocity));
    bodies_.back()->setUserIndex(static_cast<int>(bodies_.size()) - 1);
    bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(bodies_.back().get());
  }

  btScalar step_;
  int steps_ = 0;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

/// All frames of a scene in Bullet, the first one among them.
inline std::vector<Frame> bullet_frames(const Scene& scene)
{
  BulletWorld world(scene);
  std::vector<Frame> frames{world.frame()};
  const int steps = static_cast<int>(std::lround(scene.duration / scene.step));
  for (int i = 0; i < steps; ++i)
  {
    world.step();
    frames.push_back(world.frame());
  }
  return frames;
}

} // namespace cookbook

#endif
