/// \file
/// \brief Answers a row of pairs at once and one by one, and draws them as the lanes of a register.

#include "03_sphere_manifolds/sphere_pairs/sphere_pairs.hpp"
#include "03_sphere_manifolds/manifold/trial/pairs_file.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;
using Pair = std::pair<Sphere<float>, Sphere<float>>;

/// Unit spheres closer and closer, turning round each other; the last two coincide.
std::vector<Pair> scene()
{
  const std::vector<Vector3<float>> steps{{2.5f, 0, 0}, {0, 2, 0},      {1.2f, 1.6f, 0},
                                          {1.5f, 0, 0}, {0, -1.25f, 0}, {-0.6f, 0.8f, 0},
                                          {0.5f, 0, 0}, {0, 0, 0}};
  std::vector<Pair> pairs;
  for (const Vector3<float>& step : steps)
  {
    pairs.push_back({{{0, 0, 0}, 1}, {step, 1}});
  }
  return pairs;
}

/// The batch's answers, as the manifolds that one by one gives.
std::vector<std::optional<Manifold<float>>> manifolds_of(const std::vector<Pair>& pairs)
{
  const Lists in = lists_of_pairs(pairs);
  Lists out = lists_of_overlaps(pairs.size());
  sphere_pairs(pairs_of(in), overlaps_of(out));
  std::vector<std::optional<Manifold<float>>> manifolds;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    manifolds.push_back(overlap_manifold<float>(
        {{out[0][i], out[1][i], out[2][i]}, out[3][i], {out[4][i], out[5][i], out[6][i]}},
        Vector3<float>::Zero()));
  }
  return manifolds;
}

void print_scene()
{
  const std::vector<Pair> pairs = scene();
  const auto at_once = manifolds_of(pairs);
  Table table({"pair", "depth", "normal x", "normal y", "one by one"});
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const auto alone = sphere_sphere(pairs[i].first, pairs[i].second);
    const bool same = at_once[i] ? alone && alone->depth == at_once[i]->depth &&
                                       alone->normal == at_once[i]->normal
                                 : !alone;
    const auto& m = at_once[i];
    table.row(
        {std::to_string(i), m ? number(m->depth) : "apart", m ? number(m->normal.x()) : "",
         m ? number(m->normal.y()) : "", same ? "the same" : "differs"});
  }
  std::cout << table.text();
}

void draw(const Arguments& arguments)
{
  plot::Figure2d figure("sphere_pairs", "", {{-1.7, -8.4}, {15.2, 2.2}, 400});
  figure.describe("Eight pairs of spheres, each in a lane, each with its normal.");
  const std::vector<Pair> pairs = scene();
  const auto manifolds = manifolds_of(pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const Eigen::Vector2d lane(4.5 * static_cast<double>(i % 4), i < 4 ? 0.0 : -5.5);
    const auto at = [&](const Vector3<float>& v) -> Eigen::Vector2d
    { return lane + Eigen::Vector2d(v.x() / 1.5, v.y() / 1.5); };
    const auto& [a, b] = pairs[i];
    figure.circle(at(a.center), a.radius / 1.5, plot::Ink::a)
        .circle(at(b.center), b.radius / 1.5, plot::Ink::b)
        .label(lane + Eigen::Vector2d(0, -2.3), "lane " + std::to_string(i), plot::Side::centre);
    if (manifolds[i])
    {
      const Vector3<float> contact = manifolds[i]->points[0].position;
      figure.lens(at(a.center), a.radius / 1.5, at(b.center), b.radius / 1.5)
          .arrow(at(contact), at(contact + 1.2f * manifolds[i]->normal))
          .point(at(contact));
    }
  }
  save_figure(arguments, "sphere_pairs.svg", figure.svg());
}

void print_file(const Arguments& arguments)
{
  std::vector<Pair> pairs;
  for (CsvRow& row : read_csv(arguments.pairs, arguments.pairs_header))
  {
    const PairsRow where{arguments.pairs.string(), arguments.pairs_header, std::move(row)};
    pairs.push_back({sphere_at<float>(where, 0), sphere_at<float>(where, 4)});
  }
  std::cout << manifolds_csv(manifolds_of(pairs));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "sphere_pairs",
      .summary = "Many pairs of spheres at once, in float.",
      .pairs_header = "ax,ay,az,ar,bx,by,bz,br"};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        if (!given.pairs.empty())
        {
          return print_file(given);
        }
        print_scene();
        draw(given);
      });
}
