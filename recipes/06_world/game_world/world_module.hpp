#pragma once

/// \file
/// \brief What a world can do without.

#include "06_world/contacts/bounds.hpp"
#include "06_world/contacts/narrow_phase.hpp"
#include "06_world/contacts/pair_finder.hpp"

#include <any>
#include <concepts>
#include <span>
#include <vector>

namespace cookbook
{

struct WorldState;

// [cloned]
/// Owns something behind an interface; a copy of it owns a copy, of the same kind.
template <class Interface>
class Cloned
{
public:
  /// Owns a copy of this.
  template <std::derived_from<Interface> Kind>
  Cloned(const Kind& of)
      : owned_(of), get_([](std::any& one) -> Interface* { return std::any_cast<Kind>(&one); })
  {
  }

  Interface* operator->() const { return get_(owned_); }
  Interface& operator*() const { return *get_(owned_); }

private:
  mutable std::any owned_;
  Interface* (*get_)(std::any&);
};
// [cloned]

// [world_module]
/// A part of a world that can be left out. It owns what it knows; step() calls its functions, those
/// of all modules in the order in which the world was given them.
class WorldModule
{
public:
  using Bodies = std::span<const int>;
  using Box = Eigen::AlignedBox<double, 3>;

  virtual ~WorldModule() = default;
  virtual void added(WorldState&) {} ///< once, to a world without bodies

  /// Whether it is to say by which bounds [m] pairs are found, and then within which margins two
  /// bodies of a pair are in contact.
  virtual bool looks_ahead() const { return false; }
  virtual Box bounds(const WorldState&, int) { return {}; }
  virtual ContactMargins margins(const WorldState&, int, int) { return {}; }

  virtual void collided(WorldState&) {}        ///< contacts have been found
  virtual void predict(WorldState&) {}         ///< islands are known too, and nothing has moved
  virtual void solved(WorldState&) {}          ///< every body has been moved
  virtual void finished(WorldState&) {}        ///< every body is as the step leaves it
  virtual void changed(WorldState&, Bodies) {} ///< these bodies, by the game, between steps
  virtual void hit(WorldState&, Bodies) {}     ///< these bodies, by others, within a step
};

/// What a world is made of beside its solver: modules, in the order in which a step calls them, and
/// how pairs are found.
struct WorldModules
{
  std::vector<Cloned<WorldModule>> list{};
  Cloned<PairFinder> pair_finder{TreePairs()};
};
// [world_module]

} // namespace cookbook
