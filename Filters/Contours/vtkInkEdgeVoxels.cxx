// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkEdgeVoxels.h"

#include "InkAllocate.h"
#include "InkCellCenters.h"
#include "InkImageGrid.h"
#include "InkImageVoxels.h"
#include "InkReportException.h"
#include "InkVTKCompat.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkInkEdgeVoxels);

namespace
{

void MakePoints(const ink::EdgeVoxels& voxels, int type, double radius, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(voxels.samples.size());
  const auto makeArray = [&](const char* name, int components)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    InkSetNumberOfTuples(array, count);
    output->GetPointData()->AddArray(array);
    return array.Get();
  };
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  InkSetNumberOfPoints(points, count);
  output->SetPoints(points);
  vtkFloatArray* gradients = makeArray("Gradient", 3);
  vtkFloatArray* values = makeArray("Value", 1);
  makeArray("Radius", 1)->Fill(radius);
  vtkNew<vtkCellArray> vertices;
  vertices->AllocateExact(count, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto n = static_cast<std::size_t>(i);
    points->SetPoint(i, &voxels.positions[n].x);
    gradients->SetTypedTuple(i, &voxels.gradients[n].x);
    values->SetValue(i, voxels.values[n]);
    vertices->InsertNextCell(1, &i);
  }
  output->SetVerts(vertices);
}

} // namespace

vtkInkEdgeVoxels::vtkInkEdgeVoxels()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkInkEdgeVoxels::~vtkInkEdgeVoxels() = default;

int vtkInkEdgeVoxels::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkInkEdgeVoxels::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  const int levels = output->GetInformationObject(0)->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS());
  vtkInformation* info = input[0]->GetInformationObject(0);
  info->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(),
    levels + InkGetVoxelGhostLevels(this->EdgeScale) + InkPointInput::GetGhostLevels(this, info));
  return 1;
}

int vtkInkEdgeVoxels::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    InkPointInput points;
    vtkInformationVector** pointsVector = points.Take(this, inputVector);
    vtkDataArray* found = this->GetInputArrayToProcess(0, pointsVector, association);
    const InkVoxelInput input =
      InkVoxelInput::Take(this, found, association, pointsVector, outputVector, this->ArrayComponent);
    if (!input.Scalars)
    {
      return 1;
    }
    const ink::EdgeVoxels voxels = InkFindEdgeVoxels(input, this->EdgeScale, this->LeastGradientMagnitude,
      [this](double done)
      {
        this->UpdateProgress(0.9 * done);
        return !InkCheckAbort(this);
      });
    const InkExtent whole = InkGetWholeExtent(pointsVector[0]->GetInformationObject(0), input.Image);
    const bool doubles = InkNeedsDoublePrecision(InkMakeGrid(input.Image, whole));
    MakePoints(voxels, doubles ? VTK_DOUBLE : VTK_FLOAT, InkGetVoxelRadius(input.Image), output);
  }
  catch (...)
  {
    InkReportException(this, output, "The edges of the image cannot be found");
  }
  return 1;
}

void vtkInkEdgeVoxels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
  os << indent << "EdgeScale: " << this->EdgeScale << "\n";
  os << indent << "LeastGradientMagnitude: " << this->LeastGradientMagnitude << "\n";
}
