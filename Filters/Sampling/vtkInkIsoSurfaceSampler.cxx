// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIsoSurfaceSampler.h"

#include "InkVTKCompat.h"
#include "Sampling/CrossedCells.h"
#include "Sampling/IsoSurfaceSamples.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExtentTranslator.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
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

/// The box of an extent as VTK writes it.
struct Box
{
  glm::ivec3 First;
  glm::ivec3 Last;

  explicit Box(const int extent[6])
    : First(extent[0], extent[2], extent[4])
    , Last(extent[1], extent[3], extent[5])
  {
  }

  glm::ivec3 Samples() const { return glm::max(this->Last - this->First + 1, glm::ivec3(0)); }
  bool operator==(const Box& other) const { return this->First == other.First && this->Last == other.Last; }
};

ink::GridGeometry MakeGeometry(vtkImageData* image, const Box& box)
{
  glm::dvec3 origin;
  glm::dvec3 spacing;
  image->GetOrigin(&origin[0]);
  image->GetSpacing(&spacing[0]);
  glm::dmat3 direction;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      direction[column][row] = image->GetDirectionMatrix()->GetElement(row, column);
    }
  }
  return ink::GridGeometry(box.Samples(), origin, spacing, direction, box.First);
}

/// Whether points on the grid, rounded to float, move by more than a thousandth of the smallest spacing.
bool NeedsDouble(const ink::GridGeometry& whole)
{
  glm::dvec3 farthest(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 last = whole.dimensions() - 1;
    farthest = glm::max(
      farthest, glm::abs(whole.toWorld(last * glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1))));
  }
  const double largest = std::max({ farthest.x, farthest.y, farthest.z });
  const glm::dvec3 spacing = glm::abs(whole.spacing());
  const double smallest = std::min({ spacing.x, spacing.y, spacing.z });
  const double rounding = std::max<double>(
    0.5 * std::numeric_limits<float>::epsilon() * largest, std::numeric_limits<float>::denorm_min());
  return rounding > 1e-3 * smallest || largest > std::numeric_limits<float>::max();
}

/// The image's ghost array as marks with the given bits; no marks where there is no such array.
ink::ElementMarks GetMarks(vtkDataSetAttributes* attributes, unsigned char bits)
{
  auto* array =
    vtkUnsignedCharArray::SafeDownCast(attributes->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
  if (!array)
  {
    return {};
  }
  return { { array->GetPointer(0), static_cast<std::size_t>(array->GetNumberOfValues()) }, bits };
}

/// The array itself where its components lie side by side in memory, otherwise a copy of the given component;
/// `component` becomes the one to read.
vtkSmartPointer<vtkDataArray> MakeContiguous(vtkDataArray* array, int& component)
{
  const bool bits = array->GetDataType() == VTK_BIT;
  if (array->HasStandardMemoryLayout() && !bits)
  {
    return array;
  }
  vtkSmartPointer<vtkDataArray> copy =
    vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(bits ? VTK_UNSIGNED_CHAR : array->GetDataType()));
  copy->SetNumberOfTuples(array->GetNumberOfTuples());
  copy->CopyComponent(0, array, component);
  component = 0;
  return copy;
}

/// The cells that no other piece samples.
ink::CellSelection SelectCells(vtkInformation* info, vtkAlgorithm* producer, vtkImageData* image)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  const Box box(image->GetExtent());
  ink::CellSelection cells;
  cells.skipped = GetMarks(image->GetCellData(),
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL |
      vtkDataSetAttributes::REFINEDCELL);
  // Sources split the image themselves and mark ghosts; a trivial producer answers every piece with all it
  // has.
  const int pieces = info->Get(SDDP::UPDATE_NUMBER_OF_PIECES());
  const bool wholeForEveryPiece = vtkTrivialProducer::SafeDownCast(producer) &&
    producer->GetOutputDataObject(0) == image && Box(info->Get(SDDP::WHOLE_EXTENT())) == box;
  if (pieces > 1 && wholeForEveryPiece && cells.skipped.empty())
  {
    vtkNew<vtkExtentTranslator> translator;
    int extent[6] = { 0, -1, 0, -1, 0, -1 };
    translator->PieceToExtentThreadSafe(info->Get(SDDP::UPDATE_PIECE_NUMBER()), pieces, 0, image->GetExtent(),
      extent, vtkExtentTranslator::BLOCK_MODE, 0);
    const Box piece(extent);
    cells.begin = piece.First - box.First;
    cells.end = piece.Last - box.First;
  }
  return cells;
}

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
    if (!ink::placeIsoSurfaceSamples(field, request.IsoValues[i], request.Rule, crossed[i],
          std::span<Real>(point, size), std::span<float>(normal, normalSize), progress.NextStep()))
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
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, input, association);
  if (!scalars)
  {
    const char* name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
    vtkErrorMacro("The image has no point array " << (name ? name : "of scalars") << "; it has "
                                                  << image->GetPointData()->GetNumberOfArrays()
                                                  << " point arrays. Expected a numeric one.");
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
  const Box whole(info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  const glm::ivec3 samples = whole.Samples();
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
  request.Cells = SelectCells(info, this->GetInputAlgorithm(), image);
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
    const ink::GridGeometry geometry = MakeGeometry(image, Box(image->GetExtent()));
    const bool doubles = this->OutputPointsPrecision == DOUBLE_PRECISION ||
      (this->OutputPointsPrecision == DEFAULT_PRECISION && NeedsDouble(MakeGeometry(image, whole)));
    points->SetDataType(doubles ? VTK_DOUBLE : VTK_FLOAT);
    normals->SetNumberOfComponents(3);
    radius = ink::isoSurfaceSampleRadius(geometry);
    int component = this->ArrayComponent;
    const vtkSmartPointer<vtkDataArray> array = MakeContiguous(scalars, component);
    const ink::ElementMarks hidden = GetMarks(image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
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
