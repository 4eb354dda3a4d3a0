/// \file
/// \brief A box to push at any point: its velocity and spin, and the mass that the push feels.

#include "05_resolution/impulse/trial/pushed_box.hpp"
#include "tools/live/page.hpp"

namespace cookbook::live
{

namespace
{

constexpr double scale = 0.25; // [m] for 1 N s, and for 1 m/s

/// The push from its point to where its arrow ends; the point is kept within the box.
Push push_between(const BoxToPush& box, const Eigen::Vector2d& point, const Eigen::Vector2d& end)
{
  const Eigen::Vector2d half = box.half_extents.head<2>();
  const Eigen::Vector2d at = point.cwiseMax(-half).cwiseMin(half), arrow = (end - at) / scale;
  return {{at.x(), at.y(), 0}, {arrow.x(), arrow.y(), 0}};
}

/// What the box has got: momentum, angular momentum, energy.
void show_sums(Page& page, const BoxToPush& box, const Push& push, const Motion<double>& after)
{
  const Conserved<double> sums = conserved<double>(
      after, box.properties.mass, Matrix3<double>(box.properties.moments.asDiagonal()));
  page.number("impulse P", push.impulse.norm(), "N s");
  page.number("momentum", sums.momentum.norm(), "N s");
  page.number("r × P", push.point.cross(push.impulse).z(), "N m s");
  page.number("angular momentum", sums.angular_momentum.z(), "N m s");
  page.number("energy", sums.energy, "J");
}

} // namespace

void figure(Page& page)
{
  const plot::View view{{-1.5, -0.9}, {1.9, 1.5}, page.fit(520)};
  const plot::Figure2d empty("pushed_box", "", view);
  const Eigen::Vector2d point = page.handle("point of the push", empty, {0.8, -0.2});
  const Eigen::Vector2d end =
      page.handle("end of the push", empty, {0.65, 0.5}, plot::Ink::overlap);
  const BoxToPush box = box_to_push(page.slider("mass", 0.5, 5, 2, "kg"));
  const int method = page.choice("method", {"impulse", "as if every mass were 1"});

  const Push push = push_between(box, point, end);
  const Motion<double> after =
      (method == 0 ? pushed(box, push) : pushed_regardless<double>(box.body, push.impulse)).motion;
  page.number("speed v", after.velocity.norm(), "m/s");
  page.number("spin ω", after.angular_velocity.z(), "rad/s");
  page.number("mass felt there, 1/K", felt_mass(box, push), "kg");
  show_sums(page, box, push, after);
  page.draw(pushed_box_figure(box, push, after, scale, view).svg());
}

} // namespace cookbook::live
