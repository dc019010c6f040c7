// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIllustrationStyle.h"

#include "InkIsoSurface.h"
#include "InkParameter.h"
#include "InkStyleProcesses.h"
#include "InkSurfaceKind.h"
#include "vtkInkIllustrationMapper.h"
#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleMapper.h"
#include "vtkInkStippleStyle.h"

#include "Tone/Lightness.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkInkIllustrationStyle);

/// Generated from parameters.json.
const InkParameterTable& InkIllustrationParameters();

namespace
{

/// What suits a kind of subject.
struct Subject
{
  double LightingExponent; ///< more is lit with a smaller one
  double Distance;
  double StippleSize;
  double PixelsPerStipple;
  double Tau;
  double Phi;
  double Lambda;
};

/// In the order of the table's entries.
constexpr Subject Presets[] = {
  { 1.0, 0.15, 2.2, 8.0, 0.99, 100.0, 2.5 }, // specimen
  { 1.3, 0.2, 2.2, 8.0, 0.99, 100.0, 2.5 },  // bone
  { 0.7, 0.1, 1.8, 9.0, 0.98, 60.0, 3.5 },   // skin
  { 0.9, 0.1, 2.0, 7.0, 0.985, 80.0, 3.0 },  // organ
  { 1.2, 0.3, 2.0, 7.0, 0.995, 150.0, 2.0 }, // vessel
  { 1.1, 0.05, 2.0, 9.0, 0.995, 150.0, 2.0 } // machine-part
};

bool IsMesh(vtkDataObject* data)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  return mesh && InkHasPolygons(mesh);
}

} // namespace

vtkInkIllustrationStyle::vtkInkIllustrationStyle()
{
  this->Mapper->SetMappers(this->Lines->GetLinesMapper(), this->Stipples->GetStippleMapper());
  this->Actor->SetMapper(this->Mapper);
  this->SetPreset(0);
}

vtkInkIllustrationStyle::~vtkInkIllustrationStyle() = default;

const char* vtkInkIllustrationStyle::GetDescription()
{
  return "stipples that shade iso-surfaces, meshes and points, with splatting lines that outline them";
}

const InkParameterTable& vtkInkIllustrationStyle::GetParameterTable()
{
  return InkIllustrationParameters();
}

vtkMTimeType vtkInkIllustrationStyle::GetRecipeMTime()
{
  return std::max(this->Lines->GetMTime(), this->Stipples->GetMTime());
}

vtkMapper* vtkInkIllustrationStyle::GetMapper()
{
  return this->Mapper;
}

vtkLight* vtkInkIllustrationStyle::GetLight()
{
  return this->Stipples->GetLight();
}

vtkInkSplattingLinesStyle* vtkInkIllustrationStyle::GetLinesStyle()
{
  return this->Lines;
}

vtkInkStippleStyle* vtkInkIllustrationStyle::GetStippleStyle()
{
  return this->Stipples;
}

InkIsoSurface* vtkInkIllustrationStyle::GetIsoSurface()
{
  return this->Lines->GetIsoSurface();
}

std::string vtkInkIllustrationStyle::GetReasonAgainst(vtkDataObject* data)
{
  return this->Lines->GetReasonAgainst(data);
}

int vtkInkIllustrationStyle::GetNumberOfPieces()
{
  return this->Lines->GetNumberOfPieces() + this->Stipples->GetNumberOfPieces();
}

const char* vtkInkIllustrationStyle::GetPieceName(int piece)
{
  const int lines = this->Lines->GetNumberOfPieces();
  return piece < lines ? this->Lines->GetPieceName(piece) : this->Stipples->GetPieceName(piece - lines);
}

bool vtkInkIllustrationStyle::FindImages(vtkDataObject* data)
{
  auto* image = vtkImageData::SafeDownCast(data);
  double images = image && image->GetNumberOfPoints() > 0 ? 1.0 : 0.0;
  this->GetProcesses().TakeGreatest({ &images, 1 });
  return images > 0.0;
}

std::string vtkInkIllustrationStyle::MakePieces(const Input& input)
{
  Input own = input;
  vtkSmartPointer<vtkPolyData> whole;
  if (auto* mesh = vtkPolyData::SafeDownCast(input.Data); input.Port && !this->FindImages(input.Data))
  {
    // Meshes and points of several processes are put together on the first one.
    whole = this->GetProcesses().Gather(
      { mesh ? vtkSmartPointer<vtkPolyData>(mesh) : vtkSmartPointer<vtkPolyData>::New() });
    own = { whole };
  }
  // All processes take part, also those that have no points.
  const bool isEmpty = whole && whole->GetNumberOfPoints() == 0;
  std::string problem = this->MakeMarksOf(this->Lines, own);
  if (isEmpty)
  {
    problem.clear();
  }
  else
  {
    this->GetPiece(0)->ShallowCopy(this->Lines->GetPiece(0));
    this->SetFramePoints(this->Lines->GetFramePoints());
  }
  // All processes take part where there are several.
  if (input.Port || (problem.empty() && this->GetPiece(0)->GetNumberOfPoints() > 0))
  {
    const std::string ofStipples =
      this->MakeMarksOf(this->Stipples, { IsMesh(own.Data) ? own.Data : this->GetPiece(0) });
    problem = problem.empty() ? ofStipples : problem;
    for (int piece = 0; piece < this->Stipples->GetNumberOfPieces(); ++piece)
    {
      this->GetPiece(1 + piece)->ShallowCopy(this->Stipples->GetPiece(piece));
    }
  }
  return problem;
}

void vtkInkIllustrationStyle::ShowPieces(const std::vector<vtkPolyData*>& pieces)
{
  this->Lines->ShowPieces({ pieces[0] });
  this->Stipples->ShowPieces({ pieces.begin() + 1, pieces.end() });
  this->Mapper->SetInputDataObject(pieces[0]);
}

void vtkInkIllustrationStyle::UpdatePixels()
{
  this->Lines->SetPixelScale(this->GetPixelScale());
  this->Stipples->SetPixelScale(this->GetPixelScale());
}

void vtkInkIllustrationStyle::GetBackgroundColor(double color[3])
{
  this->Stipples->GetBackgroundColor(color);
}

void vtkInkIllustrationStyle::SetColorByScalars(bool byScalars)
{
  this->Lines->SetColorByScalars(byScalars);
  this->Stipples->SetColorByScalars(byScalars);
}

bool vtkInkIllustrationStyle::GetColorByScalars()
{
  return this->Lines->GetColorByScalars();
}

void vtkInkIllustrationStyle::SetPreset(int preset)
{
  this->Preset = std::clamp(preset, 0, static_cast<int>(std::size(Presets)) - 1);
  const Subject& values = Presets[this->Preset];
  vtkInkStippleMapper* stipples = this->Stipples->GetStippleMapper();
  stipples->SetLightingExponent(values.LightingExponent);
  this->Stipples->SetDistance(values.Distance);
  this->Stipples->SetStippleSize(values.StippleSize);
  this->Stipples->SetPixelsPerStipple(values.PixelsPerStipple);
  vtkInkSplattingLinesMapper* lines = this->Lines->GetLinesMapper();
  lines->SetTau(values.Tau);
  lines->SetPhi(values.Phi);
  lines->SetLambda(values.Lambda);
}

void vtkInkIllustrationStyle::SetInkColor(double red, double green, double blue)
{
  this->Lines->GetLinesMapper()->SetInkColor(red, green, blue);
  this->Stipples->GetStippleMapper()->SetInkColor(red, green, blue);
  this->UpdateLightInk();
}

double* vtkInkIllustrationStyle::GetInkColor()
{
  return this->Lines->GetLinesMapper()->GetInkColor();
}

void vtkInkIllustrationStyle::SetPaperColor(double red, double green, double blue)
{
  this->Lines->GetLinesMapper()->SetPaperColor(red, green, blue);
  this->Stipples->SetPaperColor(red, green, blue);
  this->UpdateLightInk();
}

double* vtkInkIllustrationStyle::GetPaperColor()
{
  return this->Stipples->GetPaperColor();
}

void vtkInkIllustrationStyle::UpdateLightInk()
{
  // Light ink shows light.
  this->Stipples->GetStippleMapper()->SetLightInk(
    ink::lightness(this->GetInkColor()) > ink::lightness(this->GetPaperColor()));
}

void vtkInkIllustrationStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lines:\n";
  this->Lines->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Stipples:\n";
  this->Stipples->PrintSelf(os, indent.GetNextIndent());
}
