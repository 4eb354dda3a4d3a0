/// \file
/// \brief The inner loop of box_pairs; COOKBOOK_INSTRUCTION_SET names the instruction set.
///
/// Nothing here calls functions that other files compile for every processor: the linker keeps one
/// copy of such a function, and it must not be the one for the newest processor.

#include "04_obb_manifolds/box_pairs/box_pairs_kernel.hpp"
#include "04_obb_manifolds/box_pairs/box_ahead_kernel.hpp"
#include "04_obb_manifolds/box_pairs/box_answers_kernel.hpp"
#include "04_obb_manifolds/box_pairs/box_waiting_kernel.hpp"

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [overlaps]
/// The overlaps of each pair along all fifteen axes.
struct Overlaps
{
  Three face_a, face_b;
  EdgeOverlaps<Three> edges[3];

  explicit Overlaps(const BoxesInRows<Three>& boxes)
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
    return ((zero <= face_a) & (zero <= face_b) & (zero <= edge)).all();
  }
};
// [overlaps]

// [choice_of]
/// The axis on which each pair's manifold is built, a bit for each pair.
struct Choice
{
  std::uint32_t on_edge, on_face; ///< one of the two, or neither: apart, or left out
  std::uint32_t left_out;         ///< sizes whose squares do not fit
  LeastFace<Lanes> face;
  LeastEdge<Lanes> edge;
};

/// What is chosen by all fifteen overlaps.
Choice choice_of(const BoxesInRows<Three>& boxes, const Tolerances<Lanes>& tolerances)
{
  const Overlaps overlaps(boxes);
  Choice choice;
  choice.face = least_face(overlaps.face_a, overlaps.face_b);
  choice.edge = least_edge(overlaps.edges, edge_threshold(boxes, choice.face.depth, tolerances));
  const Lanes::Mask moderate = has_moderate_size(tolerances.size);
  const std::uint32_t touching = bits_of(overlaps.touching() & moderate);
  choice.on_edge = touching & bits_of(choice.edge.found());
  choice.on_face = touching & ~choice.on_edge;
  choice.left_out = all_pairs & ~bits_of(moderate);
  return choice;
}
// [choice_of]

/// Counts manifolds that were written; where they begin a block, the next one will be asked for.
template <class Block>
void written(Block* blocks, std::size_t& count, std::size_t more, Ahead<Block>& next)
{
  if (count % 16 == 0)
  {
    next.begin(blocks + count / 16 + 1);
  }
  count += more;
}

/// Answers a register of waiting faces, `count` of which are meant.
[[gnu::flatten, gnu::noinline]] void answer_waiting_faces(
    const Waiting& waiting, std::size_t from, std::size_t count, BoxPairsRoom& room, Next& next)
{
  const Obb<Lanes> box = boxes_at(waiting.box, from), other = boxes_at(waiting.other, from);
  const LeastFace<Lanes> face{
      load_pack<Lanes>(waiting.depth + from), load_pack<Lanes>(waiting.index + from)};
  const FaceOf of(face.index);
  Vector3<Lanes> d; // seen from B it is minus the way from A, and minus zero where that is zero
  for (int x = 0; x < 3; ++x)
  {
    const Lanes &here = box.center[x], &there = other.center[x];
    d[x] = select(of.a, there - here, -(here - there));
  }
  const BoxesInRows<Three> boxes = boxes_in_rows<Three>(box, other, d);
  const Lanes::Mask pointless = answer_faces(
      box, other, boxes.rows, boxes.offset_a, 0, face, words_at(waiting.pair + from),
      room.faces[room.face_count / 16], room.face_count % 16);
  room.pointless |= (bits_of(pointless) & all_pairs >> (width - count)) != 0;
  written(room.faces, room.face_count, count, next.faces);
}

/// Answers a register of waiting edges, `count` of which are meant.
[[gnu::flatten, gnu::noinline]] void answer_waiting_edges(
    const Waiting& waiting, std::size_t from, std::size_t count, BoxPairsRoom& room, Next& next)
{
  const Obb<Lanes> a = boxes_at(waiting.box, from), b = boxes_at(waiting.other, from);
  const LeastEdge<Lanes> edge{
      load_pack<Lanes>(waiting.depth + from), load_pack<Lanes>(waiting.index + from)};
  answer_edges(
      a, boxes_in_rows<Three>(a, b), edge, words_at(waiting.pair + from),
      room.edges[room.edge_count / 16], room.edge_count % 16);
  written(room.edges, room.edge_count, count, next.edges);
}

/// Answers those that wait, by whole registers from the end; the last by what there is.
template <class Answer>
void answer_waiting(
    Waiting& waiting, bool all, BoxPairsRoom& room, Next& next, const Answer& answer)
{
  while (waiting.count >= width)
  {
    waiting.count -= width;
    answer(waiting, waiting.count, width, room, next);
  }
  if (all && waiting.count > 0)
  {
    answer(waiting, 0, waiting.count, room, next);
  }
}

// [answer_or_wait]
/// Answers a register of pairs if all of them go the same way; otherwise each waits for its like.
void answer_or_wait(
    const PairsInBlocks& pairs, Waiting& faces, Waiting& edges, BoxPairsRoom& room, Next& next)
{
  const Obb<Lanes> a = boxes_at(pairs.a, pairs.at), b = boxes_at(pairs.b, pairs.at);
  const BoxesInRows<Three> boxes = boxes_in_rows<Three>(a, b);
  next.ask();
  const Choice choice = choice_of(boxes, tolerances_of(a, b));
  next.ask();
  room.left_out |= choice.left_out != 0;
  if (choice.on_face == all_pairs)
  {
    const FaceOf of(choice.face.index);
    const Three axes[] = {
        select(of.a, boxes.rows[0], boxes.columns[0]),
        select(of.a, boxes.rows[1], boxes.columns[1]),
        select(of.a, boxes.rows[2], boxes.columns[2])};
    const Lanes::Mask pointless = answer_faces(
        select(of.a, a, b), select(of.a, b, a), axes, select(of.a, boxes.offset_a, boxes.offset_b),
        of.axis, choice.face, pairs.numbers(), room.faces[room.face_count / 16],
        room.face_count % 16);
    room.pointless |= any(pointless);
    written(room.faces, room.face_count, width, next.faces);
  }
  else if (choice.on_edge == all_pairs)
  {
    answer_edges(
        a, boxes, choice.edge, pairs.numbers(), room.edges[room.edge_count / 16],
        room.edge_count % 16);
    written(room.edges, room.edge_count, width, next.edges);
  }
  else
  {
    if (choice.on_face != 0)
    {
      wait(faces, choice.on_face, pairs, choice.face);
    }
    if (choice.on_edge != 0)
    {
      wait(edges, choice.on_edge, pairs, choice.edge);
    }
  }
}
// [answer_or_wait]

} // namespace COOKBOOK_INSTRUCTION_SET

// [box_pairs_kernel]
[[gnu::flatten]] void COOKBOOK_NAMED(box_pairs_, COOKBOOK_INSTRUCTION_SET)(
    const SixteenBoxes* a, const SixteenBoxes* b, std::size_t count, BoxPairsRoom& room)
{
  Waiting faces, edges;
  Next next;
  for (std::size_t block = 0; block < count; ++block)
  {
    next.a.begin(a + block + 1);
    next.b.begin(b + block + 1);
    for (std::size_t at = 0; at < 16; at += width)
    {
      const auto first = static_cast<std::uint32_t>(16 * block + at);
      answer_or_wait({a[block], b[block], at, first}, faces, edges, room, next);
    }
    const bool last = block + 1 == count;
    if (last || block % blocks_at_once == blocks_at_once - 1)
    {
      answer_waiting(faces, last, room, next, answer_waiting_faces);
      answer_waiting(edges, last, room, next, answer_waiting_edges);
    }
  }
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
      word |= bits_of(Overlaps(boxes_in_rows<Three>(box_a, box_b)).touching()) << at;
      answered = answered & has_moderate_size(tolerances_of(box_a, box_b).size);
    }
    touching[block] = word;
  }
  return all(answered);
}
// [box_pairs_touch_kernel]

} // namespace cookbook
