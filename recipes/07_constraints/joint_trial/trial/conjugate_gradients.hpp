#pragma once

/// \file
/// \brief All rigid rows of an island's joints at once, by conjugate gradients; contacts by soft
/// steps.

#include "06_world/soft_steps/soft_steps.hpp"

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace cookbook
{

// [conjugate_gradients]
/// A rigid row and what a push of 1 along it gives its bodies; place 0 is what does not move.
struct JointRow
{
  std::size_t a, b;         ///< one more than the bodies' numbers in the island
  Vector6 on_a, on_b;       ///< J
  Vector6 given_a, given_b; ///< M⁻¹ Jᵀ
};

/// What pushes along all rows give the bodies, a place each: M⁻¹ Jᵀ λ.
inline void
push_all(const std::vector<JointRow>& rows, const Eigen::VectorXd& pushes, std::span<Vector6> given)
{
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const double push = pushes[static_cast<Eigen::Index>(i)];
    given[rows[i].a] += push * rows[i].given_a;
    given[rows[i].b] += push * rows[i].given_b;
  }
}

/// How pushes change the speeds along all rows: J M⁻¹ Jᵀ λ, without the matrix.
inline Eigen::VectorXd speeds_given(
    const std::vector<JointRow>& rows, const Eigen::VectorXd& pushes, std::vector<Vector6>& given)
{
  given.assign(given.size(), Vector6::Zero());
  push_all(rows, pushes, given);
  Eigen::VectorXd speeds(pushes.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const JointRow& row = rows[i];
    speeds[static_cast<Eigen::Index>(i)] = row.on_a.dot(given[row.a]) + row.on_b.dot(given[row.b]);
  }
  return speeds;
}

/// Solves J M⁻¹ Jᵀ λ = b from λ = 0 in so many iterations, or to rounding.
inline Eigen::VectorXd conjugate_gradients(
    const std::vector<JointRow>& rows, std::size_t bodies, const Eigen::VectorXd& right,
    int iterations)
{
  std::vector<Vector6> given(bodies + 1);
  Eigen::VectorXd pushes = Eigen::VectorXd::Zero(right.size());
  Eigen::VectorXd residual = right, direction = right;
  double squared = residual.squaredNorm();
  const double enough = 1e-30 * squared;
  for (int i = 0; i < iterations && squared > enough; ++i)
  {
    const Eigen::VectorXd image = speeds_given(rows, direction, given);
    const double curvature = direction.dot(image);
    if (!(curvature > 0))
    {
      break; // nothing gives way any more
    }
    pushes += squared / curvature * direction;
    residual -= squared / curvature * image;
    const double left = residual.squaredNorm();
    direction = residual + left / squared * direction;
    squared = left;
  }
  return pushes;
}
// [conjugate_gradients]

// [cg_solver]
/// The rows of an island's joints as its bodies are before a substep [s], and the speeds [m/s,
/// rad/s] that each is to be given: against its own, against its error at a rate [1/s], and against
/// its bending for a time [s]. std::logic_error for a row that is not rigid.
struct IslandRows
{
  std::vector<JointRow> rows;
  std::vector<std::size_t> sizes; ///< of each joint
  Eigen::VectorXd speeds;         ///< b
};
inline IslandRows
island_rows(IslandView world, const Island& island, double substep, double rate, double bends)
{
  IslandRows all;
  std::vector<double> speeds;
  for (const int number : island.constraints)
  {
    const ConstraintPair& pair = world.constraints[index_of(number)];
    const RigidBody &a = world.bodies[index_of(pair.a)], &b = world.bodies[index_of(pair.b)];
    const std::size_t before = all.rows.size();
    const auto add = [&](const ConstraintRow& row)
    {
      if (!is_rigid(row))
      {
        throw std::logic_error(
            std::string(world.sets[pair.set]->name()) +
            " have limits, motors or springs: rigid rows alone are solved");
      }
      all.rows.push_back(
          {index_of(number_in(island, pair.a) + 1), index_of(number_in(island, pair.b) + 1), row.a,
           row.b, given_by(a, row.a), given_by(b, row.b)});
      speeds.push_back(
          row.speed - row_speed(row, a.motion, b.motion) - rate * row.error - bends * row.turning);
    };
    world.sets[pair.set]->rows(a, b, pair.number, substep, add);
    all.sizes.push_back(all.rows.size() - before);
  }
  all.speeds = Eigen::VectorXd::Map(speeds.data(), static_cast<Eigen::Index>(speeds.size()));
  return all;
}

/// Pushes the bodies of an island so that its rows lose these speeds; returns the impulses.
inline Eigen::VectorXd
push_island(IslandView world, const Island& island, const IslandRows& all, int iterations)
{
  const std::size_t bodies = island.bodies.size();
  const Eigen::VectorXd pushes = conjugate_gradients(all.rows, bodies, all.speeds, iterations);
  std::vector<Vector6> given(bodies + 1, Vector6::Zero());
  push_all(all.rows, pushes, given);
  for (std::size_t k = 0; k < bodies; ++k)
  {
    Motion<double>& motion = world.bodies[index_of(island.bodies[k])].motion;
    motion.velocity += given[k + 1].head<3>();
    motion.angular_velocity += given[k + 1].tail<3>();
  }
  return pushes;
}

/// How conjugate gradients are run.
struct GradientSettings
{
  int substeps = 6;        ///< in a frame
  int iterations = 20;     ///< in a substep
  double correction = 0.2; ///< [1], fraction of an error that a substep takes away
};

/// Joints by conjugate gradients, contacts as soft steps have them, for run_substeps().
class GradientSteps
{
public:
  static constexpr double rounding = velocity_rounding; ///< [1]

  GradientSteps(IslandView world, const Island& island, const GradientSettings& settings)
      : world_(world), island_(island), settings_(settings)
  {
  }

  int prepare(double step) { return contacts_.prepare(step); }

  void solve(double substep)
  {
    const IslandRows all =
        island_rows(world_, island_, substep, settings_.correction / substep, substep / 2);
    const Eigen::VectorXd pushes = push_island(world_, island_, all, settings_.iterations);
    const double* first = pushes.data();
    std::size_t joint = 0;
    each_constraint(
        world_, island_,
        [&](ConstraintSet& set, int number)
        {
          set.store_rows(number, {first, all.sizes[joint]});
          first += all.sizes[joint++];
        });
    contacts_.solve(substep);
  }

  void relax(double substep) { contacts_.relax(substep); }
  void store() { contacts_.store(); }

private:
  IslandView world_;
  const Island& island_;
  GradientSettings settings_;
  SoftSettings soft_{.substeps = settings_.substeps};
  Island touched_{island_.bodies, island_.contacts}; // without joints
  SoftSteps contacts_{world_, touched_, soft_};
};

/// Moves the bodies of an island on by a step [s].
inline void gradient_steps(
    IslandView world, const Island& island, double step, const GradientSettings& settings)
{
  GradientSteps solver(world, island, settings);
  run_substeps(world, {&island, 1}, step, solver);
}
// [cg_solver]

} // namespace cookbook
