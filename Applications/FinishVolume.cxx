#include "FinishVolume.h"

#include "ReadFile.h"
#include "Text.h"
#include "VolumeSlices.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageExtractComponents.h"
#include "vtkImageShiftScale.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace ink::cli
{
namespace
{

std::string componentsNote(int components)
{
  return "its voxels have " + std::to_string(components) + " components; the first is used";
}

} // namespace

Input makeVolumeInput(vtkImageData* image, const std::filesystem::path& file, const std::string& format)
{
  Input input;
  input.format = format;
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
      input.notes.push_back(std::string("array '") + array->GetName() + "' is used");
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

  input.components = scalars->GetNumberOfComponents();
  if (input.components > 1)
  {
    input.notes.push_back(componentsNote(input.components));
    vtkNew<vtkImageExtractComponents> first;
    first->SetInputData(image);
    first->SetComponents(0);
    first->Update();
    input.data = first->GetOutput();
  }
  else
  {
    input.data = image;
  }
  return input;
}

Input makeVolumeInput(
  vtkImageData* frame, const PlainVoxels& voxels, const std::string& format, const Memory& memory)
{
  Input input;
  input.format = format;
  input.volume = std::make_shared<VolumeSlices>(frame, voxels, memory);
  return input;
}

void setComponents(Input& input, int components)
{
  input.components = components;
  if (components > 1)
  {
    input.notes.push_back(componentsNote(components));
  }
}

void rescale(Input& input, double slope, double intercept)
{
  if (slope == 0.0 || (slope == 1.0 && intercept == 0.0))
  {
    return;
  }
  vtkNew<vtkImageShiftScale> filter;
  filter->SetInputDataObject(input.data);
  // The filter adds before it multiplies.
  filter->SetShift(intercept / slope);
  filter->SetScale(slope);
  // Whole numbers stay what they are where they have room.
  auto* image = vtkImageData::SafeDownCast(input.data);
  const double bounds[2] = { image->GetScalarTypeMin() * slope + intercept,
    image->GetScalarTypeMax() * slope + intercept };
  const bool whole = slope == 1.0 && intercept == std::floor(intercept) &&
    image->GetScalarType() != VTK_FLOAT && image->GetScalarType() != VTK_DOUBLE;
  const auto fits = [&bounds](double least, double greatest)
  { return std::min(bounds[0], bounds[1]) >= least && std::max(bounds[0], bounds[1]) <= greatest; };
  if (whole && fits(VTK_SHORT_MIN, VTK_SHORT_MAX))
  {
    filter->SetOutputScalarTypeToShort();
  }
  else if (whole && fits(VTK_INT_MIN, VTK_INT_MAX))
  {
    filter->SetOutputScalarTypeToInt();
  }
  else
  {
    filter->SetOutputScalarTypeToFloat();
  }
  filter->Update();
  input.data = filter->GetOutput();
  input.notes.push_back("its stored values are rescaled: " + text(slope) + " v + " + text(intercept));
}

} // namespace ink::cli
