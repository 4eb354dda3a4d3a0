/// \file
/// \brief A ball that is dropped: its bounces under each rule, against the closed form.

#include "05_resolution/restitution/trial/restitution_figures.hpp"
#include "tools/live/page.hpp"

namespace cookbook::live
{

namespace
{

/// The first apex, when the ball is at rest, and its energy: by rule, and as they ought to be.
void show_numbers(Page& page, const Drop& drop, const std::vector<Flight>& flown)
{
  const std::vector<double> heights = apexes(flown, drop.gravity);
  const double e = drop.restitution;
  page.number("first bounce", heights.empty() ? 0 : heights.front(), "m");
  page.number("due, e² H", e * e * drop.height, "m");
  page.number("energy at the end", energy(flown.back(), drop.gravity), "J");
  if (e < 1)
  {
    page.number("due at rest", settling_time(drop.height, drop.gravity, e), "s");
  }
  else
  {
    page.text("due at rest", "never");
  }
}

} // namespace

void figure(Page& page)
{
  const std::vector<BounceRule> rules = bounce_rules();
  std::vector<std::string> names;
  for (const BounceRule& rule : rules)
  {
    names.push_back(rule.name);
  }
  const int rule = page.choice("rule", names, 1);
  const double height = page.slider("height H", 0.2, 2, 1, "m");
  const double restitution = page.slider("restitution e", 0, 1, 1);
  const double rate = page.slider("steps a second", 20, 240, 60);
  const Drop drop{height, restitution, 6, 1 / rate};
  show_numbers(page, drop, flight(drop, rules[static_cast<std::size_t>(rule)]));
  page.draw(drop_chart(drop, rules[static_cast<std::size_t>(rule)], page.fit(720)).svg());
}

} // namespace cookbook::live
