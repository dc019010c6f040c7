#include "CheckMeshFile.h"

#include "CheckXmlFile.h"
#include "ReadFile.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

/// A property of a PLY element, sizes in bytes. A list is a number followed by as many items.
struct Property
{
  int itemSize;
  int countSize = 0; ///< 0: not a list
};

struct Element
{
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

struct PlyHeader
{
  std::string format;
  std::vector<Element> elements;
};

int plyTypeSize(const std::string& type)
{
  static const std::map<std::string, int> sizes{ { "char", 1 }, { "int8", 1 }, { "uchar", 1 }, { "uint8", 1 },
    { "short", 2 }, { "int16", 2 }, { "ushort", 2 }, { "uint16", 2 }, { "int", 4 }, { "int32", 4 },
    { "uint", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 }, { "double", 8 }, { "float64", 8 } };
  const auto size = sizes.find(type);
  return size == sizes.end() ? 0 : size->second;
}

PlyHeader readPlyHeader(std::istream& stream, const fs::path& file)
{
  PlyHeader header;
  std::string line;
  if (!std::getline(stream, line) || line.substr(0, 3) != "ply")
  {
    failToRead(file, "it is not a PLY mesh");
  }
  while (std::getline(stream, line))
  {
    std::istringstream words(line);
    std::string keyword;
    std::string type;
    words >> keyword >> type;
    if (keyword == "end_header")
    {
      return header;
    }
    if (keyword == "format")
    {
      header.format = type;
    }
    else if (keyword == "element")
    {
      Element element;
      element.name = type;
      if (!(words >> element.count) || element.count < 0)
      {
        failToRead(file, "its header says '" + line + "'; expected a number of elements");
      }
      header.elements.push_back(element);
    }
    else if (keyword == "property" && !header.elements.empty())
    {
      Property property{ plyTypeSize(type) };
      if (type == "list")
      {
        std::string countType;
        std::string itemType;
        words >> countType >> itemType;
        property = { plyTypeSize(itemType), plyTypeSize(countType) };
      }
      if (property.itemSize == 0 || (type == "list" && (property.countSize == 0 || property.countSize == 8)))
      {
        failToRead(file, "its header says '" + line + "'; the type is unknown");
      }
      header.elements.back().properties.push_back(property);
    }
  }
  failToRead(file, "the file ends within its header");
}

/// The length of a list from its bytes; -1 if the stream ends.
std::int64_t readCount(std::istream& stream, int size, bool bigEndian)
{
  std::array<unsigned char, 8> bytes{};
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), size))
  {
    return -1;
  }
  if (bigEndian)
  {
    std::reverse(bytes.begin(), bytes.begin() + size);
  }
  std::int64_t count = 0;
  for (int i = size - 1; i >= 0; --i)
  {
    count = count * 256 + bytes[i];
  }
  return count;
}

bool skipBinary(std::istream& stream, const Element& element, bool bigEndian, std::int64_t fileSize)
{
  for (std::int64_t i = 0; i < element.count; ++i)
  {
    for (const Property& property : element.properties)
    {
      const std::int64_t count =
        property.countSize == 0 ? 1 : readCount(stream, property.countSize, bigEndian);
      if (count < 0 || count > fileSize || !stream.seekg(count * property.itemSize, std::ios::cur) ||
        stream.tellg() > fileSize)
      {
        return false;
      }
    }
  }
  return true;
}

/// VTK expects one element a line.
bool skipText(std::istream& stream, const Element& element)
{
  std::string line;
  for (std::int64_t i = 0; i < element.count; ++i)
  {
    if (!std::getline(stream, line))
    {
      return false;
    }
    std::istringstream words(line);
    for (const Property& property : element.properties)
    {
      std::int64_t count = 1;
      if (property.countSize != 0 && !(words >> count))
      {
        return false;
      }
      std::string word;
      for (; count > 0; --count)
      {
        if (!(words >> word))
        {
          return false;
        }
      }
    }
  }
  return true;
}

/// A whole text ends with "endsolid" and perhaps a name.
void checkTextStl(const fs::path& file)
{
  if (fileTail(file, 512).find("endsolid") == std::string::npos)
  {
    failToRead(file, "the file ends without 'endsolid', the end of an STL text");
  }
}

} // namespace

void checkPly(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  const PlyHeader header = readPlyHeader(stream, file);
  const bool bigEndian = header.format == "binary_big_endian";
  const bool binary = bigEndian || header.format == "binary_little_endian";
  if (!binary && header.format != "ascii")
  {
    failToRead(file,
      "its format is '" + header.format + "'; expected ascii, binary_little_endian or binary_big_endian");
  }
  const auto fileSize = static_cast<std::int64_t>(fs::file_size(file));
  for (const Element& element : header.elements)
  {
    // Without properties an element takes no bytes, and any number of them fits.
    if (element.properties.empty() && element.count > 0)
    {
      failToRead(file, "its header gives the elements '" + element.name + "' no properties");
    }
    if (!(binary ? skipBinary(stream, element, bigEndian, fileSize) : skipText(stream, element)))
    {
      failToRead(file,
        "the file ends, or a line is too short, within the " + std::to_string(element.count) + " elements '" +
          element.name + "' that its header promises");
    }
  }
}

void checkStl(const fs::path& file)
{
  constexpr std::uint64_t headerSize = 84;
  constexpr std::uint64_t triangleSize = 50;
  std::array<char, headerSize> header{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(header.data(), headerSize);
  // Binary files may start with "solid" as well, but not go on with printable text.
  const bool textual = std::memcmp(header.data(), "solid", 5) == 0 &&
    std::none_of(header.begin(), header.begin() + stream.gcount(),
      [](unsigned char c) { return c < ' ' && c != '\n' && c != '\r' && c != '\t'; });
  if (textual)
  {
    checkTextStl(file);
    return;
  }
  std::uint64_t triangles = 0;
  for (int i = 3; i >= 0; --i)
  {
    triangles = triangles * 256 + static_cast<unsigned char>(header[80 + i]);
  }
  if (triangles == 0)
  {
    failToRead(file, "it holds no triangles");
  }
  const std::uint64_t found = fs::file_size(file);
  const std::uint64_t expected = headerSize + triangles * triangleSize;
  if (found < expected)
  {
    failToRead(file,
      "it has " + std::to_string(found) + " bytes, but " + std::to_string(triangles) +
        " triangles of a binary STL need " + std::to_string(expected));
  }
}

void checkObj(const fs::path& file)
{
  std::ifstream stream(file);
  std::string line;
  std::string last;
  while (std::getline(stream, line))
  {
    last = line.find_first_not_of(" \t\r") == std::string::npos ? last : line;
  }
  std::istringstream words(last);
  const std::vector<std::string> found{ std::istream_iterator<std::string>(words), {} };
  const bool needsThree =
    !found.empty() && (found.front() == "v" || found.front() == "vn" || found.front() == "f");
  if (needsThree && found.size() < 4)
  {
    failToRead(file, "its last line, '" + last + "', is cut off");
  }
}

} // namespace ink::cli
