#pragma once

/// \file
/// \brief Other libraries' spheres, prepared as they like it, to be timed beside ours.

#include "02_primitives/shapes/shapes.hpp"
#include "tools/measure/timing.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#if defined(COOKBOOK_HAS_ODE)
#include <ode/ode.h>
#endif
#if defined(COOKBOOK_HAS_BULLET)
#include <BulletCollision/CollisionDispatch/btSphereSphereCollisionAlgorithm.h>
#include <btBulletCollisionCommon.h>
#endif

namespace cookbook
{

using FloatPairs = std::vector<std::pair<Sphere<float>, Sphere<float>>>;

#if defined(COOKBOOK_HAS_ODE)
/// ODE: two placed sphere geoms a pair, asked for one contact.
class OdePairs
{
public:
  /// Makes the geoms.
  explicit OdePairs(const FloatPairs& pairs)
  {
    dInitODE();
    for (const auto& [a, b] : pairs)
    {
      geoms_.push_back({made(a), made(b)});
    }
  }
  OdePairs(const OdePairs&) = delete;
  OdePairs& operator=(const OdePairs&) = delete;
  ~OdePairs()
  {
    for (const auto& [a, b] : geoms_)
    {
      dGeomDestroy(a);
      dGeomDestroy(b);
    }
    dCloseODE();
  }

  /// The depth [m] of a pair, nothing if apart.
  std::optional<double> depth(std::size_t i) const
  {
    dContactGeom contact;
    const int count = dCollide(geoms_[i].first, geoms_[i].second, 1, &contact, sizeof(contact));
    return count > 0 ? std::optional<double>(contact.depth) : std::nullopt;
  }

  /// All pairs once.
  void run() const
  {
    dContactGeom contact;
    for (const auto& [a, b] : geoms_)
    {
      dCollide(a, b, 1, &contact, sizeof(contact));
      measure::keep(contact);
    }
  }

private:
  static dGeomID made(const Sphere<float>& sphere)
  {
    const dGeomID geom = dCreateSphere(nullptr, sphere.radius);
    dGeomSetPosition(geom, sphere.center.x(), sphere.center.y(), sphere.center.z());
    return geom;
  }

  std::vector<std::pair<dGeomID, dGeomID>> geoms_;
};
#endif

#if defined(COOKBOOK_HAS_BULLET)
/// Bullet: its sphere-sphere algorithm on placed collision objects.
class BulletPairs
{
public:
  /// Makes the objects.
  explicit BulletPairs(const FloatPairs& pairs) : dispatcher_(&configuration_)
  {
    for (const auto& [a, b] : pairs)
    {
      bodies_.push_back(made(a));
      bodies_.push_back(made(b));
    }
    btCollisionAlgorithmConstructionInfo info;
    info.m_dispatcher1 = &dispatcher_;
    info.m_manifold = &manifold_;
    const auto first = wrapped(0);
    const auto second = wrapped(1);
    algorithm_ =
        std::make_unique<btSphereSphereCollisionAlgorithm>(&manifold_, info, &first, &second);
  }

  /// The depth [m] of a pair, nothing if apart.
  std::optional<double> depth(std::size_t i)
  {
    collide(i);
    return manifold_.getNumContacts() > 0
               ? std::optional<double>(-manifold_.getContactPoint(0).getDistance())
               : std::nullopt;
  }

  /// All pairs once.
  void run()
  {
    for (std::size_t i = 0; 2 * i < bodies_.size(); ++i)
    {
      collide(i);
      measure::keep(manifold_);
    }
  }

private:
  struct Body
  {
    std::unique_ptr<btSphereShape> shape;
    std::unique_ptr<btCollisionObject> object;
  };

  static Body made(const Sphere<float>& sphere)
  {
    Body body{
        std::make_unique<btSphereShape>(sphere.radius), std::make_unique<btCollisionObject>()};
    btTransform pose;
    pose.setIdentity();
    pose.setOrigin({sphere.center.x(), sphere.center.y(), sphere.center.z()});
    body.object->setCollisionShape(body.shape.get());
    body.object->setWorldTransform(pose);
    return body;
  }

  btCollisionObjectWrapper wrapped(std::size_t k) const
  {
    const Body& body = bodies_[k];
    return {nullptr, body.shape.get(), body.object.get(), body.object->getWorldTransform(), -1, -1};
  }

  void collide(std::size_t i)
  {
    const auto a = wrapped(2 * i);
    const auto b = wrapped(2 * i + 1);
    manifold_.clearManifold();
    btManifoldResult result(&a, &b);
    result.setPersistentManifold(&manifold_);
    algorithm_->processCollision(&a, &b, info_, &result);
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btPersistentManifold manifold_;
  btDispatcherInfo info_;
  std::vector<Body> bodies_;
  std::unique_ptr<btSphereSphereCollisionAlgorithm> algorithm_;
};
#endif

} // namespace cookbook
