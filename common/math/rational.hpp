#pragma once

/// \file
/// \brief Exact numbers: the truth that every formula is measured against.

#include "common/math/vector.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/eigen.hpp>

#include <type_traits>

namespace cookbook
{

/// Whether a type is one of Eigen's matrices or expressions.
template <class Type>
concept EigenExpression =
  requires(const Type& value) { []<class Derived>(const Eigen::EigenBase<Derived>&) {}(value); };

} // namespace cookbook

namespace boost::multiprecision::detail
{

/// Boost asks of every argument whether it is a container of bytes, and older versions stumble over
/// Eigen's matrices, which have no iterator: they are none.
template <cookbook::EigenExpression Matrix>
struct is_byte_container<Matrix> : std::false_type
{
};

} // namespace boost::multiprecision::detail

namespace cookbook
{

/// A fraction of whole numbers of any size: +, -, * and / are exact, there is no square root.
using Rational = boost::multiprecision::number<
    boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

/// A float of 100 decimal digits, for the truth of formulas that need a square root.
using Reference = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// The exact value of a float or double, as another kind of number.
template <class To, class From>
To exact(From x)
{
  return To(x);
}

/// The exact values of a vector's components.
template <class To, class From>
Vector3<To> exact(const Vector3<From>& v)
{
  return {To(v.x()), To(v.y()), To(v.z())};
}

} // namespace cookbook
