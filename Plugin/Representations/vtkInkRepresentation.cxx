// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkRepresentation.h"

#include "vtkInkPaper.h"

#include "vtkActor.h"
#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <utility>

namespace
{

/// The field array that points carry whose ids are those of the input.
constexpr const char* IdsAreInputs = "InkIdsAreInputs";

/// Whether there are points on any process, of several. To be called by all of them at once.
bool HasPoints(vtkDataObject* piece)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const vtkIdType own = piece->GetNumberOfElements(vtkDataObject::POINT);
  vtkIdType most = own;
  controller->AllReduce(&own, &most, 1, vtkCommunicator::MAX_OP);
  return most > 0;
}

} // namespace

vtkInkRepresentation::vtkInkRepresentation(vtkSmartPointer<vtkActor> actor, int pieces, int arrays)
  : Actor(std::move(actor))
  , Paper(std::make_unique<vtkInkPaper>())
  , NumberOfArrays(arrays)
{
  for (int array = 0; array < arrays; ++array)
  {
    this->SetInputArrayToProcess(array, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "");
  }
  for (int piece = 0; piece < pieces; ++piece)
  {
    this->Pieces.push_back(vtkSmartPointer<vtkPolyData>::New());
  }
}

vtkInkRepresentation::~vtkInkRepresentation() = default;

int vtkInkRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  // The client and the render server have no input.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

vtkActor* vtkInkRepresentation::GetActor()
{
  return this->Actor;
}

vtkPolyData* vtkInkRepresentation::GetPiece(int piece)
{
  return this->Pieces[static_cast<std::size_t>(piece)];
}

void vtkInkRepresentation::MarkIdsAsInputs()
{
  // Travels with the points to where they are drawn; put together from several processes, they lose it.
  if (vtkMultiProcessController::GetGlobalController()->GetNumberOfProcesses() == 1)
  {
    vtkNew<vtkUnsignedCharArray> mark;
    mark->SetName(IdsAreInputs);
    mark->InsertNextValue(1);
    this->Pieces[0]->GetFieldData()->AddArray(mark);
  }
}

std::string vtkInkRepresentation::GetArrayName(int array)
{
  const char* name = this->GetInputArrayInformation(array)->Get(vtkDataObject::FIELD_NAME());
  return name ? name : "";
}

int vtkInkRepresentation::GetArrayAssociation(int array)
{
  return this->GetInputArrayInformation(array)->Get(vtkDataObject::FIELD_ASSOCIATION());
}

bool vtkInkRepresentation::ServesFor(int)
{
  return false;
}

bool vtkInkRepresentation::ArraysChanged()
{
  std::vector<std::string> chosen;
  bool changed = this->Arrays.empty();
  for (int array = 0; array < this->NumberOfArrays; ++array)
  {
    chosen.push_back(std::to_string(this->GetArrayAssociation(array)) + this->GetArrayName(array));
    changed =
      changed || (chosen.back() != this->Arrays[static_cast<std::size_t>(array)] && !this->ServesFor(array));
  }
  if (changed)
  {
    this->Arrays = chosen;
  }
  return changed;
}

int vtkInkRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE() && this->ArraysChanged())
  {
    this->MarkModified();
  }
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->Deliver(inInfo, outInfo);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    std::vector<vtkPolyData*> delivered;
    for (int piece = 0; piece < static_cast<int>(this->Pieces.size()); ++piece)
    {
      delivered.push_back(vtkPolyData::SafeDownCast(vtkPVView::GetDeliveredPiece(inInfo, this, piece)));
    }
    this->Show(delivered);
    this->PointIdsAreInputs = delivered[0] && delivered[0]->GetFieldData()->HasArray(IdsAreInputs);
    this->UpdatePickable();
    this->Actor->SetVisibility(this->DrawsOnThisProcess());
  }
  return 1;
}

void vtkInkRepresentation::Deliver(vtkInformation* inInfo, vtkInformation* outInfo)
{
  auto view = vtkPVRenderView::SafeDownCast(this->GetView());
  auto manager = vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  for (int piece = 0; piece < static_cast<int>(this->Pieces.size()); ++piece)
  {
    vtkPVView::SetPiece(inInfo, this, this->GetPiece(piece), 0, piece);
    for (const bool coarse : { false, true })
    {
      manager->SetDeliverToAllProcesses(this, true, coarse, piece);
    }
  }
  vtkPVRenderView::SetOrderedCompositingConfiguration(
    inInfo, this, vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
  const bool blended = this->Actor->HasTranslucentPolygonalGeometry() ||
    this->Actor->GetMapper()->HasTranslucentPolygonalGeometry();
  // ParaView's processes abort where they have to put nothing into an order.
  const bool ordered = HasPoints(vtkPVView::GetPiece(inInfo, this)) && blended;
  outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), ordered ? 1 : 0);
  // What the view holds for the current time; the first piece may be of another while it plays from its
  // cache.
  double bounds[6];
  vtkPolyData::SafeDownCast(vtkPVView::GetPiece(inInfo, this))->GetBounds(bounds);
  vtkNew<vtkMatrix4x4> matrix;
  this->Actor->GetMatrix(matrix);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, matrix);
}

bool vtkInkRepresentation::DrawsOnThisProcess()
{
  auto view = vtkPVRenderView::SafeDownCast(this->GetView());
  return !view->GetUseOrderedCompositing() ||
    vtkMultiProcessController::GetGlobalController()->GetLocalProcessId() == 0;
}

vtkDataObject* vtkInkRepresentation::GetRenderedDataObject(int)
{
  return this->Pieces[0];
}

bool vtkInkRepresentation::AddToView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Actor);
  this->Paper->Attach(renderView->GetRenderer());
  renderView->RegisterPropForHardwareSelection(this, this->Actor);
  return this->Superclass::AddToView(view);
}

bool vtkInkRepresentation::RemoveFromView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->RemoveActor(this->Actor);
  this->Paper->Detach();
  renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  return this->Superclass::RemoveFromView(view);
}

void vtkInkRepresentation::SetVisibility(bool visible)
{
  this->Actor->SetVisibility(visible);
  this->Paper->SetVisible(visible);
  this->Superclass::SetVisibility(visible);
}

void vtkInkRepresentation::SetPaper(bool paper)
{
  this->Paper->SetFills(paper);
}

void vtkInkRepresentation::SetPaperColor(double red, double green, double blue)
{
  this->Paper->SetColor(red, green, blue);
}

void vtkInkRepresentation::SetPickable(bool pickable)
{
  this->Pickable = pickable;
  this->UpdatePickable();
}

void vtkInkRepresentation::UpdatePickable()
{
  this->Actor->SetPickable(this->Pickable && this->PointIdsAreInputs);
}

void vtkInkRepresentation::SetOpacity(double opacity)
{
  this->Actor->GetProperty()->SetOpacity(opacity);
}

void vtkInkRepresentation::SetPosition(double x, double y, double z)
{
  this->Actor->SetPosition(x, y, z);
}

void vtkInkRepresentation::SetScale(double x, double y, double z)
{
  this->Actor->SetScale(x, y, z);
}

void vtkInkRepresentation::SetOrientation(double x, double y, double z)
{
  this->Actor->SetOrientation(x, y, z);
}

void vtkInkRepresentation::SetOrigin(double x, double y, double z)
{
  this->Actor->SetOrigin(x, y, z);
}

void vtkInkRepresentation::SetUserTransform(const double matrix[16])
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  this->Actor->SetUserTransform(transform);
}

void vtkInkRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Points drawn: " << this->Pieces[0]->GetNumberOfPoints() << "\n";
  os << indent << "Paper: " << this->Paper->GetFills() << "\n";
  os << indent << "Pickable: " << this->Pickable << "\n";
  os << indent << "Mapper:\n";
  this->Actor->GetMapper()->PrintSelf(os, indent.GetNextIndent());
}
