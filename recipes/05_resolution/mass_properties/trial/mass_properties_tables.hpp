#pragma once

/// \file
/// \brief What the program of mass properties prints: solids, and an axe with several heads.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "05_resolution/mass_properties/checked_mass.hpp"
#include "05_resolution/mass_properties/trial/mass_properties_figures.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace cookbook
{

/// Solids of one mass [kg] and one length of 1 m, each with its moments.
inline std::string solids_table(double mass)
{
  Table table({"solid", "mass [kg]", "I_x [kg m²]", "I_y [kg m²]", "I_z [kg m²]"});
  const auto row = [&](const std::string& name, const MassProperties<double>& solid)
  {
    const Vector3<double>& moments = checked(solid).moments;
    table.row(
        {name, number(solid.mass), number(moments.x()), number(moments.y()), number(moments.z())});
  };
  row("ball, 1 m across", solid_sphere(mass, 0.5));
  row("cube, 1 m", solid_box<double>(mass, {0.5, 0.5, 0.5}));
  row("capsule, 1 m by 0.25 m", solid_capsule(mass, 0.75, 0.125));
  row("rod, 1 m by 0.02 m", solid_box<double>(mass, {0.01, 0.5, 0.01}));
  row("plate, 1 m by 0.01 m", solid_box<double>(mass, {0.5, 0.005, 0.5}));
  return table.text();
}

/// The axe's centre of mass, moments and lean, for several heads.
inline std::string axe_table()
{
  Table table({"head [kg]", "c_x [m]", "c_y [m]", "I_1", "I_2", "I_3", "axis 1 leans by [°]"});
  for (const double head : {0.1, 0.4, 1.6, 6.4})
  {
    const PlacedSolid<double> whole = combined(solids(axe(head)));
    const Vector3<double>& moments = checked(whole.properties).moments;
    const double lean = std::atan2(whole.axes(0, 0), whole.axes(1, 0)) * 180 / std::numbers::pi;
    table.row(
        {number(head), number(whole.center.x()), number(whole.center.y()), number(moments[0]),
         number(moments[1]), number(moments[2]), number(lean)});
  }
  return table.text();
}

} // namespace cookbook
