/// \file
/// \brief A pendulum of 1 m, let go level: a point on a rod.

// [example]
#include "07_constraints/first_joint/first_joint.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  PhasePoint<Vector3<double>> point{{1, 0, 0}, {0, 0, 0}}; // position and velocity
  for (int frame = 0; frame <= 75; ++frame)
  {
    const Vector3<double>& p = point.position;
    if (frame % 15 == 0)
      std::printf("%.2f s: %5.2f, %5.2f m; rod %.5f m\n", frame / 60.0, p.x(), p.y(), p.norm());
    point = rod_step<double>(point, {1}, {0, -9.81, 0}, 1.0 / 60);
  }
}
// [example]
