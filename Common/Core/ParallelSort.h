// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Threads.h"

#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <functional>

namespace ink
{

/// Sorts on up to ink::threadCount() threads. Not stable.
template <class Iterator, class Less = std::less<>>
void parallelSort(Iterator begin, Iterator end, const Less& less = {})
{
  tbb::task_arena(threadCount()).execute([&] { tbb::parallel_sort(begin, end, less); });
}

} // namespace ink
