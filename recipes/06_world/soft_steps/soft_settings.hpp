#pragma once

/// \file
/// \brief How soft steps are run.

namespace cookbook
{

// [soft_settings]
/// How soft steps are run.
struct SoftSettings
{
  int substeps = 4;         ///< small steps in a frame, one or more
  double frequency = 0.125; ///< [1], of the contacts' springs, as a fraction of the substeps' rate
  double damping_ratio = 5; ///< [1], of the springs
  double correction_speed = 1;     ///< [m/s], no overlap is taken away faster
  double anchor_lag = 0.07;        ///< [rad], by which a cube may turn slowly and keep its arms
  double torsional_radius = 0.002; ///< [1], the radius of a corner, as a fraction of its arm
};
// [soft_settings]

} // namespace cookbook
