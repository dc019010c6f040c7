// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Threads.h"

#include <tbb/info.h>

#include <algorithm>
#include <cstdlib>

namespace ink
{

int threadCount()
{
  const int available = tbb::info::default_concurrency();
  if (const char* limit = std::getenv("VTK_SMP_MAX_THREADS"))
  {
    const int threads = std::atoi(limit);
    if (threads > 0)
    {
      return std::min(threads, available);
    }
  }
  return available;
}

} // namespace ink
