#include "Parallel/Threads.h"

#include <tbb/info.h>

#include <cstdlib>

namespace ink
{

int threadCount()
{
  if (const char* limit = std::getenv("VTK_SMP_MAX_THREADS"))
  {
    const int threads = std::atoi(limit);
    if (threads > 0)
    {
      return threads;
    }
  }
  return tbb::info::default_concurrency();
}

} // namespace ink
