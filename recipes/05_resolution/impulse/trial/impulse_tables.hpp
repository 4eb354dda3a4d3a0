#pragma once

/// \file
/// \brief What the program of the impulse prints: balls, landings of a cube, passes.

#include "05_resolution/impulse/trial/bounce_cases.hpp"
#include "05_resolution/impulse/trial/conserved.hpp"
#include "05_resolution/impulse/trial/impulse_pitfalls.hpp"
#include "05_resolution/impulse/trial/impulse_scenes.hpp"
#include "05_resolution/mass_properties/mass_properties.hpp"
#include "tools/program/table.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// The x and y of a vector, as text.
inline std::string vector_text(const Vector3<double>& v)
{
  std::string text = "(";
  return text.append(tidy(v.x())).append(", ").append(tidy(v.y())).append(")");
}

/// The balls and their sums, before and after.
inline std::string balls_table(const TwoBalls& balls, const BodyPair<double>& after)
{
  Table table({"two balls", "velocity of A", "velocity of B", "momentum", "energy"});
  const auto row = [&](const std::string& name, const BodyPair<double>& bodies)
  {
    const Conserved<double> sums = conserved(balls, bodies);
    table.row(
        {name, vector_text(bodies.a.motion.velocity), vector_text(bodies.b.motion.velocity),
         vector_text(sums.momentum), tidy(sums.energy)});
  };
  row("before", balls.bodies);
  row("after", after);
  return table.text();
}

/// What becomes of the cube, landing by landing.
inline std::string landings_table(double restitution)
{
  Table table({"cube lands", "points", "up [m/s]", "spin [rad/s]", "impulse [N s]", "energy [J]"});
  const MassProperties<double> cube = unit_cube();
  for (const Landing& landing : landings())
  {
    const Motion<double> after = bounce(landing.bodies, landing.manifold, restitution, 40).a.motion;
    const Matrix3<double> inertia = world_inertia(cube.moments, landing.cube.axes);
    const double push = cube.mass * (after.velocity.y() - landing.bodies.a.motion.velocity.y());
    table.row(
        {landing.name, std::to_string(landing.manifold.points.size()), tidy(after.velocity.y()),
         tidy(after.angular_velocity.norm()), tidy(push),
         tidy(conserved(after, cube.mass, inertia).energy)});
  }
  return table.text();
}

/// How fast the cube comes up after each number of passes.
inline std::string passes_table()
{
  Table table({"passes, e = 1", "points at ±0.5", "points at ±0.375", "divided, at ±0.5"});
  const std::vector<BounceCase<double>> cases = bounce_cases<double>();
  const auto up = [](const BodyPair<double>& bodies) { return tidy(bodies.a.motion.velocity.y()); };
  for (int passes = 1; passes <= 6; ++passes)
  {
    table.row(
        {std::to_string(passes), up(bounce(cases[0].bodies, cases[0].manifold, 1.0, passes)),
         up(bounce(cases[1].bodies, cases[1].manifold, 1.0, passes)),
         up(bounce_divided(cases[0].bodies, cases[0].manifold, 1.0, passes))});
  }
  return table.text();
}

} // namespace cookbook
