// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkArguments_h
#define BenchmarkArguments_h

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

/// Initializes benchmarks that are run that many times, in a random order, with what the caller gives
/// besides.
/// @return whether all of that is known
inline bool InitializeBenchmarks(int argc, char* argv[], int repetitions)
{
  // What the caller gives comes later and wins.
  std::vector<char*> arguments(argv, argv + 1);
  std::string defaults[] = { "--benchmark_repetitions=" + std::to_string(repetitions),
    "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true",
    "--benchmark_min_time=0.05" };
  for (std::string& argument : defaults)
  {
    arguments.push_back(argument.data());
  }
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  return !benchmark::ReportUnrecognizedArguments(count, arguments.data());
}

#endif
