#pragma once

/// \file
/// \brief The methods that give a whole manifold of two boxes, by name.

#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_box/box_box_in_registers.hpp"
#include "04_obb_manifolds/contact_reduction/contact_reduction.hpp"
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"
#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"

#include <optional>

namespace cookbook
{

// [every_method]
/// Calls `visit(name, method)` for every method that takes two boxes and gives their manifold.
///
/// The methods are lambdas: a loop can have each of them inlined.
template <class Visit>
void for_every_box_method(const Visit& visit)
{
  visit(
      "box_box_in_registers",
      [](const auto& a, const auto& b) { return box_box_in_registers(a, b); });
  visit("box_box", [](const auto& a, const auto& b) { return box_box(a, b); });
  visit(
      "contact_reduction",
      [](const auto& a, const auto& b)
      {
        const auto manifold = box_box_in_registers(a, b);
        return manifold ? std::optional(reduced(*manifold)) : std::nullopt;
      });
  visit("plain_box_box", [](const auto& a, const auto& b) { return plain_box_box(a, b); });
  visit("face_clipping", [](const auto& a, const auto& b) { return face_clipping(a, b); });
  visit("edge_clipping", [](const auto& a, const auto& b) { return edge_clipping(a, b); });
  visit("gjk_epa", [](const auto& a, const auto& b) { return gjk_epa(a, b); });
  visit("box_as_published", [](const auto& a, const auto& b) { return box_as_published(a, b); });
}
// [every_method]

} // namespace cookbook
