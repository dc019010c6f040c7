#pragma once

#include "Parallel/Threads.h"

#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <functional>

namespace ink
{

/// Sorts on up to ink::threadCount() threads. Equal elements come in no particular order.
template <class Iterator, class Less = std::less<>>
void parallelSort(Iterator begin, Iterator end, const Less& less = {})
{
  tbb::task_arena(threadCount()).execute([&] { tbb::parallel_sort(begin, end, less); });
}

} // namespace ink
