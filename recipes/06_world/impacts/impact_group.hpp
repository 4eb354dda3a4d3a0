#pragma once

/// \file
/// \brief What a box that is hit drives along, and the bounce of all at once.

#include "06_world/impacts/touch_bounce.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace cookbook
{

// [impact_group]
/// A body that a touch strikes.
struct StruckBody
{
  int number;
  RigidBody body;        ///< where it is at the touch, moving as after it
  Motion<double> before; ///< how it moved before it
};

/// Whether a body drives others along: a box that can move.
inline bool drives(const RigidBody& body)
{
  return !body.round && !is_fixed(body);
}

/// The most bodies that one touch drives along, but for those that are fixed.
inline constexpr int most_driven = 6;

/// Bodies that a touch strikes: the two that touch, and whatever boxes among them would be pushed
/// deep into by it: boxes and planes that they lie against.
///
/// One after the other they would touch again and again: a heavy box and a light one under it as
/// many times as the one is heavier than the other. What bounces well does so at first, as in a row
/// of steel cubes; until one is tossed to and fro.
class ImpactGroup
{
public:
  /// The two that touch, as they part from each other alone; an approach up to a threshold [m/s]
  /// only ends.
  ImpactGroup(
      const StepCourses& step, const CourseTouch& touch, const Met& met, const StruckBody& first,
      const StruckBody& other, double threshold)
      : step_(step), touch_(touch), threshold_(threshold), bodies_{first, other}
  {
    RigidBody &a = bodies_[0].body, &b = bodies_[1].body;
    pairs_.push_back(
        {std::minmax(touch.first, touch.other), &a, &b,
         touch_contact(step.scene, touch, *met, a, b)});
  }

  /// Takes in whom they drive along, and has all bounce at once; false if there is nobody, or if
  /// that would give them energy. `at(i)` is a body at the touch.
  template <class At>
  bool strike(const At& at)
  {
    for (std::size_t k = 0; k < bodies_.size(); ++k)
    {
      StruckBody& one = bodies_[k];
      for (const int j : drives(one.body) ? bodies_near(one) : std::vector<int>())
      {
        drive(one, j, at);
      }
    }
    return pairs_.size() > 1 && bounce_at_once();
  }

  const std::deque<StruckBody>& bodies() const { return bodies_; } ///< the two that touch first

private:
  /// Where two of them press on each other.
  struct Pair
  {
    std::pair<int, int> numbers; // the smaller first
    RigidBody *a, *b;
    WorldContact contact;
  };

  static constexpr double well = 0.5;   // what restitution that takes
  static constexpr double rough = 0.01; // of the fastest speed: what is left touches again
  static constexpr double slack = 0.02; // of a depth that does no harm: no farther apart they touch

  /// What may lie against a body, itself and balls among them, in order of number.
  std::vector<int> bodies_near(const StruckBody& one) const
  {
    const auto& shape = step_.scene.bodies[place_of(one.number)].shape;
    const Eigen::AlignedBox<double, 3> here =
        bounds_of(one.body, shape, slack * harmless_depth(thinness(step_.scene, one.number)));
    std::vector<int> found;
    each_that(
        *step_.tree,
        [&](const Eigen::AlignedBox<double, 3>& box) { return boxes_intersect(box, here); },
        [&](int j) { found.push_back(j); });
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Has one of them bounce off a body that it is driven into, which is one of them from then on.
  template <class At>
  void drive(StruckBody& one, int j, const At& at)
  {
    CourseTouch touch{touch_.time, one.number, j, Vector3<double>::Zero(), {}};
    const std::pair<int, int> pair = std::minmax(one.number, j);
    if (j == one.number || is_ball(step_.scene, j) || are_paired(pair) ||
        ignores(step_.scene, pair))
    {
      return;
    }
    const auto is_other = [&](const StruckBody& body) { return body.number == j; };
    const auto known = std::find_if(bodies_.begin(), bodies_.end(), is_other);
    const bool is_new = known == bodies_.end();
    RigidBody a = one.body, b = is_new ? at(j) : known->body;
    const Motion<double> before = b.motion;
    const bool counts = is_new && !is_fixed(b);
    const double apart = slack * harmless_depth(step_.scene, pair);
    const Met met = touch_manifold(step_.scene, touch, a, b, apart);
    if (!met || (counts && driven_ == most_driven) || ghost_depth(step_, touch, met, a, b) > 0)
    {
      return;
    }
    touch.normal = met->normal;
    WorldContact contact = touch_contact(step_.scene, touch, *met, a, b);
    std::vector<ImpactPoint> points;
    const double approach = add_impact_points(a, b, contact, threshold_, points);
    if ((contact.restitution < well || is_tossed(touch_.first) || is_tossed(touch_.other)) &&
        does_harm(step_, touch, approach))
    {
      RigidBody* const both[] = {&a, &b};
      bounce(points, both, rough);
      driven_ += counts ? 1 : 0;
      StruckBody& other = is_new ? bodies_.emplace_back(StruckBody{j, b, before}) : *known;
      one.body.motion = a.motion;
      other.body.motion = b.motion;
      pairs_.push_back({pair, &one.body, &other.body, std::move(contact)});
    }
  }

  bool is_tossed(int i) const { return step_.courses[place_of(i)].tossed; }

  bool are_paired(const std::pair<int, int>& numbers) const
  {
    const auto same = [&](const Pair& pair) { return pair.numbers == numbers; };
    return std::any_of(pairs_.begin(), pairs_.end(), same);
  }

  bool bounce_at_once()
  {
    std::vector<RigidBody*> bodies;
    for (StruckBody& one : bodies_)
    {
      one.body.motion = one.before;
      bodies.push_back(&one.body);
    }
    std::vector<ImpactPoint> points;
    for (Pair& pair : pairs_)
    {
      add_impact_points(*pair.a, *pair.b, pair.contact, threshold_, points);
    }
    return bounce(points, bodies, rough);
  }

  const StepCourses& step_;
  const CourseTouch& touch_;
  double threshold_;
  int driven_ = 0; // who can move, beside the two that touch
  std::deque<StruckBody> bodies_;
  std::deque<Pair> pairs_;
};

/// Lets two bodies bounce where they touch, and boxes with them what they drive along, which is
/// added to a list, and says at what speed [m/s] the two met. `at(i)` is a body at the touch.
template <class At>
double bounce_together(
    const StepCourses& step, const CourseTouch& touch, const Met& met, RigidBody& a, RigidBody& b,
    double threshold, const At& at, std::vector<StruckBody>& driven)
{
  const Motion<double> before_a = a.motion, before_b = b.motion;
  const double approach = bounce(step.scene, touch, met, a, b, threshold);
  if (does_harm(step, touch, approach) && (drives(a) || drives(b)))
  {
    ImpactGroup group(
        step, touch, met, {touch.first, a, before_a}, {touch.other, b, before_b}, threshold);
    if (group.strike(at))
    {
      a = group.bodies()[0].body;
      b = group.bodies()[1].body;
      driven.assign(group.bodies().begin() + 2, group.bodies().end());
    }
  }
  return approach;
}
// [impact_group]

} // namespace cookbook
