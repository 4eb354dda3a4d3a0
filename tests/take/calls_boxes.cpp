// Calls what the recipes of chapter 4 offer, those whose TAKE_… is defined. check_take.sh includes
// their headers: the house's, or one that was taken.

#include "calls.hpp"

using namespace cookbook;

namespace
{

/// Prints what a method says of pairs of boxes.
template <template <class> class Box, class Method>
[[maybe_unused]] void print_pairs(const char* name, const Method& method)
{
  print(
      name,
      [&](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const auto a = draw.box<Box>(scale), b = draw.box<Box>(scale);
        method(a, b, bits);
      });
}

} // namespace

int main()
{
#ifdef TAKE_box_box
  print_pairs<Obb>(
      "box_box", [](const auto& a, const auto& b, Bits& bits) { bits(box_box(a, b)); });
#endif
#ifdef TAKE_separating_axes
  print_pairs<Obb>(
      "separating_axes",
      [](const auto& a, const auto& b, Bits& bits)
      {
        const std::optional<LeastOverlap<double>> least = separating_axes(a, b);
        bits(least.has_value());
        if (least)
        {
          bits(least->normal, least->depth, least->axis);
        }
      });
#endif
#ifdef TAKE_plain_box_box
  print_pairs<Obb>(
      "plain_box_box", [](const auto& a, const auto& b, Bits& bits) { bits(plain_box_box(a, b)); });
#endif
#ifdef TAKE_face_clipping
  print_pairs<Obb>(
      "face_clipping", [](const auto& a, const auto& b, Bits& bits) { bits(face_clipping(a, b)); });
#endif
#ifdef TAKE_edge_clipping
  print_pairs<Obb>(
      "edge_clipping", [](const auto& a, const auto& b, Bits& bits) { bits(edge_clipping(a, b)); });
#endif
#ifdef TAKE_gjk_epa
  print_pairs<Obb>(
      "gjk_epa", [](const auto& a, const auto& b, Bits& bits) { bits(gjk_epa(a, b)); });
#endif
#ifdef TAKE_contact_reduction
  print(
      "contact_reduction",
      [](Draw& draw, Bits& bits)
      {
        Manifold<double, 16> manifold{draw.unit(), draw.number(0, 1), {}};
        for (int count = static_cast<int>(draw.number(0.6, 16)); count >= 0; --count)
        {
          const Eigen::Vector3d point = draw.vector(1);
          const Eigen::Vector3d on_plane = point - point.dot(manifold.normal) * manifold.normal;
          if (manifold.points.size() < 16)
          {
            manifold.points.push_back({on_plane, draw.number(0, 1), draw.one_in(2)});
          }
        }
        bits(reduced(manifold));
      });
#endif
#ifdef TAKE_feature_memory
  print(
      "feature_memory",
      [a = Obb<double>{}, b = Obb<double>{}, memory = ContactMemory<double, int>{},
       frame = 0](Draw& draw, Bits& bits) mutable
      {
        if (frame % 20 == 0)
        {
          a = draw.box<Obb>();
          b = draw.box<Obb>();
          memory = {};
        }
        b.center += 0.02 * draw.vector(1);
        memory = next_frame(memory, a, b);
        bits(memory.manifold, memory.warm);
        memory.warm.fill(++frame);
      });
#endif
}
