/// \file
/// \brief How deep is a stone in a slab? Only the support functions of the two are needed.

// [example]
#include "04_obb_manifolds/gjk_epa/epa.hpp"
#include <iostream>

int main()
{
  using namespace cookbook;
  const Vector3<double> slab(2, 0.5, 2); // half extents
  const Vector3<double> stone[] = {{0, 0.4, 0}, {1, 1.4, 0}, {-1, 1.2, 0}, {0, 1, 1}, {0, 1, -1}};
  const auto support = [&](const Vector3<double>& d) -> SupportPoint<double>
  {
    const auto farther = [&](const auto& p, const auto& q) { return p.dot(-d) < q.dot(-d); };
    const Vector3<double> on_a = support_corner(d, slab);
    return {on_a - *std::max_element(stone, stone + 5, farther), on_a};
  };
  const GjkAnswer<double> gjk_says = gjk<double>(support, {1, 0, 0}, 1e-12);
  const Expansion<double> epa_says = epa(support, gjk_says.simplex, 1e-12);
  std::cout << (gjk_says.apart ? "apart" : "overlap") << ", depth " << epa_says.depth << "\nnormal "
            << epa_says.normal.transpose() << "\n";
}
// [example]
