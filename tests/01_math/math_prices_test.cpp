/// \file
/// What holds for the calls whose prices are compared: they answer the same question.

#include "01_math/math_prices/trial/math_prices.hpp"

#include "tests/catch.hpp"

#include <cmath>

using namespace cookbook;

// [same_question]
TEST_CASE("on 1,000 ordinary inputs the peers answer what our functions answer, to 1e-4")
{
  std::vector<PricedCall> calls = priced_calls();
  std::size_t ours = calls.size(), peers = 0;
  for (std::size_t k = 0; k < calls.size(); ++k)
  {
    if (calls[k].whose.empty())
    {
      ours = k;
      continue;
    }
    ++peers;
    INFO(calls[k].what << " of " << calls[k].whose);
    REQUIRE(calls[k].what == calls[ours].what);
    double apart = 0;
    for (std::size_t i = 0; i < priced_inputs; ++i)
    {
      const std::vector<double> expected = calls[ours].answer(i), answer = calls[k].answer(i);
      REQUIRE(answer.size() == expected.size());
      for (std::size_t j = 0; j < answer.size(); ++j)
      {
        apart = std::max(apart, std::abs(answer[j] - expected[j]));
      }
    }
    CHECK(apart <= 1e-4); // nearly opposite vectors cost the peers digits
  }
  CHECK(peers >= 7); // Eigen's and the library's; GLM's where it is installed
}
// [same_question]
