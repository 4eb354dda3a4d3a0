#pragma once

/// \file
/// \brief The accelerations of a tree by another way: exact derivatives of its links' places, and
/// the joint-space mass matrix, solved densely.

#include "07_constraints/articulated/articulated_body.hpp"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace cookbook
{

// [pose_series]
/// A pose as a power series of time: after t it is of[0] + of[1] t + of[2] t².
struct PoseSeries
{
  std::array<Eigen::Matrix4d, 3> of{
      Eigen::Matrix4d::Identity(), Eigen::Matrix4d::Zero(), Eigen::Matrix4d::Zero()};
};

/// The product of two series, to the second power.
inline PoseSeries operator*(const PoseSeries& a, const PoseSeries& b)
{
  return {
      {a.of[0] * b.of[0], a.of[0] * b.of[1] + a.of[1] * b.of[0],
       a.of[0] * b.of[2] + a.of[1] * b.of[1] + a.of[2] * b.of[0]}};
}

/// A pose that stays.
inline PoseSeries still(const Quaternion<double>& turn, const Vector3<double>& shift)
{
  PoseSeries series;
  series.of[0].topLeftCorner<3, 3>() = turn.toRotationMatrix();
  series.of[0].topRightCorner<3, 1>() = shift;
  return series;
}

/// A joint that turns and slides from where it is, with a velocity and an acceleration.
inline PoseSeries
moving(const PoseSeries& at, const SpatialVector& velocity, const SpatialVector& acceleration)
{
  PoseSeries series = at;
  const Matrix3<double> turn = at.of[0].topLeftCorner<3, 3>();
  const Matrix3<double> spin = cross_matrix<double>(velocity.head<3>());
  const Matrix3<double> faster = cross_matrix<double>(acceleration.head<3>());
  series.of[1].topLeftCorner<3, 3>() = spin * turn;
  series.of[1].topRightCorner<3, 1>() = velocity.tail<3>();
  series.of[2].topLeftCorner<3, 3>() = (faster + spin * spin) * turn / 2;
  series.of[2].topRightCorner<3, 1>() = acceleration.tail<3>() / 2;
  return series;
}
// [pose_series]

/// The vector of an antisymmetric matrix.
inline Vector3<double> cross_vector(const Matrix3<double>& m)
{
  return Vector3<double>(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)) / 2;
}

/// How a link moves and what it feels.
struct DenseLink
{
  Matrix3<double> axes;
  SpatialVector velocity, acceleration; ///< at its centre, world
};

/// All links of a tree in a state whose velocities change by these accelerations.
inline std::vector<DenseLink> dense_motion(
    const std::vector<Link>& links, const TreeState& state, const Eigen::VectorXd& accelerations)
{
  std::vector<PoseSeries> poses;
  std::vector<DenseLink> all;
  Eigen::Index place = 0, rate = 0;
  for (const Link& link : links)
  {
    const auto [positions, velocities] = sizes_of(link.joint);
    const Eigen::VectorXd q = state.positions.segment(place, positions);
    SpatialVector v = SpatialVector::Zero(), a = SpatialVector::Zero();
    for (int k = 0; k < velocities; ++k)
    {
      SpatialVector way = SpatialVector::Unit(k);
      if (velocities == 1)
      {
        way.setZero();
        way.segment<3>(link.joint == JointType::hinge ? 0 : 3) = link.axis;
      }
      v += state.velocities[rate + k] * way;
      a += accelerations[rate + k] * way;
    }
    PoseSeries at;
    if (link.joint == JointType::hinge)
    {
      at = still(Quaternion<double>(Eigen::AngleAxisd(q[0], link.axis)), {0, 0, 0});
    }
    else if (link.joint == JointType::slider)
    {
      at = still(Quaternion<double>::Identity(), q[0] * link.axis);
    }
    else if (positions >= 4)
    {
      const Quaternion<double> turn = Quaternion<double>(q[0], q[1], q[2], q[3]).normalized();
      at = still(turn, positions == 7 ? Vector3<double>(q.tail<3>()) : Vector3<double>(0, 0, 0));
    }
    const PoseSeries parent =
        link.parent < 0 ? PoseSeries() : poses[static_cast<std::size_t>(link.parent)];
    const PoseSeries pose = parent * still(link.frame, link.anchor_parent) * moving(at, v, a) *
                            still(Quaternion<double>::Identity(), -link.anchor_child);
    poses.push_back(pose);
    const auto part = [&](std::size_t i) -> Matrix3<double>
    { return pose.of[i].topLeftCorner<3, 3>(); };
    const Matrix3<double> spin = part(1) * part(0).transpose();
    const Matrix3<double> faster = 2 * part(2) * part(0).transpose() - spin * spin;
    all.push_back(
        {part(0), spatial(cross_vector(spin), pose.of[1].topRightCorner<3, 1>()),
         spatial(cross_vector(faster), 2 * pose.of[2].topRightCorner<3, 1>())});
    place += positions;
    rate += velocities;
  }
  return all;
}

/// The solution of a system of equations with a positive definite matrix, by elimination.
inline Eigen::VectorXd eliminated(Eigen::MatrixXd matrix, Eigen::VectorXd right)
{
  const Eigen::Index size = right.size();
  for (Eigen::Index k = 0; k < size; ++k)
  {
    for (Eigen::Index i = k + 1; i < size; ++i)
    {
      const double factor = matrix(i, k) / matrix(k, k);
      matrix.row(i) -= factor * matrix.row(k);
      right[i] -= factor * right[k];
    }
  }
  for (Eigen::Index k = size; k-- > 0;)
  {
    for (Eigen::Index j = k + 1; j < size; ++j)
    {
      right[k] -= matrix(k, j) * right[j];
    }
    right[k] /= matrix(k, k);
  }
  return right;
}

// [dense_accelerations]
/// The accelerations of a tree: JᵀMJ q̈ = drive and springs - Jᵀ(M a₀ + ω × Iω - m g - loads). A
/// column of J is how all links move where one velocity is 1; a₀ where no joint accelerates.
inline Eigen::VectorXd dense_accelerations(const ArticulatedBody& tree, const TreeState& state)
{
  const Eigen::Index size = state.velocities.size();
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(size);
  std::vector<std::vector<DenseLink>> columns;
  Eigen::VectorXd right = tree.drive;
  Eigen::Index place = 0, rate = 0;
  for (const Link& link : tree.links())
  {
    if (sizes_of(link.joint).velocities == 1)
    {
      right[rate] -= link.stiffness * (state.positions[place] - link.rest);
      right[rate] -= link.damping * state.velocities[rate];
    }
    place += sizes_of(link.joint).positions;
    rate += sizes_of(link.joint).velocities;
  }
  for (Eigen::Index k = 0; k < size; ++k)
  {
    const TreeState one{state.positions, Eigen::VectorXd::Unit(size, k)};
    columns.push_back(dense_motion(tree.links(), one, none));
  }
  const std::vector<DenseLink> moving = dense_motion(tree.links(), state, none);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < moving.size(); ++i)
  {
    const auto& [m, moments] = tree.links()[i].solid;
    const SpatialMatrix inertia = rigid_inertia(m, moments, moving[i].axes);
    const Vector3<double> spin = moving[i].velocity.head<3>();
    const Vector3<double> turns = spin.cross(inertia.topLeftCorner<3, 3>() * spin);
    const SpatialVector force =
        inertia * moving[i].acceleration + spatial(turns, -m * tree.gravity()) - tree.loads[i];
    for (Eigen::Index k = 0; k < size; ++k)
    {
      const SpatialVector& column = columns[static_cast<std::size_t>(k)][i].velocity;
      const SpatialVector heavy = inertia * column;
      right[k] -= column.dot(force);
      for (Eigen::Index j = 0; j < size; ++j)
      {
        mass(j, k) += columns[static_cast<std::size_t>(j)][i].velocity.dot(heavy);
      }
    }
  }
  return eliminated(mass, right);
}
// [dense_accelerations]

} // namespace cookbook
