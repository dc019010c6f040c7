// SPDX-License-Identifier: BSD-3-Clause
// Geomview's Object File Format, http://www.geomview.org/docs/html/OFF.html, as text.
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
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

/// The lines of an OFF: a keyword, three counts, a line for each vertex and for each face.
class OffText
{
public:
  OffText(const fs::path& file, std::string_view text, const Progress& progress)
    : File(file)
    , Text(file, text, progress)
  {
  }

  vtkSmartPointer<vtkPolyData> read()
  {
    this->readCounts();
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    this->readVertices(mesh);
    this->readFaces(mesh);
    return mesh;
  }

private:
  /// The next line that is neither empty nor a comment, without one. @return false at the end
  bool tryLine()
  {
    while (this->Text.next())
    {
      const std::string_view line = this->Text.line();
      this->Words = line.substr(0, line.find('#'));
      if (this->Words.find_first_not_of(" \t\r") != std::string_view::npos)
      {
        return true;
      }
    }
    return false;
  }

  /// Those of a line; nothing after the last number. @throws ReadError if a word is none
  void numbers(const char* expected)
  {
    this->Numbers.clear();
    for (std::string_view word = nextWord(this->Words); !word.empty(); word = nextWord(this->Words))
    {
      const std::optional<double> number = numberIn(word);
      if (!number)
      {
        this->Text.fail(expected);
      }
      this->Numbers.push_back(*number);
    }
  }

  static bool isCount(double number)
  {
    return number >= 0.0 && number <= std::numeric_limits<int>::max() && number == std::floor(number);
  }

  void readKeyword()
  {
    constexpr const char* expected = "OFF, COFF, NOFF, STOFF or several of these letters before OFF";
    if (!this->tryLine())
    {
      failToRead(this->File, std::string("it says nothing; expected ") + expected);
    }
    this->Words.remove_prefix(this->Words.find_first_not_of(" \t"));
    std::string_view& words = this->Words;
    const auto take = [&words](std::string_view letters)
    {
      const bool has = words.starts_with(letters);
      words.remove_prefix(has ? letters.size() : 0);
      return has;
    };
    take("ST");
    this->HasColors = take("C");
    this->HasNormals = take("N");
    if (!take("OFF"))
    {
      failToRead(this->File,
        "it is not an OFF mesh of three dimensions: it begins with '" + shortened(this->Text.line()) +
          "'; expected " + expected);
    }
    std::string_view rest = words;
    if (nextWord(rest) == "BINARY")
    {
      failToRead(this->File, "it is a binary OFF mesh; expected one of text");
    }
  }

  /// Counts may stand in the line of the keyword, even without a space between.
  void readCounts()
  {
    constexpr const char* expected = "the numbers of vertices, faces and edges";
    this->readKeyword();
    if (this->Words.find_first_not_of(" \t\r") == std::string_view::npos && !this->tryLine())
    {
      failToRead(this->File, std::string("the file ends where ") + expected + " were expected");
    }
    this->numbers(expected);
    if (this->Numbers.size() < 2 || !std::all_of(this->Numbers.begin(), this->Numbers.end(), isCount))
    {
      this->Text.fail(expected);
    }
    this->Vertices = this->Numbers[0];
    this->Faces = this->Numbers[1];
  }

  /// @throws ReadError if there is none
  void nextOf(const char* what, double number, double count)
  {
    if (!this->tryLine())
    {
      failToRead(this->File,
        "the file ends after " + std::to_string(static_cast<std::int64_t>(number)) + " of the " +
          std::to_string(static_cast<std::int64_t>(count)) + " " + what + " that it promises");
    }
  }

  void readVertices(vtkPolyData* mesh)
  {
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    const std::size_t least = this->HasNormals ? 6 : 3;
    for (double i = 0; i < this->Vertices; ++i)
    {
      this->nextOf("vertices", i, this->Vertices);
      this->numbers("the numbers of a vertex");
      if (this->Numbers.size() < least)
      {
        this->Text.fail(
          this->HasNormals ? "a vertex and its normal, six numbers" : "a vertex, three numbers");
      }
      coordinates->InsertNextTuple(this->Numbers.data());
      if (this->HasNormals)
      {
        normals->InsertNextTuple(this->Numbers.data() + 3);
      }
      this->takeColor(std::span(this->Numbers).subspan(least));
    }
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    mesh->SetPoints(points);
    if (this->HasNormals)
    {
      mesh->GetPointData()->SetNormals(normals);
    }
    if (this->HasColors && this->Colors.size() == 3 * static_cast<std::size_t>(this->Vertices))
    {
      mesh->GetPointData()->SetScalars(this->makeColors());
    }
  }

  void takeColor(std::span<const double> numbers)
  {
    if (this->HasColors && numbers.size() >= 3)
    {
      for (const double number : numbers.first(3))
      {
        // Written so that NaN becomes 0.
        this->Colors.push_back(number > 0.0 ? static_cast<float>(std::min(number, 255.0)) : 0.0F);
      }
    }
  }

  /// Parts of 1 or of 255, as nobody has said which.
  vtkSmartPointer<vtkDataArray> makeColors() const
  {
    auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colors->SetName("RGB");
    colors->SetNumberOfComponents(3);
    const bool ofOne =
      std::all_of(this->Colors.begin(), this->Colors.end(), [](float value) { return value <= 1.0F; });
    for (const float value : this->Colors)
    {
      colors->InsertNextValue(static_cast<unsigned char>(ofOne ? value * 255.0F : value));
    }
    return colors;
  }

  void readFaces(vtkPolyData* mesh)
  {
    vtkNew<vtkCellArray> vertices;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkCellArray> polygons;
    for (double i = 0; i < this->Faces; ++i)
    {
      this->nextOf("faces", i, this->Faces);
      this->readFace(vertices, lines, polygons);
    }
    mesh->SetVerts(vertices);
    mesh->SetLines(lines);
    mesh->SetPolys(polygons);
  }

  /// A color may follow the corners.
  void readFace(vtkCellArray* vertices, vtkCellArray* lines, vtkCellArray* polygons)
  {
    this->numbers("a face: the number of its corners, and theirs");
    const double count = this->Numbers.empty() ? 0.0 : this->Numbers[0];
    if (!isCount(count) || count < 1.0 || count > static_cast<double>(this->Numbers.size() - 1))
    {
      this->Text.fail("a face: the number of its corners, and theirs");
    }
    const auto corners = std::span(this->Numbers).subspan(1, static_cast<std::size_t>(count));
    vtkCellArray* cells = corners.size() == 1 ? vertices : corners.size() == 2 ? lines : polygons;
    cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const double corner : corners)
    {
      if (!isCount(corner) || corner >= this->Vertices)
      {
        this->Text.fail("corners from 0 to " + std::to_string(static_cast<std::int64_t>(this->Vertices) - 1));
      }
      cells->InsertCellPoint(static_cast<vtkIdType>(corner));
    }
  }

  const fs::path& File;
  TextLines Text;
  std::string_view Words; ///< of the line that are to be read
  std::vector<double> Numbers;
  std::vector<float> Colors;
  bool HasColors = false;
  bool HasNormals = false;
  double Vertices = 0;
  double Faces = 0;
};

} // namespace

vtkSmartPointer<vtkPolyData> readOff(
  const fs::path& file, std::vector<std::string>&, const Progress& progress)
{
  const std::string text = contentsOf(file);
  return OffText(file, text, progress).read();
}

} // namespace ink::io
