#pragma once

/// \file
/// \brief FCL's boxes, placed before the clock starts, to be timed beside ours.

#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_pair.hpp"
#include "tools/measure/timing.hpp"

#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace cookbook
{

/// FCL: its collide() for two boxes, with contacts.
class FclBoxPairs
{
public:
  using Real = double; ///< the one that Debian builds ahead

  /// Places the boxes.
  explicit FclBoxPairs(const std::vector<BoxPair<Real>>& pairs)
  {
    for (const auto& [a, b] : pairs)
    {
      pairs_.push_back({shape(a), shape(b), pose(a), pose(b)});
    }
  }

  /// The manifold of a pair, its points as FCL gives them.
  std::optional<Manifold<Real>> manifold(std::size_t i) const
  {
    fcl::CollisionResultd result;
    collide(i, result);
    Manifold<Real> manifold{{0, 0, 0}, 0, {}};
    for (std::size_t k = 0; k < std::min<std::size_t>(result.numContacts(), 8); ++k)
    {
      const fcl::Contactd& contact = result.getContact(k);
      manifold.normal = contact.normal;
      manifold.depth = std::max(manifold.depth, contact.penetration_depth);
      manifold.points.push_back({contact.pos, contact.penetration_depth, 0});
    }
    return manifold.points.empty() ? std::nullopt : std::optional(manifold);
  }

  /// All pairs once.
  void run() const
  {
    fcl::CollisionResultd result;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
    {
      result.clear();
      collide(i, result);
      measure::keep(result);
    }
  }

private:
  struct Pair
  {
    fcl::Boxd a, b;
    fcl::Transform3d pose_a, pose_b;
  };

  static fcl::Boxd shape(const Obb<Real>& box)
  {
    return fcl::Boxd(Vector3<Real>(2 * box.half_extents));
  }
  static fcl::Transform3d pose(const Obb<Real>& box)
  {
    fcl::Transform3d result = fcl::Transform3d::Identity();
    result.linear() = box.axes;
    result.translation() = box.center;
    return result;
  }

  void collide(std::size_t i, fcl::CollisionResultd& result) const
  {
    const Pair& pair = pairs_[i];
    fcl::collide(&pair.a, pair.pose_a, &pair.b, pair.pose_b, {8, true}, result);
  }

  std::vector<Pair> pairs_;
};

} // namespace cookbook
