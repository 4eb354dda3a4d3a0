#pragma once

/// \file
/// \brief What one contact teaches, done to as many at once as a pack has lanes.

#include "05_resolution/lanes/either_in_lanes.hpp"
#include "05_resolution/lanes/turn_in_lanes.hpp"
#include "05_resolution/soft_steps/soft_steps.hpp"
#include "05_resolution/wide_solver/gather.hpp"
#include "05_resolution/wide_solver/wide_contact.hpp"
#include "05_resolution/wide_solver/wide_view.hpp"

#include <cstddef>

namespace cookbook
{

// [passes_in_lanes]
/// Lets `look(contacts, at, numbers)` see every point of a view, a group at a time, and where the
/// point's numbers lie; whom it pushes is pushed if it is said to.
template <class Lanes, class Look>
void look_at_each(const WideView& all, bool pushes, const Look& look)
{
  constexpr std::size_t lanes = lanes_of<Lanes>;
  for (std::size_t group = 0; group < all.groups.size(); ++group)
  {
    const WideGroup& here = all.groups[group];
    const int* const a = all.a + group * lanes;
    const int* const b = all.b + group * lanes;
    WideContact<Lanes> of;
    ReadLanes<Lanes> read{all.contacts + group * lanes * contact_numbers};
    each_mass(of, read);
    each_given(of, read);
    gather_motion(all.bodies, a, of.a);
    gather_motion(all.bodies, b, of.b);
    for (std::size_t place = here.first; place < here.first + here.points; ++place)
    {
      float* const numbers = all.points + place * lanes * point_numbers;
      ContactConstraint<Lanes> at;
      at.normal = of.normal;
      at.coefficient = of.coefficient;
      ReadLanes<Lanes> read_point{numbers};
      each_pushed(at, read_point);
      each_mass(at, read_point);
      each_given(at, read_point);
      look(of, at, numbers);
    }
    if (pushes)
    {
      scatter_motion(of.a, all.bodies, a);
      scatter_motion(of.b, all.bodies, b);
    }
  }
}

/// Writes what a push has changed at a point.
template <class Lanes>
void write_pushed(ContactConstraint<Lanes>& at, float* numbers)
{
  WriteLanes<Lanes> write{numbers};
  each_pushed(at, write);
}

/// The passes in packs.
template <class Lanes>
struct PassesInLanes
{
  [[gnu::flatten]] static void find_masses(const WideView& all)
  {
    for (std::size_t group = 0; group < all.groups.size(); ++group)
    {
      WideContact<Lanes> of;
      gather_inverse_masses(all.bodies, all.a + group * lanes_of<Lanes>, of.a);
      gather_inverse_masses(all.bodies, all.b + group * lanes_of<Lanes>, of.b);
      WriteLanes<Lanes> write{all.contacts + group * lanes_of<Lanes> * contact_numbers};
      each_mass(of, write);
    }
    look_at_each<Lanes>(
        all, false,
        [](const WideContact<Lanes>& of, ContactConstraint<Lanes>& at, float* numbers)
        {
          cookbook::find_masses<Lanes>(at, of.a, of.b, of.across);
          WriteLanes<Lanes> write{numbers + lanes_of<Lanes> * pushed_numbers};
          each_mass(at, write);
        });
  }

  [[gnu::flatten]] static void warm_start(const WideView& all)
  {
    look_at_each<Lanes>(
        all, true,
        [](WideContact<Lanes>& of, ContactConstraint<Lanes>& at, float*)
        { cookbook::warm_start<Lanes>(of.a, of.b, at); });
  }

  [[gnu::flatten]] static void
  correct(const WideView& all, const Softness<float>& spring, float small)
  {
    const Softness<Lanes> how{spring.bias_rate, spring.mass_scale, spring.impulse_scale};
    look_at_each<Lanes>(
        all, true,
        [&](WideContact<Lanes>& of, ContactConstraint<Lanes>& at, float* numbers)
        {
          cookbook::correct<Lanes>(of.a, of.b, at, how, small, of.correction_speed);
          write_pushed(at, numbers);
        });
  }

  [[gnu::flatten]] static void part(const WideView& all, float small)
  {
    look_at_each<Lanes>(
        all, false,
        [&](const WideContact<Lanes>& of, ContactConstraint<Lanes>& at, float* numbers)
        {
          at.apart += Lanes(small) * parting_speed<Lanes>(of.a, of.b, at);
          write_pushed(at, numbers);
        });
  }
};

/// All of them.
template <class Lanes>
constexpr WidePasses passes_in_lanes()
{
  using Passes = PassesInLanes<Lanes>;
  return {lanes_of<Lanes>, Passes::find_masses, Passes::warm_start,
          Passes::correct, Passes::part,        turn_in_lanes<Doubles<Lanes>>};
}
// [passes_in_lanes]

} // namespace cookbook
