/// \file
/// \brief The inner loop of box_pairs; COOKBOOK_INSTRUCTION_SET names the instruction set.
///
/// Nothing here calls functions that other files compile for every processor: the linker keeps one
/// copy of such a function, and it must not be the one for the newest processor.

#include "04_obb_manifolds/box_pairs_kernel.hpp"
#include "04_obb_manifolds/box_choice.hpp"
#include "04_obb_manifolds/box_contacts.hpp"
#include "common/math/lanes.hpp"

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

using Three = Group<Lanes, 3>;
using Four = Group<Lanes, 4>;

/// The boxes whose first is box i of sixteen.
Obb<Lanes> boxes_at(const SixteenBoxes& boxes, std::size_t i)
{
  Obb<Lanes> box;
  for (int x = 0; x < 3; ++x)
  {
    box.center[x] = load_pack<Lanes>(boxes.center[x] + i);
    box.half_extents[x] = load_pack<Lanes>(boxes.half_extents[x] + i);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.axes(x, axis) = load_pack<Lanes>(boxes.axes[axis][x] + i);
    }
  }
  return box;
}

Obb<Lanes> select(const Lanes::Mask& mask, const Obb<Lanes>& yes, const Obb<Lanes>& no)
{
  Obb<Lanes> box;
  for (int x = 0; x < 3; ++x)
  {
    box.center[x] = select(mask, yes.center[x], no.center[x]);
    box.half_extents[x] = select(mask, yes.half_extents[x], no.half_extents[x]);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.axes(x, axis) = select(mask, yes.axes(x, axis), no.axes(x, axis));
    }
  }
  return box;
}

// [overlaps]
/// The overlaps of each pair along all fifteen axes.
struct Overlaps
{
  Three face_a, face_b;
  EdgeOverlaps<Lanes> edges[3];

  explicit Overlaps(const BoxesInRows<Lanes>& boxes)
      : face_a(face_overlaps(boxes.half_a, boxes.columns, boxes.half_b, boxes.offset_a)),
        face_b(face_overlaps(boxes.half_b, boxes.rows, boxes.half_a, boxes.offset_b)),
        edges{edge_overlaps(boxes, 0), edge_overlaps(boxes, 1), edge_overlaps(boxes, 2)}
  {
  }

  /// Which pairs touch: along no axis are they apart.
  Lanes::Mask touching() const
  {
    const Three zero(Lanes(0.0f));
    const Three edge = min(min(edges[0].overlap, edges[1].overlap), edges[2].overlap);
    return all_lanes<Lanes>((zero <= face_a) & (zero <= face_b) & (zero <= edge));
  }
};
// [overlaps]

// [choice_of]
/// The axis and depth on which each pair's manifold is built.
struct Choice
{
  Lanes::Mask on_edge, on_face; ///< one of the two, or neither: apart
  LeastFace<Lanes> face;
  LeastEdge<Lanes> edge;
};

/// What is chosen by all fifteen overlaps.
Choice choice_of(const BoxesInRows<Lanes>& boxes, const Tolerances<Lanes>& tolerances)
{
  const Overlaps overlaps(boxes);
  const Lanes::Mask touching = overlaps.touching();
  Choice choice;
  choice.face = least_face<Lanes>(overlaps.face_a, overlaps.face_b);
  choice.edge = least_edge(overlaps.edges, edge_bar(boxes, choice.face.depth, tolerances));
  choice.on_edge = touching & choice.edge.found();
  choice.on_face = touching & (Lanes(LeastEdge<Lanes>::none) <= choice.edge.squared_depth);
  return choice;
}
// [choice_of]

/// Whole numbers, a lane each.
using Words = VectorOf<std::int32_t, width>::type;

void store(const Words& words, std::uint32_t* to)
{
  std::memcpy(to, &words, sizeof words);
}

/// What a pack of manifolds has in common, whichever kind of contact each is.
struct Answer
{
  Lanes normal[3] = {Lanes(0.0f), Lanes(0.0f), Lanes(0.0f)};
  Lanes depth = Lanes(-1.0f);
  Words kept = Words{};
  Words feature = Words{};
};

void answer_edges(
    const Obb<Lanes>& a, const BoxesInRows<Lanes>& boxes, const Choice& choice, Answer& answer,
    SixteenManifolds& out, std::size_t at)
{
  const LeastEdge<Lanes>& edge = choice.edge;
  const Lanes i = third(edge.index), j = edge.index - i * Lanes(3.0f);
  const EdgeContact<Lanes> contact = edge_contact<Lanes>(a, boxes, which(i), which(j));
  answer.depth = select(choice.on_edge, sqrt(edge.squared_depth), answer.depth);
  for (int x = 0; x < 3; ++x)
  {
    answer.normal[x] = contact.normal[x];
    store_pack(contact.position[x], out.position[0][x] + at);
  }
  store_pack(answer.depth, out.point_depth[0] + at);
  answer.kept = choice.on_edge.lanes & 1;
  answer.feature = __builtin_convertvector((edge.index.lanes + 6.0f) * 64.0f, Words);
}

void answer_faces(
    const Obb<Lanes>& a, const Obb<Lanes>& b, const BoxesInRows<Lanes>& boxes, const Choice& choice,
    const Tolerances<Lanes>& tolerances, Answer& answer, SixteenManifolds& out, std::size_t at)
{
  const Lanes index = choice.face.index;
  const Lanes::Mask of_a = index < Lanes(2.5f);
  const Three c[] = {
      select(of_a, boxes.rows[0], boxes.columns[0]), select(of_a, boxes.rows[1], boxes.columns[1]),
      select(of_a, boxes.rows[2], boxes.columns[2])};
  const FaceContact<Lanes> contact = face_contact<Lanes>(
      select(of_a, a, b), select(of_a, b, a), c, select(of_a, boxes.offset_a, boxes.offset_b),
      which<Lanes>(select(of_a, index, index - Lanes(3.0f))), kept_gap(choice.face, tolerances),
      tolerances.hair);
  const Lanes::Mask& mine = choice.on_face;
  const Lanes towards_b = select(of_a, Lanes(1.0f), Lanes(-1.0f));
  for (int x = 0; x < 3; ++x)
  {
    answer.normal[x] = select(mine, contact.normal[x] * towards_b, answer.normal[x]);
  }
  answer.depth = select(mine, choice.face.depth, answer.depth);
  const Words feature =
      __builtin_convertvector(index.lanes * 64.0f + contact.incident.lanes * 8.0f, Words);
  answer.feature = mine.lanes ? feature : answer.feature;
  for (std::size_t slot = 0; slot < 8; ++slot)
  {
    const std::size_t part = slot / 4;
    const int i = static_cast<int>(slot % 4);
    const Lanes::Mask kept = mine & contact.kept[part].lane[i];
    answer.kept |= kept.lanes & static_cast<std::int32_t>(1u << slot);
    const auto put = [&](const Lanes& lanes, float* to)
    { store_pack(slot == 0 ? select(mine, lanes, load_pack<Lanes>(to)) : lanes, to); };
    put(contact.position[part][0][i], out.position[slot][0] + at);
    put(contact.position[part][1][i], out.position[slot][1] + at);
    put(contact.position[part][2][i], out.position[slot][2] + at);
    put(contact.depth[part][i], out.point_depth[slot] + at);
  }
}

} // namespace COOKBOOK_INSTRUCTION_SET

// [box_pairs_kernel]
[[gnu::flatten]] bool COOKBOOK_NAMED(box_pairs_, COOKBOOK_INSTRUCTION_SET)(
    const SixteenBoxes* boxes_a, const SixteenBoxes* boxes_b, SixteenManifolds* manifolds,
    std::size_t count)
{
  Words left = Words{}; // set where box_box must answer
  for (std::size_t i = 0; i < count * 16; i += width)
  {
    const std::size_t block = i / 16, at = i % 16;
    const Obb<Lanes> a = boxes_at(boxes_a[block], at), b = boxes_at(boxes_b[block], at);
    SixteenManifolds& out = manifolds[block];
    const BoxesInRows<Lanes> boxes = boxes_in_rows(a, b);
    const Tolerances<Lanes> tolerances = tolerances_of(a, b);
    const Choice choice = choice_of(boxes, tolerances);
    Answer answer;
    if (any(choice.on_edge))
    {
      answer_edges(a, boxes, choice, answer, out, at);
    }
    if (any(choice.on_face))
    {
      answer_faces(a, b, boxes, choice, tolerances, answer, out, at);
    }
    for (int x = 0; x < 3; ++x)
    {
      store_pack(answer.normal[x], out.normal[x] + at);
    }
    store_pack(answer.depth, out.depth + at);
    store(answer.kept, out.kept + at);
    store(answer.feature, out.feature + at);
    const Words without_point = choice.on_face.lanes & (answer.kept == 0);
    left |= ~has_moderate_size(tolerances.size).lanes | without_point;
  }
  return !any(Lanes::Mask{left});
}
// [box_pairs_kernel]

// [box_pairs_touch_kernel]
[[gnu::flatten]] bool COOKBOOK_NAMED(box_pairs_touch_, COOKBOOK_INSTRUCTION_SET)(
    const SixteenBoxes* a, const SixteenBoxes* b, std::uint32_t* touching, std::size_t count)
{
  Lanes::Mask answered = Lanes(0.0f) <= Lanes(0.0f);
  for (std::size_t block = 0; block < count; ++block)
  {
    std::uint32_t word = 0;
    for (std::size_t at = 0; at < 16; at += width)
    {
      const Obb<Lanes> box_a = boxes_at(a[block], at), box_b = boxes_at(b[block], at);
      word |= bits_of(Overlaps(boxes_in_rows(box_a, box_b)).touching()) << at;
      answered = answered & has_moderate_size(tolerances_of(box_a, box_b).size);
    }
    touching[block] = word;
  }
  return all(answered);
}
// [box_pairs_touch_kernel]

} // namespace cookbook
