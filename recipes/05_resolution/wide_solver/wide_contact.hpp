#pragma once

/// \file
/// \brief Contacts and their points, one in every lane of a pack, read from memory and written to
/// it.

#include "05_resolution/islands/contact_constraint.hpp"
#include "05_resolution/wide_solver/lane_body.hpp"
#include "common/simd/fours.hpp"

#include <array>
#include <cstddef>

namespace cookbook
{

// [either]
/// In every lane the number of the first, if a test says so there; otherwise that of the second.
template <class Real, std::size_t Width, class Second>
Pack<Real, Width> either(
    const typename Pack<Real, Width>::Mask& first, const Pack<Real, Width>& yes,
    const Second& second)
{
  return all(first) ? yes : select(first, yes, Pack<Real, Width>(second()));
}

/// The same for each number of a vector or matrix.
template <class Real, std::size_t Width, int Rows, int Columns, class Second>
Eigen::Matrix<Pack<Real, Width>, Rows, Columns> either(
    const typename Pack<Real, Width>::Mask& first,
    const Eigen::Matrix<Pack<Real, Width>, Rows, Columns>& yes, const Second& second)
{
  Eigen::Matrix<Pack<Real, Width>, Rows, Columns> chosen = yes;
  if (!all(first))
  {
    const Eigen::Matrix<Pack<Real, Width>, Rows, Columns> no = second();
    for (int i = 0; i < yes.size(); ++i)
    {
      chosen(i) = select(first, yes(i), no(i));
    }
  }
  return chosen;
}
// [either]

// [wide_contact]
/// What the points of contacts have in common, one contact in every lane.
template <class Real>
struct WideContact
{
  Body<Real> a;          ///< the bodies A, as far as a push changes them
  Body<Real> b;          ///< the bodies B
  Vector3<Real> across;  ///< [1], world, a direction of each surface
  Real correction_speed; ///< [m/s], no overlap is taken away faster
};

/// Calls `call(number)` for each number of a vector or matrix.
template <class Real, int Rows, int Columns, class Call>
void each_number(Eigen::Matrix<Real, Rows, Columns>& of, Call& call)
{
  for (int i = 0; i < Rows * Columns; ++i)
  {
    call(of(i));
  }
}

/// The numbers of a contact, in the order in which they lie in memory: first what a turn changes.
template <class Real, class Call>
void each_mass(WideContact<Real>& of, Call& call)
{
  for (Body<Real>* const body : {&of.a, &of.b})
  {
    call(body->inverse_mass);
    each_number(body->inverse_inertia, call);
  }
}

/// Then what stays for the whole frame.
template <class Real, class Call>
void each_given(WideContact<Real>& of, Call& call)
{
  each_number(of.across, call);
  call(of.correction_speed);
}

/// The numbers of a point, in the order in which they lie in memory: first what a push changes.
template <class Real, class Call>
void each_pushed(ContactConstraint<Real>& at, Call& call)
{
  call(at.apart);
  call(at.impulse);
  each_number(at.friction, call);
}

/// Then what a turn changes.
template <class Real, class Call>
void each_mass(ContactConstraint<Real>& at, Call& call)
{
  call(at.normal_mass);
  each_number(at.sliding.ending, call);
  call(at.sliding.least);
}

/// Then what stays for the whole frame.
template <class Real, class Call>
void each_given(ContactConstraint<Real>& at, Call& call)
{
  each_number(at.normal, call);
  each_number(at.arms.a, call);
  each_number(at.arms.b, call);
  call(at.coefficient);
}

inline constexpr std::size_t contact_masses = 20;                  ///< numbers of each_mass()
inline constexpr std::size_t contact_numbers = contact_masses + 4; ///< all of a contact
inline constexpr std::size_t pushed_numbers = 5;                   ///< numbers of each_pushed()
inline constexpr std::size_t point_masses = 11;                    ///< numbers of each_mass()
inline constexpr std::size_t point_numbers = pushed_numbers + point_masses + 10; ///< all of a point

/// Reads number after number from memory, in all lanes.
template <class Lanes>
struct ReadLanes
{
  const float* from; ///< where the next lies

  void operator()(Lanes& number)
  {
    number = load_pack<Lanes>(from);
    from += sizeof(Lanes) / sizeof(float);
  }
};

/// Writes number after number to memory, in all lanes.
template <class Lanes>
struct WriteLanes
{
  float* to; ///< where the next lies

  void operator()(const Lanes& number)
  {
    store_pack(number, to);
    to += sizeof(Lanes) / sizeof(float);
  }
};

/// Reads number after number from memory, in one lane of so many.
struct ReadLane
{
  const float* from; ///< where the next lies
  std::size_t lanes; ///< how far it is from there to the one after it

  void operator()(float& number)
  {
    number = *from;
    from += lanes;
  }
};

/// Writes number after number to memory, in one lane of so many.
struct WriteLane
{
  float* to;         ///< where the next lies
  std::size_t lanes; ///< how far it is from there to the one after it

  void operator()(double number)
  {
    *to = static_cast<float>(number);
    to += lanes;
  }
};
// [wide_contact]

// [gather]
/// The same row of four numbers of a body for each lane, as columns: the first of each, the second,
/// …
template <class Lanes, class Row>
std::array<Lanes, 4> gathered(LaneBody* bodies, const int* of, const Row& row)
{
  Lanes rows[4];
  for (std::size_t i = 0; i < 4; ++i)
  {
    rows[i] = load_fours<Lanes>(
        [&](std::size_t four) -> const float* { return row(bodies[of[4 * four + i]]); });
  }
  transpose(rows);
  return {rows[0], rows[1], rows[2], rows[3]};
}

/// How the bodies of all lanes move now.
template <class Lanes>
void gather_motion(LaneBody* bodies, const int* of, Body<Lanes>& to)
{
  const auto v = gathered<Lanes>(bodies, of, [](LaneBody& body) { return body.velocity; });
  const auto w = gathered<Lanes>(bodies, of, [](LaneBody& body) { return body.angular_velocity; });
  to.motion.velocity = {v[0], v[1], v[2]};
  to.motion.angular_velocity = {w[0], w[1], w[2]};
}

/// How much a push changes each of them.
template <class Lanes>
void gather_inverse_masses(LaneBody* bodies, const int* of, Body<Lanes>& to)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto column =
        gathered<Lanes>(bodies, of, [i](LaneBody& body) { return body.inertia[i]; });
    to.inverse_inertia.col(i) = Vector3<Lanes>(column[0], column[1], column[2]);
    if (i == 0)
    {
      to.inverse_mass = column[3];
    }
  }
}

/// Puts three numbers of the bodies of all lanes back.
template <class Lanes, class Row>
void scatter(const Vector3<Lanes>& from, LaneBody* bodies, const int* of, const Row& row)
{
  Lanes rows[] = {from.x(), from.y(), from.z(), Lanes(0)};
  transpose(rows);
  for (std::size_t i = 0; i < 4; ++i)
  {
    store_fours(rows[i], [&](std::size_t four) { return row(bodies[of[4 * four + i]]); });
  }
}

/// Puts back how they move.
template <class Lanes>
void scatter_motion(const Body<Lanes>& from, LaneBody* bodies, const int* of)
{
  scatter(from.motion.velocity, bodies, of, [](LaneBody& body) { return body.velocity; });
  scatter(
      from.motion.angular_velocity, bodies, of,
      [](LaneBody& body) { return body.angular_velocity; });
}
// [gather]

} // namespace cookbook
