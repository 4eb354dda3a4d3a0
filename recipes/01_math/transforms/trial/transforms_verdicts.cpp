#include "01_math/transforms/trial/transforms_verdicts.hpp"

#include "01_math/transforms/trial/local_cases.hpp"
#include "01_math/transforms/trial/transforms_cases.hpp"
#include "tools/exact/exact.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook
{

namespace
{

/// How far a plane is off: of its unit normal, or of its distance as a part of the sizes that it
/// is made of, in roundings of float; infinite where it is not finite.
double plane_error(const Hyperplane3<float>& answer, const Affine3<float>& t)
{
  if (!answer.coeffs().allFinite())
  {
    return std::numeric_limits<double>::infinity();
  }
  const Matrix3<Rational> m = exact_matrix<float, 3>(t.linear()), c = cofactors<Rational>(m);
  const bool mirrors = m.col(0).dot(c.col(0)) < 0;
  const Vector3<Rational> n = exact<Rational, float>(ramp.normal()), along = c * n;
  Vector3<Reference> unit(Reference(along.x()), Reference(along.y()), Reference(along.z()));
  unit = Vector3<Reference>(unit * (Reference(mirrors ? -1 : 1) / sqrt(unit.dot(unit))));
  const Vector3<Rational> point = Rational(-ramp.offset()) * n;
  const Vector3<Rational> carried = m * point + exact<Rational, float>(t.translation());
  const Vector3<Rational> sizes =
      m.cwiseAbs() * point.cwiseAbs() + exact<Rational, float>(t.translation().cwiseAbs());
  Reference distance = 0, size = 0, off = 0;
  for (int i = 0; i < 3; ++i)
  {
    distance += unit[i] * Reference(carried[i]);
    size += abs(unit[i]) * Reference(sizes[i]);
    off = std::max<Reference>(off, abs(Reference(answer.normal()[i]) - unit[i]));
  }
  const Reference offset_off = abs(Reference(-answer.offset()) - distance) / size;
  return static_cast<double>(std::max<Reference>(off, offset_off)) * 0x1p24;
}

/// How far a local point is from the exact one [unit of the body].
double
local_error(const Vector3<float>& answer, const Affine3<float>& t, const Vector3<float>& point)
{
  if (!answer.allFinite())
  {
    return std::numeric_limits<double>::infinity();
  }
  const Matrix3<Rational> back = adjugate_inverse<Rational, 3>(exact_matrix<float, 3>(t.linear()));
  const Vector3<Rational> truth =
      back * (exact<Rational, float>(point) - exact<Rational, float>(t.translation()));
  return static_cast<double>(
      Rational((exact<Rational, float>(answer) - truth).cwiseAbs().maxCoeff()));
}

} // namespace

std::vector<std::string> plane_names()
{
  return names_of(plane_methods());
}

std::vector<VerdictRow> plane_verdicts()
{
  std::vector<VerdictRow> all;
  for (const PlaneCase& one : plane_cases())
  {
    all.push_back({one.id, one.what, {}});
    for (const PlaneMethod& method : plane_methods())
    {
      const double error = plane_error(method.carry(one.t, ramp), one.t);
      const bool right = error <= allowed_in_transforms;
      const std::string off = std::isinf(error) ? "not finite" : rounded(error * 0x1p-24) + " off";
      all.back().verdicts.push_back({right, right ? "right" : off});
    }
  }
  return all;
}

std::vector<std::string> local_names()
{
  return names_of(local_methods());
}

std::vector<VerdictRow> local_verdicts()
{
  std::vector<VerdictRow> all;
  for (const LocalCase& one : local_cases())
  {
    const Vector3<float> point = one.t * Vector3<float>(1, 2, 3);
    all.push_back({"", one.what, {}});
    for (const LocalMethod& method : local_methods())
    {
      const double error = local_error(method.local(one.t, point), one.t, point);
      const bool right = error <= allowed_local;
      const std::string off = std::isinf(error) ? "not finite" : rounded(error) + " off";
      all.back().verdicts.push_back({right, right ? "right" : off});
    }
  }
  return all;
}

} // namespace cookbook
