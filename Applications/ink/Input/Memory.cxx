// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include "Errors.h"

#include <algorithm>
#include <optional>

namespace ink::cli
{

InkMemoryBudget usualMemory()
{
  return InkMemoryBudget(std::max(InkGetMachineMemory() / 2, InkMemoryBudget::Least));
}

InkMemoryBudget parseMemory(const std::string& size)
{
  const std::optional<InkMemoryBudget> budget = InkMemoryBudget::Parse(size);
  if (!budget)
  {
    throw UsageError("--memory '" + size + "': expected a size of " +
      InkFormatMemory(InkMemoryBudget::Least) + " or more, as 800MiB or 4GiB");
  }
  return *budget;
}

} // namespace ink::cli
