// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSplattingLinesStyle.h"

#include "InkIsoSurface.h"
#include "InkLeaves.h"
#include "InkParameter.h"
#include "InkProbeColors.h"
#include "InkSilhouettes.h"
#include "InkStyleProcesses.h"
#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkSurfaceSampler.h"

#include "IsoSurface/ActiveCellComponents.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>

vtkStandardNewMacro(vtkInkSplattingLinesStyle);

/// Generated from parameters.json.
const InkParameterTable& InkSplattingLinesParameters();

namespace
{

constexpr int MostLayers = 8;

} // namespace

vtkInkSplattingLinesStyle::vtkInkSplattingLinesStyle()
  : IsoSurface(std::make_unique<InkIsoSurface>())
  , Silhouettes(std::make_unique<InkSilhouettes>(this->Mapper))
{
  this->Actor->SetMapper(this->Mapper);
  this->Mapper->UseLookupTableScalarRangeOn();
  this->Mapper->SetColorModeToMapScalars();
  this->SurfaceSampler->ComputePriorityOff();
  this->Silhouettes->SetSharpEdges(true);
}

vtkInkSplattingLinesStyle::~vtkInkSplattingLinesStyle() = default;

const char* vtkInkSplattingLinesStyle::GetDescription()
{
  return "lines where the shading of iso-surfaces, meshes and points changes (Zhang et al. 2014)";
}

const InkParameterTable& vtkInkSplattingLinesStyle::GetParameterTable()
{
  return InkSplattingLinesParameters();
}

vtkMTimeType vtkInkSplattingLinesStyle::GetRecipeMTime()
{
  return std::max(
    { this->IsoSurface->GetMTime(), this->SurfaceSampler->GetMTime(), this->Silhouettes->GetMTime() });
}

const char* vtkInkSplattingLinesStyle::GetPieceName(int piece)
{
  static const char* const names[] = { "Points", "Silhouettes' surface" };
  return piece >= 0 && piece < this->GetNumberOfPieces() ? names[piece] : nullptr;
}

vtkMapper* vtkInkSplattingLinesStyle::GetMapper()
{
  return this->Mapper;
}

InkIsoSurface* vtkInkSplattingLinesStyle::GetIsoSurface()
{
  return this->IsoSurface.get();
}

InkSilhouettes* vtkInkSplattingLinesStyle::GetSilhouettes()
{
  return this->Silhouettes.get();
}

vtkInkSurfaceSampler* vtkInkSplattingLinesStyle::GetSurfaceSampler()
{
  return this->SurfaceSampler;
}

vtkInkSplattingLinesMapper* vtkInkSplattingLinesStyle::GetLinesMapper()
{
  return this->Mapper;
}

void vtkInkSplattingLinesStyle::GetBackgroundColor(double color[3])
{
  std::copy_n(this->Background, 3, color);
}

std::string vtkInkSplattingLinesStyle::GetReasonAgainst(vtkDataObject* data)
{
  const std::string wanted = "expected an image, a mesh or points, found ";
  const InkLeaves leaves(data, this->IsoSurface->GetScalars());
  if (!leaves.Problem.empty())
  {
    return wanted + leaves.Problem;
  }
  if (const std::string problem = leaves.FindImageProblem(); !problem.empty())
  {
    return wanted + problem;
  }
  return !data                                                                  ? wanted + "nothing"
    : leaves.Images.empty() && leaves.Stipples.empty() && leaves.Others.empty() ? wanted + "no points"
                                                                                : std::string();
}

std::string vtkInkSplattingLinesStyle::MakePieces(const Input& input)
{
  const InkLeaves leaves(input.Data, this->IsoSurface->GetScalars());
  // Processes without a part of the image take part, too.
  double hasImages = leaves.Images.empty() ? 0.0 : 1.0;
  this->GetProcesses().TakeGreatest({ &hasImages, 1 });
  const bool isEmptyPart = hasImages > 0.0 && leaves.Images.empty();
  const std::string reason = isEmptyPart ? std::string() : this->GetReasonAgainst(input.Data);
  if (hasImages > 0.0)
  {
    return this->SampleImages(input, leaves, reason);
  }
  return this->MakeOfMeshes(input, leaves, reason);
}

std::string vtkInkSplattingLinesStyle::SampleImages(
  const Input& input, const InkLeaves& leaves, const std::string& reason)
{
  // All processes take part, also those whose image cannot be drawn.
  std::string problem = this->IsoSurface->Prepare(this, leaves.Images);
  if (problem.empty())
  {
    problem =
      this->Silhouettes->MakeOfImages(this, *this->IsoSurface, leaves.Images, this->GetPiece(SILHOUETTES));
  }
  problem = reason.empty() ? problem : reason;
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (std::size_t i = 0; i < leaves.Images.size() && problem.empty(); ++i)
  {
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    problem = this->IsoSurface->Sample(this, input, leaves.Images[i], parts.back());
    // Cells' values are those of their centers by now.
    if (!this->Colors.Name.empty() || this->Colors.Active)
    {
      InkProbeColors(leaves.Images[i], this->Colors.Name, this->Colors.InOrder,
        this->IsoSurface->GetSampler(), parts.back());
    }
  }
  this->IsoSurface->KeepParts(this, input, parts);
  if (!parts.empty())
  {
    this->GetPiece(0)->ShallowCopy(InkAppend(parts));
    this->SetFramePoints(this->GetPiece(0)->GetPoints());
  }
  return problem.empty() ? leaves.FindBesideImages() : problem;
}

void vtkInkSplattingLinesStyle::ShowPieces(const std::vector<vtkPolyData*>& pieces)
{
  this->Mapper->SetInputDataObject(pieces[POINTS]);
  this->Silhouettes->Show(pieces[SILHOUETTES], pieces[POINTS]);
  this->UpdateColors();
}

void vtkInkSplattingLinesStyle::UpdatePixels()
{
  this->Mapper->SetSpeckleLength(this->GetPixelScale() * this->SpeckleLength);
  this->Silhouettes->SetPixelScale(this->GetPixelScale());
}

void vtkInkSplattingLinesStyle::UpdateColors()
{
  this->Mapper->SetScalarVisibility(this->ByScalars);
  const int otherwise =
    this->ColorByTone ? vtkInkSplattingLinesMapper::TONE : vtkInkSplattingLinesMapper::INK;
  this->Mapper->SetInkColorMode(this->ByScalars ? vtkInkSplattingLinesMapper::SCALARS : otherwise);
  const std::size_t colors = this->HiddenColor.size() / 3;
  for (int layer = 1; layer < MostLayers; ++layer)
  {
    if (this->UseHiddenColor && colors > 0)
    {
      // Those left take the last.
      const std::size_t color = std::min(static_cast<std::size_t>(layer), colors) - 1;
      this->Mapper->SetLayerColor(layer, &this->HiddenColor[3 * color]);
    }
    else
    {
      this->Mapper->ResetLayerColor(layer);
    }
  }
}

void vtkInkSplattingLinesStyle::SetColorByScalars(bool byScalars)
{
  this->ByScalars = byScalars;
  this->UpdateColors();
}

void vtkInkSplattingLinesStyle::SetInkColor(double red, double green, double blue)
{
  this->Mapper->SetInkColor(red, green, blue);
  this->Silhouettes->SetInkColor(this->Mapper->GetInkColor());
}

double* vtkInkSplattingLinesStyle::GetInkColor()
{
  return this->Mapper->GetInkColor();
}

void vtkInkSplattingLinesStyle::SetBackground(double red, double green, double blue)
{
  this->Background[0] = red;
  this->Background[1] = green;
  this->Background[2] = blue;
}

void vtkInkSplattingLinesStyle::SetLineWidth(double width)
{
  this->Mapper->SetLayerLineWidth(0, width);
}

double vtkInkSplattingLinesStyle::GetLineWidth()
{
  return this->Mapper->GetLayerLineWidth(0);
}

void vtkInkSplattingLinesStyle::SetSpeckleLength(double pixels)
{
  this->SpeckleLength = pixels;
  this->UpdatePixels();
}

void vtkInkSplattingLinesStyle::SetColorByTone(bool byTone)
{
  this->ColorByTone = byTone;
  this->UpdateColors();
}

void vtkInkSplattingLinesStyle::SetHiddenStrength(double strength)
{
  // Layers stay in the proportions that they have by default.
  vtkNew<vtkInkSplattingLinesMapper> standard;
  const double share = strength / standard->GetLayerStrength(1);
  for (int layer = 1; layer < MostLayers; ++layer)
  {
    this->Mapper->SetLayerStrength(layer, share * standard->GetLayerStrength(layer));
  }
}

double vtkInkSplattingLinesStyle::GetHiddenStrength()
{
  return this->Mapper->GetLayerStrength(1);
}

void vtkInkSplattingLinesStyle::SetUseHiddenColor(bool use)
{
  this->UseHiddenColor = use;
  this->UpdateColors();
}

void vtkInkSplattingLinesStyle::SetHiddenColor(const std::vector<double>& colors)
{
  this->HiddenColor = colors;
  this->UpdateColors();
}

void vtkInkSplattingLinesStyle::SetHiddenLineWidth(double width)
{
  for (int layer = 1; layer < MostLayers; ++layer)
  {
    this->Mapper->SetLayerLineWidth(layer, width);
  }
}

double vtkInkSplattingLinesStyle::GetHiddenLineWidth()
{
  return this->Mapper->GetLayerLineWidth(1);
}

void vtkInkSplattingLinesStyle::SetHiddenDashLength(double length)
{
  for (int layer = 1; layer < MostLayers; ++layer)
  {
    this->Mapper->SetLayerDashLength(layer, length);
  }
}

double vtkInkSplattingLinesStyle::GetHiddenDashLength()
{
  return this->Mapper->GetLayerDashLength(1);
}

void vtkInkSplattingLinesStyle::SetCullBackFaces(bool cull)
{
  this->Actor->GetProperty()->SetBackfaceCulling(cull);
}

bool vtkInkSplattingLinesStyle::GetCullBackFaces()
{
  return this->Actor->GetProperty()->GetBackfaceCulling() != 0;
}

void vtkInkSplattingLinesStyle::SetViewpoint(const std::vector<double>& viewpoint)
{
  this->SurfaceSampler->SetOrientTowardsViewpoint(!viewpoint.empty());
  if (!viewpoint.empty())
  {
    this->SurfaceSampler->SetViewpoint(viewpoint.data());
  }
}

std::vector<double> vtkInkSplattingLinesStyle::GetViewpoint()
{
  const double* viewpoint = this->SurfaceSampler->GetViewpoint();
  return this->SurfaceSampler->GetOrientTowardsViewpoint() ? std::vector(viewpoint, viewpoint + 3)
                                                           : std::vector<double>();
}

void vtkInkSplattingLinesStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
