// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include "Errors.h"

#include <algorithm>
#include <fstream>

#include <unistd.h>

namespace ink::cli
{

InkMemoryBudget usualMemory()
{
  auto all =
    static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  // Of a container; "max" if there is no limit, which is no number.
  std::uint64_t allowed = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> allowed)
  {
    all = std::min(all, allowed);
  }
  return InkMemoryBudget(std::max(all / 2, InkMemoryBudget::Least));
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
