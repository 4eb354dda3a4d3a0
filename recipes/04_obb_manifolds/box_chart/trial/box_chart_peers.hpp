#pragma once

/// \file
/// \brief Other libraries as contenders: those that are installed.

#include "04_obb_manifolds/box_oracles/trial/timed_methods.hpp"
#if defined(COOKBOOK_HAS_ODE)
#include "04_obb_manifolds/box_chart/trial/box_peer_ode.hpp"
#endif
#if defined(COOKBOOK_HAS_BULLET)
#include "04_obb_manifolds/box_chart/trial/box_peer_bullet.hpp"
#endif
#if defined(COOKBOOK_HAS_FCL)
#include "04_obb_manifolds/box_chart/trial/box_peer_fcl.hpp"
#endif

#include <memory>
#include <string>
#include <vector>

namespace cookbook
{

/// Another library as a contender; `Pairs` places its boxes when it is made.
template <class Pairs>
TimedMethod box_peer(const std::string& name)
{
  using Real = typename Pairs::Real;
  const auto method = [](const Obb<Real>& a, const Obb<Real>& b) {
    return Pairs({{a, b}}).manifold(0);
  };
  const auto prepare = [](const BoxPairLists& lists) -> std::function<void()>
  { return [pairs = std::make_shared<Pairs>(lists.in<Real>())] { pairs->run(); }; };
  return box_contender<Real>(name, true, method, prepare);
}

/// All that are there.
inline std::vector<TimedMethod> box_peers()
{
  std::vector<TimedMethod> all;
#if defined(COOKBOOK_HAS_ODE)
  all.push_back(box_peer<OdeBoxPairs>("ODE"));
#endif
#if defined(COOKBOOK_HAS_BULLET)
  all.push_back(box_peer<BulletBoxPairs>("Bullet"));
#endif
#if defined(COOKBOOK_HAS_FCL)
  all.push_back(box_peer<FclBoxPairs>("FCL"));
#endif
  return all;
}

} // namespace cookbook
