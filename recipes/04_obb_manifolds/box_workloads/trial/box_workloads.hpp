#pragma once

/// \file
/// \brief Ten sets of pairs of boxes by name, shared by tests, charts and the reader's own trials.

#include "04_obb_manifolds/box_workloads/trial/random_box_pairs.hpp"
#include "tools/files/csv.hpp"

#include <string>
#include <vector>

namespace cookbook
{

// [workloads]
/// How the pairs of a workload are drawn, in metres about the origin, and then scaled and moved.
struct BoxRecipe
{
  std::string name;                  ///< as a reader asks for it
  std::string what;                  ///< in a few words
  BoxPair<double> (*draw)(BoxDraw&); ///< one pair
  double scale = 1;                  ///< [1], of all lengths
  double away = 0;                   ///< [m], of the pair from the origin, in any direction
};

/// Pairs of boxes that have something in common.
struct BoxWorkload
{
  std::string name;
  std::vector<BoxPair<float>> pairs;
};

/// The ten workloads of this chapter.
inline std::vector<BoxRecipe> box_workload_recipes()
{
  const auto random = [](BoxDraw& draw) { return anywhere(draw, random_boxes(draw, 1.6)); };
  const auto resting = [](BoxDraw& draw) { return resting_boxes(draw, 1, 0.01); };
  const auto deep = [](BoxDraw& draw) { return anywhere(draw, random_boxes(draw, 0.1)); };
  const auto thin = [](BoxDraw& draw) { return resting_boxes(draw, 0.02, 0.005); };
  return {
      {"random", "turned anyhow, sizes within a factor of 4, just over half overlap", random},
      {"near-parallel", "axes the same but for a turn of 1.5e-8 to 1.6e-2 rad",
       near_parallel_boxes},
      {"resting", "face on face, any yaw, tilt to 1e-4 rad, sunk by 0.1 to 1 %", resting},
      {"edge-edge", "an edge across an edge, sunk by 0.1 to 1 %", crossed_edges},
      {"deep", "random with centres up to 0.1 m apart along each axis", deep},
      {"thin plates", "resting, 50 to 100 times as long as high, sunk by 0.1 to 0.5 %", thin},
      {"millimetres", "random, a thousandth of the size", random, 1e-3},
      {"kilometres", "random, a thousand times the size", random, 1e3},
      {"far", "random, 1e5 m from the origin", random, 1, 1e5},
      {"degenerate", "in one place, touching, contained, parallel, flush, needles",
       degenerate_boxes}};
}
// [workloads]

// [workload]
/// The floats closest to a box's numbers.
///
/// Never inlined: where g++ 12 at -O3 sees a double rounded to float and widened again in one
/// vectorised piece, it drops the rounding.
[[gnu::noinline]] inline Obb<float> to_float(const Obb<double>& box)
{
  return {box.center.cast<float>(), box.axes.cast<float>(), box.half_extents.cast<float>()};
}

/// The first `count` pairs of a workload, the same on every machine; more begin with the same.
inline BoxWorkload box_workload(const BoxRecipe& recipe, std::size_t count)
{
  BoxDraw draw(4);
  BoxWorkload workload{recipe.name, {}};
  workload.pairs.reserve(count);
  while (workload.pairs.size() < count)
  {
    const BoxPair<double> pair = recipe.draw(draw);
    const Vector3<double> offset = recipe.away == 0
                                       ? Vector3<double>(0, 0, 0)
                                       : Vector3<double>(recipe.away * draw.direction());
    const auto finished = [&](const Obb<double>& box)
    {
      return to_float(
          {recipe.scale * box.center + offset, box.axes, recipe.scale * box.half_extents});
    };
    workload.pairs.push_back({finished(pair.first), finished(pair.second)});
  }
  return workload;
}
// [workload]

/// The names of all workloads.
inline std::vector<std::string> box_workload_names()
{
  std::vector<std::string> names;
  for (const BoxRecipe& recipe : box_workload_recipes())
  {
    names.push_back(recipe.name);
  }
  return names;
}

/// The workload of that name; std::out_of_range if there is none.
inline BoxWorkload box_workload(const std::string& name, std::size_t count)
{
  for (const BoxRecipe& recipe : box_workload_recipes())
  {
    if (recipe.name == name)
    {
      return box_workload(recipe, count);
    }
  }
  throw std::out_of_range("no workload is called " + name);
}

/// The columns of a file of pairs of boxes: centre, quaternion and half extents of each.
inline const char* const box_pairs_header =
    "ax,ay,az,aqw,aqx,aqy,aqz,ahx,ahy,ahz,bx,by,bz,bqw,bqx,bqy,bqz,bhx,bhy,bhz";

/// Pairs as a program's --pairs reads them; axes come back to within a rounding or two of float.
inline std::string box_pairs_csv(const std::vector<BoxPair<float>>& pairs)
{
  std::string text = std::string(box_pairs_header) + "\n";
  const auto add = [&text](const auto& value)
  { text.append(text.back() == '\n' ? "" : ",").append(round_trip(value)); };
  const auto add_box = [&add](const Obb<float>& box)
  {
    const Quaternion<double> q = Quaternion<double>(box.axes.cast<double>().eval()).normalized();
    add(box.center.x()), add(box.center.y()), add(box.center.z());
    add(q.w()), add(q.x()), add(q.y()), add(q.z());
    add(box.half_extents.x()), add(box.half_extents.y()), add(box.half_extents.z());
  };
  for (const auto& [a, b] : pairs)
  {
    add_box(a);
    add_box(b);
    text += "\n";
  }
  return text;
}

} // namespace cookbook
