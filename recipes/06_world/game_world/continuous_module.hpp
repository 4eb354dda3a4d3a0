#pragma once

/// \file
/// \brief Continuous collision detection (CCD), as a module of a world.

#include "06_world/game_world/world_state.hpp"
#include "06_world/impacts/toi_solver.hpp"
#include "06_world/sweeps/deep_overlaps.hpp"
#include "06_world/sweeps/predicted_contacts.hpp"

#include <algorithm>
#include <vector>

namespace cookbook
{

// [continuous_module]
/// Makes speculative contacts of what would be too deep at the end of a step, and sweeps what went
/// far or is too deep.
class Continuous : public WorldModule
{
public:
  bool looks_ahead() const override { return true; }

  Box bounds(const WorldState& world, int body) override
  {
    prediction_.resize(world.bodies.size());
    const PredictedStep step = predicted_step(world);
    prediction_[index_of(body)] = cookbook::predict(step, body);
    return predicted_bounds(step, body, contact_margin(world.scene));
  }

  ContactMargins margins(const WorldState& world, int a, int b) override
  {
    return predicted_margins(predicted_step(world), a, b, contact_margin(world.scene));
  }

  /// Resolves the TOI events of the step, and tells all modules what was hit.
  void solved(WorldState& world) override
  {
    StepTrajectories step{world.scene,   world.forces,   world.contacts,
                          world.falls,   world.removed,  world.pair_finder->close_pairs(),
                          trajectories_, displacements_, needs_sweep_};
    const auto is_sphere = [&](const Bounds& bound)
    { return world.bodies[index_of(bound.body)].is_sphere; };
    if (!has_boxes_to_sweep(step, prediction_, world.bodies) &&
        std::none_of(world.bounds.begin(), world.bounds.end(), is_sphere))
    {
      return trajectories_.shrink_to_fit(); // as long as nothing is swept
    }
    step.tree = &world.pair_finder->tree(world.bounds);
    set_trajectories(step, world.bodies);
    std::vector<int> hit;
    std::vector<Impact> unrecorded;
    ToiSolver(step, world.bodies, hit, world.records_impacts ? world.impacts : unrecorded).run();
    trajectories_.clear();
    for (const Cloned<WorldModule>& module : world.modules)
    {
      module->hit(world, hit);
    }
  }

private:
  PredictedStep predicted_step(const WorldState& world)
  {
    return {world.scene, world.bodies, world.forces, prediction_};
  }

  std::vector<Prediction> prediction_;   // where each body goes if nothing pushes it
  std::vector<Trajectory> trajectories_; // room for those of a sweep
  std::vector<double> displacements_;    // [m], how far any point of a body went
  std::vector<bool> needs_sweep_;        // left too deep by a solver, or swept
};
// [continuous_module]

} // namespace cookbook
