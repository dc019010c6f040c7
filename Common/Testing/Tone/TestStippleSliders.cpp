// SPDX-License-Identifier: BSD-3-Clause
// Each slider moves the ink the right way, all the way, from any preset.
#include "Tone/Stipple/Sliders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>

namespace
{

/// Ink on parts of a voxel sphere: all of it, its rim, its middle, its near half, its far half; and how
/// colorful.
struct Ink
{
  double all = 0.0;
  double rim = 0.0;
  double middle = 0.0;
  double nearHalf = 0.0;
  double farHalf = 0.0;
  double chroma = 0.0;
};

Ink draw(const ink::stipple::Tone& tone)
{
  const ink::Light headlight{ { 0.0f, 0.0f, 1.0f, 0.0f }, 1.0f };
  const ink::stipple::Tone::View view{ 16.0f, 4.0f, 0.5f, true, 4.0f, 5.0f, 1.0f, 4.0f };
  Ink ink;
  const int count = 3000;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = i * 2.399963;
    const double r = std::sqrt(1.0 - z * z);
    const glm::vec3 normal(r * std::cos(angle), r * std::sin(angle), z);
    const auto part = [i](double step) { return float(i * step - std::floor(i * step)); };
    // A layer of voxels that face the viewer at every depth, and the sphere.
    const bool facing = i % 2 == 0;
    const glm::vec3 shown = facing ? glm::vec3(0.0f, 0.6f, 0.8f) : normal;
    const ink::stipple::Tone::Element element{ normal + glm::vec3(0.0f, 0.0f, -5.0f), shown, 0.8f,
      0.05f + 0.95f * part(0.618034), 16.0f, part(0.7548777), glm::vec3(0.0f) };
    for (int rank = 0; rank < 16; ++rank)
    {
      const auto mark = tone.mark(view, { &headlight, 1 }, element, rank);
      const double area = mark.opacity * mark.diameter * mark.diameter;
      ink.all += area;
      (facing ? (z > 0.0 ? ink.nearHalf : ink.farHalf) : ink.all) += facing ? area : 0.0;
      if (!facing)
      {
        ink.rim += z > 0.0 && z < 0.3 ? area : 0.0;
        ink.middle += z > 0.7 ? area : 0.0;
      }
      const auto& c = mark.color;
      ink.chroma += area * (std::max({ c.r, c.g, c.b }) - std::min({ c.r, c.g, c.b }));
    }
  }
  return ink;
}

/// Checks that a measure never falls (or rises) along a slider and moves by at least a tenth altogether.
void expectMonotone(
  float ink::stipple::Sliders::*slider, double direction, const std::function<double(const Ink&)>& measure)
{
  for (const ink::stipple::Preset& preset : ink::stipple::presets())
  {
    double first = 0.0;
    double last = 0.0;
    for (int step = 0; step <= 20; ++step)
    {
      ink::stipple::Tone tone;
      ink::stipple::Preset moved = preset;
      moved.lightInk = false;
      moved.sliders.*slider = step / 20.0f;
      moved.apply(tone);
      const double now = measure(draw(tone));
      if (step == 0)
      {
        first = now;
      }
      else
      {
        EXPECT_GE(direction * (now - last), -1e-6 * std::abs(last)) << preset.name << ", step " << step;
      }
      last = now;
    }
    EXPECT_GT(direction * (last - first), 0.1 * std::max(std::abs(first), 1e-3)) << preset.name;
  }
}

} // namespace

TEST(StippleSliders, GradientAddsInk)
{
  expectMonotone(&ink::stipple::Sliders::gradient, 1.0, [](const Ink& ink) { return ink.all; });
}

TEST(StippleSliders, SharpnessAndInteriorTakeInkAway)
{
  expectMonotone(&ink::stipple::Sliders::sharpness, -1.0, [](const Ink& ink) { return ink.all; });
  expectMonotone(&ink::stipple::Sliders::interior, -1.0, [](const Ink& ink) { return ink.all; });
}

/// Light ink shows the light: less of it, in a smaller region.
TEST(StippleSliders, LightInkHasLessInkWithSharperLight)
{
  for (const auto slider : { &ink::stipple::Sliders::sharpness, &ink::stipple::Sliders::orientation })
  {
    double last = 0.0;
    for (int step = 0; step <= 20; ++step)
    {
      ink::stipple::Tone tone;
      ink::stipple::Preset moved = *ink::stipple::findPreset("plate-white-on-black");
      moved.sliders.*slider = step / 20.0f;
      moved.apply(tone);
      // The light alone.
      tone.boundary.on = tone.silhouette.on = tone.distance.on = tone.interior.on = false;
      const double now = draw(tone).all;
      EXPECT_TRUE(step == 0 || now < last) << "step " << step << ", ink " << last << " to " << now;
      EXPECT_GT(now, 100.0);
      last = now;
    }
  }
}

TEST(StippleSliders, OrientationTellsTheRimFromTheMiddle)
{
  expectMonotone(&ink::stipple::Sliders::orientation, 1.0,
    [](const Ink& ink) { return ink.rim / (ink.rim + ink.middle); });
}

TEST(StippleSliders, DistanceTellsNearFromFar)
{
  expectMonotone(&ink::stipple::Sliders::distance, 1.0,
    [](const Ink& ink) { return ink.nearHalf / (ink.nearHalf + ink.farHalf); });
}

TEST(StippleSliders, ColorColors)
{
  expectMonotone(&ink::stipple::Sliders::color, 1.0, [](const Ink& ink) { return ink.chroma; });
  ink::stipple::Tone gray;
  ink::stipple::Tone colored;
  ink::stipple::Sliders sliders;
  sliders.apply(gray);
  sliders.color = 1.0f;
  sliders.apply(colored);
  EXPECT_EQ(draw(gray).all, draw(colored).all);
}

/// What is out of range counts as the end of the range.
TEST(StippleSliders, EndsHold)
{
  for (auto slider : { &ink::stipple::Sliders::gradient, &ink::stipple::Sliders::sharpness,
         &ink::stipple::Sliders::orientation, &ink::stipple::Sliders::distance,
         &ink::stipple::Sliders::interior })
  {
    for (float end : { 0.0f, 1.0f })
    {
      ink::stipple::Sliders at;
      ink::stipple::Sliders beyond;
      at.*slider = end;
      beyond.*slider = end == 0.0f ? -3.0f : 7.0f;
      ink::stipple::Tone a;
      ink::stipple::Tone b;
      at.apply(a);
      beyond.apply(b);
      const double found = draw(a).all;
      EXPECT_EQ(found, draw(b).all);
      EXPECT_TRUE(std::isfinite(found));
      EXPECT_GT(found, 0.0);
    }
  }
}

/// What each slider comes to, as Documentation/stipple.md says, with `g` 0 to 4 and `s` a quarter to 4.
TEST(StippleSliders, StandForTheirKs)
{
  const struct
  {
    float slider;
    float gain;
    float octaves;
  } positions[] = { { 0.0f, 0.0f, 0.25f }, { 0.25f, 0.5f, 0.5f }, { 0.5f, 1.0f, 1.0f }, { 0.75f, 2.5f, 2.0f },
    { 1.0f, 4.0f, 4.0f } };
  for (const auto& gradient : positions)
  {
    for (const auto& sharpness : positions)
    {
      for (const auto& orientation : positions)
      {
        for (const bool lightInk : { false, true })
        {
          ink::stipple::Tone tone;
          tone.lighting.lightInk = lightInk;
          const ink::stipple::Sliders sliders{ gradient.slider, sharpness.slider, orientation.slider };
          sliders.apply(tone);
          EXPECT_FLOAT_EQ(tone.boundary.base, 0.1f + 0.5f * gradient.slider);
          EXPECT_FLOAT_EQ(tone.boundary.gain, 0.65f * gradient.gain);
          EXPECT_FLOAT_EQ(tone.boundary.exponent, 0.8f * sharpness.octaves);
          EXPECT_FLOAT_EQ(tone.silhouette.gain, 1.6f * orientation.gain);
          EXPECT_FLOAT_EQ(tone.silhouette.exponent, 0.5f / sharpness.octaves);
          const float light = sharpness.octaves * orientation.gain;
          EXPECT_FLOAT_EQ(tone.lighting.exponent, std::clamp(lightInk ? light : 1.0f / light, 0.05f, 20.0f))
            << "sharpness " << sharpness.slider << ", orientation " << orientation.slider;
        }
      }
    }
  }
  for (const auto& position : positions)
  {
    ink::stipple::Tone tone;
    const ink::stipple::Sliders sliders{ 0.5f, 0.5f, 0.5f, position.slider, position.slider,
      position.slider };
    sliders.apply(tone);
    EXPECT_FLOAT_EQ(tone.distance.exponent, std::min(0.5f / position.slider, 20.0f));
    EXPECT_EQ(tone.distance.size, position.slider);
    EXPECT_FLOAT_EQ(tone.interior.exponent, 2.0f * position.slider);
    EXPECT_EQ(tone.interior.size, position.slider);
    EXPECT_EQ(tone.warmCool.amount, position.slider);
  }
}

/// All that the drawings of each preset are made of: a number that changes changes them.
TEST(StippleSliders, PresetsAreWhatTheyWere)
{
  using Numbers = std::array<float, 6>;
  const struct
  {
    const char* name;
    Numbers sliders;
    Numbers others; ///< pixels a stipple, diameter, parts by size, k_nz, effect of the value, light ink
  } expected[] = {
    { "anatomy", { 0.5f, 0.5f, 0.5f, 0.15f, 0.15f, 0.0f }, { 6.0f, 2.2f, 1.0f, 1.0f, 0.25f, 0.0f } },
    { "bone", { 0.65f, 0.6f, 0.5f, 0.15f, 0.35f, 0.0f }, { 6.0f, 2.2f, 1.0f, 1.0f, 0.25f, 0.0f } },
    { "soft-tissue", { 0.45f, 0.3f, 0.5f, 0.1f, 0.05f, 0.0f }, { 7.0f, 1.8f, 0.0f, 1.0f, 0.25f, 0.0f } },
    { "engineering", { 0.5f, 0.65f, 0.75f, 0.05f, 0.15f, 0.0f }, { 7.0f, 2.0f, 1.0f, 0.8f, 0.25f, 0.0f } },
    { "plate-white-on-black", { 0.6f, 0.5f, 0.5f, 0.2f, 0.15f, 0.0f },
      { 7.0f, 2.2f, 1.0f, 1.0f, 0.25f, 1.0f } },
    { "as-published", { 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.0f }, { 1.0f, 1.13f, 0.0f, 1.0f, 1.0f, 0.0f } },
  };
  ASSERT_EQ(ink::stipple::presets().size(), std::size(expected));
  for (std::size_t i = 0; i < std::size(expected); ++i)
  {
    const ink::stipple::Preset& preset = ink::stipple::presets()[i];
    EXPECT_EQ(preset.name, expected[i].name);
    const ink::stipple::Sliders& s = preset.sliders;
    EXPECT_EQ((Numbers{ s.gradient, s.sharpness, s.orientation, s.distance, s.interior, s.color }),
      expected[i].sliders)
      << preset.name;
    ink::stipple::Tone tone;
    preset.apply(tone);
    EXPECT_EQ((Numbers{ tone.pixelsPerStipple, tone.diameter, tone.fadeBySize ? 1.0f : 0.0f,
                tone.resolution.slantExponent, tone.valueEffect, tone.lighting.lightInk ? 1.0f : 0.0f }),
      expected[i].others)
      << preset.name;
  }
}

/// Table 1 written out, with the k's that the preset as-published comes to: nothing else is in T.
TEST(StippleSliders, AsPublishedIsTable1)
{
  ink::stipple::Tone tone;
  ink::stipple::findPreset("as-published")->apply(tone);
  EXPECT_EQ(tone.pixelsPerStipple, 1.0f);
  // N_max 3.5 at the nearest distance, 4; D_near + d_i from 4 on; the light comes from above the eye.
  const ink::stipple::Tone::View view{ 16.0f, 3.5f, 0.0f, false, 4.0f, 6.0f, 2.0f, 4.0f };
  const ink::Light light{ { 0.0f, 0.6f, 0.8f, 0.0f }, 1.0f };
  int compared = 0;
  for (const double distance : { 4.0, 5.0, 6.0, 7.5 })
  {
    for (const double turn : { 0.1, 0.5, 1.0, 1.4 })
    {
      for (const double v : { 0.1, 0.5, 1.0 })
      {
        for (const double g : { 0.05, 0.4, 1.0 })
        {
          const double facing = std::cos(turn);                   // N.E
          const double lit = 0.6 * std::sin(turn) + 0.8 * facing; // N.L
          const double z = (6.0 - distance) / 2.0;                // z/a
          const double expected = 3.5 * v * (0.35 + 0.65 * std::pow(g, 0.8)) * v *
            (0.3 + 1.6 * (1.0 - std::pow(facing, 0.5))) * std::pow(distance / 4.0, -2.0) * facing *
            (1.0 - lit) * (1.0 + z) * g;
          const ink::stipple::Tone::Element element{ { 0.0f, 0.0f, static_cast<float>(-distance) },
            { 0.0f, static_cast<float>(std::sin(turn)), static_cast<float>(facing) }, static_cast<float>(v),
            static_cast<float>(g), 16.0f, 0.3f, glm::vec3(0.0f) };
          const auto mark = tone.mark(view, { &light, 1 }, element, 0);
          EXPECT_NEAR(mark.tone, expected, 1e-5 + 1e-5 * expected)
            << "distance " << distance << ", turned " << turn << ", v " << v << ", gradient " << g;
          ++compared;
        }
      }
    }
  }
  EXPECT_EQ(compared, 144);
}

TEST(StippleSliders, PresetsAreFoundByName)
{
  for (const char* name :
    { "anatomy", "bone", "soft-tissue", "engineering", "plate-white-on-black", "as-published" })
  {
    const auto* preset = ink::stipple::findPreset(name);
    ASSERT_NE(preset, nullptr) << name;
    EXPECT_EQ(preset->lightInk, std::string(name) == "plate-white-on-black");
  }
  EXPECT_EQ(ink::stipple::findPreset("Anatomy")->name, "anatomy");
  EXPECT_EQ(ink::stipple::findPreset("SoftTissue")->name, "soft-tissue");
  EXPECT_EQ(ink::stipple::findPreset("Plate, White on Black")->name, "plate-white-on-black");
  EXPECT_EQ(ink::stipple::findPreset("As Published")->name, "as-published");
  EXPECT_EQ(ink::stipple::findPreset("plate"), nullptr);
  EXPECT_EQ(ink::stipple::findPreset(""), nullptr);
}
