#include "tools/measure/timing.hpp"

#include "tools/measure/statistics.hpp"

#include <benchmark/benchmark.h>

#include <fstream>
#include <map>

#if !defined(COOKBOOK_FLAGS)
#define COOKBOOK_FLAGS "flags unknown"
#endif

namespace cookbook::measure
{
namespace
{

/// Keeps the times of all repetitions instead of printing them.
class Collector : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs)
    {
      if (run.run_type == Run::RT_Iteration)
      {
        ns[run.run_name.function_name].push_back(
            run.real_accumulated_time / static_cast<double>(run.iterations) * 1e9);
      }
    }
  }

  std::map<std::string, std::vector<double>> ns; ///< of a run, by method
};

void initialize(const Effort& effort)
{
  std::string words[] = {
      "measure", "--benchmark_enable_random_interleaving=true",
      "--benchmark_repetitions=" + std::to_string(effort.repetitions),
      "--benchmark_min_time=" + std::to_string(effort.seconds)};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
  int count = 4;
  benchmark::Initialize(&count, arguments);
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
  return name == "quick" ? Effort{5, 0.002} : Effort{};
}

std::vector<Timing> time_interleaved(const std::vector<Timed>& methods, const Effort& effort)
{
  initialize(effort);
  for (const Timed& method : methods)
  {
    benchmark::RegisterBenchmark(
        method.name.c_str(),
        [run = method.run](benchmark::State& state)
        {
          for ([[maybe_unused]] auto turn : state)
          {
            run();
          }
        })
        ->UseRealTime();
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  std::vector<Timing> timings;
  for (const Timed& method : methods)
  {
    timings.push_back({method.name, median(collector.ns.at(method.name)) / method.calls});
  }
  return timings;
}

std::string machine_line()
{
  return processor() + ", one thread; " + compiler() + ", " + COOKBOOK_FLAGS;
}

} // namespace cookbook::measure
