#pragma once

/// \file
/// \brief Solves sparse symmetric systems whose unknowns come in sixes, one six a body.

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace cookbook
{

/// Linear and angular part of one body.
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// What one body's six feel of another's.
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// [ordering]
/// An order of elimination of `count` unknowns that keeps the fill small, from which pairs of them
/// are coupled: approximate minimum degree. The k-th entry says what comes k-th.
inline std::vector<int>
elimination_order(int count, const std::vector<std::pair<int, int>>& coupled)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < count; ++i)
  {
    entries.emplace_back(i, i, 1.0);
  }
  for (const auto& [i, j] : coupled)
  {
    entries.emplace_back(i, j, 1.0);
    entries.emplace_back(j, i, 1.0);
  }
  Eigen::SparseMatrix<double> pattern(count, count);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(pattern, order);
  return {order.indices().data(), order.indices().data() + count};
}
// [ordering]

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
    find_rows(count, coupled);
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
    std::fill(diagonal_.begin(), diagonal_.end(), Matrix6::Zero());
    std::fill(below_.begin(), below_.end(), Matrix6::Zero());
  }

  /// The diagonal block of a body; only its lower half is read.
  Matrix6& diagonal(int body) { return diagonal_[slot(body)]; }

  /// Where the block of two coupled bodies is; true if it is to be added transposed, as block (j,
  /// i).
  std::pair<std::size_t, bool> coupling(int i, int j) const
  {
    const int row = std::max(place_[index(i)], place_[index(j)]);
    const int column = std::min(place_[index(i)], place_[index(j)]);
    return {find(row, column), place_[index(i)] < place_[index(j)]};
  }

  /// A block below the diagonal, as coupling() found it.
  Matrix6& block(std::size_t at) { return below_[at]; }

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
    const auto first = rows_.begin() + static_cast<std::ptrdiff_t>(starts_[index(column)]);
    const auto last = rows_.begin() + static_cast<std::ptrdiff_t>(starts_[index(column) + 1]);
    return static_cast<std::size_t>(std::lower_bound(first, last, row) - rows_.begin());
  }

  /// The rows of each column: those coupled to it, and what earlier columns fill in.
  void find_rows(int count, const std::vector<std::pair<int, int>>& coupled)
  {
    std::vector<std::vector<int>> rows(index(count));
    for (const auto& [i, j] : coupled)
    {
      const int a = place_[index(i)], b = place_[index(j)];
      rows[index(std::min(a, b))].push_back(std::max(a, b));
    }
    starts_.assign(1, 0);
    rows_.clear();
    for (std::size_t j = 0; j < rows.size(); ++j)
    {
      std::vector<int>& own = rows[j];
      std::sort(own.begin(), own.end());
      own.erase(std::unique(own.begin(), own.end()), own.end());
      if (!own.empty())
      {
        std::vector<int>& parent = rows[index(own.front())];
        parent.insert(parent.end(), own.begin() + 1, own.end());
      }
      rows_.insert(rows_.end(), own.begin(), own.end());
      starts_.push_back(rows_.size());
    }
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

  /// The inverse of the lower triangular factor of a block; false if it has none.
  static bool invert_factor(const Matrix6& block, Matrix6& inverse)
  {
    double l[6][6];
    inverse.setZero();
    for (int j = 0; j < 6; ++j)
    {
      double d = block(j, j);
      for (int k = 0; k < j; ++k)
      {
        d -= l[j][k] * l[j][k];
      }
      if (!(d > 0))
      {
        return false;
      }
      const double per = 1 / std::sqrt(d);
      for (int i = j + 1; i < 6; ++i)
      {
        double s = block(i, j);
        for (int k = 0; k < j; ++k)
        {
          s -= l[i][k] * l[j][k];
        }
        l[i][j] = s * per;
      }
      inverse(j, j) = per;
      for (int i = 0; i < j; ++i)
      {
        double s = 0;
        for (int k = i; k < j; ++k)
        {
          s -= l[j][k] * inverse(k, i);
        }
        inverse(j, i) = s * per;
      }
    }
    return true;
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
