#pragma once

/// \file
/// \brief Random boxes, and pairs of them in a certain position: the same on every machine.

#include "02_primitives/shapes/trial/number_draw.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_pair.hpp"
#include "common/math/norm.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

namespace cookbook
{

// [box_draw]
/// The rotation of the quaternion w + xi + yj + zk, which need not have length one; M16.
inline Matrix3<double> quaternion_rotation(double w, const Vector3<double>& v)
{
  const double x = v.x(), y = v.y(), z = v.z();
  Matrix3<double> numerator;
  numerator << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x), //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return numerator / (w * w + x * x + y * y + z * z);
}

/// Random numbers and shapes made of +, −, ×, ÷ and √, which every machine rounds alike.
class BoxDraw : public NumberDraw<double>
{
public:
  using NumberDraw::NumberDraw;

  /// A whole number from 0 to `count` − 1.
  int whole(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }

  /// A number between `low` and twice `low` times a power of two, up to the `octaves`-th.
  double octaves(double low, int octaves)
  {
    const double number = between(low, 2 * low);
    return std::ldexp(number, whole(octaves));
  }

  /// One side or the other: −1 or 1.
  double side() { return whole(2) == 0 ? -1 : 1; }

  /// Three numbers from `low` to `high`.
  Vector3<double> vector(double low, double high) { return in_box(low, high); }

  /// A unit vector.
  Vector3<double> direction() { return normalize(vector(-1, 1)).unit; }

  /// A turn by any angle about any line.
  Matrix3<double> rotation()
  {
    const double w = between(-1, 1);
    return quaternion_rotation(w, vector(-1, 1));
  }

  /// A turn by a small angle [rad] about a line.
  static Matrix3<double> tilt(double angle, const Vector3<double>& about)
  {
    return quaternion_rotation(1, angle / 2 * about);
  }
};
// [box_draw]

/// The same points under another name: the axes of a box can be labelled in 24 ways.
///
/// The axes stay right-handed: six orders, and the signs of two axes.
template <class Real>
Obb<Real> relabelled(const Obb<Real>& box, int way)
{
  const int first = way / 4 % 3, step = 1 + way / 12;
  const int order[] = {first, (first + step) % 3, (first + 2 * step) % 3};
  const Real sign_0 = way % 2 == 0 ? Real(1) : Real(-1),
             sign_1 = way / 2 % 2 == 0 ? Real(1) : Real(-1);
  const Real signs[] = {sign_0, sign_1, sign_0 * sign_1 * (step == 1 ? Real(1) : Real(-1))};
  Obb<Real> other = box;
  for (int k = 0; k < 3; ++k)
  {
    other.axes.col(k) = signs[k] * box.axes.col(order[k]);
    other.half_extents[k] = box.half_extents[order[k]];
  }
  return other;
}

/// Both boxes turned about the origin, then moved.
inline BoxPair<double>
placed(const BoxPair<double>& pair, const Matrix3<double>& turn, const Vector3<double>& offset)
{
  const auto moved = [&](const Obb<double>& box) -> Obb<double> {
    return {turn * box.center + offset, turn * box.axes, box.half_extents};
  };
  return {moved(pair.first), moved(pair.second)};
}

/// The pair somewhere within 2 m of the origin, turned anyhow, in either order, each box labelled
/// anyhow.
inline BoxPair<double> anywhere(BoxDraw& draw, const BoxPair<double>& pair)
{
  const Matrix3<double> turn = draw.rotation();
  auto [a, b] = placed(pair, turn, draw.vector(-1, 1));
  a = relabelled(a, draw.whole(24));
  b = relabelled(b, draw.whole(24));
  return draw.whole(2) == 0 ? BoxPair<double>{a, b} : BoxPair<double>{b, a};
}

} // namespace cookbook
