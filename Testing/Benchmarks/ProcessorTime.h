// SPDX-License-Identifier: BSD-3-Clause
// Processor time of this process: of all threads, and so hardly touched by what else the machine does.
#ifndef ProcessorTime_h
#define ProcessorTime_h

#include <algorithm>
#include <ctime>
#include <functional>
#include <limits>

/// In milliseconds, so far.
inline double ProcessorTime()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// The least of some runs, in milliseconds.
inline double LeastProcessorTime(int runs, const std::function<void()>& body)
{
  double least = std::numeric_limits<double>::max();
  for (int run = 0; run < runs; ++run)
  {
    const double begin = ProcessorTime();
    body();
    least = std::min(least, ProcessorTime() - begin);
  }
  return least;
}

#endif
