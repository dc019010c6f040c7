// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSplattingLinesRepresentation.h"

#include "InkDiscStipples.h"
#include "InkHasPolygons.h"
#include "InkIsoSurface.h"
#include "InkLeaves.h"
#include "InkPointOutput.h"
#include "InkSilhouettes.h"
#include "InkSourcePoints.h"
#include "vtkInkAddNormals.h"
#include "vtkInkGatherPoints.h"
#include "vtkInkIsDense.h"
#include "vtkInkProcesses.h"
#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkSplattingLinesStyle.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPVView.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkInkSplattingLinesRepresentation);

namespace
{

/// The input itself, or the outer surfaces where there are grids, whose points have no normals.
/// @param meshes of the leaves
vtkSmartPointer<vtkDataObject> SurfacesOf(
  vtkDataObject* input, const InkLeaves& leaves, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes)
{
  if (std::all_of(leaves.Others.begin(), leaves.Others.end(),
        [](vtkDataSet* data) { return vtkPolyData::SafeDownCast(data) || data->GetNumberOfCells() == 0; }))
  {
    return input;
  }
  if (!leaves.Composite)
  {
    return meshes.front();
  }
  auto surfaces = vtkSmartPointer<vtkPartitionedDataSet>::New();
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    surfaces->SetPartition(static_cast<unsigned int>(i), meshes[i]);
  }
  return surfaces;
}

} // namespace

vtkInkSplattingLinesRepresentation::vtkInkSplattingLinesRepresentation()
  : vtkInkSplattingLinesRepresentation(vtkSmartPointer<vtkInkSplattingLinesStyle>::New())
{
}

vtkInkSplattingLinesRepresentation::vtkInkSplattingLinesRepresentation(
  vtkSmartPointer<vtkInkSplattingLinesStyle> style)
  : vtkInkRepresentation(style)
  , Style(style)
{
}

vtkInkSplattingLinesRepresentation::~vtkInkSplattingLinesRepresentation() = default;

std::vector<double> vtkInkSplattingLinesRepresentation::GetUsedIsoValues()
{
  return vtkInkSplattingLinesStyle::SafeDownCast(this->GetStyle())->GetIsoSurface()->GetUsedIsoValues();
}

std::string vtkInkSplattingLinesRepresentation::MakeMarks(const vtkInkStyle::Input& input)
{
  const InkLeaves leaves(input.Data);
  const std::vector<vtkSmartPointer<vtkPolyData>> meshes = leaves.MakeMeshes();
  if (this->TakesOwnPoints(leaves, meshes))
  {
    return this->TakePoints(input.Data, leaves, meshes);
  }
  this->Style->SetColorArray(
    { this->GetColorArray(), this->GetColorAssociation() == vtkDataObject::FIELD_ASSOCIATION_CELLS });
  std::string problem = this->Superclass::MakeMarks(input);
  if (vtkPolyData::SafeDownCast(input.Data) && InkGetSourcePoints(this->GetPiece(0)))
  {
    this->MarkIdsAsInputs();
  }
  return problem;
}

bool vtkInkSplattingLinesRepresentation::TakesOwnPoints(
  const InkLeaves& leaves, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes)
{
  const auto any = [&](const auto& is) { return std::any_of(meshes.begin(), meshes.end(), is) ? 1.0 : 0.0; };
  std::array found{ leaves.Images.empty() ? 0.0 : 1.0, any(InkHasPolygons),
    any([](vtkPolyData* mesh) { return !InkHasPolygons(mesh) && !InkHasDiscs(mesh); }) };
  vtkInkProcesses processes;
  processes.TakeGreatest(found);
  const auto [images, polygons, bare] = found;
  if (images > 0.0 || bare > 0.0)
  {
    return false;
  }
  const vtkIdType samples = this->Style->GetNumberOfSamples();
  return polygons == 0.0 || samples == 0 || (samples < 0 && vtkInkIsDense(meshes, processes));
}

std::string vtkInkSplattingLinesRepresentation::TakePoints(
  vtkDataObject* input, const InkLeaves& leaves, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes)
{
  vtkPolyData* outlined = this->GetPiece(vtkInkSplattingLinesStyle::SILHOUETTES);
  outlined->Initialize();
  std::string problem;
  InkSilhouettes* silhouettes = this->Style->GetSilhouettes();
  if (silhouettes->GetSilhouettes() || silhouettes->GetSharpEdges())
  {
    const vtkSmartPointer<vtkPolyData> whole = vtkInkProcesses().Gather(meshes);
    problem = InkHasPolygons(whole) ? silhouettes->MakeOfMesh(this->Style, whole, outlined) : "";
  }
  const vtkSmartPointer<vtkDataObject> surfaces = SurfacesOf(input, leaves, meshes);
  vtkSmartPointer<vtkDataObject> data;
  try
  {
    data = vtkInkAddNormals(surfaces);
  }
  catch (const std::invalid_argument& error)
  {
    this->GetPiece(0)->Initialize();
    return std::string("The mesh cannot be drawn: ") + error.what();
  }
  const vtkInkGatheredPoints gathered =
    vtkInkGatherPoints(data, this->GetColorArray(), this->GetColorAssociation());
  this->GetPiece(0)->ShallowCopy(gathered.Points);
  // Points that are repeated at edges are none of the input's.
  const auto count = [](vtkDataObject* object)
  { return object ? object->GetNumberOfElements(vtkDataObject::POINT) : 0; };
  if (gathered.IdsAreInputs && surfaces == input && count(data) == count(input))
  {
    this->MarkIdsAsInputs();
  }
  return gathered.Problem.empty() ? problem : "Splatting Lines draws nothing for " + gathered.Problem;
}

void vtkInkSplattingLinesRepresentation::Show(const std::vector<vtkPolyData*>& delivered)
{
  vtkPolyData* points = delivered[vtkInkSplattingLinesStyle::POINTS];
  if (points && this->DrawnTime != points->GetMTime())
  {
    this->Drawn->ShallowCopy(points);
    // Exporters write cells, which the mapper ignores.
    this->Drawn->SetVerts(InkMakePolyVertex(points->GetNumberOfPoints()));
    this->DrawnTime = points->GetMTime();
  }
  this->Superclass::Show(
    { points ? this->Drawn.Get() : nullptr, delivered[vtkInkSplattingLinesStyle::SILHOUETTES] });
}

int vtkInkSplattingLinesRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  // Ambient occlusion is worked out of what the opaque pass draws, the surfaces' normals and positions: lines
  // are none of it, and come after it.
  auto view = vtkPVRenderView::SafeDownCast(this->GetView());
  this->Style->GetActor()->SetForceTranslucent(view && view->GetUseSSAO());
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_RENDER())
  {
    vtkInkSplattingLinesMapper* mapper = this->Style->GetLinesMapper();
    vtkPolyData* points = mapper->GetInput();
    const double count = points ? static_cast<double>(points->GetNumberOfPoints()) : 0.0;
    const bool fewer = inInfo->Has(vtkPVRenderView::USE_LOD()) && this->PointsWhileMoving > 0;
    mapper->SetPointFraction(fewer ? this->PointsWhileMoving / std::max(count, 1.0) : 1.0);
  }
  return 1;
}

void vtkInkSplattingLinesRepresentation::SetPointsWhileMoving(int points)
{
  this->PointsWhileMoving = points;
}
