#include "CheckVolumeFile.h"

#include "ReadFile.h"
#include "TextHeader.h"

#include <cstdint>
#include <fstream>
#include <limits>
#include <string>

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

/// Counts the words in the rest of stream, up to most.
std::uint64_t countWords(std::istream& stream, std::uint64_t most)
{
  std::uint64_t count = 0;
  std::string word;
  while (count < most && stream >> word)
  {
    ++count;
  }
  return count;
}

void requireValues(const fs::path& file, std::uint64_t found, std::uint64_t expected, const char* what)
{
  if (found < expected)
  {
    failToRead(file,
      "it has " + std::to_string(found) + what + ", but its header promises " + std::to_string(expected));
  }
}

} // namespace

void checkLegacyImage(const fs::path& file)
{
  std::ifstream stream(file);
  std::string line;
  // Version, title, encoding.
  for (int i = 0; i < 3 && std::getline(stream, line); ++i)
  {
  }
  if (!line.starts_with("ASCII"))
  {
    return;
  }
  std::uint64_t points = 0;
  std::uint64_t components = 1;
  std::string word;
  while (stream >> word && word != "LOOKUP_TABLE")
  {
    if (word == "POINT_DATA")
    {
      stream >> points;
    }
    else if (word == "SCALARS")
    {
      // Name, type and perhaps the number of components.
      stream >> word >> word;
      std::getline(stream, line);
      const auto numbers = numbersIn(line);
      components = numbers.empty() ? 1 : static_cast<std::uint64_t>(numbers.front());
    }
  }
  if (word == "LOOKUP_TABLE")
  {
    stream >> word;
    requireValues(file, countWords(stream, points * components), points * components, " values");
  }
}

} // namespace ink::cli
