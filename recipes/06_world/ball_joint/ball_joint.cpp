/// \file
/// \brief Swings a pendulum on a ball joint, and compares its period with the closed form.

#include "06_world/ball_joint/ball_joint.hpp"
#include "06_world/ball_joint/trial/joint_pendulum.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>
#include <string>

namespace
{

using namespace cookbook;

// [print_periods]
void run(const Arguments&)
{
  Table table({"solver", "steps a second", "period [s]", "off by [1e-6]", "anchors apart [mm]"});
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const int rate : {60, 240})
    {
      const Swing swing = swing_of({.solver = solver, .rate = rate, .amplitude = 0.5});
      table.row(
          {solver, std::to_string(rate), number(std::round(1000 * swing.period) / 1000),
           rounded(1e6 * std::abs(swing.period / swing.right - 1)), rounded(1000 * swing.apart)});
    }
  }
  std::cout << table.text();
}
// [print_periods]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "ball_joint", .summary = "Swings a pendulum on a ball joint in the game's world."};
  return run_program(argc, argv, arguments, run);
}
