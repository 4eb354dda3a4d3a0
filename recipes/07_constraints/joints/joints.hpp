#pragma once

/// \file
/// \brief All kinds of joints of this chapter between two bodies of a world.

// [joints]
#include "06_world/ball_joint/ball_joint.hpp"
#include "07_constraints/ball_limits/ball_limits.hpp"
#include "07_constraints/breaking/breaking.hpp"
#include "07_constraints/distance/distance.hpp"
#include "07_constraints/hinge/hinge.hpp"
#include "07_constraints/mouse/mouse.hpp"
#include "07_constraints/slider/slider.hpp"
#include "07_constraints/weld/weld.hpp"
#include "07_constraints/wheel/wheel.hpp"
// [joints]
