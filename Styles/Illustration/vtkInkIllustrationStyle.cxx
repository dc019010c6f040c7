// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIllustrationStyle.h"

#include "Core/FormatNumber.h"
#include "InkHasPolygons.h"
#include "InkHasSurface.h"
#include "InkIsoSurface.h"
#include "InkIsoValues.h"
#include "InkLeaves.h"
#include "InkParameter.h"
#include "InkSampledMesh.h"
#include "InkStyleProcesses.h"
#include "InkVolumeValues.h"
#include "vtkInkIllustrationMapper.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleControls.h"
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
struct PresetValues
{
  double LightingExponent; ///< more is lit with a smaller one
  double Distance;
  double StippleSize;
  double PixelsPerStipple;
  double Tau;
  double Phi;
  double Lambda;
  int IsoChoice;
};

/// In the order of the table's entries.
constexpr PresetValues Presets[] = {
  { 1.0, 0.15, 2.2, 8.0, 0.99, 100.0, 2.5, InkIsoSurface::OUTERMOST }, // specimen
  { 1.3, 0.2, 2.2, 8.0, 0.99, 100.0, 2.5, InkIsoSurface::INNER },      // bone
  { 0.7, 0.1, 1.8, 9.0, 0.98, 60.0, 3.5, InkIsoSurface::OUTERMOST },   // skin
  { 0.9, 0.1, 2.0, 7.0, 0.985, 80.0, 3.0, InkIsoSurface::OUTERMOST },  // organ
  { 1.2, 0.3, 2.0, 7.0, 0.995, 150.0, 2.0, InkIsoSurface::OUTERMOST }, // vessel
  { 1.1, 0.05, 2.0, 9.0, 0.995, 150.0, 2.0, InkIsoSurface::OUTERMOST } // machine-part
};

/// The pieces of a surface: those of its lines, and those of its stipples but for silhouettes.
constexpr const char* PieceNames[] = { "Points", "Silhouettes' surface", "Stipples", "Surface", "Numbers",
  "Outer points", "Outer silhouettes' surface", "Outer stipples", "Outer surface", "Outer numbers" };
constexpr int PiecesOfLines = vtkInkSplattingLinesStyle::SILHOUETTES + 1;
constexpr int PiecesOfStipples = vtkInkStippleStyle::SILHOUETTES;
constexpr int PiecesPerSurface = PiecesOfLines + PiecesOfStipples;

bool IsMesh(vtkDataObject* data)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  return mesh && InkHasPolygons(mesh);
}

} // namespace

vtkInkIllustrationStyle::vtkInkIllustrationStyle()
  : IsoValues(std::make_unique<InkIsoValues>())
  , OuterIsoValue(std::make_unique<InkIsoValues>())
{
  this->Mapper->SetMappers(this->Lines->GetLinesMapper(), this->Stipples->GetStippleMapper());
  this->Mapper->SetOuterMappers(this->OuterLines->GetLinesMapper(), this->OuterStipples->GetStippleMapper());
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

InkSilhouettes* vtkInkIllustrationStyle::GetSilhouettes()
{
  return this->Lines->GetSilhouettes();
}

std::string vtkInkIllustrationStyle::GetReasonAgainst(vtkDataObject* data)
{
  return this->Lines->GetReasonAgainst(data);
}

vtkInkIllustrationMapper* vtkInkIllustrationStyle::GetIllustrationMapper()
{
  return this->Mapper;
}

int vtkInkIllustrationStyle::GetNumberOfPieces()
{
  return 2 * PiecesPerSurface;
}

const char* vtkInkIllustrationStyle::GetPieceName(int piece)
{
  return piece >= 0 && piece < this->GetNumberOfPieces() ? PieceNames[piece] : nullptr;
}

std::string vtkInkIllustrationStyle::MakePieces(const Input& input)
{
  const InkLeaves leaves(input.Data, this->GetIsoSurface()->GetScalars());
  double images = leaves.Images.empty() ? 0.0 : 1.0;
  this->GetProcesses().TakeGreatest({ &images, 1 });
  this->GetIsoSurface()->SetIsoValues(this->IsoValues->GetGiven());
  this->IsoValues->Use({});
  this->OuterIsoValue->Use({});
  // Stipples that lie on lines' points take their colors from them.
  const std::string& array = this->Stipples->GetColorBy();
  if (!this->GetInteractive() && !this->Stipples->GetColorMap().empty() && !array.empty())
  {
    // Before lines are made.
    if (const std::string missing = leaves.FindMissingColors(array); !missing.empty())
    {
      return missing;
    }
  }
  const bool ofActive = array.empty() && !this->Stipples->GetColorMap().empty();
  this->Lines->SetColorArray(
    { .Name = array, .Active = ofActive, .InOrder = this->Stipples->TakesLabelsInOrder() });
  if (images == 0.0)
  {
    return this->MakeMesh(input, leaves);
  }
  if (!this->SeeThrough)
  {
    const std::string problem = this->MakeSurface(this->Lines, this->Stipples, 0, input);
    this->IsoValues->Use(this->GetIsoSurface()->GetUsedIsoValues());
    if (ofActive && !this->GetIsoSurface()->GetSampler()->GetLabelMap())
    {
      this->AddNote(
        "colors are those of the array whose surface is drawn, nearly one value on all of it; another "
        "array can be given (ColorBy, --color-by)");
    }
    return problem;
  }
  if (const std::string problem = this->ChooseSurfaces(leaves); !problem.empty())
  {
    return problem;
  }
  const std::string inner = this->MakeSurface(this->Lines, this->Stipples, 0, input);
  const std::string outer = this->MakeSurface(this->OuterLines, this->OuterStipples, PiecesPerSurface, input);
  // It is around the other.
  this->SetFramePoints(this->OuterLines->GetFramePoints());
  return inner.empty() ? outer : inner;
}

InkIsoSurface* vtkInkIllustrationStyle::GetSampledSurface()
{
  // See-through there are two surfaces, each with points of its own; colors are those of an image.
  if (this->SeeThrough || !this->Stipples->GetColorMap().empty())
  {
    return nullptr;
  }
  this->GetIsoSurface()->SetIsoValues(this->IsoValues->GetGiven());
  return this->GetIsoSurface();
}

std::string vtkInkIllustrationStyle::MakeMesh(const Input& input, const InkLeaves& leaves)
{
  const std::string reason = this->GetReasonAgainst(input.Data);
  if (!input.Port && !reason.empty())
  {
    return reason;
  }
  if (const std::string grids = leaves.DescribeGrids(); !grids.empty())
  {
    this->AddNote(grids);
  }
  // Those of several processes are put together on the first one; all take part.
  const vtkSmartPointer<vtkPolyData> whole = this->GatherMesh(leaves);
  const std::string problem =
    this->MakeSurface(this->Lines, this->Stipples, 0, { whole, input.Port, nullptr, true });
  return !leaves.Problem.empty() ? reason : whole->GetNumberOfPoints() == 0 ? std::string() : problem;
}

std::string vtkInkIllustrationStyle::MakeSurface(
  vtkInkSplattingLinesStyle* lines, vtkInkStippleStyle* stipples, int firstPiece, const Input& input)
{
  std::string problem = this->MakeMarksOf(lines, input);
  for (int piece = 0; piece < PiecesOfLines; ++piece)
  {
    this->GetPiece(firstPiece + piece)->ShallowCopy(lines->GetPiece(piece));
  }
  this->SetFramePoints(lines->GetFramePoints());
  // All processes take part where there are several.
  if (input.Port || this->GetPiece(firstPiece)->GetNumberOfPoints() > 0)
  {
    const std::string ofStipples = this->MakeMarksOf(
      stipples, { IsMesh(input.Data) ? input.Data : this->GetPiece(firstPiece), nullptr, nullptr, true });
    problem = problem.empty() ? ofStipples : problem;
    for (int piece = 0; piece < PiecesOfStipples; ++piece)
    {
      this->GetPiece(firstPiece + PiecesOfLines + piece)->ShallowCopy(stipples->GetPiece(piece));
    }
  }
  return problem;
}

std::string vtkInkIllustrationStyle::ChooseSurfaces(const InkLeaves& leaves)
{
  InkIsoSurface* inner = this->GetIsoSurface();
  InkIsoSurface* outer = this->OuterLines->GetIsoSurface();
  outer->CopyParameters(*inner);
  std::vector<double> outerValue = this->OuterIsoValue->GetGiven();
  std::vector<double> innerValues = this->IsoValues->GetGiven();
  if (outerValue.empty() || innerValues.empty())
  {
    std::vector<ink::IsoSuggestion> suggestions = InkIsoSurface::Suggest(this, leaves.Images);
    std::sort(
      suggestions.begin(), suggestions.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
    // The surface at the lower value is around that at the higher one.
    const auto choose = [&](std::vector<double>& values, const char* which, const auto& suits)
    {
      const auto found = std::find_if(suggestions.begin(), suggestions.end(), suits);
      if (values.empty() && found != suggestions.end())
      {
        values = { found->value };
        this->AddNote(which + (" iso-value " + ink::formatNumber(found->value)) + ": " + InkDescribe(*found));
      }
    };
    choose(outerValue, "outer",
      [&](const auto& one) {
        return innerValues.empty() || one.value < *std::min_element(innerValues.begin(), innerValues.end());
      });
    // Within skin rather bone than flesh.
    std::stable_partition(suggestions.begin(), suggestions.end(),
      [](const auto& one) { return one.boundary == ink::IsoSuggestion::Boundary::Bone; });
    choose(innerValues, "inner",
      [&](const auto& one) { return !outerValue.empty() && one.value > outerValue.front(); });
  }
  if (outerValue.empty() || innerValues.empty())
  {
    return "see-through: expected an image with two clear boundaries, found " +
      std::string(outerValue.empty() && innerValues.empty() ? "none" : "no second one") +
      "; an inner and an outer iso-value can be given";
  }
  this->IsoValues->Use(innerValues);
  this->OuterIsoValue->Use(outerValue);
  inner->SetIsoValues(innerValues);
  outer->SetIsoValues(outerValue);
  this->OuterStipples->SetNumberOfSurfaceStipples(this->Stipples->GetNumberOfSurfaceStipples());
  this->OuterStipples->SetSizeUnit(this->Stipples->GetSizeUnit());
  this->OuterStipples->SetStippleSize(this->Stipples->GetStippleSize());
  this->OuterStipples->SetPixelsPerStipple(this->Stipples->GetPixelsPerStipple());
  return {};
}

void vtkInkIllustrationStyle::ShowPieces(const std::vector<vtkPolyData*>& pieces)
{
  const auto show = [&](vtkInkSplattingLinesStyle* lines, vtkInkStippleStyle* stipples, int first)
  {
    const auto begin = pieces.begin() + first;
    lines->ShowPieces(std::vector<vtkPolyData*>(begin, begin + PiecesOfLines));
    std::vector<vtkPolyData*> ofStipples(begin + PiecesOfLines, begin + PiecesPerSurface);
    ofStipples.push_back(nullptr);
    stipples->ShowPieces(ofStipples);
  };
  show(this->Lines, this->Stipples, 0);
  show(this->OuterLines, this->OuterStipples, PiecesPerSurface);
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

int vtkInkIllustrationStyle::GetColoredPiece()
{
  return PiecesOfLines + vtkInkStippleStyle::STIPPLES;
}

void vtkInkIllustrationStyle::SetColorByScalars(bool byScalars)
{
  this->Stipples->SetColorByScalars(byScalars);
}

bool vtkInkIllustrationStyle::GetColorByScalars()
{
  return this->Stipples->GetColorByScalars();
}

void vtkInkIllustrationStyle::SetColorArray(const std::string& name, int association)
{
  this->Stipples->SetColorArray(name, association);
}

void vtkInkIllustrationStyle::SetPreset(int preset)
{
  this->Preset = std::clamp(preset, 0, static_cast<int>(std::size(Presets)) - 1);
  const PresetValues& values = Presets[this->Preset];
  vtkInkStippleMapper* stipples = this->Stipples->GetStippleMapper();
  stipples->SetLightingExponent(values.LightingExponent);
  this->Stipples->GetControls()->SetDistance(values.Distance);
  this->Stipples->SetStippleSize(values.StippleSize);
  this->Stipples->SetPixelsPerStipple(values.PixelsPerStipple);
  vtkInkSplattingLinesMapper* lines = this->Lines->GetLinesMapper();
  lines->SetTau(values.Tau);
  lines->SetPhi(values.Phi);
  lines->SetLambda(values.Lambda);
  this->GetIsoSurface()->SetIsoChoice(values.IsoChoice);
}

void vtkInkIllustrationStyle::SetIsoValues(const std::vector<double>& values)
{
  if (this->IsoValues->Give(values))
  {
    this->Modified();
  }
}

void vtkInkIllustrationStyle::SetOuterIsoValue(const std::vector<double>& value)
{
  if (this->OuterIsoValue->Give(value) && this->SeeThrough)
  {
    this->Modified();
  }
}

const std::vector<double>& vtkInkIllustrationStyle::GetIsoValues()
{
  return this->IsoValues->GetGiven();
}

const std::vector<double>& vtkInkIllustrationStyle::GetOuterIsoValue()
{
  return this->OuterIsoValue->GetGiven();
}

const std::vector<double>& vtkInkIllustrationStyle::GetUsedOuterIsoValue()
{
  return this->OuterIsoValue->GetUsed();
}

void vtkInkIllustrationStyle::SetInkColor(double red, double green, double blue)
{
  this->Lines->SetInkColor(red, green, blue);
  this->Stipples->SetInkColor(red, green, blue);
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
