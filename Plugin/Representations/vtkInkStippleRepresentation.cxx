// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleRepresentation.h"

#include "vtkInkEarlyFXAA.h"
#include "vtkInkMakeStipples.h"
#include "vtkInkStippleActor.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"

#include "Sampling/VolumeStipples.h"
#include "Tone/StippleSliders.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

using SDDP = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkInkStippleRepresentation);

namespace
{

/// The pieces that the representation hands to its views.
enum Pieces
{
  Stipples,
  Surface,
  Numbers, ///< one point of each process that has stipples, with what their field data says
  PieceCount
};

/// Of the stipples' field data what the mapper needs and delivery to other processes loses, and one number
/// more.
constexpr const char* NumberNames[] = { "ElementKind", "ElementSize", "StipplesPerElement", "RoomFactor" };

/// @param room by how much a stipple's room is multiplied
void WriteNumbers(vtkPolyData* stipples, double room, vtkPolyData* numbers)
{
  numbers->Initialize();
  if (stipples->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(stipples->GetPoint(0));
  numbers->SetPoints(points);
  for (const char* name : NumberNames)
  {
    vtkDataArray* known = stipples->GetFieldData()->GetArray(name);
    vtkNew<vtkDoubleArray> number;
    number->SetName(name);
    number->InsertNextValue(known && known->GetNumberOfTuples() > 0 ? known->GetComponent(0, 0) : room);
    numbers->GetPointData()->AddArray(number);
  }
}

} // namespace

vtkInkStippleRepresentation::vtkInkStippleRepresentation()
  : vtkInkRepresentation(vtkSmartPointer<vtkInkStippleActor>::New(), PieceCount, 2)
  , PixelsPerStipple(this->Mapper->GetPixelsPerStipple())
  , FXAA(std::make_unique<vtkInkEarlyFXAA>())
{
  this->FXAA->SetActive(this->GetVisibility());
  this->GetActor()->SetMapper(this->Mapper);
  this->Mapper->SetScalarModeToUseCellData();
  this->Mapper->UseLookupTableScalarRangeOn();
  this->Mapper->SetColorModeToMapScalars();
  this->SetProgressText("Making stipples");
  this->Generator->AddObserver(vtkCommand::ProgressEvent, this, &vtkInkStippleRepresentation::ReportProgress);
}

vtkInkStippleRepresentation::~vtkInkStippleRepresentation() = default;

bool vtkInkStippleRepresentation::AddToView(vtkView* view)
{
  if (auto renderView = vtkPVRenderView::SafeDownCast(view))
  {
    this->FXAA->Attach(renderView->GetRenderer());
  }
  return this->Superclass::AddToView(view);
}

bool vtkInkStippleRepresentation::RemoveFromView(vtkView* view)
{
  this->FXAA->Detach();
  return this->Superclass::RemoveFromView(view);
}

void vtkInkStippleRepresentation::SetVisibility(bool visible)
{
  this->FXAA->SetActive(visible);
  this->Superclass::SetVisibility(visible);
}

int vtkInkStippleRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    vtkInformation* info = inputVector[0]->GetInformationObject(0);
    // As the generator asks for them; of grids as many as tell the outer surface.
    const int ofGrids = vtkPolyData::GetData(info) ? 0 : 1;
    const int levels = vtkImageData::GetData(info) ? ink::stippleReach.x + 1 : ofGrids;
    info->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      std::max(levels, info->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS())));
  }
  return 1;
}

int vtkInkStippleRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkNew<vtkInformation> update;
  vtkInkStippleRequest wanted;
  wanted.Generator = this->Generator;
  wanted.Controller = vtkMultiProcessController::GetGlobalController();
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    wanted.Port = this->GetInputConnection(0, 0);
    vtkInformation* info = inputVector[0]->GetInformationObject(0);
    update->CopyEntry(info, SDDP::UPDATE_PIECE_NUMBER());
    update->CopyEntry(info, SDDP::UPDATE_NUMBER_OF_PIECES());
    if (info->Has(SDDP::UPDATE_TIME_STEP()))
    {
      update->Set(SDDP::UPDATE_TIME_STEP(), info->Get(SDDP::UPDATE_TIME_STEP()));
    }
  }
  wanted.Update = update;
  wanted.ColorArray = this->GetArrayName(0);
  wanted.ColorAssociation = this->GetArrayAssociation(0);
  wanted.Scalars = this->GetArrayName(1);
  if (this->IsoSurfaceHides)
  {
    wanted.IsoValue = this->IsoValue;
  }
  wanted.SurfaceHides = this->SurfaceHides;
  wanted.PictureSize = this->PictureSize;

  // An earlier run may have been stopped.
  this->SetAbortExecute(0);
  this->Generator->SetAbortExecute(0);
  const vtkInkMadeStipples made = vtkInkMakeStipples(vtkDataObject::GetData(inputVector[0], 0), wanted);
  this->GetPiece(Stipples)->ShallowCopy(made.Stipples);
  this->GetPiece(Surface)->ShallowCopy(made.Surface);
  WriteNumbers(made.Stipples, made.OfImage && this->IsoSurfaceHides ? ink::roomAtHidingSurface : 1.0,
    this->GetPiece(Numbers));
  this->Colors = made.ColorArray;
  this->ColorsAssociation = made.ColorAssociation;
  if (made.IdsAreInputs)
  {
    this->MarkIdsAsInputs();
  }
  if (!made.Problem.empty())
  {
    vtkWarningMacro(<< "Stipple draws nothing for " << made.Problem);
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

bool vtkInkStippleRepresentation::ServesFor(int array)
{
  const std::string name = this->GetArrayName(array);
  return array == 0 &&
    (name.empty() || (name == this->Colors && this->GetArrayAssociation(0) == this->ColorsAssociation));
}

void vtkInkStippleRepresentation::Show(const std::vector<vtkPolyData*>& delivered)
{
  vtkPolyData* stipples = delivered[Stipples];
  vtkPolyData* numbers = delivered[Numbers];
  if (!stipples || !numbers || numbers->GetNumberOfPoints() == 0)
  {
    this->Drawn->Initialize();
    this->DrawnTime = 0;
    this->Mapper->SetInputDataObject(nullptr);
    return;
  }
  // The same object as long as nothing is new, so that the mapper sends nothing new to the GPU.
  const vtkMTimeType time = std::max(stipples->GetMTime(), numbers->GetMTime());
  if (this->DrawnTime != time)
  {
    this->DrawnTime = time;
    this->Drawn->ShallowCopy(stipples);
    vtkNew<vtkFieldData> field;
    for (const char* name : NumberNames)
    {
      vtkNew<vtkDoubleArray> number;
      number->SetName(name);
      number->InsertNextValue(numbers->GetPointData()->GetArray(name)->GetComponent(0, 0));
      field->AddArray(number);
    }
    this->Drawn->SetFieldData(field);
  }
  this->Mapper->SetInputDataObject(this->Drawn);
  this->Mapper->SetSurfaceData(
    delivered[Surface] && delivered[Surface]->GetNumberOfCells() > 0 ? delivered[Surface] : nullptr);
  this->Mapper->SetScalarVisibility(
    this->Drawn->GetCellData()->GetScalars() && !this->GetArrayName(0).empty());
  const double room = numbers->GetPointData()->GetArray("RoomFactor")->GetComponent(0, 0);
  this->Mapper->SetPixelsPerStipple(this->PixelsPerStipple * room);
}

void vtkInkStippleRepresentation::ReportProgress()
{
  this->UpdateProgress(this->Generator->GetProgress());
  if (this->GetAbortExecute())
  {
    this->Generator->SetAbortExecute(1);
  }
}

template <class Change>
void vtkInkStippleRepresentation::ChangeGenerator(const Change& change)
{
  const vtkMTimeType before = this->Generator->GetMTime();
  change(this->Generator.Get());
  if (this->Generator->GetMTime() > before)
  {
    this->MarkModified();
  }
}

template <class Value>
void vtkInkStippleRepresentation::ChangeValue(Value& value, Value changed)
{
  if (value != changed)
  {
    value = changed;
    this->MarkModified();
  }
}

void vtkInkStippleRepresentation::SetMaximumStipples(int maximumStipples)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetMaximumStipples(maximumStipples); });
}

void vtkInkStippleRepresentation::SetNumberOfSurfaceStipples(vtkIdType numberOfSurfaceStipples)
{
  this->ChangeGenerator([=](vtkInkStippleGenerator* generator)
    { generator->SetNumberOfSurfaceStipples(numberOfSurfaceStipples); });
}

void vtkInkStippleRepresentation::SetPictureSize(double pixels)
{
  this->ChangeValue(this->PictureSize, std::clamp(pixels, 100.0, 10000.0));
}

void vtkInkStippleRepresentation::SetThresholdMode(int thresholdMode)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetThresholdMode(thresholdMode); });
}

void vtkInkStippleRepresentation::SetGradientPercentile(double gradientPercentile)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetGradientPercentile(gradientPercentile); });
}

void vtkInkStippleRepresentation::SetGradientThreshold(double gradientThreshold)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetGradientThreshold(gradientThreshold); });
}

void vtkInkStippleRepresentation::SetLayerThickness(double layerThickness)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetLayerThickness(layerThickness); });
}

void vtkInkStippleRepresentation::SetGradientMethod(int gradientMethod)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetGradientMethod(gradientMethod); });
}

void vtkInkStippleRepresentation::SetUseScalarWindow(bool useScalarWindow)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetUseScalarWindow(useScalarWindow); });
}

void vtkInkStippleRepresentation::SetUseReferenceRanges(bool useReferenceRanges)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetUseReferenceRanges(useReferenceRanges); });
}

void vtkInkStippleRepresentation::SetReferenceGradient(double referenceGradient)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetReferenceGradient(referenceGradient); });
}

void vtkInkStippleRepresentation::SetSeed(int seed)
{
  this->ChangeGenerator([=](vtkInkStippleGenerator* generator) { generator->SetSeed(seed); });
}

void vtkInkStippleRepresentation::SetScalarWindow(double lowest, double highest)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetScalarWindow(lowest, highest); });
}

void vtkInkStippleRepresentation::SetReferenceScalarRange(double lowest, double highest)
{
  this->ChangeGenerator(
    [=](vtkInkStippleGenerator* generator) { generator->SetReferenceScalarRange(lowest, highest); });
}

void vtkInkStippleRepresentation::SelectStippleArray(int, int, int, int association, const char* name)
{
  // Array 0 is the one to color by.
  const bool active = !name || std::string(name) == "Active Scalars";
  this->SetInputArrayToProcess(1, 0, 0, association, active ? "" : name);
}

void vtkInkStippleRepresentation::SetIsoSurfaceHides(bool hides)
{
  this->ChangeValue(this->IsoSurfaceHides, hides);
}

void vtkInkStippleRepresentation::SetIsoValue(double value)
{
  if (this->IsoSurfaceHides)
  {
    this->ChangeValue(this->IsoValue, value);
  }
  this->IsoValue = value;
}

void vtkInkStippleRepresentation::SetSurfaceHides(bool hides)
{
  this->ChangeValue(this->SurfaceHides, hides);
}

void vtkInkStippleRepresentation::SetBoundary(bool boundary)
{
  this->Mapper->SetBoundary(boundary);
}

void vtkInkStippleRepresentation::SetKgc(double kgc)
{
  this->Mapper->SetKgc(kgc);
}

void vtkInkStippleRepresentation::SetKgs(double kgs)
{
  this->Mapper->SetKgs(kgs);
}

void vtkInkStippleRepresentation::SetKge(double kge)
{
  this->Mapper->SetKge(kge);
}

void vtkInkStippleRepresentation::SetSilhouette(bool silhouette)
{
  this->Mapper->SetSilhouette(silhouette);
}

void vtkInkStippleRepresentation::SetKsc(double ksc)
{
  this->Mapper->SetKsc(ksc);
}

void vtkInkStippleRepresentation::SetKss(double kss)
{
  this->Mapper->SetKss(kss);
}

void vtkInkStippleRepresentation::SetKse(double kse)
{
  this->Mapper->SetKse(kse);
}

void vtkInkStippleRepresentation::SetResolution(bool resolution)
{
  this->Mapper->SetResolution(resolution);
}

void vtkInkStippleRepresentation::SetKrc(double krc)
{
  this->Mapper->SetKrc(krc);
}

void vtkInkStippleRepresentation::SetKnz(double knz)
{
  this->Mapper->SetKnz(knz);
}

void vtkInkStippleRepresentation::SetLighting(bool lighting)
{
  this->Mapper->SetLighting(lighting);
}

void vtkInkStippleRepresentation::SetKle(double kle)
{
  this->Mapper->SetKle(kle);
}

void vtkInkStippleRepresentation::SetFacingAngle(double facingAngle)
{
  this->Mapper->SetFacingAngle(facingAngle);
}

void vtkInkStippleRepresentation::SetHeadlight(bool headlight)
{
  this->Mapper->SetHeadlight(headlight);
}

void vtkInkStippleRepresentation::SetLightInk(bool lightInk)
{
  this->Mapper->SetLightInk(lightInk);
}

void vtkInkStippleRepresentation::SetDistance(bool distance)
{
  this->Mapper->SetDistance(distance);
}

void vtkInkStippleRepresentation::SetKde(double kde)
{
  this->Mapper->SetKde(kde);
}

void vtkInkStippleRepresentation::SetDistanceSize(double distanceSize)
{
  this->Mapper->SetDistanceSize(distanceSize);
}

void vtkInkStippleRepresentation::SetInterior(bool interior)
{
  this->Mapper->SetInterior(interior);
}

void vtkInkStippleRepresentation::SetKie(double kie)
{
  this->Mapper->SetKie(kie);
}

void vtkInkStippleRepresentation::SetInteriorSize(double interiorSize)
{
  this->Mapper->SetInteriorSize(interiorSize);
}

void vtkInkStippleRepresentation::SetValueEffect(double valueEffect)
{
  this->Mapper->SetValueEffect(valueEffect);
}

void vtkInkStippleRepresentation::SetGrowing(bool growing)
{
  this->Mapper->SetGrowing(growing);
}

void vtkInkStippleRepresentation::SetSmallElements(int smallElements)
{
  this->Mapper->SetSmallElements(smallElements);
}

void vtkInkStippleRepresentation::SetMinimumCoverage(double minimumCoverage)
{
  this->Mapper->SetMinimumCoverage(minimumCoverage);
}

void vtkInkStippleRepresentation::SetFade(double fade)
{
  this->Mapper->SetFade(fade);
}

void vtkInkStippleRepresentation::SetAppearBySize(bool appearBySize)
{
  this->Mapper->SetAppearBySize(appearBySize);
}

void vtkInkStippleRepresentation::SetPositionPrecision(int positionPrecision)
{
  this->Mapper->SetPositionPrecision(positionPrecision);
}

void vtkInkStippleRepresentation::SetWarmCool(double warmCool)
{
  this->Mapper->SetWarmCool(warmCool);
}

void vtkInkStippleRepresentation::SetToneWeight(double toneWeight)
{
  this->Mapper->SetToneWeight(toneWeight);
}

void vtkInkStippleRepresentation::SetDistanceWeight(double distanceWeight)
{
  this->Mapper->SetDistanceWeight(distanceWeight);
}

void vtkInkStippleRepresentation::SetOccluderOffset(double occluderOffset)
{
  this->Mapper->SetOccluderOffset(occluderOffset);
}

void vtkInkStippleRepresentation::SetPixelsPerStipple(double pixels)
{
  this->PixelsPerStipple = pixels;
}

void vtkInkStippleRepresentation::SetStippleSize(double pixels)
{
  this->Mapper->SetStippleSize(pixels);
}

void vtkInkStippleRepresentation::SetWarmColor(double red, double green, double blue)
{
  this->Mapper->SetWarmColor(red, green, blue);
}

void vtkInkStippleRepresentation::SetCoolColor(double red, double green, double blue)
{
  this->Mapper->SetCoolColor(red, green, blue);
}

void vtkInkStippleRepresentation::SetInkColor(double red, double green, double blue)
{
  this->Mapper->SetInkColor(red, green, blue);
}

void vtkInkStippleRepresentation::SetLookupTable(vtkScalarsToColors* table)
{
  this->Mapper->SetLookupTable(table);
}

void vtkInkStippleRepresentation::SetMapScalars(bool map)
{
  this->Mapper->SetColorMode(map ? VTK_COLOR_MODE_MAP_SCALARS : VTK_COLOR_MODE_DIRECT_SCALARS);
}

void vtkInkStippleRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Generator:\n";
  this->Generator->PrintSelf(os, indent.GetNextIndent());
  os << indent << "IsoSurfaceHides: " << this->IsoSurfaceHides << "\n";
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "PictureSize: " << this->PictureSize << "\n";
  os << indent << "SurfaceHides: " << this->SurfaceHides << "\n";
  os << indent << "PixelsPerStipple: " << this->PixelsPerStipple << "\n";
}
