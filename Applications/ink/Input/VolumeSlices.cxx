// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeSlices.h"

#include "ReadFile.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace ink::cli
{

VolumeSlices::VolumeSlices(vtkImageData* image)
  : Frame(image)
{
  image->GetDimensions(this->Dimensions.data());
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  this->Type = scalars->GetDataType();
  this->AtOnce = this->Dimensions[2];
  if (!scalars->HasStandardMemoryLayout())
  {
    vtkSmartPointer<vtkDataArray> contiguous =
      vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(this->Type));
    contiguous->DeepCopy(scalars);
    image->GetPointData()->SetScalars(contiguous);
    scalars = contiguous;
  }
  this->Values = static_cast<unsigned char*>(scalars->GetVoidPointer(0));
  this->LoadedEnd = this->Dimensions[2];
}

VolumeSlices::VolumeSlices(vtkImageData* frame, const io::RawVolume& voxels, const Memory& memory)
  : Frame(frame)
  , Type(voxels.type)
  , Reader(voxels)
{
  frame->GetDimensions(this->Dimensions.data());
  // Each voxel comes with a byte that marks a cell.
  const std::uint64_t needed = this->sliceBytes() + voxels.sliceValues();
  const std::uint64_t room = memory.forSlices() / needed;
  const int fewest = std::min(fewestAtOnce, this->Dimensions[2]);
  if (room < static_cast<std::uint64_t>(fewest))
  {
    failToRead(voxels.files.front(),
      "its slices have " + memoryText(this->sliceBytes()) + " each, and " + std::to_string(fewest) +
        " are needed at a time: expected --memory " +
        memoryText(Memory::limitFor(static_cast<std::uint64_t>(fewest) * needed, 4)) + " or more, found " +
        memoryText(memory.limit));
  }
  this->AtOnce = static_cast<int>(std::min<std::uint64_t>(room, this->Dimensions[2]));
  this->Buffer = std::make_unique_for_overwrite<unsigned char[]>(this->AtOnce * this->sliceBytes());
  this->Values = this->Buffer.get();
}

vtkImageData* VolumeSlices::frame() const
{
  return this->Frame;
}

std::size_t VolumeSlices::sliceBytes() const
{
  return static_cast<std::size_t>(this->Dimensions[0]) * this->Dimensions[1] *
    vtkDataArray::GetDataTypeSize(this->Type);
}

void VolumeSlices::load(int first, int end)
{
  // Neighboring parts of a volume share slices.
  int kept = 0;
  if (first >= this->LoadedFirst && first < this->LoadedEnd)
  {
    kept = std::min(this->LoadedEnd, end) - first;
    std::memmove(this->Values, this->Values + (first - this->LoadedFirst) * this->sliceBytes(),
      kept * this->sliceBytes());
  }
  this->LoadedFirst = first;
  this->LoadedEnd = first + kept;
  this->Reader->read(
    first + kept, { this->Values + kept * this->sliceBytes(), (end - first - kept) * this->sliceBytes() });
  this->LoadedEnd = end;
}

vtkSmartPointer<vtkImageData> VolumeSlices::get(int first, int end)
{
  if (first < 0 || end > this->Dimensions[2] || end - first > this->AtOnce || first >= end)
  {
    throw std::invalid_argument(
      "VolumeSlices: slices " + std::to_string(first) + " to " + std::to_string(end));
  }
  if (first < this->LoadedFirst || end > this->LoadedEnd)
  {
    this->load(first, end);
  }
  if (this->inMemory() && end - first == this->Dimensions[2])
  {
    return this->Frame;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  int extent[6];
  this->Frame->GetExtent(extent);
  extent[5] = extent[4] + end - 1;
  extent[4] += first;
  image->SetExtent(extent);
  image->SetOrigin(this->Frame->GetOrigin());
  image->SetSpacing(this->Frame->GetSpacing());
  image->SetDirectionMatrix(this->Frame->GetDirectionMatrix());
  vtkSmartPointer<vtkDataArray> values = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(this->Type));
  constexpr int notOurs = 1;
  values->SetVoidArray(this->Values + (first - this->LoadedFirst) * this->sliceBytes(),
    static_cast<vtkIdType>(image->GetNumberOfPoints()), notOurs);
  image->GetPointData()->SetScalars(values);
  return image;
}

} // namespace ink::cli
