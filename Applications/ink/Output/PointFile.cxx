// SPDX-License-Identifier: BSD-3-Clause
#include "PointFile.h"

#include "Errors.h"
#include "OutputFile.h"
#include "PointNames.h"
#include "PointStore.h"

#include "vtkSetGet.h"
#include "vtkType.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ink::cli
{
namespace
{

constexpr std::array<std::pair<const char*, PointFormat>, 5> suffixes{ { { ".vtp", PointFormat::Vtp },
  { ".vtk", PointFormat::Vtk }, { ".ply", PointFormat::Ply }, { ".csv", PointFormat::Csv },
  { ".xyz", PointFormat::Xyz } } };

std::span<const unsigned char> bytesOf(const std::string& text)
{
  return { reinterpret_cast<const unsigned char*>(text.data()), text.size() };
}

template <class T>
void append(std::string& bytes, T value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

std::vector<std::size_t> indices(std::size_t count)
{
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{ 0 });
  return all;
}

/// 0, 1, 2 ... count - 1, a block at a time.
template <class Id>
void writeIds(std::uint64_t count, const ByteSink& sink, const auto& toFile)
{
  std::vector<Id> ids;
  for (std::uint64_t first = 0; first < count; first += ids.size())
  {
    ids.resize(static_cast<std::size_t>(std::min<std::uint64_t>(PointStore::blockSize, count - first)));
    std::iota(ids.begin(), ids.end(), static_cast<Id>(first));
    toFile(ids);
    sink({ reinterpret_cast<const unsigned char*>(ids.data()), ids.size() * sizeof(Id) });
  }
}

template <class Id>
void writeXmlIds(std::uint64_t count, const ByteSink& sink)
{
  std::string head;
  append<std::uint64_t>(head, sizeof(Id));
  append<Id>(head, static_cast<Id>(count));
  append<std::uint64_t>(head, count * sizeof(Id));
  sink(bytesOf(head));
  writeIds<Id>(count, sink, [](std::vector<Id>&) {});
}

/// The arrays and one vertex cell over all points, all in the appended block.
void writeXml(const PointStore& points, const ByteSink& sink)
{
  const std::uint64_t count = points.size();
  const bool small = count <= std::numeric_limits<std::int32_t>::max();
  const std::uint64_t idSize = small ? sizeof(std::int32_t) : sizeof(std::int64_t);
  std::uint64_t offset = 0;
  const auto element = [&offset](
                         const char* type, const std::string& name, int components, std::uint64_t size)
  {
    const std::string text = std::string("<DataArray type=\"") + type + "\" Name=\"" + xmlName(name) +
      "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"appended\" offset=\"" +
      std::to_string(offset) + "\"/>\n";
    offset += sizeof(std::uint64_t) + size;
    return text;
  };
  const auto arrayElement = [&](const PointStore::Array& array)
  { return element(typeNamesOf(array.type).xml, array.name, array.components, count * array.tupleSize()); };

  const auto& arrays = points.arrays();
  std::string head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"";
  head += std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  head += "\" header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"" + std::to_string(count) +
    "\" NumberOfVerts=\"1\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<Points>\n" +
    arrayElement(arrays[0]) + "</Points>\n<PointData Normals=\"Normals\">\n";
  for (std::size_t i = 1; i < arrays.size(); ++i)
  {
    head += arrayElement(arrays[i]);
  }
  const char* idType = small ? "Int32" : "Int64";
  head += "</PointData>\n<Verts>\n";
  head += element(idType, "offsets", 1, idSize);
  head += element(idType, "connectivity", 1, count * idSize);
  head += "</Verts>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  sink(bytesOf(head));

  for (const std::size_t i : indices(arrays.size()))
  {
    std::string size;
    append<std::uint64_t>(size, count * arrays[i].tupleSize());
    sink(bytesOf(size));
    points.forEachBlock(std::span(&i, 1),
      [&](const PointStore::Block& block) {
        sink({ block.values[0], block.count * arrays[i].tupleSize() });
      });
  }
  small ? writeXmlIds<std::int32_t>(count, sink) : writeXmlIds<std::int64_t>(count, sink);
  sink(bytesOf("\n</AppendedData>\n</VTKFile>\n"));
}

/// Reverses each value's bytes where the machine's order is not the legacy format's, which is big-endian.
void toBigEndian(std::span<unsigned char> bytes, std::size_t valueSize)
{
  if (std::endian::native == std::endian::little && valueSize > 1)
  {
    for (auto value = bytes.begin(); value != bytes.end(); value += static_cast<std::ptrdiff_t>(valueSize))
    {
      std::reverse(value, value + static_cast<std::ptrdiff_t>(valueSize));
    }
  }
}

/// Version 3.0, which every reader knows; its ids have 32 bits.
void writeLegacy(const PointStore& points, const ByteSink& sink)
{
  const std::uint64_t count = points.size();
  if (count >= static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max()))
  {
    throw Failure(std::to_string(count) + " points are too many for a .vtk file; .vtp and .ply take them");
  }
  const auto writeArray = [&](std::size_t i)
  {
    const std::size_t valueSize = points.arrays()[i].tupleSize() / points.arrays()[i].components;
    std::vector<unsigned char> swapped;
    points.forEachBlock(std::span(&i, 1),
      [&](const PointStore::Block& block)
      {
        swapped.assign(block.values[0], block.values[0] + block.count * points.arrays()[i].tupleSize());
        toBigEndian(swapped, valueSize);
        sink(swapped);
      });
    sink(bytesOf("\n"));
  };

  const std::string n = std::to_string(count);
  const auto& arrays = points.arrays();
  sink(
    bytesOf("# vtk DataFile Version 3.0\npoints on a surface, from ink\nBINARY\nDATASET POLYDATA\nPOINTS " +
      n + " " + typeNamesOf(arrays[0].type).legacy + "\n"));
  writeArray(0);
  std::string cell = "VERTICES 1 " + std::to_string(count + 1) + "\n";
  const std::size_t start = cell.size();
  append<std::int32_t>(cell, static_cast<std::int32_t>(count));
  std::vector<unsigned char> head(cell.begin(), cell.end());
  toBigEndian(std::span(head).subspan(start), sizeof(std::int32_t));
  sink(head);
  writeIds<std::int32_t>(count, sink,
    [](std::vector<std::int32_t>& ids)
    {
      toBigEndian({ reinterpret_cast<unsigned char*>(ids.data()), ids.size() * sizeof(std::int32_t) },
        sizeof(std::int32_t));
    });
  sink(bytesOf("\nPOINT_DATA " + n + "\n"));
  std::vector<std::size_t> fields;
  for (std::size_t i = 1; i < arrays.size(); ++i)
  {
    if (!arrays[i].isNormals())
    {
      fields.push_back(i);
      continue;
    }
    sink(bytesOf(std::string("NORMALS Normals ") + typeNamesOf(arrays[i].type).legacy + "\n"));
    writeArray(i);
  }
  if (!fields.empty())
  {
    sink(bytesOf("FIELD FieldData " + std::to_string(fields.size()) + "\n"));
  }
  for (const std::size_t i : fields)
  {
    sink(bytesOf(legacyName(arrays[i].name) + " " + std::to_string(arrays[i].components) + " " + n + " " +
      typeNamesOf(arrays[i].type).legacy + "\n"));
    writeArray(i);
  }
}

void writePly(const PointStore& points, const ByteSink& sink)
{
  const auto& arrays = points.arrays();
  std::string head = std::string("ply\nformat binary_") +
    (std::endian::native == std::endian::little ? "little" : "big") +
    "_endian 1.0\ncomment points on a surface, from ink\nelement vertex " + std::to_string(points.size()) +
    "\n";
  std::size_t recordSize = 0;
  const std::vector<std::string> names = columnNames(points, true);
  auto name = names.begin();
  for (const auto& array : arrays)
  {
    recordSize += array.tupleSize();
    for (int c = 0; c < array.components; ++c)
    {
      head += std::string("property ") + typeNamesOf(array.type).ply + " " + *name++ + "\n";
    }
  }
  sink(bytesOf(head + "end_header\n"));
  std::vector<unsigned char> records;
  points.forEachBlock(indices(arrays.size()),
    [&](const PointStore::Block& block)
    {
      records.resize(block.count * recordSize);
      unsigned char* record = records.data();
      for (std::size_t n = 0; n < block.count; ++n)
      {
        for (std::size_t i = 0; i < arrays.size(); ++i)
        {
          const std::size_t size = arrays[i].tupleSize();
          std::memcpy(record, block.values[i] + n * size, size);
          record += size;
        }
      }
      sink(records);
    });
}

template <class T>
void appendText(std::string& line, const unsigned char* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  // The shortest that reads back as the same value, whatever the locale.
  std::array<char, 32> digits;
  line.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

void appendText(std::string& line, int type, const unsigned char* bytes)
{
  switch (type)
  {
    vtkTemplateMacro(appendText<VTK_TT>(line, bytes));
  }
}

void writeText(const PointStore& points, char separator, std::span<const std::size_t> wanted,
  const std::string& head, const ByteSink& sink)
{
  sink(bytesOf(head));
  std::string lines;
  points.forEachBlock(wanted,
    [&](const PointStore::Block& block)
    {
      lines.clear();
      for (std::size_t n = 0; n < block.count; ++n)
      {
        for (std::size_t w = 0; w < wanted.size(); ++w)
        {
          const PointStore::Array& array = points.arrays()[wanted[w]];
          const std::size_t valueSize = array.tupleSize() / array.components;
          for (int c = 0; c < array.components; ++c)
          {
            appendText(lines, array.type, block.values[w] + n * array.tupleSize() + c * valueSize);
            lines += separator;
          }
        }
        lines.back() = '\n';
      }
      sink(bytesOf(lines));
    });
}

void writeCsv(const PointStore& points, const ByteSink& sink)
{
  std::string head;
  for (const std::string& name : columnNames(points, false))
  {
    head += csvName(name) + ",";
  }
  head.back() = '\n';
  writeText(points, ',', indices(points.arrays().size()), head, sink);
}

void writeXyz(const PointStore& points, const ByteSink& sink)
{
  std::vector<std::size_t> wanted{ 0 };
  for (std::size_t i = 1; i < points.arrays().size(); ++i)
  {
    if (points.arrays()[i].isNormals())
    {
      wanted.push_back(i);
    }
  }
  writeText(points, ' ', wanted, "", sink);
}

} // namespace

PointFormat pointFormatOf(const std::filesystem::path& file)
{
  const std::string suffix = vtksys::SystemTools::LowerCase(file.extension().string());
  std::string known;
  for (const auto& [name, format] : suffixes)
  {
    if (suffix == name)
    {
      return format;
    }
    known += std::string(known.empty() ? "" : " ") + name;
  }
  throw UsageError("OUT '" + file.string() + "': expected a name that ends in one of " + known);
}

void writePoints(const PointStore& points, PointFormat format, const OutputFile& file)
{
  file.write(
    [&](const ByteSink& sink)
    {
      switch (format)
      {
        case PointFormat::Vtp:
          return writeXml(points, sink);
        case PointFormat::Vtk:
          return writeLegacy(points, sink);
        case PointFormat::Ply:
          return writePly(points, sink);
        case PointFormat::Csv:
          return writeCsv(points, sink);
        case PointFormat::Xyz:
          return writeXyz(points, sink);
      }
    });
}

} // namespace ink::cli
