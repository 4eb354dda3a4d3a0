#pragma once

/// \file
/// \brief A pyramid whose contacts are drawn in their colours.

#include "06_world/contact_graph/trial/contact_graph_scenes.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"

#include <array>
#include <string>

namespace cookbook
{

/// How a colour is drawn; its number stands beside it, for print.
inline plot::Ink ink_of(int color)
{
  using enum plot::Ink;
  constexpr std::array inks{series1, series2, series3, series4, series5, series6};
  return inks[static_cast<std::size_t>(color) % inks.size()];
}

/// A wall of bricks; `shown` is the one colour that is drawn, or −1 for all.
inline plot::Figure2d colored_wall(const std::string& title, int shown)
{
  const TouchingBodies wall(named_scene("wall_2"));
  const ContactGraph graph = wall.colored();
  plot::Figure2d figure("contact_graph", title, {{-2.3, -0.25}, {2.3, 1.2}, 330});
  figure.half_plane({0, 1}, 0);
  const auto middle = [&](int body) -> Eigen::Vector2d
  { return wall.scene.bodies[index_of(body)].position.head<2>(); };
  for (std::size_t i = 1; i < wall.scene.bodies.size(); ++i)
  {
    figure.box(middle(static_cast<int>(i)), 0, {0.49, 0.24}, plot::Ink::muted, plot::Fill::none);
  }
  for (std::size_t i = 0; i < wall.pairs.size(); ++i)
  {
    const auto [a, b] = wall.pairs[i];
    const int color = graph.color_of_each()[i];
    if (shown >= 0 && color != shown)
    {
      continue;
    }
    const Eigen::Vector2d to = middle(b);
    const Eigen::Vector2d from = a == 0 ? Eigen::Vector2d(to.x(), 0) : middle(a);
    figure.segment(from, to, ink_of(color), plot::Stroke::solid, 3);
    figure.label((from + to) / 2, std::to_string(color), plot::Side::automatic, ink_of(color));
  }
  return figure;
}

/// All contacts of a wall, and those of one colour after the other.
inline plot::Grid contact_graph_figure()
{
  const int colors = TouchingBodies(named_scene("wall_2")).colored().colors();
  plot::Grid grid("contact_graph", "", 2);
  grid.describe("The contacts of seven bricks in colours: those of one colour share no brick.");
  grid.add(colored_wall("all contacts", -1));
  for (int color = 0; color < colors; ++color)
  {
    grid.add(colored_wall("colour " + std::to_string(color), color));
  }
  return grid;
}

} // namespace cookbook
