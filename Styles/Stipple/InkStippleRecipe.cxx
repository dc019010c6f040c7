// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleRecipe.h"

#include "InkHasPolygons.h"
#include "InkHasSurface.h"
#include "InkIsoSurface.h"
#include "InkLeaves.h"
#include "InkLongestSide.h"
#include "InkSilhouettes.h"
#include "InkStippleNumbers.h"
#include "InkStyleProcesses.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"

#include "Stippling/StippledVoxels.h"
#include "Stippling/VolumeStipples.h"
#include "Tone/Stipple/ProjectedSize.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace
{

/// Square thousandths of the height that a stipple of a mesh takes in a view of all of it where their number
/// does not depend on the parameter: two thirds of what most presets have, as views are closer, too.
constexpr double UsualRoom = 4.0;

/// The longest side of a mesh relative to the height of a view that shows all of it, as VTK resets cameras:
/// the sphere around its bounds fills it, whatever the mesh's shape.
double ShareOfView(vtkPolyData* mesh)
{
  const vtkBoundingBox box(mesh->GetBounds());
  const double diagonal = box.GetDiagonalLength();
  return diagonal > 0.0 ? box.GetMaxLength() / diagonal : 1.0;
}

/// Takes a generator's properties that a drawing changes back when it is done.
class ChangedGenerator
{
public:
  explicit ChangedGenerator(vtkInkStippleGenerator* generator)
    : Generator(generator)
    , Count(generator->GetNumberOfSurfaceStipples())
    , ListLength(generator->GetMaximumStipples())
    , Mode(generator->GetMaximumStipplesMode())
    , Smoothing(generator->GetSmoothing())
  {
  }
  ~ChangedGenerator()
  {
    this->Generator->SetInputConnection(nullptr);
    this->Generator->SetStatistics(nullptr);
    this->Generator->SetPassScalars(false);
    this->Generator->SetNumberOfSurfaceStipples(this->Count);
    this->Generator->SetMaximumStipples(this->ListLength);
    this->Generator->SetMaximumStipplesMode(this->Mode);
    this->Generator->SetSmoothing(this->Smoothing);
  }
  ChangedGenerator(const ChangedGenerator&) = delete;
  void operator=(const ChangedGenerator&) = delete;

private:
  vtkInkStippleGenerator* const Generator;
  const vtkIdType Count;
  const int ListLength;
  const int Mode;
  const double Smoothing;
};

/// Of images of all processes, as many stipples a voxel as it measures pixels in a picture of them all.
int ProjectedListLength(const std::vector<vtkImageData*>& images, double pixels, InkStyleProcesses& processes)
{
  double edge = 0.0;
  for (vtkImageData* image : images)
  {
    const double* steps = image->GetSpacing();
    edge = std::max(edge, std::cbrt(std::abs(steps[0] * steps[1] * steps[2])));
  }
  processes.TakeGreatest({ &edge, 1 });
  // Bounds end at the middles of the outermost voxels.
  const double longest = InkLongestSide(images, processes) + edge;
  return ink::stipple::projectedListLength(static_cast<float>(edge / longest),
    static_cast<float>(1.0 / pixels), ink::stipple::maximumStipplesPerVoxel);
}

} // namespace

InkStippleRecipe::InkStippleRecipe(vtkInkStippleStyle* style)
  : Style(style)
  , Generator(style->GetGenerator())
{
}

void InkStippleRecipe::Say(const std::string& problem)
{
  if (this->Problem.empty() && !problem.empty())
  {
    this->Problem = problem;
  }
}

std::string InkStippleRecipe::Make(const vtkInkStyle::Input& input)
{
  vtkInkStippleStyle* style = this->Style;
  const InkLeaves leaves(input.Data);
  style->IdsAreInputs = false;
  style->MadeColorArray.clear();
  style->MadeColorAssociation = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  this->Generator->SetPictureSize(style->GetPictureSize());
  if (!leaves.Problem.empty())
  {
    this->Say("Stipple draws nothing for " + leaves.Problem + ". It needs images, meshes or stipples");
  }
  std::array found{ leaves.Images.empty() ? 0.0 : 1.0, leaves.Stipples.empty() ? 0.0 : 1.0 };
  style->GetProcesses().TakeGreatest(found);
  const bool images = found[0] > 0.0;
  const bool stipples = found[1] > 0.0;
  style->OfImage = images;
  const bool ofVoxels = images && !(this->TakesIsoSurfaces(input) && this->StippleIsoSurfaces(leaves, input));
  if (ofVoxels)
  {
    this->StippleImages(leaves, input);
  }
  else if (!images && stipples)
  {
    this->TakeStipples(leaves);
  }
  else if (!images)
  {
    this->StippleSurfaces(leaves);
  }
  style->GetProcesses().AgreeOnArray(style->MadeColorArray, style->MadeColorAssociation);
  const std::size_t left = leaves.Others.size() + (images ? leaves.Stipples.size() : 0);
  if ((images || stipples) && left > 0)
  {
    this->Say("Stipple draws nothing for " + std::to_string(left) + " datasets beside " +
      (images ? "images" : "stipples") + ". It draws images, stipples and meshes one kind at a time");
  }
  if (style->GetPiece(vtkInkStippleStyle::STIPPLES)->GetNumberOfPoints() == 0)
  {
    style->AddNote(!ofVoxels ? "nothing to draw: no stipple was placed"
        : this->Generator->GetUseScalarWindow()
        ? "nothing to draw: no voxel has a gradient that is steep enough and a value in the window"
        : "nothing to draw: no voxel has a gradient that is steep enough");
  }
  InkWriteNumbers(
    style->GetPiece(vtkInkStippleStyle::STIPPLES), style->GetPiece(vtkInkStippleStyle::NUMBERS));
  return this->Problem;
}

void InkStippleRecipe::TakeColors(vtkDataSet* data, bool cells)
{
  vtkInkStippleStyle* style = this->Style;
  const bool chosen = !style->ColorBy.empty();
  if (!style->GetInteractive())
  {
    // What is asked for has to be there.
    this->Generator->SetPassScalars(!style->ColorMap.empty());
    this->Generator->SetInputArrayToProcess(1, 0, 0,
      chosen ? vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS,
      style->ColorBy.c_str());
    return;
  }
  vtkDataArray* active = data->GetPointData()->GetScalars();
  const std::string name = chosen ? style->ColorBy : active && active->GetName() ? active->GetName() : "";
  const int association = chosen && style->ColorAssociation >= 0 ? style->ColorAssociation
                                                                 : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const bool ofCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkDataSetAttributes* attributes =
    ofCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  const bool has = !name.empty() && (!ofCells || cells) && attributes->GetArray(name.c_str());
  this->Generator->SetPassScalars(has);
  this->Generator->SetInputArrayToProcess(1, 0, 0, association, has ? name.c_str() : "");
  if (has)
  {
    style->MadeColorArray = name;
    style->MadeColorAssociation = association;
  }
}

bool InkStippleRecipe::TakesIsoSurfaces(const vtkInkStyle::Input& input) const
{
  // Of data that comes from a port, in ParaView say, no surface is chosen unasked.
  return this->Style->StippleSource == vtkInkStippleStyle::ISO_SURFACE ||
    (this->Style->StippleSource == vtkInkStippleStyle::AUTOMATIC && !input.Port);
}

bool InkStippleRecipe::StippleIsoSurfaces(const InkLeaves& leaves, const vtkInkStyle::Input& input)
{
  vtkInkStippleStyle* style = this->Style;
  const std::string problem = style->IsoSurface->Prepare(style, leaves.Images, style->Scalars);
  if (!problem.empty() && style->StippleSource == vtkInkStippleStyle::AUTOMATIC)
  {
    return false;
  }
  this->Say(problem);
  if (problem.empty())
  {
    this->OutlineImages(leaves, *style->IsoSurface);
  }
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (std::size_t i = 0; i < leaves.Images.size() && problem.empty(); ++i)
  {
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    this->Say(style->IsoSurface->Sample(style, input, leaves.Images[i], parts.back()));
    this->AddColorsOf(leaves.Images[i], parts.back());
  }
  style->IsoSurface->KeepParts(style, input, parts);
  const vtkSmartPointer<vtkPolyData> points = style->GetProcesses().Gather(parts);
  if (points->GetNumberOfPoints() > 0)
  {
    this->StippleSurface(points);
  }
  return true;
}

void InkStippleRecipe::OutlineImages(const InkLeaves& leaves, InkIsoSurface& isoSurface)
{
  vtkInkStippleStyle* style = this->Style;
  this->Say(style->Silhouettes->MakeOfImages(
    style, isoSurface, leaves.Images, style->Scalars, style->GetPiece(vtkInkStippleStyle::SILHOUETTES)));
}

void InkStippleRecipe::AddColorsOf(vtkImageData* image, vtkPolyData* points)
{
  const std::string& chosen = this->Style->ColorBy;
  vtkDataArray* colors =
    chosen.empty() ? image->GetPointData()->GetScalars() : image->GetPointData()->GetArray(chosen.c_str());
  // What is asked for by a map of colors, or by a name.
  if (!colors || !colors->GetName() || (chosen.empty() && this->Style->ColorMap.empty()))
  {
    return;
  }
  vtkNew<vtkImageData> source;
  source->CopyStructure(image);
  source->GetPointData()->SetScalars(colors);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(points);
  probe->SetSourceData(source);
  probe->Update();
  points->GetPointData()->SetScalars(probe->GetOutput()->GetPointData()->GetArray(colors->GetName()));
}

void InkStippleRecipe::StippleImages(const InkLeaves& leaves, const vtkInkStyle::Input& input)
{
  vtkInkStippleStyle* style = this->Style;
  vtkInkStippleGenerator* generator = this->Generator;
  const ChangedGenerator changed(generator);
  if (style->Silhouettes->GetMethod()->NeedsVoxels())
  {
    this->OutlineImages(leaves, *style->IsoSurface);
  }
  else if (style->Silhouettes->GetSilhouettes())
  {
    // They are those of a surface, though no surface is stippled. A panel always has an iso-value, which
    // counts where its surface is.
    InkIsoSurface isoSurface;
    isoSurface.CopyParameters(*style->IsoSurface);
    if (!style->GetInteractive())
    {
      isoSurface.SetIsoValues(style->IsoSurface->GetIsoValues());
    }
    const std::string problem = isoSurface.Prepare(style, leaves.Images, style->Scalars);
    if (problem.empty())
    {
      this->OutlineImages(leaves, isoSurface);
    }
    else
    {
      style->AddNote("there are no silhouettes: " + problem);
    }
  }
  // Nor is smoothing chosen unasked for data that comes from a port, whose stipples are the filter's.
  const double smoothing = style->IsoSurface->GetSmoothing();
  generator->SetSmoothing(input.Port
      ? std::max(smoothing, 0.0)
      : style->IsoSurface->ChooseSmoothing(style, leaves.Images, style->Scalars));
  const char* scalars = style->Scalars.c_str();
  if (style->Scalars.empty())
  {
    generator->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  }
  else
  {
    generator->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, scalars);
  }
  // The leaves of composite data are whole images, and so is an image that comes from nowhere.
  vtkNew<vtkInformation> whole;
  const bool parts = input.Port && !leaves.Composite;
  vtkInformation* update = parts && input.Request ? input.Request : whole.Get();
  const auto connect = [&](vtkImageData* image)
  {
    if (parts)
    {
      generator->SetInputConnection(input.Port);
    }
    else
    {
      generator->SetInputData(image);
    }
  };

  // One whole image is measured when it is stippled; parts and several images are, too, together.
  const bool together = parts || leaves.Composite;
  if (together && generator->GetMaximumStipplesMode() == vtkInkStippleGenerator::PROJECTED)
  {
    generator->SetMaximumStipplesModeToFixed();
    generator->SetMaximumStipples(
      ProjectedListLength(leaves.Images, generator->GetPictureSize(), style->GetProcesses()));
  }
  const auto statistics = std::make_shared<ink::stipple::VolumeStatistics>();
  std::vector<vtkImageData*> measured;
  // The same on all processes.
  const bool measures = together &&
    (generator->GetThresholdMode() == vtkInkStippleGenerator::PERCENTILE ||
      !generator->GetUseReferenceRanges());
  for (vtkImageData* image : leaves.Images)
  {
    connect(image);
    bool done = true;
    if (measures)
    {
      this->Say(style->Follow(
        generator, "measuring gradients", [&] { done = generator->Measure(update, *statistics); }));
    }
    if (done)
    {
      measured.push_back(image);
    }
  }
  if (measures)
  {
    style->GetProcesses().AddUp(*statistics);
    generator->SetStatistics(statistics);
  }
  std::vector<vtkSmartPointer<vtkPolyData>> stipples;
  for (vtkImageData* image : measured)
  {
    connect(image);
    this->TakeColors(image, false);
    this->Say(style->Follow(generator, "placing stipples", [&] { generator->Update(update); }));
    if (generator->GetOutput()->GetNumberOfPoints() > 0)
    {
      stipples.push_back(vtkSmartPointer<vtkPolyData>::New());
      stipples.back()->ShallowCopy(generator->GetOutput());
    }
  }
  style->GetPiece(vtkInkStippleStyle::STIPPLES)->ShallowCopy(InkAppend(stipples));
}

void InkStippleRecipe::StippleSurfaces(const InkLeaves& leaves)
{
  vtkInkStippleStyle* style = this->Style;
  const vtkSmartPointer<vtkPolyData> mesh = style->GetProcesses().Gather(leaves.MakeMeshes());
  if (mesh->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (!InkHasSurface(mesh))
  {
    this->Say("Stipple draws nothing for data of " + std::to_string(mesh->GetNumberOfPoints()) +
      " points without polygons. It needs an image, a mesh, points with Normals and Radius, or stipples of "
      "Ink Stipple Generator");
    return;
  }
  style->SetFramePoints(mesh->GetPoints());
  this->Say(style->Silhouettes->MakeOfMesh(style, mesh, style->GetPiece(vtkInkStippleStyle::SILHOUETTES)));
  this->StippleSurface(mesh);
}

void InkStippleRecipe::StippleSurface(vtkPolyData* mesh)
{
  vtkInkStippleStyle* style = this->Style;
  vtkInkStippleGenerator* generator = this->Generator;
  const ChangedGenerator changed(generator);
  const bool interactive = style->GetInteractive();
  const double room = interactive ? UsualRoom : style->PixelsPerStipple;
  // The number of stipples depends on the picture's pixels only where their size does.
  const bool inPixels = !interactive && style->SizeUnit == vtkInkStippleMapper::PIXELS;
  const double size = style->GetPictureSize() * (inPixels ? 1.0 : 1e3 / style->GetPictureHeight()) *
    (interactive ? ShareOfView(mesh) : 1.0);
  const vtkIdType count = style->NumberOfSurfaceStipples;
  const bool fixed = generator->GetMaximumStipplesMode() == vtkInkStippleGenerator::FIXED;
  const bool counted = count == 0 && fixed;
  const vtkIdType fitting = counted ? vtkInkStippleGenerator::CountForPicture(mesh, size, room) : 0;
  generator->SetNumberOfSurfaceStipples(counted ? fitting : std::max<vtkIdType>(count, 0));
  if (fitting == ink::stipple::mostForPicture && !interactive)
  {
    style->AddNote("there is room for more than the " + std::to_string(fitting) +
      " stipples that are made at most, so they are drawn larger; their number can be given");
  }
  generator->SetInputData(mesh);
  this->TakeColors(mesh, true);
  this->Say(style->Follow(generator, "placing stipples"));
  style->GetPiece(vtkInkStippleStyle::STIPPLES)->ShallowCopy(generator->GetOutput());
  if (style->SurfaceHides)
  {
    vtkPolyData* surface = style->GetPiece(vtkInkStippleStyle::SURFACE);
    surface->SetPoints(mesh->GetPoints());
    surface->SetPolys(mesh->GetPolys());
    surface->SetStrips(mesh->GetStrips());
    if (!InkHasPolygons(mesh))
    {
      surface->GetPointData()->PassData(mesh->GetPointData());
    }
  }
}

void InkStippleRecipe::ColorStipples(vtkCellData* cells)
{
  const std::string& name = this->Style->ColorBy;
  if (this->Style->ColorMap.empty())
  {
    cells->SetActiveScalars(nullptr);
  }
  else if (!name.empty() && cells->SetActiveScalars(name.c_str()) < 0)
  {
    this->Say("Stipple: expected stipples with the cell array '" + name + "', found none");
  }
  else if (!cells->GetScalars())
  {
    this->Say("Stipple: expected stipples with scalars to color them by, found none");
  }
}

void InkStippleRecipe::TakeStipples(const InkLeaves& leaves)
{
  vtkInkStippleStyle* style = this->Style;
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (vtkPolyData* stipples : leaves.Stipples)
  {
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    parts.back()->ShallowCopy(stipples);
    vtkCellData* cells = parts.back()->GetCellData();
    if (!style->GetInteractive())
    {
      this->ColorStipples(cells);
      continue;
    }
    const bool colored = style->ColorAssociation == vtkDataObject::FIELD_ASSOCIATION_CELLS &&
      cells->HasArray(style->ColorBy.c_str());
    cells->SetActiveScalars(colored ? style->ColorBy.c_str() : nullptr);
    if (colored)
    {
      style->MadeColorArray = style->ColorBy;
      style->MadeColorAssociation = style->ColorAssociation;
    }
  }
  style->GetPiece(vtkInkStippleStyle::STIPPLES)->ShallowCopy(InkAppend(parts));
  style->IdsAreInputs = parts.size() == 1 && !leaves.Composite;
}
