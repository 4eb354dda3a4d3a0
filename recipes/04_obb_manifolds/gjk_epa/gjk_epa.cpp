/// \file
/// \brief Finds depths and points of pairs of boxes by GJK and EPA, draws how the polytope grows,
/// and tries all ways to run them at all cases.

#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"
#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_figures.hpp"
#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_verdicts.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

/// Two boxes of which the lower is turned, the upper leans: their closest face is of edges.
const Obb<double> below{{0, 0, 0}, turned(0.4, {0, 1, 0}), {1, 0.6, 0.7}};
const Obb<double> above{{0.5, 0.9, 0.3}, turned(0.8, {1, 0.2, 0.6}), {0.5, 0.8, 0.6}};

std::string cell(double x)
{
  return number(std::round(x * 1e6) * 1e-6);
}

/// One line for each direction that EPA tries: below and above the depth.
void print_steps()
{
  const RelativeBoxes<double> boxes = relative_boxes(below, above);
  const MinkowskiDifference<double> support{boxes};
  const double tolerance = rounding_tolerance(boxes);
  const GjkAnswer<double> decision = gjk(support, boxes.offset, tolerance);
  Expansion<double> expansion = start_expansion(support, decision.simplex, tolerance);
  Table table({"corners", "faces", "closest face", "best depth"});
  for (bool more = true; more;)
  {
    const Polytope<double>& polytope = expansion.polytope;
    const std::vector<std::string> before{
        std::to_string(polytope.corner_count), std::to_string(polytope.face_count),
        cell(polytope.faces[closest_face(polytope)].distance)};
    more = expand(expansion, support);
    table.row({before[0], before[1], before[2], cell(expansion.depth)});
  }
  std::cout << "GJK asked for " << decision.steps << " support points.\n\n" << table.text();
}

void print_cases()
{
  Table table({"boxes", "depth", "asked", "normal x", "y", "z", "point x", "y", "z"});
  for (const BoxCase& pair : box_cases())
  {
    const std::optional<Manifold<double>> manifold = gjk_epa(pair.a, pair.b);
    if (!manifold)
    {
      table.row({pair.scene, "apart", "", "", "", "", "", "", ""});
      continue;
    }
    const ConvexPair<double> solid = convex_pair(pair.a, pair.b);
    const GjkAnswer<double> decision = gjk(solid.support, solid.start, tolerance_of(solid));
    const int asked =
        decision.steps + epa(solid.support, decision.simplex, tolerance_of(solid)).steps;
    const Vector3<double>&n = manifold->normal, &p = manifold->points[0].position;
    table.row(
        {pair.scene, cell(manifold->depth), std::to_string(asked), cell(n.x()), cell(n.y()),
         cell(n.z()), cell(p.x()), cell(p.y()), cell(p.z())});
  }
  std::cout << "\n" << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  return run_pairs_program(
      argc, argv,
      {.name = "gjk_epa",
       .summary = "The manifold of two boxes by GJK and EPA: normal, depth, one point.",
       .pairs_header = box_pairs_header},
      of_box_rows([](const auto& a, const auto& b) { return gjk_epa(a, b); }, BoxLengths::any),
      [](const Arguments& given)
      {
        print_steps();
        print_cases();
        save_figure(given, "gjk_epa_minkowski_difference.svg", minkowski_grid().svg());
        save_figure(given, "gjk_epa.svg", polytope_steps(below, above).svg());
        save_figure(given, "gjk_epa_error.svg", excess_chart(2000).svg());
        save_figure(
            given, "gjk_epa_verdicts.html",
            verdict_table(
                "Four ways to run GJK and EPA", names_of(convex_methods()), convex_verdicts()));
      });
}
