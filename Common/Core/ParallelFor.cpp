// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ParallelFor.h"

#include "Core/Threads.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <thread>

namespace ink
{

bool parallelFor(std::size_t count, const std::function<void(std::size_t)>& body, const Progress& progress)
{
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> stopped = false;
  std::atomic<std::size_t> done = 0;
  const auto step = [&](std::size_t i)
  {
    if (stopped)
    {
      return;
    }
    body(i);
    ++done;
    if (progress && std::this_thread::get_id() == caller &&
      !progress(static_cast<double>(done) / static_cast<double>(count)))
    {
      stopped = true;
    }
  };
  if (count <= 1)
  {
    if (count == 1)
    {
      step(0);
    }
    return !stopped;
  }
  tbb::task_arena(threadCount()).execute([&] { tbb::parallel_for(std::size_t(0), count, step); });
  return !stopped;
}

} // namespace ink
