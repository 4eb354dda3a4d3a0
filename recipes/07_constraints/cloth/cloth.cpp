/// \file
/// \brief Cloths that sag, hang, fly and lie on things: stretch, symmetry, energy, clearance.

#include "07_constraints/cloth/cloth.hpp"
#include "07_constraints/cloth/trial/cloth_figures.hpp"
#include "07_constraints/cloth/trial/cloth_scenes.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>
#include <string>

namespace
{

using namespace cookbook;

// [print_squares]
/// How far [m] a cloth differs from itself with columns and rows exchanged.
double diagonal_error(const Cloth& cloth)
{
  double most = 0;
  for (std::size_t row = 0; row < cloth.rows; ++row)
  {
    for (std::size_t column = 0; column < row; ++column)
    {
      const Vector3<double>& p = cloth.particles.positions[cloth.at(column, row)];
      const Vector3<double>& q = cloth.particles.positions[cloth.at(row, column)];
      most = std::max(most, (p - Vector3<double>(q.z(), q.y(), q.x())).norm());
    }
  }
  return most;
}

void print_squares()
{
  Table table(
      {"substeps", "iterations", "longest thread [%]", "area [%]", "sag [mm]",
       "diagonals differ [mm]"});
  for (const auto& [substeps, iterations] :
       {std::pair{1, 1}, {1, 10}, {1, 100}, {10, 1}, {30, 1}, {100, 1}})
  {
    const Cloth cloth = sagged(substeps, iterations);
    table.row(
        {std::to_string(substeps), std::to_string(iterations), rounded(100 * worst_thread(cloth)),
         rounded(100 * (area_of(cloth) - 1)),
         rounded(-1000 * cloth.particles.positions[cloth.at(8, 8)].y()),
         rounded(1000 * diagonal_error(cloth))});
  }
  std::cout << table.text();
}
// [print_squares]

void run(const Arguments& given)
{
  print_squares();
  save_figure(given, "cloth.svg", curtain_picture());
  save_figure(given, "cloth_flag.svg", flag_picture().svg());
  save_figure(given, "cloth_drape.svg", drape_picture().svg());
  save_figure(given, "cloth_stretch.svg", stretch_chart().svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "cloth", .summary = "Cloths that sag, hang, fly and lie on things."};
  return run_program(argc, argv, arguments, run);
}
