// SPDX-License-Identifier: BSD-3-Clause
#include "StyledScene.h"

#include "Errors.h"
#include "InkHasPolygons.h"
#include "MakeMarks.h"
#include "PointStore.h"
#include "RenderCommand.h"
#include "SampleVolume.h"
#include "StyleArguments.h"
#include "Volume.h"
#include "VolumeSlices.h"

#include "InkSurfaceParts.h"

#include "vtkDataArray.h"
#include "vtkInkIllustrationStyle.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace ink::cli
{
namespace
{

// A point as it is made, as it is drawn, and as OpenGL may keep it.
constexpr std::uint64_t drawnPointBytes = 100;

std::vector<double> isoValuesOf(vtkInkStyle* style)
{
  const InkParameter* parameter = style->GetParameterTable().Find("IsoValues");
  return parameter ? parameter->Get(style).Numbers : std::vector<double>();
}

bool isSeeThrough(vtkInkStyle* style)
{
  return vtkInkIllustrationStyle::SafeDownCast(style) && style->GetParameter("SeeThrough") != 0.0;
}

ink::ComponentSelection partsOf(vtkInkStyle* style)
{
  return { style->GetParameter("SmallestPart"),
    static_cast<std::size_t>(style->GetParameter("LargestParts")) };
}

/// Parts of surfaces that were sampled a few slices at a time.
void keepParts(
  vtkPolyData* points, std::vector<std::size_t>& counts, const ink::ComponentSelection& selection)
{
  vtkPointData* data = points->GetPointData();
  const vtkSmartPointer<vtkDataArray> ids = data->GetArray("CellId");
  data->RemoveArray("CellId");
  std::vector<vtkDataArray*> arrays{ points->GetPoints()->GetData() };
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    arrays.push_back(data->GetArray(i));
  }
  const auto* cells = static_cast<const ink::ActiveCellId*>(ids->GetVoidPointer(0));
  InkKeepParts({ cells, static_cast<std::size_t>(ids->GetNumberOfValues()) }, selection, arrays, counts);
  const auto left = static_cast<vtkIdType>(std::accumulate(counts.begin(), counts.end(), std::size_t{ 0 }));
  for (vtkDataArray* array : arrays)
  {
    array->SetNumberOfTuples(left);
  }
}

void setIsoValues(vtkInkStyle* style, const std::vector<double>& values)
{
  // With what iso-values imply.
  style->SetParameters({ { "IsoValues", { values, {} } } });
}

/// Whether what iso-values need to count was switched off.
bool isWithoutIsoValues(vtkInkStyle* style, const StyleArguments& parameters)
{
  const InkParameter* parameter = style->GetParameterTable().Find("IsoValues");
  const InkParameter::Setting condition = parameter ? parameter->Condition : InkParameter::Setting();
  return condition.Name && parameters.gives(condition.Name) &&
    style->GetParameterAsString(condition.Name) != condition.Text;
}

InkParameterData kindOf(const Input& input)
{
  auto* mesh = vtkPolyData::SafeDownCast(input.data);
  return input.isVolume()          ? InkParameterData::Image
    : mesh && InkHasPolygons(mesh) ? InkParameterData::Mesh
                                   : InkParameterData::Points;
}

const char* nameOf(InkParameterData kind)
{
  return kind == InkParameterData::Image ? "a volume"
    : kind == InkParameterData::Mesh     ? "a mesh"
                                         : "points without polygons";
}

} // namespace

vtkInkSplattingLinesStyle* linesOf(vtkInkStyle* style)
{
  auto* illustration = vtkInkIllustrationStyle::SafeDownCast(style);
  return illustration ? illustration->GetLinesStyle() : vtkInkSplattingLinesStyle::SafeDownCast(style);
}

SceneMaker::SceneMaker(const RenderOptions& options, bool follow)
  : Options(options)
{
  if (vtkInkSplattingLinesStyle* lines = linesOf(options.style))
  {
    lines->GetSurfaceSampler()->SetFollowDeformation(follow);
  }
}

void SceneMaker::keepIsoValue(const Input& input, std::vector<std::string>& notes, Progress& progress)
{
  requireSlices(input);
  // See-through, a volume has two, which are chosen together.
  if (isoValuesOf(this->Options.style).empty() && input.isVolume() && !isSeeThrough(this->Options.style))
  {
    setIsoValues(this->Options.style, chooseIsoValue(input, notes, progress));
  }
}

StyledScene SceneMaker::make(const Input& input, Progress& progress)
{
  requireSlices(input);
  vtkInkStyle* style = this->Options.style;
  this->Options.parameters->checkData(kindOf(input), nameOf(kindOf(input)));
  StyledScene subject;
  subject.style = style;
  vtkSmartPointer<vtkDataObject> data = input.data;
  // Lines need the points of surfaces and nothing else of a volume that is larger than memory.
  if (input.isVolume() && !data && linesOf(style))
  {
    data = this->sampleSurfaces(input, subject.notes, progress);
  }
  else if (input.isVolume())
  {
    this->prepareVolume(input, subject.notes);
  }
  makeMarks(style, data, subject.notes, progress);
  subject.frame = style->GetFramePoints();
  if (input.isVolume())
  {
    this->requireMemoryFor(style->GetPiece(0)->GetNumberOfPoints());
  }
  style->Show();
  return subject;
}

void SceneMaker::requireMemoryFor(vtkIdType points) const
{
  const std::uint64_t limit = this->Options.input.memory.limit;
  const std::uint64_t bytes = static_cast<std::uint64_t>(points) * drawnPointBytes;
  if (bytes > limit)
  {
    throw Failure("the surface has " + std::to_string(points) +
      " points or more, which cannot be drawn in less than " + memoryText(bytes) +
      ": expected --memory of more than that, found " + memoryText(limit));
  }
}

vtkSmartPointer<vtkPolyData> SceneMaker::sampleSurfaces(
  const Input& input, std::vector<std::string>& notes, Progress& progress)
{
  if (isSeeThrough(this->Options.style))
  {
    throw Failure("--see-through needs the whole volume in memory: expected a volume of voxels and more "
                  "--memory, or one surface");
  }
  const Memory& memory = this->Options.input.memory;
  VolumeSampling sampling;
  sampling.isoValues = isoValuesOf(this->Options.style);
  const ink::ComponentSelection parts = partsOf(this->Options.style);
  sampling.cut = static_cast<int>(this->Options.style->GetParameter("Cut"));
  sampling.cellIds = input.volume && !parts.keepsAll();
  sampling.parts = parts;
  // What is automatic needs the whole volume.
  sampling.smoothing = std::max(this->Options.style->GetParameter("Smoothing"), 0.0);
  sampling.smoothingTarget = static_cast<int>(this->Options.style->GetParameter("SmoothingTarget"));
  sampling.subdivision = std::max(static_cast<int>(this->Options.style->GetParameter("Subdivision")), 1);
  PointStore points(memory.limit, {});
  std::vector<std::size_t> counts;
  const auto keep = [&](int index, vtkPolyData* part)
  {
    const auto surface = static_cast<std::size_t>(index);
    counts.resize(std::max(counts.size(), surface + 1));
    counts[surface] += static_cast<std::size_t>(part->GetNumberOfPoints());
    this->requireMemoryFor(static_cast<vtkIdType>(points.size()) + part->GetNumberOfPoints());
    points.add(index, part);
  };
  notes = sampleVolume(input, sampling, memory, keep, progress);
  const vtkSmartPointer<vtkPolyData> all = points.take();
  if (sampling.cellIds)
  {
    keepParts(all, counts, parts);
  }
  return all;
}

void SceneMaker::prepareVolume(const Input& input, std::vector<std::string>& notes)
{
  vtkInkStyle* style = this->Options.style;
  if (!input.data)
  {
    const VolumeSlices& volume = *input.volume;
    std::uint64_t bytes = static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(volume.type()));
    for (const int n : volume.dimensions())
    {
      bytes *= static_cast<std::uint64_t>(n);
    }
    throw Failure("--style " + std::string(style->GetName()) + " needs the whole volume at once, " +
      memoryText(bytes) + ": expected --memory of " + memoryText(Memory::limitFor(bytes, 2)) +
      " or more, or --style illustration");
  }
  if (isWithoutIsoValues(style, *this->Options.parameters))
  {
    return;
  }
  std::vector<double> values = isoValuesOf(style);
  takeSurfaceValue(input, values, notes);
  if (linesOf(style) || !values.empty())
  {
    checkIsoValues(values, findFiniteRange(*input.volume));
  }
  if (!values.empty())
  {
    setIsoValues(style, values);
  }
}

} // namespace ink::cli
