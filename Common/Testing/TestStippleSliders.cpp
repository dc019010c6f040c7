// Each slider moves the ink the right way, all the way, from any preset.
#include "Tone/StippleSliders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
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

Ink draw(const ink::StippleTone& tone)
{
  const ink::StippleLight headlight{ { 0.0f, 0.0f, 1.0f, 0.0f }, 1.0f };
  const ink::StippleTone::View view{ 16.0f, 4.0f, 0.5f, true, 4.0f, 5.0f, 1.0f, 4.0f };
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
    const ink::StippleTone::Element element{ normal + glm::vec3(0.0f, 0.0f, -5.0f), shown, 0.8f,
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
  float ink::StippleSliders::*slider, double direction, const std::function<double(const Ink&)>& measure)
{
  for (const ink::StipplePreset& preset : ink::stipplePresets())
  {
    double first = 0.0;
    double last = 0.0;
    for (int step = 0; step <= 20; ++step)
    {
      ink::StippleTone tone;
      ink::StipplePreset moved = preset;
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
  expectMonotone(&ink::StippleSliders::gradient, 1.0, [](const Ink& ink) { return ink.all; });
}

TEST(StippleSliders, SharpnessAndInteriorTakeInkAway)
{
  expectMonotone(&ink::StippleSliders::sharpness, -1.0, [](const Ink& ink) { return ink.all; });
  expectMonotone(&ink::StippleSliders::interior, -1.0, [](const Ink& ink) { return ink.all; });
}

/// Light ink shows the light: less of it, in a smaller place.
TEST(StippleSliders, LightInkHasLessInkWithSharperLight)
{
  for (const auto slider : { &ink::StippleSliders::sharpness, &ink::StippleSliders::orientation })
  {
    double last = 0.0;
    for (int step = 0; step <= 20; ++step)
    {
      ink::StippleTone tone;
      ink::StipplePreset moved = *ink::findStipplePreset("plate-white-on-black");
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
  expectMonotone(
    &ink::StippleSliders::orientation, 1.0, [](const Ink& ink) { return ink.rim / (ink.rim + ink.middle); });
}

TEST(StippleSliders, DistanceTellsNearFromFar)
{
  expectMonotone(&ink::StippleSliders::distance, 1.0,
    [](const Ink& ink) { return ink.nearHalf / (ink.nearHalf + ink.farHalf); });
}

TEST(StippleSliders, ColorColors)
{
  expectMonotone(&ink::StippleSliders::color, 1.0, [](const Ink& ink) { return ink.chroma; });
  ink::StippleTone gray;
  ink::StippleTone colored;
  ink::StippleSliders sliders;
  sliders.apply(gray);
  sliders.color = 1.0f;
  sliders.apply(colored);
  EXPECT_EQ(draw(gray).all, draw(colored).all);
}

/// What is out of range counts as the end of the range.
TEST(StippleSliders, EndsHold)
{
  for (auto slider : { &ink::StippleSliders::gradient, &ink::StippleSliders::sharpness,
         &ink::StippleSliders::orientation, &ink::StippleSliders::distance, &ink::StippleSliders::interior })
  {
    for (float end : { 0.0f, 1.0f })
    {
      ink::StippleSliders at;
      ink::StippleSliders beyond;
      at.*slider = end;
      beyond.*slider = end == 0.0f ? -3.0f : 7.0f;
      ink::StippleTone a;
      ink::StippleTone b;
      at.apply(a);
      beyond.apply(b);
      const double found = draw(a).all;
      EXPECT_EQ(found, draw(b).all);
      EXPECT_TRUE(std::isfinite(found));
      EXPECT_GT(found, 0.0);
    }
  }
}

TEST(StippleSliders, PresetsAreFoundByName)
{
  for (const char* name : { "anatomy", "bone", "soft-tissue", "engineering", "plate-white-on-black" })
  {
    const auto* preset = ink::findStipplePreset(name);
    ASSERT_NE(preset, nullptr) << name;
    EXPECT_EQ(preset->lightInk, std::string(name) == "plate-white-on-black");
  }
  EXPECT_EQ(ink::findStipplePreset("Anatomy")->name, "anatomy");
  EXPECT_EQ(ink::findStipplePreset("SoftTissue")->name, "soft-tissue");
  EXPECT_EQ(ink::findStipplePreset("Plate, White on Black")->name, "plate-white-on-black");
  EXPECT_EQ(ink::findStipplePreset("plate"), nullptr);
  EXPECT_EQ(ink::findStipplePreset(""), nullptr);
}
