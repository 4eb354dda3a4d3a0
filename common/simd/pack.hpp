#pragma once

/// \file
/// \brief Packs: several numbers in one register, added, multiplied and compared at once.

#include "common/math/vector.hpp"
#include "common/simd/mask.hpp"
#include "common/simd/vector_of.hpp"

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi" // as in vector_of.hpp
#endif

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// `Width` numbers that are computed with as if they were one; `Width` is a power of two.
template <class Real, std::size_t Width>
struct Pack
{
  using Lanes = typename VectorOf<Real, Width>::type;

  Lanes lanes; ///< the numbers

  Pack() = default;
  Pack(Real same) : lanes(spread<Lanes>(same)) {} ///< the same number in every lane

  // Copied as one register: left to itself g++ copies wide packs in pieces.
  Pack(const Pack& other) : lanes(other.lanes) {}
  Pack& operator=(const Pack& other)
  {
    lanes = other.lanes;
    return *this;
  }

  /// The i-th number, i < Width.
  template <std::integral Whole>
  Real operator[](Whole i) const
  {
    return lanes[i];
  }

  /// What a comparison gives: in every lane all bits set, or none.
  struct Mask
  {
    decltype(Lanes{} < Lanes{}) lanes;
  };

  /// A pack made of lanes.
  static Pack of(const Lanes& lanes)
  {
    Pack pack;
    pack.lanes = lanes;
    return pack;
  }

  /// Lanes by their places in a, followed by those of b; as many as there are places.
  template <std::size_t... Places>
  static Pack<Real, sizeof...(Places)> shuffled(const Pack& a, const Pack& b)
  {
    return Pack<Real, sizeof...(Places)>::of(cookbook::shuffled<Places...>(a.lanes, b.lanes));
  }

  /// Of each four lanes of a, places 0 to 3, and the same four of b, places 4 to 7, these.
  template <std::size_t... Places>
  static Pack fours(const Pack& a, const Pack& b)
  {
    return [&]<std::size_t... I>(std::index_sequence<I...>)
    {
      constexpr std::size_t at[] = {Places...};
      return shuffled<(I - I % 4 + at[I % 4] % 4 + (at[I % 4] < 4 ? 0 : Width))...>(a, b);
    }
    (std::make_index_sequence<Width>());
  }

  friend Pack operator+(const Pack& a, const Pack& b) { return of(a.lanes + b.lanes); }
  friend Pack operator-(const Pack& a, const Pack& b) { return of(a.lanes - b.lanes); }
  friend Pack operator*(const Pack& a, const Pack& b) { return of(a.lanes * b.lanes); }
  friend Pack operator/(const Pack& a, const Pack& b) { return of(a.lanes / b.lanes); }
  friend Pack operator-(const Pack& a) { return of(-a.lanes); }
  Pack& operator+=(const Pack& other) { return *this = *this + other; } ///< adds lane by lane
  Pack& operator-=(const Pack& other) { return *this = *this - other; } ///< takes away
  friend Pack max(const Pack& a, const Pack& b) { return select(a > b, a, b); }
  friend Pack min(const Pack& a, const Pack& b) { return select(a < b, a, b); }
  friend Pack abs(const Pack& a) { return copysign(a, Pack(0)); }
  friend Pack copysign(const Pack& size, const Pack& sign)
  {
    using Bits = decltype(Mask::lanes);
    const Bits bit = std::bit_cast<Bits>(-Lanes{});
    return of(std::bit_cast<Lanes>(
        (std::bit_cast<Bits>(size.lanes) & ~bit) | (std::bit_cast<Bits>(sign.lanes) & bit)));
  }
  friend Mask operator<(const Pack& a, const Pack& b) { return {a.lanes < b.lanes}; }
  friend Mask operator<=(const Pack& a, const Pack& b) { return {a.lanes <= b.lanes}; }
  friend Mask operator>(const Pack& a, const Pack& b) { return {a.lanes > b.lanes}; }
  friend Mask operator>=(const Pack& a, const Pack& b) { return {a.lanes >= b.lanes}; }
  friend Mask operator&(const Mask& a, const Mask& b) { return {a.lanes & b.lanes}; }
  friend Mask operator|(const Mask& a, const Mask& b) { return {a.lanes | b.lanes}; }
};

/// A pack is made of plain numbers.
template <class Real, std::size_t Width>
struct PartOf<Pack<Real, Width>>
{
  using type = Real; ///< the number in each lane
};

/// Reads `Width` numbers from memory, aligned or not.
template <class P, class Real>
P load_pack(const Real* from)
{
  P pack;
  std::memcpy(&pack.lanes, from, sizeof(pack.lanes));
  return pack;
}

/// Writes a pack's numbers to memory, aligned or not.
template <class Real, std::size_t Width>
void store_pack(const Pack<Real, Width>& pack, Real* to)
{
  std::memcpy(to, &pack.lanes, sizeof(pack.lanes));
}

/// The lanes of `yes` where the mask is set, those of `no` elsewhere.
template <class Real, std::size_t Width>
Pack<Real, Width> select(
    const typename Pack<Real, Width>::Mask& mask, const Pack<Real, Width>& yes,
    const Pack<Real, Width>& no)
{
  return Pack<Real, Width>::of(picked(mask.lanes, yes.lanes, no.lanes));
}

/// Four packs as rows of four lanes made columns; in wider packs each four of the lanes.
template <class P>
void transpose_fours(P& a, P& b, P& c, P& d)
{
  const P low_ab = P::template fours<0, 4, 1, 5>(a, b),
          low_cd = P::template fours<0, 4, 1, 5>(c, d);
  const P high_ab = P::template fours<2, 6, 3, 7>(a, b);
  const P high_cd = P::template fours<2, 6, 3, 7>(c, d);
  a = P::template fours<0, 1, 4, 5>(low_ab, low_cd);
  b = P::template fours<2, 3, 6, 7>(low_ab, low_cd);
  c = P::template fours<0, 1, 4, 5>(high_ab, high_cd);
  d = P::template fours<2, 3, 6, 7>(high_ab, high_cd);
}

/// The square root of every lane: a loop that becomes one instruction.
template <class Real, std::size_t Width>
Pack<Real, Width> sqrt(const Pack<Real, Width>& a)
{
  Pack<Real, Width> root;
  for (std::size_t i = 0; i < Width; ++i)
  {
    root.lanes[i] = std::sqrt(a.lanes[i]);
  }
  return root;
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace Eigen
{

/// What Eigen needs to know of a pack, so that there are vectors of packs.
template <class Number, std::size_t Width>
struct NumTraits<cookbook::Pack<Number, Width>> : GenericNumTraits<cookbook::Pack<Number, Width>>
{
  using Real = cookbook::Pack<Number, Width>;       ///< its own real part
  using NonInteger = cookbook::Pack<Number, Width>; ///< itself
  using Nested = cookbook::Pack<Number, Width>;     ///< kept in expressions by value
  enum
  {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};

} // namespace Eigen
