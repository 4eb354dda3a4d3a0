/// \file
/// \brief Times rays and closest points on meshes of growing size, with and without a tree.

#include "02_primitives/mesh_chart/trial/mesh_chart.hpp"
#include "tools/measure/timing.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <functional>
#include <map>

namespace
{

using namespace cookbook;

using Methods = std::vector<measure::Timed>;

/// Adds a method that asks all triangles: for few inputs, and for meshes that are not too large.
template <class Input, class Call>
void add_slow(
    Methods& methods, const std::vector<Input>& inputs, const MeshWorkload& work, Call call)
{
  if (work.mesh.triangles.size() <= 10'000)
  {
    const std::vector<Input> few(inputs.begin(), inputs.begin() + 20);
    methods.push_back(measure::timed_over("without a tree", few, call));
  }
}

/// One chart: the methods' lines over the number of triangles.
class Curves
{
public:
  Curves(const std::string& name, const std::string& title, const std::string& what)
      : chart_(name, title, {"triangles", plot::Scale::log}, {what, plot::Scale::log})
  {
  }

  void measure(const MeshWorkload& work, const Methods& methods, const measure::Effort& effort)
  {
    const auto triangles = static_cast<double>(work.mesh.triangles.size());
    for (const measure::Timing& timing : measure::time_interleaved(methods, effort))
    {
      if (!lines_.contains(timing.name))
      {
        names_.push_back(timing.name);
      }
      if (std::isnan(timing.ns))
      {
        chart_.leave_out(timing.name + " of " + number(triangles), measure::time_text(timing.ns));
      }
      else
      {
        lines_[timing.name].emplace_back(triangles, timing.ns);
      }
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

void measure_asking(
    Curves& rays, Curves& points, const MeshWorkload& work, const measure::Effort& effort)
{
  using R = Ray<float>;
  using V = Vector3<float>;
  const TriangleMesh<float>& mesh = work.mesh;
  Methods of_rays, of_points;
  of_rays.push_back(measure::timed_over(
      "tree of boxes", work.rays, [&](const R& r) { return cast(r, mesh, work.tree); }));
  add_slow(of_rays, work.rays, work, [&](const R& r) { return cast_without_tree(r, mesh); });
  of_points.push_back(measure::timed_over(
      "tree of boxes", work.points,
      [&](const V& p) { return closest_point_of_mesh(mesh, work.tree, p); }));
  add_slow(of_points, work.points, work, [&](const V& p) { return closest_without_tree(mesh, p); });
#ifdef COOKBOOK_HAS_EMBREE
  const EmbreeMesh embree(mesh);
  of_rays.push_back(
      measure::timed_over("Embree", work.rays, [&](const R& r) { return embree.cast(r); }));
#endif
#ifdef COOKBOOK_HAS_BULLET
  const BulletMesh bullet(mesh);
  of_rays.push_back(
      measure::timed_over("Bullet", work.rays, [&](const R& r) { return bullet.cast(r); }));
#endif
#ifdef COOKBOOK_HAS_FCL
  const FclMesh fcl(mesh);
  of_rays.push_back(
      measure::timed_over("FCL", work.rays, [&](const R& r) { return fcl.is_met(r); }));
  of_points.push_back(
      measure::timed_over("FCL", work.points, [&](const V& p) { return fcl.distance(p); }));
#endif
#ifdef COOKBOOK_HAS_CGAL
  const CgalMesh cgal(mesh);
  of_rays.push_back(
      measure::timed_over("CGAL", work.rays, [&](const R& r) { return cgal.cast(r); }));
  of_points.push_back(
      measure::timed_over("CGAL", work.points, [&](const V& p) { return cgal.distance(p); }));
#endif
  rays.measure(work, of_rays, effort);
  points.measure(work, of_points, effort);
}

void measure_building(Curves& curves, const MeshWorkload& work, const measure::Effort& effort)
{
  Methods methods;
  const auto triangles = static_cast<double>(work.mesh.triangles.size());
  const auto add = [&](const std::string& name, const std::function<void()>& build) {
    methods.push_back({name, build, triangles});
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
#ifdef COOKBOOK_HAS_CGAL
  add("CGAL", [&work] { measure::keep(CgalMesh(work.mesh)); });
#endif
  curves.measure(work, methods, effort);
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
        const measure::Effort effort{quick ? 5 : 15, quick ? 0.001 : 0.01};
        Curves rays("rays", "A ray at a ball of triangles", "time of a ray [ns]");
        Curves points("points", "The closest point of it", "time of a point [ns]");
        Curves building("building", "Building the tree", "time of a triangle [ns]");
        const int least = 3, most = quick ? 6 : 8;
        Progress progress("meshes", static_cast<std::size_t>(most - least + 1));
        for (int times = least; times <= most; ++times)
        {
          progress.at(static_cast<std::size_t>(times - least));
          const MeshWorkload work = mesh_workload(times, 1000);
          measure_asking(rays, points, work, effort);
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
