#pragma once

/// \file
/// \brief A software picture: boxes, spheres, a floor with shadows, lines and arrows, by the
/// chapter's own camera.

// [headers]
#include "02_primitives/picture/canvas.hpp"
#include "02_primitives/picture/draw_flat.hpp"
#include "02_primitives/picture/draw_ground.hpp"
#include "02_primitives/picture/draw_marks.hpp"
#include "02_primitives/picture/draw_round.hpp"
#include "02_primitives/picture/orbit.hpp"
#include "02_primitives/picture/picture_file.hpp"
// [headers]
