#pragma once

/// \file
/// \brief Scenes whose contacts are given colours: which bodies touch at the start, and what it
/// comes to.

#include "06_world/contact_graph/contact_graph.hpp"
#include "06_world/contacts/rigid_body.hpp"
#include "06_world/contacts/start_body.hpp"
#include "06_world/contacts/world_contact.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace cookbook
{

/// The pairs of bodies that touch in a scene as it starts.
struct TouchingBodies
{
  Scene scene;
  std::vector<bool> moves;                ///< whether a body can
  std::vector<std::pair<int, int>> pairs; ///< of bodies that touch

  explicit TouchingBodies(Scene of) : scene(std::move(of)), pairs(touching_pairs(scene))
  {
    for (const SceneBody& body : scene.bodies)
    {
      moves.push_back(!is_fixed(rigid_body(body)));
    }
  }

  /// The contacts in colours.
  ContactGraph colored() const
  {
    ContactGraph graph;
    graph.color(moves.size(), pairs, [this](int i) { return bool(moves[index_of(i)]); });
    return graph;
  }

  /// How many contacts the movable body has that has the most.
  int most_at_one() const
  {
    std::vector<int> counts(moves.size(), 0);
    for (const auto& [a, b] : pairs)
    {
      counts[index_of(a)] += moves[index_of(a)] ? 1 : 0;
      counts[index_of(b)] += moves[index_of(b)] ? 1 : 0;
    }
    return *std::max_element(counts.begin(), counts.end());
  }
};

/// Contacts solved side by side, `width` at a time.
struct SideBySide
{
  int groups;  ///< how many times
  double used; ///< [1], the fraction of places that are taken
};

/// How well the colours of a graph fill groups of `width`.
inline SideBySide side_by_side(const ContactGraph& graph, int width)
{
  int groups = 0;
  for (int color = 0; color < graph.colors(); ++color)
  {
    groups += (static_cast<int>(graph[color].size()) + width - 1) / width;
  }
  const double contacts = static_cast<double>(graph.color_of_each().size());
  return {groups, groups > 0 ? contacts / (groups * width) : 1};
}

} // namespace cookbook
