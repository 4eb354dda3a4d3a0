/// \file
/// That what is timed gives the same answer.

#include "07_constraints/articulated/trial/articulated_scenes.hpp"
#include "07_constraints/articulated_chart/trial/articulated_chart.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

// [composite_test]
TEST_CASE("a mass matrix of composite bodies gives the accelerations of articulated ones to 1e-11")
{
  NumberDraw<double> draw(9);
  for (int i = 0; i < 300; ++i)
  {
    std::vector<Link> links = drawn_links(draw, 1 + i % 12);
    for (Link& link : links)
    {
      link.stiffness = link.damping = 0;
    }
    const TreeState state = drawn_state(draw, links);
    const Eigen::VectorXd faster = ArticulatedBody(links).accelerations(state);
    if (faster.size() > 0)
    {
      const Eigen::VectorXd other = CompositeBodies(links).accelerations(state);
      REQUIRE((faster - other).norm() <= 1e-11 * other.norm());
    }
  }
}
// [composite_test]
