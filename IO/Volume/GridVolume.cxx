// SPDX-License-Identifier: BSD-3-Clause
#include "GridVolume.h"

#include "CheckedXmlReader.h"
#include "Core/FormatNumber.h"
#include "InkActiveScalars.h"
#include "InkAllocate.h"
#include "InkImageOfGrid.h"
#include "ReadError.h"
#include "ReaderProgress.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"

#include <stdexcept>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

/// The active scalars, or the array in their place; null if there is none.
vtkDataArray* chooseValues(vtkDataSetAttributes* attributes, std::vector<std::string>& notes)
{
  if (vtkDataArray* active = attributes->GetScalars())
  {
    return active;
  }
  vtkDataArray* first = InkFirstValues(attributes);
  if (first && first->GetName())
  {
    notes.push_back(std::string("array '") + first->GetName() + "' is used");
  }
  return first;
}

/// All values of a file's array. @throws ReadError, ReadAborted
vtkSmartPointer<vtkDataArray> readArray(const RawVolume& values, const Progress& progress)
{
  auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(values.type));
  const std::uint64_t count = values.sliceValues() * static_cast<std::uint64_t>(values.dimensions[2]);
  InkSetNumberOfTuples(array, static_cast<vtkIdType>(count));
  const int* d = values.dimensions;
  const int all[6] = { 0, d[0] - 1, 0, d[1] - 1, 0, d[2] - 1 };
  RawVolumeReader(values).read(
    all, { static_cast<unsigned char*>(array->GetVoidPointer(0)), count * values.valueSize() }, progress);
  return array;
}

/// Hides points or cells. @param marks as vtkGhostType has them
void hide(vtkDataSet* grid, const RawVolume& marks)
{
  const vtkSmartPointer<vtkDataArray> array = readArray(marks, {});
  array->SetName(vtkDataSetAttributes::GhostArrayName());
  vtkDataSetAttributes* hidden = grid->GetPointData();
  if (array->GetNumberOfTuples() == grid->GetNumberOfCells())
  {
    hidden = grid->GetCellData();
  }
  hidden->AddArray(array);
}

vtkSmartPointer<vtkDataSet> makeGrid(const std::vector<RawVolume>& coordinates)
{
  if (coordinates.size() == 1)
  {
    constexpr int perPoint = 3;
    const int* d = coordinates.front().dimensions;
    const vtkSmartPointer<vtkDataArray> triples = readArray(coordinates.front(), {});
    triples->SetNumberOfComponents(perPoint);
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(d[0] / perPoint, d[1], d[2]);
    vtkNew<vtkPoints> points;
    points->SetData(triples);
    grid->SetPoints(points);
    return grid;
  }
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(
    coordinates[0].dimensions[0], coordinates[1].dimensions[0], coordinates[2].dimensions[0]);
  grid->SetXCoordinates(readArray(coordinates[0], {}));
  grid->SetYCoordinates(readArray(coordinates[1], {}));
  grid->SetZCoordinates(readArray(coordinates[2], {}));
  return grid;
}

} // namespace

template <class Reader>
void GridVolume::open()
{
  const auto reader = vtkSmartPointer<CheckedXmlReader<Reader>>::New();
  reader->open(this->File, this->Format);
  this->Read = [file = this->File, reader](std::vector<std::string>& notes, const Progress& progress)
  {
    const ReaderProgress reporting(reader, progress);
    reader->run([&reader] { reader->Update(); });
    if (reporting.aborted())
    {
      throw ReadAborted();
    }
    auto grid = vtk::TakeSmartPointer(reader->GetOutput()->NewInstance());
    grid->ShallowCopy(reader->GetOutput());
    reader->GetOutput()->Initialize(); // not kept as long as the reader is
    vtkDataArray* values = chooseValues(grid->GetPointData(), notes);
    if (!values)
    {
      values = chooseValues(grid->GetCellData(), notes);
      notes.emplace_back(noteOfCells);
    }
    if (!values)
    {
      failToRead(file, lackOfValues);
    }
    return Grid{ grid, values, values->GetNumberOfComponents() };
  };
}

GridVolume::GridVolume(const fs::path& file)
  : File(file)
{
  if (suffixOf(file) == ".vtr")
  {
    this->Format = "VTK XML rectilinear grid (.vtr)";
    this->open<vtkXMLRectilinearGridReader>();
  }
  else
  {
    this->Format = "VTK XML structured grid (.vts)";
    this->open<vtkXMLStructuredGridReader>();
  }
}

GridVolume::GridVolume(const VolumeHeader& header)
  : File(header.voxels.files.front())
  , Format(header.format)
  , Read(
      [header](std::vector<std::string>&, const Progress& progress)
      {
        const vtkSmartPointer<vtkDataSet> grid = makeGrid(header.coordinates);
        for (const RawVolume& marks : header.marks)
        {
          hide(grid, marks);
        }
        return Grid{ grid, readArray(header.voxels, progress), header.components };
      })
{
}

int GridVolume::read(vtkImageData* image, std::vector<std::string>& notes, const Progress& progress) const
{
  const Grid grid = this->Read(notes, progress);
  try
  {
    const InkGridImage made = InkImageOfGrid(grid.data, grid.values);
    image->ShallowCopy(made.Image);
    if (made.IsResampled)
    {
      notes.push_back("its grid is resampled to " + formatDimensions(image->GetDimensions()) + " voxels");
    }
  }
  catch (const std::invalid_argument& problem)
  {
    failToRead(this->File, problem.what());
  }
  return grid.components;
}

} // namespace ink::io
