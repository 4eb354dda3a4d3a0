/// \file
/// Catch2, whichever of its versions 2 and 3 is installed, by the names of version 3.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
namespace Catch
{
using Detail::Approx;
namespace Matchers
{
inline auto ContainsSubstring(const std::string& text)
{
  return Contains(text);
}
} // namespace Matchers

/// Version 3 has its matchers in Matchers alone. Without this, Catch::Contains and its like would
/// compile here, and not there.
struct InMatchers;
void Contains(InMatchers), StartsWith(InMatchers), EndsWith(InMatchers), Equals(InMatchers),
    WithinAbs(InMatchers), WithinRel(InMatchers), Matches(InMatchers);
} // namespace Catch
#endif
