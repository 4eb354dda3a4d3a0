#pragma once

/// \file
/// \brief Solves sparse symmetric systems whose unknowns come in sixes, one six a body.

#include "06_world/direct_solver/block_factor.hpp"
#include "06_world/direct_solver/block_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace cookbook
{

// [block_cholesky]
/// The factor L of a symmetric positive definite matrix H = L Lᵀ of 6 × 6 blocks.
///
/// The pattern is laid out once; then, as often as the numbers change: clear(), add to the blocks,
/// factor(), solve().
class BlockCholesky
{
public:
  /// Lays out the factor for `count` bodies of which these pairs are coupled; not to the end if it
  /// takes more than so many products of blocks.
  void lay_out(int count, const std::vector<std::pair<int, int>>& coupled, std::size_t most)
  {
    const std::vector<int> order = elimination_order(count, coupled);
    place_.assign(order.size(), 0);
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      place_[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
    }
    starts_.assign(1, 0);
    rows_.clear();
    for (const std::vector<int>& column : filled_rows(place_, coupled))
    {
      rows_.insert(rows_.end(), column.begin(), column.end());
      starts_.push_back(rows_.size());
    }
    find_products(most);
    diagonal_.resize(order.size());
    inverse_.resize(order.size());
    below_.resize(rows_.size());
  }

  std::size_t size() const { return diagonal_.size(); }     ///< how many bodies
  std::size_t products() const { return products_.size(); } ///< how many of blocks a factor takes

  /// Sets all blocks to zero.
  void clear()
  {
    for (std::vector<Matrix6>* blocks : {&diagonal_, &below_})
    {
      for (Matrix6& block : *blocks)
      {
        block.setZero();
      }
    }
  }

  /// The diagonal block of a body; only its lower half is read.
  Matrix6& diagonal(int body) { return diagonal_[slot(body)]; }

  /// Adds to the block of two coupled bodies, i's row and j's column.
  void add_coupling(int i, int j, const Matrix6& block)
  {
    const int a = place_[index(i)], b = place_[index(j)];
    Matrix6& sum = below_[find(std::max(a, b), std::min(a, b))];
    a < b ? sum += block.transpose() : sum += block;
  }

  /// Factors what the blocks hold; false if it is not positive definite.
  bool factor()
  {
    std::size_t product = 0;
    for (std::size_t j = 0; j < diagonal_.size(); ++j)
    {
      if (!invert_factor(diagonal_[j], inverse_[j]))
      {
        return false;
      }
      const std::size_t first = starts_[j], last = starts_[j + 1];
      for (std::size_t p = first; p < last; ++p)
      {
        below_[p] = (below_[p] * inverse_[j].transpose()).eval();
        diagonal_[index(rows_[p])].noalias() -= below_[p] * below_[p].transpose();
        for (std::size_t q = first; q < p; ++q)
        {
          below_[products_[product++]].noalias() -= below_[p] * below_[q].transpose();
        }
      }
    }
    return true;
  }

  /// Solves H x = b in place; one entry a body.
  void solve(std::vector<Vector6>& x)
  {
    ordered_.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      ordered_[index(place_[i])] = x[i];
    }
    for (std::size_t j = 0; j < x.size(); ++j)
    {
      ordered_[j] = (inverse_[j] * ordered_[j]).eval();
      for (std::size_t p = starts_[j]; p < starts_[j + 1]; ++p)
      {
        ordered_[index(rows_[p])].noalias() -= below_[p] * ordered_[j];
      }
    }
    for (std::size_t j = x.size(); j-- > 0;)
    {
      for (std::size_t p = starts_[j]; p < starts_[j + 1]; ++p)
      {
        ordered_[j].noalias() -= below_[p].transpose() * ordered_[index(rows_[p])];
      }
      ordered_[j] = (inverse_[j].transpose() * ordered_[j]).eval();
    }
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      x[i] = ordered_[index(place_[i])];
    }
  }

private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  std::size_t slot(int body) const { return index(place_[index(body)]); }

  std::size_t find(int row, int column) const
  {
    const auto at = [&](int j)
    { return rows_.begin() + static_cast<std::ptrdiff_t>(starts_[index(j)]); };
    return static_cast<std::size_t>(
        std::lower_bound(at(column), at(column + 1), row) - rows_.begin());
  }

  /// Where each product of two blocks of a column goes.
  void find_products(std::size_t most)
  {
    products_.clear();
    for (std::size_t j = 0; j + 1 < starts_.size() && products_.size() <= most; ++j)
    {
      for (std::size_t p = starts_[j]; p < starts_[j + 1]; ++p)
      {
        for (std::size_t q = starts_[j]; q < p; ++q)
        {
          products_.push_back(find(rows_[p], rows_[q]));
        }
      }
    }
  }

  std::vector<int> place_;            // of each body in the order of elimination
  std::vector<std::size_t> starts_;   // of each column in rows_ and below_
  std::vector<int> rows_;             // of the blocks below the diagonal, column by column
  std::vector<std::size_t> products_; // where each product of blocks goes
  std::vector<Matrix6> diagonal_, inverse_, below_;
  std::vector<Vector6> ordered_;
};
// [block_cholesky]

} // namespace cookbook
