// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <ios>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ink::io
{

/// Keys and values.
using TextFields = std::map<std::string, std::string>;

/// The fields of a header made of lines "key separator value", up to the first line that is empty or whose
/// key is lastKey. Keys and values come without the space around them; lines without separator are skipped.
/// @param size where to store the header's size in bytes, if not null: what follows it starts there.
TextFields readTextHeader(const std::filesystem::path& file, char separator, const std::string& lastKey,
  std::streamoff* size = nullptr);

/// The value of a field under one of two names; empty if there is none.
std::string fieldOf(const TextFields& fields, const char* name, const char* otherName = "");

/// The files in which a header says the data lies, beside the header if no folder is named: one name, LIST
/// with a name on each line after it, or a pattern as slice%03d.raw with the first number, the last and the
/// step. @param description the field's value @param slices at most that many files @throws ReadError if
/// there is no such file, or slices cannot be shared out to them.
std::vector<std::filesystem::path> detachedFiles(
  const std::filesystem::path& header, const std::string& description, int slices);

/// All numbers in text, which may stand between spaces, commas and parentheses.
std::vector<double> numbersIn(std::string text);

} // namespace ink::io
