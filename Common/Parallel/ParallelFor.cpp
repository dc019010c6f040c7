#include "Parallel/ParallelFor.h"

#include "Parallel/Threads.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
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
  // More threads than the hardware has, where the user wants that.
  const int threads = threadCount();
  const tbb::global_control workers(tbb::global_control::max_allowed_parallelism,
    static_cast<std::size_t>(std::max(threads, tbb::info::default_concurrency())));
  tbb::task_arena(threads).execute([&] { tbb::parallel_for(std::size_t(0), count, step); });
  return !stopped;
}

} // namespace ink
