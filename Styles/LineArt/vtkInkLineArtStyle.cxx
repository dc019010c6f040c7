// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkLineArtStyle.h"

#include "InkAimLight.h"
#include "InkContourSurface.h"
#include "InkIsoSurface.h"
#include "InkLeaves.h"
#include "InkMeshTriangles.h"
#include "InkParameter.h"
#include "InkPointNormals.h"
#include "InkSilhouetteMethod.h"
#include "InkStillView.h"
#include "InkStyleProcesses.h"
#include "Mesh/InsideOut.h"
#include "Mesh/SolidMesh.h"
#include "vtkInkContoursStyle.h"
#include "vtkInkHatching.h"
#include "vtkInkLineArtMapper.h"
#include "vtkInkLinesOfCurvature.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkInkLineArtStyle);

/// Generated from parameters.json.
const InkParameterTable& InkLineArtParameters();

namespace
{

/// The distance between strokes in thousandths of the picture's height, with the least and the greatest
/// density.
constexpr double WidestSpacing = 16.0;
constexpr double ClosestSpacing = 2.0;

double SpacingOf(double density)
{
  return WidestSpacing * std::pow(ClosestSpacing / WidestSpacing, density);
}

/// Curvature that bends a surface by so little over the distance of two strokes does not direct them: they
/// follow the form at large instead, in long even lines.
constexpr double NegligibleBend = 0.06;
/// For longer lines than the filter's own, which are more even.
constexpr double StopDistance = 0.35;
constexpr double MinimumLength = 4.0;
/// In distances of strokes: how far a still picture's go on where they are hidden, so that what lies around a
/// stroke counts for its direction and its width.
constexpr double HiddenMargin = 8.0;

/// What strokes are not narrower than, as shares of their distance: by number, and by width.
constexpr double OneWidth = 0.6;
constexpr double LeastWidth = 0.12;

/// A way of drawing.
struct Way
{
  double Density;
  double Tone;
  double Crosshatching;
  double Width;
  double Length;
  double Taper;
  double ContourWidth;
  bool Creases;
};

/// In the order of the table's entries.
constexpr Way Presets[] = {
  { 0.6, 0.5, 0.5, 1.0, 0.0, 0.0, 2.0, false },   // engraving
  { 0.4, 0.45, 0.6, 0.3, 60.0, 0.5, 2.5, false }, // sketch
  { 0.75, 0.4, 0.0, 0.7, 0.0, 0.0, 1.5, true },   // technical
};

/// Turns computed normals of a closed surface outwards: maximum and minimum curvature change places
/// otherwise.
void FaceOutward(vtkPolyData* surface)
{
  if (!ink::isInsideOut(InkMeshTriangles(surface, false, InkMeshTriangles::Order::OfMesh).GetMesh()))
  {
    return;
  }
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  auto turned = vtkSmartPointer<vtkDataArray>::Take(normals->NewInstance());
  turned->DeepCopy(normals);
  for (vtkIdType i = 0; i < turned->GetNumberOfTuples(); ++i)
  {
    const double* normal = normals->GetTuple3(i);
    turned->SetTuple3(i, -normal[0], -normal[1], -normal[2]);
  }
  surface->GetPointData()->SetNormals(turned);
}

/// Whether a surface's inner side is not to be seen, but through holes of a scan, or where an image ends.
/// What has lower values than its surroundings, as the inside of a level set, is seen from within these.
bool HasOutsideOnly(vtkPolyData* surface)
{
  const InkMeshTriangles triangles(surface, true, InkMeshTriangles::Order::OfMesh);
  return InkContourSurface::IsOfImage(surface) ? !ink::facesInward(triangles.GetMesh(), triangles.Normals)
                                               : ink::isSolid(triangles.GetMesh(), triangles.Normals);
}

constexpr const char* PieceNames[] = { "Surface", "Strokes", "Edge voxels" };

} // namespace

vtkInkLineArtStyle::vtkInkLineArtStyle()
{
  this->SetCurvature(OF_IMAGE);
  this->Contours->OnSurfaceOn();
  this->Lines->SetStopDistance(StopDistance);
  this->Lines->SetMinimumLength(MinimumLength);
  this->Lines->CombDirectionsOn();
  this->Strokes->HatchingOn();
  this->Mapper->SetMappers(this->Strokes, this->Contours->GetSilhouetteMapper());
  this->Actor->SetMapper(this->Mapper);
  this->Contours->GetSilhouetteMapper()->SetDepthWidth(0.3);
  InkAimLight(this->Light, this->LightDirection);
  // Parameters are set on the mapper itself.
  this->Strokes->AddObserver(vtkCommand::ModifiedEvent, this, &vtkInkLineArtStyle::UpdateFamilies);
  this->AddObserver(vtkCommand::ModifiedEvent, this, &vtkInkLineArtStyle::UpdateFamilies);
  this->SetPreset(0);
  this->UpdateFamilies();
}

vtkInkLineArtStyle::~vtkInkLineArtStyle() = default;

const char* vtkInkLineArtStyle::GetDescription()
{
  return "hatching along lines of curvature, and contours, of iso-surfaces and meshes (Rössl, Kobbelt and "
         "Seidel 2000)";
}

const InkParameterTable& vtkInkLineArtStyle::GetParameterTable()
{
  return InkLineArtParameters();
}

vtkMTimeType vtkInkLineArtStyle::GetRecipeMTime()
{
  return std::max({ this->Contours->GetMTime(), this->Lines->GetMTime(), this->Hatching->GetMTime() });
}

void vtkInkLineArtStyle::UpdateFamilies()
{
  // The second family is drawn in tones above 1 - crosshatching. A style that is changed while it is shown
  // has it, too, for the slider.
  const bool needsBoth =
    this->GetInteractive() || this->Strokes->GetCrosshatching() > 1.0 - this->Strokes->GetDarkestTone();
  this->Lines->SetFamilies(needsBoth ? vtkInkLinesOfCurvature::BOTH : vtkInkLinesOfCurvature::MAXIMUM);
}

vtkMapper* vtkInkLineArtStyle::GetMapper()
{
  return this->Mapper;
}

InkIsoSurface* vtkInkLineArtStyle::GetIsoSurface()
{
  return this->Contours->GetIsoSurface();
}

vtkInkContoursStyle* vtkInkLineArtStyle::GetContoursStyle()
{
  return this->Contours;
}

vtkInkLinesOfCurvature* vtkInkLineArtStyle::GetLinesOfCurvature()
{
  return this->Lines;
}

vtkInkStrokeMapper* vtkInkLineArtStyle::GetStrokeMapper()
{
  return this->Strokes;
}

const char* vtkInkLineArtStyle::GetPieceName(int piece)
{
  return piece >= 0 && piece < this->GetNumberOfPieces() ? PieceNames[piece] : nullptr;
}

void vtkInkLineArtStyle::GetBackgroundColor(double color[3])
{
  this->Contours->GetBackgroundColor(color);
}

std::string vtkInkLineArtStyle::GetReasonAgainst(vtkDataObject* data)
{
  return this->Contours->GetReasonAgainst(data);
}

double vtkInkLineArtStyle::FindThousandth()
{
  double bounds[6];
  this->GetFramePoints()->GetBounds(bounds);
  const double longest = std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  return longest / (1e3 * this->GetRelativeSize());
}

std::string vtkInkLineArtStyle::MakePieces(const Input& input)
{
  // Processes without a part take part, too.
  const InkLeaves leaves(input.Data);
  double hasNormals = std::any_of(leaves.Others.begin(), leaves.Others.end(),
    [](vtkDataSet* leaf)
    {
      auto* mesh = vtkPolyData::SafeDownCast(leaf);
      return mesh && InkPointNormals(mesh);
    });
  this->GetProcesses().TakeGreatest({ &hasNormals, 1 });
  const std::string problem = this->MakeMarksOf(this->Contours, input);
  vtkPolyData* surface = this->GetPiece(0);
  vtkPolyData* strokes = this->GetPiece(1);
  // Segments through voxels have a piece of their own beside the surface's.
  vtkPolyData* contoured = this->Contours->GetPiece(vtkInkContoursStyle::CONTOURED);
  const bool ofVoxels = InkSilhouetteMethod::IsOfVoxels(contoured);
  surface->ShallowCopy(ofVoxels ? this->Contours->GetPiece(vtkInkContoursStyle::SURFACE) : contoured);
  this->GetPiece(2)->Initialize();
  if (ofVoxels)
  {
    this->GetPiece(2)->ShallowCopy(contoured);
  }
  strokes->Initialize();
  // That of images from a port is nobody's, and in voxels larger than the surface.
  this->SetFramePoints(ofVoxels && input.Port ? surface->GetPoints() : this->Contours->GetFramePoints());
  if (!problem.empty() || surface->GetNumberOfPoints() == 0)
  {
    return problem;
  }
  if (hasNormals == 0.0 && !InkContourSurface::IsOfImage(surface))
  {
    FaceOutward(surface);
  }
  const double thousandth = this->FindThousandth();
  this->LimitPictures(this->GetRelativeSize(), this->GetRelativeSize());
  // Those of a style that is changed while it is shown suit the middle of its sliders.
  const double shown = SpacingOf(this->GetInteractive() ? 0.5 : this->Density);
  const double spacing = this->LineSpacing > 0.0 ? this->LineSpacing : shown;
  vtkSmartPointer<vtkPolyData> hatched = surface;
  vtkSmartPointer<vtkPlanes> region;
  if (const vtkSmartPointer<vtkCamera> camera = this->FindStillCamera())
  {
    // Directions do not depend on how near the picture is.
    hatched = InkSeenPart(surface, camera, HiddenMargin * spacing * 1e-3);
    region = InkSeenRegion(this->GetFramePoints(), camera);
  }
  this->Lines->SetRegion(region);
  this->Hatching->SetRegion(region);
  this->Lines->SetInputData(hatched);
  this->Lines->SetSpacing(spacing * thousandth);
  this->Lines->SetNegligibleCurvature(NegligibleBend / (spacing * thousandth));
  if (std::string failed = this->Follow(this->Lines, "tracing lines of curvature"); !failed.empty())
  {
    return failed;
  }
  this->Hatching->SetInputData(this->Lines->GetOutput());
  this->Hatching->SetSurfaceData(hatched);
  this->Hatching->SetStrokeLength(this->Length * thousandth);
  const std::string failed = this->Follow(this->Hatching, "cutting strokes");
  strokes->ShallowCopy(this->Hatching->GetOutput());
  // Only lines need the curvature that an image's surface has.
  for (const char* name : { "k1", "k2", "PrincipalDirection1", "PrincipalDirection2" })
  {
    if (InkContourSurface::IsOfImage(surface))
    {
      surface->GetPointData()->RemoveArray(name);
    }
  }
  return failed;
}

void vtkInkLineArtStyle::ShowPieces(const std::vector<vtkPolyData*>& pieces)
{
  vtkPolyData* voxels = pieces[2];
  const bool ofVoxels = voxels && voxels->GetNumberOfPoints() > 0;
  this->Contours->ShowPieces({ ofVoxels ? voxels : pieces[0], ofVoxels ? pieces[0] : nullptr });
  // Views show the same pieces again and again.
  if (pieces[0] != this->Shown || (pieces[0] && pieces[0]->GetMTime() > this->TimeShown))
  {
    this->Shown = pieces[0];
    this->TimeShown = pieces[0] ? pieces[0]->GetMTime() : 0;
    this->HasOutside = pieces[0] && HasOutsideOnly(pieces[0]);
  }
  this->UpdateCulling();
  const auto usable = [](vtkPolyData* piece)
  { return piece && piece->GetNumberOfCells() > 0 ? piece : nullptr; };
  this->Strokes->SetInputDataObject(usable(pieces[1]));
  this->Strokes->SetSurfaceData(usable(pieces[0]));
  this->Mapper->SetInputDataObject(usable(pieces[0]));
}

void vtkInkLineArtStyle::UpdatePixels()
{
  this->Contours->SetPixelScale(this->GetPixelScale());
}

void vtkInkLineArtStyle::SetPreset(int preset)
{
  this->Preset = std::clamp(preset, 0, static_cast<int>(std::size(Presets)) - 1);
  const Way& way = Presets[this->Preset];
  this->Strokes->SetTone(way.Tone);
  this->Strokes->SetCrosshatching(way.Crosshatching);
  this->Strokes->SetTaper(way.Taper);
  this->Contours->GetSilhouetteMapper()->SetLineWidth(way.ContourWidth);
  this->Contours->SetCreases(way.Creases);
  this->SetLength(way.Length);
  this->Width = way.Width;
  this->SetDensity(way.Density);
}

void vtkInkLineArtStyle::SetInkColor(double red, double green, double blue)
{
  this->Strokes->SetInkColor(red, green, blue);
  this->Contours->GetSilhouetteMapper()->SetInkColor(red, green, blue);
}

double* vtkInkLineArtStyle::GetInkColor()
{
  return this->Strokes->GetInkColor();
}

void vtkInkLineArtStyle::SetLightDirection(double azimuth, double elevation)
{
  this->LightDirection[0] = azimuth;
  this->LightDirection[1] = elevation;
  InkAimLight(this->Light, this->LightDirection);
}

void vtkInkLineArtStyle::SetDensity(double density)
{
  if (this->Density != density && !this->GetInteractive() && this->LineSpacing == 0.0)
  {
    // Lines are as dense as they are drawn.
    this->Modified();
  }
  this->Density = density;
  this->UpdateWidths();
}

void vtkInkLineArtStyle::SetWidth(double width)
{
  this->Width = width;
  this->UpdateWidths();
}

void vtkInkLineArtStyle::UpdateWidths()
{
  const double spacing = SpacingOf(this->Density);
  this->Strokes->SetHatchSpacing(spacing);
  this->Strokes->SetLineWidth(spacing * (OneWidth + this->Width * (LeastWidth - OneWidth)));
}

void vtkInkLineArtStyle::SetCurvature(int source)
{
  this->GetIsoSurface()->SetComputeCurvature(source == OF_IMAGE);
}

int vtkInkLineArtStyle::GetCurvature()
{
  return this->GetIsoSurface()->GetComputeCurvature() ? OF_IMAGE : OF_MESH;
}

void vtkInkLineArtStyle::SetCullingCosine(double cosine)
{
  this->CullingCosine = cosine;
  this->UpdateCulling();
}

void vtkInkLineArtStyle::UpdateCulling()
{
  this->Strokes->SetCullingCosine(this->HasOutside ? this->CullingCosine : 1.0);
}

void vtkInkLineArtStyle::SetSeed(int seed)
{
  this->Lines->SetSeed(seed);
  this->Hatching->SetSeed(seed);
}

int vtkInkLineArtStyle::GetSeed()
{
  return this->Lines->GetSeed();
}

void vtkInkLineArtStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Contours:\n";
  this->Contours->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Strokes:\n";
  this->Strokes->PrintSelf(os, indent.GetNextIndent());
}
