// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkVDBReader.h"

#include "InkAllocate.h"
#include "InkReportException.h"
#include "InkVDBSource.h"
#include "InkVTKCompat.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <span>

vtkStandardNewMacro(vtkInkVDBReader);

namespace
{

constexpr const char* ClassName(ink::VdbClass gridClass)
{
  return gridClass == ink::VdbClass::LevelSet ? "level set"
    : gridClass == ink::VdbClass::FogVolume   ? "fog volume"
    : gridClass == ink::VdbClass::Staggered   ? "staggered"
                                              : "unknown";
}

/// The grid with that index, or an empty one.
const ink::VdbGridInfo& GridAt(const InkVDBSource& source, int index)
{
  static const ink::VdbGridInfo none;
  const auto& grids = source.Listed().grids;
  return index >= 0 && static_cast<std::size_t>(index) < grids.size() ? grids[static_cast<std::size_t>(index)]
                                                                      : none;
}

int ClampedToInt(double value)
{
  return static_cast<int>(std::clamp<double>(value, VTK_INT_MIN, VTK_INT_MAX));
}

/// The box with padding; an empty box stays empty.
ink::VoxelBox Padded(const ink::VoxelBox& box, int border)
{
  ink::VoxelBox padded = box;
  for (int axis = 0; axis < 3 && !box.empty(); ++axis)
  {
    padded.first[axis] = ClampedToInt(static_cast<double>(box.first[axis]) - border);
    padded.last[axis] = ClampedToInt(static_cast<double>(box.last[axis]) + border);
  }
  return padded;
}

ink::VoxelBox BoxOf(const int extent[6])
{
  return { { extent[0], extent[2], extent[4] }, { extent[1], extent[3], extent[5] } };
}

template <class Array>
bool Fill(const ink::VdbGrid& grid, vtkImageData* image, bool negate, vtkAlgorithm* algorithm)
{
  using Real = typename Array::ValueType;
  vtkNew<Array> array;
  array->SetName(grid.info().name.c_str());
  InkSetNumberOfTuples(array, image->GetNumberOfPoints());
  const std::span<Real> values(array->GetPointer(0), static_cast<std::size_t>(image->GetNumberOfPoints()));
  const auto progress = [=](double fraction)
  {
    // Reading the grid was about half of the work.
    algorithm->UpdateProgress(0.5 + 0.5 * fraction);
    return !InkCheckAbort(algorithm);
  };
  if (!grid.copyTo(BoxOf(image->GetExtent()), negate, values, progress))
  {
    return false;
  }
  image->GetPointData()->SetScalars(array);
  return true;
}

} // namespace

vtkInkVDBReader::vtkInkVDBReader()
  : Source(std::make_unique<InkVDBSource>())
  , Names(vtkSmartPointer<vtkStringArray>::New())
{
  this->SetNumberOfInputPorts(0);
}

vtkInkVDBReader::~vtkInkVDBReader()
{
  this->SetFileName(nullptr);
  this->SetGridName(nullptr);
}

int vtkInkVDBReader::CanReadFile(const char* fileName)
{
  try
  {
    InkVDBSource().List(InkTextOf(fileName));
    return 1;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

int vtkInkVDBReader::GetNumberOfGrids()
{
  return static_cast<int>(this->Source->Listed().grids.size());
}

const char* vtkInkVDBReader::GetNameOfGrid(int index)
{
  return GridAt(*this->Source, index).name.c_str();
}

const char* vtkInkVDBReader::GetTypeOfGrid(int index)
{
  return GridAt(*this->Source, index).type.c_str();
}

const char* vtkInkVDBReader::GetClassOfGrid(int index)
{
  return index >= 0 && index < this->GetNumberOfGrids() ? ClassName(GridAt(*this->Source, index).gridClass)
                                                        : "";
}

void vtkInkVDBReader::GetDimensionsOfGrid(int index, int dimensions[3])
{
  const glm::dvec3 size = GridAt(*this->Source, index).activeBox.value_or(ink::VoxelBox()).size();
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] = ClampedToInt(size[axis]);
  }
}

vtkIdType vtkInkVDBReader::GetNumberOfActiveVoxelsOfGrid(int index)
{
  return GridAt(*this->Source, index).activeCount.value_or(0);
}

vtkStringArray* vtkInkVDBReader::GetGridNames()
{
  return this->Names;
}

int vtkInkVDBReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputVector->GetInformationObject(0);
  const int nothing[6] = { 0, -1, 0, -1, 0, -1 };
  info->Set(SDDP::WHOLE_EXTENT(), nothing, 6);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  this->Failed = true;
  this->Names->SetNumberOfValues(0);
  try
  {
    const std::string file = InkTextOf(this->FileName);
    const ink::VdbFile& list = this->Source->List(file);
    for (const ink::VdbGridInfo& grid : list.grids)
    {
      if (grid.problem.empty())
      {
        this->Names->InsertNextValue(grid.name);
      }
    }
    const std::string wanted = InkTextOf(this->GridName);
    ink::VdbGridInfo grid;
    try
    {
      grid = list.find(wanted);
    }
    catch (const ink::VdbError& error)
    {
      throw ink::VdbError("Cannot read \"" + file + "\": " + error.what());
    }
    ink::VoxelBox box;
    if (grid.domain)
    {
      box = *grid.domain;
    }
    else
    {
      box = Padded(
        grid.activeBox ? *grid.activeBox : this->Source->Read(file, wanted, this->MaximumMemory).activeBox(),
        this->Padding);
    }
    this->Failed = false;
    if (box.empty())
    {
      vtkWarningMacro("Grid \"" << grid.name << "\" in \"" << file << "\" has no active voxels.");
    }
    else
    {
      const int extent[6] = { box.first.x, box.last.x, box.first.y, box.last.y, box.first.z, box.last.z };
      info->Set(SDDP::WHOLE_EXTENT(), extent, 6);
    }
    info->Set(vtkDataObject::ORIGIN(), &grid.origin[0], 3);
    info->Set(vtkDataObject::SPACING(), &grid.spacing[0], 3);
    double direction[9];
    for (int n = 0; n < 9; ++n)
    {
      direction[n] = grid.direction[n % 3][n / 3];
    }
    info->Set(vtkDataObject::DIRECTION(), direction, 9);
    vtkDataObject::SetPointDataActiveScalarInfo(info, grid.isDouble ? VTK_DOUBLE : VTK_FLOAT, 1);
  }
  catch (const ink::VdbError& error)
  {
    vtkErrorMacro(<< error.what() << ".");
  }
  catch (...)
  {
    InkReportException(this, nullptr, "Cannot read \"" + InkTextOf(this->FileName) + "\"");
  }
  return 1;
}

int vtkInkVDBReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  int extent[6];
  info->Get(SDDP::UPDATE_EXTENT(), extent);
  const ink::VoxelBox box = BoxOf(extent);
  if (this->Failed || box.empty())
  {
    return 1;
  }
  try
  {
    const std::string file = InkTextOf(this->FileName);
    const std::string wanted = InkTextOf(this->GridName);
    // The image first, whose size is known from its dimensions without reading anything.
    const ink::VdbGridInfo& listed = this->Source->List(file).find(wanted);
    const glm::dvec3 size = box.size();
    const double imageBytes = size.x * size.y * size.z * (listed.isDouble ? sizeof(double) : sizeof(float));
    constexpr double mebibyte = 1 << 20;
    const double allowed = this->MaximumMemory * mebibyte;
    const auto check = [&](double needed)
    {
      if (this->MaximumMemory != 0 && needed > allowed)
      {
        throw ink::VdbTooLarge("Cannot read \"" + file + "\": grid '" + listed.name + "' as an image of " +
          std::to_string(static_cast<std::int64_t>(size.x)) + " x " +
          std::to_string(static_cast<std::int64_t>(size.y)) + " x " +
          std::to_string(static_cast<std::int64_t>(size.z)) + " voxels needs " + InkMebibytes(needed) +
          " of memory; allowed are " + std::to_string(this->MaximumMemory) + " MiB (MaximumMemory)");
      }
    };
    check(imageBytes);
    const ink::VdbGrid& grid = this->Source->Read(file, wanted, this->MaximumMemory);
    check(imageBytes + static_cast<double>(grid.memory()));

    image->SetExtent(extent);
    image->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
    image->SetSpacing(info->Get(vtkDataObject::SPACING()));
    image->SetDirectionMatrix(info->Get(vtkDataObject::DIRECTION()));
    const bool negate = this->InvertLevelSets && grid.info().gridClass == ink::VdbClass::LevelSet;
    const bool done = listed.isDouble ? Fill<vtkDoubleArray>(grid, image, negate, this)
                                      : Fill<vtkFloatArray>(grid, image, negate, this);
    if (!done)
    {
      image->Initialize();
    }
  }
  catch (const ink::VdbError& error)
  {
    image->Initialize();
    vtkErrorMacro(<< error.what() << ".");
  }
  catch (...)
  {
    InkReportException(this, image, "Cannot read \"" + InkTextOf(this->FileName) + "\"");
  }
  return 1;
}

void vtkInkVDBReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << InkTextOf(this->FileName) << "\n"
     << indent << "GridName: " << InkTextOf(this->GridName) << "\n"
     << indent << "InvertLevelSets: " << this->InvertLevelSets << "\n"
     << indent << "Padding: " << this->Padding << "\n"
     << indent << "MaximumMemory: " << this->MaximumMemory << "\n";
}
