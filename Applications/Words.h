#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ink::cli
{

/// Takes the next line, without its end, from the front of text. \return false if there is none
bool nextLine(std::string_view& text, std::string_view& line);

/// Takes the next word between spaces, tabs and ends of lines from the front of text; empty if there is none.
std::string_view nextWord(std::string_view& text);

/// The number that all of word is, with a dot whatever the locale; nan and inf are numbers as well.
std::optional<double> numberIn(std::string_view word);

/// The beginning of a line, for a message; what cannot be printed everywhere becomes a question mark.
std::string shortened(std::string_view line);

} // namespace ink::cli
