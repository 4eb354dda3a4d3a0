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
};

/// How long to measure.
struct Effort
{
  int repetitions = 31;  ///< of each method, in random turns
  double seconds = 0.02; ///< at least, for each repetition
};

/// The effort that --effort names: brief where it is `quick`.
Effort effort_named(const std::string& name);

/// What a call costs.
struct Timing
{
  std::string name;
  double ns; ///< [ns] a call, the median of all repetitions
};

/// Times all methods in one run, their repetitions in random turns: whatever else the machine does
/// meanwhile slows all of them alike, so that their ratios hold.
std::vector<Timing> time_interleaved(const std::vector<Timed>& methods, const Effort& effort = {});

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
