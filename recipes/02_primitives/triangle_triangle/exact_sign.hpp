#pragma once

/// \file
/// \brief On which side of a plane or a line a point lies, decided without an error.

#include "common/math/vector.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace cookbook
{

/// A sum of up to 96 numbers without an error: parts of growing size that do not overlap.
class ExactSum
{
public:
  /// Adds a number; what a rounded sum loses becomes a part of its own.
  void add(double x)
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i)
    {
      const double sum = x + parts_[i], of_part = sum - x;
      const double lost = (x - (sum - of_part)) + (parts_[i] - of_part);
      if (lost != 0)
      {
        parts_[kept++] = lost;
      }
      x = sum;
    }
    if (x != 0)
    {
      parts_[kept++] = x;
    }
    size_ = kept;
  }

  /// Adds a product of two numbers.
  void add(double x, double y)
  {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }

  /// Adds a product of three numbers.
  void add(double x, double y, double z)
  {
    const double product = x * y;
    add(std::fma(x, y, -product), z);
    add(product, z);
  }

  /// −1, 0 or 1: the largest part decides.
  int sign() const { return size_ == 0 ? 0 : parts_[size_ - 1] < 0 ? -1 : 1; }

private:
  std::array<double, 96> parts_;
  std::size_t size_ = 0;
};

// [orient3d]
/// 1 where d lies below the plane of a, b and c, which are seen counterclockwise from above; −1
/// above it; 0 on it; P16.
///
/// Numbers up to 1e100 and down to 1e-90: then no product leaves the range of double.
inline int orient3d(
    const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
    const Vector3<double>& d)
{
  const Vector3<double> p = a - d, q = b - d, r = c - d;
  const double permanent = std::abs(p.x()) * (std::abs(q.y() * r.z()) + std::abs(q.z() * r.y())) +
                           std::abs(p.y()) * (std::abs(q.z() * r.x()) + std::abs(q.x() * r.z())) +
                           std::abs(p.z()) * (std::abs(q.x() * r.y()) + std::abs(q.y() * r.x()));
  const double volume = p.dot(q.cross(r));
  if (std::abs(volume) > 0x1p-49 * permanent)
  {
    return volume < 0 ? -1 : 1;
  }
  ExactSum sum;
  const auto add_volume =
      [&sum](
          double sign, const Vector3<double>& u, const Vector3<double>& v, const Vector3<double>& w)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      sum.add(sign * u[i], v[j], w[k]);
      sum.add(-sign * u[i], v[k], w[j]);
    }
  };
  add_volume(1, a, b, c);
  add_volume(-1, a, b, d);
  add_volume(1, a, c, d);
  add_volume(-1, b, c, d);
  return sum.sign();
}
// [orient3d]

/// 1 where a, b and c turn counterclockwise, −1 where they turn clockwise, 0 where they do not;
/// seen along the axis k, of which the coordinate is left out.
inline int
orient2d(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c, int k)
{
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  ExactSum sum;
  const auto add_area = [&](const Vector3<double>& u, const Vector3<double>& v)
  {
    sum.add(u[i], v[j]);
    sum.add(-u[j], v[i]);
  };
  add_area(a, b);
  add_area(b, c);
  add_area(c, a);
  return sum.sign();
}

} // namespace cookbook
