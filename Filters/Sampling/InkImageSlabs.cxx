// SPDX-License-Identifier: BSD-3-Clause
#include "InkImageSlabs.h"

#include "InkCellCenters.h"
#include "InkImageGrid.h"
#include "InkMemoryBudget.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace
{

/// What is said of an array before it is made: by its name, or of the active scalars.
struct Announced
{
  int Type = VTK_DOUBLE;
  int Components = 1;

  Announced(vtkInformation* info, const std::string& array)
  {
    const int association = InkAnnouncesCells(info, array) ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                                                           : vtkDataObject::FIELD_ASSOCIATION_POINTS;
    vtkInformation* named =
      array.empty() ? nullptr : vtkDataObject::GetNamedFieldInformation(info, association, array.c_str());
    vtkInformation* found = named
      ? named
      : vtkDataObject::GetActiveFieldInformation(info, association, vtkDataSetAttributes::SCALARS);
    if (found && found->Has(vtkDataObject::FIELD_ARRAY_TYPE()))
    {
      this->Type = found->Get(vtkDataObject::FIELD_ARRAY_TYPE());
    }
    if (found && found->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()))
    {
      this->Components = found->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
    }
  }
};

/// A point array of the image: the active scalars without a name; null if there is none.
vtkDataArray* FindScalars(vtkImageData* image, const std::string& array)
{
  vtkPointData* data = image->GetPointData();
  return array.empty() ? data->GetScalars() : data->GetArray(array.c_str());
}

/// Of an array that shows memory of another one.
constexpr int NotOurs = 1;

/// The points of a slice (border 0), or the cells between two (border 1).
std::uint64_t SizeOfLayer(vtkImageData* image, int border)
{
  const int* d = image->GetDimensions();
  return static_cast<std::uint64_t>(d[0] - border) * static_cast<std::uint64_t>(d[1] - border);
}

/// Gives a part of an image the marks of hidden and other points or cells.
void ShareMarks(vtkDataSetAttributes* from, std::uint64_t first, vtkIdType count, vtkDataSetAttributes* to)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  if (auto* marks = vtkUnsignedCharArray::SafeDownCast(from->GetArray(name)))
  {
    vtkNew<vtkUnsignedCharArray> part;
    part->SetName(name);
    part->SetArray(marks->GetPointer(static_cast<vtkIdType>(first)), count, NotOurs);
    to->AddArray(part);
  }
}

} // namespace

InkImageSlabs::InkImageSlabs(
  vtkAlgorithmOutput* port, const InkMemoryBudget& budget, const std::string& array)
  : Producer(port->GetProducer())
  , Port(port->GetIndex())
  , Array(array)
  , Budget(budget)
{
  this->Producer->UpdateInformation();
  vtkInformation* info = this->Producer->GetOutputInformation(this->Port);
  this->Frame = InkMakePointFrame(info, array);
  this->OfCells = InkAnnouncesCells(info, array);
  this->Frame->GetDimensions(this->Dimensions.data());
  this->AtOnce = this->Dimensions[2];
  if (vtkTrivialProducer::SafeDownCast(this->Producer))
  {
    // It is in memory already, and says nothing of its scalars.
    auto* image = vtkImageData::SafeDownCast(this->Producer->GetOutputDataObject(this->Port));
    this->OfCells = image && InkTakesCells(image, array);
    if (this->OfCells)
    {
      InkMoveToCellCenters(this->Frame);
      this->Frame->GetDimensions(this->Dimensions.data());
      this->AtOnce = this->Dimensions[2];
    }
    this->Load(0, this->AtOnce);
    return;
  }
  this->ScalarType = Announced(info, array).Type;
  if (this->GetBytes() <= budget.ForWholeImage())
  {
    return;
  }
  const std::uint64_t room = budget.ForSlices() / this->GetBytesAtOnce(1);
  const int fewest = std::min(FewestAtOnce, this->Dimensions[2]);
  if (room < static_cast<std::uint64_t>(fewest))
  {
    throw std::runtime_error("its slices have " + InkFormatMemory(this->GetSliceBytes()) + " each, and " +
      std::to_string(fewest) + " are needed at a time: expected MaximumMemory " +
      InkFormatMemory(this->GetMemoryFor(fewest)) + " or more, found " + InkFormatMemory(budget.Limit));
  }
  this->AtOnce = static_cast<int>(std::min<std::uint64_t>(room, this->Dimensions[2]));
}

InkImageSlabs::~InkImageSlabs() = default;

std::uint64_t InkImageSlabs::GetBytes(vtkInformation* info, const std::string& array, int bytesBeside)
{
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  // In double first, in which nothing overflows: a sparse grid's box may have more voxels than 2^64.
  const Announced announced(info, array);
  double bytes =
    static_cast<double>(vtkDataArray::GetDataTypeSize(announced.Type)) * std::max(announced.Components, 1) +
    bytesBeside;
  for (int axis = 0; axis < 3; ++axis)
  {
    bytes *= std::max(static_cast<double>(extent[2 * axis + 1]) - extent[2 * axis] + 1.0, 0.0);
  }
  constexpr double moreThanAnyMachine = 1LL << 60;
  return static_cast<std::uint64_t>(std::min(bytes, moreThanAnyMachine));
}

std::uint64_t InkImageSlabs::GetBytes() const
{
  return this->GetSliceBytes() * static_cast<std::uint64_t>(this->Dimensions[2]);
}

std::uint64_t InkImageSlabs::GetSliceBytes() const
{
  return static_cast<std::uint64_t>(this->Dimensions[0]) * static_cast<std::uint64_t>(this->Dimensions[1]) *
    static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(this->ScalarType));
}

int InkImageSlabs::GetAtOnce(int bytesBeside) const
{
  // A whole image has memory of its own.
  const std::uint64_t bytes =
    this->GetBytesAtOnce(1, bytesBeside) - (this->IsWhole() ? this->GetBytesAtOnce(1) : 0);
  return bytes == 0
    ? this->AtOnce
    : static_cast<int>(std::min(this->Budget.ForSlices() / bytes, static_cast<std::uint64_t>(this->AtOnce)));
}

std::uint64_t InkImageSlabs::GetBytesAtOnce(int slices, int bytesBeside) const
{
  // Each voxel comes with a byte that marks a cell.
  const std::uint64_t voxels =
    static_cast<std::uint64_t>(this->Dimensions[0]) * static_cast<std::uint64_t>(this->Dimensions[1]);
  return static_cast<std::uint64_t>(slices) *
    (this->GetSliceBytes() + voxels * static_cast<std::uint64_t>(1 + bytesBeside));
}

std::uint64_t InkImageSlabs::GetMemoryFor(int slices, int bytesBeside) const
{
  return InkMemoryBudget::LimitFor(this->GetBytesAtOnce(slices, bytesBeside), 4);
}

vtkSmartPointer<vtkImageData> InkImageSlabs::Make(const int wanted[6])
{
  int extent[6];
  std::copy_n(wanted, 6, extent);
  if (this->OfCells)
  {
    InkToPointExtent(extent,
      this->Producer->GetOutputInformation(this->Port)
        ->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  }
  this->Producer->UpdateExtent(extent);
  auto* image = vtkImageData::SafeDownCast(this->Producer->GetOutputDataObject(this->Port));
  return image && this->OfCells ? InkAtCellCenters(image) : vtkSmartPointer<vtkImageData>(image);
}

void InkImageSlabs::Load(int first, int end)
{
  const int* whole = this->Frame->GetExtent();
  this->LoadedEnd = this->LoadedFirst;
  // Memory is reused that nobody holds but who makes the image.
  vtkDataArray* last = this->Loaded ? FindScalars(this->Loaded, this->Array) : nullptr;
  if (last && last->GetReferenceCount() > 1)
  {
    this->Loaded->Initialize();
  }
  this->Loaded = nullptr;
  const int wanted[6] = { whole[0], whole[1], whole[2], whole[3], whole[4] + first, whole[4] + end - 1 };
  vtkSmartPointer<vtkImageData> image = this->Make(wanted);
  const std::string slices = "slices " + std::to_string(first) + " to " + std::to_string(end - 1);
  const int* made = image ? image->GetExtent() : nullptr;
  if (!made || made[4] > wanted[4] || made[5] < wanted[5] || !std::equal(made, made + 4, whole))
  {
    throw std::runtime_error("its input does not make " + slices);
  }
  vtkDataArray* scalars = FindScalars(image, this->Array);
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("expected a point array" +
      (this->Array.empty() ? "" : " '" + this->Array + "'") + " of one component, found " +
      (scalars ? std::to_string(scalars->GetNumberOfComponents()) : "none"));
  }
  int component = 0;
  const vtkSmartPointer<vtkDataArray> contiguous = InkMakeContiguous(scalars, component);
  this->Loaded = image;
  if (contiguous != image->GetPointData()->GetScalars())
  {
    this->Loaded = vtkSmartPointer<vtkImageData>::New();
    this->Loaded->ShallowCopy(image);
    this->Loaded->GetPointData()->SetScalars(contiguous);
  }
  this->ScalarType = contiguous->GetDataType();
  this->Values = static_cast<unsigned char*>(contiguous->GetVoidPointer(0));
  this->LoadedFirst = made[4] - whole[4];
  this->LoadedEnd = made[5] - whole[4] + 1;
}

vtkSmartPointer<vtkImageData> InkImageSlabs::Get(int first, int end)
{
  if (first < 0 || end > this->Dimensions[2] || end - first > this->AtOnce || first >= end)
  {
    throw std::invalid_argument(
      "InkImageSlabs: slices " + std::to_string(first) + " to " + std::to_string(end));
  }
  if (first < this->LoadedFirst || end > this->LoadedEnd)
  {
    this->IsWhole() ? this->Load(0, this->AtOnce) : this->Load(first, end);
  }
  if (end - first == this->Dimensions[2])
  {
    return this->Loaded;
  }
  auto part = vtkSmartPointer<vtkImageData>::New();
  part->CopyStructure(this->Frame);
  int extent[6];
  this->Frame->GetExtent(extent);
  extent[5] = extent[4] + end - 1;
  extent[4] += first;
  part->SetExtent(extent);
  vtkSmartPointer<vtkDataArray> values =
    vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(this->ScalarType));
  const auto before = static_cast<std::uint64_t>(first - this->LoadedFirst);
  values->SetVoidArray(this->Values + before * this->GetSliceBytes(),
    static_cast<vtkIdType>(part->GetNumberOfPoints()), NotOurs);
  part->GetPointData()->SetScalars(values);
  ShareMarks(this->Loaded->GetPointData(), before * SizeOfLayer(part, 0), part->GetNumberOfPoints(),
    part->GetPointData());
  ShareMarks(this->Loaded->GetCellData(), before * SizeOfLayer(part, 1), part->GetNumberOfCells(),
    part->GetCellData());
  return part;
}
