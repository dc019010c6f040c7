// SPDX-License-Identifier: BSD-3-Clause
// The Point Cloud Library's files, https://pointclouds.org/documentation/tutorials/pcd_file_format.html.
#include "MeshFiles.h"

#include "Core/FormatNumber.h"
#include "NumberTypes.h"
#include "PcdHeader.h"
#include "ReadError.h"
#include "TextLines.h"
#include "Words.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

/// Makes points and their arrays of the numbers that a PCD file has.
class PcdCloud
{
public:
  /// @throws ReadError if points have no coordinates
  PcdCloud(const PcdHeader& header, const fs::path& file)
    : Header(header)
  {
    const std::array<const PcdField*, 3> position = this->findAll({ "x", "y", "z" });
    if (std::count(position.begin(), position.end(), nullptr) > 0)
    {
      failToRead(file, "its points have the fields " + this->listFields() + "; expected x, y and z");
    }
    const bool isDouble = std::any_of(position.begin(), position.end(),
      [](const PcdField* field)
      { return field->size == 8 || (field->size == 4 && field->vtkType != VTK_FLOAT); });
    this->addArray("Points", isDouble ? VTK_DOUBLE : VTK_FLOAT, position);
    const std::array<const PcdField*, 3> normal = this->findAll({ "normal_x", "normal_y", "normal_z" });
    if (std::count(normal.begin(), normal.end(), nullptr) == 0)
    {
      this->addArray("Normals", VTK_FLOAT, normal);
      this->Columns.back().isNormal = true;
    }
    for (const PcdField& field : header.fields)
    {
      this->addField(field);
    }
  }

  /// @param numbers of a point, one for each field
  void add(std::span<const double> numbers)
  {
    const auto& position = this->Columns.front().fields;
    if (!std::all_of(
          position.begin(), position.end(), [&](std::size_t field) { return std::isfinite(numbers[field]); }))
    {
      ++this->LeftOut;
      return;
    }
    for (const Column& column : this->Columns)
    {
      std::array<double, 3> tuple{};
      std::transform(column.fields.begin(), column.fields.end(), tuple.begin(),
        [&](std::size_t field) { return numbers[field]; });
      // What has no normal has nan for it.
      if (column.isNormal && !std::isfinite(tuple[0] + tuple[1] + tuple[2]))
      {
        tuple = {};
      }
      column.array->InsertNextTuple(tuple.data());
    }
    if (this->Color)
    {
      const auto packed = static_cast<std::uint32_t>(numbers[*this->Color]);
      for (const int shift : { 16, 8, 0 })
      {
        this->Colors->InsertNextValue(static_cast<unsigned char>(packed >> shift));
      }
    }
  }

  vtkSmartPointer<vtkPolyData> take(std::vector<std::string>& notes)
  {
    auto cloud = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetData(this->Columns.front().array);
    cloud->SetPoints(points);
    vtkPointData* pointData = cloud->GetPointData();
    for (const Column& column : std::span(this->Columns).subspan(1))
    {
      pointData->AddArray(column.array);
      if (column.isNormal)
      {
        pointData->SetNormals(column.array);
      }
    }
    if (this->Color)
    {
      pointData->SetScalars(this->Colors);
    }
    if (this->LeftOut > 0)
    {
      notes.push_back(std::to_string(this->LeftOut) + " of its " + std::to_string(this->Header.points) +
        " points, which have no coordinates, are left out");
    }
    if (!this->Unused.empty())
    {
      notes.push_back("its fields " + this->Unused + " are not used");
    }
    return cloud;
  }

private:
  /// An array, and the fields that it is made of.
  struct Column
  {
    vtkSmartPointer<vtkDataArray> array;
    std::vector<std::size_t> fields;
    bool isNormal = false;
  };

  std::array<const PcdField*, 3> findAll(const std::array<const char*, 3>& names) const
  {
    std::array<const PcdField*, 3> all;
    std::transform(
      names.begin(), names.end(), all.begin(), [this](const char* name) { return this->Header.find(name); });
    return all;
  }

  std::string listFields() const
  {
    std::string list;
    for (const PcdField& field : this->Header.fields)
    {
      list += (list.empty() ? "" : " ") + field.name;
    }
    const std::string some = shortened(list);
    return "'" + some + "'";
  }

  void addArray(const std::string& name, int type, std::span<const PcdField* const> fields)
  {
    Column column;
    column.array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    column.array->SetName(name.c_str());
    column.array->SetNumberOfComponents(static_cast<int>(fields.size()));
    for (const PcdField* field : fields)
    {
      column.fields.push_back(field->index);
      this->Taken.push_back(field);
    }
    this->Columns.push_back(column);
  }

  /// What is neither position nor normal; fields of the name "_" are room between others.
  void addField(const PcdField& field)
  {
    if (field.name == "_" || std::find(this->Taken.begin(), this->Taken.end(), &field) != this->Taken.end())
    {
      return;
    }
    const bool isKnown = std::any_of(this->Columns.begin(), this->Columns.end(),
      [&](const Column& column) { return column.array->GetName() == field.name; });
    if (field.isColor() && !this->Color)
    {
      this->Color = field.index;
      this->Colors->SetName("RGB");
      this->Colors->SetNumberOfComponents(3);
    }
    // Marks of ghosts would hide points.
    else if (field.count == 1 && !isKnown && field.name != vtkDataSetAttributes::GhostArrayName())
    {
      const PcdField* one[] = { &field };
      // Whole numbers of 64 bits, as times, are taken as the nearest doubles.
      this->addArray(field.name, field.size == 8 ? VTK_DOUBLE : field.vtkType, one);
    }
    else
    {
      this->Unused += (this->Unused.empty() ? "" : ", ") + shortened(field.name);
    }
  }

  const PcdHeader& Header;
  std::vector<Column> Columns; ///< the first one are the points
  std::vector<const PcdField*> Taken;
  std::optional<std::size_t> Color; ///< the field
  vtkNew<vtkUnsignedCharArray> Colors;
  std::uint64_t LeftOut = 0;
  std::string Unused;
};

/// The bits of a color that is written as a number: some programs write what they have as a float.
double packedColor(const PcdField& field, double number)
{
  if (field.vtkType == VTK_FLOAT)
  {
    return std::bit_cast<std::uint32_t>(static_cast<float>(number));
  }
  return number < 0.0 ? number + std::ldexp(1.0, 32) : number;
}

void readPcdText(const PcdHeader& header, TextLines& text, const fs::path& file, PcdCloud& cloud)
{
  for (std::size_t i = 0; i < header.lines; ++i)
  {
    text.next();
  }
  std::vector<double> numbers(header.fields.size());
  const std::size_t words = std::accumulate(header.fields.begin(), header.fields.end(), std::size_t{ 0 },
    [](std::size_t sum, const PcdField& field) { return sum + field.count; });
  const std::string expected = "the " + std::to_string(words) + " numbers of a point";
  for (std::uint64_t i = 0; i < header.points; ++i)
  {
    std::string_view line;
    do
    {
      if (!text.next())
      {
        failToRead(file,
          "the file ends after " + std::to_string(i) + " of the " + std::to_string(header.points) +
            " points that it promises");
      }
      line = text.line();
    } while (line.find_first_not_of(" \t") == std::string_view::npos);
    for (const PcdField& field : header.fields)
    {
      for (std::size_t c = 0; c < field.count; ++c)
      {
        const std::optional<double> number = numberIn(nextWord(line));
        // Arrays of 64 bits are double, which takes any number.
        if (!number || (field.size < 8 && !isNumberOf(field.vtkType, *number)))
        {
          text.fail(expected);
        }
        numbers[field.index] = field.isColor() ? packedColor(field, *number) : *number;
      }
    }
    if (!nextWord(line).empty())
    {
      text.fail(expected);
    }
    cloud.add(numbers);
  }
}

/// Numbers as bytes, least significant first: of one point after the other, or of one field after the other.
void readPcdBytes(
  const PcdHeader& header, const char* bytes, bool isByField, const Progress& progress, PcdCloud& cloud)
{
  constexpr bool swapped = std::endian::native == std::endian::big;
  std::vector<double> numbers(header.fields.size());
  for (std::uint64_t i = 0; i < header.points; ++i)
  {
    constexpr std::uint64_t pointsOfAStep = 1 << 16;
    if (i % pointsOfAStep == 0)
    {
      advance(progress, static_cast<double>(i) / static_cast<double>(header.points));
    }
    for (const PcdField& field : header.fields)
    {
      // Of others nothing is used.
      if (field.count == 1)
      {
        const char* place = bytes +
          (isByField ? field.offset * header.points + i * field.size : i * header.pointBytes + field.offset);
        numbers[field.index] = numberAt(place, field.isColor() ? VTK_UNSIGNED_INT : field.vtkType, swapped);
      }
    }
    cloud.add(numbers);
  }
}

/// Unpacks what liblzf packed: bytes as they are, and others that repeat what came shortly before.
/// @return whether all of both was used
bool unpackLzf(std::span<const unsigned char> from, std::span<unsigned char> to)
{
  std::size_t read = 0;
  std::size_t made = 0;
  while (read < from.size())
  {
    const std::size_t control = from[read++];
    constexpr std::size_t leastRepeated = 32;
    if (control < leastRepeated)
    {
      const std::size_t length = control + 1;
      if (length > from.size() - read || length > to.size() - made)
      {
        return false;
      }
      std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(read), length,
        to.begin() + static_cast<std::ptrdiff_t>(made));
      read += length;
      made += length;
      continue;
    }
    std::size_t length = control / leastRepeated + 2;
    constexpr std::size_t longer = 9;
    if (length == longer && read < from.size())
    {
      length += from[read++];
    }
    if (read == from.size())
    {
      return false;
    }
    const std::size_t distance = (control % leastRepeated) * 256 + from[read++] + 1;
    if (distance > made || length > to.size() - made)
    {
      return false;
    }
    // One after the other, as what is made may be repeated at once.
    for (; length > 0; --length, ++made)
    {
      to[made] = to[made - distance];
    }
  }
  return made == to.size();
}

/// What the bytes after a header are before they were packed, after two sizes of four bytes.
std::vector<unsigned char> unpackPcd(const PcdHeader& header, std::string_view bytes, const fs::path& file)
{
  constexpr std::size_t sizes = 8;
  const auto sizeAt = [&](std::size_t position)
  { return numberAt(bytes.data() + position, VTK_UNSIGNED_INT, std::endian::native == std::endian::big); };
  const double packed = bytes.size() < sizes ? 0.0 : sizeAt(0);
  const double made = bytes.size() < sizes ? 0.0 : sizeAt(4);
  const double there = static_cast<double>(bytes.size()) - static_cast<double>(sizes);
  const double needed = static_cast<double>(header.points) * static_cast<double>(header.pointBytes);
  // Three bytes repeat at most 264.
  constexpr double mostPerByte = 88;
  if (packed > there || made != needed || made > mostPerByte * packed)
  {
    failToRead(file,
      "it has " + std::to_string(bytes.size()) + " bytes after its header, which say that " +
        formatNumber(packed) + " bytes of compressed points become " + formatNumber(made) + "; its " +
        std::to_string(header.points) + " points need " + formatNumber(needed));
  }
  std::vector<unsigned char> unpacked(static_cast<std::size_t>(made));
  const std::span<const unsigned char> from(
    reinterpret_cast<const unsigned char*>(bytes.data()) + sizes, static_cast<std::size_t>(packed));
  if (!unpackLzf(from, unpacked))
  {
    failToRead(file, "its compressed points are broken");
  }
  return unpacked;
}

} // namespace

vtkSmartPointer<vtkPolyData> readPcd(
  const fs::path& file, std::vector<std::string>& notes, const Progress& progress)
{
  std::string bytes = contentsOf(file);
  std::string_view rest = bytes;
  const PcdHeader header = PcdHeader::take(rest, file);
  PcdCloud cloud(header, file);
  if (header.data == PcdData::Text)
  {
    TextLines text(file, bytes, progress);
    readPcdText(header, text, file, cloud);
  }
  else if (header.data == PcdData::Binary)
  {
    const double needed = static_cast<double>(header.points) * static_cast<double>(header.pointBytes);
    if (needed > static_cast<double>(rest.size()))
    {
      failToRead(file,
        "it has " + std::to_string(rest.size()) + " bytes after its header, but its " +
          std::to_string(header.points) + " points need " + formatNumber(needed));
    }
    readPcdBytes(header, rest.data(), false, progress, cloud);
  }
  else
  {
    const std::vector<unsigned char> unpacked = unpackPcd(header, rest, file);
    std::string().swap(bytes);
    readPcdBytes(header, reinterpret_cast<const char*>(unpacked.data()), true, progress, cloud);
  }
  return cloud.take(notes);
}

} // namespace ink::io
