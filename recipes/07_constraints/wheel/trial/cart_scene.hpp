#pragma once

/// \file
/// \brief A cart that stands on four wheels, not yet joined.

#include "06_world/contacts/scene.hpp"

namespace cookbook
{

// [cart_scene]
/// The ground, a cart of 100 kg, and four wheels of 5 kg and 30 cm below it, the rear two first.
inline Scene cart_scene()
{
  const auto dynamic = MotionType::dynamic;
  Scene scene{.bodies = {{"ground", PlaneShape{{0, 1, 0}, 0}}}};
  scene.bodies.push_back({"cart", BoxShape{{1, 0.2, 0.5}}, 100, dynamic, {0, 0.7, 0}});
  for (const double x : {-0.8, 0.8})
  {
    for (const double z : {-0.6, 0.6})
    {
      scene.bodies.push_back({"wheel", SphereShape{0.3}, 5, dynamic, {x, 0.3, z}});
    }
  }
  return scene;
}
// [cart_scene]

} // namespace cookbook
