#pragma once

/// \file
/// \brief The chapter's functions that have no chart of their own, and their peers, on ordinary
/// input.

#include "01_math/transforms/transforms.hpp"
#include "common/math/vector.hpp"
#include "tools/measure/timing.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

// [ordinary_inputs]
/// What the timed functions are given: drawn at random, the same ones every time.
struct Ordinary
{
  Vector3<float> a, b, axis; ///< [1], unit
  Quaternion<float> p, q;    ///< [1], unit, less than half a turn apart
  Matrix3<float> m;          ///< [1], turned, and stretched by half to twice along each axis
  Isometry3<float> pose;     ///< [m], within 10 of the origin
  float angle;               ///< [rad], up to 20 either way
};
// [ordinary_inputs]

/// A call that is timed, of our own or of a peer.
struct PricedCall
{
  std::string what;     ///< what is computed, by the name of our function
  std::string whose;    ///< empty where it is ours, else the peer
  measure::Timed timed; ///< the call on the whole workload
  std::function<std::vector<double>(std::size_t)>
      answer; ///< the numbers that it answers to an input
};

/// How many inputs each call is timed on.
constexpr std::size_t priced_inputs = 1000;

/// All calls; those that compute the same stand one after the other, ours first.
std::vector<PricedCall> priced_calls();

} // namespace cookbook
