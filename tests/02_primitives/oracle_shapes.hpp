/// \file
/// What an oracle of answers knows of each kind of shape: corners, radius, sides, in long double.
#pragma once

#include "02_primitives/shapes/more_shapes.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace cookbook
{

/// What the oracle computes in.
using Long = long double;
/// Its points.
using Long3 = Vector3<Long>;

/// What the oracle knows of a shape.
struct OracleShape
{
  std::vector<Long3> corners;             ///< of its core
  Long radius = 0;                        ///< around the core
  std::vector<std::array<Long, 4>> sides; ///< unit outward normals and offsets of a box's faces
  bool is_plane = false;                  ///< one side only, without corners
};

template <class Real>
Long3 exactly(const Vector3<Real>& v)
{
  return v.template cast<Long>();
}

template <class Real>
OracleShape as_oracle(const Vector3<Real>& p)
{
  return {{exactly(p)}, 0, {}};
}
template <class Real>
OracleShape as_oracle(const Segment<Real>& s)
{
  return {{exactly(s.start), exactly(s.end)}, 0, {}};
}
template <class Real>
OracleShape as_oracle(const Plane<Real>& plane)
{
  const Long3 n = exactly(plane.normal);
  const Long length = n.norm();
  return {
      {},
      0,
      {{n.x() / length, n.y() / length, n.z() / length, Long(plane.distance) / length}},
      true};
}
template <class Real>
OracleShape as_oracle(const Sphere<Real>& s)
{
  return {{exactly(s.center)}, Long(s.radius), {}};
}
template <class Real>
OracleShape as_oracle(const Capsule<Real>& c)
{
  return {{exactly(c.segment.start), exactly(c.segment.end)}, Long(c.radius), {}};
}
template <class Real>
OracleShape as_oracle(const Obb<Real>& box)
{
  OracleShape shape;
  for (int i = 0; i < 8; ++i)
  {
    Long3 corner = exactly(box.center);
    for (int k = 0; k < 3; ++k)
    {
      const Long3 axis = box.axes.col(k).template cast<Long>();
      corner += (i >> k & 1 ? Long(1) : Long(-1)) * Long(box.half_extents[k]) * axis;
    }
    shape.corners.push_back(corner);
  }
  for (int k = 0; k < 6; ++k)
  {
    const Long side = k < 3 ? 1 : -1;
    const Long3 n = side * box.axes.col(k % 3).template cast<Long>();
    const Long offset = n.dot(exactly(box.center)) + Long(box.half_extents[k % 3]);
    shape.sides.push_back({n.x(), n.y(), n.z(), offset});
  }
  return shape;
}
template <class Real>
OracleShape as_oracle(const Aabb<Real>& box)
{
  OracleShape shape;
  for (int i = 0; i < 8; ++i)
  {
    const auto of = [&](int k) { return Long((i >> k & 1 ? box.max() : box.min())[k]); };
    shape.corners.push_back({of(0), of(1), of(2)});
  }
  for (int k = 0; k < 3; ++k)
  {
    std::array<Long, 4> up{}, down{};
    up[std::size_t(k)] = 1;
    up[3] = Long(box.max()[k]);
    down[std::size_t(k)] = -1;
    down[3] = -Long(box.min()[k]);
    shape.sides.push_back(up);
    shape.sides.push_back(down);
  }
  return shape;
}
template <class Real>
OracleShape as_oracle(const Triangle<Real>& t)
{
  return {{exactly(t.a), exactly(t.b), exactly(t.c)}, 0, {}};
}
template <class Real>
OracleShape as_oracle(const Tetrahedron<Real>& t)
{
  return {{exactly(t.a), exactly(t.b), exactly(t.c), exactly(t.d)}, 0, {}};
}

} // namespace cookbook
