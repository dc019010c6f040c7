// SPDX-License-Identifier: BSD-3-Clause
#include "InkMemoryBudget.h"

#include "Core/FormatNumber.h"

#include "vtksys/SystemInformation.hxx"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace
{

constexpr std::uint64_t Mebibyte = std::uint64_t{ 1 } << 20;
// The program itself with its libraries, which is there whatever it does.
constexpr std::uint64_t Program = 96 * Mebibyte;
constexpr int MostMebibytes = 16777216;

} // namespace

InkMemoryBudget InkMemoryBudget::OfMebibytes(int mebibytes)
{
  return InkMemoryBudget(mebibytes == 0 ? std::numeric_limits<std::uint64_t>::max()
                                        : static_cast<std::uint64_t>(mebibytes) * Mebibyte);
}

std::optional<InkMemoryBudget> InkMemoryBudget::Parse(const std::string& size)
{
  double number = 0.0;
  const char* const end = size.data() + size.size();
  const auto [rest, error] = std::from_chars(size.data(), end, number, std::chars_format::fixed);
  std::string unit(rest, end);
  unit.erase(0, !unit.empty() && unit.front() == ' ' ? 1 : 0);
  unit = vtksys::SystemTools::LowerCase(unit);
  const std::size_t power = unit.empty() ? std::string::npos : std::string("kmgt").find(unit.front());
  const bool isSize = error == std::errc() && std::isdigit(static_cast<unsigned char>(size.front())) != 0 &&
    power != std::string::npos && (unit.size() == 1 || unit.substr(1) == "ib");
  const double bytes = isSize ? std::ldexp(number, 10 * (1 + static_cast<int>(power))) : 0.0;
  constexpr double most = static_cast<double>(MostMebibytes) * Mebibyte;
  return bytes >= static_cast<double>(Least)
    ? std::optional(InkMemoryBudget(static_cast<std::uint64_t>(std::min(bytes, most))))
    : std::nullopt;
}

int InkMemoryBudget::GetMebibytes() const
{
  return static_cast<int>(std::min<std::uint64_t>(this->Limit / Mebibyte, MostMebibytes));
}

std::uint64_t InkMemoryBudget::LimitFor(std::uint64_t size, int part)
{
  // Whole MiB, so that what a message says is enough.
  return (Program + size * static_cast<std::uint64_t>(part) + Mebibyte - 1) / Mebibyte * Mebibyte;
}

std::uint64_t InkMemoryBudget::GetFree() const
{
  return this->Limit - std::min(this->Limit, Program);
}

std::uint64_t InkGetMachineMemory()
{
  vtksys::SystemInformation system;
  std::uint64_t memory = 1024 * static_cast<std::uint64_t>(system.GetHostMemoryTotal());
  // Of control groups, version 2 and 1. Without a limit the former has "max", which is no number.
  for (const char* limit : { "/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes" })
  {
    std::uint64_t allowed = 0;
    if (std::ifstream(limit) >> allowed)
    {
      memory = std::min(memory, allowed);
    }
  }
  return memory;
}

void InkCheckMemory(
  double count, double bytes, const std::string& names, double most, const std::string& advice)
{
  const double fitting = static_cast<double>(InkGetMachineMemory()) / bytes;
  if (count > fitting || count > most)
  {
    throw std::invalid_argument(ink::formatNumber(count) + " " + names + " would take " +
      ink::formatNumber(count * bytes / 0x1p30) + " GiB of memory; expected no more than " +
      ink::formatNumber(std::floor(std::min(fitting, most))) + " " + names + " on this machine" + advice);
  }
}

std::string InkFormatMemory(std::uint64_t bytes)
{
  return std::to_string((bytes + Mebibyte - 1) / Mebibyte) + " MiB";
}
