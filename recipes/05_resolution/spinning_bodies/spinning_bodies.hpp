#pragma once

/// \file
/// \brief Bodies that spin freely: Euler's equations in steps that keep the angular momentum.

#include "01_math/turning/rotation_by.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook
{

// [spinning]
/// A body that turns about its centre of mass.
template <class Real>
struct Spinning
{
  Quaternion<Real> orientation;   ///< unit, body to world
  Vector3<Real> angular_velocity; ///< [rad/s], world
};
// [spinning]

// [turned_about]
/// A body that turns, as seen along its own axes.
template <class Real>
struct Tumbling
{
  Quaternion<Real> orientation; ///< unit, body to world
  Vector3<Real> momentum;       ///< angular, along the body's axes, in units of its largest moment
};

/// An axis of a body, and how fast the body turns about it for each unit of momentum along it.
template <class Real>
struct SpinAxis
{
  Eigen::Index index; ///< 0, 1 or 2
  Real rate;          ///< [rad/s] for a unit of momentum
};

/// A body after it has turned about one of its own axes for a time [s]; the momentum along that
/// axis, and so the speed, stays as it is, and the momentum in the world does too.
template <class Real>
Tumbling<Real> turned_about(const Tumbling<Real>& body, const SpinAxis<Real>& axis, Real time)
{
  const Eigen::Index i = axis.index, j = (i + 1) % 3, k = (i + 2) % 3;
  const HalfTurn<Real> half = half_turn<Real>(axis.rate * body.momentum[i] * time);
  const Real cosine = 1 - 2 * half.sine * half.sine, sine = 2 * half.sine * half.cosine;
  Quaternion<Real> turn(half.cosine, 0, 0, 0);
  turn.vec()[i] = half.sine;
  Vector3<Real> momentum = body.momentum;
  momentum[j] = cosine * body.momentum[j] + sine * body.momentum[k];
  momentum[k] = cosine * body.momentum[k] - sine * body.momentum[j];
  return {body.orientation * turn, momentum};
}
// [turned_about]

// [spin_axes]
/// The spin of a body in three parts: about its angular momentum, as if it were a ball of its
/// middle moment, about the axis whose inverse moment differs most from that, and about the third.
template <class Real>
struct SpinAxes
{
  Vector3<Real> moments; ///< in units of the largest, no less than ε
  Real ball_rate;        ///< one over the middle moment
  SpinAxis<Real> main;   ///< by how much its inverse moment differs
  SpinAxis<Real> third;  ///< the same; zero if two moments are equal
};

/// The parts of a body's spin from its moments [kg m²]; those of a ball if none is above zero.
template <class Real>
SpinAxes<Real> spin_axes(const Vector3<Real>& moments)
{
  const Real largest = moments.maxCoeff();
  Vector3<Real> relative = Vector3<Real>::Ones();
  if (largest > Real(0) && largest <= std::numeric_limits<Real>::max())
  {
    relative = (moments / largest).cwiseMax(std::numeric_limits<Real>::epsilon());
  }
  Eigen::Index least = 0, most = 0;
  relative.minCoeff(&least);
  relative.maxCoeff(&most);
  most = most == least ? 2 : most; // of a ball
  const Real ball = 1 / relative[3 - least - most];
  SpinAxis<Real> main{least, 1 / relative[least] - ball};
  SpinAxis<Real> third{most, 1 / relative[most] - ball};
  if (main.rate < -third.rate)
  {
    std::swap(main, third);
  }
  return {relative, ball, main, third};
}
// [spin_axes]

// [turned]
/// A body's own turning for a time [s]: main axis and third in turn, five symmetric shares; R24.
template <class Real>
Tumbling<Real> tumbled(Tumbling<Real> body, const SpinAxes<Real>& axes, Real time)
{
  if (axes.third.rate == Real(0))
  {
    return turned_about<Real>(body, axes.main, time);
  }
  const Real share = Real(0.1931833275037836); // the one with the smallest error
  body = turned_about<Real>(body, axes.third, share * time);
  body = turned_about<Real>(body, axes.main, time / 2);
  body = turned_about<Real>(body, axes.third, (1 - 2 * share) * time);
  body = turned_about<Real>(body, axes.main, time / 2);
  return turned_about<Real>(body, axes.third, share * time);
}

/// The number of parts that a step [s] is cut in, so that the body swings by half a radian at most
/// in each; one, with the third axis left out, where 16 would not do.
template <class Real>
int cut(SpinAxes<Real>& axes, Real momentum, Real step)
{
  const Real swing =
      std::sqrt(std::abs(axes.main.rate * axes.third.rate)) * momentum * std::abs(step);
  if (swing <= Real(8))
  {
    return std::max(1, static_cast<int>(std::ceil(2 * swing)));
  }
  axes.third.rate = 0;
  return 1;
}

/// A body after it has spun freely for a step [s].
template <class Real>
Tumbling<Real> spun(Tumbling<Real> body, SpinAxes<Real> axes, Real step)
{
  const Vector3<Real> whole = body.orientation * body.momentum;
  const int parts = cut(axes, Real(whole.norm()), step);
  for (int part = 0; part < parts; ++part)
  {
    body = tumbled<Real>(body, axes, step / Real(parts));
  }
  const Vector3<Real> ball = (axes.ball_rate * step) * whole;
  return {(rotation_by(ball) * body.orientation).normalized(), body.momentum};
}

/// Whether a body turns evenly for a step [s], as a ball does, or by 1/ε or more.
template <class Real>
bool turns_evenly(const Spinning<Real>& body, const SpinAxes<Real>& axes, Real step)
{
  const Real angle = body.angular_velocity.norm() * std::abs(step);
  return axes.main.rate == Real(0) || !(angle * std::numeric_limits<Real>::epsilon() < Real(1));
}

/// A body that turns evenly after a step [s].
template <class Real>
Spinning<Real> turned_evenly(const Spinning<Real>& body, Real step)
{
  const Quaternion<Real> turn = rotation_by<Real>(step * body.angular_velocity);
  return {(turn * body.orientation).normalized(), body.angular_velocity};
}
/// A body as seen along its own axes; moments in units of the largest.
template <class Real>
Tumbling<Real> tumbling(const Spinning<Real>& body, const Vector3<Real>& moments)
{
  const Vector3<Real> spin = body.orientation.conjugate() * body.angular_velocity;
  return {body.orientation, moments.cwiseProduct(spin)};
}
/// The same body as seen in the world.
template <class Real>
Spinning<Real> spinning(const Tumbling<Real>& body, const Vector3<Real>& moments)
{
  return {body.orientation, body.orientation * body.momentum.cwiseQuotient(moments)};
}

/// A body of these moments [kg m²] after it has spun freely for a step [s]; R24.
///
/// Its angular momentum stays as it is to rounding, whatever the step. Exact where two moments are
/// equal; elsewhere of second order. One that swings too fast for 16 parts of a step turns as if
/// two moments were equal, the closest. A turn of 1/ε or more is none.
template <class Real>
Spinning<Real> turned(const Spinning<Real>& body, const Vector3<Real>& moments, Real step)
{
  const SpinAxes<Real> axes = spin_axes(moments);
  return turns_evenly(body, axes, step)
             ? turned_evenly(body, step)
             : spinning(spun(tumbling(body, axes.moments), axes, step), axes.moments);
}
// [turned]

// [turned_finely]
/// As turned(), in five fractions of the step, the third of them backwards: of fourth order.
template <class Real>
Spinning<Real> turned_finely(Spinning<Real> body, const Vector3<Real>& moments, Real step)
{
  const Real share = Real(0.41449077179437573714); // 1 / (4 - 4^(1/3))
  for (const Real part : {share, share, 1 - 4 * share, share, share})
  {
    body = turned<Real>(body, moments, part * step);
  }
  return body;
}
// [turned_finely]

} // namespace cookbook
