#pragma once

/// \file
/// \brief What a matrix was factored for, so that it is not factored again for the same.

#include "06_world/direct_solver/direct_points.hpp"
#include "06_world/direct_solver/direct_rows.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace cookbook
{

// [factored_points]
/// The points that pushed when a matrix was factored, and the rows that were within their bounds.
class FactoredPoints
{
public:
  /// Forgets all.
  void clear() { points_.clear(); }

  /// Stores the active points; none if any point slips, since then the matrix depends on by how
  /// much.
  void take(std::span<const DirectPoint> all, std::span<const DirectRow> rows = {})
  {
    points_.clear();
    within_.clear();
    for (const DirectRow& row : rows)
    {
      within_.push_back(row.at == 0);
    }
    for (const DirectPoint& point : all)
    {
      if (point.friction_state == FrictionState::slip)
      {
        return points_.clear();
      }
      if (has_impulse(point))
      {
        points_.push_back({point, point.arms});
      }
    }
  }

  /// Whether the same points push as then, in the same way, and where they were, to nine digits,
  /// and the same rows.
  bool are_those_of(std::span<const DirectPoint> all, std::span<const DirectRow> rows = {}) const
  {
    if (!std::equal(
            rows.begin(), rows.end(), within_.begin(), within_.end(),
            [](const DirectRow& row, bool within) { return (row.at == 0) == within; }))
    {
      return false;
    }
    auto then = points_.begin();
    for (const DirectPoint& now : all)
    {
      if (!has_impulse(now))
      {
        continue;
      }
      if (then == points_.end() || !is_same(now, *then))
      {
        return false;
      }
      ++then;
    }
    return then == points_.end() && !points_.empty();
  }

private:
  struct Pushed
  {
    ContactState state;
    Arms<double> arms;
  };

  static bool is_same(const DirectPoint& now, const Pushed& then)
  {
    const auto stays = [](const Vector3<double>& one, const Vector3<double>& other)
    { return (one - other).squaredNorm() <= 1e-18 * other.squaredNorm(); };
    return now == then.state && stays(now.arms.a, then.arms.a) && stays(now.arms.b, then.arms.b);
  }

  std::vector<Pushed> points_;
  std::vector<bool> within_; // of rows
};
// [factored_points]

} // namespace cookbook
