// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "Core/FormatNumber.h"
#include "GridCells.h"
#include "LegacyFile.h"
#include "ReadError.h"
#include "ReaderProgress.h"
#include "VtkMessages.h"
#include "Words.h"

#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataReader.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridReader.h"

#include <new>
#include <set>
#include <string>
#include <utility>

namespace ink::io
{

namespace
{

constexpr const char* polyData = "polydata";
constexpr const char* grid = "unstructured_grid";

/// The sections of a file, as far as VTK believes them.
///
/// Faults: VTK makes room for as many points, cells and values as a file says, whatever its length; of cells
/// in the format before version 5, a list of "count, ids" each, it reads as many ids as a count says; and it
/// takes as many types of cells as there are cells from wherever.
class LegacySections
{
public:
  explicit LegacySections(const std::filesystem::path& file)
    : File(file)
    , Legacy(file)
  {
  }

  const std::string& kind() const { return this->Legacy.kind(); }

  void check()
  {
    std::string word;
    double tuples = 0.0;
    while (this->Legacy.tryWord(word))
    {
      if (word == "point_data" || word == "cell_data")
      {
        tuples = this->Legacy.whole(0, "a number of values");
        this->Legacy.beginValues();
      }
      else if (word == "metadata")
      {
        this->Legacy.skipMetadata();
      }
      else if (!this->passSection(word) &&
        !this->Legacy.passValues(word, tuples, [](const LegacyArray&) { return true; }))
      {
        this->Legacy.fail(word, "a keyword as POINTS, POLYGONS, CELLS or POINT_DATA");
      }
    }
    if (this->Types != this->GridCells)
    {
      failToRead(this->File,
        "it has types of " + formatNumber(this->Types) + " cells, but points of " +
          formatNumber(this->GridCells));
    }
  }

private:
  /// Goes past points, cells or types of cells. @return whether keyword is one that these follow
  bool passSection(const std::string& keyword)
  {
    static const std::set<std::string> ofPolyData{ "vertices", "lines", "polygons", "triangle_strips" };
    const bool isGrid = this->Legacy.kind() == grid;
    const bool areCells = isGrid ? keyword == "cells" : ofPolyData.count(keyword) > 0;
    const bool areTypes = isGrid && keyword == "cell_types";
    if (keyword != "points" && !areCells && !areTypes)
    {
      return false;
    }
    if (!this->Passed.insert(keyword).second)
    {
      failToRead(this->File, "it has " + keyword + " twice; expected them once");
    }
    if (areCells)
    {
      this->passCells();
    }
    else if (areTypes)
    {
      this->passTypes();
    }
    else
    {
      const double count = this->Legacy.whole(0, "a number of points");
      this->passNumbers(3.0 * count);
    }
    return true;
  }

  /// Those whose type comes next.
  void passNumbers(double count)
  {
    const std::string typeName = this->Legacy.word("a type");
    const int type = LegacyFile::typeOf(typeName);
    if (type == VTK_VOID || type == VTK_BIT)
    {
      this->Legacy.fail(typeName, "a type of numbers, as float,");
    }
    this->Legacy.beginValues();
    this->Legacy.skip(count, type);
  }

  void passCells()
  {
    const double first = this->Legacy.whole(0, "a number of cells");
    const double second = this->Legacy.whole(0, "a number of all cells' points");
    this->Legacy.beginValues();
    constexpr int versionOfOffsets = 5;
    if (this->Legacy.majorVersion() < versionOfOffsets)
    {
      this->checkCounts(first, second);
      this->GridCells = first;
    }
    else if (first > 0.0)
    {
      // Where each ends, after a 0.
      for (const auto& [name, count] : { std::pair("offsets", first), std::pair("connectivity", second) })
      {
        if (const std::string word = this->Legacy.word(name); word != name)
        {
          this->Legacy.fail(word, name);
        }
        this->passNumbers(count);
      }
      this->GridCells = first - 1.0;
    }
    this->GridCells = this->Legacy.kind() == grid ? this->GridCells : 0.0;
  }

  /// Before version 5: of each cell how many points it has, and these.
  void checkCounts(double cells, double left)
  {
    for (double cell = 0; cell < cells; ++cell)
    {
      const double points = this->Legacy.cellNumber();
      left -= 1.0 + points;
      if (points < 0.0 || left < 0.0)
      {
        failToRead(this->File, "its cells say that they have more points than they have");
      }
      this->Legacy.skip(points, VTK_INT);
    }
    if (left > 0.0)
    {
      failToRead(this->File, "its cells say that they have fewer points than they have");
    }
  }

  void passTypes()
  {
    this->Types = this->Legacy.whole(0, "a number of types of cells");
    this->Legacy.beginValues();
    for (double i = 0; i < this->Types; ++i)
    {
      const int type = static_cast<int>(this->Legacy.cellNumber());
      const std::string problem =
        type == VTK_POLYHEDRON ? "it has polyhedra; expected them in a .vtu file" : problemOfCellType(type);
      if (!problem.empty())
      {
        failToRead(this->File, problem);
      }
    }
  }

  const std::filesystem::path& File;
  LegacyFile Legacy;
  std::set<std::string> Passed;
  double GridCells = 0.0;
  double Types = 0.0;
};

/// What VTK's reader makes of a file whose sections are sound.
template <class Reader, class Data>
vtkSmartPointer<Data> readBy(const std::filesystem::path& file, const Progress& progress)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  const ReaderProgress reporting(reader, progress);
  const VtkMessages messages;
  auto data = vtkSmartPointer<Data>::New();
  bool whole = false;
  try
  {
    whole = reader->ReadMeshSimple(file.string(), data) != 0;
  }
  catch (const std::bad_alloc&)
  {
    failToRead(file, "there is not enough memory for what it says that it has");
  }
  if (reporting.aborted())
  {
    throw ReadAborted();
  }
  if (const std::string problem = messages.error(); !problem.empty() || !whole)
  {
    failToRead(file, problem.empty() ? "it is damaged" : problem);
  }
  return data;
}

} // namespace

bool isLegacyMesh(const std::filesystem::path& file)
{
  try
  {
    const std::string kind = LegacyFile(file).kind();
    return kind == polyData || kind == grid;
  }
  catch (const ReadError&)
  {
    return false;
  }
}

vtkSmartPointer<vtkPolyData> readLegacyMesh(
  const std::filesystem::path& file, std::vector<std::string>& notes, const Progress& progress)
{
  LegacySections sections(file);
  const std::string& kind = sections.kind();
  if (kind != polyData && kind != grid)
  {
    failToRead(file,
      "it is a legacy VTK file of '" + shortened(kind) + "'; expected DATASET POLYDATA or UNSTRUCTURED_GRID");
  }
  sections.check();
  if (kind == grid)
  {
    const auto cells = readBy<vtkUnstructuredGridReader, vtkUnstructuredGrid>(file, halfOf(progress, 0.0));
    return surfaceOf(cells, file, notes, progress);
  }
  return readBy<vtkPolyDataReader, vtkPolyData>(file, progress);
}

} // namespace ink::io
