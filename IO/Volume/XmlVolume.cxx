// SPDX-License-Identifier: BSD-3-Clause
#include "XmlVolume.h"

#include "InkCellCenters.h"
#include "ReaderProgress.h"
#include "VolumeHeader.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkImageExtractComponents.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace ink::io
{
namespace
{

/// The scalars, or the first array in their place. @throws ReadError if they are no values of voxels
vtkDataArray* chooseScalars(
  vtkImageData* image, const std::filesystem::path& file, std::vector<std::string>& notes)
{
  if (image->GetNumberOfPoints() == 0)
  {
    failToRead(file, "it holds no voxels");
  }
  vtkPointData* pointData = image->GetPointData();
  for (int i = 0; i < pointData->GetNumberOfArrays() && !pointData->GetScalars(); ++i)
  {
    if (vtkDataArray* array = pointData->GetArray(i))
    {
      pointData->SetActiveScalars(array->GetName());
      notes.push_back(std::string("array '") + array->GetName() + "' is used");
    }
  }
  vtkDataArray* scalars = pointData->GetScalars();
  if (!scalars)
  {
    failToRead(file, lackOfValues);
  }
  if (scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    failToRead(file,
      "it holds " + std::to_string(scalars->GetNumberOfTuples()) + " values for " +
        std::to_string(image->GetNumberOfPoints()) + " voxels");
  }
  if (scalars->GetDataType() == VTK_BIT)
  {
    failToRead(file, "its voxels are single bits; expected integers of 8 to 64 bits, float or double");
  }
  return scalars;
}

} // namespace

XmlVolume::XmlVolume(const std::filesystem::path& file)
  : File(file)
{
  this->Reader->open(file, format);
  this->Reader->run([this] { this->Reader->UpdateInformation(); });
  vtkInformation* own = this->Reader->GetOutputInformation(0);
  this->OfCells = InkAnnouncesCells(own);
  this->Announced->CopyEntry(own, vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  this->Announced->CopyEntry(own, vtkDataObject::ORIGIN());
  this->Announced->CopyEntry(own, vtkDataObject::SPACING());
  this->Announced->CopyEntry(own, vtkDataObject::DIRECTION());
  this->Announced->CopyEntry(own, vtkDataObject::POINT_DATA_VECTOR());
  if (this->OfCells)
  {
    const vtkSmartPointer<vtkImageData> frame = InkMakePointFrame(own);
    this->Announced->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), frame->GetExtent(), 6);
    this->Announced->Set(vtkDataObject::ORIGIN(), frame->GetOrigin(), 3);
    this->Announced->Set(vtkDataObject::POINT_DATA_VECTOR(), own->Get(vtkDataObject::CELL_DATA_VECTOR()));
  }
}

std::uint64_t XmlVolume::memorySize()
{
  vtkInformation* info = this->information();
  const int* extent = info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(
    info, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  if (!extent || !scalars || !scalars->Has(vtkDataObject::FIELD_ARRAY_TYPE()))
  {
    return 0;
  }
  double bytes = vtkDataArray::GetDataTypeSize(scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE()));
  if (scalars->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()))
  {
    bytes *= scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
  }
  for (int i = 0; i < 3; ++i)
  {
    bytes *= std::max(static_cast<double>(extent[2 * i + 1]) - extent[2 * i] + 1.0, 0.0);
  }
  // An extent that no values are promised for may have more voxels than there are numbers of 64 bits.
  constexpr double moreThanAnyMachine = 1LL << 60;
  return static_cast<std::uint64_t>(std::min(bytes, moreThanAnyMachine));
}

int XmlVolume::read(
  const int extent[6], vtkImageData* image, std::vector<std::string>& notes, const Progress& progress)
{
  const ReaderProgress reporting(this->Reader, progress);
  // The reader has a member of the name of the base's function.
  vtkAlgorithm* algorithm = this->Reader;
  int wanted[6];
  std::copy_n(extent, 6, wanted);
  if (this->OfCells)
  {
    InkToPointExtent(
      wanted, this->Reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
    notes.emplace_back(noteOfCells);
  }
  this->Reader->run([&] { algorithm->UpdateExtent(wanted); });
  if (reporting.aborted())
  {
    throw ReadAborted();
  }
  image->ShallowCopy(
    this->OfCells ? InkAtCellCenters(this->Reader->GetOutput()).Get() : this->Reader->GetOutput());
  this->Reader->GetOutput()->ReleaseData();
  const int components = chooseScalars(image, this->File, notes)->GetNumberOfComponents();
  if (components > 1)
  {
    vtkNew<vtkImageExtractComponents> first;
    first->SetInputData(image);
    first->SetComponents(0);
    first->Update();
    image->ShallowCopy(first->GetOutput());
  }
  return components;
}

} // namespace ink::io
