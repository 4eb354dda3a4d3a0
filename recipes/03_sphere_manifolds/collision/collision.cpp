/// \file
/// \brief Two balls that move: relative velocity, approach, nature, and how they are separated.

#include "03_sphere_manifolds/collision/collision.hpp"
#include "03_sphere_manifolds/collision/trial/collision_names.hpp"
#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

constexpr double tolerance = 0.01;     // [m]
constexpr double resting_speed = 0.01; // [m/s]
constexpr double inverse_mass_a = 1;   // [1/kg]
constexpr double inverse_mass_b = 0.5; // [1/kg], twice as heavy

const Sphere<double> sphere_a{{0, 0, 0}, 1};

/// B at a distance from A along x, moving along x.
struct Meeting
{
  const char* name;
  double distance; // [m]
  double speed;    // [m/s]
};

const Meeting meetings[] = {{"passing by", 2.5, -1}, {"hit", 2, -1},    {"rest", 2, 0},
                            {"rebound", 2, 1},       {"stuck", 1.4, 0}, {"deep hit", 1.4, -1}};

void print_meetings()
{
  Table table({"meeting", "depth", "nature", "approach", "A moves", "B moves"});
  for (const Meeting& meeting : meetings)
  {
    const Vector3<double> center_b(meeting.distance, 0, 0);
    const Motion<double> a{sphere_a.center, {0, 0, 0}, {0, 0, 0}};
    const Motion<double> b{center_b, {meeting.speed, 0, 0}, {0, 0, 0}};
    const std::optional<Manifold<double>> manifold = plain_sphere_sphere(sphere_a, {center_b, 1});
    if (!manifold)
    {
      table.row({meeting.name, "apart", name_of(nature(manifold, tolerance)), "", "", ""});
      continue;
    }
    const Vector3<double> velocity = relative_velocity(a, b, manifold->points[0].position);
    const SeparatingMoves<double> moves =
        separating_moves(*manifold, inverse_mass_a, inverse_mass_b);
    table.row(
        {meeting.name, number(manifold->depth), name_of(nature(manifold, tolerance)),
         name_of(approach(velocity, manifold->normal, resting_speed)), number(moves.a.x()),
         number(moves.b.x())});
  }
  std::cout << table.text();
}

/// Draws a ball with its velocity and the sense in which it turns.
void draw_sphere(
    plot::Figure2d& figure, const Motion<double>& motion, double angle, plot::Ink ink,
    const std::string& name)
{
  const Eigen::Vector2d center = motion.center.head<2>();
  const double turned = motion.angular_velocity.z() < 0 ? -0.7 : 0.7;
  const auto at = [&](double t) -> Eigen::Vector2d
  { return center + 0.75 * Eigen::Vector2d(std::cos(t), std::sin(t)); };
  figure.circle(center, 1, ink)
      .angle(center, 0.75, angle, angle + turned, "ω_{" + name + "}", ink)
      .arrow(at(angle + 0.9 * turned), at(angle + 1.1 * turned), ink)
      .arrow(center, center + motion.velocity.head<2>(), ink, "v_{" + name + "}")
      .dot(center, ink, name, plot::Side::left);
}

void draw(const Arguments& arguments)
{
  const Motion<double> a{{0, 0, 0}, {0.6, 0.1, 0}, {0, 0, 0.6}};
  const Motion<double> b{{1.7, 0, 0}, {-0.5, -0.35, 0}, {0, 0, -0.7}};
  const Manifold<double> manifold = plain_sphere_sphere(sphere_a, {b.center, 1}).value();
  const Vector3<double> contact = manifold.points[0].position;
  const Eigen::Vector2d point = contact.head<2>();
  plot::Figure2d figure("collision", "", {{-1.1, -1.1}, {2.8, 1.1}, 400});
  figure.describe("Velocities of two turning balls at their contact point, and the difference.");
  draw_sphere(figure, a, 2, plot::Ink::a, "A");
  draw_sphere(figure, b, 1.2, plot::Ink::b, "B");
  figure.arrow(point, point + 0.5 * manifold.normal.head<2>(), plot::Ink::ink, "n")
      .arrow(point, point + velocity_at(a, contact).head<2>(), plot::Ink::a, "A's at the point")
      .arrow(point, point + velocity_at(b, contact).head<2>(), plot::Ink::b, "B's at the point")
      .arrow(
          point, point + relative_velocity(a, b, contact).head<2>(), plot::Ink::overlap,
          "relative velocity", plot::Side::below)
      .point(point);
  save_figure(arguments, "collision.svg", figure.svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "collision",
      .summary =
          "Relative velocity, approach and nature of a collision, and the separating moves."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_meetings();
        draw(given);
      });
}
