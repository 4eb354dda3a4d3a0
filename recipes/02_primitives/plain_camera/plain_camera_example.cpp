/// \file
/// \brief A pixel, and what is culled.

// [example]
#include "02_primitives/camera/camera.hpp"
#include "02_primitives/plain_camera/plain_camera.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  const Camera<double> camera{
      look_at<double>({0, 3, 4}, {0, 0, 0}, {0, 1, 0}),
      perspective<double>(1.5708, 1.5, 1, 100).value(),
      {600, 400}};
  const Matrix4<double> matrix = clip_from_world(camera);
  const Frustum<double> view = frustum_planes<double>(matrix, DepthRange::minus_one_to_one);
  const Vector2<double> pixel = pixel_of<double>(matrix, camera.size, {1, 0, 0}).value();
  std::cout << "(1, 0, 0) is at pixel " << pixel.transpose() << '\n'
            << "ball at the origin culled: " << is_culled(view, Sphere<double>{{0, 0, 0}, 1})
            << '\n'
            << "ball behind culled: " << is_culled(view, Sphere<double>{{0, 6, 8}, 1}) << '\n';
}
// [example]
