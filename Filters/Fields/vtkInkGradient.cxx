// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkGradient.h"

#include "Fields/Derivatives/Gradients.h"
#include "Fields/Derivatives/LaplacianOfGaussian.h"
#include "Fields/Grid/GridField.h"
#include "InkAllocate.h"
#include "InkImageGrid.h"
#include "InkPrecision.h"
#include "InkReportException.h"
#include "InkTrimArray.h"
#include "InkVTKCompat.h"
#include "InkWithGridField.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkInkGradient);

namespace
{

using SDDP = vtkStreamingDemandDrivenPipeline;

/// The parameters and outputs of one run.
struct GradientRequest
{
  ink::SampleBox Box;
  ink::GradientOptions Options;
  glm::dvec3 Deviation;
  vtkDataArray* Gradient;
  vtkDataArray* Magnitude;
  vtkDataArray* Value;
  vtkDataArray* Laplacian;

  bool HasGradients() const { return this->Gradient || this->Magnitude || this->Value; }
};

template <class Real>
std::span<Real> ValuesOf(vtkDataArray* array)
{
  auto* values = vtkAOSDataArrayTemplate<Real>::FastDownCast(array);
  return values
    ? std::span<Real>(values->GetPointer(0), static_cast<std::size_t>(values->GetNumberOfValues()))
    : std::span<Real>();
}

/// Returns false when aborted.
template <class Real, class T>
bool Compute(const ink::GridField<T>& field, const GradientRequest& request, vtkAlgorithm* algorithm)
{
  const double steps = request.HasGradients() + (request.Laplacian != nullptr);
  double done = 0.0;
  const auto progress = [&](double share)
  {
    algorithm->UpdateProgress((done + share) / steps);
    return !InkCheckAbort(algorithm);
  };
  if (request.HasGradients())
  {
    const ink::GradientArrays<Real> arrays{ ValuesOf<Real>(request.Gradient),
      ValuesOf<Real>(request.Magnitude), ValuesOf<Real>(request.Value) };
    if (!ink::estimateGradients<T, Real>(field, request.Box, request.Options, arrays, progress))
    {
      return false;
    }
    done = 1.0;
  }
  return !request.Laplacian ||
    ink::laplacianOfGaussian<T, Real>(
      field, request.Box, request.Deviation, ValuesOf<Real>(request.Laplacian), progress);
}

/// Dispatches on the type of `array`, which is contiguous.
bool ComputeFromArray(const ink::GridGeometry& geometry, vtkDataArray* array, int component,
  const ink::ElementMarks& hidden, bool doubles, const GradientRequest& request, vtkAlgorithm* algorithm)
{
  return InkWithGridField(geometry, array, component, hidden,
    [&](const auto& field) {
      return doubles ? Compute<double>(field, request, algorithm) : Compute<float>(field, request, algorithm);
    });
}

ink::GradientOptions OptionsOf(vtkInkGradient* filter)
{
  ink::GradientOptions options;
  options.method = filter->GetMethod() == vtkInkGradient::CENTRAL_DIFFERENCE
    ? ink::GradientMethod::CentralDifference
    : ink::GradientMethod::Regression;
  options.radius = filter->GetNeighborhood() == vtkInkGradient::NEIGHBORHOOD_3 ? 1 : 2;
  options.weighting = filter->GetWeighting() == vtkInkGradient::UNIFORM
    ? ink::RegressionWeighting::Uniform
    : ink::RegressionWeighting::InverseDistance;
  return options;
}

glm::dvec3 DeviationOf(vtkInkGradient* filter, const ink::GridGeometry& geometry)
{
  return ink::gaussianInSamples(geometry, filter->GetLaplacianScale(),
    filter->GetLaplacianScaleUnit() == vtkInkGradient::SAMPLES ? ink::ScaleUnit::Samples
                                                               : ink::ScaleUnit::World);
}

/// The radius of the results' support, in points along each axis. `info` describes the image.
glm::ivec3 ReachOf(vtkInkGradient* filter, vtkInformation* info)
{
  glm::ivec3 reach(0);
  if (filter->GetComputeGradient() || filter->GetComputeGradientMagnitude() || filter->GetComputeValue())
  {
    reach = glm::ivec3(ink::gradientReach(OptionsOf(filter)));
  }
  if (filter->GetComputeLaplacian())
  {
    vtkNew<vtkImageData> image;
    image->CopyInformationFromPipeline(info);
    const int nothing[6] = { 0, -1, 0, -1, 0, -1 };
    try
    {
      reach =
        glm::max(reach, ink::laplacianReach(DeviationOf(filter, InkMakeGrid(image, InkExtent(nothing)))));
    }
    catch (const std::invalid_argument&)
    {
      // RequestData reports it.
    }
  }
  return reach;
}

/// Whether a piece is requested; the requested extent is then ignored.
bool IsPieceAskedFor(vtkInformation* outInfo)
{
  return outInfo->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) > 1;
}

int LargestOf(const glm::ivec3& v)
{
  return std::max({ v.x, v.y, v.z });
}

/// The bounding box of the cells not marked as another piece's, as a box of points.
InkExtent OwnPart(vtkImageData* image)
{
  InkExtent own(image->GetExtent());
  const ink::ElementMarks others = InkGetMarks(image->GetCellData(), vtkDataSetAttributes::DUPLICATECELL);
  if (others.empty())
  {
    return own;
  }
  const glm::ivec3 cells = glm::max(own.GetDimensions() - 1, glm::ivec3(1));
  glm::ivec3 low = cells;
  glm::ivec3 high(-1);
  std::size_t cell = 0;
  for (glm::ivec3 at(0); at.z < cells.z; ++at.z)
  {
    for (at.y = 0; at.y < cells.y; ++at.y)
    {
      for (at.x = 0; at.x < cells.x; ++at.x, ++cell)
      {
        if (!others[cell])
        {
          low = glm::min(low, at);
          high = glm::max(high, at);
        }
      }
    }
  }
  own.Last = own.First + high + 1;
  own.First += low;
  return own;
}

/// The part of the image for which results are requested.
InkExtent PartOf(vtkInformation* inInfo, vtkInformation* outInfo, vtkImageData* image)
{
  const InkExtent given(image->GetExtent());
  InkExtent part = given;
  if (!IsPieceAskedFor(outInfo))
  {
    part = InkExtent(outInfo->Get(SDDP::UPDATE_EXTENT()));
  }
  else if (InkIsOfFirstPiece(inInfo, outInfo, image))
  {
    part.Last = part.First - 1;
    return part;
  }
  else
  {
    part = OwnPart(image);
    if (glm::any(glm::lessThan(part.Last, part.First)))
    {
      return part;
    }
    const int levels = outInfo->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS());
    part.First -= levels;
    part.Last += levels;
  }
  part.First = glm::max(part.First, given.First);
  part.Last = glm::min(part.Last, given.Last);
  return part;
}

/// A part of an image with its arrays cropped; the image itself if the part is the whole.
void CopyPart(vtkImageData* image, const InkExtent& part, vtkImageData* output)
{
  output->ShallowCopy(image);
  const int extent[6] = { part.First.x, part.Last.x, part.First.y, part.Last.y, part.First.z, part.Last.z };
  if (part != InkExtent(image->GetExtent()))
  {
    output->Crop(extent);
  }
}

} // namespace

vtkInkGradient::vtkInkGradient()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkInkGradient::~vtkInkGradient() = default;

const char* vtkInkGradient::GetMethodAsString()
{
  return this->Method == REGRESSION ? "Regression" : "CentralDifference";
}

const char* vtkInkGradient::GetNeighborhoodAsString()
{
  return this->Neighborhood == NEIGHBORHOOD_3 ? "3" : "5";
}

const char* vtkInkGradient::GetWeightingAsString()
{
  return this->Weighting == UNIFORM ? "Uniform" : "InverseDistance";
}

const char* vtkInkGradient::GetLaplacianScaleUnitAsString()
{
  return this->LaplacianScaleUnit == SAMPLES ? "Samples" : "WorldUnits";
}

const char* vtkInkGradient::GetOutputArraysPrecisionAsString()
{
  return InkNameOfPrecision(this->OutputArraysPrecision);
}

int vtkInkGradient::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  this->KeepArrays(vtkImageData::GetData(outInfo));
  int extent[6];
  int whole[6];
  outInfo->Get(SDDP::UPDATE_EXTENT(), extent);
  inInfo->Get(SDDP::WHOLE_EXTENT(), whole);
  const glm::ivec3 reach = ReachOf(this, inInfo);
  if (IsPieceAskedFor(outInfo))
  {
    inInfo->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      outInfo->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS()) + LargestOf(reach));
    return 1;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    // An empty extent requests nothing.
    if (extent[2 * axis] <= extent[2 * axis + 1])
    {
      extent[2 * axis] = std::max(extent[2 * axis] - reach[axis], whole[2 * axis]);
      extent[2 * axis + 1] = std::min(extent[2 * axis + 1] + reach[axis], whole[2 * axis + 1]);
    }
  }
  inInfo->Set(SDDP::UPDATE_EXTENT(), extent, 6);
  return 1;
}

void vtkInkGradient::KeepArrays(vtkImageData* output)
{
  const char* const names[] = { "Gradient", "GradientMagnitude", "Value", "Laplacian" };
  for (int n = 0; n < 4; ++n)
  {
    this->Kept[n] = output ? output->GetPointData()->GetArray(names[n]) : nullptr;
  }
}

vtkSmartPointer<vtkDataArray> vtkInkGradient::MakeArray(int which, vtkIdType tuples)
{
  const char* const names[] = { "Gradient", "GradientMagnitude", "Value", "Laplacian" };
  const int type = this->OutputArraysPrecision == SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE;
  vtkSmartPointer<vtkDataArray> array = this->Kept[which];
  this->Kept[which] = nullptr;
  if (!array || array->GetReferenceCount() > 1 || array->GetDataType() != type ||
    !array->HasStandardMemoryLayout())
  {
    array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  }
  array->SetName(names[which]);
  array->SetNumberOfComponents(which == 0 ? 3 : 1);
  InkSetNumberOfTuples(array, tuples);
  InkTrimArray(array);
  array->Modified();
  return array;
}

int vtkInkGradient::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  output->Initialize();
  // An empty piece is not an error.
  if (!image || image->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* found = this->GetInputArrayToProcess(0, inputVector, association);
  vtkDataArray* scalars = InkChooseScalars(this, image, found, association, this->ArrayComponent);
  if (!scalars)
  {
    return 1;
  }

  const InkExtent own(image->GetExtent());
  const InkExtent part = PartOf(inputVector[0]->GetInformationObject(0), outInfo, image);
  GradientRequest request;
  request.Box = { part.First - own.First, part.Last - own.First + 1 };
  if (request.Box.empty())
  {
    return 1;
  }
  const vtkIdType count = static_cast<vtkIdType>(request.Box.count());
  const auto arrayFor = [&](int which, bool wanted)
  { return wanted ? this->MakeArray(which, count) : vtkSmartPointer<vtkDataArray>(); };
  try
  {
    const ink::GridGeometry geometry = InkMakeGrid(image, own);
    const vtkSmartPointer<vtkDataArray> arrays[4] = { arrayFor(0, this->ComputeGradient),
      arrayFor(1, this->ComputeGradientMagnitude), arrayFor(2, this->ComputeValue),
      arrayFor(3, this->ComputeLaplacian) };
    request.Options = OptionsOf(this);
    request.Deviation = DeviationOf(this, geometry);
    request.Gradient = arrays[0];
    request.Magnitude = arrays[1];
    request.Value = arrays[2];
    request.Laplacian = arrays[3];
    int component = this->ArrayComponent;
    const vtkSmartPointer<vtkDataArray> array = InkMakeContiguous(scalars, component);
    const ink::ElementMarks hidden = InkGetMarks(image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
    if (ComputeFromArray(
          geometry, array, component, hidden, this->OutputArraysPrecision == DOUBLE_PRECISION, request, this))
    {
      CopyPart(image, part, output);
      for (vtkDataArray* result : arrays)
      {
        if (result)
        {
          output->GetPointData()->AddArray(result);
        }
      }
    }
  }
  catch (...)
  {
    InkReportException(this, output, "Gradients of the image cannot be computed");
  }
  return 1;
}

void vtkInkGradient::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "Neighborhood: " << this->GetNeighborhoodAsString() << "\n";
  os << indent << "Weighting: " << this->GetWeightingAsString() << "\n";
  os << indent << "ComputeGradient: " << this->ComputeGradient << "\n";
  os << indent << "ComputeGradientMagnitude: " << this->ComputeGradientMagnitude << "\n";
  os << indent << "ComputeValue: " << this->ComputeValue << "\n";
  os << indent << "ComputeLaplacian: " << this->ComputeLaplacian << "\n";
  os << indent << "LaplacianScale: " << this->LaplacianScale << "\n";
  os << indent << "LaplacianScaleUnit: " << this->GetLaplacianScaleUnitAsString() << "\n";
  os << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
  os << indent << "OutputArraysPrecision: " << this->GetOutputArraysPrecisionAsString() << "\n";
}
