#pragma once

/// \file
/// \brief Rays and shapes that break some way of casting.

#include "02_primitives/casts/trial/casts_methods.hpp"

#include <string>
#include <vector>

namespace cookbook
{

// [cast_cases]
/// A row of the table: what is set up, and what is asked of a method.
struct CastCase
{
  std::string id;                               ///< in the book
  std::string what;                             ///< in a few words
  Verdict (*verdict)(const CastMethod& method); ///< the answer, judged
};

/// From the origin, along x or z.
inline Ray<float> along_x()
{
  return {{0, 0, 0}, {1, 0, 0}};
}
inline Ray<float> along_z()
{
  return {{0, 0, 0}, {0, 0, 1}};
}

/// A box along the axes.
inline Aabb<float> box_between(const Vector3<float>& min, const Vector3<float>& max)
{
  return {min, max};
}

/// A floor of one triangle, perpendicular to z.
inline Triangle<float> floor_at(float z)
{
  return {{-3, -3, z}, {3, -3, z}, {0, 3, z}};
}

/// The cases with boxes and spheres.
inline std::vector<CastCase> solid_cast_cases()
{
  using M = CastMethod;
  return {
      {"E1", "a sphere 5 m behind",
       [](const M& m) {
         return cast_verdict(m.sphere(along_z(), {{0, 0, -5}, 1}), {});
       }},
      {"X29", "the same, off the line",
       [](const M& m) {
         return cast_verdict(m.sphere(along_z(), {{0, 0.5f, -3}, 1}), {});
       }},
      {"E2", "a plate 0.2 mm thick, seen along its plane",
       [](const M& m) {
         return cast_verdict(m.box(along_x(), box_between({19, -1e-4f, -1}, {21, 1e-4f, 1})), 19.0);
       }},
      {"X31", "the same, as an oriented box",
       [](const M& m)
       {
         Matrix3<float> axes;
         axes << 0, 0, 1, 1, 0, 0, 0, 1, 0;
         const Obb<float> box{{20, 0, 0}, axes, {1e-4f, 1, 1}};
         const Ray<float> ray = seen_from_box(along_x(), box);
         return cast_verdict(m.box(ray, box_between(-box.half_extents, box.half_extents)), 19.0);
       }},
      {"E3", "a ray along the face of a box",
       [](const M& m)
       {
         return cast_verdict(
             m.box({{-1, 1, 0.5f}, {1, 0, 0}}, box_between({0, 0, 0}, {1, 1, 1})), 1.0);
       }},
      {"E4", "a sphere 10 km away, passed at 0.9 m",
       [](const M& m) {
         return cast_verdict(m.sphere(along_x(), {{10000, 0.9f, 0}, 1}), 9999.56411);
       }},
      {"X30", "the same, passed at 1.5 m",
       [](const M& m) {
         return cast_verdict(m.sphere(along_x(), {{10000, 1.5f, 0}, 1}), {});
       }},
      {"E6", "from inside a sphere",
       [](const M& m) {
         return cast_verdict(m.sphere(along_x(), {{0.5f, 0, 0}, 2}), 0.0);
       }},
      {"", "from inside a box", [](const M& m) {
         return cast_verdict(m.box(along_x(), box_between({-1, -1, -1}, {2, 1, 1})), 0.0);
       }}};
}

/// The cases with triangles, and some of size.
inline std::vector<CastCase> other_cast_cases()
{
  using M = CastMethod;
  return {
      {"E7", "1,000,000 rays at the diagonal of a quad", quad_verdict},
      {"E9", "two triangles, at 5 m and at 2 m",
       [](const M& m)
       {
         return cast_verdict(
             cast_at_many(m, {{0, 0, 0}, {0, 0, -1}}, {floor_at(-5), floor_at(-2)}), 2.0);
       }},
      {"X34", "three triangles, the nearest last",
       [](const M& m)
       {
         return cast_verdict(
             cast_at_many(m, {{0, 0, 0}, {0, 0, -1}}, {floor_at(-7), floor_at(-9), floor_at(-4)}),
             4.0);
       }},
      {"", "a direction of length 2",
       [](const M& m) {
         return cast_verdict(m.sphere({{0, 0, 0}, {2, 0, 0}}, {{5, 0, 0}, 1}), 2.0);
       }},
      {"", "a sphere of 1e-25 m, 3e-25 m away",
       [](const M& m) {
         return cast_verdict(m.sphere(along_x(), {{3e-25f, 0, 0}, 1e-25f}), 2e-25);
       }},
      {"", "a triangle from behind",
       [](const M& m) { return cast_verdict(m.triangle(along_z(), floor_at(2)), 2.0); }},
      {"", "a triangle with edges of 0.5 mm",
       [](const M& m)
       {
         const Triangle<float> small{{-2e-4f, -2e-4f, -1}, {3e-4f, -2e-4f, -1}, {0, 3e-4f, -1}};
         return cast_verdict(m.triangle({{0, 0, 0}, {0, 0, -1}}, small), 1.0);
       }}};
}
// [cast_cases]

/// The verdicts on all ways, case by case.
inline std::vector<VerdictRow> cast_verdicts()
{
  std::vector<VerdictRow> rows;
  std::vector<CastCase> cases = solid_cast_cases();
  for (const CastCase& one : other_cast_cases())
  {
    cases.push_back(one);
  }
  for (const CastCase& one : cases)
  {
    rows.push_back({one.id, one.what, {}});
    for (const CastMethod& method : cast_methods())
    {
      rows.back().verdicts.push_back(one.verdict(method));
    }
  }
  return rows;
}

} // namespace cookbook
