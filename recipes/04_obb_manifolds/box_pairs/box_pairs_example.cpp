/// \file
/// \brief A hundred crates at different heights over a floor, all answered at once.

// [example]
#include "04_obb_manifolds/box_pairs/box_pairs.hpp"
#include <iostream>

int main()
{
  using namespace cookbook;
  const Matrix3<float> straight = Matrix3<float>::Identity();
  std::vector<std::pair<Obb<float>, Obb<float>>> pairs;
  for (int i = 0; i < 100; ++i)
  {
    const float height = 0.755f + 0.01f * float(i);
    pairs.push_back(
        {{{0, 0, 0}, straight, {5, 0.5f, 5}}, {{0, height, 0}, straight, {0.5f, 0.5f, 0.5f}}});
  }
  const BoxBlocks blocks = blocks_of(pairs); // structure of arrays, sixteen boxes side by side
  BoxManifolds manifolds;
  box_pairs(blocks.a, blocks.b, manifolds);
  const PairManifold first = face_manifold_at(manifolds, 0);
  std::cout << manifolds.face_count << " of 100 touch; pair " << first.pair << " is "
            << first.manifold.depth << " m deep, " << first.manifold.points.size() << " points\n";
}
// [example]
