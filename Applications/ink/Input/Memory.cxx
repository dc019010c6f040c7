// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include "Errors.h"
#include "Pattern.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>

#include <unistd.h>

namespace ink::cli
{
namespace
{

constexpr std::uint64_t mebibyte = std::uint64_t{ 1 } << 20;
// The program itself with its libraries, which is there whatever it does.
constexpr std::uint64_t program = 96 * mebibyte;
constexpr std::uint64_t least = 128 * mebibyte;

} // namespace

Memory::Memory()
{
  auto all =
    static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  // Of a container; "max" if there is no limit, which is no number.
  std::uint64_t allowed = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> allowed)
  {
    all = std::min(all, allowed);
  }
  this->limit = std::max(all / 2, least);
}

Memory Memory::parse(const std::string& size)
{
  static const io::Pattern pattern(R"((\d{1,9}(?:\.\d{1,9})?) ?([KMGT])(?:iB)?)", true);
  const std::vector<std::string> match = pattern.match(size);
  Memory memory;
  double bytes = 0;
  if (!match.empty())
  {
    const char unit = static_cast<char>(std::toupper(static_cast<unsigned char>(match[2][0])));
    bytes = std::ldexp(std::stod(match[1]), 10 * (1 + static_cast<int>(std::string("KMGT").find(unit))));
  }
  if (!(bytes >= static_cast<double>(least)))
  {
    throw UsageError(
      "--memory '" + size + "': expected a size of " + memoryText(least) + " or more, as 800MiB or 4GiB");
  }
  memory.limit = static_cast<std::uint64_t>(bytes);
  return memory;
}

std::uint64_t Memory::limitFor(std::uint64_t size, int part)
{
  // Whole MiB, so that what a message says is enough.
  return (program + size * static_cast<std::uint64_t>(part) + mebibyte - 1) / mebibyte * mebibyte;
}

std::uint64_t Memory::free() const
{
  return this->limit - program;
}

std::string memoryText(std::uint64_t bytes)
{
  return std::to_string((bytes + mebibyte - 1) / mebibyte) + " MiB";
}

} // namespace ink::cli
