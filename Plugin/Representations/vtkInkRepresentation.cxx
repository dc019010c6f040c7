// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkRepresentation.h"

#include "InkParameter.h"
#include "vtkInkCoarseImage.h"
#include "vtkInkPaper.h"
#include "vtkInkProcesses.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <utility>

namespace
{

/// The field array that points carry whose ids are those of the input.
constexpr const char* IdsAreInputs = "InkIdsAreInputs";

/// Surfaces of so many voxels are made and drawn in less than a second.
constexpr vtkIdType MostPointsOfPreview = 6000000;

/// Whether there are points on any process, of several. To be called by all of them at once.
bool HasPoints(vtkDataObject* piece)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const vtkIdType own = piece->GetNumberOfElements(vtkDataObject::POINT);
  vtkIdType most = own;
  controller->AllReduce(&own, &most, 1, vtkCommunicator::MAX_OP);
  return most > 0;
}

/// While marks are made of a coarse image: those of a smaller picture, of cells that are not subdivided, and
/// as smooth in the world as of all points.
class CoarseSettings
{
public:
  CoarseSettings(vtkInkStyle* style, vtkImageData* image, vtkImageData* coarse)
    : Style(style)
    , PictureSize(style->GetPictureSize())
  {
    const double fewer = std::cbrt(
      static_cast<double>(coarse->GetNumberOfPoints()) / static_cast<double>(image->GetNumberOfPoints()));
    style->SetPictureSize(std::min(fewer, 0.5) * this->PictureSize);
    this->Change("Subdivision", [](double) { return 1.0; });
    this->Change("Smoothing", [=](double voxels) { return voxels > 0.0 ? fewer * voxels : voxels; });
  }
  ~CoarseSettings()
  {
    this->Style->SetPictureSize(this->PictureSize);
    for (const auto& [name, value] : this->Before)
    {
      this->Style->SetParameter(name, value);
    }
  }
  CoarseSettings(const CoarseSettings&) = delete;
  CoarseSettings& operator=(const CoarseSettings&) = delete;

private:
  template <class Coarser>
  void Change(const char* name, const Coarser& coarser)
  {
    if (this->Style->GetParameterTable().Find(name))
    {
      const double value = this->Style->GetParameter(name);
      this->Before.emplace_back(name, value);
      this->Style->SetParameter(name, coarser(value));
    }
  }

  vtkInkStyle* const Style;
  const double PictureSize;
  std::vector<std::pair<const char*, double>> Before;
};

} // namespace

vtkInkRepresentation::vtkInkRepresentation(vtkSmartPointer<vtkInkStyle> style)
  : Style(std::move(style))
  , Paper(std::make_unique<vtkInkPaper>())
{
  // Parameters of the mapper change while the marks stay.
  this->Style->InteractiveOn();
  this->Style->SetProcesses(std::make_shared<vtkInkProcesses>());
  this->Style->AddObserver(vtkCommand::ProgressEvent, this, &vtkInkRepresentation::ReportProgress);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "");
  for (int piece = 0; piece < this->Style->GetNumberOfPieces(); ++piece)
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

int vtkInkRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkNew<vtkInformation> part;
  vtkInkStyle::Input input{ vtkDataObject::GetData(inputVector[0], 0), nullptr, part };
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    input.Port = this->GetInputConnection(0, 0);
    vtkInformation* info = inputVector[0]->GetInformationObject(0);
    part->CopyEntry(info, SDDP::UPDATE_PIECE_NUMBER());
    part->CopyEntry(info, SDDP::UPDATE_NUMBER_OF_PIECES());
    if (info->Has(SDDP::UPDATE_TIME_STEP()))
    {
      part->Set(SDDP::UPDATE_TIME_STEP(), info->Get(SDDP::UPDATE_TIME_STEP()));
    }
  }
  std::optional<CoarseSettings> settings;
  if (auto* image = this->Preview ? vtkImageData::SafeDownCast(input.Data) : nullptr;
      image && vtkInkProcesses().GetNumber() == 1)
  {
    try
    {
      this->TakeCoarse(input, image);
      settings.emplace(this->Style, image, vtkImageData::SafeDownCast(input.Data));
    }
    catch (const std::bad_alloc&)
    {
      this->Coarse = nullptr; // all of the image is drawn, or the style says why not
    }
  }
  // An earlier run may have been stopped.
  this->SetAbortExecute(0);
  this->MadeColors = { this->GetColorArray(), this->GetColorAssociation() };
  const std::string problem = this->MakeMarks(input);
  // A server's client has no input.
  if (input.Port && !problem.empty())
  {
    vtkWarningMacro(<< problem << '.');
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

bool vtkInkRepresentation::BlendsMarks()
{
  return this->Style->GetActor()->HasTranslucentPolygonalGeometry() ||
    this->Style->GetMapper()->HasTranslucentPolygonalGeometry();
}

std::string vtkInkRepresentation::MakeMarks(const vtkInkStyle::Input& input)
{
  std::string problem = this->Style->MakeMarks(input);
  ++this->TimesMade;
  for (int piece = 0; piece < this->Style->GetNumberOfPieces(); ++piece)
  {
    this->GetPiece(piece)->ShallowCopy(this->Style->GetPiece(piece));
  }
  return problem;
}

void vtkInkRepresentation::ReportProgress()
{
  this->UpdateProgress(this->Style->GetProgress());
  if (this->GetAbortExecute())
  {
    this->Style->AbortMake();
  }
}

void vtkInkRepresentation::Show(const std::vector<vtkPolyData*>& delivered)
{
  this->Style->ShowPieces(delivered);
  vtkMapper* mapper = this->Style->GetMapper();
  int ofCells = 0;
  vtkPolyData* marks = delivered[static_cast<std::size_t>(this->Style->GetColoredPiece())];
  const bool colored = marks && !this->GetColorArray().empty() &&
    vtkAbstractMapper::GetScalars(marks, mapper->GetScalarMode(), 0, 0, nullptr, ofCells);
  this->Style->SetColorByScalars(colored);
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

std::string vtkInkRepresentation::GetColorArray()
{
  const char* name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  return name ? name : "";
}

int vtkInkRepresentation::GetColorAssociation()
{
  return this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_ASSOCIATION());
}

bool vtkInkRepresentation::ServesFor(const std::string&, int)
{
  return false;
}

bool vtkInkRepresentation::LacksColors()
{
  const std::string name = this->GetColorArray();
  const int association = this->GetColorAssociation();
  // What was asked for when marks were made is not asked for again, whether the data has it or not.
  return !name.empty() && this->MadeColors != std::pair(name, association) &&
    !this->ServesFor(name, association);
}

int vtkInkRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE() && this->LacksColors())
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
    this->Style->GetActor()->SetVisibility(this->DrawsOnThisProcess());
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
  // ParaView's processes abort where they have to put nothing into an order.
  const bool ordered = HasPoints(vtkPVView::GetPiece(inInfo, this)) && this->BlendsMarks();
  outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), ordered ? 1 : 0);
  // What the view holds for the current time; the first piece may be of another while it plays from its
  // cache.
  vtkBoundingBox box;
  for (int piece = 0; piece < static_cast<int>(this->Pieces.size()); ++piece)
  {
    auto* marks = vtkPolyData::SafeDownCast(vtkPVView::GetPiece(inInfo, this, piece));
    if (marks && marks->GetNumberOfPoints() > 0)
    {
      box.AddBounds(marks->GetBounds());
    }
  }
  double bounds[6];
  box.GetBounds(bounds);
  vtkNew<vtkMatrix4x4> matrix;
  this->Style->GetActor()->GetMatrix(matrix);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, matrix);
}

bool vtkInkRepresentation::DrawsOnThisProcess()
{
  auto view = vtkPVRenderView::SafeDownCast(this->GetView());
  return !view->GetUseOrderedCompositing() ||
    vtkMultiProcessController::GetGlobalController()->GetLocalProcessId() == 0;
}

std::vector<double> vtkInkRepresentation::GetUsedIsoValues()
{
  return {};
}

bool vtkInkRepresentation::AddToView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Style->GetActor());
  this->Paper->Attach(renderView->GetRenderer());
  renderView->RegisterPropForHardwareSelection(this, this->Style->GetActor());
  return this->Superclass::AddToView(view);
}

bool vtkInkRepresentation::RemoveFromView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->RemoveActor(this->Style->GetActor());
  this->Paper->Detach();
  renderView->UnRegisterPropForHardwareSelection(this, this->Style->GetActor());
  return this->Superclass::RemoveFromView(view);
}

void vtkInkRepresentation::SetMagnification(double magnification)
{
  this->Magnification = magnification;
  this->ChangeStyle(
    [=](vtkInkStyle* style) { style->SetPictureSize(magnification * style->GetPictureHeight()); });
}

void vtkInkRepresentation::SetPreview(bool preview)
{
  this->Preview = preview;
  if (!preview && this->Coarse)
  {
    this->Coarse = nullptr;
    this->MarkModified();
  }
}

void vtkInkRepresentation::TakeCoarse(vtkInkStyle::Input& input, vtkImageData* image)
{
  if (!this->Coarse || this->CoarseTime != image->GetMTime())
  {
    const vtkSmartPointer<vtkImageData> coarse = vtkInkCoarseImage(image, MostPointsOfPreview);
    this->Coarse = vtkSmartPointer<vtkTrivialProducer>::New();
    this->Coarse->SetOutput(coarse);
    this->CoarseTime = image->GetMTime();
  }
  input.Data = this->Coarse->GetOutputDataObject(0);
  input.Port = this->Coarse->GetOutputPort();
}

vtkBoundingBox vtkInkRepresentation::ToWorld(const vtkBoundingBox& box)
{
  vtkNew<vtkMatrix4x4> matrix;
  this->Style->GetActor()->GetMatrix(matrix);
  vtkBoundingBox moved;
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    box.GetCorner(corner, point);
    matrix->MultiplyPoint(point, point);
    moved.AddPoint(point);
  }
  return moved;
}

void vtkInkRepresentation::AskForGhostsOfGrids(vtkInformationVector** inputVector)
{
  vtkInformation* info =
    inputVector[0]->GetNumberOfInformationObjects() == 1 ? inputVector[0]->GetInformationObject(0) : nullptr;
  if (info && !vtkPolyData::GetData(info) && !vtkImageData::GetData(info))
  {
    using SDDP = vtkStreamingDemandDrivenPipeline;
    info->Set(
      SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), std::max(1, info->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS())));
  }
}

void vtkInkRepresentation::UpdatePickable()
{
  this->Style->GetActor()->SetPickable(this->Pickable && this->PointIdsAreInputs);
}

void vtkInkRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Points drawn: " << this->Pieces[0]->GetNumberOfPoints() << "\n";
  os << indent << "Cells drawn: " << this->Pieces[0]->GetNumberOfCells() << "\n";
  os << indent << "Times made: " << this->TimesMade << "\n";
  os << indent << "Magnification: " << this->Magnification << "\n";
  os << indent << "Paper: " << this->Paper->GetFills() << "\n";
  os << indent << "Pickable: " << this->Pickable << "\n";
  os << indent << "Style:\n";
  this->Style->PrintSelf(os, indent.GetNextIndent());
}
