// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSplattingLinesRepresentation.h"

#include "vtkInkGatherPoints.h"
#include "vtkInkSplattingLinesMapper.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

vtkStandardNewMacro(vtkInkSplattingLinesRepresentation);

namespace
{

/// The field array that points carry whose ids are those of the input.
constexpr const char* IdsAreInputs = "InkIdsAreInputs";

} // namespace

vtkInkSplattingLinesRepresentation::vtkInkSplattingLinesRepresentation()
{
  this->Actor->SetMapper(this->Mapper);
}

vtkInkSplattingLinesRepresentation::~vtkInkSplattingLinesRepresentation() = default;

int vtkInkSplattingLinesRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  // The client and the render server have no input.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkInkSplattingLinesRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkInkGatheredPoints gathered = vtkInkGatherPoints(vtkDataObject::GetData(inputVector[0], 0));
  this->Points->ShallowCopy(gathered.Points);
  // Travels with the points to where they are drawn; put together from several processes, they lose it.
  if (gathered.IdsAreInputs && vtkMultiProcessController::GetGlobalController()->GetNumberOfProcesses() == 1)
  {
    vtkNew<vtkUnsignedCharArray> mark;
    mark->SetName(IdsAreInputs);
    mark->InsertNextValue(1);
    this->Points->GetFieldData()->AddArray(mark);
  }
  if (!gathered.Problem.empty())
  {
    vtkWarningMacro(<< "Splatting Lines draws nothing for " << gathered.Problem);
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

int vtkInkSplattingLinesRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(inInfo, this, this->Points);
    vtkPVRenderView::SetDeliverToAllProcesses(inInfo, this, true);
    vtkPVRenderView::SetOrderedCompositingConfiguration(
      inInfo, this, vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
    outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), this->Actor->HasTranslucentPolygonalGeometry());
    // What the view holds for the current time; this->Points may be of another while it plays from its cache.
    double bounds[6];
    vtkPolyData::SafeDownCast(vtkPVView::GetPiece(inInfo, this))->GetBounds(bounds);
    vtkNew<vtkMatrix4x4> matrix;
    this->Actor->GetMatrix(matrix);
    vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, matrix);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    vtkDataObject* delivered = vtkPVView::GetDeliveredPiece(inInfo, this);
    this->Mapper->SetInputDataObject(delivered);
    this->PointIdsAreInputs = delivered && delivered->GetFieldData()->HasArray(IdsAreInputs);
    this->UpdatePickable();
    this->Actor->SetVisibility(this->DrawsOnThisProcess());
  }
  return 1;
}

bool vtkInkSplattingLinesRepresentation::DrawsOnThisProcess()
{
  auto view = vtkPVRenderView::SafeDownCast(this->GetView());
  return !view->GetUseOrderedCompositing() ||
    vtkMultiProcessController::GetGlobalController()->GetLocalProcessId() == 0;
}

vtkDataObject* vtkInkSplattingLinesRepresentation::GetRenderedDataObject(int)
{
  return this->Points;
}

bool vtkInkSplattingLinesRepresentation::AddToView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Actor);
  renderView->RegisterPropForHardwareSelection(this, this->Actor);
  return this->Superclass::AddToView(view);
}

bool vtkInkSplattingLinesRepresentation::RemoveFromView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->RemoveActor(this->Actor);
  renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  return this->Superclass::RemoveFromView(view);
}

void vtkInkSplattingLinesRepresentation::SetVisibility(bool visible)
{
  this->Actor->SetVisibility(visible);
  this->Superclass::SetVisibility(visible);
}

void vtkInkSplattingLinesRepresentation::SetPickable(bool pickable)
{
  this->Pickable = pickable;
  this->UpdatePickable();
}

void vtkInkSplattingLinesRepresentation::UpdatePickable()
{
  this->Actor->SetPickable(this->Pickable && this->PointIdsAreInputs);
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
}

void vtkInkSplattingLinesRepresentation::SetPaperColor(double red, double green, double blue)
{
  this->Mapper->SetPaperColor(red, green, blue);
}

void vtkInkSplattingLinesRepresentation::SetPaperVisibility(bool visible)
{
  this->Mapper->SetPaperVisibility(visible);
}

void vtkInkSplattingLinesRepresentation::SetOpacity(double opacity)
{
  this->Actor->GetProperty()->SetOpacity(opacity);
}

void vtkInkSplattingLinesRepresentation::SetPosition(double x, double y, double z)
{
  this->Actor->SetPosition(x, y, z);
}

void vtkInkSplattingLinesRepresentation::SetScale(double x, double y, double z)
{
  this->Actor->SetScale(x, y, z);
}

void vtkInkSplattingLinesRepresentation::SetOrientation(double x, double y, double z)
{
  this->Actor->SetOrientation(x, y, z);
}

void vtkInkSplattingLinesRepresentation::SetOrigin(double x, double y, double z)
{
  this->Actor->SetOrigin(x, y, z);
}

void vtkInkSplattingLinesRepresentation::SetUserTransform(const double matrix[16])
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  this->Actor->SetUserTransform(transform);
}

void vtkInkSplattingLinesRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Points drawn: " << this->Points->GetNumberOfPoints() << "\n";
  os << indent << "Pickable: " << this->Pickable << "\n";
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
