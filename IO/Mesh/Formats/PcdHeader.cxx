// SPDX-License-Identifier: BSD-3-Clause
#include "PcdHeader.h"

#include "Core/FormatNumber.h"
#include "ReadError.h"
#include "Words.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

/// Collects the header's lines.
class PcdLines
{
public:
  explicit PcdLines(const fs::path& file)
    : File(file)
  {
  }

  /// Takes lines until one that says where points begin.
  PcdHeader take(std::string_view& bytes)
  {
    PcdHeader header;
    while (this->Lines.count("DATA") == 0)
    {
      std::string_view line;
      if (!nextLine(bytes, line))
      {
        failToRead(this->File, "the file ends within its header; expected a line DATA");
      }
      ++header.lines;
      this->add(line);
    }
    this->readFields(header);
    this->readCount(header);
    static const std::map<std::string_view, PcdData> kinds{ { "ascii", PcdData::Text },
      { "binary", PcdData::Binary }, { "binary_compressed", PcdData::Compressed } };
    const std::vector<std::string_view> said = this->wordsOf("DATA");
    const auto kind = kinds.find(said.empty() ? "" : said.front());
    if (kind == kinds.end())
    {
      this->fail("DATA", "ascii, binary or binary_compressed");
    }
    header.data = kind->second;
    return header;
  }

private:
  [[noreturn]] void fail(const char* key, const std::string& expected) const
  {
    const auto line = this->Lines.find(key);
    failToRead(this->File,
      line == this->Lines.end()
        ? std::string("its header says no ") + key + "; expected " + expected
        : std::string("its header says ") + key + " '" + shortened(line->second) + "'; expected " + expected);
  }

  void add(std::string_view line)
  {
    static constexpr std::array<std::string_view, 10> keys{ "VERSION", "FIELDS", "SIZE", "TYPE", "COUNT",
      "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA" };
    std::string_view words = line;
    std::string_view key = nextWord(words);
    if (key.empty() || key.front() == '#')
    {
      return;
    }
    // As versions before 0.5 have it.
    key = key == "COLUMNS" ? "FIELDS" : key;
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
    {
      failToRead(this->File,
        "it is no PCD file, or its header is broken: it says '" + shortened(line) +
          "'; expected VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, VIEWPOINT, POINTS or DATA");
    }
    words.remove_prefix(std::min(words.find_first_not_of(" \t"), words.size()));
    this->Lines[key] = words;
  }

  std::vector<std::string_view> wordsOf(std::string_view key) const
  {
    std::vector<std::string_view> words;
    if (const auto line = this->Lines.find(key); line != this->Lines.end())
    {
      std::string_view rest = line->second;
      for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest))
      {
        words.push_back(word);
      }
    }
    return words;
  }

  /// A word for each field. @param otherwise where the header has no such line, as those of old versions
  std::vector<std::string_view> wordsOfFields(
    const char* key, std::size_t fields, const char* otherwise) const
  {
    if (this->Lines.count(key) == 0)
    {
      return std::vector<std::string_view>(fields, otherwise);
    }
    const std::vector<std::string_view> words = this->wordsOf(key);
    if (words.size() != fields)
    {
      this->fail(key, "a word for each of the " + std::to_string(fields) + " fields");
    }
    return words;
  }

  void readFields(PcdHeader& header) const
  {
    // More than the longest descriptors have.
    constexpr std::size_t mostFields = 4096;
    const std::vector<std::string_view> names = this->wordsOf("FIELDS");
    if (names.empty() || names.size() > mostFields)
    {
      this->fail("FIELDS", "names as x y z, at most " + std::to_string(mostFields));
    }
    const auto sizes = this->wordsOfFields("SIZE", names.size(), "4");
    const auto types = this->wordsOfFields("TYPE", names.size(), "F");
    const auto counts = this->wordsOfFields("COUNT", names.size(), "1");
    static const std::map<std::string, int> vtkTypes{ { "I1", VTK_SIGNED_CHAR }, { "U1", VTK_UNSIGNED_CHAR },
      { "I2", VTK_SHORT }, { "U2", VTK_UNSIGNED_SHORT }, { "I4", VTK_INT }, { "U4", VTK_UNSIGNED_INT },
      { "I8", VTK_LONG_LONG }, { "U8", VTK_UNSIGNED_LONG_LONG }, { "F4", VTK_FLOAT }, { "F8", VTK_DOUBLE } };
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      const auto type = vtkTypes.find(std::string(types[i]) + std::string(sizes[i]));
      if (type == vtkTypes.end())
      {
        failToRead(this->File,
          "its field '" + shortened(names[i]) + "' has TYPE '" + shortened(types[i]) + "' and SIZE '" +
            shortened(sizes[i]) + "'; expected I or U and 1, 2, 4 or 8, or F and 4 or 8");
      }
      constexpr double mostNumbers = 1 << 20;
      const std::optional<double> count = wholeIn(counts[i], mostNumbers);
      if (!count || *count < 1.0)
      {
        this->fail("COUNT", "whole numbers from 1 to " + formatNumber(mostNumbers));
      }
      PcdField field;
      field.name = names[i];
      field.vtkType = type->second;
      field.size = static_cast<std::size_t>(type->first[1] - '0');
      field.count = static_cast<std::size_t>(*count);
      field.offset = header.pointBytes;
      field.index = i;
      header.pointBytes += field.size * field.count;
      header.fields.push_back(field);
    }
  }

  /// An organized cloud has rows and columns, as an image; old files say either those or how many there are.
  void readCount(PcdHeader& header) const
  {
    const auto number = [this](const char* key) -> std::optional<double>
    {
      if (this->Lines.count(key) == 0)
      {
        return std::nullopt;
      }
      // More than any file has.
      constexpr double most = 1e15;
      const std::optional<double> said = wholeIn(this->Lines.find(key)->second, most);
      if (!said)
      {
        this->fail(key, "a whole number from 0 to " + formatNumber(most));
      }
      return said;
    };
    const std::optional<double> points = number("POINTS");
    const std::optional<double> width = number("WIDTH");
    const double product = width.value_or(0.0) * number("HEIGHT").value_or(1.0);
    if (!points && !width)
    {
      this->fail("POINTS", "how many there are");
    }
    if (points && width && *points != product)
    {
      this->fail("POINTS", formatNumber(product) + ", its WIDTH times its HEIGHT");
    }
    constexpr double most = 1e15;
    if (product > most)
    {
      this->fail("WIDTH", "no more than " + formatNumber(most) + " points");
    }
    header.points = static_cast<std::uint64_t>(points.value_or(product));
  }

  /// What all of a word is, without spaces around it; none if that is no whole number from 0 to most.
  static std::optional<double> wholeIn(std::string_view word, double most)
  {
    const std::optional<double> number = numberIn(nextWord(word));
    return number && *number >= 0.0 && *number <= most && *number == std::floor(*number) ? number
                                                                                         : std::nullopt;
  }

  const fs::path& File;
  std::map<std::string_view, std::string_view> Lines; ///< by their first words
};

} // namespace

const PcdField* PcdHeader::find(std::string_view name) const
{
  const auto found = std::find_if(this->fields.begin(), this->fields.end(),
    [name](const PcdField& field) { return field.name == name && field.count == 1; });
  return found == this->fields.end() ? nullptr : &*found;
}

PcdHeader PcdHeader::take(std::string_view& bytes, const fs::path& file)
{
  return PcdLines(file).take(bytes);
}

} // namespace ink::io
