/// \file
/// \brief The angle of two vectors by each way, in float, as near to zero and to π as a float can
/// come.

#include "01_math/angles/trial/angles_figures.hpp"
#include "tools/live/page.hpp"

#include <cmath>

namespace cookbook::live
{

namespace
{

/// Shows what a way finds, as far from zero or from π as the truth is.
void show(Page& page, const std::string& way, double found, bool at_pi)
{
  const double pi = 3.14159265358979324;
  const double shown = at_pi ? pi - found : found;
  page.number(
      at_pi ? "π − " + way : way, std::round(shown * 1e6) / 1e6,
      "rad"); // floats at π are 2e-7 apart
}

} // namespace

void figure(Page& page)
{
  const bool at_pi = page.choice("near", {"0: same direction", "π: opposite"}) == 1;
  const double thousandths = page.slider("angle", 0, 1, 0.26, "mrad");
  const Vector3<float> a(1, 0, 0), near_a = turned_by_half_tangent<float>(thousandths * 0.5e-3);
  const Vector3<float> b = at_pi ? Vector3<float>(-near_a.x(), near_a.y(), 0) : near_a;
  page.number(at_pi ? "π − truth" : "truth", thousandths * 1e-3, "rad");
  show(page, "acos, as published", double(angle_acos(a, b)), at_pi);
  show(page, "acos, clamped", double(angle_clamped(a, b)), at_pi);
  show(page, "Kahan", double(angle_kahan(a, b)), at_pi);
  show(page, "atan2, recommended", double(angle(a, b)), at_pi);
  plot::Chart chart = steps_chart("angles_live", page.fit(480));
  page.draw(chart.reference_x(thousandths, "").svg());
}

} // namespace cookbook::live
