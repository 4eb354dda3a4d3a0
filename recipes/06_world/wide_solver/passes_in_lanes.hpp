#pragma once

/// \file
/// \brief What one contact teaches, done to as many at once as a pack has lanes.

#include "06_world/lanes/either_in_lanes.hpp"
#include "06_world/lanes/turn_in_lanes.hpp"
#include "06_world/soft_steps/soft_steps.hpp"
#include "06_world/wide_solver/gather.hpp"
#include "06_world/wide_solver/wide_contact.hpp"
#include "06_world/wide_solver/wide_view.hpp"

#include <algorithm>
#include <cstddef>

namespace cookbook
{

// [passes_in_lanes]
/// Lets `look(contacts, at, numbers)` see every point of a view, a group at a time, and where the
/// point's numbers lie; its bodies are pushed if it is said to.
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
    each_stored(of, read);
    using std::max; // what cannot move has none
    of.correction_speed = max(gather_body(all.bodies, a, of.a), gather_body(all.bodies, b, of.b));
    const SurfaceAxes<Lanes> surface = surface_axes(of.normal);
    for (std::size_t place = here.first; place < here.first + here.points; ++place)
    {
      float* const numbers = all.points + place * lanes * point_numbers;
      ContactConstraint<Lanes> at;
      at.normal = of.normal;
      at.surface = surface;
      at.coefficient = of.coefficient;
      ReadLanes<Lanes> read_point{numbers};
      read_point(at.separation);
      each_pushed(at, read_point);
      each_mass(at, read_point);
      each_stored(at, read_point);
      look(of, at, numbers);
    }
    if (pushes)
    {
      scatter_motion(of.a, all.bodies, a);
      scatter_motion(of.b, all.bodies, b);
    }
  }
}

/// The passes in packs.
template <class Lanes>
struct PassesInLanes
{
  [[gnu::flatten]] static void compute_masses(const WideView& all)
  {
    look_at_each<Lanes>(
        all, false,
        [](const WideContact<Lanes>& of, ContactConstraint<Lanes>& at, float* numbers)
        {
          cookbook::compute_masses<Lanes>(at, of.a, of.b);
          WriteLanes<Lanes> write{
              numbers + lanes_of<Lanes> * (separation_numbers + impulse_numbers)};
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
  solve(const WideView& all, const Softness<float>& spring, float substep, float elapsed, bool last)
  {
    const Softness<Lanes> how{spring.bias_rate, spring.mass_scale, spring.impulse_scale};
    look_at_each<Lanes>(
        all, true,
        [&](WideContact<Lanes>& of, ContactConstraint<Lanes>& at, float* numbers)
        {
          solve_contact<Lanes>(of.a, of.b, at, how, substep, of.correction_speed, elapsed);
          at.total_impulse += last ? at.impulse : Lanes(0);
          WriteLanes<Lanes> write{numbers + lanes_of<Lanes> * separation_numbers};
          each_pushed(at, write);
        });
  }

  [[gnu::flatten]] static void update_separations(const WideView& all, float substep)
  {
    look_at_each<Lanes>(
        all, false,
        [&](const WideContact<Lanes>& of, ContactConstraint<Lanes>& at, float* numbers)
        {
          at.separation += Lanes(substep) * separating_velocity<Lanes>(of.a, of.b, at);
          store_pack(at.separation, numbers);
        });
  }
};

/// All of them.
template <class Lanes>
constexpr WidePasses passes_in_lanes()
{
  using Passes = PassesInLanes<Lanes>;
  return {lanes_of<Lanes>, Passes::compute_masses,     Passes::warm_start,
          Passes::solve,   Passes::update_separations, turn_in_lanes<Doubles<Lanes>>};
}
// [passes_in_lanes]

} // namespace cookbook
