#pragma once

/// \file
/// \brief What takes long to compile of fractions in matrices and of ways to invert, compiled once.

#include "01_math/matrices/trial/matrices_cases.hpp"

namespace cookbook
{

extern template Matrix3<Rational> cofactors<Rational>(const Matrix3<Rational>&);
extern template Matrix4<Rational> cofactors<Rational>(const Matrix4<Rational>&);
extern template Matrix3<Rational> adjugate_inverse<Rational, 3>(const Matrix3<Rational>&);
extern template Matrix4<Rational> adjugate_inverse<Rational, 4>(const Matrix4<Rational>&);
extern template double inverse_error<float, 3>(const Matrix3<float>&, const Matrix3<float>&);
extern template double inverse_error<double, 3>(const Matrix3<double>&, const Matrix3<double>&);
extern template std::array<InverseMethod<float>, 6> inverse_methods<float>();
extern template std::array<InverseMethod<double>, 6> inverse_methods<double>();
extern template std::vector<VerdictRow> inverse_verdicts<float>();
extern template std::vector<VerdictRow> inverse_verdicts<double>();

} // namespace cookbook
