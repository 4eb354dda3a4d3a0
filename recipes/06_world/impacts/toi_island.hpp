#pragma once

/// \file
/// \brief The bodies that a box which is hit pushes along, and the impulses of all at once.

#include "06_world/impacts/toi_impulse.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace cookbook
{

// [toi_island]
/// A body of a TOI event.
struct ToiBody
{
  int number;
  RigidBody body;        ///< at the event, with its velocity after it
  Motion<double> before; ///< its motion before the event
};

/// Whether a body can push others along: a box that can move.
inline bool can_push(const RigidBody& body)
{
  return !body.is_sphere && !is_fixed(body);
}

/// The most bodies that one event pushes along, fixed ones not counted.
inline constexpr int max_pushed_bodies = 6;

/// Bodies of a TOI event: the two that touch, and what they would be pushed into.
///
/// Solved pair by pair they would touch again and again, the more often the more masses differ.
class ToiIsland
{
public:
  /// The two that touch, after their own impulse; up to a threshold [m/s] an approach only stops.
  ToiIsland(
      const StepTrajectories& step, const ToiEvent& event, const ToiManifold& manifold,
      const ToiBody& first, const ToiBody& other, double threshold)
      : step_(step), event_(event), threshold_(threshold), bodies_{first, other}
  {
    RigidBody &a = bodies_[0].body, &b = bodies_[1].body;
    pairs_.push_back(
        {std::minmax(event.first, event.other), &a, &b,
         toi_contact(step.scene, event, *manifold, a, b)});
  }

  /// Adds the bodies they are pushed into and solves all at once; false if there are none, or if
  /// energy would grow. `at(i)` is a body at the event.
  template <class At>
  bool solve(const At& at)
  {
    for (std::size_t k = 0; k < bodies_.size(); ++k)
    {
      ToiBody& one = bodies_[k];
      for (const int j : can_push(one.body) ? bodies_near(one) : std::vector<int>())
      {
        push_into(one, j, at);
      }
    }
    return pairs_.size() > 1 && solve_together();
  }

  const std::deque<ToiBody>& bodies() const { return bodies_; } ///< the two that touch first

private:
  /// Two of them in contact.
  struct Pair
  {
    std::pair<int, int> numbers; // the smaller first
    RigidBody *a, *b;
    WorldContact contact;
  };

  // With this much restitution a pair is left to an event of its own.
  static constexpr double high_restitution = 0.5;
  // Of the fastest speed; an approach that is left makes another event.
  static constexpr double rough_tolerance = 0.01;
  // Of the allowed penetration: a separation up to it counts as contact.
  static constexpr double allowed = 0.02;

  /// The numbers of all bodies that may touch one, in order, itself and spheres among them.
  std::vector<int> bodies_near(const ToiBody& one) const
  {
    const auto& shape = step_.scene.bodies[index_of(one.number)].shape;
    const Eigen::AlignedBox<double, 3> here = bounds_of(
        one.body, shape, allowed * allowed_penetration(inner_radius(step_.scene, one.number)));
    std::vector<int> found;
    each_that(
        *step_.tree,
        [&](const Eigen::AlignedBox<double, 3>& box) { return boxes_intersect(box, here); },
        [&](int j) { found.push_back(j); });
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Resolves the impact of one of them on a body that it is pushed into, and adds that body.
  template <class At>
  void push_into(ToiBody& one, int j, const At& at)
  {
    ToiEvent event{event_.time, one.number, j, Vector3<double>::Zero(), {}};
    const std::pair<int, int> pair = std::minmax(one.number, j);
    if (j == one.number || is_sphere(step_.scene, j) || are_paired(pair) ||
        ignores(step_.scene, pair))
    {
      return;
    }
    const auto is_other = [&](const ToiBody& body) { return body.number == j; };
    const auto known = std::find_if(bodies_.begin(), bodies_.end(), is_other);
    const bool is_new = known == bodies_.end();
    RigidBody a = one.body, b = is_new ? at(j) : known->body;
    const Motion<double> before = b.motion;
    const bool counts = is_new && !is_fixed(b);
    const double separation = allowed * allowed_penetration(step_.scene, pair);
    const ToiManifold manifold = toi_manifold(step_.scene, event, a, b, separation);
    if (!manifold || (counts && pushed_count_ == max_pushed_bodies) ||
        ghost_depth(step_, event, manifold, a, b) > 0)
    {
      return;
    }
    event.normal = manifold->normal;
    WorldContact contact = toi_contact(step_.scene, event, *manifold, a, b);
    std::vector<ImpactPoint> points;
    const double approach_speed = add_impact_points(a, b, contact, threshold_, points);
    if ((contact.restitution < high_restitution || is_reversed(event_.first) ||
         is_reversed(event_.other)) &&
        penetrates(step_, event, approach_speed))
    {
      RigidBody* const both[] = {&a, &b};
      resolve_impacts(points, both, rough_tolerance);
      pushed_count_ += counts ? 1 : 0;
      ToiBody& other = is_new ? bodies_.emplace_back(ToiBody{j, b, before}) : *known;
      one.body.motion = a.motion;
      other.body.motion = b.motion;
      pairs_.push_back({pair, &one.body, &other.body, std::move(contact)});
    }
  }

  bool is_reversed(int i) const { return step_.trajectories[index_of(i)].reversed; }

  bool are_paired(const std::pair<int, int>& numbers) const
  {
    const auto same = [&](const Pair& pair) { return pair.numbers == numbers; };
    return std::any_of(pairs_.begin(), pairs_.end(), same);
  }

  bool solve_together()
  {
    std::vector<RigidBody*> bodies;
    for (ToiBody& one : bodies_)
    {
      one.body.motion = one.before;
      bodies.push_back(&one.body);
    }
    std::vector<ImpactPoint> points;
    for (Pair& pair : pairs_)
    {
      add_impact_points(*pair.a, *pair.b, pair.contact, threshold_, points);
    }
    return resolve_impacts(points, bodies, rough_tolerance);
  }

  const StepTrajectories& step_;
  const ToiEvent& event_;
  double threshold_;
  int pushed_count_ = 0; // those that can move, beside the two that touch
  std::deque<ToiBody> bodies_;
  std::deque<Pair> pairs_;
};

/// Resolves a TOI event, with all bodies that its boxes push along; returns the approach speed
/// [m/s]. `at(i)` is a body at the event.
template <class At>
double resolve_toi_island(
    const StepTrajectories& step, const ToiEvent& event, const ToiManifold& manifold, RigidBody& a,
    RigidBody& b, double threshold, const At& at, std::vector<ToiBody>& pushed)
{
  const Motion<double> before_a = a.motion, before_b = b.motion;
  const double approach_speed = resolve_impacts(step.scene, event, manifold, a, b, threshold);
  if (penetrates(step, event, approach_speed) && (can_push(a) || can_push(b)))
  {
    ToiIsland group(
        step, event, manifold, {event.first, a, before_a}, {event.other, b, before_b}, threshold);
    if (group.solve(at))
    {
      a = group.bodies()[0].body;
      b = group.bodies()[1].body;
      pushed.assign(group.bodies().begin() + 2, group.bodies().end());
    }
  }
  return approach_speed;
}
// [toi_island]

} // namespace cookbook
