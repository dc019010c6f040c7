// SPDX-License-Identifier: BSD-3-Clause
#include "CheckXmlFile.h"

#include "Core/FormatNumber.h"
#include "PromptXmlParser.h"
#include "ReadError.h"
#include "VtkMessages.h"
#include "Words.h"

#include "vtkNew.h"
#include "vtkXMLDataElement.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

std::string fileTail(const fs::path& file, std::size_t size)
{
  std::ifstream stream(file, std::ios::binary);
  const std::uint64_t fileSize = fs::file_size(file);
  stream.seekg(static_cast<std::streamoff>(fileSize - std::min<std::uint64_t>(fileSize, size)));
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

std::string attribute(vtkXMLDataElement* element, const char* name)
{
  const char* value = element->GetAttribute(name);
  return value ? value : "";
}

/// The bytes of a type by its name, as Float32. Of others than numbers, 1.
double typeSize(std::string_view name)
{
  const auto has = [name](std::string_view end) { return name.ends_with(end); };
  constexpr double bitsOfAByte = 8;
  return has("64") ? 64 / bitsOfAByte : (has("32") ? 32 / bitsOfAByte : (has("16") ? 16 / bitsOfAByte : 1));
}

/// The first bytes of what base64 text says; fewer if it is none.
std::vector<unsigned char> decoded(std::string_view text, std::size_t most)
{
  static constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  std::uint32_t word = 0;
  int count = 0;
  for (const char c : text)
  {
    if (std::isspace(static_cast<unsigned char>(c)))
    {
      continue;
    }
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos || bytes.size() >= most)
    {
      break;
    }
    word = word << 6 | static_cast<std::uint32_t>(digit);
    if (++count % 4 == 0)
    {
      for (int shift = 16; shift >= 0; shift -= 8)
      {
        bytes.push_back(static_cast<unsigned char>(word >> shift));
      }
    }
  }
  return bytes;
}

class XmlCheck
{
public:
  XmlCheck(const fs::path& file, PromptXmlParser* parser)
    : File(file)
    , Parser(parser)
    , Stream(file, std::ios::binary)
    , Size(static_cast<double>(fs::file_size(file)))
  {
    vtkXMLDataElement* root = parser->GetRootElement();
    this->IsCompressed = !attribute(root, "compressor").empty();
    this->HeaderSize = attribute(root, "header_type") == "UInt64" ? 8 : 4;
    this->IsBigEndian = attribute(root, "byte_order") == "BigEndian";
    // A digit and a space may be a number of 8 bytes; of compressors in VTK, LZMA makes most of a byte.
    constexpr double mostOfText = 4;
    constexpr double mostOfCompressed = 8192;
    this->Most = this->Size * (this->IsCompressed ? mostOfCompressed : mostOfText);
    this->checkElement(root);
  }

  /// A value has a byte at least.
  double mostValues() const { return this->IsCompressed ? this->Most : this->Size; }

private:
  [[noreturn]] void fail(vtkXMLDataElement* element, const std::string& found) const
  {
    failToRead(this->File,
      std::string("its element ") + (element->GetName() ? element->GetName() : "") + " promises " + found +
        ", for which the file of " + formatNumber(this->Size) + " bytes is too short");
  }

  double number(vtkXMLDataElement* element, const char* name, double otherwise) const
  {
    const std::string value = attribute(element, name);
    if (value.empty())
    {
      return otherwise;
    }
    // VTK's writers leave room for offsets that they know last.
    std::string_view words = value;
    const std::optional<double> number = numberIn(nextWord(words));
    if (!number || !(*number >= 0.0) || *number != std::floor(*number))
    {
      failToRead(this->File,
        std::string("its element ") + element->GetName() + " says " + name + " '" + shortened(value) +
          "'; expected a whole number");
    }
    return *number;
  }

  /// First and last point along x, y and z.
  using Extent = std::array<double, 6>;

  Extent extentOf(vtkXMLDataElement* element, const char* name) const
  {
    const std::string value = attribute(element, name);
    std::string_view words = value;
    Extent extent{};
    for (std::size_t i = 0; i < extent.size(); i += 2)
    {
      const std::optional<double> first = numberIn(nextWord(words));
      const std::optional<double> last = numberIn(nextWord(words));
      constexpr double most = 1 << 30;
      if (!first || !last || !(std::abs(*first) <= most && std::abs(*last) <= most && *first <= *last))
      {
        failToRead(this->File,
          std::string("its element ") + element->GetName() + " says " + name + " '" + shortened(value) +
            "'; expected an extent as '0 9 0 9 0 9'");
      }
      extent[i] = *first;
      extent[i + 1] = *last;
    }
    return extent;
  }

  /// VTK would look for the rows beyond the image after the last block of values.
  void checkPieceExtent(vtkXMLDataElement* piece) const
  {
    const Extent extent = this->extentOf(piece, "Extent");
    for (std::size_t i = 0; i < extent.size(); i += 2)
    {
      if (extent[i] < this->Whole[i] || extent[i + 1] > this->Whole[i + 1])
      {
        failToRead(this->File,
          "its element Piece says Extent '" + shortened(attribute(piece, "Extent")) +
            "', which reaches beyond its WholeExtent");
      }
    }
  }

  void checkElement(vtkXMLDataElement* element)
  {
    const std::string name = element->GetName() ? element->GetName() : "";
    if (name == "ImageData" || name == "RectilinearGrid" || name == "StructuredGrid")
    {
      this->Whole = this->extentOf(element, "WholeExtent");
      this->GridPoints = 1.0;
      for (std::size_t i = 0; i < this->Whole.size(); i += 2)
      {
        this->GridPoints *= this->Whole[i + 1] - this->Whole[i] + 1.0;
      }
    }
    else if (name == "Piece")
    {
      this->checkPiece(element);
    }
    else if (name == "DataArray" || name == "Array")
    {
      this->checkArray(element);
    }
    else if (name == "InformationKey" && this->number(element, "length", 0.0) > this->Size)
    {
      this->fail(element, "a list of length " + attribute(element, "length"));
    }
    for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
    {
      this->checkElement(element->GetNestedElement(i));
    }
  }

  static double tupleBytes(vtkXMLDataElement* set, const char* name, const auto& components)
  {
    double bytes = 0.0;
    vtkXMLDataElement* arrays = set->FindNestedElementWithName(name);
    for (int i = 0; arrays && i < arrays->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* array = arrays->GetNestedElement(i);
      bytes += components(array) * typeSize(attribute(array, "type"));
    }
    return bytes;
  }

  void checkPiece(vtkXMLDataElement* piece)
  {
    const auto components = [this](vtkXMLDataElement* array)
    { return this->number(array, "NumberOfComponents", 1.0); };
    double points = this->GridPoints;
    double cells = 0.0;
    if (this->GridPoints > 0.0)
    {
      // The values of all pieces are one array.
      this->checkPieceExtent(piece);
      cells = points;
    }
    else
    {
      points = this->number(piece, "NumberOfPoints", 0.0);
      for (const char* kind :
        { "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys", "NumberOfCells" })
      {
        // Each is at least one number, where it ends.
        cells += this->number(piece, kind, 0.0);
      }
      constexpr double leastPointBytes = 3;
      if (points * leastPointBytes > this->Most || cells > this->Most)
      {
        this->fail(piece, formatNumber(points) + " points and " + formatNumber(cells) + " cells");
      }
    }
    double bytes =
      points * (tupleBytes(piece, "PointData", components) + tupleBytes(piece, "Points", components)) +
      cells * tupleBytes(piece, "CellData", components);
    // Of each point along x, y and z.
    for (std::size_t i = 0; i < this->Whole.size(); i += 2)
    {
      bytes += (this->Whole[i + 1] - this->Whole[i] + 1.0) * tupleBytes(piece, "Coordinates", components);
    }
    if (!(bytes <= this->Most))
    {
      this->fail(piece, formatNumber(bytes) + " bytes of values");
    }
  }

  void checkArray(vtkXMLDataElement* array)
  {
    const double components = this->number(array, "NumberOfComponents", 1.0);
    const double tuples = this->number(array, "NumberOfTuples", 0.0);
    constexpr double mostComponents = 1 << 20;
    if (components > mostComponents || tuples * components * typeSize(attribute(array, "type")) > this->Most)
    {
      this->fail(array, formatNumber(tuples) + " tuples of " + formatNumber(components) + " numbers");
    }
    const std::string format = attribute(array, "format");
    if ((!format.empty() && format != "ascii" && format != "binary" && format != "appended") ||
      (format == "appended") == attribute(array, "offset").empty())
    {
      failToRead(this->File,
        "its element DataArray says format '" + shortened(format) + "' and offset '" +
          shortened(attribute(array, "offset")) + "'; expected ascii, binary, or appended with an offset");
    }
    if (format == "appended")
    {
      const double offset = this->number(array, "offset", 0.0);
      const auto begin = static_cast<double>(this->Parser->appendedBegin());
      if (!(begin > 0.0 && begin + offset < this->Size))
      {
        this->fail(array, "values at byte " + formatNumber(offset) + " of its appended data");
      }
      this->checkBlock(array, begin + offset, this->Parser->appendedIsText());
    }
    else if (format == "binary")
    {
      // After the tag.
      this->Stream.clear();
      this->Stream.seekg(static_cast<std::streamoff>(array->GetXMLByteIndex()));
      this->Stream.ignore(static_cast<std::streamsize>(this->Size), '>');
      if (const std::streamoff begin = this->Stream.tellg(); begin > 0)
      {
        this->checkBlock(array, static_cast<double>(begin), true);
      }
    }
  }

  /// What stands before the values of an array: their bytes, or how they are compressed in blocks.
  void checkBlock(vtkXMLDataElement* array, double begin, bool isText)
  {
    const double left = this->Size - begin;
    constexpr std::size_t numbers = 3;
    const std::vector<double> header = this->headerAt(begin, isText, numbers);
    if (!this->IsCompressed)
    {
      if (header[0] > left)
      {
        this->fail(array, formatNumber(header[0]) + " bytes in one block");
      }
      return;
    }
    // How many blocks, the bytes of each and of the last where that is shorter; then those of each
    // compressed.
    const double blocks = header[0];
    double compressed = 0.0;
    if (blocks * static_cast<double>(this->HeaderSize) <= left)
    {
      const std::vector<double> sizes =
        this->headerAt(begin, isText, numbers + static_cast<std::size_t>(blocks));
      compressed = std::accumulate(sizes.begin() + numbers, sizes.end(), 0.0);
    }
    if (blocks * static_cast<double>(this->HeaderSize) > left || compressed > left ||
      std::max(blocks, 1.0) * header[1] > this->Most || header[2] > (blocks > 0.0 ? header[1] : 0.0))
    {
      this->fail(array,
        formatNumber(blocks) + " compressed blocks of " + formatNumber(compressed) + " bytes, of " +
          formatNumber(header[1]) + " bytes each that are not");
    }
  }

  /// Whole numbers before the values of an array; what the file does not hold of them is 0.
  std::vector<double> headerAt(double begin, bool isText, std::size_t count)
  {
    // Base64 needs a third more, and there may be line ends in it.
    const std::size_t size = count * this->HeaderSize;
    std::string stored(isText ? 2 * size : size, '\0');
    this->Stream.clear();
    this->Stream.seekg(static_cast<std::streamoff>(begin));
    this->Stream.read(stored.data(), static_cast<std::streamsize>(stored.size()));
    stored.resize(static_cast<std::size_t>(this->Stream.gcount()));
    std::vector<unsigned char> bytes(stored.begin(), stored.end());
    if (isText)
    {
      bytes = decoded(stored, size);
    }
    bytes.resize(std::max(bytes.size(), size));
    std::vector<double> header;
    for (std::size_t i = 0; i < count; ++i)
    {
      std::uint64_t value = 0;
      for (std::size_t b = 0; b < this->HeaderSize; ++b)
      {
        value = value << 8 | bytes[i * this->HeaderSize + (this->IsBigEndian ? b : this->HeaderSize - 1 - b)];
      }
      header.push_back(static_cast<double>(value));
    }
    return header;
  }

  const fs::path& File;
  PromptXmlParser* Parser;
  std::ifstream Stream;
  double Size;
  double Most = 0.0;
  Extent Whole{};
  double GridPoints = 0.0;
  std::size_t HeaderSize = 4;
  bool IsCompressed = false;
  bool IsBigEndian = false;
};

} // namespace

double checkXml(const fs::path& file)
{
  // Some programs write elements of their own after it, as gprMax does of its materials.
  constexpr std::size_t endSize = 1 << 16;
  if (fileTail(file, endSize).find("</VTKFile>") == std::string::npos)
  {
    failToRead(file, "the file ends without '</VTKFile>', the end of a VTK XML file");
  }
  vtkNew<PromptXmlParser> parser;
  parser->SetFileName(file.c_str());
  {
    const VtkMessages messages;
    if (parser->Parse() == 0 || !parser->GetRootElement())
    {
      const std::string problem = messages.error();
      failToRead(file, "it is no XML that can be read" + (problem.empty() ? "" : ": " + problem));
    }
  }
  return XmlCheck(file, parser).mostValues();
}

} // namespace ink::io
