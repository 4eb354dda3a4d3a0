#pragma once

/// \file
/// \brief The numbers of contacts in groups, as they lie in memory.

#include "06_world/lanes/line_allocator.hpp"
#include "06_world/lanes/reserve_space.hpp"
#include "06_world/wide_solver/wide_contact.hpp"
#include "06_world/wide_solver/wide_groups.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace cookbook
{

// [lane_numbers]
/// A gap [m] that nothing closes in a step.
inline constexpr float infinite_separation = 1e20f;

/// What a view shows, but for the bodies: put in and taken out lane by lane.
class LaneNumbers
{
public:
  /// Room for contacts in groups of so many lanes: all are between two null bodies, and have no
  /// points but such as are too far apart to meet.
  void clear(const WideGroups& groups, std::size_t lanes, int null_body)
  {
    const auto clear = [](auto& list, std::size_t count, auto same)
    {
      list.clear();
      reserve_space(list, count);
      list.assign(count, same);
    };
    lanes_ = lanes;
    const std::size_t count = groups.taken().size();
    clear(a_, count, null_body);
    clear(b_, count, null_body);
    clear(contacts_, count * contact_numbers, 0.0f);
    clear(points_, groups.points() * lanes * point_numbers, 0.0f);
    for (std::size_t place = 0; place < groups.points(); ++place)
    {
      std::fill_n(point(place, 0), lanes, infinite_separation); // the first of a point's numbers
    }
  }

  /// Puts a contact into a lane of all, but for its points.
  void put(const WorldContact& contact, std::size_t lane)
  {
    a_[lane] = contact.a;
    b_[lane] = contact.b;
    WideContact<double> of;
    of.normal = contact.normal;
    of.coefficient = contact.friction;
    const std::size_t numbers = lane / lanes_ * contact_numbers;
    WriteLane<float> write{&contacts_[numbers * lanes_ + lane % lanes_], lanes_};
    each_stored(of, write);
  }

  /// Puts a point at a place into a lane of all, but for its masses.
  void put(ContactConstraint<double>& at, std::size_t place, std::size_t lane)
  {
    WriteLane<float> pushed{point(place, lane), lanes_};
    pushed(at.separation);
    each_pushed(at, pushed);
    WriteLane<float> stored{pushed.to + point_masses * lanes_, lanes_};
    each_stored(at, stored);
  }

  /// What a push has changed of the point at a place in a lane of all; nothing else of it.
  ContactConstraint<float> pushed(std::size_t place, std::size_t lane)
  {
    ContactConstraint<float> at;
    ReadLane<float> read{point(place, lane) + lanes_ * separation_numbers, lanes_};
    each_pushed(at, read);
    return at;
  }

  /// Forgets what that point has been given.
  void discard_warm_start(std::size_t place, std::size_t lane)
  {
    ContactConstraint<float> at = pushed(place, lane);
    at.impulse = 0;
    at.friction.setZero();
    WriteLane<float> write{point(place, lane) + lanes_ * separation_numbers, lanes_};
    each_pushed(at, write);
  }

  /// All of them, in their groups, and the bodies that they push.
  WideView view(std::span<const WideGroup> groups, LaneBody* bodies)
  {
    return {groups, a_.data(), b_.data(), contacts_.data(), points_.data(), bodies};
  }

private:
  float* point(std::size_t place, std::size_t lane)
  {
    return &points_[place * lanes_ * point_numbers + lane % lanes_];
  }

  using Numbers = std::vector<float, LineAllocator<float>>;

  std::size_t lanes_ = 0;
  std::vector<int> a_, b_;
  Numbers contacts_, points_;
};
// [lane_numbers]

} // namespace cookbook
