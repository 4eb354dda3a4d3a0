/// \file
/// \brief Turns by axis and angle, by three angles and by quaternions, and answers questions about
/// the reader's own.

#include "01_math/rotations/rotations.hpp"
#include "01_math/rotations/trial/rotations_cases.hpp"
#include "01_math/rotations/trial/rotations_figures.hpp"
#include "tools/program/asking.hpp"
#include "tools/program/table.hpp"

#include <iostream>
#include <numbers>

namespace
{

using namespace cookbook;

void print_rotations()
{
  const double degree = std::numbers::pi / 180;
  Table table({"rotation", "w", "x", "y", "z", "heading", "pitch", "roll"});
  const auto add = [&](const std::string& what, const Quaternion<double>& q)
  {
    const auto cell = [](double value, double unit)
    { return number(std::round(value / unit * 1e4) / 1e4); };
    const EulerAngles<double> angles = euler_angles(rotation_matrix(q));
    table.row(
        {what, cell(q.w(), 1), cell(q.x(), 1), cell(q.y(), 1), cell(q.z(), 1),
         cell(angles.heading, degree), cell(angles.pitch, degree), cell(angles.roll, degree)});
  };
  const Vector3<double> x(1, 0, 0), y(0, 1, 0);
  const Quaternion<double> none(1, 0, 0, 0);
  const Quaternion<double> quarter = quaternion_of(rotation_about<double>(y, 90 * degree));
  add("no turn", none);
  add("90° about y", quarter);
  add("a third of that, by slerp", slerp<double>(none, quarter, 1.0 / 3));
  add("120° about (1, 1, 1)", quaternion_of(rotation_about<double>({1, 1, 1}, 120 * degree)));
  add("180° about (3, 4, 0)", quaternion_of(rotation_about<double>({3, 4, 0}, 180 * degree)));
  add("from x to y", rotation_between<double>(x, y));
  add("from x to -x", rotation_between<double>(x, -x));
  add("heading 30°, pitch 60°, roll 10°",
      quaternion_of(from_euler_angles<double>({30 * degree, 60 * degree, 10 * degree})));
  add("heading 30°, pitch 90°, roll 10°",
      quaternion_of(from_euler_angles<double>({30 * degree, 90 * degree, 10 * degree})));
  std::cout << table.text();
}

/// The quaternion in four columns from `first` on.
template <class Real>
Quaternion<Real> quaternion_at(const PairsRow& row, std::size_t first)
{
  return {
      row.at<Real>(first), row.at<Real>(first + 1), row.at<Real>(first + 2),
      row.at<Real>(first + 3)};
}

template <class Real>
std::vector<Real> matrix_answer(const PairsRow& row)
{
  const Quaternion<Real> q = quaternion_at<Real>(row, 0);
  if (q.coeffs().isZero(0))
  {
    return {};
  }
  const Matrix3<Real> r = rotation_matrix(q);
  return {r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)};
}

/// A matrix whose products of columns are off by more than 1/1000, or that mirrors, is no rotation.
template <class Real>
std::vector<Real> quaternion_answer(const PairsRow& row)
{
  Matrix3<Real> r;
  r << row.at<Real>(0), row.at<Real>(1), row.at<Real>(2), row.at<Real>(3), row.at<Real>(4),
      row.at<Real>(5), row.at<Real>(6), row.at<Real>(7), row.at<Real>(8);
  if (!(r.cwiseAbs().maxCoeff() <= Real(2)) || !(rotation_error(r) <= Real(0.001)))
  {
    return {};
  }
  const Quaternion<Real> q = quaternion_of(r);
  return {q.w(), q.x(), q.y(), q.z()};
}

template <class Real>
std::vector<Real> slerp_answer(const PairsRow& row)
{
  const Quaternion<Real> a = quaternion_at<Real>(row, 0), b = quaternion_at<Real>(row, 4);
  if (a.coeffs().isZero(0) || b.coeffs().isZero(0))
  {
    return {};
  }
  const Quaternion<Real> q = slerp<Real>(a, b, row.at<Real>(8));
  return {q.w(), q.x(), q.y(), q.z()};
}

/// What may be asked of each row of a file.
template <class Real>
std::vector<Question<Real>> questions(Real)
{
  return {
      {"matrix", "qw,qx,qy,qz", "m00,m01,m02,m10,m11,m12,m20,m21,m22", matrix_answer<Real>},
      {"quaternion", "m00,m01,m02,m10,m11,m12,m20,m21,m22", "w,x,y,z", quaternion_answer<Real>},
      {"slerp", "aw,ax,ay,az,bw,bx,by,bz,t", "w,x,y,z", slerp_answer<Real>}};
}

} // namespace

int main(int argc, char** argv)
{
  return run_asking_program(
      argc, argv,
      {.name = "rotations",
       .summary = "Rotations by axis and angle, by three angles, by quaternions and between them."},
      [](auto zero) { return questions(zero); },
      [](const Arguments& given)
      {
        print_rotations();
        save_figure(given, "rotations_axis.svg", axis_figure().svg());
        save_figure(given, "rotations_lock.svg", lock_grid().svg());
        save_figure(given, "rotations_slerp.svg", slerp_figure().svg());
        save_figure(
            given, "rotations_cases.html",
            folded_verdict_table(
                "Rotations in float: right means within 1e-6.", rotation_ways,
                rotation_verdicts()));
      });
}
