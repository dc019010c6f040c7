// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStyle.h"

#include "InkCurvedMesh.h"
#include "InkFeatureNormals.h"
#include "InkHasPolygons.h"
#include "InkLeaves.h"
#include "InkOriginalImage.h"
#include "InkParameter.h"
#include "InkPointNormals.h"
#include "InkReportException.h"
#include "InkStyleProcesses.h"
#include "InkTubes.h"
#include "vtkInkSurfaceSampler.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>

vtkInkStyle::vtkInkStyle()
  : Original(std::make_unique<InkOriginalImage>())
  , Processes(std::make_shared<InkStyleProcesses>())
{
}

vtkInkStyle::~vtkInkStyle() = default;

bool vtkInkStyle::Make(vtkDataObject* data)
{
  return this->ReportProblem(this->MakeMarks({ data }));
}

vtkMTimeType vtkInkStyle::GetMTime()
{
  const vtkMTimeType recipe = this->GetRecipeMTime();
  return std::max(
    this->Superclass::GetMTime(), recipe == this->TimeAfterMaking ? this->TimeBeforeMaking : recipe);
}

std::string vtkInkStyle::MakeMarks(const Input& input)
{
  const vtkMTimeType before = this->GetMTime();
  std::string problem = this->TryPieces(input);
  std::array limits{ this->LeastRelativeSize, -this->MostRelativeSize };
  this->GetProcesses().TakeGreatest(limits);
  this->LeastRelativeSize = limits[0];
  this->MostRelativeSize = -limits[1];
  this->TimeBeforeMaking = before;
  this->TimeAfterMaking = this->GetRecipeMTime();
  return problem;
}

std::string vtkInkStyle::TryPieces(const Input& input)
{
  this->Notes.clear();
  this->Aborted = false;
  this->FramePoints = nullptr;
  this->LeastRelativeSize = 0.0;
  this->MostRelativeSize = std::numeric_limits<double>::infinity();
  this->DataDiagonal = input.Diagonal > 0.0 ? input.Diagonal
    : this->Interactive                     ? this->FindDiagonal(input.Data)
                                            : 0.0;
  this->Pieces.clear();
  for (int piece = 0; piece < this->GetNumberOfPieces(); ++piece)
  {
    this->Pieces.push_back(vtkSmartPointer<vtkPolyData>::New());
  }
  try
  {
    std::string problem = this->MakePiecesOrSurfaces(this->TakeOriginal(input));
    this->FramePoints = this->FramePoints ? this->FramePoints.Get() : this->GetPiece(0)->GetPoints();
    return problem;
  }
  catch (const std::bad_alloc&)
  {
    return std::string(this->GetLabel()) + ": there is not enough memory";
  }
  catch (const std::exception& error)
  {
    return std::string(this->GetLabel()) + ": " + error.what();
  }
}

vtkInkStyle::Input vtkInkStyle::TakeOriginal(const Input& input)
{
  if (input.IsOriginal)
  {
    return input;
  }
  const auto is = [&](const char* parameter, const char* value)
  {
    const InkParameter* known = this->GetParameterTable().Find(parameter);
    return known && this->GetParameterAsString(known->Name) == value;
  };
  const bool repeats = !is("LabelMap", "off");
  const bool slices = is("ShapeBasedInterpolation", "auto") && this->DrawsSurfaces(input);
  if ((!repeats && !slices) ||
    !this->Original->Find(
      this->GetProcesses(), input.Data, { this->GetParameterAsString("Scalars"), repeats, slices }))
  {
    return input;
  }
  this->AddNote(this->Original->GetNote());
  Input result = input;
  vtkTrivialProducer* source = this->Original->GetSource();
  result.Data = source->GetOutputDataObject(0);
  result.Port = input.Port ? source->GetOutputPort() : nullptr;
  result.Request = nullptr; // no longer a piece of several
  return result;
}

void vtkInkStyle::Show()
{
  std::vector<vtkPolyData*> pieces;
  for (int piece = 0; piece < this->GetNumberOfPieces(); ++piece)
  {
    pieces.push_back(this->GetPiece(piece));
  }
  this->ShowPieces(pieces);
}

std::string vtkInkStyle::TryDraw(vtkDataObject* data)
{
  const std::string problem = this->MakeMarks({ data });
  this->Show();
  return problem;
}

bool vtkInkStyle::Draw(vtkDataObject* data)
{
  return this->ReportProblem(this->TryDraw(data));
}

vtkPolyData* vtkInkStyle::GetPiece(int piece)
{
  const auto index = static_cast<std::size_t>(piece);
  return piece >= 0 && index < this->Pieces.size() ? this->Pieces[index].Get() : nullptr;
}

void vtkInkStyle::SetProcesses(std::shared_ptr<InkStyleProcesses> processes)
{
  this->Processes = processes ? std::move(processes) : std::make_shared<InkStyleProcesses>();
}

InkStyleProcesses& vtkInkStyle::GetProcesses()
{
  return *this->Processes;
}

std::string vtkInkStyle::MakeMarksOf(vtkInkStyle* part, const Input& input)
{
  part->SetPictureSize(this->PictureSize);
  part->SetPictureHeight(this->PictureHeight);
  part->SetInteractive(this->Interactive);
  part->SetCurvedMeshes(this->CurvedMeshes && !input.IsGathered);
  part->SetProcesses(this->Processes);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void*)
    {
      auto* self = static_cast<vtkInkStyle*>(client);
      auto* made = static_cast<vtkInkStyle*>(caller);
      self->Progress = made->Progress;
      self->ProgressText = made->ProgressText;
      self->InvokeEvent(vtkCommand::ProgressEvent, &self->Progress);
      made->Aborted = self->Aborted;
    });
  const unsigned long observer = part->AddObserver(vtkCommand::ProgressEvent, command);
  Input known = input;
  known.Diagonal = this->DataDiagonal;
  known.IsOriginal = true;
  std::string problem = part->MakeMarks(known);
  part->RemoveObserver(observer);
  this->Notes.insert(this->Notes.end(), part->Notes.begin(), part->Notes.end());
  this->LimitPictures(part->LeastRelativeSize, part->MostRelativeSize);
  return problem;
}

void vtkInkStyle::AddNote(const std::string& note)
{
  this->Notes.push_back(note);
}

int vtkInkStyle::GetNumberOfNotes()
{
  return static_cast<int>(this->Notes.size());
}

const char* vtkInkStyle::GetNote(int note)
{
  return note >= 0 && note < this->GetNumberOfNotes() ? this->Notes[static_cast<std::size_t>(note)].c_str()
                                                      : nullptr;
}

void vtkInkStyle::SetPixelScale(double scale)
{
  // Not a number compares as false.
  const double kept = scale > 0.001 ? std::min(scale, 16.0) : 0.001;
  if (this->PixelScale != kept)
  {
    this->PixelScale = kept;
    this->UpdatePixels();
    this->Modified();
  }
}

void vtkInkStyle::SetStillCamera(StillCamera camera)
{
  this->Still = std::move(camera);
  this->Modified();
}

vtkSmartPointer<vtkCamera> vtkInkStyle::FindStillCamera()
{
  return this->Still && this->FramePoints ? this->Still(this->FramePoints) : nullptr;
}

void vtkInkStyle::SetPictureSize(double pixels)
{
  this->SetPicture(this->PictureSize, pixels);
}

void vtkInkStyle::SetPictureHeight(double pixels)
{
  this->SetPicture(this->PictureHeight, pixels);
}

void vtkInkStyle::SetPicture(double& side, double pixels)
{
  const double kept = pixels > 1.0 ? std::min(pixels, 100000.0) : 1.0;
  if (side == kept)
  {
    return;
  }
  side = kept;
  const double size = this->GetRelativeSize();
  if (!this->Interactive || size < this->LeastRelativeSize || size > this->MostRelativeSize)
  {
    this->Modified();
  }
}

double vtkInkStyle::FindDiagonal(vtkDataObject* data)
{
  const InkLeaves leaves(data);
  vtkBoundingBox box;
  const auto add = [&](const auto& some)
  { std::for_each(some.begin(), some.end(), [&](vtkDataSet* one) { box.AddBounds(one->GetBounds()); }); };
  add(leaves.Images);
  add(leaves.Stipples);
  add(leaves.Others);
  // The lower corner negated.
  const double* low = box.GetMinPoint();
  const double* high = box.GetMaxPoint();
  std::array corners{ -low[0], -low[1], -low[2], high[0], high[1], high[2] };
  this->GetProcesses().TakeGreatest(corners);
  const std::array sides{ corners[0] + corners[3], corners[1] + corners[4], corners[2] + corners[5] };
  return sides[0] >= 0.0 ? std::hypot(sides[0], sides[1], sides[2]) : 0.0;
}

void vtkInkStyle::LimitPictures(double least, double most)
{
  this->LeastRelativeSize = std::max(this->LeastRelativeSize, least);
  this->MostRelativeSize = std::min(this->MostRelativeSize, most);
}

bool vtkInkStyle::ReportProblem(const std::string& problem)
{
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem << '.');
  }
  return problem.empty();
}

std::shared_ptr<void> vtkInkStyle::StartFollowing(vtkAlgorithm* algorithm, const char* text)
{
  this->AlgorithmError.clear();
  this->ProgressText = text;
  this->Progress = 0.0;
  this->InvokeEvent(vtkCommand::ProgressEvent, &this->Progress);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject* caller, unsigned long event, void* client, void* data)
    {
      auto* self = static_cast<vtkInkStyle*>(client);
      auto* followed = static_cast<vtkAlgorithm*>(caller);
      if (event == vtkCommand::ErrorEvent)
      {
        self->AlgorithmError = self->AlgorithmError.empty() ? InkTextOfMessage(static_cast<const char*>(data))
                                                            : self->AlgorithmError;
        return;
      }
      self->Progress = followed->GetProgress();
      self->InvokeEvent(vtkCommand::ProgressEvent, &self->Progress);
      if (self->Aborted)
      {
        followed->SetAbortExecute(1);
      }
    });
  const unsigned long progress = algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  const unsigned long error = algorithm->AddObserver(vtkCommand::ErrorEvent, command);
  // An earlier run may have been stopped.
  algorithm->SetAbortExecute(0);
  const vtkSmartPointer<vtkAlgorithm> kept = algorithm;
  return { nullptr,
    [kept, progress, error](void*)
    {
      kept->RemoveObserver(progress);
      kept->RemoveObserver(error);
    } };
}

std::string vtkInkStyle::Follow(vtkAlgorithm* algorithm, const char* text)
{
  return this->Follow(algorithm, text, [algorithm] { algorithm->Update(); });
}

std::function<bool(double)> vtkInkStyle::StartStep(const char* text)
{
  this->ProgressText = text;
  return [this](double done)
  {
    this->Progress = done;
    this->InvokeEvent(vtkCommand::ProgressEvent, &this->Progress);
    return !this->Aborted;
  };
}

vtkSmartPointer<vtkPolyData> vtkInkStyle::GatherMesh(const InkLeaves& leaves)
{
  return this->TakeSurface(this->GetProcesses().Gather(leaves.MakeMeshes()));
}

vtkSmartPointer<vtkPolyData> vtkInkStyle::TakeSurface(vtkPolyData* mesh)
{
  if (InkIsOfLines(mesh))
  {
    std::string note;
    const vtkSmartPointer<vtkPolyData> tubes = InkMakeTubes(mesh, note);
    this->AddNote(note);
    return tubes;
  }
  if (!this->CurvedMeshes || !InkHasPolygons(mesh))
  {
    return mesh;
  }
  const ink::Progress progress = this->StartStep("curving the mesh");
  try
  {
    const vtkSmartPointer<vtkPolyData> curved = InkCurvedMesh(mesh, progress);
    if (curved != mesh)
    {
      this->NoteMissingNormals(mesh);
    }
    return curved;
  }
  catch (const std::exception&)
  {
    // What is wrong with it those say who draw it, on all processes.
    return mesh;
  }
}

void vtkInkStyle::NoteMissingNormals(vtkPolyData* mesh)
{
  if (!InkPointNormals(mesh))
  {
    this->AddNote("the mesh has no normals; they are computed from its polygons");
  }
}

std::string vtkInkStyle::TakeMeshWithNormals(vtkPolyData* mesh, vtkPolyData* piece)
{
  this->NoteMissingNormals(mesh);
  try
  {
    piece->ShallowCopy(InkWithFeatureNormals(mesh));
  }
  catch (const std::invalid_argument& problem)
  {
    return std::string("The mesh cannot be drawn: ") + problem.what();
  }
  piece->GetPointData()->SetNormals(InkPointNormals(piece));
  return {};
}

std::string vtkInkStyle::TakeDiscs(vtkInkSurfaceSampler* sampler, vtkPolyData* points, vtkPolyData* piece)
{
  sampler->SetInputData(points);
  const std::string problem = this->Follow(sampler, "looking at the points");
  // The sampler's own output is other points' when it is asked again.
  piece->ShallowCopy(sampler->GetOutput());
  if (!problem.empty())
  {
    return problem;
  }
  const bool estimated = sampler->GetComputeNormals() && !points->GetPointData()->GetNormals();
  this->AddNote("there are no polygons; the " + std::to_string(points->GetNumberOfPoints()) +
    " points are taken as they are" + (estimated ? ", with normals estimated from their neighbors" : ""));
  if (const vtkIdType isolated = sampler->GetNumberOfIsolatedPoints(); isolated > 0)
  {
    this->AddNote(std::to_string(isolated) + " points that are far from all others are left out");
  }
  return {};
}

void vtkInkStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PixelScale: " << this->PixelScale << "\n";
  os << indent << "PictureSize: " << this->PictureSize << "\n";
  os << indent << "PictureHeight: " << this->PictureHeight << "\n";
  os << indent << "MaximumMemory: " << this->MaximumMemory << "\n";
  os << indent << "Interactive: " << (this->Interactive ? "On" : "Off") << "\n";
  os << indent << "Parameters:\n";
  for (const InkParameter& parameter : this->GetParameterTable().Parameters)
  {
    os << indent.GetNextIndent() << parameter.Name << ": " << parameter.Format(parameter.Get(this)) << "\n";
  }
}
