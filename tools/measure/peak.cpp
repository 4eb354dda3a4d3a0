#include "tools/measure/peak.hpp"

#include <stdexcept>
#include <string>

#if defined(__x86_64__)
#define COOKBOOK_TARGET(set) [[gnu::target(set)]]
#else
#define COOKBOOK_TARGET(set)
#endif

namespace cookbook::measure
{
namespace
{

typedef float FourLanes __attribute__((vector_size(16)));
typedef float EightLanes __attribute__((vector_size(32)));
typedef float SixteenLanes __attribute__((vector_size(64)));

constexpr int chains = 12;    // more than a core has under way at once
constexpr int rounds = 10000; // of a run

/// Twelve sums that wait for themselves only; none grows without bound.
template <class Lanes>
[[gnu::always_inline]] inline void multiply_and_add()
{
  Lanes sum[chains];
  float start = 1, part = 0.5f;
  asm volatile("" : "+m"(start), "+m"(part)); // unknown to the compiler from here on
  const Lanes factor = part - Lanes{}, term = start - Lanes{};
  for (int k = 0; k < chains; ++k)
  {
    sum[k] = term * static_cast<float>(k);
  }
  for (int i = 0; i < rounds; ++i)
  {
#pragma GCC unroll 12
    for (int k = 0; k < chains; ++k)
    {
      sum[k] = sum[k] * factor + term;
    }
  }
  Lanes total = sum[0];
  for (int k = 1; k < chains; ++k)
  {
    total += sum[k];
  }
  keep(total);
}

void with_four()
{
  multiply_and_add<FourLanes>();
}

COOKBOOK_TARGET("avx2") void with_eight()
{
  multiply_and_add<EightLanes>();
}

COOKBOOK_TARGET("avx512f") void with_sixteen()
{
  multiply_and_add<SixteenLanes>();
}

} // namespace

Timed peak_flops(std::size_t lanes)
{
  const double flops = 2.0 * chains * rounds * static_cast<double>(lanes);
  const std::string name = "peak, " + std::to_string(lanes) + " lanes";
  switch (lanes)
  {
  case 4:
    return {name, with_four, flops};
  case 8:
    return {name, with_eight, flops};
  case 16:
    return {name, with_sixteen, flops};
  default:
    throw std::invalid_argument("lanes must be 4, 8 or 16, got " + std::to_string(lanes));
  }
}

} // namespace cookbook::measure
