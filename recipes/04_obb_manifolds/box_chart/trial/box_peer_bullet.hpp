#pragma once

/// \file
/// \brief Bullet's boxes, placed before the clock starts, to be timed beside ours.

#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_pair.hpp"
#include "tools/measure/timing.hpp"

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace cookbook
{

/// Bullet: its detector of two boxes, called directly.
class BulletBoxPairs
{
public:
  using Real = float; ///< as Debian builds it

  /// Places the boxes.
  explicit BulletBoxPairs(const std::vector<BoxPair<Real>>& pairs)
  {
    for (const auto& [a, b] : pairs)
    {
      pairs_.push_back({shape(a), shape(b), {}});
      pairs_.back().input.m_transformA = pose(a);
      pairs_.back().input.m_transformB = pose(b);
    }
  }

  /// The manifold of a pair, its points as Bullet gives them.
  std::optional<Manifold<Real>> manifold(std::size_t i) const
  {
    Points found;
    collide(i, found);
    return found.manifold.points.empty() ? std::nullopt : std::optional(found.manifold);
  }

  /// All pairs once.
  void run() const
  {
    for (std::size_t i = 0; i < pairs_.size(); ++i)
    {
      Points found;
      collide(i, found);
      measure::keep(found);
    }
  }

private:
  struct Pair
  {
    btBoxShape a, b;
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  };

  /// Takes the points as they come.
  struct Points : btDiscreteCollisionDetectorInterface::Result
  {
    Manifold<Real> manifold{{0, 0, 0}, 0, {}};

    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
    void addContactPoint(const btVector3& on_b, const btVector3& p, btScalar distance) override
    {
      manifold.normal = -Vector3<Real>(on_b.x(), on_b.y(), on_b.z());
      manifold.depth = std::max(manifold.depth, -distance);
      manifold.points.push_back({{p.x(), p.y(), p.z()}, -distance, 0});
    }
  };

  static btVector3 vector(const Vector3<Real>& v) { return {v.x(), v.y(), v.z()}; }
  static btBoxShape shape(const Obb<Real>& box) { return btBoxShape(vector(box.half_extents)); }
  static btTransform pose(const Obb<Real>& box)
  {
    const Matrix3<Real>& m = box.axes;
    return btTransform(
        {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)},
        vector(box.center));
  }

  void collide(std::size_t i, Points& found) const
  {
    const Pair& pair = pairs_[i];
    btBoxBoxDetector(&pair.a, &pair.b).getClosestPoints(pair.input, found, nullptr);
  }

  std::vector<Pair> pairs_;
};

} // namespace cookbook
