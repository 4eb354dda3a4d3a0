/// \file
/// \brief A spinning body followed by each way to turn an orientation: its quaternion, how far it
/// lags behind, and how long it gets.

#include "01_math/turning/trial/turning_figures.hpp"
#include "tools/live/page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cookbook::live
{

namespace
{

using Way = Quaternion<double> (*)(const Quaternion<double>&, const Vector3<double>&, double);

constexpr std::array<Way, 4> ways = {
    quaternion_added<double>, quaternion_added_and_normalised<double>, turned_by_fraction<double>,
    [](const Quaternion<double>& q, const Vector3<double>& spin, double h)
    { return turned_by<double>(q, spin, h); }};

/// The body while it turns about z: the steps of the chosen way, and of the right one.
struct Turning
{
  Quaternion<double> q{1, 0, 0, 0};
  std::vector<Eigen::Vector2d> way{{1, 0}}, turned{{1, 0}};
  double angle = 0; ///< turned in truth [rad]
  double lag = 0;   ///< behind the truth [rad]
};

/// One step of 1/60 s; of what came before the last 24 steps are kept.
void step(Turning& body, Way way, double spin)
{
  const Eigen::Vector2d before = body.way.back();
  body.q = way(body.q, {0, 0, spin}, 1.0 / 60);
  body.angle += spin / 60;
  const Eigen::Vector2d now(body.q.w(), body.q.z());
  const double turned =
      2 * std::atan2(before.x() * now.y() - before.y() * now.x(), before.dot(now));
  body.lag += spin / 60 - turned;
  body.way.push_back(now);
  body.turned.emplace_back(std::cos(body.angle / 2), std::sin(body.angle / 2));
  if (body.way.size() > 24)
  {
    body.way.erase(body.way.begin());
    body.turned.erase(body.turned.begin());
  }
}

} // namespace

void figure(Page& page)
{
  static Turning body;
  const int way = page.choice("way", {"added", "added, length one", "by a fraction", "turned"});
  const double spin = page.slider("spin", 0, 60, 24, "rad/s");
  if (page.begins() || page.changed("way"))
  {
    body = {};
    for (int i = 0; i < 9; ++i) // something to see before it moves
    {
      step(body, ways[std::size_t(way)], spin);
    }
  }
  for (int i = 0; i < page.steps() && body.q.norm() < 1e6; ++i)
  {
    step(body, ways[std::size_t(way)], spin);
  }
  const double degree = std::numbers::pi / 180, length = body.q.norm();
  page.number("turned in truth", body.angle / degree, "°");
  const double shown = std::round(body.lag / degree * 1e6) / 1e6; // the rest is rounding
  page.number("behind the truth", shown, "°");
  page.number("length of the quaternion", length);
  page.plot("behind the truth", shown, "°");
  page.plot("length of the quaternion", length);
  double reach = 1;
  for (const Eigen::Vector2d& at : body.way)
  {
    reach = std::max(reach, at.norm());
  }
  const double half = 1.45 * reach;
  const plot::View view{{-half, -0.75 * half}, {half, 0.75 * half}, page.fit(400)};
  page.draw(
      ways_figure("turning_live", way == 3 ? "" : "this way", body.turned, body.way, view).svg());
}

} // namespace cookbook::live
