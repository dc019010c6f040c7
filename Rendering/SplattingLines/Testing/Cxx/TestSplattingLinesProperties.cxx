// SPDX-License-Identifier: BSD-3-Clause
// Properties as VTK's programmers know them: copied by ShallowCopy, printed by name, chosen by name, and what
// is no value of theirs refused with a message or brought into range.
#include "InkTestMessages.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkIndent.h"
#include "vtkInformation.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <string>

namespace
{

using Mapper = vtkInkSplattingLinesMapper;

/// What PrintSelf says of the properties of this class and not of those above it.
std::map<std::string, std::string> Print(Mapper* mapper)
{
  std::ostringstream all;
  mapper->PrintSelf(all, vtkIndent());
  std::istringstream lines(all.str());
  std::map<std::string, std::string> properties;
  bool own = false;
  for (std::string line; std::getline(lines, line);)
  {
    own = own || line.rfind("Lambda:", 0) == 0;
    const std::size_t colon = line.find(':');
    if (own && colon != std::string::npos)
    {
      properties[line.substr(0, colon)] = line.substr(colon + 1);
    }
  }
  return properties;
}

/// No property at its default.
void ChangeAll(Mapper* mapper)
{
  mapper->SetLambda(1.7);
  mapper->SetTau(1.1);
  mapper->SetPhi(33.0);
  mapper->SetSigma(0.7);
  mapper->AsPublishedOn();
  mapper->SetRadius(0.3);
  mapper->SetMinimumRadius(7.0);
  mapper->HiddenLayersOn();
  mapper->SetNumberOfLayers(5);
  mapper->PeelBackFacesOn();
  mapper->SetHardness(0.4);
  mapper->SetSpeckleLength(6.0);
  mapper->ThinningOn();
  mapper->SetInkColorModeToTone();
  mapper->SetToneColor(0.1, 0.2, 0.3);
  mapper->SetMaximumDownsampling(4);
  mapper->HalfFloatsOn();
  mapper->SetPointFraction(0.6);
  mapper->SetInkColor(0.2, 0.1, 0.9);
  mapper->SetPaperColor(0.9, 0.8, 0.7);
  mapper->PaperVisibilityOff();
  for (int layer = 0; layer < 8; ++layer)
  {
    mapper->SetLayerColor(layer, 0.1 * layer, 0.5, 0.6);
    mapper->SetLayerStrength(layer, 0.01 + 0.1 * layer);
    mapper->SetLayerLineWidth(layer, 1.0 + layer);
    mapper->SetLayerDashLength(layer, 2.0 + layer);
  }
}

} // namespace

TEST(SplattingLinesProperties, ShallowCopy)
{
  vtkNew<Mapper> fresh;
  vtkNew<Mapper> changed;
  vtkNew<Mapper> copy;
  ChangeAll(changed);
  changed->SetInputData(InkTestPoints::Sphere(1.0, 0.2));
  changed->SetInputArrayToProcess(
    Mapper::NORMALS, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Direction");
  const auto defaults = Print(fresh);
  const auto expected = Print(changed);
  for (const auto& [name, value] : expected)
  {
    EXPECT_NE(value, defaults.at(name)) << name << " is tested with another value than its default," << value;
  }
  const vtkMTimeType time = copy->GetMTime();
  copy->ShallowCopy(changed);
  const auto found = Print(copy);
  EXPECT_GE(found.size(), 29) << "all properties are printed, found " << found.size();
  for (const auto& [name, value] : expected)
  {
    EXPECT_EQ(found.at(name), value) << name << ":" << value << " copied, found" << found.at(name);
  }
  EXPECT_GT(copy->GetMTime(), time) << "a copy is a change";
  EXPECT_EQ(copy->GetInput(), changed->GetInput()) << "the same input";
  EXPECT_EQ(std::string(copy->GetInputArrayInformation(Mapper::NORMALS)->Get(vtkDataObject::FIELD_NAME())),
    "Direction")
    << "the same arrays";
  // A layer without a color of its own stays without.
  copy->ShallowCopy(fresh);
  copy->SetInkColor(1.0, 0.0, 0.0);
  double color[3];
  copy->GetLayerColor(3, color);
  EXPECT_EQ(color[0], 1.0) << "the ink's color for layers without their own after a copy";
}

TEST(SplattingLinesProperties, Enumerations)
{
  vtkNew<Mapper> mapper;
  const std::string start = mapper->GetInkColorModeAsString();
  mapper->SetInkColorModeToScalars();
  const std::string scalars = mapper->GetInkColorModeAsString();
  EXPECT_EQ(mapper->GetInkColorMode(), Mapper::SCALARS) << "scalars by name";
  EXPECT_EQ(Print(mapper).at("InkColorMode"), " Scalars") << "names in PrintSelf";
  mapper->SetInkColorModeToTone();
  const std::string tone = mapper->GetInkColorModeAsString();
  mapper->SetInkColorModeToInk();
  EXPECT_EQ(mapper->GetInkColorMode(), Mapper::INK) << "ink by name";
  EXPECT_TRUE(start == "Ink" && scalars == "Scalars" && tone == "Tone")
    << "names: " << start << ", " << scalars << ", " << tone;
}

/// Each call leaves everything as it was, and says what is wrong.
TEST(SplattingLinesProperties, Refused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double nothing[3] = { nan, 0.0, 0.0 };
  struct Case
  {
    std::string Words;
    std::function<void(Mapper*)> Set;
  };
  const std::vector<Case> cases{
    { "Lambda: expected a number from 0.1 to 20, found nan", [&](Mapper* m) { m->SetLambda(nan); } },
    { "Tau: ", [&](Mapper* m) { m->SetTau(nan); } },
    { "Phi: ", [&](Mapper* m) { m->SetPhi(nan); } },
    { "Sigma: ", [&](Mapper* m) { m->SetSigma(nan); } },
    { "Radius: ", [&](Mapper* m) { m->SetRadius(nan); } },
    { "MinimumRadius: ", [&](Mapper* m) { m->SetMinimumRadius(nan); } },
    { "Hardness: ", [&](Mapper* m) { m->SetHardness(nan); } },
    { "SpeckleLength: ", [&](Mapper* m) { m->SetSpeckleLength(nan); } },
    { "PointFraction: ", [&](Mapper* m) { m->SetPointFraction(nan); } },
    { "InkColor: expected red, green and blue from 0 to 1", [&](Mapper* m) { m->SetInkColor(nothing); } },
    { "PaperColor: ", [&](Mapper* m) { m->SetPaperColor(0.0, nan, 0.0); } },
    { "ToneColor: ", [&](Mapper* m) { m->SetToneColor(0.0, 0.0, nan); } },
    { "LayerColor: ", [&](Mapper* m) { m->SetLayerColor(2, nothing); } },
    { "LayerStrength: expected a number from 0 to 1", [&](Mapper* m) { m->SetLayerStrength(2, nan); } },
    { "LayerLineWidth: ", [&](Mapper* m) { m->SetLayerLineWidth(2, nan); } },
    { "LayerDashLength: ", [&](Mapper* m) { m->SetLayerDashLength(2, nan); } },
    { "LayerColor: expected a layer from 0 to 7, found 8",
      [](Mapper* m) { m->SetLayerColor(8, 1.0, 0.0, 0.0); } },
    { "LayerColor: expected a layer", [](Mapper* m) { m->ResetLayerColor(-1); } },
    { "LayerStrength: expected a layer", [](Mapper* m) { m->SetLayerStrength(99, 0.5); } },
    { "LayerLineWidth: expected a layer", [](Mapper* m) { m->SetLayerLineWidth(8, 0.5); } },
    { "LayerDashLength: expected a layer", [](Mapper* m) { m->SetLayerDashLength(-1, 0.5); } },
  };
  for (const auto& [words, set] : cases)
  {
    vtkNew<Mapper> mapper;
    const auto before = Print(mapper);
    const vtkMTimeType time = mapper->GetMTime();
    vtkNew<InkTestMessages> messages;
    messages->Observe(mapper);
    set(mapper);
    messages->Expect(words, { words });
    EXPECT_TRUE(Print(mapper) == before && mapper->GetMTime() == time) << words << " changes nothing";
  }
}

TEST(SplattingLinesProperties, Colors)
{
  vtkNew<Mapper> mapper;
  mapper->SetInkColor(-1.0, 0.5, 7.0);
  mapper->SetPaperColor(2.0, 2.0, -2.0);
  mapper->SetToneColor(0.0, 1e9, 0.25);
  mapper->SetLayerColor(1, 3.0, -3.0, 0.5);
  double layer[3];
  mapper->GetLayerColor(1, layer);
  const auto is = [](const double* found, const std::array<double, 3>& expected)
  { return std::equal(expected.begin(), expected.end(), found); };
  EXPECT_TRUE(is(mapper->GetInkColor(), { 0.0, 0.5, 1.0 }) &&
    is(mapper->GetPaperColor(), { 1.0, 1.0, 0.0 }) && is(mapper->GetToneColor(), { 0.0, 1.0, 0.25 }) &&
    is(layer, { 1.0, 0.0, 0.5 }))
    << "colors within 0 to 1";
  const vtkMTimeType time = mapper->GetMTime();
  mapper->SetInkColor(0.0, 0.5, 3.0);
  EXPECT_EQ(mapper->GetMTime(), time) << "the same color is no change";
  mapper->ResetLayerColor(1);
  mapper->GetLayerColor(1, layer);
  EXPECT_TRUE(is(layer, { 0.0, 0.5, 1.0 }) && mapper->GetMTime() > time) << "the ink's color again";
}
