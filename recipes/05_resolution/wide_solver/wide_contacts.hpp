#pragma once

/// \file
/// \brief The contacts of islands, four side by side, colour by colour.

#include "05_resolution/contact_graph/contact_graph.hpp"
#include "05_resolution/wide_solver/islands_together.hpp"
#include "05_resolution/wide_solver/wide_contact.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [wide_contacts]
/// The contacts of islands, and their bodies, as lanes.
class WideContacts
{
public:
  /// The islands whose contacts are taken.
  IslandsTogether islands;

  /// Takes the contacts of all islands, their impulses as they are for one of so many small steps.
  void take(IslandView world, int substeps)
  {
    color(world);
    take_bodies(world);
    fours_.clear();
    make_room(fours_, islands.contacts().size() / 4 + std::size_t(graph_.colors()));
    std::size_t points = 0;
    for (int color = 0; color < graph_.colors(); ++color)
    {
      points = take_color(world, graph_[color], points);
    }
    make_room(points_, points);
    points_.assign(points, no_point());
    for (const WideContact& four : fours_)
    {
      put_points(four, world, points_of(four), 1.0 / substeps);
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
      for (WideContact& four : fours_)
      {
        take_masses(four, bodies_, points_of(four));
      }
    }
  }

  /// Lets `look(four, at)` change every point, four at a time; their bodies stay as they are.
  template <class Look>
  void look_at_each(const Look& look)
  {
    for (WideContact& four : fours_)
    {
      look_at(four, look);
    }
  }

  /// Lets `change(four, at)` change every point and its bodies, four at a time.
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
  [[gnu::flatten]] void look_at(WideContact& four, const Look& look)
  {
    gather_motion(bodies_, four.a, four.body_a);
    gather_motion(bodies_, four.b, four.body_b);
    for (ContactConstraint<Four>& at : points_of(four))
    {
      look(four, at);
    }
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

  /// Contacts with as many points come together, so that few lanes idle; how many points there are
  /// with those of this colour.
  std::size_t take_color(IslandView world, std::span<const int> of, std::size_t before)
  {
    const auto contact_of = [&](int pair) -> WorldContact&
    { return world.contacts[place_of(islands.contacts()[place_of(pair)])]; };
    order_.assign(of.begin(), of.end());
    const auto points = [&](int pair) { return contact_of(pair).points().size(); };
    std::sort(
        order_.begin(), order_.end(),
        [&](int i, int j) { return std::pair(points(j), i) < std::pair(points(i), j); });
    for (std::size_t i = 0; i < order_.size(); i += 4)
    {
      WideContact& four = fours_.emplace_back(no_contact(world.bodies.size()));
      four.first = before;
      four.points = points(order_[i]);
      before += four.points;
      for (std::size_t lane = 0; lane < std::min<std::size_t>(4, order_.size() - i); ++lane)
      {
        const int pair = order_[i + lane];
        put_contact(four, lane, contact_of(pair), islands.correction_speed(place_of(pair)));
      }
    }
    return before;
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
