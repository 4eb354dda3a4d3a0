#pragma once

/// \file
/// \brief Scenes that break some way to keep depths, or to leave out boxes.

#include "02_primitives/camera/camera.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

/// Two points ahead that a depth buffer has to tell apart.
struct DepthCase
{
  std::string what;             ///< in a few words
  float nearer, farther;        ///< [m] ahead
  float near_plane = 0.1f;      ///< [m], of the near plane
  float far_plane = 100'000.0f; ///< [m], of the far plane, where there is one
};

/// Pairs of points to tell apart.
inline std::vector<DepthCase> depth_cases()
{
  return {
      {"1 cm apart at 10 m", 10, 10.01f},
      {"1 m apart at 1 km", 1000, 1001},
      {"100 m apart at 50 km", 50'000, 50'100},
      {"the same, near plane at 10 m", 50'000, 50'100, 10},
      {"1 m apart at 1 km, near plane at 0", 1000, 1001, 0}};
}

/// A way to make depths, by name.
struct DepthMethod
{
  std::string name;                                      ///< as on the page
  std::optional<Matrix4<float>> (*matrix)(float, float); ///< of the near and the far plane
};

/// The perspective with depths 0…1, without any question whether there is one.
inline std::optional<Matrix4<float>> perspective_unasked(float near_plane, float far_plane)
{
  Matrix4<float> m = lens(1.0f, 1.0f).cast<float>();
  m(2, 2) = far_plane / (near_plane - far_plane);
  m(2, 3) = near_plane * far_plane / (near_plane - far_plane);
  return m;
}

/// The ways that compete, the recommended one last.
inline std::array<DepthMethod, 3> depth_methods()
{
  return {
      {{"0…1, unasked", perspective_unasked},
       {"−1…1", [](float near_plane, float far_plane)
        { return perspective(1.0f, 1.0f, near_plane, far_plane); }},
       {"reversed",
        [](float near_plane, float) { return perspective_reversed(1.0f, 1.0f, near_plane); }}}};
}

/// The verdicts on all ways to keep depths.
inline std::vector<VerdictRow> depth_verdicts()
{
  std::vector<VerdictRow> all;
  for (const DepthCase& one : depth_cases())
  {
    all.push_back({"", one.what, {}});
    for (const DepthMethod& method : depth_methods())
    {
      const std::optional<Matrix4<float>> m = method.matrix(one.near_plane, one.far_plane);
      const auto depth = [&](float ahead) -> float
      { return ((*m)(2, 2) * -ahead + (*m)(2, 3)) / ahead; };
      const bool distinct = m && depth(one.nearer) != depth(one.farther);
      const bool refused = !m && one.near_plane == 0;
      const std::string what = refused ? "refused" : distinct ? "told apart" : "the same depth";
      all.back().verdicts.push_back({distinct || refused, what});
    }
  }
  return all;
}

/// The chapter's camera: 3 m up and 4 m back, looking at the origin; a right angle high.
inline Camera<double> scene_camera()
{
  const Matrix4<double> lens = *perspective(std::numbers::pi / 2, 1.5, 1.0, 9.0);
  return {look_at<double>({0, 3, 4}, {0, 0, 0}, {0, 1, 0}), lens, {600, 400}};
}

/// The camera of the table of boxes: at the origin, looking along −z, a right angle wide and high.
inline Camera<double> square_camera()
{
  Matrix4<double> lens = Matrix4<double>::Identity();
  lens(2, 2) = -11.0 / 9;
  lens(2, 3) = -20.0 / 9;
  lens(3, 2) = -1;
  lens(3, 3) = 0;
  return {Isometry3<double>::Identity(), lens, {100, 100}};
}

/// A box before the camera that sees 1 to 10 m ahead, as far to each side as ahead.
struct ViewCase
{
  std::string what;            ///< in a few words
  Vector3<double> least, most; ///< [m], corners of the box
  bool seen;                   ///< by hand
};

/// Boxes to keep or to leave out.
inline std::vector<ViewCase> view_cases()
{
  return {
      {"a box ahead", {-1, -1, -5}, {1, 1, -4}, true},
      {"the camera is in the box", {-9, -9, -9}, {9, 9, 9}, true},
      {"a floor under all of it", {-99, -2, -99}, {99, -1, 99}, true},
      {"behind the camera", {-1, -1, 4}, {1, 1, 5}, false},
      {"to the left, as far back as ahead", {-9, -1, -6}, {-7, 1, 6}, false},
      {"a wall just beyond a far corner", {10.5, -1, -40}, {11, 1, 0}, false},
      {"across a slanted edge", {7, -30, -9}, {30, -8, -6}, true}};
}

/// The verdicts on both ways to leave out boxes: right if seen boxes stay and others go.
inline std::vector<VerdictRow> view_verdicts()
{
  const Camera<double> camera = square_camera();
  const Frustum<double> planes =
      frustum_planes<double>(clip_from_world(camera), DepthRange::minus_one_to_one);
  const std::array<Vector3<double>, 8> corners = *view_corners<double>(camera, -1, 1);
  std::vector<VerdictRow> all;
  for (const ViewCase& one : view_cases())
  {
    const Eigen::AlignedBox<double, 3> box(one.least, one.most);
    all.push_back({"", one.what, {}});
    for (const bool kept : {may_see(planes, box), may_see(planes, corners, box)})
    {
      all.back().verdicts.push_back({kept == one.seen, kept ? "drawn" : "left out"});
    }
  }
  return all;
}

/// The names of the ways to leave out boxes.
inline std::vector<std::string> view_method_names()
{
  return {"six planes", "planes and corners"};
}

} // namespace cookbook
