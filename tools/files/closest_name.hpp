#pragma once

/// \file
/// \brief What a reader may have meant by a misspelt name.

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace cookbook
{

/// How many letters must be put in, taken out or replaced to make one word of the other.
inline std::size_t letters_apart(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// `; did you mean NAME?` with the name closest to a word, the first of equals; nothing where more
/// than a third of the word's letters would have to change.
inline std::string meant(const std::string& word, const std::vector<std::string>& names)
{
  if (names.empty() || word.size() > 64)
  {
    return "";
  }
  const auto further = [&word](const std::string& p, const std::string& q)
  { return letters_apart(word, p) < letters_apart(word, q); };
  const std::string& best = *std::min_element(names.begin(), names.end(), further);
  const bool close = 3 * letters_apart(word, best) <= word.size() + 2;
  return close ? std::string("; did you mean ").append(best).append("?") : "";
}

} // namespace cookbook
