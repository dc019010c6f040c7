// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "NumberTypes.h"
#include "PlyHeader.h"
#include "ReadError.h"
#include "Words.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <span>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

/// The numbers of one row, all types of which double holds exactly.
class Row
{
public:
  void clear()
  {
    this->Values.clear();
    this->Ends.clear();
  }
  void add(double value) { this->Values.push_back(value); }
  void endProperty() { this->Ends.push_back(this->Values.size()); }
  std::span<const double> property(std::size_t i) const
  {
    const std::size_t begin = i == 0 ? 0 : this->Ends[i - 1];
    return { this->Values.data() + begin, this->Ends[i] - begin };
  }

private:
  std::vector<double> Values;
  std::vector<std::size_t> Ends;
};

/// Takes rows one after the other.
class RowReader
{
public:
  RowReader(const PlyHeader& header, std::string_view bytes)
    : Bytes(bytes)
    , Format(header.format)
    , Swapped((header.format == PlyFormat::BigEndian) != (std::endian::native == std::endian::big))
  {
  }

  std::size_t bytesLeft() const { return this->Bytes.size(); }

  /// @return false if there is none
  bool read(const PlyElement& element, Row& row)
  {
    row.clear();
    return this->Format == PlyFormat::Text ? this->readText(element, row) : this->readBinary(element, row);
  }

private:
  /// One row is one line; what its numbers leave over is not read.
  bool readText(const PlyElement& element, Row& row)
  {
    std::string_view line;
    // Some programs leave lines between the tables.
    do
    {
      if (!nextLine(this->Bytes, line))
      {
        return false;
      }
    } while (line.find_first_not_of(" \t") == std::string_view::npos);
    const auto take = [&line](const PlyType& type)
    {
      const auto number = numberIn(nextWord(line));
      return number && isNumberOf(type.vtkType, *number) ? number : std::nullopt;
    };
    for (const PlyProperty& property : element.properties)
    {
      std::optional<double> count = 1.0;
      if (property.countType)
      {
        count = take(*property.countType);
      }
      if (!count || *count < 0.0)
      {
        return false;
      }
      for (auto left = static_cast<std::uint64_t>(*count); left > 0; --left)
      {
        const std::optional<double> value = take(property.type);
        if (!value)
        {
          return false;
        }
        row.add(*value);
      }
      row.endProperty();
    }
    return true;
  }

  bool readBinary(const PlyElement& element, Row& row)
  {
    for (const PlyProperty& property : element.properties)
    {
      double count = 1.0;
      if (property.countType)
      {
        const auto size = static_cast<std::size_t>(property.countType->size);
        if (this->Bytes.size() < size)
        {
          return false;
        }
        count = numberAt(this->Bytes.data(), property.countType->vtkType, this->Swapped);
        this->Bytes.remove_prefix(size);
      }
      const auto size = static_cast<std::size_t>(property.type.size);
      const std::size_t most = this->Bytes.size() / size;
      if (count < 0.0 || count > static_cast<double>(most))
      {
        return false;
      }
      for (auto left = static_cast<std::uint64_t>(count); left > 0; --left)
      {
        row.add(numberAt(this->Bytes.data(), property.type.vtkType, this->Swapped));
        this->Bytes.remove_prefix(size);
      }
      row.endProperty();
    }
    return true;
  }

  std::string_view Bytes;
  PlyFormat Format;
  bool Swapped;
};

/// Where a property of vertices goes.
struct Target
{
  vtkSmartPointer<vtkDataArray> array;
  int component;
  std::size_t property;
};

/// The points and their arrays, with room for all vertices.
class Vertices
{
public:
  Vertices(const PlyElement& element, const fs::path& file, vtkPolyData* mesh)
    : Count(static_cast<vtkIdType>(element.count))
    , Used(element.properties.size(), false)
  {
    std::vector<std::size_t> position;
    bool isDouble = false;
    for (const char* name : { "x", "y", "z" })
    {
      const auto found = element.find(name);
      if (!found)
      {
        failToRead(file, std::string("its vertices have no number '") + name + "'; expected x, y and z");
      }
      const int type = element.properties[*found].type.vtkType;
      isDouble = isDouble || type == VTK_DOUBLE || type == VTK_INT || type == VTK_UNSIGNED_INT;
      position.push_back(*found);
    }
    vtkNew<vtkPoints> points;
    points->SetData(this->add("Points", isDouble ? VTK_DOUBLE : VTK_FLOAT, position));
    mesh->SetPoints(points);

    vtkPointData* arrays = mesh->GetPointData();
    if (const auto normal = findAll(element, { "nx", "ny", "nz" }); !normal.empty())
    {
      arrays->SetNormals(this->add("Normals", VTK_FLOAT, normal));
    }
    this->addColors(element, arrays);
    for (std::size_t i = 0; i < element.properties.size(); ++i)
    {
      const PlyProperty& property = element.properties[i];
      if (!this->Used[i] && !property.countType && !arrays->HasArray(property.name.c_str()))
      {
        arrays->AddArray(this->add(property.name, property.type.vtkType, { i }));
      }
    }
  }

  void set(vtkIdType vertex, const Row& row)
  {
    for (const Target& target : this->Targets)
    {
      target.array->SetComponent(vertex, target.component, row.property(target.property)[0]);
    }
  }

private:
  static std::vector<std::size_t> findAll(const PlyElement& element, std::initializer_list<const char*> names)
  {
    std::vector<std::size_t> all;
    for (const char* name : names)
    {
      if (const auto found = element.find(name))
      {
        all.push_back(*found);
      }
    }
    return all.size() == names.size() ? all : std::vector<std::size_t>();
  }

  /// As VTK's other readers give them: bytes.
  void addColors(const PlyElement& element, vtkPointData* arrays)
  {
    auto color = findAll(element, { "red", "green", "blue" });
    if (color.empty())
    {
      color = findAll(element, { "diffuse_red", "diffuse_green", "diffuse_blue" });
    }
    if (color.empty() ||
      std::any_of(color.begin(), color.end(),
        [&](std::size_t i) { return element.properties[i].type.vtkType != VTK_UNSIGNED_CHAR; }))
    {
      return;
    }
    const auto alpha = element.find("alpha");
    const bool hasAlpha = alpha && element.properties[*alpha].type.vtkType == VTK_UNSIGNED_CHAR;
    if (hasAlpha)
    {
      color.push_back(*alpha);
    }
    arrays->SetScalars(this->add(hasAlpha ? "RGBA" : "RGB", VTK_UNSIGNED_CHAR, color));
  }

  vtkDataArray* add(const std::string& name, int type, const std::vector<std::size_t>& properties)
  {
    vtkSmartPointer<vtkDataArray> array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    array->SetName(name.c_str());
    array->SetNumberOfComponents(static_cast<int>(properties.size()));
    array->SetNumberOfTuples(this->Count);
    for (std::size_t i = 0; i < properties.size(); ++i)
    {
      this->Targets.push_back({ array, static_cast<int>(i), properties[i] });
      this->Used[properties[i]] = true;
    }
    return array;
  }

  vtkIdType Count;
  std::vector<bool> Used;
  std::vector<Target> Targets;
};

/// Adds faces, whose numbers are those of points.
class Polygons
{
public:
  Polygons(const fs::path& file, std::uint64_t points)
    : File(file)
    , Points(points)
  {
  }

  /// @return whether it has three points or more; otherwise it is left out
  bool addFace(std::span<const double> numbers)
  {
    if (numbers.size() < 3)
    {
      return false;
    }
    this->Ids.clear();
    for (const double number : numbers)
    {
      this->Ids.push_back(this->idOf(number));
    }
    this->Cells->InsertNextCell(static_cast<vtkIdType>(this->Ids.size()), this->Ids.data());
    return true;
  }

  /// A triangle for each three points that follow each other, every second one turned; -1 begins a new strip.
  void addStrips(std::span<const double> numbers)
  {
    this->Ids.clear();
    for (const double number : numbers)
    {
      if (number == -1.0)
      {
        this->Ids.clear();
        continue;
      }
      this->Ids.push_back(this->idOf(number));
      const std::size_t count = this->Ids.size();
      if (count < 3)
      {
        continue;
      }
      const vtkIdType last[] = { this->Ids[count - 3], this->Ids[count - 2], this->Ids[count - 1] };
      const bool turned = count % 2 == 0;
      // Points are repeated where a strip turns.
      if (last[0] != last[1] && last[1] != last[2] && last[2] != last[0])
      {
        this->Cells->InsertNextCell({ last[turned ? 1 : 0], last[turned ? 0 : 1], last[2] });
      }
    }
  }

  vtkCellArray* cells() { return this->Cells; }

private:
  vtkIdType idOf(double number) const
  {
    if (!(number >= 0.0 && number < static_cast<double>(this->Points) && number == std::floor(number)))
    {
      std::array<char, 32> text{};
      std::snprintf(text.data(), text.size(), "%.15g", number);
      failToRead(this->File,
        std::string("a face has point ") + text.data() + ", but there are " + std::to_string(this->Points) +
          " points, counted from 0");
    }
    return static_cast<vtkIdType>(number);
  }

  const fs::path& File;
  std::uint64_t Points;
  std::vector<vtkIdType> Ids;
  vtkNew<vtkCellArray> Cells;
};

} // namespace

vtkSmartPointer<vtkPolyData> readPly(
  const fs::path& file, std::vector<std::string>& notes, const Progress& progress)
{
  const std::string bytes = contentsOf(file);
  std::string_view rest = bytes;
  const PlyHeader header = PlyHeader::take(rest, file);
  const auto vertexElement = std::find_if(header.elements.begin(), header.elements.end(),
    [](const PlyElement& element) { return element.name == "vertex"; });
  if (vertexElement == header.elements.end())
  {
    failToRead(file, "its header names no element 'vertex'");
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  Vertices vertices(*vertexElement, file, mesh);
  Polygons polygons(file, vertexElement->count);
  std::uint64_t smallFaces = 0;

  RowReader reader(header, rest);
  Row row;
  for (const PlyElement& element : header.elements)
  {
    const bool isVertex = &element == &*vertexElement;
    auto corners = element.find("vertex_indices", true);
    corners = corners ? corners : element.find("vertex_index", true);
    const bool isFace = element.name == "face";
    const bool isStrips = element.name == "tristrips";
    if ((isFace || isStrips) && !corners && element.count > 0)
    {
      failToRead(file,
        std::string("its ") + (isFace ? "faces" : "strips") +
          " have no list 'vertex_indices' or 'vertex_index'");
    }
    for (std::uint64_t i = 0; i < element.count; ++i)
    {
      constexpr std::uint64_t rowsOfAStep = 1 << 16;
      if (i % rowsOfAStep == 0)
      {
        advance(progress, 1.0 - static_cast<double>(reader.bytesLeft()) / static_cast<double>(bytes.size()));
      }
      if (!reader.read(element, row))
      {
        failToRead(file,
          "the file ends, or holds something else than the numbers that its header promises, at element " +
            std::to_string(i + 1) + " of " + std::to_string(element.count) + " '" + element.name + "'");
      }
      if (isVertex)
      {
        vertices.set(static_cast<vtkIdType>(i), row);
      }
      else if (isFace)
      {
        smallFaces += polygons.addFace(row.property(*corners)) ? 0 : 1;
      }
      else if (isStrips)
      {
        polygons.addStrips(row.property(*corners));
      }
    }
  }
  mesh->SetPolys(polygons.cells());
  if (smallFaces > 0)
  {
    notes.push_back(std::to_string(smallFaces) + " faces of less than three points are left out");
  }
  return mesh;
}

} // namespace ink::io
