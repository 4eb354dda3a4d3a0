#pragma once

/// \file
/// \brief What balls would pass through in a step: found in the order of time, and bounced off.

#include "05_resolution/sweeps/free_flight.hpp"
#include "05_resolution/sweeps/step_courses.hpp"
#include "05_resolution/sweeps/touch_bounce.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [ball_sweeps]
/// The most touches of one ball in one step; from then on it only stops, once at each body.
inline constexpr int most_touches_a_step = 64;

/// Corrects a step in which balls would have passed through something.
class BallSweeps
{
public:
  /// The step, and the bodies at its end; `woken(i)` is told of who is hit.
  BallSweeps(StepCourses& step, std::span<RigidBody> ends, const std::function<void(int)>& woken)
      : step_(step),
        ends_(ends),
        woken_(woken),
        duration_(step.scene.step),
        threshold_(bounce_threshold(step.scene.gravity.norm(), duration_)),
        versions_(ends.size(), 0),
        touched_(ends.size(), 0)
  {
  }

  /// Has balls bounce off what they touch, one touch after the other.
  void run()
  {
    for (const auto& [i, j] : pairs_in_danger(step_, ends_))
    {
      look_for(i, j, 0);
    }
    while (!touches_.empty())
    {
      const BallTouch touch = touches_.top();
      touches_.pop();
      if (touch.versions == versions(touch.ball, touch.other))
      {
        meet(touch);
      }
    }
  }

private:
  static std::pair<int, int> pair_of(int i, int j) { return {std::min(i, j), std::max(i, j)}; }
  std::pair<int, int> versions(int a, int b) const
  {
    return {versions_[place_of(a)], versions_[place_of(b)]};
  }
  bool falls(int i) const { return step_.falls[place_of(i)]; }

  /// Writes down when two bodies touch, if they do so after a time [s].
  void look_for(int i, int j, double time)
  {
    if (std::find(left_.begin(), left_.end(), pair_of(i, j)) != left_.end())
    {
      return;
    }
    // The first is a ball, and one that falls, if there is one.
    const bool falls_first = !is_ball(step_, j) || falls(i) || !falls(j);
    const int ball = is_ball(step_, i) && falls_first ? i : j, other = i + j - ball;
    const double slack = pressed(step_, pair_of(i, j)) ? reach(step_, ball) / 100 : 0;
    const TouchOnCourse touch{
        step_.courses[place_of(ball)], step_.courses[place_of(other)], time, duration_, slack};
    const std::vector<SceneBody>& bodies = step_.scene.bodies;
    if (const auto hit =
            std::visit(touch, bodies[place_of(ball)].shape, bodies[place_of(other)].shape))
    {
      touches_.push({hit->time * duration_, ball, other, hit->normal, versions(ball, other)});
    }
  }

  /// Looks anew for what a body touches whose course has changed at a time [s].
  void look_around(int i, double time)
  {
    for (int j = 0; j < static_cast<int>(ends_.size()); ++j)
    {
      const bool balls = is_ball(step_, i) || is_ball(step_, j);
      if (j != i && balls && !step_.gone[place_of(j)] && may_meet(step_, i, j, time))
      {
        look_for(i, j, time);
      }
    }
  }

  /// A body at a time [s] of its course, as fast as it is there.
  RigidBody at(int i, double time) const
  {
    const Course& course = step_.courses[place_of(i)];
    if (falls(i) || versions_[place_of(i)] > 0)
    {
      RigidBody body = flown(course.start, course.acceleration, time - course.since);
      body.position = course.place_at(time);
      return body;
    }
    RigidBody body = course.pose_at(time);
    body.velocity = ends_[place_of(i)].velocity;
    body.angular_velocity = ends_[place_of(i)].angular_velocity;
    return body;
  }

  void meet(const BallTouch& touch)
  {
    const int ball = touch.ball, other = touch.other;
    RigidBody a = at(ball, touch.time), b = at(other, touch.time);
    WorldContact contact = touch_contact(step_.scene, {ball, other}, a, b, touch.normal);
    const bool tired = ++touched_[place_of(ball)] > most_touches_a_step;
    const double slow = tired ? std::numeric_limits<double>::infinity()
                              : std::min(threshold_, reach(step_, ball) / (2 * duration_));
    const double approach = bounce(a, b, contact, slow);
    // A ball that has come to rest leans on what does not give way. Two balls that have are left
    // alone: what they sink by, the next step finds.
    const bool rests = approach <= slow, leans = rests && !tired && !goes_on(other);
    if (rests && !leans && (tired || approach == 0 || is_ball(step_, other)))
    {
      left_.push_back(pair_of(ball, other));
    }
    if (approach > 0 || leans || !falls(ball))
    {
      go_on(ball, a, touch.time, leans ? &touch : nullptr);
    }
    if (approach > 0)
    {
      woken_(ball);
      woken_(other);
      pass_on(other, b, touch.time);
    }
  }

  /// Whether a body that is hit goes its own way: a ball, and what falls. All others lie among
  /// others: they are pushed in this step, and move in the next.
  bool goes_on(int i) const
  {
    return !is_fixed(ends_[place_of(i)]) && (is_ball(step_, i) || falls(i));
  }

  void pass_on(int i, const RigidBody& body, double time)
  {
    if (goes_on(i))
    {
      go_on(i, body, time, nullptr);
    }
    else
    {
      ends_[place_of(i)].velocity = body.velocity;
      ends_[place_of(i)].angular_velocity = body.angular_velocity;
    }
  }

  /// Lets a body go on from where it is at a time [s], for the rest of the step; but not into what
  /// it leans on.
  void go_on(int i, const RigidBody& body, double time, const BallTouch* leaning)
  {
    Course& course = step_.courses[place_of(i)];
    course = {body, time, body.velocity, course.acceleration, course.spin};
    if (leaning)
    {
      hold_back(course, step_.courses[place_of(leaning->other)], leaning->normal);
    }
    RigidBody& end = ends_[place_of(i)];
    end = flown(body, course.acceleration, duration_ - time);
    end.position = course.place_at(duration_);
    course.spin = spin_between(body, end, duration_ - time);
    ++versions_[place_of(i)];
    look_around(i, time);
  }

  StepCourses& step_;
  std::span<RigidBody> ends_;
  const std::function<void(int)>& woken_;
  double duration_;
  double threshold_;                      // [m/s], of a bounce
  std::vector<int> versions_;             // how often each course has changed
  std::vector<int> touched_;              // how often each ball has touched something
  std::vector<std::pair<int, int>> left_; // pairs that nobody looks at for the rest of the step
  std::priority_queue<BallTouch> touches_;
};
// [ball_sweeps]

} // namespace cookbook
