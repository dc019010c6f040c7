// SPDX-License-Identifier: BSD-3-Clause
#include "GridCells.h"

#include "Core/FormatNumber.h"
#include "InkVTKCompat.h"
#include "ReadError.h"
#include "ReaderProgress.h"
#include "VtkMessages.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkGeometryFilter.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

struct CellKind
{
  int type;
  int dimension;
  /// How many points it has at least, and how many more at a time; 0: no more.
  vtkIdType points;
  vtkIdType step;
};

/// Those whose outer surface VTK makes without looking at anything but their points and faces.
constexpr CellKind kinds[] = { { VTK_EMPTY_CELL, 0, 0, 1 }, { VTK_VERTEX, 0, 1, 0 },
  { VTK_POLY_VERTEX, 0, 1, 1 }, { VTK_LINE, 1, 2, 0 }, { VTK_POLY_LINE, 1, 1, 1 }, { VTK_TRIANGLE, 2, 3, 0 },
  { VTK_TRIANGLE_STRIP, 2, 3, 1 }, { VTK_POLYGON, 2, 3, 1 }, { VTK_PIXEL, 2, 4, 0 }, { VTK_QUAD, 2, 4, 0 },
  { VTK_TETRA, 3, 4, 0 }, { VTK_VOXEL, 3, 8, 0 }, { VTK_HEXAHEDRON, 3, 8, 0 }, { VTK_WEDGE, 3, 6, 0 },
  { VTK_PYRAMID, 3, 5, 0 }, { VTK_PENTAGONAL_PRISM, 3, 10, 0 }, { VTK_HEXAGONAL_PRISM, 3, 12, 0 },
  { VTK_QUADRATIC_EDGE, 1, 3, 0 }, { VTK_QUADRATIC_TRIANGLE, 2, 6, 0 }, { VTK_QUADRATIC_QUAD, 2, 8, 0 },
  { VTK_QUADRATIC_TETRA, 3, 10, 0 }, { VTK_QUADRATIC_HEXAHEDRON, 3, 20, 0 },
  { VTK_QUADRATIC_WEDGE, 3, 15, 0 }, { VTK_QUADRATIC_PYRAMID, 3, 13, 0 }, { VTK_BIQUADRATIC_QUAD, 2, 9, 0 },
  { VTK_TRIQUADRATIC_HEXAHEDRON, 3, 27, 0 }, { VTK_QUADRATIC_LINEAR_QUAD, 2, 6, 0 },
  { VTK_QUADRATIC_LINEAR_WEDGE, 3, 12, 0 }, { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 3, 18, 0 },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 3, 24, 0 }, { VTK_BIQUADRATIC_TRIANGLE, 2, 7, 0 },
  { VTK_CUBIC_LINE, 1, 4, 0 }, { VTK_QUADRATIC_POLYGON, 2, 6, 2 }, { VTK_TRIQUADRATIC_PYRAMID, 3, 19, 0 },
  { VTK_POLYHEDRON, 3, 4, 1 } };

const CellKind* kindOf(double type)
{
  const auto* kind =
    std::find_if(std::begin(kinds), std::end(kinds), [type](const CellKind& k) { return k.type == type; });
  return kind == std::end(kinds) ? nullptr : kind;
}

/// VTK looks the points of faces up among those of the cell. @param corners of the cell, in order
void checkFaces(vtkUnstructuredGrid* grid, vtkIdType cell, const std::vector<vtkIdType>& corners,
  vtkIdList* stream, const fs::path& file)
{
  const std::string which = "cell " + std::to_string(cell) + ", a polyhedron, ";
  if (!InkHasFaces(grid, cell))
  {
    failToRead(file, which + "has no faces");
  }
  // The number of faces, and of each the number of its points and these.
  grid->GetFaceStream(cell, stream);
  for (vtkIdType i = 1; i < stream->GetNumberOfIds();)
  {
    const vtkIdType end = i + 1 + stream->GetId(i);
    if (stream->GetId(i) < 3)
    {
      failToRead(file, which + "has a face of fewer than 3 points");
    }
    for (++i; i < end; ++i)
    {
      if (!std::binary_search(corners.begin(), corners.end(), stream->GetId(i)))
      {
        failToRead(file,
          which + "has a face with point " + std::to_string(stream->GetId(i)) + ", which is not its own");
      }
    }
  }
}

/// @return how many of its cells are solid
vtkIdType checkGrid(vtkUnstructuredGrid* grid, const fs::path& file)
{
  const vtkIdType count = grid->GetNumberOfCells();
  if (grid->GetCells()->GetNumberOfCells() != count)
  {
    failToRead(file,
      "it has types of " + std::to_string(count) + " cells, but points of " +
        std::to_string(grid->GetCells()->GetNumberOfCells()));
  }
  checkCells(grid->GetCells(), grid->GetNumberOfPoints(), file);
  vtkIdType solid = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    const int type = grid->GetCellType(cell);
    if (const std::string problem = problemOfCellType(type); !problem.empty())
    {
      failToRead(file, problem);
    }
    const CellKind& kind = *kindOf(type);
    const vtkIdType points = grid->GetCells()->GetCellSize(cell);
    if (points < kind.points ||
      (kind.step == 0 ? points > kind.points : (points - kind.points) % kind.step != 0))
    {
      failToRead(file,
        "cell " + std::to_string(cell) + " of VTK's type " + std::to_string(type) + " has " +
          std::to_string(points) + " points; expected " + std::to_string(kind.points) +
          (kind.step == 0 ? "" : " or more"));
    }
    solid += kind.dimension == 3 ? 1 : 0;
    if (type == VTK_POLYHEDRON)
    {
      grid->GetCells()->GetCellAtId(cell, ids);
      std::vector<vtkIdType> corners(ids->begin(), ids->end());
      std::sort(corners.begin(), corners.end());
      checkFaces(grid, cell, corners, ids, file);
    }
  }
  return solid;
}

} // namespace

std::string problemOfCellType(double type)
{
  if (kindOf(type))
  {
    return {};
  }
  // VTK_HIGHER_ORDER_EDGE, which VTK 9.7 renamed, to VTK_BEZIER_PYRAMID.
  constexpr double firstOfHigherOrder = 60;
  constexpr double lastOfHigherOrder = 81;
  return (type >= firstOfHigherOrder && type <= lastOfHigherOrder
             ? "a cell is of a higher order than quadratic"
             : "a cell is of a type that is not read") +
    (", VTK's type " + formatNumber(type)) + "; expected linear and quadratic cells and polyhedra";
}

void checkCells(vtkCellArray* cells, vtkIdType points, const fs::path& file)
{
  if (cells->GetNumberOfCells() == 0)
  {
    return;
  }
  vtkDataArray* ends = cells->GetOffsetsArray();
  const auto ids = static_cast<double>(cells->GetNumberOfConnectivityIds());
  double last = 0.0;
  for (vtkIdType i = 0; i < ends->GetNumberOfTuples(); ++i)
  {
    const double end = ends->GetComponent(i, 0);
    if (!(end >= last && end <= ids))
    {
      failToRead(file,
        "a cell ends at number " + formatNumber(end) + " of the points of all cells, of which there are " +
          formatNumber(ids) + ", where the one before ends at " + formatNumber(last));
    }
    last = end;
  }
  if (ids == 0.0)
  {
    return;
  }
  double range[2];
  cells->GetConnectivityArray()->GetRange(range, 0);
  if (range[0] < 0 || range[1] >= static_cast<double>(points))
  {
    failToRead(file,
      "a cell has point " + formatNumber(range[0] < 0 ? range[0] : range[1]) + ", but there are " +
        std::to_string(points) + " points");
  }
}

void dropMismatched(vtkDataSet* data, std::vector<std::string>& notes)
{
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkFieldData* arrays = data->GetAttributesAsFieldData(type);
    const vtkIdType count = data->GetNumberOfElements(type);
    for (int i = arrays->GetNumberOfArrays() - 1; i >= 0; --i)
    {
      if (vtkAbstractArray* array = arrays->GetAbstractArray(i); array->GetNumberOfTuples() != count)
      {
        notes.push_back("its array " + std::string(array->GetName() ? array->GetName() : "") + " has " +
          std::to_string(array->GetNumberOfTuples()) + " values for " + std::to_string(count) +
          (type == vtkDataObject::POINT ? " points" : " cells") + " and is left out");
        arrays->RemoveArray(i);
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> surfaceOf(
  vtkUnstructuredGrid* grid, const fs::path& file, std::vector<std::string>& notes, const Progress& progress)
{
  dropMismatched(grid, notes);
  const vtkIdType cells = grid->GetNumberOfCells();
  if (cells == 0)
  {
    auto points = vtkSmartPointer<vtkPolyData>::New();
    points->SetPoints(grid->GetPoints());
    points->GetPointData()->ShallowCopy(grid->GetPointData());
    return points;
  }
  const vtkIdType solid = checkGrid(grid, file);
  vtkNew<vtkGeometryFilter> outside;
  outside->SetInputData(grid);
  const Progress second = halfOf(progress, 0.5);
  const ReaderProgress reporting(outside, second);
  {
    const VtkMessages messages;
    outside->Update();
    if (const std::string problem = messages.error(); !problem.empty())
    {
      failToRead(file, problem);
    }
  }
  if (reporting.aborted())
  {
    throw ReadAborted();
  }
  vtkSmartPointer<vtkPolyData> surface = outside->GetOutput();
  if (surface->GetNumberOfCells() == 0)
  {
    failToRead(file, "none of its " + std::to_string(cells) + " cells has an outer surface");
  }
  if (solid > 0)
  {
    notes.push_back("the outer surface of its " + std::to_string(solid) +
      (solid == 1 ? " solid cell" : " solid cells") + " is drawn");
  }
  return surface;
}

} // namespace ink::io
