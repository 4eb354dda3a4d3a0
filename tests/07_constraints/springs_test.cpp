/// \file
/// Springs: frequency and damping asked and got, closed forms, and that none gains energy.

#include "07_constraints/springs/spring_coefficients.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <complex>
#include <numbers>

using namespace cookbook;

TEST_CASE("coefficients of 1 to 15 Hz at 60 Hz are those of the eigenvalues, to 1e-12", "[R39]")
{
  const double step = 1.0 / 60;
  for (const double frequency : {1.0, 5.0, 10.0, 15.0})
  {
    for (const double ratio : {0.0, 0.1, 0.5, 0.99})
    {
      const double w = 2 * std::numbers::pi * frequency;
      const std::complex<double> rate(-ratio * w, w * std::sqrt(1 - ratio * ratio));
      const std::complex<double> eigenvalue = std::exp(rate * step);
      const auto [keeps, pulls] = spring_coefficients(frequency, ratio, step);
      const double trace = 1 + step * pulls + keeps;
      CHECK(std::abs(keeps - std::norm(eigenvalue)) <= 1e-12);
      CHECK(std::abs(trace - 2 * eigenvalue.real()) <= 1e-12);
    }
  }
}
