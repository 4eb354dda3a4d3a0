#pragma once

/// \file
/// \brief The ladder of worlds beyond step 7: each branch on scenes that step 7 fails, and scenes
/// in which both worlds agree.

#include "05_resolution/small_world/trial/rung.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace cookbook
{

/// The branches of the ladder: step 7 of the small world below, GameWorld here.
std::vector<Rung> branch_rungs();

/// A scene in both worlds: step 7 of the small world, and GameWorld under soft steps.
struct Agreement
{
  std::string scene; ///< in a few words
  double time;       ///< [s], after which the two are compared
  bool rests;        ///< whether its bodies lie still by then
  double moved;      ///< [m], the farthest that a body is from where it began, in GameWorld
  double separation; ///< [m], the farthest that a body of one world is from the same of the other
};

/// Ten scenes in both worlds.
std::vector<Agreement> agreements();

/// How far apart [m] a body may be: 1 mm where it rests, half a percent of how far it has moved
/// otherwise.
inline double allowed(const Agreement& one)
{
  return one.rests ? 0.001 : 0.005 * one.moved;
}

// [shared_functions]
/// A function that both worlds call, and the headers in which they do, under recipes/.
struct SharedFunction
{
  std::string name;
  std::string of_step_7;
  std::string of_game_world;
};

/// Those of a contact, a bounce and a body.
inline std::vector<SharedFunction> shared_functions()
{
  const std::string step = "05_resolution/small_world/step_7.hpp";
  const std::string body = "05_resolution/small_world/small_body.hpp";
  const std::string soft = "06_world/soft_steps/soft_steps.hpp";
  const std::string rigid = "06_world/contacts/rigid_body.hpp";
  return {
      {"solve_contact", step, soft},
      {"softness", step, soft},
      {"warm_start", step, soft},
      {"surface_axes", step, "06_world/islands/island_points.hpp"},
      {"rebound_speed", step, "06_world/islands/simultaneous_impacts.hpp"},
      {"impact_speed", step, "06_world/impacts/impact.hpp"},
      {"restitution_threshold", step, "06_world/body/external_acceleration.hpp"},
      {"fastest_point", step, "06_world/sleeping/sleeping.hpp"},
      {"dynamic_body", body, "06_world/contacts/start_body.hpp"},
      {"solid_box", body, "06_world/shapes/box_shape.hpp"},
      {"world_inverse_inertia", body, rigid},
      {"rotation_by", body, "06_world/contacts/integrate_body.hpp"}};
}

/// Whether a header, under recipes/, calls a function.
bool calls(const std::string& header, const std::string& function);
// [shared_functions]

// [lines_taken]
/// What a rung takes in lines, rounded to hundreds, and the headers that are taken for it.
struct LinesTaken
{
  std::string rung;
  int lines;
  std::vector<std::string> headers; ///< under recipes/
};

/// Of each rung.
inline std::vector<LinesTaken> lines_taken()
{
  const std::string step = "05_resolution/small_world/step_";
  const std::string world = "06_world/game_world/game_world.hpp";
  const std::string soft = "06_world/soft_steps/soft_steps.hpp";
  return {
      {"1", 1300, {step + "1.hpp"}},
      {"2", 1300, {step + "2.hpp"}},
      {"3", 1400, {step + "3.hpp"}},
      {"4", 1400, {step + "4.hpp"}},
      {"5", 1500, {step + "5.hpp"}},
      {"6", 1700, {step + "6.hpp"}},
      {"7", 1800, {step + "7.hpp"}},
      {"direct", 18700, {world, "06_world/game_world/direct_or_soft.hpp"}},
      {"SIMD", 18000, {world, "06_world/wide_solver/wide_solver.hpp"}},
      {"anchors", 16600, {world, soft}},
      {"sweeps", 16600, {world, soft}},
      {"queries",
       18300,
       {world, soft, "06_world/game_world/world_queries.hpp",
        "06_world/contact_events/contact_events.hpp"}}};
}

/// How many lines a game takes with these headers, each file of the book once.
std::size_t lines_to_take(const std::vector<std::string>& headers);
// [lines_taken]

} // namespace cookbook
