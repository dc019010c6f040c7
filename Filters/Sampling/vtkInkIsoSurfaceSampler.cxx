// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIsoSurfaceSampler.h"

#include "InkImageGrid.h"
#include "InkVTKCompat.h"
#include "Sampling/CrossedCells.h"
#include "Sampling/IsoSurfaceSamples.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkContourValues.h"
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
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

vtkStandardNewMacro(vtkInkIsoSurfaceSampler);

namespace
{

/// One VTK_POLY_VERTEX cell over points 0 ... count - 1.
template <class IdArray>
vtkSmartPointer<vtkCellArray> MakePolyVertex(vtkIdType count)
{
  using Id = typename IdArray::ValueType;
  vtkNew<IdArray> offsets;
  offsets->SetNumberOfValues(2);
  offsets->SetValue(0, 0);
  offsets->SetValue(1, static_cast<Id>(count));
  vtkNew<IdArray> points;
  points->SetNumberOfValues(count);
  std::iota(points->GetPointer(0), points->GetPointer(0) + count, Id(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, points);
  return cells;
}

/// Counts the steps of one run, each a pass over the volume, and tells the algorithm's observers.
class StepProgress
{
public:
  StepProgress(vtkAlgorithm* algorithm, std::size_t steps)
    : Algorithm(algorithm)
    , Steps(static_cast<double>(steps))
  {
  }

  ink::Progress NextStep()
  {
    return [this, before = this->Done++](double fraction)
    {
      this->Algorithm->UpdateProgress((before + fraction) / this->Steps);
      return !InkCheckAbort(this->Algorithm);
    };
  }

private:
  vtkAlgorithm* Algorithm;
  double Steps;
  double Done = 0.0;
};

/// One run over all iso-values.
struct SampleRequest
{
  std::span<const double> IsoValues;
  ink::CrossingRule Rule;
  ink::CellSelection Cells;
  bool Normals;
};

/// Writes the samples of the iso-values, one after the other; `normals` stays empty when they are not wanted.
/// Returns false when aborted.
template <class Real, class T>
bool Sample(const ink::GridField<T>& field, const SampleRequest& request, vtkAlgorithm* algorithm,
  vtkAOSDataArrayTemplate<Real>* points, vtkFloatArray* normals)
{
  StepProgress progress(algorithm, 2 * request.IsoValues.size());
  std::vector<ink::CrossedCells> crossed;
  std::size_t total = 0;
  for (const double isoValue : request.IsoValues)
  {
    crossed.push_back(
      ink::findCrossedCells(field, isoValue, request.Rule, request.Cells, progress.NextStep()));
    if (InkCheckAbort(algorithm))
    {
      return false;
    }
    total += crossed.back().count;
  }

  points->SetNumberOfTuples(static_cast<vtkIdType>(total));
  normals->SetNumberOfTuples(request.Normals ? static_cast<vtkIdType>(total) : 0);
  Real* point = points->GetPointer(0);
  float* normal = normals->GetPointer(0);
  for (std::size_t i = 0; i < crossed.size(); ++i)
  {
    const std::size_t size = 3 * crossed[i].count;
    const std::size_t normalSize = request.Normals ? size : 0;
    if (!ink::placeIsoSurfaceSamples(field, request.IsoValues[i], { request.Rule }, crossed[i],
          std::span<Real>(point, size), { std::span<float>(normal, normalSize), {}, {} }, progress.NextStep()))
    {
      return false;
    }
    point += size;
    normal += normalSize;
  }
  return true;
}

/// The same for an array whose type is not known; `array` is contiguous.
bool SampleArray(const ink::GridGeometry& geometry, vtkDataArray* array, int component,
  const ink::ElementMarks& hidden, const SampleRequest& request, vtkAlgorithm* algorithm,
  vtkDataArray* points, vtkFloatArray* normals)
{
  const auto sample = [&](auto* values)
  {
    using T = typename std::remove_pointer_t<decltype(values)>::ValueType;
    const std::span<const T> all(
      values->GetPointer(0), static_cast<std::size_t>(values->GetNumberOfValues()));
    const ink::GridField<T> field(geometry, all.subspan(static_cast<std::size_t>(component)),
      static_cast<std::size_t>(values->GetNumberOfComponents()), hidden);
    if (auto* floats = vtkFloatArray::SafeDownCast(points))
    {
      return Sample<float>(field, request, algorithm, floats, normals);
    }
    return Sample<double>(field, request, algorithm, vtkDoubleArray::SafeDownCast(points), normals);
  };
  switch (array->GetDataType())
  {
    vtkTemplateMacro(return sample(vtkAOSDataArrayTemplate<VTK_TT>::FastDownCast(array)));
  }
  throw std::invalid_argument(std::string("its values have the type ") + array->GetDataTypeAsString());
}

} // namespace

vtkInkIsoSurfaceSampler::vtkInkIsoSurfaceSampler()
{
  // It holds one value at first.
  this->ContourValues->SetNumberOfContours(0);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkInkIsoSurfaceSampler::~vtkInkIsoSurfaceSampler() = default;

void vtkInkIsoSurfaceSampler::SetValue(int i, double value)
{
  this->ContourValues->SetValue(i, value);
}

double vtkInkIsoSurfaceSampler::GetValue(int i)
{
  return this->ContourValues->GetValue(i);
}

void vtkInkIsoSurfaceSampler::SetNumberOfContours(int number)
{
  this->ContourValues->SetNumberOfContours(number);
}

vtkIdType vtkInkIsoSurfaceSampler::GetNumberOfContours()
{
  return this->ContourValues->GetNumberOfContours();
}

void vtkInkIsoSurfaceSampler::GenerateValues(int numContours, double rangeStart, double rangeEnd)
{
  this->ContourValues->GenerateValues(numContours, rangeStart, rangeEnd);
}

vtkMTimeType vtkInkIsoSurfaceSampler::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
}

int vtkInkIsoSurfaceSampler::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkInkIsoSurfaceSampler::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  // A normal beside a piece's border takes a value from across it.
  using SDDP = vtkStreamingDemandDrivenPipeline;
  const int ghostLevels = output->GetInformationObject(0)->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS());
  input[0]->GetInformationObject(0)->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), ghostLevels + 1);
  return 1;
}

vtkDataArray* vtkInkIsoSurfaceSampler::GetScalars(vtkImageData* image, vtkInformationVector** input)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const char* chosen = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  // ParaView gives an empty name where no array was chosen.
  vtkDataArray* scalars = chosen && !*chosen ? image->GetPointData()->GetScalars()
                                             : this->GetInputArrayToProcess(0, input, association);
  if (!scalars)
  {
    const int count = image->GetPointData()->GetNumberOfArrays();
    std::string found;
    for (int i = 0; i < count; ++i)
    {
      const char* name = image->GetPointData()->GetArrayName(i);
      found += (i ? ", \"" : "\"") + std::string(name ? name : "") + "\"";
    }
    vtkErrorMacro(<< (chosen && *chosen ? "No numeric point array \"" + std::string(chosen) + "\""
                                        : std::string("No point scalars"))
                  << " in the image. Its point arrays: " << (found.empty() ? "none" : found) << ".");
    return nullptr;
  }
  const char* name = scalars->GetName() ? scalars->GetName() : "(unnamed)";
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS ||
    scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    vtkErrorMacro("The array " << name << " has " << scalars->GetNumberOfTuples()
                               << " values and is not point data. Expected a point array with "
                               << image->GetNumberOfPoints() << " values.");
    return nullptr;
  }
  if (this->ArrayComponent >= scalars->GetNumberOfComponents())
  {
    vtkErrorMacro("ArrayComponent is " << this->ArrayComponent << ", but the array " << name << " has "
                                       << scalars->GetNumberOfComponents() << " components, counted from 0.");
    return nullptr;
  }
  return scalars;
}

int vtkInkIsoSurfaceSampler::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  // A piece that holds nothing is no error.
  if (!image || image->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const InkExtent whole = InkGetWholeExtent(info, image);
  const glm::ivec3 samples = whole.GetDimensions();
  if (std::min({ samples.x, samples.y, samples.z }) < 2)
  {
    vtkWarningMacro("The image has " << samples.x << " x " << samples.y << " x " << samples.z
                                     << " samples. An iso-surface needs at least 2 along each axis.");
    return 1;
  }
  vtkDataArray* scalars = this->GetScalars(image, inputVector);
  if (!scalars)
  {
    return 1;
  }
  SampleRequest request;
  request.IsoValues = std::span<const double>(
    this->ContourValues->GetValues(), static_cast<std::size_t>(this->ContourValues->GetNumberOfContours()));
  request.Rule = this->CrossingRule == STRICT ? ink::CrossingRule::Strict : ink::CrossingRule::HalfOpen;
  request.Cells = InkSelectCells(info, this->GetInputAlgorithm(), image);
  request.Normals = this->ComputeNormals;
  if (std::any_of(request.IsoValues.begin(), request.IsoValues.end(), [](double v) { return std::isnan(v); }))
  {
    vtkWarningMacro("An iso-value is not a number (NaN) and makes no points.");
  }

  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  double radius = 0.0;
  try
  {
    const ink::GridGeometry geometry = InkMakeGrid(image, InkExtent(image->GetExtent()));
    const bool doubles = this->OutputPointsPrecision == DOUBLE_PRECISION ||
      (this->OutputPointsPrecision == DEFAULT_PRECISION &&
        InkNeedsDoublePrecision(InkMakeGrid(image, whole)));
    points->SetDataType(doubles ? VTK_DOUBLE : VTK_FLOAT);
    normals->SetNumberOfComponents(3);
    radius = ink::isoSurfaceSampleRadius(geometry);
    int component = this->ArrayComponent;
    const vtkSmartPointer<vtkDataArray> array = InkMakeContiguous(scalars, component);
    const ink::ElementMarks hidden = InkGetMarks(image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
    if (!SampleArray(geometry, array, component, hidden, request, this, points->GetData(), normals))
    {
      return 1;
    }
  }
  catch (const std::invalid_argument& error)
  {
    vtkErrorMacro("The image cannot be sampled: " << error.what() << ".");
    return 1;
  }
  this->FillOutput(points, normals, radius, vtkPolyData::GetData(outputVector));
  return 1;
}

void vtkInkIsoSurfaceSampler::FillOutput(
  vtkPoints* points, vtkFloatArray* normals, double radius, vtkPolyData* output)
{
  const vtkIdType count = points->GetNumberOfPoints();
  output->SetPoints(points);
  if (this->ComputeNormals)
  {
    normals->SetName("Normals");
    output->GetPointData()->SetNormals(normals);
  }
  if (this->ComputeRadius)
  {
    // As precise as the points: a radius too small for float comes with points too fine for it.
    vtkSmartPointer<vtkDataArray> radii =
      vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(points->GetDataType()));
    radii->SetName("Radius");
    radii->SetNumberOfTuples(count);
    radii->Fill(radius);
    output->GetPointData()->AddArray(radii);
  }
  if (this->GenerateVertices && count > 0)
  {
    const bool small = count <= std::numeric_limits<vtkTypeInt32>::max();
    output->SetVerts(
      small ? MakePolyVertex<vtkTypeInt32Array>(count) : MakePolyVertex<vtkTypeInt64Array>(count));
  }
}

void vtkInkIsoSurfaceSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CrossingRule: " << (this->CrossingRule == STRICT ? "STRICT" : "HALF_OPEN") << "\n"
     << indent << "ComputeNormals: " << this->ComputeNormals << "\n"
     << indent << "ComputeRadius: " << this->ComputeRadius << "\n"
     << indent << "GenerateVertices: " << this->GenerateVertices << "\n"
     << indent << "ArrayComponent: " << this->ArrayComponent << "\n"
     << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n"
     << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
}
