/// \file
/// \brief The inner loop of sphere_pairs; COOKBOOK_INSTRUCTION_SET names the instruction set.
///
/// Nothing here calls functions that other files compile for every processor: the linker keeps one
/// copy of such a function, and it must not be the one for the newest processor.

#include "03_sphere_manifolds/sphere_pairs/sphere_pairs_kernel.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "common/simd/lanes.hpp"

namespace cookbook
{

// [sphere_pairs_kernel]
bool COOKBOOK_NAMED(sphere_pairs_, COOKBOOK_INSTRUCTION_SET)(
    const PairsBegin& pairs, const OverlapsBegin& overlaps, std::size_t count)
{
  const auto [ax, ay, az, ar, bx, by, bz, br] = pairs.list;
  const auto [nx, ny, nz, depth, px, py, pz] = overlaps.list;
  Lanes::Mask safe = Lanes(0.0f) <= Lanes(0.0f);
  for (std::size_t i = 0; i < count; i += width)
  {
    const auto load = [i](const float* list) { return load_pack<Lanes>(list + i); };
    const auto store = [i](const Lanes& lanes, float* list) { store_pack(lanes, list + i); };

    const Vector3<Lanes> center_a(load(ax), load(ay), load(az));
    const Vector3<Lanes> a_to_b = Vector3<Lanes>(load(bx), load(by), load(bz)) - center_a;
    const Lanes squared = a_to_b.squaredNorm();
    safe = safe & (squared >= Lanes(SafeSquares<float>::least)) &
           (squared <= Lanes(SafeSquares<float>::most));
    const SphereOverlap<Lanes> overlap =
        sphere_overlap<Lanes>(split<Lanes>(a_to_b, squared), load(ar), load(br));
    const Vector3<Lanes> position = center_a + overlap.position;

    store(overlap.normal.x(), nx);
    store(overlap.normal.y(), ny);
    store(overlap.normal.z(), nz);
    store(overlap.depth, depth);
    store(position.x(), px);
    store(position.y(), py);
    store(position.z(), pz);
  }
  return all(safe);
}
// [sphere_pairs_kernel]

} // namespace cookbook
