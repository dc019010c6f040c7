// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSplattingLinesRepresentation.h"

#include "vtkInkAddNormals.h"
#include "vtkInkGatherPoints.h"
#include "vtkInkSplattingLinesMapper.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPVView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkInkSplattingLinesRepresentation);

namespace
{

/// One cell of all points: exporters write cells, which the mapper ignores.
vtkSmartPointer<vtkCellArray> MakeVertex(vtkIdType count)
{
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  if (count > 0 && count <= std::numeric_limits<int>::max())
  {
    vertices->Use32BitStorage();
    vertices->AllocateExact(1, count);
    vertices->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      vertices->InsertCellPoint(i);
    }
  }
  return vertices;
}

} // namespace

vtkInkSplattingLinesRepresentation::vtkInkSplattingLinesRepresentation()
  : vtkInkRepresentation(vtkSmartPointer<vtkActor>::New(), 1, 1)
{
  this->GetActor()->SetMapper(this->Mapper);
  this->Mapper->UseLookupTableScalarRangeOn();
  this->SetMapScalars(true);
}

vtkInkSplattingLinesRepresentation::~vtkInkSplattingLinesRepresentation() = default;

int vtkInkSplattingLinesRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkSmartPointer<vtkDataObject> input = vtkInkAddNormals(vtkDataObject::GetData(inputVector[0], 0));
  const vtkInkGatheredPoints gathered =
    vtkInkGatherPoints(input, this->GetArrayName(0), this->GetArrayAssociation(0));
  this->GetPiece(0)->ShallowCopy(gathered.Points);
  if (gathered.IdsAreInputs)
  {
    this->MarkIdsAsInputs();
  }
  if (!gathered.Problem.empty())
  {
    vtkWarningMacro(<< "Splatting Lines draws nothing for " << gathered.Problem);
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

void vtkInkSplattingLinesRepresentation::Show(const std::vector<vtkPolyData*>& delivered)
{
  vtkPolyData* points = delivered[0];
  if (points && this->DrawnTime != points->GetMTime())
  {
    this->Drawn->ShallowCopy(points);
    this->Drawn->SetVerts(MakeVertex(points->GetNumberOfPoints()));
    this->DrawnTime = points->GetMTime();
  }
  this->Mapper->SetInputDataObject(points ? this->Drawn.Get() : nullptr);
  this->UpdateColors();
}

int vtkInkSplattingLinesRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  // Ambient occlusion is worked out of what the opaque pass draws, the surfaces' normals and positions: lines
  // are none of it, and come after it.
  auto view = vtkPVRenderView::SafeDownCast(this->GetView());
  this->GetActor()->SetForceTranslucent(view && view->GetUseSSAO());
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_RENDER())
  {
    vtkPolyData* points = this->Mapper->GetInput();
    const double count = points ? static_cast<double>(points->GetNumberOfPoints()) : 0.0;
    const bool fewer = inInfo->Has(vtkPVRenderView::USE_LOD()) && this->PointsWhileMoving > 0;
    this->Mapper->SetPointFraction(fewer ? this->PointsWhileMoving / std::max(count, 1.0) : 1.0);
  }
  return 1;
}

void vtkInkSplattingLinesRepresentation::UpdateColors()
{
  vtkPolyData* points = this->Mapper->GetInput();
  const bool byArray = points && points->GetPointData()->GetScalars() && !this->GetArrayName(0).empty();
  this->Mapper->SetScalarVisibility(byArray);
  const int otherwise =
    this->ColorByTone ? vtkInkSplattingLinesMapper::TONE : vtkInkSplattingLinesMapper::INK;
  this->Mapper->SetInkColorMode(byArray ? vtkInkSplattingLinesMapper::SCALARS : otherwise);
  for (int layer = 1; layer < this->Mapper->GetNumberOfLayersMaxValue(); ++layer)
  {
    if (this->UseHiddenColor)
    {
      this->Mapper->SetLayerColor(layer, this->HiddenColor);
    }
    else
    {
      this->Mapper->ResetLayerColor(layer);
    }
  }
}

void vtkInkSplattingLinesRepresentation::SetLambda(double lambda)
{
  this->Mapper->SetLambda(lambda);
}

void vtkInkSplattingLinesRepresentation::SetTau(double tau)
{
  this->Mapper->SetTau(tau);
}

void vtkInkSplattingLinesRepresentation::SetPhi(double phi)
{
  this->Mapper->SetPhi(phi);
}

void vtkInkSplattingLinesRepresentation::SetSigma(double sigma)
{
  this->Mapper->SetSigma(sigma);
}

void vtkInkSplattingLinesRepresentation::SetAsPublished(bool asPublished)
{
  this->Mapper->SetAsPublished(asPublished);
}

void vtkInkSplattingLinesRepresentation::SetRadius(double radius)
{
  this->Mapper->SetRadius(radius);
}

void vtkInkSplattingLinesRepresentation::SetInkColor(double red, double green, double blue)
{
  this->Mapper->SetInkColor(red, green, blue);
  this->UpdateColors();
}

void vtkInkSplattingLinesRepresentation::SetPaperColor(double red, double green, double blue)
{
  this->Mapper->SetPaperColor(red, green, blue);
  this->Superclass::SetPaperColor(red, green, blue);
}

void vtkInkSplattingLinesRepresentation::SetPaperVisibility(bool visible)
{
  this->Mapper->SetPaperVisibility(visible);
}

void vtkInkSplattingLinesRepresentation::SetMinimumRadius(double radius)
{
  this->Mapper->SetMinimumRadius(radius);
}

void vtkInkSplattingLinesRepresentation::SetHardness(double hardness)
{
  this->Mapper->SetHardness(hardness);
}

void vtkInkSplattingLinesRepresentation::SetSpeckleLength(double length)
{
  this->Mapper->SetSpeckleLength(length);
}

void vtkInkSplattingLinesRepresentation::SetThinning(bool thinning)
{
  this->Mapper->SetThinning(thinning);
}

void vtkInkSplattingLinesRepresentation::SetCoarsestTexel(int pixels)
{
  this->Mapper->SetCoarsestTexel(pixels);
}

void vtkInkSplattingLinesRepresentation::SetHalfFloats(bool halfFloats)
{
  this->Mapper->SetHalfFloats(halfFloats);
}

void vtkInkSplattingLinesRepresentation::SetHiddenLayers(bool hiddenLayers)
{
  this->Mapper->SetHiddenLayers(hiddenLayers);
}

void vtkInkSplattingLinesRepresentation::SetNumberOfLayers(int layers)
{
  this->Mapper->SetNumberOfLayers(layers);
}

void vtkInkSplattingLinesRepresentation::SetPeelBackFaces(bool peel)
{
  this->Mapper->SetPeelBackFaces(peel);
}

void vtkInkSplattingLinesRepresentation::SetLineWidth(double width)
{
  this->Mapper->SetLayerLineWidth(0, width);
}

void vtkInkSplattingLinesRepresentation::SetToneColor(double red, double green, double blue)
{
  this->Mapper->SetToneColor(red, green, blue);
}

void vtkInkSplattingLinesRepresentation::SetColorByTone(bool byTone)
{
  this->ColorByTone = byTone;
  this->UpdateColors();
}

void vtkInkSplattingLinesRepresentation::SetHiddenStrength(double strength)
{
  for (int layer = 1; layer < this->Mapper->GetNumberOfLayersMaxValue(); ++layer)
  {
    this->Mapper->SetLayerStrength(layer, strength);
    strength *= 2.0 / 3.0;
  }
}

void vtkInkSplattingLinesRepresentation::SetUseHiddenColor(bool use)
{
  this->UseHiddenColor = use;
  this->UpdateColors();
}

void vtkInkSplattingLinesRepresentation::SetHiddenColor(double red, double green, double blue)
{
  this->HiddenColor[0] = red;
  this->HiddenColor[1] = green;
  this->HiddenColor[2] = blue;
  this->UpdateColors();
}

void vtkInkSplattingLinesRepresentation::SetHiddenLineWidth(double width)
{
  for (int layer = 1; layer < this->Mapper->GetNumberOfLayersMaxValue(); ++layer)
  {
    this->Mapper->SetLayerLineWidth(layer, width);
  }
}

void vtkInkSplattingLinesRepresentation::SetHiddenDashLength(double length)
{
  for (int layer = 1; layer < this->Mapper->GetNumberOfLayersMaxValue(); ++layer)
  {
    this->Mapper->SetLayerDashLength(layer, length);
  }
}

void vtkInkSplattingLinesRepresentation::SetCullBackFaces(bool cull)
{
  this->GetActor()->GetProperty()->SetBackfaceCulling(cull);
}

void vtkInkSplattingLinesRepresentation::SetPointsWhileMoving(int points)
{
  this->PointsWhileMoving = points;
}

void vtkInkSplattingLinesRepresentation::SetLookupTable(vtkScalarsToColors* table)
{
  this->Mapper->SetLookupTable(table);
}

void vtkInkSplattingLinesRepresentation::SetMapScalars(bool map)
{
  // How scalars become colors, which is not what colors the lines.
  this->Mapper->SetColorMode(map ? VTK_COLOR_MODE_MAP_SCALARS : VTK_COLOR_MODE_DIRECT_SCALARS);
}
