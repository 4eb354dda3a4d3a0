#pragma once

/// \file
/// \brief Where a scene file's joints are read: the kinds of joints are in chapter 7.

#include "06_world/contacts/scene.hpp"
#include "tools/files/json_file.hpp"

#include <string>

namespace cookbook
{

/// Reads a list of joints between the bodies of a scene, and adds them to its constraints; chapter
/// 7, which has the kinds of joints, defines this function in `joints/trial/scene_joints.cpp`.
///
/// A joint is an object with `kind`, and with `a` and `b`, the names of its bodies, or "world" for
/// one of them. The other members are those of \ref ch7_joint_files.
///
/// Throws SceneError for anything else, with the line and the reason.
void read_joints(const JsonValue& list, const std::string& file, Scene& scene);

} // namespace cookbook
