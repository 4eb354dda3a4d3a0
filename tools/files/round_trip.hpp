#pragma once

/// \file
/// \brief Numbers as texts with all their digits.

#include <string>

namespace cookbook
{

/// The shortest text that reads back as the same number; zero has no sign.
std::string round_trip(double value);

/// The shortest text that reads back as the same number; zero has no sign.
std::string round_trip(float value);

} // namespace cookbook
