/// \file
/// \brief Times rays and closest points on meshes of growing size, with and without a tree.

#include "02_primitives/mesh_chart/trial/mesh_chart.hpp"
#include "common/measure/timing.hpp"
#include "common/plot/charts/chart.hpp"
#include "common/program/program.hpp"

#include <functional>
#include <map>
#include <memory>

namespace
{

using namespace cookbook;

/// Methods that answer once for each of a workload's rays or points.
struct Methods
{
  std::vector<measure::Timed> timed;

  template <class Input, class Method>
  void add(const std::string& name, const std::vector<Input>& inputs, Method method)
  {
    const auto run = [inputs, method]
    {
      for (const Input& input : inputs)
      {
        measure::keep(method(input));
      }
    };
    timed.push_back({name, run, static_cast<double>(inputs.size())});
  }

  /// The same for a method that asks all triangles: for few inputs, and not too many triangles.
  template <class Input, class Method>
  void add_slow(
      const std::string& name, const std::vector<Input>& inputs, std::size_t triangles,
      Method method)
  {
    if (triangles <= 10'000)
    {
      add(name, std::vector<Input>(inputs.begin(), inputs.begin() + 20), method);
    }
  }
};

/// One chart: the methods' lines over the number of triangles.
class Curves
{
public:
  Curves(const std::string& name, const std::string& title, const std::string& what)
      : chart_(name, title, {"triangles", plot::Scale::log}, {what, plot::Scale::log})
  {
  }

  void measure(double triangles, const Methods& methods, const measure::Effort& effort)
  {
    for (const measure::Timing& timing : measure::time_interleaved(methods.timed, effort))
    {
      if (!lines_.contains(timing.name))
      {
        names_.push_back(timing.name);
      }
      lines_[timing.name].emplace_back(triangles, timing.ns);
    }
  }

  plot::Chart& drawn()
  {
    for (const std::string& name : names_)
    {
      chart_.line(name, lines_[name]);
    }
    return chart_.size(420, 320);
  }

private:
  plot::Chart chart_;
  std::vector<std::string> names_; ///< in the order in which they came
  std::map<std::string, std::vector<Eigen::Vector2d>> lines_;
};

void measure_rays(Curves& curves, const MeshWorkload& work, const measure::Effort& effort)
{
  using R = Ray<float>;
  const TriangleMesh<float>& mesh = work.mesh;
  Methods methods;
  methods.add("tree of boxes", work.rays, [&](const R& r) { return cast(r, mesh, work.tree); });
  methods.add_slow(
      "without a tree", work.rays, mesh.triangles.size(),
      [&](const R& r) { return cast_without_tree(r, mesh); });
#ifdef COOKBOOK_HAS_EMBREE
  const auto embree = std::make_shared<EmbreeMesh>(mesh);
  methods.add("Embree", work.rays, [embree](const R& r) { return embree->cast(r); });
#endif
#ifdef COOKBOOK_HAS_BULLET
  const auto bullet = std::make_shared<BulletMesh>(mesh);
  methods.add("Bullet", work.rays, [bullet](const R& r) { return bullet->cast(r); });
#endif
#ifdef COOKBOOK_HAS_FCL
  const auto fcl = std::make_shared<FclMesh>(mesh);
  methods.add("FCL", work.rays, [fcl](const R& r) { return fcl->is_met(r); });
#endif
  curves.measure(static_cast<double>(mesh.triangles.size()), methods, effort);
}

void measure_points(Curves& curves, const MeshWorkload& work, const measure::Effort& effort)
{
  using V = Vector3<float>;
  const TriangleMesh<float>& mesh = work.mesh;
  Methods methods;
  methods.add(
      "tree of boxes", work.points,
      [&](const V& p) { return closest_point_of_mesh(mesh, work.tree, p); });
  methods.add_slow(
      "without a tree", work.points, mesh.triangles.size(),
      [&](const V& p) { return closest_without_tree(mesh, p); });
#ifdef COOKBOOK_HAS_FCL
  const auto fcl = std::make_shared<FclMesh>(mesh);
  methods.add("FCL", work.points, [fcl](const V& p) { return fcl->distance(p); });
#endif
  curves.measure(static_cast<double>(mesh.triangles.size()), methods, effort);
}

void measure_building(Curves& curves, const MeshWorkload& work, const measure::Effort& effort)
{
  Methods methods;
  const auto triangles = static_cast<double>(work.mesh.triangles.size());
  const auto add = [&](const std::string& name, const std::function<void()>& build) {
    methods.timed.push_back({name, build, triangles});
  };
  add("tree of boxes", [&work] { measure::keep(build_volumes(work.mesh)); });
  add("refitted", [&work] { measure::keep(refitted(work.tree, work.mesh)); });
#ifdef COOKBOOK_HAS_EMBREE
  add("Embree", [&work] { measure::keep(EmbreeMesh(work.mesh)); });
#endif
#ifdef COOKBOOK_HAS_BULLET
  add("Bullet", [&work] { measure::keep(BulletMesh(work.mesh)); });
#endif
#ifdef COOKBOOK_HAS_FCL
  add("FCL", [&work] { measure::keep(FclMesh(work.mesh)); });
#endif
  curves.measure(triangles, methods, effort);
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "mesh_chart",
      .summary = "Times rays, closest points and building over the number of triangles.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const bool quick = given.value("effort") == "quick";
        const measure::Effort effort{quick ? 3 : 7, quick ? 0.001 : 0.02};
        Curves rays("rays", "A ray at a ball of triangles", "time of a ray [ns]");
        Curves points("points", "The closest point of it", "time of a point [ns]");
        Curves building("building", "Building the tree", "time of a triangle [ns]");
        const int least = 3, most = quick ? 6 : 8;
        Progress progress("meshes", static_cast<std::size_t>(most - least + 1));
        for (int times = least; times <= most; ++times)
        {
          progress.at(static_cast<std::size_t>(times - least));
          const MeshWorkload work = mesh_workload(times, 1000);
          measure_rays(rays, work, effort);
          measure_points(points, work, effort);
          measure_building(building, work, effort);
        }
        plot::Grid grid("mesh_chart", "", 1);
        grid.describe("Cost over the size of a mesh; " + measure::machine_line())
            .add(rays.drawn())
            .add(points.drawn())
            .add(building.drawn().note(measure::machine_line()).size(420, 380));
        save_figure(given, "mesh_chart.svg", grid.svg());
      });
}
