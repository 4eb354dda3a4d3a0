/// \file
/// \brief Two balls that move: relative velocity, approach, nature, and how they share the way out.

#include "03_sphere_manifolds/collision/collision.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "common/plot/figures/figure2d.hpp"
#include "common/program/program.hpp"
#include "common/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

constexpr double tolerance = 0.01;     // [m]
constexpr double resting_speed = 0.01; // [m/s]
constexpr double inverse_mass_a = 1;   // [1/kg]
constexpr double inverse_mass_b = 0.5; // [1/kg], twice as heavy

const Sphere<double> ball_a{{0, 0, 0}, 1};

/// B at a distance from A along x, moving along x.
struct Meeting
{
  const char* name;
  double distance; // [m]
  double speed;    // [m/s]
};

const Meeting meetings[] = {{"passing by", 2.5, -1}, {"hit", 2, -1},    {"rest", 2, 0},
                            {"rebound", 2, 1},       {"stuck", 1.4, 0}, {"deep hit", 1.4, -1}};

const char* name_of(Nature nature)
{
  const char* const names[] = {"separated", "colliding", "penetrating"};
  return names[static_cast<int>(nature)];
}

const char* name_of(Approach approach)
{
  const char* const names[] = {"approaching", "resting", "separating"};
  return names[static_cast<int>(approach)];
}

void print_meetings()
{
  Table table({"meeting", "depth", "nature", "approach", "A moves", "B moves"});
  for (const Meeting& meeting : meetings)
  {
    const Vector3<double> center_b(meeting.distance, 0, 0);
    const Motion<double> a{ball_a.center, {0, 0, 0}, {0, 0, 0}};
    const Motion<double> b{center_b, {meeting.speed, 0, 0}, {0, 0, 0}};
    const std::optional<Manifold<double>> manifold = sphere_sphere(ball_a, {center_b, 1});
    if (!manifold)
    {
      table.row({meeting.name, "apart", name_of(nature(manifold, tolerance)), "", "", ""});
      continue;
    }
    const Vector3<double> velocity = relative_velocity(a, b, manifold->points[0].position);
    const PartingMoves<double> moves = parting_moves(*manifold, inverse_mass_a, inverse_mass_b);
    table.row(
        {meeting.name, number(manifold->depth), name_of(nature(manifold, tolerance)),
         name_of(approach(velocity, manifold->normal, resting_speed)), number(moves.a.x()),
         number(moves.b.x())});
  }
  std::cout << table.text();
}

void draw(const Arguments& arguments)
{
  const Motion<double> a{{0, 0, 0}, {0.6, 0.2, 0}, {0, 0, 0.5}};
  const Motion<double> b{{1.7, 0, 0}, {-0.5, 0.1, 0}, {0, 0, 0.4}};
  const Manifold<double> manifold = sphere_sphere(ball_a, {b.center, 1}).value();
  const Vector3<double> point = manifold.points[0].position;
  const auto flat = [](const Vector3<double>& v) { return Eigen::Vector2d(v.x(), v.y()); };
  const auto arrow_at_point = [&](const Vector3<double>& v) { return flat(point + v); };
  plot::Figure2d figure("collision", "", {{-1.2, -1.2}, {2.9, 1.2}, 640});
  figure.describe("Velocities of two turning balls at their contact point, and the difference.")
      .circle(flat(ball_a.center), 1, plot::Ink::a)
      .circle(flat(b.center), 1, plot::Ink::b)
      .arrow(flat(a.center), flat(a.center + a.velocity), plot::Ink::a, "v_{A}")
      .arrow(flat(b.center), flat(b.center + b.velocity), plot::Ink::b, "v_{B}")
      .arrow(flat(point), arrow_at_point(velocity_at(a, point)), plot::Ink::a, "A at the point")
      .arrow(flat(point), arrow_at_point(velocity_at(b, point)), plot::Ink::b, "B at the point")
      .arrow(
          flat(point), arrow_at_point(relative_velocity(a, b, point)), plot::Ink::overlap,
          "relative velocity", plot::Side::below)
      .point(flat(point), plot::Ink::ink);
  save_figure(arguments, "collision.svg", figure.svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "collision",
      .summary = "Relative velocity, approach and nature of a collision, and the way apart."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_meetings();
        draw(given);
      });
}
