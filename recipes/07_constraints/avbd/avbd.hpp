#pragma once

/// \file
/// \brief Augmented vertex block descent of islands: body by body goes to where its forces balance.

#include "05_resolution/mass_properties/mass_properties.hpp"
#include "06_world/islands/run_substeps.hpp"
#include "07_constraints/avbd/avbd_item.hpp"
#include "07_constraints/avbd/avbd_memory.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [avbd]
/// One step of an island, for run_substeps(). Kinematic bodies move along.
class AvbdStep
{
public:
  static constexpr double rounding = velocity_rounding; ///< [1]

  AvbdStep(
      IslandView world, const Island& island, const AvbdSettings& settings, AvbdMemories& memories)
      : world_(world), island_(island), settings_(settings), memories_(memories)
  {
  }

  int prepare(double)
  {
    driven_.emplace(world_, island_);
    return 1;
  }

  /// Stores where the bodies are, and how far each row is off there.
  void solve(double step)
  {
    for (const int i : island_.bodies)
    {
      before_.push_back(state_of(world_.bodies[index_of(i)]));
    }
    items_of_.assign(island_.bodies.size(), {});
    for (const int i : island_.constraints)
    {
      const ConstraintPair& pair = world_.constraints[index_of(i)];
      ConstraintSet& set = *world_.sets[pair.set];
      add(pair.a, pair.b, key_of(pair), &set, pair.number, nullptr, step);
    }
    std::size_t next = 0;
    points_ = points_of(world_, island_);
    for (const int i : island_.contacts)
    {
      const WorldContact& contact = world_.contacts[index_of(i)];
      for (const WorldPoint& point : contact.points)
      {
        add(contact.a, contact.b, key_of(contact, point), nullptr, 0, &points_[next++], step);
      }
    }
  }

  /// The bodies have moved as if alone; from there each in turn moves to where its forces balance.
  void correct(double step)
  {
    driven_->move(step);
    std::vector<RigidBody> alone;
    for (const int i : island_.bodies)
    {
      alone.push_back(world_.bodies[index_of(i)]);
    }
    for (int pass = 0; pass < settings_.iterations; ++pass)
    {
      for (std::size_t k = 0; k < alone.size(); ++k)
      {
        settle(world_.bodies[index_of(island_.bodies[k])], alone[k], items_of_[k], step);
      }
      for (AvbdItem& item : items_)
      {
        evaluate(item, step, settings_);
        for (AvbdRow& row : item.rows)
        {
          update(row, settings_);
        }
      }
    }
  }

  /// Velocities are those that have moved the bodies there.
  void relax(double step)
  {
    for (std::size_t k = 0; k < before_.size(); ++k)
    {
      derive_velocities(before_[k], world_.bodies[index_of(island_.bodies[k])], step);
    }
    for (std::size_t i = 0; i < items_.size(); ++i)
    {
      keep(items_[i], keys_[i], step, memories_);
    }
  }

  void store() { driven_.reset(); }

private:
  void
  add(int a, int b, const AvbdKey& key, ConstraintSet* set, int number, IslandPoint* point,
      double step)
  {
    AvbdItem item{&world_.bodies[index_of(a)], &world_.bodies[index_of(b)], set, number, point};
    evaluate(item, step, settings_);
    if (set != nullptr)
    {
      evaluate_bending(item, step);
    }
    for (std::size_t i = 0; i < item.rows.size(); ++i)
    {
      const auto known = memories_.find(row_of(key, i));
      if (known != memories_.end() && !item.rows[i].is_spring)
      {
        item.rows[i].memory = warm_start(known->second, settings_);
      }
    }
    for (const int body : {a, b})
    {
      if (const int place = number_in(island_, body); place >= 0)
      {
        items_of_[index_of(place)].push_back(items_.size());
      }
    }
    items_.push_back(std::move(item));
    keys_.push_back(key);
  }

  /// Moves one body to where its forces balance, with all others where they are; R68.
  void settle(
      RigidBody& body, const RigidBody& alone, const std::vector<std::size_t>& items, double step)
  {
    AvbdBlock block = block_of(body, alone, step);
    for (const std::size_t i : items)
    {
      AvbdItem& item = items_[i];
      evaluate(item, step, settings_);
      for (const AvbdRow& row : item.rows)
      {
        &body == item.a ? add_row(block, row, row.a, row.curve_a)
                        : add_row(block, row, row.b, row.curve_b);
      }
    }
    move_to_rest(body, block);
  }

  IslandView world_;
  const Island& island_;
  const AvbdSettings& settings_;
  AvbdMemories& memories_;
  std::optional<DrivenAlong> driven_;
  std::vector<PreviousState> before_; // of each body
  std::span<IslandPoint> points_;
  std::vector<AvbdItem> items_;
  std::vector<AvbdKey> keys_;                      // of each item
  std::vector<std::vector<std::size_t>> items_of_; // of each body of the island
};

/// Augmented vertex block descent as a solver of islands, for one_by_one(). What it remembers is
/// copied with it. Source: Giles, Diaz and Yuksel 2025.
class Avbd
{
public:
  explicit Avbd(const AvbdSettings& settings = {}) : settings_(settings) {}

  /// Moves an island on by a step [s].
  void operator()(IslandView world, const Island& island, double step)
  {
    forget_gone(memories_, kept_, world);
    AvbdStep stepped(world, island, settings_, memories_);
    run_substeps(world, {&island, 1}, step, stepped);
  }

private:
  AvbdSettings settings_;
  AvbdMemories memories_;
  std::size_t kept_ = 64; // how many there were, and some more, when it was last tidied up
};
// [avbd]

} // namespace cookbook
