// SPDX-License-Identifier: BSD-3-Clause
#include "Words.h"

#include "ReadError.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <system_error>
#include <utility>

namespace ink::io
{
namespace
{

constexpr std::string_view space = " \t\r\n\v\f";

} // namespace

bool nextLine(std::string_view& text, std::string_view& line)
{
  if (text.empty())
  {
    return false;
  }
  const std::size_t end = std::min(text.find('\n'), text.size());
  line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r'))
  {
    line.remove_suffix(1);
  }
  return true;
}

std::string_view nextWord(std::string_view& text)
{
  text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(space));
  text.remove_prefix(word.size());
  return word;
}

std::optional<double> numberIn(std::string_view word)
{
  if (word.starts_with('+'))
  {
    word.remove_prefix(1);
  }
  double number = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error == std::errc::invalid_argument || end != word.data() + word.size())
  {
    return std::nullopt;
  }
  // from_chars does not say whether it is too large or too small.
  return error == std::errc::result_out_of_range ? std::strtod(std::string(word).c_str(), nullptr) : number;
}

std::string shortened(std::string_view line)
{
  constexpr std::size_t most = 40;
  std::string text(line.substr(0, most));
  // A file that is not text may say anything.
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return line.size() <= most ? text : text + "...";
}

void failAtWord(const std::filesystem::path& file, std::string_view found, const std::string& expected)
{
  failToRead(file,
    (found.empty() ? "the file ends" : "it says '" + shortened(found) + "'") + " where " + expected +
      " was expected");
}

double takeNumber(std::string_view& text, const std::filesystem::path& file, const char* expected)
{
  const std::string_view word = nextWord(text);
  const std::optional<double> number = numberIn(word);
  if (!number || !std::isfinite(*number))
  {
    failAtWord(file, word, expected);
  }
  return *number;
}

int takeWhole(std::string_view& text, int least, const std::filesystem::path& file, const char* expected)
{
  const std::string_view word = nextWord(text);
  const double number = numberIn(word).value_or(std::nan(""));
  if (!(number >= least && number <= std::numeric_limits<int>::max()) || number != std::floor(number))
  {
    failAtWord(file, word, expected);
  }
  return static_cast<int>(number);
}

bool comesBefore(const std::string& a, const std::string& b)
{
  const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size())
  {
    if (isDigit(a[i]) && isDigit(b[j]))
    {
      const auto numberAt = [&](const std::string& text, std::size_t& position)
      {
        const std::size_t begin = std::min(text.find_first_not_of('0', position), text.size());
        for (position = begin; position < text.size() && isDigit(text[position]); ++position)
        {
        }
        return text.substr(begin, position - begin);
      };
      const std::string first = numberAt(a, i);
      const std::string second = numberAt(b, j);
      if (first != second)
      {
        return std::pair(first.size(), first) < std::pair(second.size(), second);
      }
    }
    else if (a[i] != b[j])
    {
      return a[i] < b[j];
    }
    else
    {
      ++i;
      ++j;
    }
  }
  return std::pair(a.size() - i, a) < std::pair(b.size() - j, b);
}

} // namespace ink::io
