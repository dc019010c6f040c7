// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkContoursStyle.h"

#include "InkContourSurface.h"
#include "InkHasPolygons.h"
#include "InkIsoSurface.h"
#include "InkLeaves.h"
#include "InkNullIfEmpty.h"
#include "InkParameter.h"
#include "InkSilhouetteMethod.h"
#include "InkStyleProcesses.h"
#include "InkTextureFile.h"
#include "InkTubes.h"
#include "vtkInkSilhouetteMapper.h"

#include "Curves/Contours/FeatureEdges.h"
#include "Mesh/FeatureSplit.h"

#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
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
  , Method(std::make_unique<InkSilhouetteMethod>(this->Mapper))
{
  this->Actor->SetMapper(this->Mapper);
  this->Mapper->SetFeatureAngle(ink::defaultFeatureAngle);
  this->Mapper->SetShortestCrease(ink::defaultShortestCrease);
  this->Mapper->SetShortestBorder(InkContourSurface::ShortestBorder);
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
  return std::max(this->IsoSurface->GetMTime(), this->Method->GetMTime());
}

vtkMapper* vtkInkContoursStyle::GetMapper()
{
  return this->Mapper;
}

InkIsoSurface* vtkInkContoursStyle::GetIsoSurface()
{
  return this->IsoSurface.get();
}

InkSilhouetteMethod* vtkInkContoursStyle::GetSilhouetteMethod()
{
  return this->Method.get();
}

const char* vtkInkContoursStyle::GetPieceName(int piece)
{
  static const char* const names[] = { "Contoured", "Surface" };
  return piece >= 0 && piece < this->GetNumberOfPieces() ? names[piece] : nullptr;
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
  const std::string wanted = "expected an image or a mesh with polygons, found ";
  const InkLeaves leaves(data, this->IsoSurface->GetScalars());
  const std::string problem = leaves.Problem.empty() ? leaves.FindImageProblem() : leaves.Problem;
  if (!data || !problem.empty())
  {
    return wanted + (data ? problem : "nothing");
  }
  const auto isPoints = [](vtkDataSet* leaf)
  {
    auto* mesh = vtkPolyData::SafeDownCast(leaf);
    return mesh && !InkHasPolygons(mesh) && !InkIsOfLines(mesh);
  };
  const bool hasPoints = !leaves.Stipples.empty() || !leaves.Others.empty();
  const bool onlyPoints =
    leaves.Images.empty() && std::all_of(leaves.Others.begin(), leaves.Others.end(), isPoints);
  return !onlyPoints ? std::string()
                     : wanted +
      (hasPoints ? "points without polygons (Illustration and Splatting Lines draw points)" : "no points");
}

std::string vtkInkContoursStyle::MakePieces(const Input& input)
{
  const InkLeaves leaves(input.Data, this->IsoSurface->GetScalars());
  // Processes without a part of the image take part, too.
  double images = leaves.Images.empty() ? 0.0 : 1.0;
  this->GetProcesses().TakeGreatest({ &images, 1 });
  // Where others have a part of the data, none is no mistake.
  const std::string reason = input.Port && !input.Data ? std::string() : this->GetReasonAgainst(input.Data);
  if (images == 0.0)
  {
    return this->TakeMesh(input, leaves, reason);
  }
  const bool ofVoxels = this->Method->NeedsVoxels();
  std::string problem;
  if (!ofVoxels || this->OnSurface)
  {
    problem = this->MakeSurface(input, leaves, this->GetPiece(ofVoxels ? SURFACE : CONTOURED));
  }
  if (ofVoxels && problem.empty())
  {
    problem = this->Method->MakeVoxels(this, leaves.Images, this->GetPiece(CONTOURED));
  }
  if (problem.empty() && reason.empty())
  {
    this->IsoSurface->TakeFrame(this, input, leaves.Images, !ofVoxels || this->OnSurface);
  }
  return !leaves.Images.empty() && !reason.empty() ? reason
    : problem.empty()                              ? leaves.FindBesideImages()
                                                   : problem;
}

std::string vtkInkContoursStyle::MakeSurface(
  const Input& input, const InkLeaves& leaves, vtkPolyData* surface)
{
  std::string problem = this->IsoSurface->Prepare(this, leaves.Images);
  if (problem.empty())
  {
    problem = InkContourSurface(this).MakeOfImages(*this->IsoSurface, leaves.Images, surface);
    if (problem.empty() && !input.Port)
    {
      this->IsoSurface->NoteWhereEmpty(this, surface);
    }
  }
  return problem;
}

std::string vtkInkContoursStyle::TakeMesh(
  const Input& input, const InkLeaves& leaves, const std::string& reason)
{
  if (!input.Port && !reason.empty())
  {
    return reason;
  }
  if (this->Method->NeedsVoxels() && !this->OnSurface)
  {
    return "segments through voxels need an image, found a mesh";
  }
  if (const std::string grids = leaves.DescribeGrids(); !grids.empty())
  {
    this->AddNote(grids);
  }
  // Those of several processes are put together on the first one; all take part.
  const vtkSmartPointer<vtkPolyData> whole = this->GatherMesh(leaves);
  if (!InkHasPolygons(whole))
  {
    return !leaves.Problem.empty() || whole->GetNumberOfPoints() > 0 ? reason : std::string();
  }
  this->SetFramePoints(whole->GetPoints());
  const std::string problem =
    InkContourSurface(this).MakeOfMesh(whole, this->GetPiece(CONTOURED), this->Method->NeedsVoxels());
  return leaves.Problem.empty() ? problem : reason;
}

void vtkInkContoursStyle::ShowPieces(const std::vector<vtkPolyData*>& pieces)
{
  this->Mapper->SetInputDataObject(InkNullIfEmpty(pieces[CONTOURED]));
  this->Mapper->SetSurfaceData(InkNullIfEmpty(pieces[SURFACE]));
  this->Method->Follow();
  this->SetCreases(this->Creases);
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

void vtkInkContoursStyle::SetCreases(bool creases)
{
  this->Creases = creases;
  InkContourSurface::Follow(this->Mapper, creases);
}

void vtkInkContoursStyle::SetTexture(const std::string& file)
{
  std::string problem;
  this->Mapper->SetTexture(InkReadTexture(file, problem));
  this->Texture = file;
  if (!problem.empty())
  {
    vtkErrorMacro("Texture: " << problem);
  }
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
