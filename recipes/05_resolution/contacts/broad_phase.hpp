#pragma once

/// \file
/// \brief Which bodies of a world may touch: intervals along one axis, sorted and swept.

#include "05_resolution/contacts/rigid_body.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [bounds]
/// A body's bounds in the world.
struct Bounds
{
  Eigen::AlignedBox<double, 3> box; ///< [m], world; infinite for a plane
  int body;                         ///< its number
};

/// How far [m] a body reaches from its centre along the axes of the world.
struct Reach
{
  const RigidBody& body;

  Vector3<double> operator()(const BoxShape& box) const
  {
    return body.axes.cwiseAbs() * box.half_extents;
  }
  Vector3<double> operator()(const SphereShape& ball) const
  {
    return Vector3<double>::Constant(ball.radius);
  }
  Vector3<double> operator()(const PlaneShape&) const
  {
    return Vector3<double>::Constant(std::numeric_limits<double>::infinity());
  }
};

/// The bounds of a shape where its body is, wider by a margin [m].
inline Eigen::AlignedBox<double, 3>
bounds_of(const RigidBody& body, const decltype(SceneBody::shape)& shape, double margin)
{
  const Vector3<double> reach = std::visit(Reach{body}, shape) + Vector3<double>::Constant(margin);
  return {body.position - reach, body.position + reach};
}
// [bounds]

// [sweep]
/// What a scene with too many overlaps is answered with.
class TooManyContacts : public std::runtime_error
{
public:
  /// Says how many bodies there are, and how many pairs of them were counted.
  TooManyContacts(std::size_t bodies, std::size_t pairs)
      : std::runtime_error(std::to_string(bodies)
                               .append(" bodies overlap in more than ")
                               .append(std::to_string(pairs))
                               .append(" pairs: place them apart"))
  {
  }
};

/// Calls `meet(i, j)` for all pairs of bodies whose bounds overlap, the smaller number first; it
/// says whether to go on.
///
/// The bounds come in any order and are left in that of their lower ends along x. What was in order
/// in the frame before is nearly so now, and sorted by a few exchanges.
template <class Meet>
void each_overlap(std::vector<Bounds>& bounds, const Meet& meet)
{
  const auto low = [](const Bounds& one) { return one.box.min().x(); };
  for (std::size_t i = 1; i < bounds.size(); ++i)
  {
    for (std::size_t j = i; j > 0 && low(bounds[j]) < low(bounds[j - 1]); --j)
    {
      std::swap(bounds[j], bounds[j - 1]);
    }
  }
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    const double end = bounds[i].box.max().x();
    for (std::size_t j = i + 1; j < bounds.size() && low(bounds[j]) <= end; ++j)
    {
      if (bounds[i].box.intersects(bounds[j].box))
      {
        const auto [first, second] = std::minmax(bounds[i].body, bounds[j].body);
        if (!meet(first, second))
        {
          return;
        }
      }
    }
  }
}

/// All pairs of bodies whose bounds overlap, in order of number; TooManyContacts if there are more
/// than 100 for each body.
inline std::vector<std::pair<int, int>> overlapping_pairs(std::vector<Bounds>& bounds)
{
  const std::size_t most = 100 * bounds.size();
  std::vector<std::pair<int, int>> pairs;
  each_overlap(
      bounds,
      [&](int a, int b)
      {
        pairs.emplace_back(a, b);
        return pairs.size() <= most;
      });
  if (pairs.size() > most)
  {
    throw TooManyContacts(bounds.size(), most);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}
// [sweep]

} // namespace cookbook
