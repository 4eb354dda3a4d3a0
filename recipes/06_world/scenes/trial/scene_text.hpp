#pragma once

/// \file
/// \brief The reader's own scene: from a JSON text, with errors by line.

#include "06_world/contacts/scene.hpp"
#include "tools/files/json_file.hpp"

#include <string>

namespace cookbook
{

/// The scene in a JSON text; `file` is named where there is an error, and names the scene.
///
/// The text is an object with `bodies`, and as needed `gravity` [m/s²], `step` [s], `duration` [s],
/// and the `friction` and `restitution` of bodies that name none. A body is an object with `name`
/// and `shape`: "box" with `half_extents` [m], "sphere" with `radius` [m], or "plane" with `normal`
/// and `offset` [m]; boxes and spheres with `mass` [kg], 0: fixed, and as needed `position`,
/// `orientation` (w, x, y, z), `velocity`, `angular_velocity`, `friction`, `restitution`. Lengths
/// of quaternions and normals within a thousandth of one are taken as rounded and set to one.
/// `joints`, where there are some, are read by read_joints().
///
/// Throws SceneError for anything else, with the line and the reason.
Scene scene_in(const std::string& text, const std::string& file);

} // namespace cookbook
