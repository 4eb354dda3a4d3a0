#pragma once

/// \file
/// \brief The friction cone from the side and from above, and what it leaves of an impulse.

#include "tools/plot/figures/figure2d.hpp"

#include <string>

namespace cookbook
{

/// The cone from the side: an impulse of 1 N s along the normal, and one along the surface of which
/// so much is wanted and so much given [N s]; the cone's coefficient.
inline plot::Figure2d cone_side(
    const std::string& title, double wanted, double given, double coefficient,
    const plot::View& view)
{
  const bool cut = given < wanted;
  plot::Figure2d figure("side", title, view);
  figure.half_plane({0, 1}, 0)
      .polygon({{0, 0}, {-coefficient, 1}, {coefficient, 1}}, plot::Ink::a)
      .segment({0, 1}, {wanted, 1}, plot::Ink::muted, plot::Stroke::dashed)
      .arrow({0, 0}, {0, 1}, plot::Ink::ink, "λ_{n}", plot::Side::left)
      .arrow({0, 0}, {given, 0}, cut ? plot::Ink::overlap : plot::Ink::good)
      .arrow({0, 0}, {given, 1}, cut ? plot::Ink::overlap : plot::Ink::good)
      .label({given, 0}, cut ? "λ_{t} = μ λ_{n}" : "λ_{t}", plot::Side::below)
      .dot({wanted, 1}, plot::Ink::muted, cut ? "would hold" : "holds", plot::Side::above);
  return figure;
}

/// The cone from above: the impulse [N s] that would end the sliding of 1 kg, what a rule of
/// friction gives, and the velocity [m/s] that is left; the rule allows a circle or a square.
inline plot::Figure2d cone_top(
    const std::string& title, const Eigen::Vector2d& wanted, const Eigen::Vector2d& given,
    double bound, bool square, const plot::View& view)
{
  const bool cut = (given - wanted).norm() > 1e-9;
  const Eigen::Vector2d left = given - wanted;
  plot::Figure2d figure("above", title, view);
  if (square)
  {
    figure.box({0, 0}, 0, {bound, bound}, plot::Ink::a)
        .circle({0, 0}, bound, plot::Ink::muted, plot::Fill::none, plot::Stroke::dashed);
  }
  else
  {
    figure.circle({0, 0}, bound, plot::Ink::a);
  }
  figure.segment({0, 0}, wanted, plot::Ink::muted, plot::Stroke::dashed)
      .segment({0, 0}, -wanted, plot::Ink::muted, plot::Stroke::dotted)
      .arrow({0, 0}, given, cut ? plot::Ink::overlap : plot::Ink::good, "λ_{t}");
  if (cut)
  {
    figure.arrow({0, 0}, left, plot::Ink::ink, "v_{t}");
  }
  return figure;
}

} // namespace cookbook
