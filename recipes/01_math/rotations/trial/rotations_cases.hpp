#pragma once

/// \file
/// \brief Rotations that break some way to handle them: as first written, Eigen's, and this book's.

#include "01_math/rotations/rotations.hpp"
#include "01_math/rotations/trial/eigen_between.hpp"
#include "01_math/rotations/trial/rotations_pitfalls.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

/// An answer is right within this: eight units in the last place of one, in float.
inline constexpr double rotation_limit = 1e-6;

/// Whether a quaternion is the right one, or the right one's negative.
inline Verdict quaternion_verdict(const Quaternion<float>& answer, const Quaternion<double>& truth)
{
  const Quaternion<double> q = answer.cast<double>();
  if (!q.coeffs().allFinite())
  {
    return {false, "not a number"};
  }
  const double length = q.norm();
  if (std::abs(length - 1) > rotation_limit)
  {
    return {false, "length " + number(length)};
  }
  const Quaternion<double> turn = truth.conjugate() * q;
  const double off = 2 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
  const bool holds = off <= 2 * rotation_limit;
  return {holds, holds ? "right" : "off by " + rounded(off * 180 / std::numbers::pi) + "°"};
}

/// Whether a matrix is the right one.
inline Verdict matrix_verdict(const Matrix3<float>& answer, const Matrix3<double>& truth)
{
  const double off = (answer.cast<double>() - truth).cwiseAbs().maxCoeff();
  return {off <= rotation_limit, off <= rotation_limit ? "right" : "off by " + rounded(off)};
}

/// Whether three angles give their matrix again, with the pitch between straight down and up.
inline Verdict angles_verdict(const EulerAngles<float>& answer, const Matrix3<float>& r)
{
  const EulerAngles<double> wide{answer.heading, answer.pitch, answer.roll};
  const double off = (from_euler_angles(wide) - r.cast<double>()).cwiseAbs().maxCoeff();
  if (!(off <= rotation_limit))
  {
    return {false, std::isnan(off) ? "not a number" : "off by " + rounded(off)};
  }
  const double pitch = wide.pitch * 180 / std::numbers::pi;
  const bool upright = std::abs(pitch) <= 90.001;
  return {upright, upright ? "right" : "pitch " + number(std::round(pitch)) + "°"};
}

// [rotations_cases]
/// A question about a rotation, and what became of it in each of three ways.
struct RotationCase
{
  std::string what;                    ///< the question
  std::function<Verdict()> first_way;  ///< as one writes it first
  std::function<Verdict()> eigens_way; ///< Eigen's own function
  std::function<Verdict()> books_way;  ///< this book's
};

/// From a matrix to a quaternion, whose direction is `truth`, the matrix stretched by `stretch`.
inline RotationCase
matrix_case(const std::string& what, const Quaternion<double>& truth, float stretch)
{
  const Matrix3<float> r = truth.normalized().toRotationMatrix().cast<float>() * stretch;
  const auto verdict = [=](const Quaternion<float>& answer)
  { return quaternion_verdict(answer, truth.normalized()); };
  return {
      "matrix to quaternion: " + what, [=] { return verdict(quaternion_by_w(r)); },
      [=] { return verdict(Quaternion<float>(r)); }, [=] { return verdict(quaternion_of(r)); }};
}

/// The direction of the quaternion (1, 2, 3, 4) times a size.
inline RotationCase size_case(const std::string& what, float size)
{
  const Quaternion<float> q(1 * size, 2 * size, 3 * size, 4 * size);
  const auto verdict = [](const Quaternion<float>& answer)
  { return quaternion_verdict(answer, Quaternion<double>(1, 2, 3, 4).normalized()); };
  return {
      "length one: " + what, [=] { return verdict(quaternion_over_root(q)); },
      [=] { return verdict(q.normalized()); }, [=] { return verdict(unit_quaternion(q)); }};
}

/// A quaternion of length 1.005 to a matrix.
inline RotationCase long_case()
{
  const Quaternion<float> q(0.303f, 0.505f, 0.707f, 0.404f);
  const Matrix3<double> right = q.cast<double>().normalized().toRotationMatrix();
  return {
      "quaternion to matrix: length 1.005",
      [=] { return matrix_verdict(matrix_of_unit(q), right); },
      [=] { return matrix_verdict(q.toRotationMatrix(), right); },
      [=] { return matrix_verdict(rotation_matrix(q), right); }};
}

/// From no turn by a quaternion, at a fraction of the way.
inline RotationCase slerp_case(
    const std::string& what, const Quaternion<float>& to, float t, const Quaternion<double>& truth)
{
  const Quaternion<float> from = Quaternion<float>::Identity();
  const auto verdict = [=](const Quaternion<float>& answer)
  { return quaternion_verdict(answer, truth); };
  return {
      "slerp: " + what, [=] { return verdict(slerp_by_cosine(from, to, t)); },
      [=] { return verdict(from.slerp(t, to)); }, [=] { return verdict(slerp(from, to, t)); }};
}

/// From one vector to another.
inline RotationCase between_case(
    const std::string& what, const Vector3<float>& from, const Vector3<float>& to,
    const Quaternion<double>& truth)
{
  const auto verdict = [=](const Quaternion<float>& answer)
  { return quaternion_verdict(answer, truth.normalized()); };
  return {
      "between vectors: " + what, [=] { return verdict(between_by_half(from, to)); },
      [=] { return verdict(eigen_between(from, to)); },
      [=] { return verdict(rotation_between(from, to)); }};
}

/// The three angles of a rotation that was made of three [degrees].
inline RotationCase angles_case(const std::string& what, const Vector3<double>& degrees)
{
  const Vector3<double> a = degrees * std::numbers::pi / 180;
  const Matrix3<float> r =
      from_euler_angles(EulerAngles<double>{a.x(), a.y(), a.z()}).cast<float>();
  const auto eigens = [=]
  {
    const Vector3<float> e = r.eulerAngles(1, 0, 2);
    return angles_verdict({e.x(), e.y(), e.z()}, r);
  };
  return {
      "three angles: " + what, [=] { return angles_verdict(angles_by_sine(r), r); }, eigens,
      [=] { return angles_verdict(euler_angles(r), r); }};
}

/// All questions, all of them in float.
inline std::vector<RotationCase> rotation_cases()
{
  const double off_lock = 5e-5 * std::numbers::pi / 180;
  const Quaternion<double> almost(
      std::sin(off_lock), std::cos(off_lock) / 3, 2 * std::cos(off_lock) / 3,
      2 * std::cos(off_lock) / 3);
  const float tiny = 1e-30f;
  const Quaternion<float> small(1, 5e-4f, 0, 0);
  const double thousand = 1000 * std::atan(double(small.x())), bend = std::atan(double(0.001f)) / 2;
  return {
      matrix_case("half a turn about (3, 4, 0)", {0, 3, 4, 0}, 1),
      matrix_case("0.0001° short of it, about (1, 2, 2)", almost, 1),
      matrix_case("stretched by 1 %", {1, 2, 3, 4}, 1.01f),
      size_case("(1, 2, 3, 4) · 1e-30", tiny),
      size_case("(1, 2, 3, 4) · 1e30", 1e30f),
      long_case(),
      slerp_case("from q to q", {1, 0, 0, 0}, 0.5f, {1, 0, 0, 0}),
      slerp_case("from q to -q", {-1, 0, 0, 0}, 0.5f, {1, 0, 0, 0}),
      slerp_case(
          "1000 times a turn of 0.001", small, 1000,
          {std::cos(thousand), std::sin(thousand), 0, 0}),
      between_case("(1, 0, 0) to (-1, 0, 0)", {1, 0, 0}, {-1, 0, 0}, {0, 0, 0, -1}),
      between_case(
          "(1, 0, 0) to (-1, 0.001, 0)", {1, 0, 0}, {-1, 0.001f, 0},
          {std::sin(bend), 0, 0, std::cos(bend)}),
      between_case("(0, 0, 1e-30) to (0, 1e-30, 0)", {0, 0, tiny}, {0, tiny, 0}, {1, -1, 0, 0}),
      angles_case("30, 90, 20 degrees", {30, 90, 20}),
      angles_case("30, 89.99, 20 degrees", {30, 89.99, 20}),
      angles_case("-6, 0, 0 degrees", {-6, 0, 0})};
}
// [rotations_cases]

/// The names of the three ways.
inline const std::vector<std::string> rotation_ways{"first written", "Eigen", "this page"};

/// The verdicts, question by question.
inline std::vector<VerdictRow> rotation_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const RotationCase& one : rotation_cases())
  {
    rows.push_back({"", one.what, {one.first_way(), one.eigens_way(), one.books_way()}});
  }
  return rows;
}

} // namespace cookbook
