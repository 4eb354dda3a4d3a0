#pragma once

/// \file
/// \brief What a solver of a world is, for those that only pass one on.

#include <functional>
#include <span>

namespace cookbook
{

struct Island;
struct IslandView;

// [world_solver]
/// Moves the bodies of one island on by a step [s], and sets the impulses of its contacts.
using IslandSolver = std::function<void(IslandView, const Island&, double)>;

/// The same for any number of islands, none of which affects another.
using WorldSolver = std::function<void(IslandView, std::span<const Island>, double)>;

/// A solver that solves islands one after the other; none if there is none for one.
inline WorldSolver one_by_one(IslandSolver solver);
// [world_solver]

} // namespace cookbook
