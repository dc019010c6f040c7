// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReadError.h"
#include "Words.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace ink::io
{

/// The lines of a text, one after the other; tells how far they are, and which one cannot be read.
class TextLines
{
public:
  /// @param file what they are of, for messages. It, the text and the progress have to last as long as this
  TextLines(const std::filesystem::path& file, std::string_view text, const Progress& progress)
    : File(file)
    , Rest(text)
    , Size(text.size())
    , Reports(progress)
  {
  }

  /// Goes to the next line. @return false at the end
  bool next()
  {
    if (!nextLine(this->Rest, this->Line))
    {
      return false;
    }
    constexpr std::uint64_t linesOfAStep = 1 << 16;
    if (this->Number++ % linesOfAStep == 0)
    {
      advance(this->Reports, 1.0 - static_cast<double>(this->Rest.size()) / static_cast<double>(this->Size));
    }
    return true;
  }

  std::string_view line() const { return this->Line; }

  /// @throws ReadError that names the line and what was expected of it
  [[noreturn]] void fail(const std::string& expected) const
  {
    failToRead(this->File,
      "line " + std::to_string(this->Number) + " is '" + shortened(this->Line) + "'; expected " + expected);
  }

private:
  const std::filesystem::path& File;
  std::string_view Rest;
  std::size_t Size;
  const Progress& Reports;
  std::string_view Line;
  std::uint64_t Number = 0; ///< of the line, from 1
};

} // namespace ink::io
