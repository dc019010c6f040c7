// SPDX-License-Identifier: BSD-3-Clause
#include "Validators.h"

#include "Core/DidYouMean.h"
#include "Core/FormatNumber.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ink::cli
{
namespace
{

CLI::Validator numberWithin(double least, double greatest, bool whole, const std::string& range)
{
  const std::string expected =
    std::string(whole ? "a whole number" : "a number") + (range.empty() ? "" : " from " + range);
  return { [=](std::string& text)
    {
      double value = 0;
      const bool valid = CLI::detail::lexical_cast(text, value) && value >= least && value <= greatest &&
        (!whole || value == std::floor(value));
      return valid ? std::string() : "'" + text + "': expected " + expected;
    },
    range, "within" };
}

std::string rangeText(double least, double greatest)
{
  return formatNumber(least) + " to " + formatNumber(greatest);
}

} // namespace

CLI::Validator within(double least, double greatest)
{
  return numberWithin(least, greatest, false, rangeText(least, greatest));
}

CLI::Validator anyNumber()
{
  constexpr double most = std::numeric_limits<double>::max();
  return numberWithin(-most, most, false, "");
}

CLI::Validator wholeNumber(double least, double greatest)
{
  return numberWithin(least, greatest, true, rangeText(least, greatest));
}

CLI::Validator oneOf(const std::vector<std::string>& words)
{
  std::string list;
  std::string names;
  for (const std::string& word : words)
  {
    list += (list.empty() ? "" : ",") + word;
    names += (names.empty() ? "" : &word == &words.back() ? " or " : ", ") + word;
  }
  return { [=](std::string& text)
    {
      const bool valid = std::find(words.begin(), words.end(), text) != words.end();
      return valid ? std::string() : "'" + text + "': expected " + names + didYouMean(text, words);
    },
    "{" + list + "}", "one of" };
}

} // namespace ink::cli
