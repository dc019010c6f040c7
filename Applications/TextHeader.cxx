#include "TextHeader.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace ink::cli
{
namespace
{

std::string trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t\r");
  const auto last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

} // namespace

std::map<std::string, std::string> readTextHeader(
  const std::filesystem::path& file, char separator, const std::string& lastKey, std::streamoff* size)
{
  std::map<std::string, std::string> fields;
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
    *size = stream ? static_cast<std::streamoff>(stream.tellg())
                   : static_cast<std::streamoff>(std::filesystem::file_size(file));
  }
  return fields;
}

std::vector<double> numbersIn(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == ',' || c == '(' || c == ')'; }, ' ');
  std::istringstream stream(text);
  return { std::istream_iterator<double>(stream), std::istream_iterator<double>() };
}

} // namespace ink::cli
