#pragma once

/// \file
/// \brief All contacts of an island at once: Newton's method with an exact factorisation.

#include "05_resolution/direct_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace cookbook
{

// [direct_contact]
/// A contact of an island; its bodies by their numbers in the island, −1 where one is fixed.
struct DirectContact
{
  int a, b;
  const WorldContact* of;
  std::size_t first, end; ///< its points
  double softness;        ///< [1/kg], of each
  std::size_t block;      ///< where the two bodies are coupled
  bool transposed;        ///< whether they are as B and A
};

/// A body of an island.
struct DirectBody
{
  double mass;             ///< [kg]
  Matrix3<double> inertia; ///< [kg m²], world
  Vector6 free;            ///< [m/s, rad/s], after the step if nothing touched it
};
// [direct_contact]

/// Finds the velocities of islands after a step. It remembers how the last island was laid out, and
/// is quicker if the next one hangs together in the same way.
class DirectSolver
{
public:
  // [direct_solve]
  /// Sets the velocities of the bodies of an island, and the impulses of its contacts, to those
  /// after a step [s]. False if they were not found; then nothing has changed.
  bool
  solve(IslandView world, const Island& island, double step, const DirectSettings& settings = {})
  {
    gather(world, island, step, settings);
    if (!lay_out(settings.products))
    {
      return false;
    }
    find_missing();
    guess(2 * step * world.gravity.norm());
    for (used_ = 1; used_ <= settings.iterations; ++used_)
    {
      assemble();
      if (!factor_.factor())
      {
        return false;
      }
      change_ = missing_;
      factor_.solve(change_);
      const bool exact = advance();
      const double most = largest_impulse();
      const double small = std::max(settings.tolerance * most, rounding());
      if ((exact || size_of_missing() <= small) &&
          !moved_bounds(settings.friction_tolerance * most))
      {
        scatter(world, island);
        return true;
      }
    }
    return false;
  }
  // [direct_solve]

  /// How many iterations the last island took.
  int iterations() const { return used_; }

private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void gather(IslandView world, const Island& island, double step, const DirectSettings& settings)
  {
    bodies_.clear();
    velocities_.clear();
    contacts_.clear();
    points_.clear();
    number_.resize(world.bodies.size(), -1);
    for (const int i : island.bodies)
    {
      const RigidBody& body = world.bodies[index(i)];
      number_[index(i)] = static_cast<int>(bodies_.size());
      Vector6 velocity;
      velocity << body.velocity, body.angular_velocity;
      velocities_.push_back(velocity);
      velocity.head<3>() += step * world.gravity;
      bodies_.push_back(
          {1 / body.inverse_mass, body.axes * body.moments.asDiagonal() * body.axes.transpose(),
           velocity});
    }
    for (const int i : island.contacts)
    {
      gather(world, world.contacts[index(i)], step, settings);
    }
    for (const int i : island.bodies)
    {
      number_[index(i)] = -1;
    }
  }

  void
  gather(IslandView world, const WorldContact& contact, double step, const DirectSettings& settings)
  {
    const RigidBody &a = world.bodies[index(contact.a)], &b = world.bodies[index(contact.b)];
    const std::size_t first = points_.size();
    for (const WorldPoint& point : contact.points())
    {
      const double apart = gap(a, b, contact.normal(), point) / step;
      const double opening = std::min(-settings.correction * apart, settings.correction_speed);
      DirectPoint& made = points_.emplace_back();
      made.arm_a = a.axes * point.on_a;
      made.arm_b = b.axes * point.on_b;
      made.bias = apart > 0 ? apart : -opening;
      made.solved = point.solved;
      made.bound = point.impulse > 0 ? contact.friction * point.impulse
                                     : std::numeric_limits<double>::infinity();
    }
    contacts_.push_back(
        {number_[index(contact.a)], number_[index(contact.b)], &contact, first, points_.size(),
         settings.compliance * (a.inverse_mass + b.inverse_mass), 0, false});
  }

  bool lay_out(std::size_t products)
  {
    coupled_.clear();
    for (const DirectContact& contact : contacts_)
    {
      if (contact.a >= 0 && contact.b >= 0)
      {
        coupled_.emplace_back(contact.a, contact.b);
      }
    }
    if (coupled_ != laid_out_ || factor_.size() != bodies_.size())
    {
      factor_.lay_out(static_cast<int>(bodies_.size()), coupled_, products);
      laid_out_ = coupled_;
    }
    if (factor_.products() > products)
    {
      return false;
    }
    for (DirectContact& contact : contacts_)
    {
      if (contact.a >= 0 && contact.b >= 0)
      {
        std::tie(contact.block, contact.transposed) = factor_.coupling(contact.a, contact.b);
      }
    }
    return true;
  }

  // [direct_missing]
  /// Presses all points at the velocities as they are, and finds the impulses [N s, N m s] that are
  /// missing, body by body: those of the contacts less the change of momentum.
  void find_missing()
  {
    missing_.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
      const Vector6 change = bodies_[i].free - velocities_[i];
      missing_[i] << bodies_[i].mass * change.head<3>(), bodies_[i].inertia * change.tail<3>();
    }
    const Vector6 still = Vector6::Zero();
    for (const DirectContact& contact : contacts_)
    {
      const Vector6& a = contact.a >= 0 ? velocities_[index(contact.a)] : still;
      const Vector6& b = contact.b >= 0 ? velocities_[index(contact.b)] : still;
      const Vector3<double>& normal = contact.of->normal();
      Vector6 on_a = still, on_b = still;
      for (std::size_t i = contact.first; i < contact.end; ++i)
      {
        DirectPoint& point = points_[i];
        const Vector3<double> moving = b.head<3>() + b.tail<3>().cross(point.arm_b) - a.head<3>() -
                                       a.tail<3>().cross(point.arm_a);
        press(point, normal, moving, contact.softness);
        const Vector3<double> impulse = point.impulse * normal + point.friction;
        on_a.head<3>() -= impulse;
        on_a.tail<3>() -= point.arm_a.cross(impulse);
        on_b.head<3>() += impulse;
        on_b.tail<3>() += point.arm_b.cross(impulse);
      }
      if (contact.a >= 0)
      {
        missing_[index(contact.a)] += on_a;
      }
      if (contact.b >= 0)
      {
        missing_[index(contact.b)] += on_b;
      }
    }
  }
  // [direct_missing]

  /// Takes all points for pressed that gravity, in one step, could bring to a speed [m/s]: so a
  /// tower stands from the first iteration on, not box upon box.
  void guess(double speed)
  {
    for (DirectPoint& point : points_)
    {
      if (!point.solved && !point.pressed && point.bias <= speed)
      {
        point.pressed = true;
        point.grip = Grip::stick;
      }
    }
  }

  // [direct_assemble]
  /// What impulses a change of velocities takes: masses, and the stiffness of all contacts.
  void assemble()
  {
    factor_.clear();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
      Matrix6& block = factor_.diagonal(static_cast<int>(i));
      block.topLeftCorner<3, 3>().diagonal().setConstant(bodies_[i].mass);
      block.bottomRightCorner<3, 3>() = bodies_[i].inertia;
    }
    for (const DirectContact& contact : contacts_)
    {
      const DirectBlocks blocks = blocks_of(
          std::span(points_).subspan(contact.first, contact.end - contact.first),
          contact.of->normal(), contact.softness);
      if (contact.a >= 0)
      {
        factor_.diagonal(contact.a) += blocks.aa;
      }
      if (contact.b >= 0)
      {
        factor_.diagonal(contact.b) += blocks.bb;
      }
      if (contact.a >= 0 && contact.b >= 0)
      {
        factor_.block(contact.block) +=
            contact.transposed ? Matrix6(blocks.ab.transpose()) : blocks.ab;
      }
    }
  }
  // [direct_assemble]

  // [direct_advance]
  /// Goes along the change to where nothing is missing in its direction; true if that is all of the
  /// way and no point pushes in another way than before, so that the answer is exact.
  bool advance()
  {
    before_ = points_;
    from_ = velocities_;
    const double steep = missing_along_change();
    double low = 0, high = 1, at_low = steep, at_high = 0, part = 1;
    for (int tries = 0; tries < 20; ++tries)
    {
      for (std::size_t i = 0; i < from_.size(); ++i)
      {
        velocities_[i] = from_[i] + part * change_[i];
      }
      find_missing();
      if (part == 1 && pushes_as_before())
      {
        return true;
      }
      const double now = missing_along_change();
      if (std::abs(now) <= 0.2 * std::abs(steep) || (part == 1 && now > 0))
      {
        break;
      }
      (now > 0 ? low : high) = part;
      (now > 0 ? at_low : at_high) = now;
      const double secant = at_low / (at_low - at_high);
      part = low + (high - low) * (tries % 3 == 2 ? 0.5 : std::clamp(secant, 0.01, 0.99));
    }
    return false;
  }
  // [direct_advance]

  /// True if all points push in the way they did before the change, and none slips.
  bool pushes_as_before() const
  {
    return std::equal(
        points_.begin(), points_.end(), before_.begin(),
        [](const DirectPoint& now, const DirectPoint& then)
        { return now.pressed == then.pressed && now.grip == then.grip && now.grip != Grip::slip; });
  }

  double missing_along_change() const
  {
    double sum = 0;
    for (std::size_t i = 0; i < missing_.size(); ++i)
    {
      sum += missing_[i].dot(change_[i]);
    }
    return sum;
  }

  /// How much is missing [N s], as a root of a sum of squares; turns count by the radius of
  /// gyration.
  double size_of_missing() const
  {
    double sum = 0;
    for (std::size_t i = 0; i < missing_.size(); ++i)
    {
      const double squared_radius = bodies_[i].inertia.trace() / bodies_[i].mass;
      sum += missing_[i].head<3>().squaredNorm() +
             missing_[i].tail<3>().squaredNorm() / squared_radius;
    }
    return std::sqrt(sum);
  }

  /// What rounding of the velocities alone leaves missing [N s], at the stiffest contact.
  double rounding() const
  {
    double fastest = 0, stiffest = 0;
    for (const Vector6& velocity : velocities_)
    {
      fastest = std::max(fastest, velocity.head<3>().cwiseAbs().maxCoeff());
    }
    for (const DirectContact& contact : contacts_)
    {
      stiffest = std::max(stiffest, 1 / contact.softness);
    }
    return 8 * std::numeric_limits<double>::epsilon() * fastest * stiffest;
  }

  double largest_impulse() const
  {
    double most = 0;
    for (const DirectPoint& point : points_)
    {
      most = std::max(most, point.impulse);
    }
    return most;
  }

  /// Has friction follow the impulses along the normals; false where none is off by more than a
  /// tolerance [N s].
  bool moved_bounds(double tolerance)
  {
    bool moved = false;
    for (const DirectContact& contact : contacts_)
    {
      for (std::size_t i = contact.first; i < contact.end; ++i)
      {
        DirectPoint& point = points_[i];
        const double size = point.friction.norm();
        point.bound = contact.of->friction * point.impulse;
        const double above = size - point.bound;
        moved = moved || above > tolerance || (point.grip == Grip::slip && -above > tolerance);
      }
    }
    if (moved)
    {
      find_missing();
    }
    return moved;
  }

  void scatter(IslandView world, const Island& island) const
  {
    for (std::size_t i = 0; i < island.bodies.size(); ++i)
    {
      RigidBody& body = world.bodies[index(island.bodies[i])];
      body.velocity = velocities_[i].head<3>();
      body.angular_velocity = velocities_[i].tail<3>();
    }
    std::size_t point = 0;
    for (const int i : island.contacts)
    {
      for (WorldPoint& of : world.contacts[index(i)].points())
      {
        of.impulse = points_[point].impulse;
        of.friction = points_[point].friction;
        of.solved = true;
        ++point;
      }
    }
  }

  int used_ = 0;
  std::vector<int> number_; // of each body of the world in the island
  std::vector<DirectBody> bodies_;
  std::vector<DirectContact> contacts_;
  std::vector<DirectPoint> points_, before_;
  std::vector<Vector6> velocities_, from_, missing_, change_;
  std::vector<std::pair<int, int>> coupled_, laid_out_;
  BlockCholesky factor_;
};

} // namespace cookbook
