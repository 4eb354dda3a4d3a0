/// \file
/// \brief Lets two balls bounce off each other, and a cube off a floor, and draws both.

#include "05_resolution/impulse/impulse.hpp"
#include "05_resolution/impulse/trial/bounce_cases.hpp"
#include "05_resolution/impulse/trial/impulse_cases.hpp"
#include "05_resolution/impulse/trial/impulse_figures.hpp"
#include "05_resolution/impulse/trial/impulse_scenes.hpp"
#include "05_resolution/impulse/trial/impulse_tables.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void run(const Arguments& given)
{
  const double restitution = number_option(given, "restitution", 0.0, 1.0);
  const TwoBalls balls = two_balls(number_option(given, "mass", 0.001, 1000.0));
  const ContactPoint<double>& contact = balls.manifold.points[0];
  const BodyPair<double> after =
      resolve_collision(balls.bodies, balls.manifold.normal, contact.position, restitution);
  std::cout << balls_table(balls, after) << "\n"
            << landings_table(restitution) << "\n"
            << passes_table();
  save_figure(given, "impulse.svg", balls_figure(balls, after).svg());
  save_figure(given, "impulse_corner.svg", corner_figure(on_pebble(), restitution).svg());
  save_figure(given, "impulse_passes.svg", passes_figure().svg());
  save_figure(
      given, "impulse_bounces.html",
      verdict_table(
          "Bounces that lose nothing: each body comes down at 1 m/s and is to come up at 1 m/s, "
          "to 1 %, with a spin of at most 0.01 rad/s.",
          names_of(bounce_methods<double>()), bounce_verdicts()));
  save_figure(
      given, "impulse_responses.html",
      verdict_table(
          "What a push of 1 N m s or 6 N s does to a body at rest.",
          {"as published", "impulse.hpp"}, response_verdicts()));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "impulse",
      .summary = "Lets two balls bounce off each other, and a cube off a floor: velocities, "
                 "momentum and energy before and after.",
      .options = {
          {"restitution", "how much of the speed a bounce gives back, 0 to 1", "0.5", {}},
          {"mass", "mass of ball B [kg], 0.001 to 1000; ball A has 1 kg", "2", {}}}};
  return run_program(argc, argv, arguments, run);
}
