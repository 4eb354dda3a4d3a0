#pragma once

/// \file
/// \brief Columns of spheres that cannot lean: contacts that change each other, and nothing else.

#include "05_resolution/contact_constraint/contact_constraint.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cookbook
{

// [column]
/// Spheres of 1 m one on top of the other; contact i is below sphere i, which is body i + 1.
template <class Real>
struct Column
{
  std::vector<Body<Real>> bodies; ///< the ground first
  std::vector<ContactConstraint<Real>> contacts;
};

/// One pass: each contact in turn gets the impulse that stops its surfaces; R7.
template <class Real>
void solve_once(Column<Real>& column)
{
  for (std::size_t i = 0; i < column.contacts.size(); ++i)
  {
    Body<Real>&a = column.bodies[i], &b = column.bodies[i + 1];
    ContactConstraint<Real>& contact = column.contacts[i];
    add_impulse<Real>(a, b, contact, -contact.normal_mass * separating_velocity(a, b, contact));
  }
}

/// A frame in which gravity gives each sphere a velocity [m/s], and then some passes.
template <class Real>
void solve_frame(Column<Real>& column, const Real& fall, int passes, bool warm)
{
  for (std::size_t i = 0; i < column.contacts.size(); ++i)
  {
    column.bodies[i + 1].motion.velocity.y() -= fall;
    if (!warm)
    {
      column.contacts[i].impulse = Real(0);
    }
    warm_start<Real>(column.bodies[i], column.bodies[i + 1], column.contacts[i]);
  }
  for (int pass = 0; pass < passes; ++pass)
  {
    solve_once(column);
  }
}
// [column]

/// A column of spheres of some masses [kg], from the ground up, at rest.
template <class Real>
Column<Real> column_of(const std::vector<Real>& masses)
{
  using Vector = Vector3<Real>;
  const Real radius = Real(1) / Real(2);
  const Vector up = Vector::UnitY();
  Column<Real> column{{static_body<Real>(-radius * up)}, {}};
  for (std::size_t i = 0; i < masses.size(); ++i)
  {
    const Vector center = (Real(int(i)) + radius) * up;
    column.bodies.push_back(
        {{center, Vector::Zero(), Vector::Zero()}, Real(1) / masses[i], Matrix3<Real>::Zero()});
    ContactConstraint<Real> contact{};
    contact.normal = up;
    contact.surface = {Vector::UnitX(), Vector::UnitZ()};
    contact.arms = {radius * up, -radius * up};
    contact.impulse = Real(0);
    contact.friction.setZero();
    contact.normal_mass = effective_mass<Real>(
        inverse_mass_at<Real>(column.bodies[i], column.bodies[i + 1], up, contact.arms));
    column.contacts.push_back(contact);
  }
  return column;
}

/// The impulses [N s] that carry a column in which gravity gives each sphere a velocity [m/s]: at
/// each contact the weight of all that is above; R9.
template <class Real>
std::vector<Real> carrying_impulses(const std::vector<Real>& masses, const Real& fall)
{
  std::vector<Real> impulses(masses.size());
  Real above(0);
  for (std::size_t i = masses.size(); i-- > 0;)
  {
    above += masses[i];
    impulses[i] = fall * above;
  }
  return impulses;
}

/// The largest error of a column's impulses, as a fraction of what each ought to be.
template <class Real>
Real impulse_error(const Column<Real>& column, const std::vector<Real>& right)
{
  using std::abs;
  Real largest(0);
  for (std::size_t i = 0; i < right.size(); ++i)
  {
    largest = std::max(largest, Real(abs(column.contacts[i].impulse - right[i]) / right[i]));
  }
  return largest;
}

/// The errors of a column's impulses after one pass, two, and so on, without warm starting, until
/// one is below a fraction or there are as many as asked for.
inline std::vector<double>
errors_by_pass(const std::vector<double>& masses, double least, std::size_t most)
{
  Column<double> column = column_of(masses);
  const std::vector<double> right = carrying_impulses(masses, 1.0);
  solve_frame(column, 1.0, 1, false);
  std::vector<double> errors{impulse_error(column, right)};
  while (errors.back() > least && errors.size() < most)
  {
    solve_once(column);
    errors.push_back(impulse_error(column, right));
  }
  return errors;
}

/// How many passes a column needs until its impulses are right to a fraction; R8.
inline int passes_needed(const std::vector<double>& masses, double error)
{
  return static_cast<int>(errors_by_pass(masses, error, 1000000).size());
}

/// The velocity [m/s] at which the top of a column of 1 kg spheres goes down after each frame.
inline std::vector<double> sink_velocities(std::size_t count, int passes, int frames, bool warm)
{
  Column<double> column = column_of(std::vector<double>(count, 1.0));
  std::vector<double> velocities;
  for (int i = 0; i < frames; ++i)
  {
    solve_frame(column, 9.81 / 60, passes, warm);
    velocities.push_back(-column.bodies.back().motion.velocity.y());
  }
  return velocities;
}

} // namespace cookbook
