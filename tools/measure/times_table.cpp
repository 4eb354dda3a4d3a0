#include "tools/measure/times_table.hpp"

#include <limits>

namespace cookbook::measure
{

void add_column(std::vector<TimingRow>& rows, const std::vector<Timing>& timings)
{
  rows.resize(timings.size());
  for (std::size_t i = 0; i < timings.size(); ++i)
  {
    rows[i].push_back(timings[i]);
  }
}

double fastest_peer(const std::vector<TimingRow>& rows, std::size_t workload)
{
  double least = std::numeric_limits<double>::infinity();
  for (const TimingRow& row : rows)
  {
    least = row[workload].peer && row[workload].ns < least ? row[workload].ns : least;
  }
  return least;
}

Cells times_table(
    const std::string& what, const std::vector<std::string>& workloads,
    const std::vector<TimingRow>& rows)
{
  Cells cells{{what + " [ns a pair]"}};
  for (const std::string& workload : workloads)
  {
    cells[0].insert(cells[0].end(), {workload, "× peer"});
  }
  for (const TimingRow& row : rows)
  {
    cells.push_back({row[0].name});
    for (std::size_t w = 0; w < workloads.size(); ++w)
    {
      cells.back().push_back(time_text(row[w].ns));
      cells.back().push_back(rounded(fastest_peer(rows, w) / row[w].ns));
    }
  }
  return cells;
}

} // namespace cookbook::measure
