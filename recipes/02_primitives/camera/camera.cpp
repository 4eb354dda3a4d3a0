/// \file
/// \brief Sends points of a scene to pixels and back, and counts what is drawn of many boxes.

#include "02_primitives/camera/camera.hpp"
#include "02_primitives/camera/trial/camera_cases.hpp"
#include "02_primitives/camera/trial/camera_figures.hpp"
#include "02_primitives/camera/trial/look_cases.hpp"
#include "02_primitives/camera/trial/view_truth.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>

namespace
{

using namespace cookbook;

/// Numbers in round brackets, to a thousandth.
template <int Size>
std::string tuple(const Vector<double, Size>& v)
{
  std::string text;
  for (const double x : v)
  {
    text += (text.empty() ? "(" : ", ") + number(std::round(x * 1000) / 1000);
  }
  return text + ")";
}

void print_pixels()
{
  const Camera<double> camera = scene_camera();
  Table table({"point", "pixel", "depth", "unprojected", "direction of the ray"});
  for (const Vector3<double>& point :
       {Vector3<double>(0, 0, 0), Vector3<double>(1, 0, 0), Vector3<double>(0, 1, 0),
        Vector3<double>(-3, 0, -1), Vector3<double>(0, 3, 5)})
  {
    const std::optional<PixelDepth<double>> seen = to_pixel(camera, point);
    if (!seen)
    {
      table.row({tuple<3>(point), "not ahead", "", "", ""});
      continue;
    }
    const Vector3<double> direction = picking_ray(camera, seen->pixel).direction;
    table.row(
        {tuple<3>(point), tuple<2>(seen->pixel), number(std::round(seen->depth * 1000) / 1000),
         tuple<3>(*unproject(camera, *seen)), tuple<3>(direction)});
  }
  std::cout << table.text() << '\n';
}

void print_boxes()
{
  Table table({"boxes up to", "of", "in view", "drawn by planes", "and corners"});
  for (const double largest : {2.0, 8.0, 32.0})
  {
    const DrawnBoxes drawn = drawn_boxes(20'000, largest);
    table.row(
        {number(largest) + " m", std::to_string(drawn.all), std::to_string(drawn.seen),
         std::to_string(drawn.by_planes), std::to_string(drawn.by_corners)});
  }
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "camera",
      .summary = "Sends points to pixels and back, and counts what is drawn of many boxes."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_pixels();
        print_boxes();
        save_figure(
            given, "camera_look.html",
            verdict_table(
                "Ways to turn a camera, in float: right means within 1e-6.",
                names_of(look_methods()), look_verdicts(), "look"));
        save_figure(
            given, "camera_depth.html",
            verdict_table(
                "Depths of two points in float, by a near plane at 0.1 m and a far plane at 100 "
                "km.",
                names_of(depth_methods()), depth_verdicts(), "depth"));
        save_figure(
            given, "camera_view.html",
            verdict_table(
                "Which boxes are drawn; the camera sees 1 to 10 m ahead.", view_method_names(),
                view_verdicts(), "view"));
        save_figure(given, "camera.svg", camera_figure().svg());
        save_figure(given, "camera_wall.svg", wall_figure().svg());
      });
}
