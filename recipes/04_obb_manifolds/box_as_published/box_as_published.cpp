/// \file
/// \brief What the published code says of ten pairs of boxes, one for each mistake, and what is
/// right.

#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>
#include <set>

namespace
{

using namespace cookbook;

/// A mistake, and a pair of boxes at which it shows.
struct Mistake
{
  std::string id, what, scene;
  Obb<double> a, b;
  std::string shows; ///< in which part of the answer
};

std::vector<Mistake> mistakes()
{
  const Vector3<double> one(1, 1, 1);
  const Obb<double> cube = upright({0, 0, 0}, one), large = upright({0, 0, 0}, {10, 10, 10}),
                    plate = upright({0, 0, 0}, {5, 0.1, 5}), sunk = upright({0, 0.5, 0}, one);
  const double eighth = std::atan(1.0);
  const Obb<double> edge{{2.25, 2.25, 0}, turned(eighth, {-1, 1, 0}), one};
  const Matrix3<double> slope = turned(eighth * 2 / 3, {0, 0, 1});
  const Obb<double> ground{{0, 0, 0}, slope, {2, 0.5, 1}},
      rests{slope * Vector3<double>(0.3, 0.85, 0), slope, {0.5, 0.5, 0.5}};
  const Matrix3<double> ridge = turned(eighth, {1, 0, 0}), yaw = turned(eighth / 30, {0, 1, 0}),
                        anyhow = rational_rotation<double>(1, 2, 3, 3);
  const Obb<double> bar = placed({{0, 0, 0}, ridge, {10, 1, 1}}, anyhow),
                    other = placed({{0, 2.8385, 0}, yaw * ridge, {10, 1, 1}}, anyhow),
                    small = upright({0, 0, 0}, {0.004, 0.004, 0.004});
  return {
      {"X08", "A's axes crossed with A's", "cubes edge to edge, 0.05 apart", cube, edge, "hit"},
      {"X09", "negative components erased", "a cube on a slope of 30°", ground, rests, "normal"},
      {"", "", "the same", ground, rests, "depth"},
      {"X10", "A compared with A", "cubes 100 m apart", cube, upright({60, 0, 80}, one), "yes"},
      {"X11", "depth by union", "a cube sunk through a plate", plate, sunk, "depth"},
      {"X12", "turned by the beginnings", "the same", plate, sunk, "normal"},
      {"X13", "depth 0 dropped", "cubes that touch", cube, upright({0, 2, 0}, one), "hit"},
      {"X14", "axes below 1.8° dropped", "bars crossed at 1.5°, 0.01 apart", bar, other, "hit"},
      {"X15", "points without tolerance", "a box inside another", large,
       upright({9.8, 0, 0}, {0.1, 0.1, 0.1}), "points"},
      {"X16", "1 cm apart is one point", "cubes of 8 mm, 4 points", small,
       upright({0, 0.0076, 0}, small.half_extents), "points"},
      {"X17", "features forgotten", "cubes, one on the other", cube, upright({0.3, 1.9, 0.2}, one),
       "features"}};
}

/// The part of an answer in which a mistake shows.
template <class Answer>
std::string told(const Mistake& mistake, const Answer& answer)
{
  const auto rounded = [](double x) { return number(std::round(100 * x) / 100 + 0.0); };
  if (mistake.shows == "hit" || !answer)
  {
    return answer ? "overlap" : "apart";
  }
  if (mistake.shows == "depth")
  {
    return rounded(answer->depth) + " deep";
  }
  if (mistake.shows == "normal")
  {
    const Vector3<double>& n = answer->normal;
    return "(" + rounded(n.x()) + ", " + rounded(n.y()) + ", " + rounded(n.z()) + ")";
  }
  std::set<std::uint32_t> features;
  for (const auto& point : answer->points)
  {
    features.insert(point.feature);
  }
  const bool points = mistake.shows == "points";
  return mistake.shows + ": " + std::to_string(points ? answer->points.size() : features.size());
}

void print()
{
  Table table({"case", "mistake", "boxes", "published", "right"});
  for (const Mistake& mistake : mistakes())
  {
    const auto& [id, what, scene, a, b, shows] = mistake;
    const std::string published = shows == "yes"
                                      ? (overlap_as_published(a, b) ? "overlap" : "apart")
                                      : told(mistake, box_as_published(a, b));
    table.row({id, what, scene, published, told(mistake, box_box(a, b))});
  }
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  return run_pairs_program(
      argc, argv,
      {.name = "box_as_published",
       .summary = "What the published code makes of two boxes, mistake by mistake.",
       .pairs_header = box_pairs_header},
      of_box_rows([](const auto& a, const auto& b) { return box_as_published(a, b); }),
      [](const Arguments&) { print(); });
}
