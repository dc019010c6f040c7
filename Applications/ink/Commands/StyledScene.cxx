// SPDX-License-Identifier: BSD-3-Clause
#include "StyledScene.h"

#include "Errors.h"
#include "MakeMarks.h"
#include "PointStore.h"
#include "RenderCommand.h"
#include "SampleVolume.h"
#include "StyleArguments.h"
#include "Volume.h"
#include "VolumeSlices.h"

#include "vtkDataArray.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkPolyData.h"

#include <cstdint>

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
  return input.isVolume()                                              ? InkParameterData::Image
    : mesh && mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0 ? InkParameterData::Mesh
                                                                       : InkParameterData::Points;
}

const char* nameOf(InkParameterData kind)
{
  return kind == InkParameterData::Image ? "a volume"
    : kind == InkParameterData::Mesh     ? "a mesh"
                                         : "points without polygons";
}

} // namespace

SceneMaker::SceneMaker(const RenderOptions& options, bool follow)
  : Options(options)
{
  if (auto* lines = vtkInkSplattingLinesStyle::SafeDownCast(options.style))
  {
    lines->GetSurfaceSampler()->SetFollowDeformation(follow);
  }
}

void SceneMaker::keepIsoValue(const Input& input, std::vector<std::string>& notes, Progress& progress)
{
  requireSlices(input);
  if (isoValuesOf(this->Options.style).empty() && input.isVolume())
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
  // Lines need the points of surfaces and nothing else of a volume.
  if (input.isVolume() && vtkInkSplattingLinesStyle::SafeDownCast(style))
  {
    subject.points = this->sampleSurfaces(input, subject.notes, progress);
    style->ShowPieces({ subject.points });
    return subject;
  }
  if (input.isVolume())
  {
    this->prepareVolume(input, subject.notes);
  }
  makeMarks(style, input.data, subject.notes, progress);
  subject.points = style->GetPiece(0);
  style->Show();
  return subject;
}

vtkSmartPointer<vtkPolyData> SceneMaker::sampleSurfaces(
  const Input& input, std::vector<std::string>& notes, Progress& progress)
{
  const Memory& memory = this->Options.input.memory;
  VolumeSampling sampling;
  sampling.isoValues = isoValuesOf(this->Options.style);
  PointStore points(memory.limit, {});
  const auto keep = [&](int index, vtkPolyData* part)
  {
    const std::uint64_t count = points.size() + static_cast<std::uint64_t>(part->GetNumberOfPoints());
    if (count * drawnPointBytes > memory.limit)
    {
      throw Failure("the surface has " + std::to_string(count) +
        " points or more, which cannot be drawn in less than " + memoryText(count * drawnPointBytes) +
        ": expected --memory of more than that, found " + memoryText(memory.limit));
    }
    points.add(index, part);
  };
  notes = sampleVolume(input, sampling, memory, keep, progress);
  return points.take();
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
      " or more, or --style splatting-lines");
  }
  if (isWithoutIsoValues(style, *this->Options.parameters))
  {
    return;
  }
  std::vector<double> values = isoValuesOf(style);
  takeSurfaceValue(input, values, notes);
  if (!values.empty())
  {
    checkIsoValues(values, findFiniteRange(*input.volume));
    setIsoValues(style, values);
  }
}

} // namespace ink::cli
