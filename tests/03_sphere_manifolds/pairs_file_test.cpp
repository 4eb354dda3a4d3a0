/// \file
/// What holds for files of pairs: shapes from rows, manifolds as rows, errors by line and column.

#include "03_sphere_manifolds/manifold/trial/pairs_file.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"

#include "tests/catch.hpp"
#include "tests/tools/run_program.hpp"

#include <fstream>

#include <unistd.h>

using namespace cookbook;

namespace
{

/// Runs a program that prints the spheres' sum of radii as a manifold's depth, on a file.
Run run_on_file(const std::string& text)
{
  const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                     ("cookbook_pairs_" + std::to_string(getpid()) + ".csv");
  std::ofstream(path) << text;
  const auto body = [](const Arguments& given)
  {
    print_pairs(
        given,
        [](const PairsRow& row, auto real)
        {
          using Real = decltype(real);
          const Real depth = sphere_at<Real>(row, 0).radius + sphere_at<Real>(row, 4).radius;
          const ContactPoint<Real> point{{1, 2, 3}, depth, 0};
          return depth > 5 ? std::nullopt
                           : std::optional(
                                 Manifold<Real>{{0, 1, 0}, depth, ContactPoints<Real, 8>(point)});
        });
  };
  const Run result = run({"demo", "--pairs", path.string()}, body);
  std::filesystem::remove(path);
  return result;
}

const std::string spheres = "ax,ay,az,ar,bx,by,bz,br\n";

} // namespace

TEST_CASE("manifolds are printed with as many points as any of them has", "[pairs]")
{
  const Run result = run_on_file(spheres + "0,0,0,1,0,0,0,0.5\n0,0,0,9,0,0,0,1\n");
  CHECK(result.status == 0);
  CHECK(
      result.out == "pair,hit,depth,nx,ny,nz,count,p0x,p0y,p0z,p0depth\n"
                    "0,1,1.5,0,1,0,1,1,2,3,1.5\n"
                    "1,0,,,,,0,,,,\n");
}

TEST_CASE("a wrong shape is named by file, line and column, and nothing is printed", "[pairs]")
{
  const Run result = run_on_file(spheres + "0,0,0,1,0,0,0,1\n0,0,0,1,0,0,0,-2\n");
  CHECK(result.status == 1);
  CHECK(result.out.empty());
  CHECK(result.err.find(".csv:3:8: br: radius must be zero or more, got -2") != std::string::npos);
}

TEST_CASE(
    "a manifold that does not fit the number type is named by its row, and none printed", "[pairs]")
{
  const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                     ("cookbook_huge_" + std::to_string(getpid()) + ".csv");
  std::ofstream(path) << spheres << "0,0,0,1,0,0,0,1\n0,0,0,3e38,1,0,0,3e38\n";
  const auto printed = [&](const std::string& scalar)
  {
    return run(
        {"demo", "--pairs", path.string(), "--scalar", scalar},
        [](const Arguments& given)
        {
          print_pairs(
              given,
              [](const PairsRow& row, auto zero)
              {
                using Real = decltype(zero);
                return sphere_sphere(sphere_at<Real>(row, 0), sphere_at<Real>(row, 4));
              });
        });
  };
  const Run in_float = printed("float"), in_double = printed("double");
  std::filesystem::remove(path);
  CHECK(in_float.status == 1);
  CHECK(in_float.out.empty());
  CHECK(
      in_float.err.find(".csv:3:1: the manifold is too large for the number type") !=
      std::string::npos);
  CHECK(in_double.status == 0);
  CHECK(in_double.out.find("inf") == std::string::npos);
}

TEST_CASE("a number that does not fit the number type is named", "[pairs]")
{
  const auto sphere = [](double x) {
    return sphere_at<float>({"balls.csv", "x,y,z,r", {2, {x, 0, 0, 1}}}, 0).center.x();
  };
  CHECK(sphere(0.1) == 0.1f);
  CHECK_THROWS_WITH(sphere(1e300), "balls.csv:2:1: x: 1e+300 is too large for the number type");
  CHECK_THROWS_WITH(sphere(-1e-300), "balls.csv:2:1: x: -1e-300 is too small for the number type");
}

TEST_CASE("a box's quaternion may be rounded, but not of another length", "[pairs]")
{
  const std::string header = "x,y,z,w,qx,qy,qz,hx,hy,hz";
  const auto box = [&](std::vector<double> values) {
    return obb_at<double>({"boxes.csv", header, {2, std::move(values)}}, 0);
  };
  CHECK(box({1, 2, 3, 0.7071, 0, 0, 0.7071, 1, 1, 1}).axes.isUnitary(1e-12));
  CHECK_THROWS_WITH(
      box({1, 2, 3, 2, 0, 0, 0, 1, 1, 1}),
      "boxes.csv:2:4: w: the quaternion must have length 1, got 2");
  CHECK_THROWS_WITH(
      box({1, 2, 3, 1, 0, 0, 0, 1, 0, 1}),
      "boxes.csv:2:9: hy: half_extents.y must be greater than zero, got 0");
}
