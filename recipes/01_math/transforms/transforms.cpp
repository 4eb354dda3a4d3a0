/// \file
/// \brief Carries points, vectors, normals and planes through transforms, and back.

#include "01_math/transforms/transforms.hpp"
#include "01_math/transforms/trial/transforms_figures.hpp"
#include "01_math/transforms/trial/transforms_verdicts.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

std::string triple(const Vector3<double>& v)
{
  return '(' + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + ")";
}

void print_transforms()
{
  Affine3<double> t = Affine3<double>::Identity();
  t.translation() = Vector3<double>(5, 0, 0);
  t.linear() = Vector3<double>(1, 1, 4).asDiagonal();
  const Vector3<double> v(1, 2, 2);
  const Hyperplane3<double> plane(v / 3, -2);
  const Hyperplane3<double> carried = transformed_plane<double>(t, plane);
  const Vector3<double> by_matrix = (t.linear() * plane.normal()).normalized();
  Table table({"what", "before", "after"});
  table.row({"point", triple(v), triple(t * v)});
  table.row({"vector", triple(v), triple(t.linear() * v)});
  table.row({"normal", triple(plane.normal()), triple(carried.normal())});
  table.row({"normal by M, wrong", triple(plane.normal()), triple(by_matrix)});
  table.row({"plane's distance", number(-plane.offset()), number(-carried.offset())});
  table.row({"point, and back", triple(v), triple(*to_local<double>(t, t * v))});
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "transforms",
      .summary = "Carries points, vectors, normals and planes through transforms, and back."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_transforms();
        save_figure(
            given, "transforms_planes.html",
            verdict_table(
                "Ways to carry the plane 2x + y + 2z = 6 through a transform, in float.",
                plane_names(), plane_verdicts()));
        save_figure(
            given, "transforms_local.html",
            verdict_table(
                "Ways to see a point of the world in a body's frame, in float: right means "
                "within 1e-4.",
                local_names(), local_verdicts(), "local"));
        save_figure(given, "transforms.svg", normal_figures().svg());
        save_figure(given, "transforms_order.svg", order_figures().svg());
        save_figure(given, "transforms_pose.svg", pose_figure().svg());
      });
}
