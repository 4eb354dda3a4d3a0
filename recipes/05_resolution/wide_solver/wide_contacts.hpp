#pragma once

/// \file
/// \brief The contacts of an island, four side by side, colour by colour.

#include "05_resolution/contact_graph/contact_graph.hpp"
#include "05_resolution/wide_solver/wide_contact.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [wide_contacts]
/// The contacts of an island, and its bodies, as lanes.
class WideContacts
{
public:
  /// Takes the contacts of an island, their impulses as they are for one of so many small steps.
  void take(IslandView world, const Island& island, int substeps)
  {
    color(world, island);
    take_bodies(world, island);
    fours_.clear();
    points_.clear();
    for (int color = 0; color < graph_.colors(); ++color)
    {
      take_color(world, island, graph_[color], 1.0 / substeps);
    }
    find_masses(world, island);
  }

  /// What impulses feel, as the bodies are turned now.
  void find_masses(IslandView world, const Island& island)
  {
    for (const int i : island.bodies)
    {
      put_inverse_masses(world.bodies[place_of(i)], bodies_[place_of(i)]);
    }
    for (WideContact& four : fours_)
    {
      gather_inverse_masses(bodies_, four.a, four.body_a);
      gather_inverse_masses(bodies_, four.b, four.body_b);
      for (ContactConstraint<Four>& at : points_of(four))
      {
        cookbook::find_masses<Four>(at, four.body_a, four.body_b, four.across);
      }
    }
  }

  /// Lets `look(a, b, at)` change every point, four at a time; their bodies stay as they are.
  template <class Look>
  void look_at_each(const Look& look)
  {
    for (WideContact& four : fours_)
    {
      look_at(four, look);
    }
  }

  /// Lets `change(a, b, at)` change every point and its bodies, four at a time.
  template <class Change>
  void change_each(const Change& change)
  {
    for (WideContact& four : fours_)
    {
      look_at(four, change);
      scatter_motion(four.body_a, bodies_, four.a);
      scatter_motion(four.body_b, bodies_, four.b);
    }
  }

  /// Writes down what the points have been given in so many small steps.
  void store(int substeps)
  {
    const float scale = static_cast<float>(substeps);
    for (const WideContact& four : fours_)
    {
      for (std::size_t lane = 0; lane < 4; ++lane)
      {
        std::size_t place = four.first;
        for (WorldPoint& known : points_in(four, lane))
        {
          take_lane(points_[place++], lane, scale, known);
        }
      }
    }
  }

  /// A body of the world, to be pushed here.
  LaneBody& body(int number) { return bodies_[place_of(number)]; }

private:
  std::span<ContactConstraint<Four>> points_of(const WideContact& four)
  {
    return std::span(points_).subspan(four.first, four.points);
  }

  template <class Look>
  void look_at(WideContact& four, const Look& look)
  {
    gather_motion(bodies_, four.a, four.body_a);
    gather_motion(bodies_, four.b, four.body_b);
    for (ContactConstraint<Four>& at : points_of(four))
    {
      look(four.body_a, four.body_b, at);
    }
  }

  void color(IslandView world, const Island& island)
  {
    pairs_.clear();
    for (const int number : island.contacts)
    {
      const WorldContact& contact = world.contacts[place_of(number)];
      pairs_.emplace_back(contact.a, contact.b);
    }
    graph_.color(
        world.bodies.size(), pairs_, [&](int i) { return !is_fixed(world.bodies[place_of(i)]); });
  }

  /// Bodies have their places in the world; behind them is nobody, whom nothing moves.
  void take_bodies(IslandView world, const Island& island)
  {
    bodies_.resize(world.bodies.size());
    bodies_.emplace_back();
    for (const int i : island.bodies)
    {
      put_motion(world.bodies[place_of(i)], body(i));
    }
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

  /// Contacts with as many points come together, so that few lanes idle.
  void take_color(IslandView world, const Island& island, std::span<const int> of, double scale)
  {
    const auto contact_of = [&](int pair) -> WorldContact&
    { return world.contacts[place_of(island.contacts[place_of(pair)])]; };
    order_.assign(of.begin(), of.end());
    const auto points = [&](int pair) { return contact_of(pair).points().size(); };
    std::sort(
        order_.begin(), order_.end(),
        [&](int i, int j) { return std::pair(points(j), i) < std::pair(points(i), j); });
    for (std::size_t i = 0; i < order_.size(); i += 4)
    {
      WideContact& four = fours_.emplace_back(no_contact(world.bodies.size()));
      four.first = points_.size();
      four.points = points(order_[i]);
      points_.resize(four.first + four.points, no_point());
      for (std::size_t lane = 0; lane < std::min<std::size_t>(4, order_.size() - i); ++lane)
      {
        put_lane(world, four, lane, contact_of(order_[i + lane]), scale);
      }
    }
  }

  void put_lane(
      IslandView world, WideContact& four, std::size_t lane, WorldContact& contact, double scale)
  {
    const RigidBody& a = world.bodies[place_of(contact.a)];
    const RigidBody& b = world.bodies[place_of(contact.b)];
    four.contacts[lane] = &contact;
    four.a[lane] = contact.a;
    four.b[lane] = contact.b;
    set_lane(four.across, lane, contact.normal().unitOrthogonal());
    std::size_t place = four.first;
    for (const WorldPoint& point : contact.points())
    {
      ContactConstraint<double> at = constraint_of(a, b, contact, point);
      at.impulse *= scale;
      at.friction *= scale;
      set_lane(points_[place++], lane, at);
    }
  }

  ContactGraph graph_;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<LaneBody> bodies_;
  std::vector<WideContact> fours_;
  std::vector<ContactConstraint<Four>> points_;
  std::vector<int> order_;
};
// [wide_contacts]

} // namespace cookbook
