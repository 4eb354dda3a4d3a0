#pragma once

/// \file
/// \brief ODE's boxes, placed before the clock starts, to be timed beside ours.

#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_pair.hpp"
#include "tools/measure/timing.hpp"

#include <ode/ode.h>

#include <optional>
#include <vector>

namespace cookbook
{

/// ODE: its collider of two boxes, called directly, for up to eight points.
class OdeBoxPairs
{
public:
  using Real = double; ///< as Debian builds it

  /// Places the boxes.
  explicit OdeBoxPairs(const std::vector<BoxPair<Real>>& pairs)
  {
    for (const auto& [a, b] : pairs)
    {
      boxes_.push_back(made(a));
      boxes_.push_back(made(b));
    }
  }

  /// The manifold of a pair, its points as ODE gives them.
  std::optional<Manifold<Real>> manifold(std::size_t i) const
  {
    const Answer answer = collide(i);
    Manifold<Real> manifold{
        {answer.normal[0], answer.normal[1], answer.normal[2]}, answer.depth, {}};
    for (int k = 0; k < answer.count; ++k)
    {
      const dContactGeom& contact = answer.contacts[k];
      manifold.points.push_back(
          {{contact.pos[0], contact.pos[1], contact.pos[2]}, contact.depth, 0});
    }
    return answer.count > 0 ? std::optional(manifold) : std::nullopt;
  }

  /// All pairs once.
  void run() const
  {
    for (std::size_t i = 0; 2 * i < boxes_.size(); ++i)
    {
      measure::keep(collide(i));
    }
  }

  /// All pairs once: only whether they touch.
  void run_overlaps() const
  {
    for (std::size_t i = 0; 2 * i < boxes_.size(); ++i)
    {
      const Box &a = boxes_[2 * i], &b = boxes_[2 * i + 1];
      measure::keep(dBoxTouchesBox(a.center, a.axes, a.sides, b.center, b.axes, b.sides));
    }
  }

private:
  struct Box
  {
    dVector3 center;
    dMatrix3 axes;
    dVector3 sides;
  };
  struct Answer
  {
    int count;
    dReal depth;
    dVector3 normal;
    dContactGeom contacts[8];
  };

  static Box made(const Obb<Real>& box)
  {
    Box result{};
    for (int i = 0; i < 3; ++i)
    {
      result.center[i] = box.center[i];
      result.sides[i] = 2 * box.half_extents[i];
      for (int j = 0; j < 3; ++j)
      {
        result.axes[4 * i + j] = box.axes(i, j);
      }
    }
    return result;
  }

  Answer collide(std::size_t i) const
  {
    const Box &a = boxes_[2 * i], &b = boxes_[2 * i + 1];
    Answer answer;
    int code = 0;
    answer.count = dBoxBox(
        a.center, a.axes, a.sides, b.center, b.axes, b.sides, answer.normal, &answer.depth, &code,
        8, answer.contacts, sizeof(dContactGeom));
    return answer;
  }

  std::vector<Box> boxes_;
};

} // namespace cookbook
