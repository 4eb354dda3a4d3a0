#pragma once

/// \file
/// \brief The figures of matrices: where a square's edges go, and columns that may be parallel.

#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <string>
#include <vector>

namespace cookbook
{

/// A capital F in the unit square: it shows which way round a picture of it is.
inline std::vector<Eigen::Vector2d> letter_f(const Eigen::Matrix2d& m)
{
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector2d& corner : std::vector<Eigen::Vector2d>{
           {0.3, 0.2},
           {0.42, 0.2},
           {0.42, 0.48},
           {0.6, 0.48},
           {0.6, 0.6},
           {0.42, 0.6},
           {0.42, 0.74},
           {0.7, 0.74},
           {0.7, 0.86},
           {0.3, 0.86}})
  {
    corners.push_back(m * corner);
  }
  return corners;
}

/// Where a matrix sends the unit square, with its columns as arrows.
inline plot::Figure2d square_under(
    const std::string& name, const std::string& title, const Eigen::Matrix2d& m,
    const std::string& first, const std::string& second, const std::string& area)
{
  const Eigen::Vector2d zero(0, 0), a = m.col(0), b = m.col(1);
  plot::Figure2d figure(name, title, {{-0.7, -0.35}, {3.5, 1.95}, 400});
  figure.grid(1)
      .polygon({zero, a, a + b, b}, plot::Ink::muted)
      .polygon(letter_f(m), plot::Ink::ink, plot::Fill::solid)
      .arrow(zero, a, plot::Ink::a, first, plot::Side::right)
      .arrow(zero, b, plot::Ink::b, second, plot::Side::above)
      .label({2.75, 0.95}, area, plot::Side::centre);
  return figure;
}

/// The unit square, a matrix's picture of it, and that of the matrix with its columns swapped.
inline plot::Grid columns_figure()
{
  Eigen::Matrix2d m, swapped;
  m << 2, 0.5, 0.5, 1.375;
  swapped << m.col(1), m.col(0);
  plot::Grid grid("matrices", "", 1);
  grid.describe("The unit square, and where two matrices send it: one of them mirrors it.")
      .add(square_under(
          "before", "before", Eigen::Matrix2d::Identity(), "(1, 0)", "(0, 1)", "area 1"))
      .add(square_under(
          "after", "after: the columns are where the edges go", m, "column 0", "column 1",
          "det = 2.5"))
      .add(square_under(
          "swapped", "columns swapped: a mirror image", swapped, "column 0", "column 1",
          "det = −2.5"));
  return grid;
}

/// Two columns whose tips are known only to a small box each: they may be parallel.
inline plot::Figure2d near_figure()
{
  const Eigen::Vector2d zero(0, 0), a(3, 1.1), b(2.2, 0.9), half(0.2, 0.07);
  plot::Figure2d figure("matrices_near", "", {{-0.4, -0.3}, {4.1, 1.75}, 400});
  figure.describe("Two nearly parallel columns; a line from the origin meets both boxes.")
      .polygon({zero, a, a + b, b}, plot::Ink::muted, plot::Fill::none, plot::Stroke::dotted)
      .segment(zero, 1.25 * Eigen::Vector2d(2.9, 1.121), plot::Ink::overlap, plot::Stroke::dashed)
      .arrow(zero, a, plot::Ink::a)
      .arrow(zero, b, plot::Ink::b)
      .box(a, 0, half, plot::Ink::a)
      .box(b, 0, half, plot::Ink::b)
      .label(a - Eigen::Vector2d(-0.25, 0.05), "column 0", plot::Side::below_right, plot::Ink::a)
      .label(b + Eigen::Vector2d(-0.2, 0.1), "column 1", plot::Side::above_left, plot::Ink::b);
  return figure;
}

} // namespace cookbook
