/// \file
/// \brief The friction cone: an impulse along the surface to drag, and what a rule leaves of it.

#include "05_resolution/friction/trial/cone_figures.hpp"
#include "05_resolution/friction/trial/friction_scenes.hpp"
#include "tools/live/page.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cookbook::live
{

namespace
{

/// An angle [rad] in degrees.
double in_degrees(double angle)
{
  return angle * 180 / std::numbers::pi;
}

/// The angle [rad] between the sliding before and after; zero where none is left.
double bend(const Eigen::Vector2d& before, const Eigen::Vector2d& after)
{
  const double cross = before.x() * after.y() - before.y() * after.x();
  return after.norm() > 1e-9 ? std::abs(std::atan2(cross, before.dot(after))) : 0;
}

/// The rule's answer in numbers.
void show_numbers(
    Page& page, const Eigen::Vector2d& wanted, const Eigen::Vector2d& given, double coefficient)
{
  const Eigen::Vector2d left = given - wanted;
  const bool sticks = left.norm() <= 1e-9;
  page.text("contact", sticks ? "sticks" : "slips");
  page.number("would hold", wanted.norm(), "N s");
  page.number("limit, μ times normal", coefficient, "N s");
  page.number("friction given", given.norm(), "N s");
  page.number("slides on at", sticks ? 0 : left.norm(), "m/s");
  page.number(
      "path bent by", sticks ? 0 : std::round(1e6 * in_degrees(bend(-wanted, left))) * 1e-6, "°");
  page.number("as on a slope of", in_degrees(std::atan(wanted.norm())), "°");
  page.number("steepest that holds", in_degrees(std::atan(coefficient)), "°");
}

} // namespace

void figure(Page& page)
{
  const bool wide = page.width() > 640;
  const double width = wide ? (page.fit(720) - 16) / 2 : page.fit(360);
  const plot::View above{{-1.2, -1.2}, {1.2, 1.2}, width};
  const plot::Figure2d empty("above", "from above", above);
  const Eigen::Vector2d wanted = page.handle("impulse that would hold", empty, {0.85, 0.6});
  const double coefficient = page.slider("μ", 0, 1.2, 0.6);
  const int rule = page.choice("rule", {"cone", "pyramid: two axes"});

  // One kilogram that slides, with a normal impulse of 1 N s: what would hold is −1 kg times that.
  const SlidingMass<double> mass{Matrix2<double>::Identity(), 1};
  const FrictionVisit visit{-wanted, mass, {0, 0}, coefficient, coefficient};
  const Eigen::Vector2d given = friction_rules()[rule == 0 ? 3 : 2].cut(visit);

  show_numbers(page, wanted, given, coefficient);
  plot::Grid grid("friction_cone", "", wide ? 2 : 1);
  grid.describe("The friction cone from above and from the side, and an impulse along the surface.")
      .add(cone_top("from above", wanted, given, coefficient, rule == 1, above))
      .add(cone_side(
          "from the side", wanted.norm(), std::min(given.norm(), wanted.norm()), coefficient,
          {{-1.3, -0.45}, {1.8, 1.65}, width}));
  page.draw(grid.svg());
}

} // namespace cookbook::live
