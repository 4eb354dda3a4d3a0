#pragma once

/// \file
/// \brief A cloth: particles in a grid, the distances that they keep, and the triangles in between.

#include "07_constraints/particles/checked_particles.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [cloth]
/// A rectangle of cloth as it is laid out, flat and at rest.
struct ClothSheet
{
  Vector3<double> corner{0, 0, 0}; ///< [m], world, of column 0 and row 0
  Vector3<double> across{1, 0, 0}; ///< [m], from the first column to the last
  Vector3<double> down{0, 0, 1};   ///< [m], from the first row to the last
  std::size_t columns = 16;        ///< of particles, 2 or more
  std::size_t rows = 16;           ///< of particles, 2 or more
  double mass = 0.2;               ///< [kg], of the whole
  double stretch = 0;              ///< [m/N], compliance along threads
  double shear = 1e-3;             ///< [m/N], compliance of the diagonals between threads
  double bend = 1e-1;              ///< [m/N], compliance between every other particle
};

/// A cloth of particles, row by row.
struct Cloth
{
  std::size_t columns, rows;
  Particles particles;
  std::vector<DistanceConstraint> constraints;
  std::vector<std::array<std::size_t, 3>> triangles; ///< two a cell, both the same way round

  /// The place of a particle in the lists.
  std::size_t at(std::size_t column, std::size_t row) const { return row * columns + column; }
};
// [cloth]

// [add_constraints]
/// Joins the particles of a cloth, those that `some(column, row)` asks for, with the ones `right`
/// columns and `below` rows on, at the distance they have.
template <class Some>
void add_constraints(Cloth& cloth, int right, int below, double compliance, const Some& some)
{
  const int columns = static_cast<int>(cloth.columns), rows = static_cast<int>(cloth.rows);
  for (int row = 0; row + below < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const bool inside = column + right >= 0 && column + right < columns;
      if (inside && some(column, row))
      {
        const int place = row * columns + column;
        const auto a = static_cast<std::size_t>(place);
        const int offset = below * columns + right;
        const std::size_t b = a + static_cast<std::size_t>(offset);
        DistanceConstraint pair{a, b, 0, compliance};
        pair.length = direction_of(cloth.particles, pair).length;
        cloth.constraints.push_back(pair);
      }
    }
  }
}

/// Adds the constraints of a cloth in groups in which no two share a particle, so that their order
/// within a group changes nothing: structural ones along the threads, shear ones across the
/// diagonals of each cell, and bending ones between every other particle.
inline void add_constraints(Cloth& cloth, const ClothSheet& sheet)
{
  for (const int odd : {0, 1})
  {
    add_constraints(cloth, 1, 0, sheet.stretch, [&](int c, int) { return c % 2 == odd; });
    add_constraints(cloth, 0, 1, sheet.stretch, [&](int, int r) { return r % 2 == odd; });
  }
  for (const int cell : {0, 1, 2, 3})
  {
    const auto in_cell = [&](int c, int r) { return c % 2 == cell % 2 && r % 2 == cell / 2; };
    add_constraints(cloth, 1, 1, sheet.shear, in_cell);
    const auto left_of = [&](int c, int r) { return in_cell(c - 1, r); };
    add_constraints(cloth, -1, 1, sheet.shear, left_of);
  }
  for (const int odd : {0, 1})
  {
    add_constraints(cloth, 2, 0, sheet.bend, [&](int c, int) { return c / 2 % 2 == odd; });
    add_constraints(cloth, 0, 2, sheet.bend, [&](int, int r) { return r / 2 % 2 == odd; });
  }
}
// [add_constraints]

// [make_cloth]
/// Lays out a cloth.
///
/// Throws std::invalid_argument, with member and value, where a number is not finite or makes no
/// sense.
inline Cloth make_cloth(const ClothSheet& sheet)
{
  check_setting("columns", static_cast<double>(sheet.columns), 2, 1e4);
  check_setting("rows", static_cast<double>(sheet.rows), 2, 1e4);
  const double count = static_cast<double>(sheet.columns * sheet.rows);
  check_setting("mass", sheet.mass, count / largest_number, count * largest_number);
  Cloth cloth{sheet.columns, sheet.rows, {}, {}, {}};
  for (std::size_t i = 0; i < sheet.columns * sheet.rows; ++i)
  {
    const std::size_t column = i % sheet.columns, row = i / sheet.columns;
    const double s = static_cast<double>(column) / static_cast<double>(sheet.columns - 1);
    const double t = static_cast<double>(row) / static_cast<double>(sheet.rows - 1);
    cloth.particles.positions.push_back(sheet.corner + s * sheet.across + t * sheet.down);
    cloth.particles.velocities.push_back({0, 0, 0});
    cloth.particles.inverse_masses.push_back(count / sheet.mass);
  }
  add_constraints(cloth, sheet);
  for (std::size_t row = 0; row + 1 < sheet.rows; ++row)
  {
    for (std::size_t column = 0; column + 1 < sheet.columns; ++column)
    {
      const std::size_t a = cloth.at(column, row), b = a + 1, c = a + sheet.columns, d = c + 1;
      cloth.triangles.push_back({a, c, b});
      cloth.triangles.push_back({b, c, d});
    }
  }
  check(cloth.particles);
  check(cloth.constraints, cloth.particles.positions.size());
  return cloth;
}
// [make_cloth]

} // namespace cookbook
