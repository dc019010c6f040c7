// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOCoreModule.h" // for the export macro

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ink::io
{

/// Takes the next line, without its end, from the front of text. @return false if there is none
VTKINKIOCORE_EXPORT bool nextLine(std::string_view& text, std::string_view& line);

/// Takes the next word between spaces, tabs and ends of lines from the front of text; empty if there is none.
VTKINKIOCORE_EXPORT std::string_view nextWord(std::string_view& text);

/// The number that all of word is, with a dot whatever the locale; nan and inf are numbers as well.
VTKINKIOCORE_EXPORT std::optional<double> numberIn(std::string_view word);

/// The beginning of a line, for a message; what cannot be printed everywhere becomes a question mark.
VTKINKIOCORE_EXPORT std::string shortened(std::string_view line);

/// Says what was found, a word or, if it is empty, the file's end. @throws ReadError always
[[noreturn]] VTKINKIOCORE_EXPORT void failAtWord(
  const std::filesystem::path& file, std::string_view found, const std::string& expected);

/// Takes a finite number, or a whole one of at least `least`, from the front of text. @param expected what it
/// is, for the message. @throws ReadError if the next word is none
VTKINKIOCORE_EXPORT double takeNumber(
  std::string_view& text, const std::filesystem::path& file, const char* expected);
VTKINKIOCORE_EXPORT int takeWhole(
  std::string_view& text, int least, const std::filesystem::path& file, const char* expected);

/// Whether a name comes before another, numbers in them by their value, so that 10 comes after 9.
VTKINKIOCORE_EXPORT bool comesBefore(const std::string& a, const std::string& b);

} // namespace ink::io
