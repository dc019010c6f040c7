// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleRecipe.h"

#include "InkChangedGenerator.h"
#include "InkHasPolygons.h"
#include "InkHasSurface.h"
#include "InkIsoSurface.h"
#include "InkLeaves.h"
#include "InkProbeColors.h"
#include "InkSilhouettes.h"
#include "InkStippleNumbers.h"
#include "InkStyleProcesses.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"

#include "Stippling/VolumeStipples.h"
#include "Tone/Stipple/ProjectedSize.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace
{

/// Square thousandths of the height that a stipple of a mesh takes in a view of all of it where their number
/// does not depend on the parameter: two thirds of what most presets have, as views are closer, too.
constexpr double UsualRoom = 4.0;

/// The longest side of a mesh relative to the height of a view that shows all of the data, as VTK resets
/// cameras: the sphere around its bounds fills it, whatever its shape.
double ShareOfView(vtkPolyData* mesh, double diagonal)
{
  return diagonal > 0.0 ? vtkBoundingBox(mesh->GetBounds()).GetMaxLength() / diagonal : 1.0;
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
  const InkLeaves leaves(input.Data, style->IsoSurface->GetScalars());
  style->IdsAreInputs = false;
  style->OfVoxels = false;
  style->MadeColorArray.clear();
  style->MadeColorAssociation = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  this->Generator->SetPictureSize(style->GetPictureSize());
  if (this->Generator->GetMaximumStipplesMode() == vtkInkStippleGenerator::PROJECTED)
  {
    style->LimitPictures(1.0, 0.0); // which goes by pixels
  }
  if (!leaves.Problem.empty())
  {
    this->Say("Stipple draws nothing for " + leaves.Problem + ". It needs images, meshes or stipples");
  }
  if (!style->GetInteractive() && !style->ColorMap.empty() && !style->ColorBy.empty())
  {
    if (const std::string missing = leaves.FindMissingColors(style->ColorBy); !missing.empty())
    {
      return missing;
    }
  }
  std::array found{ leaves.Images.empty() ? 0.0 : 1.0, leaves.Stipples.empty() ? 0.0 : 1.0 };
  style->GetProcesses().TakeGreatest(found);
  const bool images = found[0] > 0.0;
  const bool stipples = found[1] > 0.0;
  style->OfImage = images;
  style->OfVoxels = images && !(this->Style->DrawsSurfaces(input) && this->StippleIsoSurfaces(leaves, input));
  if (style->OfVoxels)
  {
    this->StippleVoxels(leaves, input);
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
    style->AddNote(!style->OfVoxels ? "nothing to draw: no stipple was placed"
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
  if (const char* colors = InkFindColors(data))
  {
    this->Generator->SetPassScalars(true);
    this->Generator->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, colors);
    style->MadeColorArray = style->ColorBy;
    style->MadeColorAssociation =
      std::max<int>(style->ColorAssociation, vtkDataObject::FIELD_ASSOCIATION_POINTS);
    return;
  }
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
  // Of an image, cells' values are those of their centers by now.
  const bool ofCells = cells && association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkDataSetAttributes* attributes =
    ofCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  const bool has = !name.empty() && attributes->GetArray(name.c_str());
  this->Generator->SetPassScalars(has);
  this->Generator->SetInputArrayToProcess(1, 0, 0,
    ofCells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS,
    has ? name.c_str() : "");
  if (has)
  {
    style->MadeColorArray = name;
    style->MadeColorAssociation = association;
  }
}

bool InkStippleRecipe::StippleIsoSurfaces(const InkLeaves& leaves, const vtkInkStyle::Input& input)
{
  vtkInkStippleStyle* style = this->Style;
  const std::string problem = style->IsoSurface->Prepare(style, leaves.Images);
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
    // What is asked for by a map of colors, or by a name.
    if (!style->ColorBy.empty() || !style->ColorMap.empty())
    {
      InkProbeColors(leaves.Images[i], style->ColorBy, style->TakesLabelsInOrder(),
        style->IsoSurface->GetSampler(), parts.back());
    }
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
    style, isoSurface, leaves.Images, style->GetPiece(vtkInkStippleStyle::SILHOUETTES)));
}

void InkStippleRecipe::StippleSurfaces(const InkLeaves& leaves)
{
  vtkInkStippleStyle* style = this->Style;
  vtkSmartPointer<vtkPolyData> mesh = style->GatherMesh(leaves);
  if (mesh->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (!InkHasSurface(mesh))
  {
    vtkNew<vtkPolyData> discs;
    this->Say(style->TakeDiscs(style->SurfaceSampler, mesh, discs));
    mesh = discs;
    if (mesh->GetNumberOfPoints() == 0)
    {
      return;
    }
  }
  style->SetFramePoints(mesh->GetPoints());
  this->Say(style->Silhouettes->MakeOfMesh(style, mesh, style->GetPiece(vtkInkStippleStyle::SILHOUETTES)));
  this->StippleSurface(mesh);
}

void InkStippleRecipe::StippleSurface(vtkPolyData* mesh)
{
  vtkInkStippleStyle* style = this->Style;
  vtkInkStippleGenerator* generator = this->Generator;
  const InkChangedGenerator changed(generator);
  const bool interactive = style->GetInteractive();
  const double room = interactive ? UsualRoom : style->PixelsPerStipple;
  // The number of stipples depends on the picture's pixels only where their size does.
  const bool inPixels = !interactive && style->SizeUnit == vtkInkStippleMapper::PIXELS;
  const double size = style->GetPictureSize() * (inPixels ? 1.0 : 1e3 / style->GetPictureHeight()) *
    (interactive ? ShareOfView(mesh, style->GetDataDiagonal()) : 1.0);
  const vtkIdType count = style->NumberOfSurfaceStipples;
  const bool fixed = generator->GetMaximumStipplesMode() == vtkInkStippleGenerator::FIXED;
  const bool counted = count == 0 && fixed;
  const vtkIdType fitting = counted ? vtkInkStippleGenerator::CountForPicture(mesh, size, room) : 0;
  generator->SetNumberOfSurfaceStipples(counted ? fitting : std::max<vtkIdType>(count, 0));
  if (counted)
  {
    const double relative = style->GetRelativeSize();
    const bool isFull = fitting == ink::stipple::mostForPicture;
    style->LimitPictures(relative, isFull ? std::numeric_limits<double>::infinity() : relative);
  }
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
  else if (!name.empty())
  {
    cells->SetActiveScalars(name.c_str());
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
