#include "01_math/matrices/trial/matrix_instances.hpp"

namespace cookbook
{

template Matrix3<Rational> cofactors<Rational>(const Matrix3<Rational>&);
template Matrix4<Rational> cofactors<Rational>(const Matrix4<Rational>&);
template Matrix3<Rational> adjugate_inverse<Rational, 3>(const Matrix3<Rational>&);
template Matrix4<Rational> adjugate_inverse<Rational, 4>(const Matrix4<Rational>&);
template double inverse_error<float, 3>(const Matrix3<float>&, const Matrix3<float>&);
template double inverse_error<double, 3>(const Matrix3<double>&, const Matrix3<double>&);
template std::array<InverseMethod<float>, 6> inverse_methods<float>();
template std::array<InverseMethod<double>, 6> inverse_methods<double>();
template std::vector<VerdictRow> inverse_verdicts<float>();
template std::vector<VerdictRow> inverse_verdicts<double>();

} // namespace cookbook
