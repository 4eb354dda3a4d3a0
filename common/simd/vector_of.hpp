#pragma once

/// \file
/// \brief Numbers side by side, as packs are made of: the compilers' own vector types, or plain C++
/// with the same results where COOKBOOK_PLAIN is defined.

#include "common/simd/plain_vector.hpp"

#include <cstddef>
#include <type_traits>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi" // what is wider than a register is never passed by value
#endif

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

#if defined(COOKBOOK_PLAIN)

/// `Width` numbers side by side.
template <class Number, std::size_t Width>
struct VectorOf
{
  using type = PlainVector<Number, Width>; ///< the numbers
};

/// The numbers of `yes` where the mask is set, those of `no` elsewhere.
template <class Bits, class Vector>
Vector picked(const Bits& mask, const Vector& yes, const Vector& no)
{
  Vector result{};
  for (std::size_t i = 0; i < sizeof(result.at) / sizeof(result.at[0]); ++i)
  {
    result.at[i] = mask.at[i] != 0 ? yes.at[i] : no.at[i];
  }
  return result;
}

/// Numbers by their places in a, followed by those of b; as many as there are places.
template <std::size_t... Places, class Number, std::size_t Width>
PlainVector<Number, sizeof...(Places)>
shuffled(const PlainVector<Number, Width>& a, const PlainVector<Number, Width>& b)
{
  return {(Places < Width ? a.at[Places % Width] : b.at[Places % Width])...};
}

/// Each number in another type, without a fraction if that has none.
template <class To, class From>
To converted(const From& from)
{
  To result{};
  for (std::size_t i = 0; i < sizeof(from.at) / sizeof(from.at[0]); ++i)
  {
    result.at[i] = static_cast<std::remove_cvref_t<decltype(result.at[i])>>(from.at[i]);
  }
  return result;
}

/// The same number `Width` times.
template <class Vector, class Number>
Vector spread(Number same)
{
  Vector result{};
  for (auto& number : result.at)
  {
    number = same;
  }
  return result;
}

#else

/// `Width` numbers side by side.
template <class Number, std::size_t Width>
struct VectorOf
{
  typedef Number type __attribute__((vector_size(sizeof(Number) * Width))); ///< the numbers
};

/// The numbers of `yes` where the mask is set, those of `no` elsewhere.
template <class Bits, class Vector>
Vector picked(const Bits& mask, const Vector& yes, const Vector& no)
{
  return mask ? yes : no;
}

/// Numbers by their places in a, followed by those of b; as many as there are places.
template <int... Places, class Vector>
auto shuffled(const Vector& a, const Vector& b)
{
  return __builtin_shufflevector(a, b, Places...);
}

/// Each number in another type, without a fraction if that has none.
template <class To, class From>
To converted(const From& from)
{
  return __builtin_convertvector(from, To);
}

/// The same number in each place.
template <class Vector, class Number>
Vector spread(Number same)
{
  return same - Vector{};
}

#endif

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
