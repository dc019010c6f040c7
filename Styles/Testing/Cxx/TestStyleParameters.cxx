// SPDX-License-Identifier: BSD-3-Clause
// Every parameter of every style by name: defaults, ranges, what is refused, what others set.
#include "StyleErrors.h"

#include "InkParameter.h"
#include "vtkInkStippleControls.h"
#include "vtkInkStippleMapper.h"
#include "vtkInkStippleStyle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace
{

using Type = InkParameterType;

bool HasRange(const InkParameter& row)
{
  return row.Type == Type::Int || row.Type == Type::Double;
}

/// Another value than the default, which the parameter can have.
InkParameterValue Another(const InkParameter& row, vtkInkStyle* style)
{
  InkParameterValue value = row.Get(style);
  switch (row.Type)
  {
    case Type::Bool:
      value.Numbers[0] = 1.0 - value.Numbers[0];
      break;
    case Type::Enum:
      value.Numbers[0] = row.Entries[value.Numbers[0] == row.Entries[0].Value ? 1 : 0].Value;
      break;
    case Type::Int:
      value.Numbers[0] += value.Numbers[0] < row.GetGreatest(style) ? 1.0 : -1.0;
      break;
    case Type::Double:
      value.Numbers[0] = value.Numbers[0] < row.GetGreatest(style)
        ? std::min(row.GetGreatest(style), value.Numbers[0] + 0.125)
        : row.GetLeast(style);
      break;
    case Type::Color:
      value.Numbers = { 0.25, 0.5, 0.75 };
      break;
    case Type::Colors:
      value.Numbers = { 0.25, 0.5, 0.75, 1.0, 0.0, 0.5 };
      break;
    case Type::Vector:
      value.Numbers.assign(static_cast<std::size_t>(row.Size), 3.0);
      value.Numbers.back() = 4.5;
      break;
    case Type::List:
      value.Numbers = { 80.0, 120.5 };
      break;
    case Type::String:
      value.Text = row.Name == std::string("Texture") ? INK_DATA_DIR "/pencil.png"
        : row.CheckText                               ? "viridis"
                                                      : "pressure";
      break;
  }
  return value;
}

TEST(StyleParameters, DefaultsAreThoseOfANewStyle)
{
  for (const auto& style : MakeStyles())
  {
    for (const InkParameter& row : style->GetParameterTable().Parameters)
    {
      EXPECT_EQ(row.Format(row.Get(style)), row.Default) << style->GetName() << ' ' << row.Name;
    }
  }
}

TEST(StyleParameters, NamesAndOptionsAreUnique)
{
  for (const auto& style : MakeStyles())
  {
    std::set<std::string> names;
    std::set<std::string> options;
    for (const InkParameter& row : style->GetParameterTable().Parameters)
    {
      EXPECT_TRUE(names.insert(row.Name).second) << row.Name;
      EXPECT_TRUE(options.insert(row.Option).second) << row.Option;
      EXPECT_EQ(row.Text[std::string(row.Text).size() - 1], '.') << row.Name;
    }
  }
}

TEST(StyleParameters, EachCanBeSetAlone)
{
  for (const auto& style : MakeStyles())
  {
    for (const InkParameter& row : style->GetParameterTable().Parameters)
    {
      style->ResetParameters();
      const InkParameterValue value = Another(row, style);
      ASSERT_NE(value, row.Get(style)) << row.Name;
      EXPECT_TRUE(style->SetParameterAsString(row.Name, row.Format(value).c_str())) << row.Name;
      EXPECT_EQ(row.Get(style), value) << row.Name << " found " << row.Format(row.Get(style));
      EXPECT_EQ(style->GetParameterAsString(row.Name), row.Format(value));
    }
  }
}

/// The table's range is that of the class that the parameter is set on: both ends are kept, and what is
/// beyond is clamped there, where the table did not refuse it.
TEST(StyleParameters, RangesAreThoseOfTheClasses)
{
  int clamped = 0;
  for (const auto& style : MakeStyles())
  {
    for (const InkParameter& row : style->GetParameterTable().Parameters)
    {
      if (!HasRange(row) || row.Greatest >= 1e6)
      {
        continue;
      }
      for (const double end : { row.Least, row.Greatest })
      {
        EXPECT_TRUE(style->SetParameter(row.Name, end)) << row.Name;
        EXPECT_EQ(style->GetParameter(row.Name), end) << row.Name;
        const double beyond = end == row.Least ? end - 1.0 : end + 1.0;
        const StyleErrors errors(style);
        EXPECT_FALSE(style->SetParameter(row.Name, beyond));
        EXPECT_EQ(style->GetParameter(row.Name), end) << row.Name;
        ASSERT_EQ(errors.All.size(), 1u);
        EXPECT_NE(errors.All[0].find(std::string(row.Name) + ": expected"), std::string::npos)
          << errors.All[0];
        row.Set(style, { { beyond }, {} });
        clamped += row.Get(style).Numbers[0] == end ? 1 : 0;
        row.Set(style, { { end }, {} });
      }
    }
  }
  // All but those of the styles themselves, which nothing but the table sets.
  EXPECT_GT(clamped, 60);
}

TEST(StyleParameters, WrongNamesAndValuesAreOneErrorAndChangeNothing)
{
  vtkNew<vtkInkStippleStyle> style;
  const std::string before = style->GetParametersAsJSON();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const auto& set, const std::vector<std::string>& words)
  {
    StyleErrors errors(style);
    EXPECT_FALSE(set());
    ASSERT_EQ(errors.All.size(), 1u);
    for (const std::string& word : words)
    {
      EXPECT_NE(errors.All[0].find(word), std::string::npos) << errors.All[0] << " lacks " << word;
    }
  };
  refused([&] { return style->SetParameter("Sharpnes", 0.5); }, { "'Sharpnes'", "stipple", "Sharpness" });
  refused([&] { return style->SetParameter(nullptr, 0.5); }, { "''" });
  refused([&] { return style->SetParameter("Sharpness", 1.5); }, { "Sharpness", "from 0 to 1", "'1.5'" });
  refused([&] { return style->SetParameter("Sharpness", nan); }, { "Sharpness", "from 0 to 1" });
  refused([&] { return style->SetParameter("Sharpness", 0.1, 0.2); }, { "Sharpness", "0.1,0.2" });
  refused([&] { return style->SetParameter("ScalarWindow", 5, 1); }, { "ScalarWindow", "lower value first" });
  refused([&] { return style->SetParameter("ColorRange", 3, 3); }, { "ColorRange", "lower value first" });
  refused([&] { return style->SetParameter("MaximumStipples", 2.5); }, { "whole number", "2.5" });
  refused([&] { return style->SetParameter("InkColor", 0, 0, 1.5); }, { "InkColor", "from 0 to 1" });
  refused([&] { return style->SetParameter("Preset", 17); }, { "Preset", "anatomy", "or as-published" });
  refused([&] { return style->SetParameterAsString("Preset", "oil"); }, { "Preset", "bone", "'oil'" });
  refused([&] { return style->SetParameterAsString("Preset", ""); }, { "Preset", "bone" });
  refused([&] { return style->SetParameterAsString("GrowWithZoom", "maybe"); }, { "on or off", "'maybe'" });
  refused([&] { return style->SetParameterAsString("GrowWithZoom", "-1"); }, { "on or off", "'-1'" });
  refused([&] { return style->SetParameterAsString("Preset", ".4"); }, { "Preset", "'.4'" });
  refused([&] { return style->SetParameterAsString("BoundaryBase", "1x"); }, { "BoundaryBase", "'1x'" });
  refused([&] { return style->SetParameterAsString("BoundaryBase", "nan"); }, { "BoundaryBase", "'nan'" });
  refused([&] { return style->SetParameterAsString("IsoValues", "1,"); }, { "IsoValues", "'1,'" });
  refused([&] { return style->SetParameterAsString("InkColor", "mauvish"); }, { "HTML", "'mauvish'" });
  refused([&] { return style->SetParameterAsString("ColorMap", "red"); }, { "ColorMap", "viridis", "'red'" });
  refused([&] { return style->SetParameterAsString("ColorMap", "red,mauvish"); }, { "'mauvish'" });
  EXPECT_EQ(style->GetParametersAsJSON(), before);
}

TEST(StyleParameters, ColorsAreReadByName)
{
  vtkNew<vtkInkStippleStyle> style;
  for (const char* red : { "red", "#ff0000", "#F00", "1,0,0" })
  {
    style->SetParameterAsString("InkColor", "black");
    EXPECT_TRUE(style->SetParameterAsString("InkColor", red));
    EXPECT_EQ(style->GetParameterAsString("InkColor"), "1,0,0") << red;
  }
}

/// What a slider sets is what differs between its ends, as far as vtkInkStippleControls says; the rest stays.
TEST(StyleParameters, SlidersSetWhatTheyStandFor)
{
  for (const char* slider : { "Gradient", "Sharpness", "Orientation", "Distance", "Interior", "Color" })
  {
    vtkNew<vtkInkStippleStyle> style;
    const InkParameterTable& table = style->GetParameterTable();
    std::set<std::string> follow;
    std::vector<InkParameterValue> low;
    for (const double end : { 0.0, 1.0 })
    {
      style->ResetParameters();
      style->SetParameter(slider, end);
      for (std::size_t i = 0; i < table.Parameters.size(); ++i)
      {
        const InkParameterValue value = table.Parameters[i].Get(style);
        if (end == 0.0)
        {
          low.push_back(value);
        }
        else if (low[i] != value)
        {
          follow.insert(table.Parameters[i].Name);
        }
      }
    }
    EXPECT_GT(follow.size(), 1u) << slider;
    // The mapper as the controls would have it, at a slider's position and with another preset.
    vtkNew<vtkInkStippleControls> controls;
    controls->SetPreset("bone");
    controls->SetSharpness(0.9);
    style->ResetParameters();
    style->ApplyPreset("bone");
    style->SetParameter("Sharpness", 0.9);
    vtkNew<vtkInkStippleMapper> wanted;
    controls->Apply(wanted);
    EXPECT_EQ(style->GetParameter("BoundaryExponent"), wanted->GetBoundaryExponent());
    EXPECT_EQ(style->GetParameter("SilhouetteExponent"), wanted->GetSilhouetteExponent());
    EXPECT_EQ(style->GetParameter("LightingExponent"), wanted->GetLightingExponent());
    // What the slider does not stand for stays as it was chosen.
    style->ResetParameters();
    for (const InkParameter& row : table.Parameters)
    {
      if (row.Group == std::string("Enhancements") && !follow.contains(row.Name))
      {
        row.Set(style, Another(row, style));
      }
    }
    std::vector<InkParameterValue> chosen;
    for (const InkParameter& row : table.Parameters)
    {
      chosen.push_back(row.Get(style));
    }
    style->SetParameter(slider, 0.7);
    for (std::size_t i = 0; i < table.Parameters.size(); ++i)
    {
      const InkParameter& row = table.Parameters[i];
      if (!follow.contains(row.Name))
      {
        EXPECT_EQ(row.Get(style), chosen[i]) << slider << " changed " << row.Name;
      }
    }
  }
}

TEST(StyleParameters, PresetsSetAllThatGoesWithThem)
{
  for (int preset = 0; preset < vtkInkStippleControls::GetNumberOfPresets(); ++preset)
  {
    vtkNew<vtkInkStippleStyle> style;
    ASSERT_EQ(style->GetNumberOfPresets(), vtkInkStippleControls::GetNumberOfPresets());
    EXPECT_STREQ(style->GetPresetName(preset), vtkInkStippleControls::GetPresetName(preset));
    // Whatever was there before.
    for (const InkParameter& row : style->GetParameterTable().Parameters)
    {
      if (row.Group == std::string("Enhancements"))
      {
        row.Set(style, Another(row, style));
      }
    }
    style->SetParameter("FacingAngle", 90);
    style->SetParameter("Headlight", 0);
    EXPECT_TRUE(style->ApplyPreset(style->GetPresetName(preset)));
    EXPECT_EQ(style->GetParameterAsString("Preset"), style->GetPresetName(preset));
    vtkNew<vtkInkStippleStyle> fresh;
    fresh->SetParameter("Preset", preset);
    EXPECT_EQ(style->GetParametersAsJSON(), fresh->GetParametersAsJSON());
    vtkNew<vtkInkStippleControls> controls;
    controls->SetPreset(vtkInkStippleControls::GetPresetName(preset));
    vtkNew<vtkInkStippleMapper> wanted;
    controls->Apply(wanted);
    EXPECT_EQ(style->GetStippleMapper()->GetBoundaryGain(), wanted->GetBoundaryGain());
    EXPECT_EQ(style->GetParameter("StippleSize"), wanted->GetStippleSize());
    double paper[3];
    double background[3];
    controls->GetPaperColor(paper);
    style->GetBackgroundColor(background);
    EXPECT_EQ(paper[0], background[0]);
  }
}

TEST(StyleParameters, PixelsAreThePicturesOwn)
{
  vtkNew<vtkInkStippleStyle> style;
  style->SetParameter("StippleSize", 3);
  style->SetParameter("PixelsPerStipple", 5);
  style->SetPixelScale(2);
  // Thousandths of the height are the same ones in any picture.
  EXPECT_EQ(style->GetStippleMapper()->GetStippleSize(), 3);
  EXPECT_EQ(style->GetStippleMapper()->GetPixelsPerStipple(), 5);
  EXPECT_EQ(style->GetStippleMapper()->GetSizeUnit(), vtkInkStippleMapper::THOUSANDTHS);
  style->SetParameterAsString("SizeUnit", "pixels");
  EXPECT_EQ(style->GetStippleMapper()->GetSizeUnit(), vtkInkStippleMapper::PIXELS);
  EXPECT_EQ(style->GetStippleMapper()->GetStippleSize(), 6);
  EXPECT_EQ(style->GetStippleMapper()->GetPixelsPerStipple(), 20);
  EXPECT_EQ(style->GetParameter("StippleSize"), 3);
  // In a hundred tiles on either side, which mappers enlarge pixels for.
  style->SetPixelScale(0.01);
  EXPECT_DOUBLE_EQ(style->GetStippleMapper()->GetStippleSize(), 0.03);
  EXPECT_DOUBLE_EQ(style->GetStippleMapper()->GetPixelsPerStipple(), 5e-4);
  style->SetPixelScale(2);
  // 100 pixels are the mapper's most.
  EXPECT_TRUE(style->SetParameter("StippleSize", 50));
  EXPECT_EQ(style->GetStippleMapper()->GetStippleSize(), 100);
  const StyleErrors errors(style);
  EXPECT_FALSE(style->SetParameter("StippleSize", 51));
  EXPECT_EQ(errors.All.size(), 1u);
}

} // namespace
