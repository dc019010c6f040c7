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

/// Of a NRRD type, which has up to three names each.
std::uint64_t nrrdTypeSize(const std::string& type)
{
  const auto has = [&type](const char* part) { return type.find(part) != std::string::npos; };
  if (has("64") || has("long long") || has("longlong") || has("double"))
  {
    return 8;
  }
  if (has("16") || has("short"))
  {
    return 2;
  }
  return has("8") || has("char") ? 1 : 4;
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

void checkNrrd(const fs::path& file)
{
  std::string magic(4, ' ');
  std::ifstream(file, std::ios::binary).read(magic.data(), 4);
  if (magic != "NRRD")
  {
    failToRead(file, "it is not a NRRD volume");
  }
  std::streamoff headerSize = 0;
  const auto fields = readTextHeader(file, ':', "", &headerSize);
  for (const char* name : { "type", "dimension", "sizes", "encoding" })
  {
    if (fields.count(name) == 0)
    {
      failToRead(file, std::string("its header has no field '") + name + "'");
    }
  }
  const auto field = [&fields](const char* name)
  {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string() : found->second;
  };
  // VTK's reader crashes on other numbers of dimensions.
  const auto sizes = numbersIn(field("sizes"));
  const auto dimensions = numbersIn(field("dimension"));
  if (dimensions.size() != 1 || (dimensions[0] != 3 && dimensions[0] != 4) || sizes.size() != dimensions[0])
  {
    failToRead(file,
      "its header says dimension '" + field("dimension") + "' and sizes '" + field("sizes") +
        "'; expected 3 or 4 sizes");
  }
  std::uint64_t values = 1;
  constexpr double largestSize = 1 << 30;
  for (const double size : sizes)
  {
    if (!(size >= 1 && size <= largestSize) ||
      values > std::numeric_limits<std::uint64_t>::max() / 64 / static_cast<std::uint64_t>(size))
    {
      failToRead(file,
        "its header says sizes '" + field("sizes") + "'; expected sizes from 1 to " +
          std::to_string(static_cast<long>(largestSize)) + " that memory can hold");
    }
    values *= static_cast<std::uint64_t>(size);
  }

  // The data may lie in a file, or several ("LIST", patterns with %), beside the header.
  fs::path data = file;
  const std::string detached = field("data file") + field("datafile");
  if (!detached.empty())
  {
    headerSize = 0;
    data = file.parent_path() / detached;
    if (!fs::is_regular_file(data))
    {
      if (detached.starts_with("LIST") || detached.find('%') != std::string::npos)
      {
        return;
      }
      failToRead(file, "there is no file '" + data.string() + "', in which its header says the data is");
    }
  }
  else if (static_cast<std::uint64_t>(headerSize) == fs::file_size(file))
  {
    failToRead(file, "the file ends within or after its header");
  }
  const std::string encoding = field("encoding");
  if (encoding == "raw")
  {
    requireValues(file, fs::file_size(data) - static_cast<std::uint64_t>(headerSize),
      values * nrrdTypeSize(field("type")), " bytes of data");
  }
  else if (encoding != "gzip" && encoding != "gz")
  {
    // VTK reads text as well, but wrongly.
    failToRead(file, "its encoding is '" + encoding + "'; expected raw or gzip");
  }
}

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
