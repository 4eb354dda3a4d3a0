#pragma once

/// \file
/// \brief Contenders of the chart that are more than a function of two boxes: the batch, and the
/// recipe with a memory.

#include "04_obb_manifolds/box_box/box_box_in_registers.hpp"
#include "04_obb_manifolds/box_oracles/trial/timed_methods.hpp"
#include "04_obb_manifolds/box_pairs/box_pairs.hpp"
#include "04_obb_manifolds/feature_memory/feature_memory.hpp"

#include <memory>
#include <string>
#include <vector>

namespace cookbook
{

/// Pairs in blocks, and room for their answers.
struct BoxBatch
{
  BoxBlocks blocks;
  BoxManifolds manifolds;
  std::vector<std::uint32_t> touching;

  /// Fills the blocks.
  explicit BoxBatch(const std::vector<BoxPair<float>>& pairs)
      : blocks(blocks_of(pairs)), touching(blocks.a.size())
  {
  }
};

/// Stores the manifolds of all pairs, or only whether they touch.
inline std::function<void()>
run_batch(const std::shared_ptr<BoxBatch>& batch, InstructionSet set, bool only_touch)
{
  return [=]
  {
    only_touch ? box_pairs_touch(batch->blocks.a, batch->blocks.b, batch->touching, set)
               : box_pairs(batch->blocks.a, batch->blocks.b, batch->manifolds, set);
  };
}

/// box_pairs with an instruction set.
inline TimedMethod batch_contender(InstructionSet set)
{
  const auto method = [set](const Obb<float>& a, const Obb<float>& b)
  {
    const BoxPair<float> pair(a, b);
    return box_pairs_in_order({&pair, 1}, set)[0];
  };
  const auto prepare = [set](const BoxPairLists& lists)
  { return run_batch(std::make_shared<BoxBatch>(lists.in_float), set, false); };
  return box_contender<float>("box_pairs, " + name_of(set), false, method, prepare);
}

/// Every second call is the next frame of the one before.
template <class Real>
class EverySecondFrame
{
public:
  /// The manifold of a frame.
  std::optional<Manifold<Real>> operator()(const Obb<Real>& a, const Obb<Real>& b)
  {
    memory_ = next_frame(second_ ? memory_ : ContactMemory<Real, Real>{}, a, b);
    second_ = !second_;
    return memory_.manifold;
  }

private:
  ContactMemory<Real, Real> memory_;
  bool second_ = false;
};

/// box_box with a memory: timed as in a frame like the one before.
template <class Real>
TimedMethod memory_contender(const std::string& name)
{
  const auto first_frame = [](const Obb<Real>& a, const Obb<Real>& b)
  { return next_frame_in<RowInRegisters<Real>>(ContactMemory<Real, Real>{}, a, b).manifold; };
  const auto prepare = [](const BoxPairLists& lists) -> std::function<void()>
  {
    std::vector<ContactMemory<Real, Real>> before;
    for (const auto& [a, b] : lists.in<Real>())
    {
      before.push_back(next_frame_in<RowInRegisters<Real>>(ContactMemory<Real, Real>{}, a, b));
    }
    return [before, pairs = lists.in<Real>()]
    {
      for (std::size_t i = 0; i < pairs.size(); ++i)
      {
        const auto now =
            next_frame_in<RowInRegisters<Real>>(before[i], pairs[i].first, pairs[i].second);
        measure::keep(now);
      }
    };
  };
  TimedMethod contender = box_contender<Real>(name, false, first_frame, prepare);
  contender.steadiness = [](const BoxWorkload& workload)
  {
    EverySecondFrame<Real> frames;
    return resting_steadiness<Real>(
        workload, [&](const Obb<Real>& a, const Obb<Real>& b) { return frames(a, b); });
  };
  return contender;
}

} // namespace cookbook
