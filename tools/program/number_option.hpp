#pragma once

/// \file
/// \brief Options of a program that are numbers, checked before anything is computed.

#include "tools/files/csv.hpp"
#include "tools/program/program.hpp"

#include <charconv>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace cookbook
{

/// The number that an option was given; std::invalid_argument unless it is one from `least` to
/// `most`.
///
/// Real is double, or int where only whole numbers will do.
template <class Real>
Real number_option(const Arguments& given, const std::string& name, Real least, Real most)
{
  const std::string& text = given.value(name);
  Real value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= least) ||
      !(value <= most))
  {
    const bool whole = std::is_integral_v<Real>;
    throw std::invalid_argument(
        "--" + name + " must be a " + (whole ? "whole " : "") + "number from " +
        round_trip(double(least)) + " to " + round_trip(double(most)) + ", got '" + text + "'");
  }
  return value;
}

} // namespace cookbook
