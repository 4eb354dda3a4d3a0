/// \file
/// Each kind of shape with each other: random pairs, and what the book answers of them.
#pragma once

#include "02_primitives/closest_points/closest_points.hpp"
#include "02_primitives/overlaps/overlaps.hpp"

#include "tests/02_primitives/shape_oracle.hpp"
#include "tests/02_primitives/shapes_moved.hpp"

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace cookbook
{

/// One pair: what the oracle knows of both shapes, and what the book answers.
struct CheckedPair
{
  OracleShape a, b;
  ClosestPoints<Long, 3> points;
  bool overlap;         ///< the answer of overlaps()
  bool still_separated; ///< also after B moved towards A by the distance less a billionth
  Long touch; ///< their distance after B moved by the whole distance, as a fraction of the size
};

/// Answers a pair; where the shapes are apart, once more with B moved almost to A, and to A.
template <class Real, class A, class B>
CheckedPair answered(const A& a, const B& b)
{
  const ClosestPoints<Real, 3> points = closest_points(a, b);
  CheckedPair pair{as_oracle(a), as_oracle(b), exactly(points), overlaps(a, b), true, 0};
  if constexpr (std::is_same_v<Real, double>)
  {
    const double size = double(size_of_numbers(pair.a, pair.b));
    if (points.distance > 1e-3 * size)
    {
      const Vector3<double> difference = points.a - points.b;
      const Vector3<double> short_of_it = difference * (1e-9 * size / points.distance);
      pair.still_separated = !overlaps(a, moved(b, Vector3<double>(difference - short_of_it)));
      pair.touch = Long(closest_points(a, moved(b, difference)).distance / size);
    }
  }
  return pair;
}

/// Two kinds of shapes, and how a pair of them is drawn and answered.
template <class Real>
struct Kinds
{
  std::string names;
  std::function<CheckedPair(ShapeDraw<Real>&)> answer;
};

/// Each kind with itself and each that comes after it.
template <class Real>
std::vector<Kinds<Real>> all_kinds()
{
  std::vector<Kinds<Real>> kinds;
  int first = 0;
  const auto with_first = [&](const auto& a, const char* of_a)
  {
    int second = 0;
    const auto with_second = [&](const auto& b, const char* of_b)
    {
      using A = std::decay_t<decltype(a)>;
      using B = std::decay_t<decltype(b)>;
      if (second++ >= first)
      {
        const auto answer = [](ShapeDraw<Real>& from)
        {
          const A one = drawn<A>(from);
          const B other = drawn<B>(from);
          return answered<Real>(one, other);
        };
        kinds.push_back({std::string(of_a) + " and " + of_b, answer});
      }
    };
    for_each_kind<Real>(with_second);
    ++first;
  };
  for_each_kind<Real>(with_first);
  return kinds;
}

constexpr Draws all_draws[] = {Draws::any,  Draws::lattice, Draws::thin,  Draws::tiny,
                               Draws::huge, Draws::distant, Draws::unlike};

/// What was wrong with any of many pairs of two kinds.
struct Wrongs
{
  Long fault = 0;         ///< as a fraction of the size
  int overlapping = 0;    ///< that overlap
  int contradictions = 0; ///< distance 0, but no overlap, or an overlap without
  int moved_wrongly = 0;  ///< not apart after B moved less than the distance
  Long touch = 0;         ///< the distance after B moved by the distance
};

/// Draws pairs of two kinds, and checks the answers.
template <class Real>
Wrongs check_pairs(const Kinds<Real>& kinds, Draws draws, int count)
{
  ShapeDraw<Real> from(7);
  from.use(draws);
  Wrongs wrongs;
  for (int i = 0; i < count; ++i)
  {
    const CheckedPair pair = kinds.answer(from);
    wrongs.fault = std::max(wrongs.fault, fault(pair.a, pair.b, pair.points));
    wrongs.overlapping += pair.overlap;
    wrongs.contradictions += pair.overlap != (pair.points.distance == 0);
    wrongs.moved_wrongly += !pair.still_separated;
    wrongs.touch = std::max(wrongs.touch, pair.touch);
  }
  return wrongs;
}

} // namespace cookbook
