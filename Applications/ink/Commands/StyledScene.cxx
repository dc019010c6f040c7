// SPDX-License-Identifier: BSD-3-Clause
#include "StyledScene.h"

#include "Errors.h"
#include "InkHasPolygons.h"
#include "MakeMarks.h"
#include "RenderCommand.h"
#include "SampleVolume.h"
#include "StyleArguments.h"

#include "InkVolumeValues.h"

#include "vtkImageData.h"
#include "vtkInkIllustrationStyle.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkPolyData.h"

namespace ink::cli
{
namespace
{

std::vector<double> isoValuesOf(vtkInkStyle* style)
{
  const InkParameter* parameter = style->GetParameterTable().Find("IsoValues");
  return parameter ? parameter->Get(style).Numbers : std::vector<double>();
}

bool isSeeThrough(vtkInkStyle* style)
{
  return vtkInkIllustrationStyle::SafeDownCast(style) && style->GetParameter("SeeThrough") != 0.0;
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
  // Lines are drawn as tubes.
  const bool isMesh = mesh && (InkHasPolygons(mesh) || mesh->GetNumberOfLines() > 0);
  return input.isVolume() ? InkParameterData::Image
    : isMesh              ? InkParameterData::Mesh
                          : InkParameterData::Points;
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
  // Samples follow faces, and how a mesh is divided changes with its form.
  if (follow && !options.parameters->gives("CurvedMeshes"))
  {
    options.style->SetCurvedMeshes(false);
  }
}

void SceneMaker::keepIsoValue(const Input& input, std::vector<std::string>& notes, Progress& progress)
{
  requireSlices(input);
  // See-through, a volume has two, which are chosen together.
  if (isoValuesOf(this->Options.style).empty() && input.isVolume() && !isSeeThrough(this->Options.style))
  {
    const bool inner = this->Options.style->GetParameter("IsoChoice") != 0.0;
    setIsoValues(
      this->Options.style, chooseIsoValue(input, this->Options.input.memory, inner, notes, progress));
  }
}

StyledScene SceneMaker::make(const Input& input, Progress& progress)
{
  requireSlices(input);
  vtkInkStyle* style = this->Options.style;
  this->Options.parameters->checkData(kindOf(input));
  StyledScene scene;
  scene.style = style;
  style->SetMaximumMemory(input.isVolume() ? this->Options.input.memory.GetMebibytes() : 0);
  if (input.data)
  {
    this->prepareVolume(input, scene.notes);
    makeMarks(style, { input.data }, scene.notes, progress);
  }
  else
  {
    std::vector<double> values = isoValuesOf(style);
    takeSurfaceValue(input, values, scene.notes);
    const auto check = [&] { checkIsoValues(values, input.sampler->FindRange()); };
    makeMarks(style, { .Surfaces = input.sampler }, scene.notes, progress, check);
    check();
  }
  scene.frame = style->GetFramePoints();
  style->Show();
  return scene;
}

void SceneMaker::prepareVolume(const Input& input, std::vector<std::string>& notes)
{
  vtkInkStyle* style = this->Options.style;
  auto* image = vtkImageData::SafeDownCast(input.data);
  if (!image || isWithoutIsoValues(style, *this->Options.parameters))
  {
    return;
  }
  std::vector<double> values = isoValuesOf(style);
  takeSurfaceValue(input, values, notes);
  if (linesOf(style) || !values.empty())
  {
    checkIsoValues(values, InkFindFiniteRange(image));
  }
  if (!values.empty())
  {
    setIsoValues(style, values);
  }
}

} // namespace ink::cli
