#pragma once

/// \file
/// \brief Times methods against each other: all of them in one run, in random turns.

#include <functional>
#include <string>
#include <vector>

namespace cookbook::measure
{

/// Something to be timed.
struct Timed
{
  std::string name;
  std::function<void()> run; ///< does all calls once
  double calls;              ///< how many calls `run` stands for
  bool peer = false;         ///< whether it is another library's
};

/// How long to measure.
struct Effort
{
  int repetitions = 41;   ///< of each method, in random turns
  double seconds = 0.005; ///< at least, for each repetition
};

/// The effort that --effort names: brief where it is `quick`.
Effort effort_named(const std::string& name);

/// What a call costs, in processor time.
struct Timing
{
  std::string name;
  double ns;         ///< [ns] a call, the least of all repetitions; NaN where the machine was busy
  double usual;      ///< [ns] a call, what three of four repetitions do not exceed
  bool peer = false; ///< whether it is another library's
};

/// That a method takes at least `factor` times as long as another: the whole as long as its part,
/// a count of operations as long as they take at the processor's peak.
struct AtLeast
{
  std::string slower, faster;
  double factor = 1;
};

// [doubtful]
/// The places of timings that cannot be right: those with `usual` above 1.5 times `ns`, and both
/// of a pair that breaks its limit by more than a tenth, which is what a compiler's layout of code
/// may cost. A limit whose methods are not there says nothing.
std::vector<std::size_t>
doubtful(const std::vector<Timing>& timings, const std::vector<AtLeast>& limits = {});
// [doubtful]

/// Times all methods in one run, their repetitions in random turns, so that the machine is the same
/// to all of them. Where a result is doubtful, all are timed again, up to twice; what is doubtful
/// even then has NaN as its time.
std::vector<Timing> time_interleaved(
    const std::vector<Timed>& methods, const Effort& effort = {},
    const std::vector<AtLeast>& limits = {});

/// A time for a table: rounded, or that the machine was busy.
std::string time_text(double ns);

/// The time [s] that the processor has given to this thread so far.
double processor_seconds();

/// Makes the compiler believe that a value is read, so that it must be computed.
template <class Value>
void keep(const Value& value)
{
  asm volatile("" : : "m"(value) : "memory");
}

/// A call for each of some inputs, of which it keeps a copy.
template <class Input, class Call>
Timed timed_over(const std::string& name, const std::vector<Input>& inputs, Call call)
{
  const auto run = [inputs, call]
  {
    for (const Input& input : inputs)
    {
      keep(call(input));
    }
  };
  return {name, run, static_cast<double>(inputs.size())};
}

/// Machine, compiler and flags in one line, for the caption of a chart.
std::string machine_line();

} // namespace cookbook::measure
