// SPDX-License-Identifier: BSD-3-Clause
#include "XmlVolume.h"

#include "ReaderProgress.h"

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
    failToRead(file, "it holds no values at its points (cell values alone cannot be used)");
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
  this->Reader->run([&] { algorithm->UpdateExtent(extent); });
  if (reporting.aborted())
  {
    throw ReadAborted();
  }
  image->ShallowCopy(this->Reader->GetOutput());
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
