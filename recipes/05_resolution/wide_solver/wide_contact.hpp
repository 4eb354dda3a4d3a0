#pragma once

/// \file
/// \brief Contacts and their points, one in every lane of a pack, read from memory and written to
/// it.

#include "05_resolution/islands/contact_constraint.hpp"
#include "common/simd/pack.hpp"

#include <cstddef>

namespace cookbook
{

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

/// How many floats a pack has.
template <class Lanes>
inline constexpr std::size_t lanes_of = sizeof(Lanes) / sizeof(float);

/// Reads number after number from memory, in all lanes.
template <class Lanes>
struct ReadLanes
{
  const float* from; ///< where the next lies

  void operator()(Lanes& number)
  {
    number = load_pack<Lanes>(from);
    from += lanes_of<Lanes>;
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
    to += lanes_of<Lanes>;
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

} // namespace cookbook
