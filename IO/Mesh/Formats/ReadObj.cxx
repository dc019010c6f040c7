// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "ReadError.h"
#include "TextLines.h"
#include "Words.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <span>
#include <utility>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

constexpr std::int64_t noNormal = -1;

/// Which vertex and which normal.
struct Corner
{
  std::int64_t vertex;
  std::int64_t normal = noNormal;
  auto operator<=>(const Corner&) const = default;
};

/// What the lines of an OBJ say of the shape: v, vn, f, l and p. Textures, groups and materials are not used.
class ObjText
{
public:
  ObjText(const fs::path& file, std::string_view text, const Progress& progress)
    : File(file)
    , Text(file, text, progress)
  {
    while (this->Text.next())
    {
      std::string_view words = this->Text.line();
      this->take(nextWord(words), words);
    }
  }

  vtkSmartPointer<vtkPolyData> mesh()
  {
    this->checkIndices();
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    const std::size_t count = this->Coordinates.size() / 3;
    std::vector<Corner> points(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      points[i].vertex = static_cast<std::int64_t>(i);
    }
    const auto& corners = this->Faces.corners;
    if (!corners.empty() &&
      std::none_of(corners.begin(), corners.end(), [](const Corner& c) { return c.normal == noNormal; }))
    {
      this->giveNormals(points, mesh);
    }
    this->setPoints(points, mesh);
    mesh->SetPolys(this->Faces.cells());
    mesh->SetLines(this->Lines.cells());
    mesh->SetVerts(this->Points.cells());
    return mesh;
  }

private:
  struct Cells
  {
    std::vector<Corner> corners;
    std::vector<std::size_t> ends;

    vtkSmartPointer<vtkCellArray> cells() const
    {
      auto cells = vtkSmartPointer<vtkCellArray>::New();
      std::size_t begin = 0;
      for (const std::size_t end : this->ends)
      {
        cells->InsertNextCell(static_cast<int>(end - begin));
        for (; begin < end; ++begin)
        {
          cells->InsertCellPoint(this->corners[begin].vertex);
        }
      }
      return cells;
    }
  };

  void take(std::string_view keyword, std::string_view words)
  {
    if (keyword == "v")
    {
      this->takeVertex(words);
    }
    else if (keyword == "vn")
    {
      const std::vector<double> numbers = this->numbers(words);
      if (numbers.size() < 3)
      {
        this->Text.fail("a normal's three numbers after vn");
      }
      this->Normals.insert(this->Normals.end(), numbers.begin(), numbers.begin() + 3);
    }
    else if (keyword == "f")
    {
      this->takeCell(words, 3, this->Faces);
    }
    else if (keyword == "l")
    {
      this->takeCell(words, 2, this->Lines);
    }
    else if (keyword == "p")
    {
      this->takeCell(words, 1, this->Points);
    }
  }

  std::vector<double> numbers(std::string_view words) const
  {
    std::vector<double> numbers;
    for (std::string_view word = nextWord(words); !word.empty() && word[0] != '#'; word = nextWord(words))
    {
      const std::optional<double> number = numberIn(word);
      if (!number)
      {
        this->Text.fail("numbers");
      }
      numbers.push_back(*number);
    }
    return numbers;
  }

  /// Three coordinates, perhaps a weight, perhaps a color.
  void takeVertex(std::string_view words)
  {
    const std::vector<double> numbers = this->numbers(words);
    if (numbers.size() < 3)
    {
      this->Text.fail("three coordinates after v");
    }
    this->Coordinates.insert(this->Coordinates.end(), numbers.begin(), numbers.begin() + 3);
    constexpr std::size_t withColor = 6;
    if (numbers.size() == withColor)
    {
      for (std::size_t i = 3; i < withColor; ++i)
      {
        // Written so that NaN becomes 0.
        const double value = numbers[i] > 0.0 ? std::min(numbers[i], 1.0) : 0.0;
        this->Colors.push_back(static_cast<unsigned char>(value * 255.0));
      }
    }
  }

  /// From 1 on, or backwards from the last before this line as -1. That there is such a one is seen at the
  /// end.
  std::int64_t indexIn(std::string_view word, std::size_t count) const
  {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    const auto before = static_cast<std::int64_t>(count);
    if (error != std::errc() || end != word.data() + word.size() || index == 0 || index < -before)
    {
      this->Text.fail("numbers of vertices as 1, 1/2, 1//3, 1/2/3 or, of those before this line, as -1");
    }
    return index > 0 ? index - 1 : before + index;
  }

  void checkIndices() const
  {
    const auto check = [this](std::int64_t index, std::size_t count, const char* what)
    {
      if (index >= static_cast<std::int64_t>(count))
      {
        failToRead(this->File,
          std::string("a cell has ") + what + " " + std::to_string(index + 1) + ", but there are " +
            std::to_string(count) + " of them");
      }
    };
    for (const Cells* cells : { &this->Faces, &this->Lines, &this->Points })
    {
      for (const Corner& corner : cells->corners)
      {
        check(corner.vertex, this->Coordinates.size() / 3, "vertex");
        check(corner.normal, this->Normals.size() / 3, "normal");
      }
    }
  }

  /// Corners as 1, 1/2, 1//3 or 1/2/3: vertex, texture coordinates, normal.
  void takeCell(std::string_view words, std::size_t least, Cells& cells)
  {
    const std::size_t begin = cells.corners.size();
    for (std::string_view word = nextWord(words); !word.empty() && word[0] != '#'; word = nextWord(words))
    {
      const std::size_t slash = word.find('/');
      Corner corner{ this->indexIn(word.substr(0, slash), this->Coordinates.size() / 3) };
      const std::size_t second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
      if (second != std::string_view::npos)
      {
        corner.normal = this->indexIn(word.substr(second + 1), this->Normals.size() / 3);
      }
      cells.corners.push_back(corner);
    }
    if (cells.corners.size() - begin < least)
    {
      this->Text.fail(std::to_string(least) + " vertices or more");
    }
    cells.ends.push_back(cells.corners.size());
  }

  /// A vertex with several normals becomes several points.
  void giveNormals(std::vector<Corner>& points, vtkPolyData* mesh)
  {
    std::map<Corner, std::int64_t> further;
    for (Corner& corner : this->Faces.corners)
    {
      Corner& point = points[static_cast<std::size_t>(corner.vertex)];
      if (point.normal == noNormal)
      {
        point.normal = corner.normal;
      }
      else if (point.normal != corner.normal)
      {
        const auto [known, isNew] = further.try_emplace(corner, static_cast<std::int64_t>(points.size()));
        if (isNew)
        {
          points.push_back(corner);
        }
        corner.vertex = known->second;
      }
    }
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
    constexpr std::array<double, 3> none{ 0.0, 0.0, 0.0 };
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      normals->SetTuple(static_cast<vtkIdType>(i),
        points[i].normal == noNormal ? none.data()
                                     : &this->Normals[3 * static_cast<std::size_t>(points[i].normal)]);
    }
    mesh->GetPointData()->SetNormals(normals);
  }

  void setPoints(const std::vector<Corner>& points, vtkPolyData* mesh)
  {
    const bool hasColors = this->Colors.size() == this->Coordinates.size();
    vtkNew<vtkDoubleArray> coordinates;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("RGB");
    coordinates->SetNumberOfComponents(3);
    colors->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
    colors->SetNumberOfTuples(hasColors ? static_cast<vtkIdType>(points.size()) : 0);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const std::size_t first = 3 * static_cast<std::size_t>(points[i].vertex);
      coordinates->SetTypedTuple(static_cast<vtkIdType>(i), &this->Coordinates[first]);
      if (hasColors)
      {
        colors->SetTypedTuple(static_cast<vtkIdType>(i), &this->Colors[first]);
      }
    }
    vtkNew<vtkPoints> all;
    all->SetData(coordinates);
    mesh->SetPoints(all);
    if (hasColors)
    {
      mesh->GetPointData()->SetScalars(colors);
    }
  }

  const fs::path& File;
  TextLines Text;
  std::vector<double> Coordinates;
  std::vector<unsigned char> Colors;
  std::vector<double> Normals;
  Cells Faces;
  Cells Lines;
  Cells Points;
};

/// A line that ends with a backslash goes on in the next.
void joinLines(std::string& text)
{
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 1))
  {
    const std::size_t end = text.compare(at + 1, 1, "\r") == 0 ? at + 2 : at + 1;
    if (end < text.size() && text[end] == '\n')
    {
      text.replace(at, end + 1 - at, end + 1 - at, ' ');
    }
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> readObj(
  const fs::path& file, std::vector<std::string>&, const Progress& progress)
{
  std::string bytes = contentsOf(file);
  joinLines(bytes);
  return ObjText(file, bytes, progress).mesh();
}

} // namespace ink::io
