#pragma once

/// \file
/// \brief The methods for two boxes, in float and in double, are compiled once, in
/// box_instances.cpp; a file that includes this does not compile them again.

#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_box/box_box_in_registers.hpp"
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"
#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "04_obb_manifolds/feature_memory/feature_memory.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"

/// Declares every method for a number type: with `extern` as compiled elsewhere, without as
/// compiled here.
#define COOKBOOK_BOX_METHODS(ELSEWHERE, REAL)                                                      \
  ELSEWHERE template std::optional<LeastOverlap<REAL>> separating_axes(                            \
      const Obb<REAL>&, const Obb<REAL>&);                                                         \
  ELSEWHERE template std::optional<Manifold<REAL, most_crossings>> edge_clipping(                  \
      const Obb<REAL>&, const Obb<REAL>&);                                                         \
  ELSEWHERE template std::optional<Manifold<REAL>> plain_box_box(                                  \
      const Obb<REAL>&, const Obb<REAL>&);                                                         \
  ELSEWHERE template std::optional<Manifold<REAL>> face_clipping(                                  \
      const Obb<REAL>&, const Obb<REAL>&);                                                         \
  ELSEWHERE template std::optional<Manifold<REAL>> gjk_epa(const Obb<REAL>&, const Obb<REAL>&);    \
  ELSEWHERE template std::optional<REAL> overlap_on(const Obb<REAL>&, const Obb<REAL>&, int);      \
  ELSEWHERE template std::optional<Manifold<REAL, most_published_points>> box_as_published(        \
      const Obb<REAL>&, const Obb<REAL>&);

/// The same for box_box() with its rows of type ROW.
#define COOKBOOK_BOX_ROWS(ELSEWHERE, REAL, ...)                                                    \
  ELSEWHERE template std::optional<Manifold<REAL>> box_box_in<__VA_ARGS__>(                        \
      const Obb<REAL>&, const Obb<REAL>&);                                                         \
  ELSEWHERE template std::optional<std::pair<int, REAL>> box_axis_in<__VA_ARGS__>(                 \
      const Obb<REAL>&, const Obb<REAL>&);                                                         \
  ELSEWHERE template std::optional<Manifold<REAL>> box_box_on<__VA_ARGS__>(                        \
      const Obb<REAL>&, const Obb<REAL>&, int, const REAL&, const REAL&, const REAL&);

namespace cookbook
{

COOKBOOK_BOX_ROWS(extern, float, RowOf<float, 3>)
COOKBOOK_BOX_ROWS(extern, float, RowInRegisters<float>)
COOKBOOK_BOX_ROWS(extern, double, RowOf<double, 3>)
COOKBOOK_BOX_ROWS(extern, double, RowInRegisters<double>)

COOKBOOK_BOX_METHODS(extern, float)
COOKBOOK_BOX_METHODS(extern, double)

} // namespace cookbook
