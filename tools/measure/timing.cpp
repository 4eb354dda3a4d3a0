#include "tools/measure/timing.hpp"

#include "tools/measure/statistics.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <numeric>
#include <random>

#if !defined(COOKBOOK_FLAGS)
#define COOKBOOK_FLAGS "flags unknown"
#endif

namespace cookbook::measure
{
namespace
{

/// The processor's time [s] for as many runs.
double seconds_of(const Timed& method, std::size_t runs)
{
  const double start = processor_seconds();
  for (std::size_t i = 0; i < runs; ++i)
  {
    method.run();
  }
  return processor_seconds() - start;
}

/// How many runs take at least so long; it also warms up.
std::size_t runs_for(const Timed& method, double seconds)
{
  std::size_t runs = 1;
  while (seconds_of(method, runs) < seconds)
  {
    runs *= 2;
  }
  return runs;
}

/// Times [ns] of a call of each method in all repetitions.
std::vector<std::vector<double>>
repeated(const std::vector<Timed>& methods, const std::vector<std::size_t>& runs, int repetitions)
{
  std::vector<std::vector<double>> ns(methods.size());
  std::vector<std::size_t> turns(methods.size());
  std::iota(turns.begin(), turns.end(), std::size_t{0});
  std::mt19937 random(1);
  for (int repetition = 0; repetition < repetitions; ++repetition)
  {
    std::shuffle(turns.begin(), turns.end(), random);
    for (const std::size_t i : turns)
    {
      const double calls = methods[i].calls * static_cast<double>(runs[i]);
      ns[i].push_back(seconds_of(methods[i], runs[i]) * 1e9 / calls);
    }
  }
  return ns;
}

std::string processor()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "processor unknown";
}

std::string compiler()
{
#if defined(__clang__)
  return "clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__);
#else
  return "g++ " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__);
#endif
}

} // namespace

Effort effort_named(const std::string& name)
{
  return name == "quick" ? Effort{7, Effort{}.seconds} : Effort{};
}

double processor_seconds()
{
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

std::vector<std::size_t>
doubtful(const std::vector<Timing>& timings, const std::vector<AtLeast>& limits)
{
  constexpr double most_spread = 1.5, least_of_limit = 0.9;
  const auto of_name = [&](const std::string& name)
  {
    return std::find_if(
        timings.begin(), timings.end(), [&](const Timing& timing) { return timing.name == name; });
  };
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < timings.size(); ++i)
  {
    bool doubted = !(timings[i].usual <= most_spread * timings[i].ns);
    for (const AtLeast& limit : limits)
    {
      const auto slower = of_name(limit.slower), faster = of_name(limit.faster);
      const bool named = timings[i].name == limit.slower || timings[i].name == limit.faster;
      doubted |= named && slower != timings.end() && faster != timings.end() &&
                 slower->ns < least_of_limit * limit.factor * faster->ns;
    }
    if (doubted)
    {
      found.push_back(i);
    }
  }
  return found;
}

std::vector<Timing> time_interleaved(
    const std::vector<Timed>& methods, const Effort& effort, const std::vector<AtLeast>& limits)
{
  std::vector<std::size_t> runs;
  std::vector<Timing> timings;
  const double none = std::numeric_limits<double>::infinity();
  for (const Timed& method : methods)
  {
    runs.push_back(runs_for(method, effort.seconds));
    timings.push_back({method.name, none, none, method.peer});
  }
  for (int attempt = 0; attempt < 3 && (attempt == 0 || !doubtful(timings, limits).empty());
       ++attempt)
  {
    const std::vector<std::vector<double>> ns = repeated(methods, runs, effort.repetitions);
    for (std::size_t i = 0; i < ns.size(); ++i)
    {
      timings[i].ns = std::min(timings[i].ns, *std::min_element(ns[i].begin(), ns[i].end()));
      timings[i].usual = std::min(timings[i].usual, percentile(ns[i], 75));
    }
  }
  for (const std::size_t i : doubtful(timings, limits))
  {
    timings[i].ns = std::numeric_limits<double>::quiet_NaN();
  }
  return timings;
}

std::string time_text(double ns)
{
  return std::isnan(ns) ? "machine was busy" : rounded(ns);
}

std::string machine_line()
{
  return processor() + ", one thread, least processor time; " + compiler() + ", " + COOKBOOK_FLAGS;
}

} // namespace cookbook::measure
