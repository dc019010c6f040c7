// SPDX-License-Identifier: BSD-3-Clause
// Parameters given together, as JSON: round trips, what they imply, what is refused.
#include "StyleErrors.h"

#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleMapper.h"
#include "vtkInkStippleStyle.h"

#include <gtest/gtest.h>

namespace
{

/// A file that sets a few parameters.
std::string File(const std::string& style, const std::string& parameters)
{
  return R"({"style": ")" + style + R"(", "parameters": {)" + parameters + "}}";
}

TEST(StyleFiles, RoundTripsOfAllParameters)
{
  for (const auto& style : MakeStyles())
  {
    const std::string standard = style->GetParametersAsJSON();
    EXPECT_EQ(vtkInkStyle::FindStyleInJSON(standard), style->GetName());
    // Something else of each kind.
    if (style->GetNumberOfPresets() > 0)
    {
      style->SetParameter("Preset", 4);
    }
    if (std::string(style->GetName()) == "stipple")
    {
      EXPECT_TRUE(style->SetParameter("ColorRange", 1e-30, 0.1));
      EXPECT_TRUE(style->SetParameterAsString("ColorMap", "red,blue,#fff"));
    }
    EXPECT_TRUE(style->SetParameterAsString("IsoValues", "0.1,-5e-300,1e300"));
    style->SetParameter("InkColor", 0.1, 0.2, 0.3);
    const std::string changed = style->GetParametersAsJSON();
    EXPECT_NE(changed, standard);
    const auto other = vtk::TakeSmartPointer(vtkInkStyle::CreateStyle(style->GetName()));
    EXPECT_EQ(other->SetParametersFromJSON(changed), "");
    EXPECT_EQ(other->GetParametersAsJSON(), changed);
    EXPECT_EQ(other->SetParametersFromJSON(standard), "");
    EXPECT_EQ(other->GetParametersAsJSON(), standard);
    style->ResetParameters();
    EXPECT_EQ(style->GetParametersAsJSON(), standard);
  }
}

TEST(StyleFiles, OrderDoesNotMatter)
{
  vtkNew<vtkInkStippleStyle> style;
  EXPECT_EQ(
    style->SetParametersFromJSON(File("stipple", R"("BoundaryGain": 3, "Gradient": 1, "Preset": "bone")")),
    "");
  EXPECT_EQ(style->GetParameter("BoundaryGain"), 3);
  EXPECT_EQ(style->GetParameter("Gradient"), 1);
  EXPECT_EQ(style->GetParameter("Sharpness"), 0.6);
}

TEST(StyleFiles, WhatIsGivenImpliesWhatItNeeds)
{
  vtkNew<vtkInkSplattingLinesStyle> lines;
  vtkInkSplattingLinesMapper* mapper = lines->GetLinesMapper();
  EXPECT_EQ(
    lines->SetParametersFromJSON(File("splatting-lines", R"("ToneColor": "blue", "LineWidth": 2)")), "");
  EXPECT_EQ(mapper->GetInkColorMode(), vtkInkSplattingLinesMapper::TONE);
  EXPECT_EQ(mapper->GetLayerLineWidth(3), 2);
  EXPECT_EQ(lines->SetParametersFromJSON(File(
              "splatting-lines", R"("NumberOfLayers": 3, "HiddenColor": "red,blue", "HiddenStrength": 0.7)")),
    "");
  EXPECT_TRUE(mapper->GetHiddenLayers());
  EXPECT_NEAR(mapper->GetLayerStrength(2), 0.7 * 2 / 3, 1e-12);
  double color[3];
  mapper->GetLayerColor(2, color);
  EXPECT_EQ(color[2], 1);
  mapper->GetLayerColor(7, color);
  EXPECT_EQ(color[2], 1);
  // What is given, too, stays as given.
  lines->ResetParameters();
  EXPECT_EQ(lines->SetParametersFromJSON(File("splatting-lines",
              R"("ToneColor": "blue", "ColorByTone": false, "LineWidth": 2, "HiddenLineWidth": 1)")),
    "");
  EXPECT_EQ(mapper->GetInkColorMode(), vtkInkSplattingLinesMapper::INK);
  EXPECT_EQ(mapper->GetLayerLineWidth(3), 1);
  // Set alone, they imply nothing.
  EXPECT_TRUE(lines->SetParameterAsString("ToneColor", "red"));
  EXPECT_FALSE(lines->GetColorByTone());

  vtkNew<vtkInkStippleStyle> stipple;
  EXPECT_EQ(
    stipple->SetParametersFromJSON(File("stipple", R"("InkColor": "white", "PaperColor": "navy")")), "");
  EXPECT_TRUE(stipple->GetStippleMapper()->GetLightInk());
  EXPECT_EQ(stipple->SetParametersFromJSON(File("stipple", R"("InkColor": "white", "LightInk": false)")), "");
  EXPECT_FALSE(stipple->GetStippleMapper()->GetLightInk());
  for (const char* colors : { R"("ColorBy": "density")", R"("ColorRange": [0, 1])" })
  {
    stipple->ResetParameters();
    EXPECT_EQ(stipple->SetParametersFromJSON(File("stipple", colors)), "");
    EXPECT_EQ(stipple->GetColorMap(), "viridis");
  }
  EXPECT_EQ(stipple->SetParametersFromJSON(File("stipple", R"("ColorBy": "x", "ColorMap": "red,blue")")), "");
  EXPECT_EQ(stipple->GetColorMap(), "red,blue");
}

TEST(StyleFiles, WhatIsWrongIsNamedAndNothingIsSet)
{
  vtkNew<vtkInkStippleStyle> style;
  const std::string before = style->GetParametersAsJSON();
  const auto problem = [&](const std::string& json, const std::vector<std::string>& words)
  {
    const std::string found = style->SetParametersFromJSON(json);
    EXPECT_NE(found, "") << json;
    for (const std::string& word : words)
    {
      EXPECT_NE(found.find(word), std::string::npos) << json << ": " << found << " lacks " << word;
    }
  };
  problem("", { "JSON" });
  problem("{", { "JSON" });
  problem("[1]", { R"("style")", "[1]" });
  problem(R"({"style": "stipple"})", { "parameters" });
  problem(R"({"style": "stipple", "parameters": [1]})", { "parameters" });
  problem(R"({"style": "oil", "parameters": {}})",
    { "style", "one of illustration, contours, line-art, splatting-lines, stipple, found \"oil\"" });
  problem(R"({"style": 1, "parameters": {}})",
    { "style", "one of illustration, contours, line-art, splatting-lines, stipple, found 1" });
  problem(R"({"style": "splatting-lines", "parameters": {}})",
    { R"(style: expected "stipple", found "splatting-lines")" });
  problem(R"({"style": "stipple", "parameters": {}, "author": 1})", { "'author'" });
  problem(File("stipple", R"("Oil": 1)"), { "'Oil'", "Sharpness" });
  problem(File("stipple", R"("BoundaryGain": 2, "Sharpness": 2)"), { "Sharpness", "from 0 to 1", "found 2" });
  problem(File("stipple", R"("Sharpness": [0.5])"), { "Sharpness", "[0.5]" });
  problem(File("stipple", R"("Sharpness": true)"), { "Sharpness", "true" });
  problem(File("stipple", R"("Sharpness": null)"), { "Sharpness", "null" });
  problem(File("stipple", R"("Sharpness": {"a": 1})"), { "Sharpness" });
  problem(File("stipple", R"("GrowWithZoom": 1)"), { "GrowWithZoom", "on or off" });
  problem(File("stipple", R"("GrowWithZoom": "yes")"), { "GrowWithZoom", "on or off" });
  problem(File("stipple", R"("Preset": 1)"), { "Preset", "bone" });
  problem(File("stipple", R"("Preset": "oil")"), { "Preset", "oil" });
  problem(File("stipple", R"("InkColor": [1, 2, 3])"), { "InkColor" });
  problem(File("stipple", R"("InkColor": [1, "0", 0])"), { "InkColor" });
  problem(File("stipple", R"("InkColor": 1)"), { "InkColor" });
  problem(File("stipple", R"("Scalars": 1)"), { "Scalars" });
  problem(File("stipple", R"("Seed": 1e400)"), {});
  EXPECT_EQ(style->GetParametersAsJSON(), before);
}

} // namespace
