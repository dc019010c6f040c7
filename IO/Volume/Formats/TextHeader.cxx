// SPDX-License-Identifier: BSD-3-Clause
#include "TextHeader.h"

#include "Pattern.h"
#include "ReadError.h"
#include "Words.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

std::string trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t\r");
  const auto last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// The lines of a file after the one that says LIST, up to an empty one.
std::vector<std::string> listedNames(const fs::path& header, std::size_t most)
{
  std::vector<std::string> names;
  std::ifstream stream(header, std::ios::binary);
  std::string line;
  bool found = false;
  while (names.size() <= most && std::getline(stream, line))
  {
    const std::string_view::size_type list = line.find("LIST");
    if (found && trimmed(line).empty())
    {
      break;
    }
    if (found)
    {
      names.push_back(trimmed(line));
    }
    found = found ||
      (list != std::string::npos && list > 0 &&
        line.find_first_not_of(" \t", line.find_first_of(":=") + 1) == list);
  }
  return names;
}

/// The names that a pattern stands for; empty if it is none.
std::vector<std::string> numberedNames(const std::string& description, std::size_t most)
{
  static const Pattern pattern(
    R"((.*)%(0?)(\d?)d(\S*)\s+(\d{1,6})\s+(\d{1,6})(?:\s+(\d{1,6}))?(?:\s+\d)?\s*)");
  constexpr std::size_t longest = 1024;
  if (description.size() > longest)
  {
    return {};
  }
  const std::vector<std::string> match = pattern.match(description);
  if (match.empty())
  {
    return {};
  }
  const int last = std::stoi(match[6]);
  const int step = !match[7].empty() ? std::stoi(match[7]) : 1;
  const std::size_t width = match[3].length() > 0 ? static_cast<std::size_t>(std::stoi(match[3])) : 0;
  std::vector<std::string> names;
  for (int number = std::stoi(match[5]); number <= last && step > 0 && names.size() <= most; number += step)
  {
    std::string digits = std::to_string(number);
    digits.insert(0, width - std::min(width, digits.size()), match[2].length() > 0 ? '0' : ' ');
    names.push_back(match[1] + digits + match[4]);
  }
  return names;
}

} // namespace

TextFields readTextHeader(
  const fs::path& file, char separator, const std::string& lastKey, std::streamoff* size)
{
  TextFields fields;
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  while (std::getline(stream, line) && !trimmed(line).empty())
  {
    const auto position = line.find(separator);
    if (position == std::string::npos)
    {
      continue;
    }
    const std::string key = trimmed(line.substr(0, position));
    fields[key] = trimmed(line.substr(position + 1));
    if (key == lastKey)
    {
      break;
    }
  }
  if (size)
  {
    *size =
      stream ? static_cast<std::streamoff>(stream.tellg()) : static_cast<std::streamoff>(fs::file_size(file));
  }
  return fields;
}

std::string fieldOf(const TextFields& fields, const char* name, const char* otherName)
{
  for (const char* key : { name, otherName })
  {
    if (const auto found = fields.find(key); found != fields.end())
    {
      return found->second;
    }
  }
  return "";
}

std::vector<fs::path> detachedFiles(const fs::path& header, const std::string& description, int slices)
{
  const auto most = static_cast<std::size_t>(slices);
  std::vector<std::string> names = numberedNames(description, most);
  if (names.empty() && (description == "LIST" || description.starts_with("LIST ")))
  {
    names = listedNames(header, most);
    if (names.empty())
    {
      failToRead(header, "its header promises a list of files; expected a name on each line after it");
    }
  }
  else if (names.empty())
  {
    names = { description };
  }
  if (names.size() > most || most % names.size() != 0)
  {
    failToRead(header,
      "its header names " + std::to_string(names.size()) + (names.size() > most ? " or more" : "") +
        " files for " + std::to_string(slices) + " slices; expected as many in each");
  }
  std::vector<fs::path> files;
  for (const std::string& name : names)
  {
    // A path that is absolute replaces the folder.
    files.push_back(header.parent_path() / name);
    std::error_code error;
    if (!fs::is_regular_file(files.back(), error))
    {
      failToRead(
        header, "there is no file '" + files.back().string() + "', in which its header says the data is");
    }
  }
  return files;
}

std::vector<double> numbersIn(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == ',' || c == '(' || c == ')'; }, ' ');
  std::istringstream stream(text);
  return { std::istream_iterator<double>(stream), std::istream_iterator<double>() };
}

} // namespace ink::io
