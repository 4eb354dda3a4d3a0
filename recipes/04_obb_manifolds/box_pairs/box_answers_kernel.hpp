#pragma once

/// \file
/// \brief Manifolds of a register of pairs, for the kernel of box_pairs.

#include "04_obb_manifolds/box_box/box_contacts.hpp"
#include "04_obb_manifolds/box_pairs/box_lanes_kernel.hpp"
#include "04_obb_manifolds/box_pairs/box_pairs.hpp"

#include <cstddef>
#include <cstdint>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// Writes the manifolds of pairs that all meet with edges.
inline void answer_edges(
    const Obb<Lanes>& a, const BoxesInRows<Three>& boxes, const LeastEdge<Lanes>& edge,
    const Words& pair, SixteenEdgeManifolds& out, std::size_t at)
{
  const Lanes zero(0.0f), one(1.0f);
  const Lanes i = select(Lanes(2.5f) < edge.index, one, zero) +
                  select(Lanes(5.5f) < edge.index, one, zero); // a third of it
  const Lanes j = edge.index - i * Lanes(3.0f);
  const EdgeContact<Three> contact = edge_contact(a, boxes, which(i), which(j));
  for (int x = 0; x < 3; ++x)
  {
    store_pack(contact.normal[x], out.normal[x] + at);
    store_pack(contact.position[x], out.position[x] + at);
  }
  store_pack(sqrt(edge.squared_depth), out.depth + at);
  store(pair, out.pair + at);
  store(converted<Words>(((edge.index + Lanes(6.0f)) * Lanes(64.0f)).lanes), out.feature + at);
}

/// Writes the manifolds of pairs that all meet with faces, and says which have no point.
///
/// `box` has the face, along its axis k; the other's axes and centre are as it sees them.
template <class Lane>
Lanes::Mask answer_faces(
    const Obb<Lanes>& box, const Obb<Lanes>& other, const Three (&axes)[3], const Three& offset,
    const Lane& k, const LeastFace<Lanes>& face, const Words& pair, SixteenFaceManifolds& out,
    std::size_t at)
{
  const Tolerances<Lanes> tolerances = tolerances_of(box, other);
  const FaceContact<Three> contact = face_contact(
      box, other, axes, offset, k,
      kept_separation(face.depth, tolerances.margin, tolerances.length), tolerances.length);
  const Lanes towards_b = select(FaceOf(face.index).a, Lanes(1.0f), Lanes(-1.0f));
  Words kept = Words{};
  for (std::size_t slot = 0; slot < 8; ++slot)
  {
    const std::size_t part = slot / 4;
    const int i = static_cast<int>(slot % 4);
    kept = kept | (contact.kept[part].part[i].lanes & spread<Words>(1 << slot));
    for (int x = 0; x < 3; ++x)
    {
      store_pack(contact.position[part][x][i], out.position[slot][x] + at);
    }
    store_pack(contact.depth[part][i], out.point_depth[slot] + at);
  }
  for (int x = 0; x < 3; ++x)
  {
    store_pack(contact.normal[x] * towards_b, out.normal[x] + at);
  }
  store_pack(face.depth, out.depth + at);
  store(pair, out.pair + at);
  store(kept, out.kept + at);
  const Lanes feature = face.index * Lanes(64.0f) + contact.incident * Lanes(8.0f);
  store(converted<Words>(feature.lanes), out.feature + at);
  return {kept == Words{}};
}

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
