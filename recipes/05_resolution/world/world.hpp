#pragma once

/// \file
/// \brief A world of bodies that fall, meet, bounce and rest: everything in this book, in one step.

#include "05_resolution/contacts/contact_cache.hpp"
#include "05_resolution/sweeps/ball_sweeps.hpp"
#include "05_resolution/sweeps/free_flight.hpp"
#include "05_resolution/sweeps/simultaneous_impacts.hpp"
#include "05_resolution/world/wake_neighbours.hpp"
#include "05_resolution/world/world_checks.hpp"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

/// Moves the bodies of one island on by a step [s], and sets the impulses of its contacts.
using IslandSolver = std::function<void(IslandView, const Island&, double)>;

// [world]
/// Bodies in motion, from a scene that makes sense. No body of it becomes NaN or infinite.
class World
{
public:
  /// The scene as it starts; InvalidScene if it makes no sense.
  World(const Scene& scene, IslandSolver solver, bool may_sleep = false)
      : scene_(checked(scene)),
        solver_(std::move(solver)),
        may_sleep_(may_sleep),
        forces_(scene.bodies.size(), Vector3<double>::Zero()),
        gone_(scene.bodies.size(), false),
        sleep_(scene.bodies.size())
  {
    for (const SceneBody& body : scene_.bodies)
    {
      bounds_.push_back({{}, static_cast<int>(bodies_.size())});
      has_balls_ = has_balls_ || std::holds_alternative<SphereShape>(body.shape);
      bodies_.push_back(rigid_body(body));
    }
  }

  const Scene& scene() const { return scene_; }                           ///< as it started
  const std::vector<RigidBody>& bodies() const { return bodies_; }        ///< in its order
  const std::vector<WorldContact>& contacts() const { return contacts_; } ///< of the last step
  const std::vector<RigidBody>& bodies_before() const { return before_; } ///< as that began
  double time() const { return double(steps_) * scene_.step; }            ///< [s], since the start
  bool sleeps(std::size_t body) const { return sleep_[body].asleep; }     ///< whether a body does

  /// How far apart [m] two bodies may be and still be in contact: what a fall from rest covers in
  /// two steps, so that a solver knows of a touch before there is an overlap.
  double margin() const { return 2 * scene_.gravity.norm() * scene_.step * scene_.step; }

  /// Adds a force [N], world, on a body's centre, in the next step only; std::invalid_argument, and
  /// nothing changes, if it is not finite.
  void push(std::size_t body, const Vector3<double>& force)
  {
    if (!force.allFinite())
    {
      throw std::invalid_argument("the force on " + scene_.bodies.at(body).name + " is not finite");
    }
    forces_.at(body) += force;
    wake(sleep_, island_numbers(bodies_, contacts_), static_cast<int>(body));
  }

  /// Takes a body out: from the next step on it stays where it is, and nothing touches it.
  void remove(std::size_t body)
  {
    wake_neighbours(sleep_, bodies_, contacts_, static_cast<int>(body));
    fix(bodies_.at(body));
    gone_[body] = true;
    std::erase_if(bounds_, [body](const Bounds& bound) { return place_of(bound.body) == body; });
  }

  /// Goes on by one step of the scene.
  void step()
  {
    find_contacts();
    start_ = before_ = bodies_;
    falls_.assign(bodies_.size(), false);
    const std::vector<int> numbers = island_numbers(bodies_, contacts_);
    if (may_sleep_)
    {
      settle(sleep_, numbers, SleepLimits<double>{});
    }
    for (const Island& island : islands_of(numbers, contacts_))
    {
      if (!sleep_[place_of(island.bodies.front())].asleep)
      {
        advance(island);
      }
    }
    if (has_balls_)
    {
      sweep_balls([&](int body) { wake(sleep_, numbers, body); });
    }
    finish();
    ++steps_;
  }

private:
  void find_contacts()
  {
    for (Bounds& bound : bounds_)
    {
      const std::size_t i = place_of(bound.body);
      bound.box = bounds_of(bodies_[i], scene_.bodies[i].shape, margin() / 2);
    }
    contacts_ = next_contacts(
        scene_, bodies_, contacts_, overlapping_pairs(bounds_), margin(),
        [this](int body) { return is_fixed(bodies_[place_of(body)]) || sleeps(place_of(body)); });
  }

  /// Moves an island: forces, bounces, contacts; and what no contact has pushed flies on.
  void advance(const Island& island)
  {
    const IslandView view{bodies_, contacts_, scene_.gravity};
    const bool touches = !island.contacts.empty();
    for (const int i : island.bodies)
    {
      RigidBody& body = bodies_[place_of(i)];
      body.velocity += scene_.step * body.inverse_mass * forces_[place_of(i)];
    }
    if (touches)
    {
      simultaneous_impacts(view, island, scene_.step);
    }
    for (const int i : island.bodies)
    {
      start_[place_of(i)] = bodies_[place_of(i)];
    }
    if (touches)
    {
      solver_(view, island, scene_.step);
    }
    for (const int i : island.bodies)
    {
      fall_unless_pushed(place_of(i), touches);
    }
  }

  /// Has a body fall freely that nothing has pushed.
  void fall_unless_pushed(std::size_t i, bool solved)
  {
    falls_[i] = !solved || !was_pushed(bodies_[i], start_[i], scene_.gravity, scene_.step);
    if (falls_[i])
    {
      bodies_[i] = flown(start_[i], scene_.gravity, scene_.step);
    }
  }

  /// Has balls bounce off what they would have passed through; `woken(i)` is told of who is hit.
  void sweep_balls(const std::function<void(int)>& woken)
  {
    StepCourses step{scene_, contacts_, falls_, gone_};
    set_out(step, start_, bodies_);
    BallSweeps(step, bodies_, woken).run();
  }

  /// Watches who rests, and keeps bodies whose numbers have overflowed where they were, fixed.
  void finish()
  {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
      RigidBody& body = bodies_[i];
      if (!is_finite(body))
      {
        body = before_[i];
        fix(body);
      }
      if (may_sleep_ && !is_fixed(body) && !sleeps(i))
      {
        const double radius = bounds_of(body, scene_.bodies[i].shape, 0).sizes().norm() / 2;
        sleep_[i] = watched(
            sleep_[i], body.velocity, body.angular_velocity, radius, scene_.step,
            SleepLimits<double>{});
      }
      forces_[i].setZero();
    }
  }

  Scene scene_;
  IslandSolver solver_;
  bool may_sleep_, has_balls_ = false;
  long steps_ = 0;
  std::vector<RigidBody> bodies_, before_, start_;
  std::vector<Vector3<double>> forces_;
  std::vector<bool> gone_, falls_;
  std::vector<SleepState<double>> sleep_;
  std::vector<Bounds> bounds_;
  std::vector<WorldContact> contacts_;
};
// [world]

} // namespace cookbook
