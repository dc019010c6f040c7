// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkContoursStyle.h"

#include "InkHasPolygons.h"
#include "InkIsoSurface.h"
#include "InkParameter.h"
#include "InkVolumeValues.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkActor.h"
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
{
  this->Actor->SetMapper(this->Mapper);
  this->Mapper->SetFeatureAngle(40.0);
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
  return this->IsoSurface->GetMTime();
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
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    const std::string problem = InkFindScalarsProblem(image);
    return problem.empty() ? problem : wanted + problem;
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  return !mesh                       ? wanted + (data ? "a " + std::string(data->GetClassName()) : "nothing")
    : mesh->GetNumberOfPoints() == 0 ? wanted + "no points"
    : !InkHasPolygons(mesh)          ? wanted + "points without polygons"
                                     : std::string();
}

std::string vtkInkContoursStyle::MakePieces(const Input& input)
{
  const std::string reason = this->GetReasonAgainst(input.Data);
  if (!reason.empty())
  {
    return reason;
  }
  auto* mesh = vtkPolyData::SafeDownCast(input.Data);
  this->OfImage = !mesh;
  if (mesh)
  {
    this->SetFramePoints(mesh->GetPoints());
    return this->TakeMeshWithNormals(mesh, true);
  }
  auto* image = vtkImageData::SafeDownCast(input.Data);
  vtkImageData* const images[] = { image };
  const std::string problem = this->IsoSurface->Prepare(this, images, {});
  return problem.empty() ? this->IsoSurface->Mesh(this, image, this->GetPiece(0)) : problem;
}

void vtkInkContoursStyle::ShowPieces(const std::vector<vtkPolyData*>& pieces)
{
  vtkPolyData* surface = pieces[0];
  this->Mapper->SetInputDataObject(surface && surface->GetNumberOfPoints() > 0 ? surface : nullptr);
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
  this->Mapper->SetCreases(creases && !this->OfImage);
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
