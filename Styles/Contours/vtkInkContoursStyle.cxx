// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkContoursStyle.h"

#include "InkContourSurface.h"
#include "InkHasPolygons.h"
#include "InkIsoSurface.h"
#include "InkLeaves.h"
#include "InkParameter.h"
#include "InkStyleProcesses.h"
#include "vtkInkEdgeVoxels.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkInkContoursStyle);

/// Generated from parameters.json.
const InkParameterTable& InkContoursParameters();

namespace
{

/// A way of drawing.
struct Way
{
  double LineWidth;
  double Taper;
  double DepthWidth;
  int Join;
  bool Creases;
  int HiddenParts;
};

using Mapper = vtkInkSilhouetteMapper;

/// In the order of the table's entries.
constexpr Way Presets[] = {
  { 2.5, 0.0, 0.5, Mapper::ROUND_JOIN, true, Mapper::OMITTED },  // pen
  { 1.5, 0.0, 0.0, Mapper::MITER_JOIN, true, Mapper::OMITTED },  // technical
  { 1.5, 0.0, 0.0, Mapper::MITER_JOIN, true, Mapper::DASHED },   // hidden-lines
  { 2.0, 0.0, 0.3, Mapper::ROUND_JOIN, true, Mapper::FAINT },    // glass
  { 6.0, 0.8, 0.7, Mapper::ROUND_JOIN, false, Mapper::OMITTED }, // brush
};

} // namespace

vtkInkContoursStyle::vtkInkContoursStyle()
  : IsoSurface(std::make_unique<InkIsoSurface>())
{
  this->Actor->SetMapper(this->Mapper);
  this->Mapper->SetFeatureAngle(40.0);
  this->Mapper->SetShortestCrease(0.05);
  this->SetPreset(0);
}

vtkInkContoursStyle::~vtkInkContoursStyle() = default;

const char* vtkInkContoursStyle::GetDescription()
{
  return "silhouettes, creases and borders of iso-surfaces and meshes (Hertzmann and Zorin 2000)";
}

const InkParameterTable& vtkInkContoursStyle::GetParameterTable()
{
  return InkContoursParameters();
}

vtkMTimeType vtkInkContoursStyle::GetRecipeMTime()
{
  return std::max(this->IsoSurface->GetMTime(), this->VoxelsChanged.GetMTime());
}

vtkMapper* vtkInkContoursStyle::GetMapper()
{
  return this->Mapper;
}

InkIsoSurface* vtkInkContoursStyle::GetIsoSurface()
{
  return this->IsoSurface.get();
}

vtkInkSilhouetteMapper* vtkInkContoursStyle::GetSilhouetteMapper()
{
  return this->Mapper;
}

void vtkInkContoursStyle::GetBackgroundColor(double color[3])
{
  std::copy_n(this->PaperColor, 3, color);
}

std::string vtkInkContoursStyle::GetReasonAgainst(vtkDataObject* data)
{
  const std::string wanted = "expected an image, a mesh with polygons, found ";
  const InkLeaves leaves(data);
  const std::string problem = leaves.Problem.empty() ? leaves.FindImageProblem() : leaves.Problem;
  if (!data || !problem.empty())
  {
    return wanted + (data ? problem : "nothing");
  }
  const auto isPoints = [](vtkDataSet* leaf)
  {
    auto* mesh = vtkPolyData::SafeDownCast(leaf);
    return mesh && !InkHasPolygons(mesh);
  };
  const bool hasPoints = !leaves.Stipples.empty() || !leaves.Others.empty();
  const bool onlyPoints =
    leaves.Images.empty() && std::all_of(leaves.Others.begin(), leaves.Others.end(), isPoints);
  return !onlyPoints ? std::string() : wanted + (hasPoints ? "points without polygons" : "no points");
}

std::string vtkInkContoursStyle::MakePieces(const Input& input)
{
  const InkLeaves leaves(input.Data);
  // Processes without a part of the image take part, too.
  double images = leaves.Images.empty() ? 0.0 : 1.0;
  this->GetProcesses().TakeGreatest({ &images, 1 });
  // Where others have a part of the data, none is no mistake.
  const std::string reason = input.Port && !input.Data ? std::string() : this->GetReasonAgainst(input.Data);
  if (images == 0.0)
  {
    return this->TakeMesh(input, leaves, reason);
  }
  if (this->Method == Mapper::VOXEL_SEGMENTS)
  {
    const std::string ofVoxels = this->MakeVoxels(leaves);
    return !leaves.Images.empty() && !reason.empty() ? reason
      : ofVoxels.empty()                             ? leaves.FindBesideImages()
                                                     : ofVoxels;
  }
  const std::string problem = this->IsoSurface->Prepare(this, leaves.Images, {});
  if (!problem.empty())
  {
    return problem;
  }
  vtkPolyData* surface = this->GetPiece(0);
  const std::string ofSurface =
    InkContourSurface(this).MakeOfImages(*this->IsoSurface, leaves.Images, {}, surface);
  if (ofSurface.empty() && !input.Port)
  {
    this->IsoSurface->NoteWhereEmpty(this, surface);
  }
  return !leaves.Images.empty() && !reason.empty() ? reason
    : ofSurface.empty()                            ? leaves.FindBesideImages()
                                                   : ofSurface;
}

std::string vtkInkContoursStyle::MakeVoxels(const InkLeaves& leaves)
{
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (vtkImageData* image : this->GetProcesses().GatherImages(leaves.Images, {}))
  {
    this->EdgeVoxels->SetInputData(image);
    std::string problem = this->Follow(this->EdgeVoxels, "finding edge voxels");
    if (!problem.empty())
    {
      this->EdgeVoxels->SetInputData(nullptr);
      return problem;
    }
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    parts.back()->ShallowCopy(this->EdgeVoxels->GetOutput());
  }
  this->EdgeVoxels->SetInputData(nullptr);
  vtkPolyData* voxels = this->GetPiece(0);
  if (!parts.empty())
  {
    voxels->ShallowCopy(InkAppend(parts));
    if (voxels->GetNumberOfPoints() == 0)
    {
      this->AddNote("no voxel of the image lies on an edge");
    }
  }
  return {};
}

std::string vtkInkContoursStyle::TakeMesh(
  const Input& input, const InkLeaves& leaves, const std::string& reason)
{
  if (!input.Port && !reason.empty())
  {
    return reason;
  }
  if (this->Method == Mapper::VOXEL_SEGMENTS)
  {
    return "segments through voxels need an image, found a mesh";
  }
  if (const std::string grids = leaves.DescribeGrids(); !grids.empty())
  {
    this->AddNote(grids);
  }
  // Those of several processes are put together on the first one; all take part.
  const vtkSmartPointer<vtkPolyData> whole = this->GetProcesses().Gather(leaves.MakeMeshes());
  if (!InkHasPolygons(whole))
  {
    return !leaves.Problem.empty() || whole->GetNumberOfPoints() > 0 ? reason : std::string();
  }
  this->SetFramePoints(whole->GetPoints());
  const std::string problem = InkContourSurface(this).MakeOfMesh(whole, this->GetPiece(0));
  return leaves.Problem.empty() ? problem : reason;
}

void vtkInkContoursStyle::ShowPieces(const std::vector<vtkPolyData*>& pieces)
{
  vtkPolyData* surface = pieces[0];
  this->Mapper->SetInputDataObject(surface && surface->GetNumberOfPoints() > 0 ? surface : nullptr);
  this->UpdateMethod();
  this->SetCreases(this->Creases);
}

void vtkInkContoursStyle::UpdateMethod()
{
  vtkPolyData* piece = this->Mapper->GetInput();
  vtkDataArray* gradients =
    piece && !InkHasPolygons(piece) ? piece->GetPointData()->GetArray("Gradient") : nullptr;
  if (!gradients)
  {
    // The piece is a surface until voxels are made.
    this->Mapper->SetMethod(this->Method == Mapper::VOXEL_SEGMENTS ? Mapper::CHAINS : this->Method);
    return;
  }
  this->Mapper->SetMethodToVoxelSegments();
  // The magnitudes'.
  double range[2];
  gradients->GetFiniteRange(range, -1);
  this->Mapper->SetLeastGradientMagnitude(this->LeastGradient * range[1]);
}

void vtkInkContoursStyle::UpdatePixels()
{
  this->Mapper->SetShortestPart(this->GetPixelScale() * this->ShortestPart);
}

void vtkInkContoursStyle::SetPreset(int preset)
{
  this->Preset = std::clamp(preset, 0, static_cast<int>(std::size(Presets)) - 1);
  const Way& way = Presets[this->Preset];
  this->Mapper->SetLineWidth(way.LineWidth);
  this->Mapper->SetTaper(way.Taper);
  this->Mapper->SetDepthWidth(way.DepthWidth);
  this->Mapper->SetJoin(way.Join);
  this->Mapper->SetHiddenParts(way.HiddenParts);
  this->SetCreases(way.Creases);
}

void vtkInkContoursStyle::SetMethod(int method)
{
  const int known = std::clamp<int>(method, Mapper::CHAINS, Mapper::TOON);
  const bool wanted = known == Mapper::VOXEL_SEGMENTS;
  if (wanted != (this->Method == Mapper::VOXEL_SEGMENTS))
  {
    this->VoxelsChanged.Modified();
  }
  this->Method = known;
  this->UpdateMethod();
}

void vtkInkContoursStyle::SetEdgeScale(double scale)
{
  if (scale != this->GetEdgeScale())
  {
    this->EdgeVoxels->SetEdgeScale(scale);
    this->VoxelsChanged.Modified();
  }
}

double vtkInkContoursStyle::GetEdgeScale()
{
  return this->EdgeVoxels->GetEdgeScale();
}

void vtkInkContoursStyle::SetLeastGradient(double share)
{
  this->LeastGradient = share;
  this->UpdateMethod();
}

void vtkInkContoursStyle::SetValueRange(const std::vector<double>& range)
{
  this->ValueRange = range;
  const bool all = range.size() != 2;
  this->Mapper->SetLowestValue(all ? -1e38 : range[0]);
  this->Mapper->SetHighestValue(all ? 1e38 : range[1]);
}

void vtkInkContoursStyle::SetCreases(bool creases)
{
  this->Creases = creases;
  InkContourSurface::SetCreases(this->Mapper, creases);
}

void vtkInkContoursStyle::SetPaperColor(double red, double green, double blue)
{
  this->PaperColor[0] = red;
  this->PaperColor[1] = green;
  this->PaperColor[2] = blue;
}

void vtkInkContoursStyle::SetShortestPart(double pixels)
{
  this->ShortestPart = pixels;
  this->UpdatePixels();
}

void vtkInkContoursStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
