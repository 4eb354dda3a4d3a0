#pragma once

/// \file
/// \brief Pairs of boxes that are small, large, far away, thin or flush, with the right answers.

#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "common/math/rotation.hpp"

#include <string>
#include <vector>

namespace cookbook
{

// [size_cases]
/// A small cube flush on a larger one, turned by the angle of a 3-4-5 triangle about the height:
/// each pair of edges that cross in the common plane ties with the faces.
inline BoxCase flush_case(double size)
{
  const Matrix3<double> turn = rational_rotation<double>(2, 0, 1, 0);
  const Obb<double> a = upright({0, 0, 0}, Vector3<double>(size, size, size));
  const Obb<double> b{size * Vector3<double>(0.2, 1.4, 0.1), turn, 0.5 * a.half_extents};
  BoxCase pair{"G11", "a cube flush on a larger one, turned", a, b, 0.1 * size, {0, 1, 0}, {}};
  for (const Vector3<double>& corner : rectangle(0.5, -0.45, 0.5))
  {
    pair.contacts.push_back(b.center + size * (turn * corner));
  }
  pair.tolerance *= size;
  return pair;
}

/// Cubes one on the other, 0.01 deep, at a distance [m] from the origin, in float.
inline BoxCase far_case(double distance, BoxNumbers numbers)
{
  const Vector3<double> place(distance, distance, distance), half(0.5, 0.5, 0.5);
  const std::string how = numbers == BoxNumbers::in_float ? ", float" : ", float seen from A";
  const std::string km = std::to_string(static_cast<int>(distance / 1000));
  BoxCase pair{
      "G13-" + km + (numbers == BoxNumbers::in_float ? "-b" : "-A-b"),
      "cubes " + km + " km away" + how,
      upright(place, half),
      upright(place + Vector3<double>(0, 0.99, 0), half),
      0.01,
      {0, 1, 0},
      {}};
  for (const Vector3<double>& corner : rectangle(0.5, 0.495, 0.5))
  {
    pair.contacts.push_back(place + corner);
  }
  pair.numbers = numbers;
  return pair;
}

/// Cases of size, place and proportion; an id that ends in b is a neighbour of the case above.
inline std::vector<BoxCase> size_cases()
{
  std::vector<BoxCase> cases{flush_case(1), flush_case(1e-3), flush_case(1e3)};
  cases[1].id = "G12";
  cases[1].scene = "the same, a thousand times smaller";
  cases[2].id = "G12-b";
  cases[2].scene = "the same, a thousand times larger";
  for (const double distance : {1e4, 1e5, 1e6})
  {
    cases.push_back(far_case(distance, BoxNumbers::in_float));
    cases.push_back(far_case(distance, BoxNumbers::in_float_from_a));
  }
  cases[3].id = "G13";
  Matrix3<double> turn;
  turn << 0.10758262492983036718, -0.6624881850015212903, -0.74130653817877356637,
      0.22682184885125472595, -0.709614040775253474, 0.6670830248314786326, //
      -0.96797615037608542021, -0.23991106241273435495, 0.07392465377049164954;
  cases.push_back(
      {"G14",
       "a handle in the edge of a thin board",
       upright({-0.721, -0.772, 0.81}, {0.23, 0.24, 0.005}),
       {{-0.42677133002999478872, -0.76596851247746788882, 0.80746731400091054098},
        turn,
        {0.0247605, 0.073, 0.03625}},
       0.0134086,
       {0, 0, 0},
       {}});
  return cases;
}
// [size_cases]

} // namespace cookbook
