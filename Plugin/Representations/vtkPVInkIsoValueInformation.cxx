// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVInkIsoValueInformation.h"

#include "InkLeaves.h"
#include "InkVolumeValues.h"
#include "vtkInkRepresentation.h"

#include "vtkAlgorithm.h"
#include "vtkClientServerStream.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkObjectFactory.h"

#include <vector>

vtkStandardNewMacro(vtkPVInkIsoValueInformation);

vtkPVInkIsoValueInformation::vtkPVInkIsoValueInformation() = default;

vtkPVInkIsoValueInformation::~vtkPVInkIsoValueInformation() = default;

void vtkPVInkIsoValueInformation::SetPort(int port)
{
  this->Port = port;
}

void vtkPVInkIsoValueInformation::SetArrayName(const std::string& name)
{
  this->ArrayName = name;
}

bool vtkPVInkIsoValueInformation::GetFound() const
{
  return this->Voxels > 0.0;
}

double vtkPVInkIsoValueInformation::GetValue() const
{
  return this->Value;
}

void vtkPVInkIsoValueInformation::Share(vtkMultiProcessController* controller)
{
  const double own[2] = { this->Voxels, this->Value };
  std::vector<double> all(2 * static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(own, all.data(), 2);
  // The first of the largest, on each process.
  this->Voxels = 0.0;
  for (std::size_t i = 0; i < all.size(); i += 2)
  {
    if (all[i] > this->Voxels)
    {
      this->Voxels = all[i];
      this->Value = all[i + 1];
    }
  }
}

void vtkPVInkIsoValueInformation::CopyFromObject(vtkObject* object)
{
  this->Value = 0.0;
  this->Voxels = 0.0;
  if (auto* representation = vtkInkRepresentation::SafeDownCast(object))
  {
    const std::vector<double> used = representation->GetUsedIsoValues();
    const auto surface = static_cast<std::size_t>(this->Port);
    if (surface < used.size())
    {
      this->Value = used[surface];
      this->Voxels = 1.0;
    }
    return;
  }
  auto algorithm = vtkAlgorithm::SafeDownCast(object);
  auto given = vtkImageData::SafeDownCast(algorithm ? algorithm->GetOutputDataObject(this->Port) : nullptr);
  if (!given || given->GetNumberOfPoints() == 0)
  {
    return;
  }
  const InkLeaves leaves(given, this->ArrayName);
  if (leaves.Images.empty())
  {
    return;
  }
  vtkImageData* image = leaves.Images.front();
  if (const auto suggestions = InkSuggestIsoValues(image); !suggestions.empty())
  {
    this->Value = suggestions.front().value;
    this->Voxels = static_cast<double>(image->GetNumberOfPoints());
  }
}

void vtkPVInkIsoValueInformation::AddInformation(vtkPVInformation* other)
{
  auto one = vtkPVInkIsoValueInformation::SafeDownCast(other);
  if (one && one->Voxels > this->Voxels)
  {
    this->Value = one->Value;
    this->Voxels = one->Voxels;
  }
}

void vtkPVInkIsoValueInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << this->Value << this->Voxels << vtkClientServerStream::End;
}

void vtkPVInkIsoValueInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  if (!stream->GetArgument(0, 0, &this->Value) || !stream->GetArgument(0, 1, &this->Voxels))
  {
    vtkErrorMacro("Expected a value and a number of voxels from the server.");
  }
}

void vtkPVInkIsoValueInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << this->Port << this->ArrayName;
}

void vtkPVInkIsoValueInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  stream >> this->Port >> this->ArrayName;
}

void vtkPVInkIsoValueInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Port: " << this->Port << "\n"
     << indent << "ArrayName: " << this->ArrayName << "\n"
     << indent << "Value: " << this->Value << "\n"
     << indent << "Voxels: " << this->Voxels << "\n";
}
