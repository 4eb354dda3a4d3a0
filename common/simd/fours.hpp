#pragma once

/// \file
/// \brief Packs as fours side by side: rows of four numbers in memory, made columns.

#include "common/simd/pack.hpp"

#include <cstddef>
#include <utility>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi" // as in vector_of.hpp
#endif

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// Of each four of a and the same four of b, in their places 0 to 3 and 4 to 7, these.
template <std::size_t... Places, class Real, std::size_t Width>
Pack<Real, Width> of_fours(const Pack<Real, Width>& a, const Pack<Real, Width>& b)
{
  return [&]<std::size_t... Four>(std::index_sequence<Four...>)
  {
    constexpr std::size_t places[] = {Places...};
    constexpr auto at = [](std::size_t i)
    { return places[i % 4] % 4 + (i - i % 4) + (places[i % 4] < 4 ? 0 : Width); };
    return Pack<Real, Width>::of(shuffled<at(Four)...>(a.lanes, b.lanes));
  }
  (std::make_index_sequence<Width>());
}

/// Four rows of four made columns; in wider packs each four of the rows.
template <class Real, std::size_t Width>
void transpose(Pack<Real, Width> (&rows)[4])
{
  Pack<Real, Width>&a = rows[0], &b = rows[1], &c = rows[2], &d = rows[3];
  const Pack<Real, Width> low_ab = of_fours<0, 4, 1, 5>(a, b);
  const Pack<Real, Width> low_cd = of_fours<0, 4, 1, 5>(c, d);
  const Pack<Real, Width> high_ab = of_fours<2, 6, 3, 7>(a, b);
  const Pack<Real, Width> high_cd = of_fours<2, 6, 3, 7>(c, d);
  a = of_fours<0, 1, 4, 5>(low_ab, low_cd);
  b = of_fours<2, 3, 6, 7>(low_ab, low_cd);
  c = of_fours<0, 1, 4, 5>(high_ab, high_cd);
  d = of_fours<2, 3, 6, 7>(high_ab, high_cd);
}

/// Half the numbers of a pack, from a place on.
template <std::size_t From, class Real, std::size_t Width>
Pack<Real, Width / 2> half(const Pack<Real, Width>& of)
{
  return [&]<std::size_t... I>(std::index_sequence<I...>)
  {
    return Pack<Real, Width / 2>::of(shuffled<From + I...>(of.lanes, of.lanes));
  }
  (std::make_index_sequence<Width / 2>());
}

/// Fours read from where `four(i)` points, i from a first one on, side by side.
template <class P, class Four>
P load_fours(const Four& four, std::size_t first = 0)
{
  constexpr std::size_t width = sizeof(P) / sizeof(*four(first));
  if constexpr (width == 4)
  {
    return load_pack<P>(four(first));
  }
  else
  {
    using Half = Pack<typename PartOf<P>::type, width / 2>;
    const Half low = load_fours<Half>(four, first);
    const Half high = load_fours<Half>(four, first + width / 8);
    return [&]<std::size_t... I>(std::index_sequence<I...>)
    {
      return P::of(shuffled<I...>(low.lanes, high.lanes));
    }
    (std::make_index_sequence<width>());
  }
}

/// Fours written to where `four(i)` points, i from a first one on.
template <class Real, std::size_t Width, class Four>
void store_fours(const Pack<Real, Width>& from, const Four& four, std::size_t first = 0)
{
  if constexpr (Width == 4)
  {
    store_pack(from, four(first));
  }
  else
  {
    store_fours(half<0>(from), four, first);
    store_fours(half<Width / 2>(from), four, first + Width / 8);
  }
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
