#pragma once

/// \file
/// \brief Contacts that give way for a while, so that an island returns to exact answers.

#include "06_world/contacts/world_contact.hpp"
#include "06_world/direct_solver/direct_points.hpp"

#include <algorithm>

namespace cookbook
{

// [direct_softening]
/// How soft contacts are at first, where no exact answer was found.
struct SofteningSettings
{
  double push = 0.03;         ///< [1], of the inverse masses: no contact is softer
  double friction = 0.9;      ///< [1], the same of friction
  double normal_speed = 0.01; ///< [m/s], at which a contact gives way to what pushed there last
  double tangent_speed = 0.3; ///< [m/s], the same of friction
  double kept = 0.9;          ///< [1], fraction of the friction that stays from frame to frame
  double tolerance =
      1e-8;               ///< [1], of the largest impulse: what may be left of a residual meanwhile
  double decay = 0.95;    ///< [1], how soft contacts are after a frame, of what they were
  double smallest = 1e-7; ///< [1], from here on contacts are stiff
};

/// How stiff the points of a contact are that has these inverse masses [1/kg] together.
inline DirectStiffness
stiffness_of(const WorldContact& contact, double inverse_mass, const DirectSettings& settings)
{
  const SofteningSettings how;
  double pushed = 0; // [N s], in the step before
  for (const WorldPoint& point : contact.points)
  {
    pushed = std::max(pushed, point.impulse);
  }
  const auto soft = [&](double most, double speed)
  {
    const double give =
        pushed > 0 ? std::min(most * inverse_mass, speed / pushed) : most * inverse_mass;
    return std::max(settings.compliance * inverse_mass, settings.softening * give);
  };
  return {1 / soft(how.push, how.normal_speed), 1 / soft(how.friction, how.tangent_speed)};
}

/// The friction [N s] that a soft point keeps from the frame before: no more than its overlap
/// alone, which pushes by so much [N s], would bear. Stiff points need none; of a strain none is
/// kept, for what held it in balance may be gone.
inline Vector3<double>
kept_friction(const WorldContact& contact, const WorldPoint& point, double push, double softening)
{
  if (softening == 0 || point.over_constrained)
  {
    return Vector3<double>::Zero();
  }
  const Vector3<double> across = along_surface(point.friction, contact.normal);
  return within_cone<double, 3>(
      SofteningSettings().kept * across, contact.friction * std::max(0.0, push));
}

/// How the direct solver is run where contacts are so soft; where they are, friction keeps to the
/// bounds that the frame before has left; at new points, to one of its own, bound_stays().
inline DirectSettings settings_at(double softening)
{
  DirectSettings settings{.softening = softening};
  if (softening > 0)
  {
    settings.tolerance = SofteningSettings().tolerance;
    settings.bounds_move = false;
  }
  return settings;
}

/// How soft an island is in the next frame, by how soft it was and whether it was solved.
inline double next_softening(double softening, bool solved)
{
  const SofteningSettings how;
  const double next = solved ? how.decay * softening : 1;
  return next < how.smallest ? 0 : next;
}
// [direct_softening]

/// Watches whether exact answers of an island last. Where they do not, as in a heap of jammed
/// spheres, softening would squeeze it again and again, and it would gain energy where overlaps
/// open.
class Restlessness
{
public:
  /// After a try of a step [s]: for how long [s] the island is now left to soft steps, or 0. With
  /// spheres it is sooner than without.
  double watch(bool found, bool softened, bool has_spheres, double step)
  {
    exact_time_ = found && !softened ? exact_time_ + step : 0;
    restless_time_ += step;
    failures_ += found ? 0 : 1;
    if (exact_time_ >= lasting)
    {
      *this = {};
    }
    const bool often =
        restless_time_ > (has_spheres ? rolling_patience : patience) && failures_ > 1;
    if (!often && !(left_ && !found))
    {
      return 0;
    }
    const double absence = absence_;
    *this = {};
    absence_ = std::min(4 * absence, last_absence);
    left_ = true;
    return absence;
  }

  /// After a step [s] without a try.
  void wait(double step) { restless_time_ += left_ ? 0 : step; }

  /// Whether it was left, and exact answers have not lasted since.
  bool left() const { return left_; }

private:
  static constexpr double lasting = 0.5;        // [s], of exact answers, after which all is well
  static constexpr double patience = 8;         // [s], without that and with failures: contacts of
                                                // fallen rows are stiff again after 315 frames
  static constexpr double rolling_patience = 2; // [s], where bodies roll aside meanwhile
  static constexpr double last_absence = 256;   // [s], after four times as long each time

  double exact_time_ = 0;    // [s], of exact answers without a break
  double restless_time_ = 0; // [s], since they have lasted
  int failures_ = 0;         // since then
  double absence_ = 4;       // [s], the next one
  bool left_ = false;
};

} // namespace cookbook
