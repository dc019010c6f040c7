// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatOrder.h"

#include "vtkDataArray.h"

#include "Core/Hash.h"
#include "Core/ParallelSort.h"

#include <cmath>
#include <utility>

std::vector<std::uint32_t> InkFindSplatOrder(std::uint32_t count, vtkDataArray* priorities)
{
  std::vector<std::pair<double, std::uint32_t>> keys(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const double priority = priorities ? priorities->GetComponent(i, 0) : ink::unitDouble(ink::hash(i));
    // What is no number comes last.
    keys[i] = { std::isnan(priority) ? HUGE_VAL : priority, i };
  }
  ink::parallelSort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    order[i] = keys[i].second;
  }
  return order;
}
