// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleStyle.h"

#include "InkAimLight.h"
#include "InkColorMap.h"
#include "InkIsoSurface.h"
#include "InkLeaves.h"
#include "InkNullIfEmpty.h"
#include "InkParameter.h"
#include "InkProbeColors.h"
#include "InkSilhouettes.h"
#include "InkStippleNumbers.h"
#include "InkStippleRecipe.h"
#include "vtkInkSilhouetteMapper.h"
#include "vtkInkStippleActor.h"
#include "vtkInkStippleControls.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"
#include "vtkInkSurfaceSampler.h"

#include "Tone/Lightness.h"

#include "vtkCellData.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkInkStippleStyle);

/// Generated from parameters.json.
const InkParameterTable& InkStippleParameters();

vtkInkStippleStyle::vtkInkStippleStyle()
  : Silhouettes(std::make_unique<InkSilhouettes>(this->Mapper))
  , IsoSurface(std::make_unique<InkIsoSurface>())
{
  this->Actor->SetMapper(this->Mapper);
  this->SurfaceSampler->ComputePriorityOff();
  this->Mapper->SetScalarModeToUseCellData();
  this->Mapper->UseLookupTableScalarRangeOn();
  // Bytes, too: VTK takes them for colors otherwise.
  this->Mapper->SetColorModeToMapScalars();
  this->SetLightDirection(this->LightDirection[0], this->LightDirection[1]);
  // A slider sets what it stands for, and nothing else: what was chosen for the rest stays.
  this->Controls->SetMapper(this->Mapper);
  this->SetPreset(0);
}

vtkInkStippleStyle::~vtkInkStippleStyle() = default;

const char* vtkInkStippleStyle::GetDescription()
{
  return "dots whose density is the tone: boundaries, silhouettes and light of volumes and meshes (Lu et al. "
         "2003)";
}

const InkParameterTable& vtkInkStippleStyle::GetParameterTable()
{
  return InkStippleParameters();
}

const char* vtkInkStippleStyle::GetPieceName(int piece)
{
  static const char* const names[] = { "Stipples", "Surface", "Numbers", "Silhouettes' surface" };
  return piece >= 0 && piece < this->GetNumberOfPieces() ? names[piece] : nullptr;
}

vtkMapper* vtkInkStippleStyle::GetMapper()
{
  return this->Mapper;
}

vtkActor* vtkInkStippleStyle::GetActor()
{
  return this->Actor;
}

vtkInkStippleGenerator* vtkInkStippleStyle::GetGenerator()
{
  return this->Generator;
}

vtkInkStippleMapper* vtkInkStippleStyle::GetStippleMapper()
{
  return this->Mapper;
}

vtkInkStippleControls* vtkInkStippleStyle::GetControls()
{
  return this->Controls;
}

InkIsoSurface* vtkInkStippleStyle::GetIsoSurface()
{
  return this->IsoSurface.get();
}

InkSilhouettes* vtkInkStippleStyle::GetSilhouettes()
{
  return this->Silhouettes.get();
}

vtkMTimeType vtkInkStippleStyle::GetRecipeMTime()
{
  // As InkStippleRecipe takes the values: interactively, for stipples on their surfaces only.
  const bool ofValues = this->StippleSource == ISO_SURFACE ||
    (!this->GetInteractive() && (this->StippleSource == AUTOMATIC || this->Silhouettes->GetSilhouettes()));
  return std::max(
    { this->Generator->GetMTime(), this->IsoSurface->GetMTime(ofValues), this->Silhouettes->GetMTime() });
}

bool vtkInkStippleStyle::DrawsSurfaces(const Input& input) const
{
  // Of data that comes from a port, in ParaView say, no surface is chosen unasked.
  return this->StippleSource == ISO_SURFACE || (this->StippleSource == AUTOMATIC && !input.Port);
}

void vtkInkStippleStyle::GetBackgroundColor(double color[3])
{
  std::copy_n(this->PaperColor, 3, color);
}

void vtkInkStippleStyle::SetColorByScalars(bool byScalars)
{
  this->Mapper->SetScalarVisibility(byScalars);
}

bool vtkInkStippleStyle::GetColorByScalars()
{
  return this->Mapper->GetScalarVisibility();
}

std::string vtkInkStippleStyle::GetReasonAgainst(vtkDataObject* data)
{
  const std::string wanted = "expected an image, a mesh, points or stipples, found ";
  const InkLeaves leaves(data, this->IsoSurface->GetScalars());
  if (!leaves.Problem.empty())
  {
    return wanted + leaves.Problem;
  }
  const std::size_t count = leaves.Images.size() + leaves.Stipples.size() + leaves.Others.size();
  return count == 0 ? wanted + "data without points" : std::string();
}

std::string vtkInkStippleStyle::MakePieces(const Input& input)
{
  return InkStippleRecipe(this).Make(input);
}

void vtkInkStippleStyle::ShowPieces(const std::vector<vtkPolyData*>& pieces)
{
  vtkPolyData* stipples = pieces[STIPPLES];
  vtkPolyData* surface = pieces[SURFACE];
  vtkPolyData* numbers = pieces[NUMBERS];
  this->Silhouettes->Show(pieces[SILHOUETTES], surface);
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
    InkReadNumbers(numbers, this->Drawn);
  }
  this->Mapper->SetInputDataObject(this->Drawn);
  this->Mapper->SetSurfaceData(InkNullIfEmpty(surface));
  this->UpdateColors();
  this->UpdatePixels();
}

void vtkInkStippleStyle::UpdatePixels()
{
  const double scale = this->SizeUnit == vtkInkStippleMapper::PIXELS ? this->GetPixelScale() : 1.0;
  this->Silhouettes->SetPixelScale(this->GetPixelScale());
  this->Mapper->SetSizeUnit(this->SizeUnit);
  this->Mapper->SetStippleSize(scale * this->StippleSize);
  this->Mapper->SetPixelsPerStipple(scale * scale * this->PixelsPerStipple);
}

void vtkInkStippleStyle::UpdateColors()
{
  if (this->ColorMap.empty())
  {
    return;
  }
  vtkDataArray* scalars = this->Drawn->GetCellData()->GetScalars();
  this->Mapper->SetScalarVisibility(scalars != nullptr);
  if (scalars)
  {
    const bool isOrder = scalars->GetName() && std::string(scalars->GetName()) == InkLabelOrderName;
    const std::vector<double> range = isOrder ? std::vector{ 0.0, 1.0 } : this->ColorRange;
    this->Mapper->SetLookupTable(InkMakeColors(this->ColorMap, range, scalars));
  }
}

void vtkInkStippleStyle::FollowParameters(const Settings& given)
{
  const auto has = [&](const char* name)
  { return std::any_of(given.begin(), given.end(), [name](const auto& one) { return one.first == name; }); };
  if ((has("InkColor") || has("PaperColor")) && !has("LightInk"))
  {
    this->Mapper->SetLightInk(ink::lightness(this->Mapper->GetInkColor()) > ink::lightness(this->PaperColor));
  }
}

void vtkInkStippleStyle::SetPreset(int preset)
{
  this->Controls->SetPreset(vtkInkStippleControls::GetPresetName(preset));
  this->Controls->GetPaperColor(this->PaperColor);
  this->Silhouettes->SetInkColor(this->Mapper->GetInkColor());
  const bool asPublished = std::string(this->Controls->GetPreset()) == "as-published";
  this->Silhouettes->GetMethod()->SetMethod(
    asPublished ? vtkInkSilhouetteMapper::VOXEL_SEGMENTS : vtkInkSilhouetteMapper::CHAINS);
  this->SizeUnit = this->Mapper->GetSizeUnit();
  this->StippleSize = this->Mapper->GetStippleSize();
  this->PixelsPerStipple = this->Mapper->GetPixelsPerStipple();
  this->UpdatePixels();
}

int vtkInkStippleStyle::GetPreset()
{
  int preset = 0;
  while (std::string(vtkInkStippleControls::GetPresetName(preset)) != this->Controls->GetPreset())
  {
    ++preset;
  }
  return preset;
}

void vtkInkStippleStyle::SetLightDirection(double azimuth, double elevation)
{
  this->LightDirection[0] = azimuth;
  this->LightDirection[1] = elevation;
  InkAimLight(this->Light, this->LightDirection);
}

void vtkInkStippleStyle::SetInkColor(double red, double green, double blue)
{
  this->Mapper->SetInkColor(red, green, blue);
  this->Silhouettes->SetInkColor(this->Mapper->GetInkColor());
}

double* vtkInkStippleStyle::GetInkColor()
{
  return this->Mapper->GetInkColor();
}

void vtkInkStippleStyle::SetPaperColor(double red, double green, double blue)
{
  this->PaperColor[0] = red;
  this->PaperColor[1] = green;
  this->PaperColor[2] = blue;
}

void vtkInkStippleStyle::SetSizeUnit(int unit)
{
  this->SizeUnit = std::clamp<int>(unit, vtkInkStippleMapper::THOUSANDTHS, vtkInkStippleMapper::PIXELS);
  this->UpdatePixels();
}

void vtkInkStippleStyle::SetStippleSize(double size)
{
  this->StippleSize = size;
  this->UpdatePixels();
}

void vtkInkStippleStyle::SetPixelsPerStipple(double pixels)
{
  this->PixelsPerStipple = pixels;
  this->UpdatePixels();
}

void vtkInkStippleStyle::SetColorArray(const std::string& name, int association)
{
  if (this->ColorBy != name || this->ColorAssociation != association)
  {
    this->ColorBy = name;
    this->ColorAssociation = association;
    this->Modified();
  }
}

void vtkInkStippleStyle::SetColorMap(const std::string& map)
{
  if (this->ColorMap != map)
  {
    this->ColorMap = map;
    this->Mapper->SetScalarVisibility(false);
    // Stipples may have to be given scalars.
    this->Modified();
    this->UpdateColors();
  }
}

void vtkInkStippleStyle::SetColorRange(const std::vector<double>& range)
{
  if (range.empty() != this->ColorRange.empty())
  {
    // Stipples of labels may have to be given others.
    this->Modified();
  }
  this->ColorRange = range;
  this->UpdateColors();
}

void vtkInkStippleStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Generator:\n";
  this->Generator->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
