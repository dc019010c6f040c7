// SPDX-License-Identifier: BSD-3-Clause
#include "LegacyFile.h"

#include "Core/FormatNumber.h"
#include "ReadError.h"
#include "Words.h"

#include "vtkDataArray.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

namespace fs = std::filesystem;

namespace ink::io
{

LegacyFile::LegacyFile(const fs::path& file)
  : File(file)
  , Stream(file, std::ios::binary)
  , Size(static_cast<double>(fs::file_size(file)))
{
  constexpr std::string_view start = "# vtk DataFile Version";
  std::string line;
  std::getline(this->Stream, line);
  if (!line.starts_with(start))
  {
    failToRead(this->File, "it is not a legacy VTK file: it does not begin with '# vtk DataFile Version'");
  }
  std::string_view version = std::string_view(line).substr(start.size());
  this->MajorVersion = static_cast<int>(std::clamp(numberIn(nextWord(version)).value_or(0.0), 0.0, 99.0));
  this->endLine(); // a title
  const std::string encoding = this->word("ASCII or BINARY");
  if (encoding != "ascii" && encoding != "binary")
  {
    this->fail(encoding, "ASCII or BINARY");
  }
  this->IsText = encoding == "ascii";
  this->Kind = this->word("DATASET");
  if (this->Kind == "dataset")
  {
    this->Kind = this->word("a kind of dataset");
  }
}

void LegacyFile::fail(const std::string& found, const std::string& expected) const
{
  failAtWord(this->File, found, expected);
}

bool LegacyFile::tryWord(std::string& word)
{
  word.clear();
  this->Stream >> word;
  word = vtksys::SystemTools::LowerCase(word);
  return !word.empty();
}

std::string LegacyFile::word(const char* expected)
{
  std::string word;
  if (!this->tryWord(word))
  {
    this->fail("", expected);
  }
  return word;
}

std::string LegacyFile::name()
{
  std::string name;
  if (!(this->Stream >> name))
  {
    this->fail("", "a name");
  }
  return name;
}

double LegacyFile::number(const char* expected)
{
  const std::string word = this->word(expected);
  std::string_view text = word;
  return takeNumber(text, this->File, expected);
}

double LegacyFile::whole(double least, const char* expected)
{
  const double number = this->number(expected);
  if (number < least || number > std::numeric_limits<int>::max() || number != std::floor(number))
  {
    this->fail(formatNumber(number), expected);
  }
  return number;
}

void LegacyFile::endLine()
{
  std::string rest;
  std::getline(this->Stream, rest);
}

void LegacyFile::beginValues()
{
  if (!this->IsText)
  {
    this->endLine();
  }
}

int LegacyFile::typeOf(const std::string& name)
{
  // As VTK writes them on machines of 64 bits, but for ids, which have 32 in these files.
  static const std::map<std::string, int> types{ { "bit", VTK_BIT }, { "char", VTK_SIGNED_CHAR },
    { "signed_char", VTK_SIGNED_CHAR }, { "unsigned_char", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT },
    { "unsigned_short", VTK_UNSIGNED_SHORT }, { "int", VTK_INT }, { "unsigned_int", VTK_UNSIGNED_INT },
    { "long", VTK_LONG_LONG }, { "unsigned_long", VTK_UNSIGNED_LONG_LONG }, { "vtkidtype", VTK_INT },
    { "vtktypeint64", VTK_LONG_LONG }, { "vtktypeuint64", VTK_UNSIGNED_LONG_LONG }, { "float", VTK_FLOAT },
    { "double", VTK_DOUBLE } };
  const auto type = types.find(name);
  return type == types.end() ? VTK_VOID : type->second;
}

double LegacyFile::cellNumber()
{
  constexpr const char* expected = "a number of cells";
  if (this->IsText)
  {
    return this->whole(std::numeric_limits<int>::min(), expected);
  }
  std::array<unsigned char, 4> bytes{};
  if (!this->Stream.read(reinterpret_cast<char*>(bytes.data()), bytes.size()))
  {
    this->fail("", expected);
  }
  std::uint32_t number = 0;
  for (const unsigned char byte : bytes)
  {
    number = number << 8 | byte;
  }
  return static_cast<std::int32_t>(number);
}

void LegacyFile::skip(double values, int type)
{
  constexpr double bitsOfAByte = 8;
  if (values > this->Size * bitsOfAByte)
  {
    failToRead(this->File, "the file ends within an array that it promises");
  }
  if (!this->IsText)
  {
    const double bytes = type == VTK_BIT ? std::ceil(values / bitsOfAByte)
                                         : values * static_cast<double>(vtkDataArray::GetDataTypeSize(type));
    this->Stream.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
    if (!this->Stream || static_cast<double>(this->Stream.tellg()) > this->Size)
    {
      failToRead(this->File, "the file ends within an array that it promises");
    }
    return;
  }
  for (double i = 0; i < values; ++i)
  {
    if (const std::string word = this->word("a value"); !numberIn(word))
    {
      this->fail(word, "a value");
    }
  }
}

void LegacyFile::skipMetadata()
{
  std::string line;
  this->endLine();
  // Up to an empty line, which a component without a name has as well.
  while (std::getline(this->Stream, line) && line.find_first_not_of(" \t\r") != std::string::npos)
  {
    for (double i = 0; line.starts_with("COMPONENT_NAMES") && i < this->Components; ++i)
    {
      this->endLine();
    }
  }
}

void LegacyFile::skipString()
{
  // The first two bits say how many bytes say its length.
  constexpr std::array<int, 4> sizes{ 8, 4, 2, 1 };
  constexpr unsigned lengthOfFirst = 0x3f;
  const int first = this->Stream.get();
  std::uint64_t length = static_cast<unsigned>(first) & lengthOfFirst;
  for (int i = 1; first >= 0 && i < sizes[static_cast<std::size_t>(first >> 6)]; ++i)
  {
    length = length << 8 | static_cast<std::uint64_t>(this->Stream.get() & 0xff);
  }
  const std::streamoff begin = this->position();
  if (begin < 0 || static_cast<double>(begin) + static_cast<double>(length) > this->Size)
  {
    this->fail("", "a text");
  }
  this->Stream.seekg(static_cast<std::streamoff>(length), std::ios::cur);
}

void LegacyFile::skipStrings(double strings, bool areVariants)
{
  // VTK takes this memory for each, however short it is.
  constexpr double bytesOfAString = 32;
  constexpr double few = 1 << 18;
  constexpr double times = 10;
  if (strings > few && bytesOfAString * strings > times * this->Size)
  {
    failToRead(this->File, "the file ends within an array that it promises");
  }
  const bool areLines = this->IsText || areVariants;
  if (this->IsText)
  {
    this->endLine();
  }
  for (double i = 0; i < strings; ++i)
  {
    std::string line;
    if (!areLines)
    {
      this->skipString();
    }
    else if (!std::getline(this->Stream, line))
    {
      this->fail("", "a text");
    }
  }
}

bool LegacyFile::passValues(
  const std::string& keyword, double tuples, const std::function<bool(const LegacyArray&)>& take)
{
  static const std::map<std::string, double> others{ { "vectors", 3 }, { "normals", 3 }, { "tensors", 9 },
    { "tensors6", 6 }, { "global_ids", 1 }, { "pedigree_ids", 1 }, { "edge_flags", 1 } };
  // Of a color.
  const std::string channel = this->IsText ? "float" : "unsigned_char";
  const auto arrayOf = [&](std::string name, double components) {
    return LegacyArray{ std::move(name), VTK_VOID, components, tuples, 0 };
  };
  if (keyword == "field")
  {
    this->name();
    const double count = this->whole(0, "a number of arrays");
    bool goesOn = true;
    for (double i = 0; i < count && goesOn; ++i)
    {
      std::string name = this->name();
      if (name == "METADATA")
      {
        this->skipMetadata();
        name = this->name();
      }
      LegacyArray array = arrayOf(name, this->whole(0, "a number of components"));
      array.tuples = this->whole(0, "a number of values");
      const std::string typeName = this->word("a type");
      this->beginValues();
      goesOn = this->pass(array, typeName, true, take);
    }
  }
  else if (keyword == "scalars")
  {
    LegacyArray array = arrayOf(this->name(), 1.0);
    array.areScalars = true;
    const std::string typeName = this->word("a type");
    std::string line;
    std::getline(this->Stream, line);
    std::string_view words = line;
    if (const std::string_view count = nextWord(words); !count.empty())
    {
      array.components = numberIn(count).value_or(0.0);
    }
    const std::streampos before = this->Stream.tellg();
    if (this->word("LOOKUP_TABLE") == "lookup_table")
    {
      this->endLine();
    }
    else
    {
      this->Stream.seekg(before);
    }
    this->pass(array, typeName, true, take);
  }
  else if (keyword == "color_scalars" || keyword == "texture_coordinates")
  {
    LegacyArray array = arrayOf(this->name(), 1.0);
    array.components = this->whole(1, "a number of components");
    const std::string typeName = keyword == "color_scalars" ? channel : this->word("a type");
    this->beginValues();
    this->pass(array, typeName, true, take);
  }
  else if (keyword == "lookup_table")
  {
    LegacyArray array = arrayOf(this->name(), 4.0);
    array.tuples = this->whole(0, "a number of colors");
    this->beginValues();
    this->pass(array, channel, false, take);
  }
  else if (const auto other = others.find(keyword); other != others.end())
  {
    const LegacyArray array = arrayOf(this->name(), other->second);
    const std::string typeName = this->word("a type");
    this->beginValues();
    this->pass(array, typeName, true, take);
  }
  else
  {
    return false;
  }
  return true;
}

bool LegacyFile::pass(LegacyArray array, const std::string& typeName, bool areValues,
  const std::function<bool(const LegacyArray&)>& take)
{
  array.type = typeOf(typeName);
  constexpr double mostComponents = 1 << 20;
  const bool isWhole = array.components >= 0 && array.components <= mostComponents &&
    array.components == std::floor(array.components);
  this->Components = array.components;
  const bool areVariants = typeName == "variant";
  if (isWhole && (areVariants || typeName == "string" || typeName == "utf8_string"))
  {
    this->skipStrings(array.tuples * array.components, areVariants);
    return true;
  }
  if (array.type == VTK_VOID || !isWhole)
  {
    failToRead(this->File,
      "its array '" + shortened(array.name) + "' has type '" + shortened(typeName) + "' and " +
        formatNumber(array.components) + " components; expected numbers as float, and 1 component or more");
  }
  array.begin = this->position();
  if (array.begin < 0)
  {
    failToRead(this->File, "the file ends where the values of '" + shortened(array.name) + "' were expected");
  }
  if (areValues && !take(array))
  {
    return false;
  }
  this->skip(array.tuples * array.components, array.type);
  return true;
}

} // namespace ink::io
