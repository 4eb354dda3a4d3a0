#pragma once

/// \file
/// \brief What calls of taken headers are made of: inputs from a fixed seed, and one number made of
/// all bits of all answers.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <random>
#include <type_traits>

/// Draws inputs. Most shapes touch, some are apart; every eighth place, length or pose is one of
/// few round ones, so that some shapes are concentric, parallel, or touch.
class Draw
{
public:
  /// A number from `low` to `high`; every eighth is a multiple of 0.5.
  double number(double low, double high)
  {
    const double share = static_cast<double>(engine_() >> 11) * 0x1p-53;
    const double drawn = low + (high - low) * share;
    return one_in(8) ? std::ceil(2 * drawn) / 2 : drawn;
  }

  bool one_in(unsigned count) { return engine_() % count == 0; } ///< true once in so many times

  Eigen::Vector3d vector(double most) ///< no number beyond `most`; every eighth vector is round
  {
    const bool round = one_in(8);
    Eigen::Vector3d drawn(0, 0, 0);
    for (double& one : drawn)
    {
      one = round ? std::trunc(2 * number(-most, most)) / 2 : number(-most, most);
    }
    return drawn;
  }

  Eigen::Vector3d unit() ///< of length one
  {
    const Eigen::Vector3d drawn = vector(1);
    const double length = drawn.norm();
    return length > 0 ? Eigen::Vector3d(drawn / length) : Eigen::Vector3d(0, 1, 0);
  }

  Eigen::Quaterniond orientation() ///< of length one; every eighth does not turn
  {
    const Eigen::Vector3d axis = unit();
    const double tangent =
        one_in(8) ? 0 : number(-14, 14); // of half the angle, the same everywhere
    const Eigen::Vector3d turned = tangent * axis;
    return Eigen::Quaterniond(1, turned.x(), turned.y(), turned.z()).normalized();
  }

  Eigen::Matrix3d axes() { return orientation().toRotationMatrix(); } ///< of a box

  Eigen::Vector3d half_extents() ///< of a box
  {
    return {number(0.2, 1.4), number(0.2, 1.4), number(0.2, 1.4)};
  }

  double scale() ///< by which a pair of shapes is stretched: mostly 1, else huge or tiny
  {
    return one_in(16) ? std::ldexp(1.0, static_cast<int>(engine_() % 1200) - 600) : 1.0;
  }

  /// A sphere or a box, stretched.
  template <template <class> class Sphere>
  Sphere<double> sphere(double stretch = 1)
  {
    const Eigen::Vector3d center = vector(1) * stretch;
    return {center, number(0.2, 1.4) * stretch};
  }
  template <template <class> class Box>
  Box<double> box(double stretch = 1)
  {
    const Eigen::Vector3d center = vector(1) * stretch;
    const Eigen::Matrix3d turned = axes();
    return {center, turned, half_extents() * stretch};
  }

private:
  std::mt19937_64 engine_{20260101};
};

/// Makes one number of the bits of all that it is given (FNV-1a, a word at a time).
class Bits
{
public:
  std::uint64_t sum() const { return sum_; } ///< of all so far

  /// Adds numbers, vectors, matrices, manifolds, directions; lists and optionals of them.
  template <class... Answer>
  void operator()(const Answer&... answers)
  {
    (add(answers), ...);
  }

private:
  void word(std::uint64_t bits) { sum_ = (sum_ ^ bits) * 0x100000001b3; }

  template <class Answer>
  void add(const Answer& answer)
  {
    if constexpr (std::is_same_v<Answer, double>)
    {
      word(std::isnan(answer) ? ~std::uint64_t(0) : std::bit_cast<std::uint64_t>(answer));
    }
    else if constexpr (std::is_integral_v<Answer> || std::is_enum_v<Answer>)
    {
      word(static_cast<std::uint64_t>(answer));
    }
    else if constexpr (requires { answer.points; })
    {
      (*this)(answer.normal, answer.depth, answer.points);
    }
    else if constexpr (requires { answer.feature; })
    {
      (*this)(answer.position, answer.depth, answer.feature);
    }
    else if constexpr (requires { answer.unit; })
    {
      (*this)(answer.unit, answer.length);
    }
    else if constexpr (requires { answer.has_value(); })
    {
      word(answer.has_value());
      if (answer)
      {
        add(*answer);
      }
    }
    else if constexpr (requires { answer.coeffs(); })
    {
      add(answer.coeffs());
    }
    else if constexpr (requires { answer.reshaped(); })
    {
      for (const double one : answer.reshaped())
      {
        add(one);
      }
    }
    else
    {
      word(answer.size());
      for (const auto& one : answer)
      {
        add(one);
      }
    }
  }

  std::uint64_t sum_ = 0xcbf29ce484222325;
};

/// Prints a recipe's name, and one number for what it answers to 10,000 inputs.
template <class Call>
void print(const char* name, Call call)
{
  Draw draw;
  Bits bits;
  for (int i = 0; i < 10000; ++i)
  {
    call(draw, bits);
  }
  std::printf("%s %016llx\n", name, static_cast<unsigned long long>(bits.sum()));
}
