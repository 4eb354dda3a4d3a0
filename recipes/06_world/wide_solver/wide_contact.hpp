#pragma once

/// \file
/// \brief Contacts and their points, one in every lane of a pack, and how they lie in memory.

#include "05_resolution/contact_constraint/contact_constraint.hpp"
#include "06_world/lanes/each_number.hpp"

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
  Vector3<Real> normal;  ///< [1], world, from A to B
  Real coefficient;      ///< [1], of friction
  Real correction_speed; ///< [m/s], no overlap is taken away faster; its bodies'
};

/// The numbers of a contact, without those of its bodies, in the order in which they lie in memory.
template <class Real, class Call>
void each_stored(WideContact<Real>& of, Call& call)
{
  each_number(of.normal, call);
  call(of.coefficient);
}

/// The numbers of a point, without its contact's, in the order in which they lie in memory, behind
/// its gap: first what a push changes.
template <class Real, class Call>
void each_pushed(ContactConstraint<Real>& at, Call& call)
{
  call(at.impulse);
  call(at.total_impulse);
  each_number(at.friction, call);
}

/// Then what a turn changes.
template <class Real, class Call>
void each_mass(ContactConstraint<Real>& at, Call& call)
{
  call(at.normal_mass);
  each_number_once(at.sliding.matrix, call);
  call(at.sliding.smallest);
}

/// Then what stays for the whole frame.
template <class Real, class Call>
void each_stored(ContactConstraint<Real>& at, Call& call)
{
  each_number(at.arms.a, call);
  each_number(at.arms.b, call);
  each_number(at.drift, call);
}

inline constexpr std::size_t contact_numbers = 4;    ///< numbers of a contact's each_stored()
inline constexpr std::size_t separation_numbers = 1; ///< a point's gap
inline constexpr std::size_t impulse_numbers = 4;    ///< numbers of each_pushed()
inline constexpr std::size_t point_masses = 5;       ///< numbers of each_mass()
inline constexpr std::size_t point_numbers =
    separation_numbers + impulse_numbers + point_masses + 8; ///< of a point
// [wide_contact]

} // namespace cookbook
