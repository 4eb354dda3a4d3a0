#pragma once

/// \file
/// \brief Runs of scenes with solvers by name, measured; compiled once for programs and tests.

#include "06_world/scenes/trial/frames.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

class GameWorld;
struct SoftSettings;
struct WidePasses;

/// How a scene is to be run.
struct RunSettings
{
  std::string solver = "direct";                 ///< by name
  int substeps = 0;                              ///< 0: what the solver takes itself
  double duration = -1;                          ///< [s]; less than zero: the scene's
  bool may_sleep = false;                        ///< whether bodies that rest are left out
  bool keeps_frames = false;                     ///< whether each step is kept as a frame
  std::function<void(GameWorld&)> before_step{}; ///< if given, may push and remove bodies
};

/// What came of it.
struct WorldRun
{
  std::vector<Frame> frames; ///< the first, and one a step or only the last
  double overlap = 0;        ///< [m], the deepest at the end
  double deepest = 0;        ///< [m], the deepest at any time
  bool joined = false;       ///< whether there are joints
  double joints_open = 0;    ///< [m], the farthest that a joint is open at any time
  double joints_turned = 0;  ///< [rad], the same about an axis
  double drift = 0;          ///< [m], the farthest that a body is across gravity at the end
  double sink = 0;           ///< [m], the farthest that a body is up or down at the end
  double energy_start = 0;   ///< [J]
  double energy_end = 0;     ///< [J]
  double energy_most = 0;    ///< [J], at any time
  Vector3<double> momentum;  ///< [kg m/s], at the end
  double residual = 0;       ///< [m/s], at the end
  std::size_t asleep = 0;    ///< bodies that sleep at the end
  double time = 0;           ///< [s], of the clock, a body and step
  double longest_step = 0;   ///< [s], of the clock, a body
};

/// Runs a scene; `observer`, if given, hears after each step how many are done.
///
/// Throws InvalidScene, TooManyContacts, or std::invalid_argument for a solver that there is not.
WorldRun run_world(
    const Scene& scene, const RunSettings& settings = {},
    const std::function<void(std::size_t)>& observer = {});

/// A world under wide steps by these passes, in registers of their width.
GameWorld wide_world(const Scene& scene, const WidePasses& passes, const SoftSettings& how);

/// The impulses [N s] that each body gets from all contacts with bodies before it in the scene,
/// along gravity, at the end of a run of so many steps: what carries it.
std::vector<double> warm_start_impulse(const Scene& scene, const std::string& solver, int steps);

/// How many steps a scene has.
std::size_t steps_of(const Scene& scene, double duration);

/// The bodies of a scene that touch as it starts, in pairs.
std::vector<std::pair<int, int>> touching_pairs(const Scene& scene);

/// A world that is only stepped, and asked in the end.
class SteppedWorld
{
public:
  /// A scene under a solver by name, with so many substeps, or its own number of them, 0.
  SteppedWorld(const Scene& scene, const std::string& solver, int substeps);

  void step();                                    ///< goes on by a step
  Frame frame() const;                            ///< as it is now
  double deepest_overlap() const;                 ///< [m]
  std::vector<double> warm_start_impulse() const; ///< [N s], as above

private:
  std::shared_ptr<GameWorld> world_;
};

} // namespace cookbook
