#pragma once

/// \file
/// \brief Matrices of a given condition, ways to invert them, and how wrong each way is.

#include "01_math/matrices/matrices.hpp"
#include "01_math/matrices/trial/matrix_instances.hpp"
#include "tools/measure/statistics.hpp"

#ifdef COOKBOOK_HAS_GLM
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to invert that is timed, by name, built into a loop.
template <int Size>
struct TimedInverse
{
  using M = SquareMatrix<double, Size>;                       ///< what it inverts
  std::string name;                                           ///< as on the chart
  void (*invert_all)(const std::vector<M>&, std::vector<M>&); ///< into as many answers
};

/// A way to invert one matrix, built into a loop.
template <int Size, class Invert>
TimedInverse<Size> timed_inverse(const std::string& name, Invert)
{
  using M = SquareMatrix<double, Size>;
  return {
      name, [](const std::vector<M>& all, std::vector<M>& answers)
      {
        for (std::size_t i = 0; i < all.size(); ++i)
        {
          answers[i] = Invert()(all[i]);
        }
      }};
}

// [timed_inverses]
/// All ways, the recommended one last; NaN where a way says that a matrix is singular.
template <int Size>
std::vector<TimedInverse<Size>> timed_inverses()
{
  using M = SquareMatrix<double, Size>;
  static const M singular = M::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto way = [](const std::string& name, auto invert)
  { return timed_inverse<Size>(name, invert); };
  return {
      way("Eigen inverse", [](const M& m) -> M { return m.inverse(); }),
      way("PartialPivLU", [](const M& m) -> M { return partial_lu_inverse<double, Size>(m); }),
      way("FullPivLU",
          [](const M& m) -> M { return full_lu_inverse<double, Size>(m).value_or(singular); }),
#ifdef COOKBOOK_HAS_GLM
      way("GLM",
          [](const M& m) -> M
          {
            glm::mat<Size, Size, double, glm::defaultp> of;
            std::memcpy(glm::value_ptr(of), m.data(), sizeof(of));
            of = glm::inverse(of);
            M answer;
            std::memcpy(answer.data(), glm::value_ptr(of), sizeof(of));
            return answer;
          }),
#endif
      way("adjugate", [](const M& m) -> M { return adjugate_inverse<double, Size>(m); }),
      way("recommended",
          [](const M& m) -> M { return inverse<double, Size>(m).value_or(singular); })};
}
// [timed_inverses]

// [conditioned]
/// Turned, stretched and turned again: the last axis is stretched `stretch` times less than the
/// others. `count` matrices, the same ones every time.
template <int Size>
std::vector<SquareMatrix<double, Size>> conditioned(double stretch, int count)
{
  using M = SquareMatrix<double, Size>;
  std::mt19937 random(1);
  const auto drawn = [&]
  {
    M any;
    for (int i = 0; i < Size * Size; ++i)
    {
      any.data()[i] = static_cast<double>(random() % 2001) / 1000 - 1;
    }
    for (int k = 0; k < Size; ++k)
    {
      for (int j = 0; j < 2 * k; ++j) // twice, for the roundings of the first time
      {
        any.col(k) -= any.col(j % k).dot(any.col(k)) * any.col(j % k);
      }
      any.col(k).normalize();
    }
    return any;
  };
  Vector<double, Size> along = Vector<double, Size>::Ones();
  along[Size - 1] = 1 / stretch;
  std::vector<M> all;
  for (int i = 0; i < count; ++i)
  {
    const M first = drawn();
    all.push_back(drawn() * along.asDiagonal() * first);
  }
  return all;
}
// [conditioned]

/// How wrong a way is on matrices: the largest entry's error, as a part of the largest entry.
template <int Size>
measure::ErrorStatistics inverse_errors(
    const TimedInverse<Size>& way, const std::vector<SquareMatrix<double, Size>>& matrices)
{
  using Exact = SquareMatrix<Rational, Size>;
  std::vector<double> errors;
  std::vector<SquareMatrix<double, Size>> answers(matrices.size());
  way.invert_all(matrices, answers);
  for (std::size_t k = 0; k < matrices.size(); ++k)
  {
    const SquareMatrix<double, Size>&m = matrices[k], &answer = answers[k];
    if (!answer.allFinite())
    {
      errors.push_back(std::numeric_limits<double>::infinity());
      continue;
    }
    const Exact truth = adjugate_inverse<Rational, Size>(exact_matrix<double, Size>(m));
    Rational off = 0, largest = 0;
    for (int i = 0; i < Size * Size; ++i)
    {
      const Rational& entry = truth.data()[i];
      off = std::max<Rational>(off, abs(Rational(answer.data()[i]) - entry));
      largest = std::max<Rational>(largest, abs(entry));
    }
    errors.push_back(static_cast<double>(Rational(off / largest)));
  }
  return measure::error_statistics(errors);
}

// Compiled once, in timed_inverses.cpp and inverse_errors.cpp.
extern template std::vector<TimedInverse<3>> timed_inverses<3>();
extern template std::vector<SquareMatrix<double, 3>> conditioned<3>(double, int);
extern template measure::ErrorStatistics
inverse_errors<3>(const TimedInverse<3>&, const std::vector<SquareMatrix<double, 3>>&);
extern template std::vector<TimedInverse<4>> timed_inverses<4>();
extern template std::vector<SquareMatrix<double, 4>> conditioned<4>(double, int);
extern template measure::ErrorStatistics
inverse_errors<4>(const TimedInverse<4>&, const std::vector<SquareMatrix<double, 4>>&);

} // namespace cookbook
