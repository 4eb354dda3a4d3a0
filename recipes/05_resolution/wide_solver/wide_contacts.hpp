#pragma once

/// \file
/// \brief The contacts of islands side by side, colour by colour.

#include "05_resolution/contact_graph/contact_graph.hpp"
#include "05_resolution/wide_solver/islands_together.hpp"
#include "05_resolution/wide_solver/passes_in_lanes.hpp"
#include "common/simd/lanes.hpp"
#include "common/simd/line_allocator.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [widest_passes]
/// The passes in the widest registers of this processor, where cookbook::wide_passes is linked;
/// otherwise in those of the processors that this file is compiled for. All give the same bits.
#if defined(COOKBOOK_WIDE_PASSES)
WidePasses widest_passes();
#else
inline WidePasses widest_passes()
{
  return passes_in_lanes<Lanes>();
}
#endif
// [widest_passes]

// [wide_contacts]
/// The contacts of islands, and their bodies, as lanes.
class WideContacts
{
public:
  /// Lanes for these passes.
  explicit WideContacts(const WidePasses& passes = widest_passes()) : passes_(passes) {}

  /// The islands whose contacts are taken.
  IslandsTogether islands;

  /// Takes the contacts of all islands, their impulses as they are for one of so many small steps.
  void take(IslandView world, int substeps)
  {
    color(world);
    take_bodies(world);
    take_groups(world);
    for (std::size_t lane = 0; lane < taken_.size(); ++lane)
    {
      put_contact(world, lane, 1.0 / substeps);
    }
    find_masses(world, [](const Island&) { return true; });
  }

  /// What impulses feel, as the bodies are turned now in those islands that `turned(island)` says.
  template <class Turned>
  void find_masses(IslandView world, const Turned& turned)
  {
    bool any = false;
    for (const Island& island : islands.all())
    {
      if (turned(island))
      {
        any = true;
        for (const int i : island.bodies)
        {
          put_inverse_masses(world.bodies[place_of(i)], body(i));
        }
      }
    }
    if (any)
    {
      passes_.find_masses(view());
    }
  }

  /// Pushes as the step before has ended.
  void warm_start() { passes_.warm_start(view()); }

  /// Corrects every point once, with a spring, in a small step [s].
  void correct(const Softness<double>& spring, double small)
  {
    const auto rounded = [](double number) { return static_cast<float>(number); };
    passes_.correct(
        view(),
        {rounded(spring.bias_rate), rounded(spring.mass_scale), rounded(spring.impulse_scale)},
        rounded(small));
  }

  /// Carries all gaps on for a small step [s].
  void part(double small) { passes_.part(view(), static_cast<float>(small)); }

  /// Writes down what the points have been given in so many small steps.
  void store(IslandView world, int substeps)
  {
    const float scale = static_cast<float>(substeps);
    for (std::size_t lane = 0; lane < taken_.size(); ++lane)
    {
      std::size_t place = groups_[lane / lanes()].first;
      for (WorldPoint& known : points_of(world, taken_[lane]))
      {
        ContactConstraint<float> at;
        ReadLane read{numbers_of(place++, lane), lanes()};
        each_pushed(at, read);
        known.impulse = scale * at.impulse;
        known.friction = (scale * at.friction).cast<double>();
      }
    }
  }

  /// A body of the world, to be pushed here.
  LaneBody& body(int number) { return bodies_[place_of(number)]; }

private:
  static constexpr int none = -1; // the contact of a lane that is left over

  template <class Number>
  using Numbers = std::vector<Number, LineAllocator<Number>>;

  std::size_t lanes() const { return passes_.lanes; }

  WideView view()
  {
    return {groups_, a_.data(), b_.data(), contacts_.data(), points_.data(), bodies_.data()};
  }

  WorldContact& contact_of(IslandView world, int taken) const
  {
    return world.contacts[place_of(islands.contacts()[place_of(taken)])];
  }

  std::span<WorldPoint> points_of(IslandView world, int taken) const
  {
    return taken == none ? std::span<WorldPoint>() : contact_of(world, taken).points();
  }

  /// Where the numbers of a point lie in a lane.
  float* numbers_of(std::size_t place, std::size_t lane)
  {
    return &points_[place * lanes() * point_numbers + lane % lanes()];
  }

  void color(IslandView world)
  {
    pairs_.clear();
    for (const int number : islands.contacts())
    {
      pairs_.push_back(pair_of(world.contacts[place_of(number)]));
    }
    graph_.color(
        world.bodies.size(), pairs_, [&](int i) { return !is_fixed(world.bodies[place_of(i)]); });
  }

  /// Bodies have their places in the world; behind them is nobody, whom nothing moves.
  void take_bodies(IslandView world)
  {
    bodies_.resize(world.bodies.size());
    bodies_.emplace_back();
    islands.for_each_body([&](int i) { put_motion(world.bodies[place_of(i)], body(i)); });
    for (const auto& [a, b] : pairs_)
    {
      for (const int i : {a, b})
      {
        if (is_fixed(world.bodies[place_of(i)]))
        {
          put_motion(world.bodies[place_of(i)], body(i));
          put_inverse_masses(world.bodies[place_of(i)], body(i));
        }
      }
    }
  }

  /// Puts contacts into groups, colour by colour; what is left over of lanes is between nobody and
  /// nobody.
  void take_groups(IslandView world)
  {
    const std::size_t most = pairs_.size() / lanes() + std::size_t(graph_.colors());
    groups_.clear();
    taken_.clear();
    make_room(groups_, most);
    make_room(taken_, most * lanes());
    std::size_t points = 0;
    for (int color = 0; color < graph_.colors(); ++color)
    {
      points = take_color(world, graph_[color], points);
    }
    const auto assign = [](auto& to, std::size_t count, auto same)
    {
      to.clear();
      make_room(to, count);
      to.assign(count, same);
    };
    const int nobody = static_cast<int>(world.bodies.size());
    assign(a_, taken_.size(), nobody);
    assign(b_, taken_.size(), nobody);
    assign(contacts_, taken_.size() * contact_numbers, 0.0f);
    assign(points_, points * lanes() * point_numbers, 0.0f);
  }

  /// Contacts with as many points come together, so that few lanes idle; how many points there are
  /// with those of this colour.
  std::size_t take_color(IslandView world, std::span<const int> of, std::size_t before)
  {
    order_.assign(of.begin(), of.end());
    const auto points = [&](int taken) { return points_of(world, taken).size(); };
    std::sort(
        order_.begin(), order_.end(),
        [&](int i, int j) { return std::pair(points(j), i) < std::pair(points(i), j); });
    for (std::size_t i = 0; i < order_.size(); i += lanes())
    {
      groups_.push_back({before, points(order_[i])});
      before += groups_.back().points;
      const std::size_t count = std::min(lanes(), order_.size() - i);
      taken_.insert(taken_.end(), &order_[i], &order_[i] + count);
      taken_.resize(groups_.size() * lanes(), none);
    }
    return before;
  }

  /// Puts a contact and its points into a lane, the impulses as so large a share of a frame's.
  void put_contact(IslandView world, std::size_t lane, double share)
  {
    if (taken_[lane] == none)
    {
      return;
    }
    WorldContact& contact = contact_of(world, taken_[lane]);
    const RigidBody& a = world.bodies[place_of(contact.a)];
    const RigidBody& b = world.bodies[place_of(contact.b)];
    const std::size_t group = lane / lanes();
    a_[lane] = contact.a;
    b_[lane] = contact.b;
    WideContact<double> common;
    common.across = contact.normal().unitOrthogonal();
    common.correction_speed = islands.correction_speed(place_of(taken_[lane]));
    WriteLane write{
        &contacts_[(group * contact_numbers + contact_masses) * lanes() + lane % lanes()], lanes()};
    each_given(common, write);
    std::size_t place = groups_[group].first;
    for (const WorldPoint& point : contact.points())
    {
      ContactConstraint<double> at = constraint_of(a, b, contact, point);
      at.impulse *= share;
      at.friction *= share;
      WriteLane pushed{numbers_of(place++, lane), lanes()};
      each_pushed(at, pushed);
      WriteLane given{pushed.to + point_masses * lanes(), lanes()};
      each_given(at, given);
    }
  }

  WidePasses passes_;
  ContactGraph graph_;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<int> order_;        // of the contacts of a colour
  std::vector<LaneBody> bodies_;  // by their places in the world
  std::vector<WideGroup> groups_; // as in a WideView, here and below
  std::vector<int> taken_;        // the contact in each lane
  std::vector<int> a_, b_;
  Numbers<float> contacts_, points_;
};
// [wide_contacts]

} // namespace cookbook
