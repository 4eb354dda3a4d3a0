#pragma once

/// \file
/// \brief The numbers of vectors and matrices one after the other, read from memory and written to
/// it: in all lanes of a pack, or in one.

#include "common/math/vector.hpp"
#include "common/simd/pack.hpp"

#include <cstddef>

namespace cookbook
{

// [each_number]
/// Calls `call(number)` for each number of a vector or matrix.
template <class Real, int Rows, int Columns, class Call>
void each_number(Eigen::Matrix<Real, Rows, Columns>& of, Call& call)
{
  for (int i = 0; i < Rows * Columns; ++i)
  {
    call(of(i));
  }
}

/// Calls `call(number)` for each number of a symmetric matrix once.
template <class Real, int Size, class Call>
void each_number_once(Eigen::Matrix<Real, Size, Size>& of, Call& call)
{
  for (int i = 0; i < Size; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      call(of(i, j));
      of(j, i) = of(i, j);
    }
  }
}

/// How many numbers a pack has.
template <class Lanes>
inline constexpr std::size_t lanes_of = sizeof(Lanes) / sizeof(typename PartOf<Lanes>::type);

/// Reads number after number from memory, in all lanes.
template <class Lanes>
struct ReadLanes
{
  const typename PartOf<Lanes>::type* from; ///< where the next lies

  void operator()(Lanes& number)
  {
    number = load_pack<Lanes>(from);
    from += lanes_of<Lanes>;
  }
};

/// Writes number after number to memory, in all lanes.
template <class Lanes>
struct WriteLanes
{
  typename PartOf<Lanes>::type* to; ///< where the next lies

  void operator()(const Lanes& number)
  {
    store_pack(number, to);
    to += lanes_of<Lanes>;
  }
};

/// Reads number after number from memory, in one lane of so many.
template <class Number>
struct ReadLane
{
  const Number* from; ///< where the next lies
  std::size_t lanes;  ///< how far it is from there to the one after it

  void operator()(Number& number)
  {
    number = *from;
    from += lanes;
  }
};

/// Writes number after number to memory, in one lane of so many.
template <class Number>
struct WriteLane
{
  Number* to;        ///< where the next lies
  std::size_t lanes; ///< how far it is from there to the one after it

  void operator()(double number)
  {
    *to = static_cast<Number>(number);
    to += lanes;
  }
};
// [each_number]

} // namespace cookbook
