// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSplattingLinesStyle.h"

#include "InkParameter.h"
#include "InkVolumeValues.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkSurfaceSampler.h"

#include "IsoSurface/ActiveCellComponents.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"

#include <algorithm>

vtkStandardNewMacro(vtkInkSplattingLinesStyle);

/// Generated from parameters.json.
const InkParameterTable& InkSplattingLinesParameters();

namespace
{

constexpr int MostLayers = 8;

bool HasPolygons(vtkPolyData* mesh)
{
  return mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0;
}

} // namespace

vtkInkSplattingLinesStyle::vtkInkSplattingLinesStyle()
{
  this->Actor->SetMapper(this->Mapper);
  this->Mapper->UseLookupTableScalarRangeOn();
  this->Mapper->SetColorModeToMapScalars();
  this->IsoSurfaceSampler->GenerateVerticesOff();
  this->IsoSurfaceSampler->SetCutToRim();
  this->IsoSurfaceSampler->SetSmallestPart(ink::ComponentSelection::automatic);
  this->SurfaceSampler->ComputePriorityOff();
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
  return std::max(this->IsoSurfaceSampler->GetMTime(), this->SurfaceSampler->GetMTime());
}

vtkMapper* vtkInkSplattingLinesStyle::GetMapper()
{
  return this->Mapper;
}

vtkInkIsoSurfaceSampler* vtkInkSplattingLinesStyle::GetIsoSurfaceSampler()
{
  return this->IsoSurfaceSampler;
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
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    return !scalars ? wanted + "an image without point scalars"
      : scalars->GetNumberOfComponents() != 1
      ? wanted + "an image with " + std::to_string(scalars->GetNumberOfComponents()) + " scalars a point"
      : std::string();
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  return !mesh                       ? wanted + (data ? "a " + std::string(data->GetClassName()) : "nothing")
    : mesh->GetNumberOfPoints() == 0 ? wanted + "no points"
                                     : std::string();
}

std::string vtkInkSplattingLinesStyle::MakePieces(const Input& input)
{
  if (std::string reason = this->GetReasonAgainst(input.Data); !reason.empty())
  {
    return reason;
  }
  if (auto* image = vtkImageData::SafeDownCast(input.Data))
  {
    return this->SampleImage(image);
  }
  auto* mesh = vtkPolyData::SafeDownCast(input.Data);
  if (HasPolygons(mesh))
  {
    this->SetFramePoints(mesh->GetPoints());
  }
  return this->NumberOfSamples == 0 && HasPolygons(mesh) ? this->TakeVertices(mesh) : this->SampleMesh(mesh);
}

std::string vtkInkSplattingLinesStyle::SampleImage(vtkImageData* image)
{
  std::vector<double> values = this->IsoValues;
  if (values.empty())
  {
    const auto chosen = this->ChooseIsoValue(image);
    if (!chosen)
    {
      return "expected an image with two different finite values or more, found none";
    }
    values.push_back(*chosen);
  }
  vtkInkIsoSurfaceSampler* sampler = this->IsoSurfaceSampler;
  sampler->SetInputData(image);
  sampler->SetNumberOfContours(static_cast<int>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    sampler->SetValue(static_cast<int>(i), values[i]);
  }
  const std::string problem = this->Follow(sampler, "sampling the surface");
  this->GetPiece(0)->ShallowCopy(sampler->GetOutput());
  sampler->SetInputData(nullptr);
  if (problem.empty() && this->GetPiece(0)->GetNumberOfPoints() == 0)
  {
    this->AddNote("nothing to draw: no surface at iso-value " + InkFormatShort(values.front()));
  }
  return problem;
}

vtkIdType vtkInkSplattingLinesStyle::CountForMesh(vtkPolyData* mesh)
{
  return std::clamp<vtkIdType>(2 * mesh->GetNumberOfPoints(), 200'000, 1'000'000);
}

std::string vtkInkSplattingLinesStyle::SampleMesh(vtkPolyData* mesh)
{
  vtkInkSurfaceSampler* sampler = this->SurfaceSampler;
  sampler->SetInputData(mesh);
  sampler->SetNumberOfSamples(this->NumberOfSamples > 0 ? this->NumberOfSamples : CountForMesh(mesh));
  const bool isCloud = !HasPolygons(mesh);
  const std::string problem = this->Follow(sampler, isCloud ? "looking at the points" : "sampling the mesh");
  // The sampler's own output is another mesh's when it is asked again.
  this->GetPiece(0)->ShallowCopy(sampler->GetOutput());
  if (problem.empty() && isCloud)
  {
    const bool estimated = sampler->GetComputeNormals() && !mesh->GetPointData()->GetNormals();
    this->AddNote("there are no polygons; the " + std::to_string(mesh->GetNumberOfPoints()) +
      " points are taken as they are" + (estimated ? ", with normals estimated from their neighbors" : ""));
    if (const vtkIdType isolated = sampler->GetNumberOfIsolatedPoints(); isolated > 0)
    {
      this->AddNote(std::to_string(isolated) + " points that are far from all others are left out");
    }
  }
  if (problem.empty() && this->GetPiece(0)->GetNumberOfPoints() == 0)
  {
    this->AddNote("nothing to draw: no point was made on the mesh");
  }
  return problem;
}

std::string vtkInkSplattingLinesStyle::TakeVertices(vtkPolyData* mesh)
{
  vtkPolyData* points = this->GetPiece(0);
  points->ShallowCopy(mesh);
  vtkPointData* pointData = points->GetPointData();
  vtkDataArray* named = pointData->GetArray("Normals");
  if (named && named->GetNumberOfComponents() == 3 && !pointData->GetNormals())
  {
    pointData->SetNormals(named);
  }
  if (pointData->GetNormals())
  {
    return {};
  }
  // The points stay what they are.
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  const std::string problem = this->Follow(normals, "computing normals");
  points->ShallowCopy(normals->GetOutput());
  this->AddNote("the mesh has no normals; they are computed from its polygons");
  return problem;
}

void vtkInkSplattingLinesStyle::ShowPieces(const std::vector<vtkPolyData*>& pieces)
{
  this->Mapper->SetInputDataObject(pieces[0]);
  this->UpdateColors();
}

void vtkInkSplattingLinesStyle::UpdatePixels()
{
  this->Mapper->SetSpeckleLength(this->GetPixelScale() * this->SpeckleLength);
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

void vtkInkSplattingLinesStyle::SetIsoValues(const std::vector<double>& values)
{
  if (this->IsoValues != values)
  {
    this->IsoValues = values;
    this->Modified();
  }
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
