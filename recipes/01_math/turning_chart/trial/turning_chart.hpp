#pragma once

/// \file
/// \brief Ways to turn in float, a million times by a spin that changes, and where they end.

#include "01_math/rotations/euler_angles.hpp"
#include "01_math/turning/trial/turning_cases.hpp"

#ifdef COOKBOOK_HAS_GLM
#include <glm/gtc/quaternion.hpp>
#endif

#include <cmath>
#include <random>
#include <vector>

namespace cookbook
{

/// A frame of a game [s].
inline constexpr float frame = 1.0f / 60;

// [changing_spin]
/// 64 angular velocities [rad/s] up to 5 in each component, the same ones every time.
inline std::vector<Vector3<float>> changing_spin()
{
  std::mt19937 random(1);
  const auto component = [&]
  { return static_cast<float>(static_cast<int>(random() % 10001) - 5000) / 1000; };
  std::vector<Vector3<float>> spins;
  for (int i = 0; i < 64; ++i)
  {
    const float x = component(), y = component();
    spins.push_back({x, y, component()});
  }
  return spins;
}

/// Where the spins lead, `rounds` times one after the other, in long double.
inline Quaternion<double> true_end(const std::vector<Vector3<float>>& spins, int rounds)
{
  Quaternion<long double> round(1, 0, 0, 0), end = round;
  for (const Vector3<float>& spin : spins)
  {
    const Vector3<long double> turn = spin.cast<long double>() * static_cast<long double>(frame);
    const long double angle = turn.norm();
    Quaternion<long double> one(std::cos(angle / 2), 0, 0, 0);
    one.vec() = turn * (std::sin(angle / 2) / angle);
    round = one * round;
  }
  for (int i = 0; i < rounds; ++i)
  {
    end = round * end;
  }
  return end.normalized().cast<double>();
}
// [changing_spin]

/// Goes through the spins `rounds` times, by one step of a way after the other.
template <class State, class Step>
State after_rounds(
    State state, const std::vector<Vector3<float>>& spins, int rounds, const Step& one)
{
  for (int i = 0; i < rounds; ++i)
  {
    for (const Vector3<float>& spin : spins)
    {
      state = one(state, spin, frame);
    }
  }
  return state;
}

// [chart_ways]
/// By Rodrigues' matrix, and nothing repaired.
inline Matrix3<float>
matrix_turned(const Matrix3<float>& axes, const Vector3<float>& spin, float step)
{
  return rotation_about<float>(spin, spin.norm() * step) * axes;
}

/// By Eigen's angle and axis, and nothing repaired.
inline Quaternion<float>
eigen_turned(const Quaternion<float>& q, const Vector3<float>& spin, float step)
{
  return Eigen::AngleAxisf(spin.norm() * step, spin.normalized()) * q;
}

#ifdef COOKBOOK_HAS_GLM
/// By GLM's angle and axis, and nothing repaired.
inline glm::quat glm_turned(const glm::quat& q, const Vector3<float>& spin, float step)
{
  const glm::vec3 v(spin.x(), spin.y(), spin.z());
  return glm::angleAxis(glm::length(v) * step, glm::normalize(v)) * q;
}
#endif
// [chart_ways]

/// The end of a way by matrices, or by GLM, as others have it.
inline SpinEnd spin_end(const Matrix3<float>& axes)
{
  return {spin_end(quaternion_of(axes)).orientation, std::cbrt(double(axes.determinant()))};
}
#ifdef COOKBOOK_HAS_GLM
inline SpinEnd spin_end(const glm::quat& q)
{
  return spin_end(Quaternion<float>(q.w, q.x, q.y, q.z));
}
#endif

/// The angle [rad] from the true end, or by how much the length is off one, if that is more.
inline double drift(const SpinEnd& end, const Quaternion<double>& right)
{
  const Quaternion<double> turn = right.conjugate() * end.orientation;
  const double angle = 2 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
  return std::max(angle, std::abs(end.length - 1));
}

} // namespace cookbook
