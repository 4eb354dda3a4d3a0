#pragma once

/// \file
/// \brief The numbers of a very small float on a line.

#include "tools/plot/figures/figure2d.hpp"

#include <cmath>
#include <vector>

namespace cookbook
{

/// The numbers from 0 to `most` of a float with three binary digits whose smallest power is 1/8.
inline std::vector<double> small_floats(double most)
{
  std::vector<double> all;
  for (int digits = 0; digits < 4; ++digits)
  {
    all.push_back(digits / 32.0); // subnormal: the gaps next to 1/8 go on down to zero
  }
  for (double power = 0.125; power <= most; power *= 2)
  {
    for (int digits = 4; digits < 8; ++digits)
    {
      all.push_back(power * digits / 4);
    }
  }
  std::erase_if(all, [most](double x) { return x > most; });
  return all;
}

/// Draws the small float's numbers from 0 to `most` on a line that ends at 1.
inline void draw_small_floats(plot::Figure2d& figure, double most)
{
  figure.segment({0, 0}, {1.02, 0}, plot::Ink::muted);
  for (const double x : small_floats(most))
  {
    const bool power = std::exp2(std::floor(std::log2(x))) == x;
    const plot::Ink ink = x < 0.125 ? plot::Ink::b : plot::Ink::a;
    const double height = (power && x >= 0.125) || x == 0 ? 0.05 : 0.025;
    figure.segment({x / most, -height}, {x / most, height}, ink, plot::Stroke::solid, 2);
  }
}

/// From 0 to 4: the gaps double at each power of two.
inline plot::Figure2d gaps_figure()
{
  plot::Figure2d figure("numbers_gaps", "", {{-0.06, -0.16}, {1.08, 0.22}, 400});
  draw_small_floats(figure, 4);
  figure.describe("The numbers from 0 to 4 of a float of three binary digits.");
  for (const auto& [x, name] :
       {std::pair{0.0, "0"}, {0.5, "½"}, {1.0, "1"}, {2.0, "2"}, {4.0, "4"}})
  {
    figure.label({x / 4, -0.06}, name, plot::Side::below);
  }
  figure.dimension({0.5, 0.09}, {0.625, 0.09}, "gap ½", 0, plot::Ink::ink)
      .dimension({0.25, 0.09}, {0.3125, 0.09}, "gap ¼", 0, plot::Ink::ink);
  return figure;
}

/// From 0 to 1/2: where 0.1 goes, and the evenly spaced numbers next to zero.
inline plot::Figure2d tenth_figure()
{
  plot::Figure2d figure("numbers_tenth", "", {{-0.06, -0.29}, {1.08, 0.26}, 400});
  draw_small_floats(figure, 0.5);
  figure.describe("Its numbers from 0 to one half; 0.1 is rounded to 3/32.")
      .label({0, -0.06}, "0", plot::Side::below)
      .label({0.25, -0.06}, "⅛", plot::Side::below)
      .label({0.5, -0.06}, "¼", plot::Side::below)
      .label({1, -0.06}, "½", plot::Side::below)
      .segment({0.2, -0.035}, {0.2, 0.035}, plot::Ink::overlap, plot::Stroke::solid, 3)
      .arrow({0.2, 0.14}, {0.1875, 0.035}, plot::Ink::overlap)
      .label({0.2, 0.14}, "0.1 is stored as 3/32", plot::Side::above_right, plot::Ink::overlap)
      .dimension({0, -0.2}, {0.25, -0.2}, "subnormal", 0, plot::Ink::b);
  return figure;
}

} // namespace cookbook
