#pragma once

/// \file
/// \brief How the impulses on two bodies change with the velocities of both, through a contact.

#include "05_resolution/spinning_bodies/cross_matrix.hpp"
#include "06_world/direct_solver/block_cholesky.hpp"
#include "06_world/direct_solver/direct_points.hpp"

#include <span>

namespace cookbook
{

// [direct_blocks]
/// How the impulses and angular impulses on two bodies change with the velocities of both, through
/// a contact.
struct DirectBlocks
{
  Matrix6 aa = Matrix6::Zero(); ///< of A in A; only its lower half is right
  Matrix6 ab = Matrix6::Zero(); ///< of B in A
  Matrix6 bb = Matrix6::Zero(); ///< of B in B; only its lower half is right
};

/// Adds a point with a stiffness W [kg]: Jᵀ W J, where J = (1, −S), S x = r × x, takes the
/// velocities of a body to that of its point.
inline void
add_point(DirectBlocks& blocks, const DirectPoint& point, const Matrix3<double>& stiffness)
{
  const Matrix3<double> a = cross_matrix(point.arms.a), b = cross_matrix(point.arms.b);
  const Matrix3<double> a_by = a * stiffness, b_by = b * stiffness;
  blocks.aa.topLeftCorner<3, 3>() += stiffness;
  blocks.aa.bottomLeftCorner<3, 3>() += a_by;
  blocks.aa.bottomRightCorner<3, 3>() -= a_by * a;
  blocks.ab.topLeftCorner<3, 3>() -= stiffness;
  blocks.ab.topRightCorner<3, 3>() -= b_by.transpose();
  blocks.ab.bottomLeftCorner<3, 3>() -= a_by;
  blocks.ab.bottomRightCorner<3, 3>() += a_by * b;
  blocks.bb.topLeftCorner<3, 3>() += stiffness;
  blocks.bb.bottomLeftCorner<3, 3>() += b_by;
  blocks.bb.bottomRightCorner<3, 3>() -= b_by * b;
}

/// The sums over points that resist alike in all directions: all of such a contact in a few
/// numbers.
struct IsotropicPoints
{
  double count = 0;
  Vector3<double> a = Vector3<double>::Zero(), b = Vector3<double>::Zero();
  Matrix3<double> aa = Matrix3<double>::Zero(), ab = aa, bb = aa; ///< sums of r rᵀ

  /// Adds a point by its arms.
  void add(const Arms<double>& arms)
  {
    count += 1;
    a += arms.a;
    b += arms.b;
    for (int column = 0; column < 3; ++column)
    {
      for (int row = 0; row < 3; ++row)
      {
        aa(row, column) += arms.a[row] * arms.a[column];
        ab(row, column) += arms.b[row] * arms.a[column];
        bb(row, column) += arms.b[row] * arms.b[column];
      }
    }
  }

  /// The same as add_point() for each of them, with a stiffness w [kg] times the identity, since
  /// S(r) S(q) = q rᵀ − (r·q) 1.
  DirectBlocks blocks(double w) const
  {
    const auto squares = [&](const Matrix3<double>& sum) -> Matrix3<double>
    { return w * (sum.trace() * Matrix3<double>::Identity() - sum); };
    const Matrix3<double> one = w * count * Matrix3<double>::Identity();
    const Matrix3<double> s_a = w * cross_matrix(a), s_b = w * cross_matrix(b);
    DirectBlocks made;
    made.aa << one, -s_a, s_a, squares(aa);
    made.ab << -one, s_b, -s_a, -squares(ab);
    made.bb << one, -s_b, s_b, squares(bb);
    return made;
  }
};

/// What a contact with these points adds.
inline DirectBlocks blocks_of(
    std::span<const DirectPoint> points, const Vector3<double>& normal,
    const DirectStiffness& stiffness)
{
  const auto is_isotropic = [&](const DirectPoint& point)
  {
    return stiffness.push == stiffness.friction && point.active &&
           point.friction_state == FrictionState::stick;
  };
  IsotropicPoints even;
  for (const DirectPoint& point : points)
  {
    if (is_isotropic(point))
    {
      even.add(point.arms);
    }
  }
  DirectBlocks blocks = even.blocks(stiffness.push);
  for (const DirectPoint& point : points)
  {
    if (!is_isotropic(point) && has_impulse(point))
    {
      add_point(blocks, point, stiffness_at(point, normal, stiffness));
    }
  }
  return blocks;
}
// [direct_blocks]

} // namespace cookbook
