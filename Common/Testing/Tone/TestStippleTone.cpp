// SPDX-License-Identifier: BSD-3-Clause
// The whole sequence of Lu et al. 2003, section 5.
#include "Tone/Stipple/Tone.h"

#include "Tone/Stipple/ProjectedSize.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr ink::stipple::Tone::View view{ 16.0f, 8.0f, 0.0f, false, 4.0f, 6.0f, 2.0f, 4.0f };

ink::stipple::Tone::Element element()
{
  return { { 0.0f, 0.0f, -5.0f }, { 0.0f, 0.6f, 0.8f }, 0.7f, 0.4f, 16.0f, 0.3f, { 0.1f, 0.2f, 0.3f } };
}

ink::stipple::Tone allOff()
{
  ink::stipple::Tone tone;
  tone.boundary.on = tone.silhouette.on = tone.resolution.on = false;
  tone.lighting.on = tone.distance.on = tone.interior.on = false;
  return tone;
}

const ink::Light headlight{ { 0.0f, 0.0f, 1.0f, 0.0f }, 1.0f };

} // namespace

TEST(StippleTone, WithoutEnhancementsIsNMax)
{
  EXPECT_FLOAT_EQ(allOff().mark(view, { &headlight, 1 }, element(), 0).tone, 8.0f);
}

TEST(StippleTone, IsTheProductOfTheChosenFactors)
{
  ink::stipple::Tone tone;
  const auto found = tone.mark(view, { &headlight, 1 }, element(), 0);
  const double boundary =
    0.7 * (tone.boundary.base + tone.boundary.gain * std::pow(0.4, tone.boundary.exponent));
  const double silhouette =
    0.7 * (tone.silhouette.base + tone.silhouette.gain * (1.0 - std::pow(0.8, tone.silhouette.exponent)));
  const double resolution = std::pow(5.0 / 4.0, -2.0) * 0.8;
  const double light = 1.0 - std::pow(0.8, tone.lighting.exponent);
  const double distance = 1.0 + std::pow(0.5, tone.distance.exponent);
  const double interior = std::pow(0.4, tone.interior.exponent);
  EXPECT_NEAR(found.tone, 8.0 * boundary * silhouette * resolution * light * distance * interior, 1e-5);
  EXPECT_NEAR(found.diameter, 2.0 * (1.0 + 0.5 * (distance - 1.0)) * (1.0 + 0.5 * (interior - 1.0)), 1e-5);
  EXPECT_EQ(found.color, element().color);

  tone.surface = true;
  EXPECT_NEAR(
    tone.mark(view, { &headlight, 1 }, element(), 0).tone, 8.0 * resolution * light * distance, 1e-5);
}

TEST(StippleTone, OneFactorAtATime)
{
  const double off = allOff().mark(view, { &headlight, 1 }, element(), 0).tone;
  const auto ratio = [&](auto chosen)
  {
    ink::stipple::Tone tone = allOff();
    (tone.*chosen).on = true;
    return tone.mark(view, { &headlight, 1 }, element(), 0).tone / off;
  };
  // Table 1 with the defaults.
  EXPECT_NEAR(ratio(&ink::stipple::Tone::boundary), 0.7 * (0.2 + 1.0 * 0.4), 1e-5);
  EXPECT_NEAR(ratio(&ink::stipple::Tone::silhouette), 0.7 * (0.3 + 2.0 * (1.0 - std::sqrt(0.8))), 1e-5);
  EXPECT_NEAR(ratio(&ink::stipple::Tone::resolution), 0.64 * 0.8, 1e-5);
  EXPECT_NEAR(ratio(&ink::stipple::Tone::lighting), 0.2, 1e-5);
  EXPECT_NEAR(ratio(&ink::stipple::Tone::distance), 1.5, 1e-5);
  EXPECT_NEAR(ratio(&ink::stipple::Tone::interior), 0.4, 1e-5);
}

TEST(StippleTone, WhatFacesAway)
{
  auto away = element();
  away.normal = -away.normal;
  ink::stipple::Tone volume = allOff();
  EXPECT_EQ(volume.mark(view, {}, away, 0).opacity, 1.0f); // points are see-through
  volume.lighting.on = true;
  EXPECT_EQ(volume.mark(view, {}, away, 0).opacity, 0.0f); // but lighting needs a front
  EXPECT_EQ(volume.mark(view, {}, element(), 0).opacity, 1.0f);
  volume.lighting.facingCosine = 0.9f;
  EXPECT_EQ(volume.mark(view, {}, element(), 0).opacity, 0.0f);

  ink::stipple::Tone surface = allOff();
  surface.surface = true;
  EXPECT_EQ(surface.mark(view, {}, away, 0).opacity, 0.0f);
  surface.twoSided = true;
  surface.lighting.on = true;
  EXPECT_EQ(surface.mark(view, { &headlight, 1 }, away, 0).tone,
    surface.mark(view, { &headlight, 1 }, element(), 0).tone);
}

/// The nearest element has most room; with a positive k_rc one farther away may have more, without a limit.
TEST(StippleTone, LargestDiameterIsThatOfTheNearest)
{
  ink::stipple::Tone tone = allOff();
  ink::stipple::Tone::View close = view;
  close.maximumStipples = 4.0f * close.listed;
  close.closest = close.nearest / 3.0f;
  const auto found = [&] { return tone.largestDiameter(close) / tone.diameter; };
  for (const bool on : { false, true })
  {
    for (const float exponent : { -2.0f, 0.0f, 1.0f })
    {
      tone.resolution.on = on;
      tone.resolution.exponent = exponent;
      SCOPED_TRACE(std::to_string(on) + ' ' + std::to_string(exponent));
      close.parallel = false;
      EXPECT_FLOAT_EQ(found(), on && exponent > 0.0f ? std::numeric_limits<float>::infinity() : 6.0f);
      close.parallel = true;
      EXPECT_FLOAT_EQ(found(), 2.0f);
    }
  }
  tone.growWithZoom = false;
  EXPECT_FLOAT_EQ(found(), 1.0f);
}

/// Close up, lists run out: fewer stipples than there is room for, but larger, so that their area is right.
TEST(StippleTone, GrowsWhereListsAreTooShort)
{
  for (float maximum : { 4.0f, 16.0f, 64.0f, 1024.0f })
  {
    ink::stipple::Tone::View close = view;
    close.maximumStipples = maximum;
    const auto mark = allOff().mark(close, {}, element(), 0);
    const double area = mark.tone * mark.diameter * mark.diameter;
    EXPECT_NEAR(area / (maximum * 4.0), 1.0, 1e-5) << "N_max " << maximum;
    EXPECT_LE(mark.tone, 16.0f);
    EXPECT_LE(mark.diameter, allOff().largestDiameter(close));
    ink::stipple::Tone fixed = allOff();
    fixed.growWithZoom = false;
    EXPECT_FLOAT_EQ(fixed.mark(close, {}, element(), 0).diameter, 2.0f);
  }
}

/// A part of a stipple has the same area as a paler or as a smaller one.
TEST(StippleTone, AppearsBySizeOrByOpacity)
{
  ink::stipple::Tone tone = allOff();
  ink::stipple::Tone::View far = view;
  far.maximumStipples = 0.3f;
  const auto paler = tone.mark(far, {}, element(), 0);
  EXPECT_NEAR(paler.opacity, 0.3f, 1e-6f);
  tone.fadeBySize = true;
  const auto smaller = tone.mark(far, {}, element(), 0);
  EXPECT_EQ(smaller.opacity, 1.0f);
  EXPECT_NEAR(smaller.diameter * smaller.diameter, 0.3f * 4.0f, 1e-5f);
  EXPECT_EQ(tone.mark(far, {}, element(), 1).opacity, 0.0f);
}

TEST(StippleTone, ListsEnd)
{
  auto shortList = element();
  shortList.listLength = 2.0f;
  ink::stipple::Tone tone = allOff();
  tone.growWithZoom = false;
  ink::stipple::Tone::View close = view;
  close.maximumStipples = 1e4f;
  EXPECT_EQ(tone.mark(close, {}, shortList, 1).opacity, 1.0f);
  EXPECT_EQ(tone.mark(close, {}, shortList, 2).opacity, 0.0f);
}

TEST(StippleTone, ParallelProjectionsIgnoreTheDistance)
{
  ink::stipple::Tone tone = allOff();
  tone.resolution.on = true;
  ink::stipple::Tone::View parallel = view;
  parallel.parallel = true;
  auto far = element();
  far.position = { 3.0f, 1.0f, -50.0f };
  EXPECT_FLOAT_EQ(tone.mark(parallel, {}, far, 0).tone, 8.0f * 0.8f);
}

/// No element exceeds what its group is said to need at most.
TEST(StippleTone, MostToneIsAnUpperBound)
{
  ink::stipple::Tone tone;
  tone.resolution.slantExponent = 0.1f;
  const ink::Light sun{ glm::vec4(glm::normalize(glm::vec3(0.4f, 0.5f, 1.0f)), 0.0f), 0.8f };
  int near = 0;
  int nothing = 0;
  for (int kind = 0; kind < 8; ++kind)
  {
    tone.growWithZoom = kind & 1;
    tone.lighting.lightInk = kind & 2;
    tone.surface = kind & 4;
    for (float krc : { -2.0f, 0.0f, 1.0f })
    {
      // Normals within a cone around the x-z plane's direction of that angle.
      for (float angle : { 0.3f, 1.2f, 2.5f })
      {
        tone.resolution.exponent = krc;
        std::vector<ink::stipple::Tone::Element> group;
        ink::stipple::Tone::Directions directions{ 1.0f, -1.0f, 1.0f, 0.0f };
        for (int i = 0; i < 500; ++i)
        {
          const auto fraction = [i](double step) { return float(i * step - std::floor(i * step)); };
          auto one = element();
          one.position = { 0.0f, 0.0f, -4.0f - 4.0f * fraction(0.618034) };
          const float turn = angle + 0.3f * (fraction(0.7548777) - 0.5f);
          one.normal = { std::sin(turn), 0.0f, std::cos(turn) };
          one.value = 0.9f * fraction(0.569840);
          one.gradientMagnitude = 0.8f * fraction(0.819173);
          const float cosine = one.normal.z;
          const float lit = tone.lighting.lit({ &sun, 1 }, one.position, one.normal);
          directions.leastCosine = std::min(directions.leastCosine, cosine);
          directions.mostCosine = std::max(directions.mostCosine, cosine);
          directions.leastLit = std::min(directions.leastLit, lit);
          directions.mostLit = std::max(directions.mostLit, lit);
          group.push_back(one);
        }
        const float most = tone.mostTone(view, 0.9f, 0.8f, 16.0f, 4.0f, 8.0f, directions);
        nothing += most == 0.0f;
        for (const auto& one : group)
        {
          const auto mark = tone.mark(view, { &sun, 1 }, one, 0);
          const float found = mark.opacity > 0.0f ? mark.tone : 0.0f;
          EXPECT_LE(found, most * 1.00001f);
          near += found > 0.1f * most && most > 0.0f;
        }
      }
    }
  }
  EXPECT_GT(near, 10);
  EXPECT_GT(nothing, 0);
  EXPECT_EQ(ink::stipple::Tone().mostTone(view, 0.0f, 0.8f, 16.0f, 4.0f, 8.0f, {}), 0.0f);
  // Of which nothing is known but its values: some of it may be fully lit, some not at all.
  ink::stipple::Tone plain = allOff();
  plain.lighting.on = true;
  for (const bool lightInk : { false, true })
  {
    plain.lighting.lightInk = lightInk;
    EXPECT_FLOAT_EQ(plain.mostTone(view, 0.9f, 0.8f, 16.0f, 4.0f, 8.0f, {}), 8.0f) << lightInk;
  }
  // A group around the eye: one of its elements may be as near as none.
  auto atTheEye = element();
  atTheEye.position.z = -1e-9f;
  ink::stipple::Tone fixed;
  fixed.growWithZoom = false;
  EXPECT_LE(fixed.mark(view, {}, atTheEye, 0).tone,
    fixed.mostTone(view, 0.9f, 0.8f, 16.0f, -1.0f, 8.0f, {}) * 1.00001f);
}

/// The room that an element has is its own projection's where it is nearer than what k_rc is about, whether
/// the enhancement is on or off; and beyond that follows k_rc.
TEST(StippleTone, RoomIsTheElementsOwnCloseUp)
{
  ink::stipple::Tone tone = allOff();
  tone.growWithZoom = false;
  const auto roomAt = [&](float distance)
  {
    auto one = element();
    one.position = { 0.0f, 0.0f, -distance };
    return tone.mark(view, {}, one, 0).tone;
  };
  for (const float krc : { 0.0f, -1.0f, -2.0f, -4.0f })
  {
    tone.resolution.on = krc != 0.0f;
    tone.resolution.exponent = krc;
    tone.resolution.slantExponent = 0.0f;
    EXPECT_FLOAT_EQ(roomAt(4.0f), 8.0f) << krc;
    for (const float nearer : { 3.99f, 2.0f, 0.5f, 0.01f })
    {
      EXPECT_NEAR(roomAt(nearer) * nearer * nearer / (8.0f * 16.0f), 1.0f, 1e-5f) << krc << ' ' << nearer;
    }
    EXPECT_NEAR(roomAt(8.0f) / (8.0f * std::pow(2.0f, krc)), 1.0f, 1e-5f) << krc;
    EXPECT_TRUE(std::isfinite(roomAt(0.0f)) && std::isfinite(roomAt(-3.0f))) << krc;
  }
  // As Table 1 has it from outside; from within it is the object's own size.
  EXPECT_FLOAT_EQ(ink::stipple::Resolution::nearestDistance(6.0f, 2.0f), 4.0f);
  EXPECT_FLOAT_EQ(ink::stipple::Resolution::nearestDistance(2.0f, 2.0f), 2.0f);
  EXPECT_FLOAT_EQ(ink::stipple::Resolution::nearestDistance(-1.0f, 2.0f), 2.0f);
}

/// VTK's equations for lamps, worked out by hand.
TEST(StippleTone, LampsFadeWithDistanceAndTowardsTheRim)
{
  ink::Light lamp{ { 0.0f, 0.0f, 2.0f, 1.0f }, 3.0f };
  EXPECT_FLOAT_EQ(lamp.intensityAt({ 0.0f, 0.0f, -2.0f }), 3.0f);
  lamp.attenuation = { 1.0f, 0.5f, 0.25f };
  EXPECT_FLOAT_EQ(lamp.intensityAt({ 0.0f, 0.0f, -2.0f }), 3.0f / 7.0f);
  lamp.attenuation = { 1.0f, 0.0f, 0.0f };
  lamp.coneCosine = 0.7f;
  lamp.coneExponent = 2.0f;
  EXPECT_FLOAT_EQ(lamp.intensityAt({ 3.0f, 0.0f, -2.0f }), 3.0f * 0.64f);
  EXPECT_EQ(lamp.intensityAt({ 5.0f, 0.0f, -2.0f }), 0.0f);
  EXPECT_EQ(lamp.intensityAt({ 0.0f, 0.0f, 3.0f }), 0.0f);
  lamp.position.w = 0.0f;
  EXPECT_EQ(lamp.intensityAt({ 5.0f, 0.0f, -2.0f }), 3.0f);
  lamp.position.w = 1.0f;
  lamp.attenuation = { 0.0f, 0.0f, 0.0f };
  EXPECT_EQ(lamp.intensityAt({ 0.0f, 0.0f, -2.0f }), 0.0f);
}

/// A sphere of voxels: its ink over its projected area is the same over ten octaves of distance; by random
/// values over four, at which a few hundred stipples are left.
TEST(StippleTone, SameGrayAtAnyDistance)
{
  for (auto way :
    { ink::stipple::SmallElements::Way::intensity, ink::stipple::SmallElements::Way::probability })
  {
    ink::stipple::Tone tone;
    tone.smallElements.way = way;
    tone.distance.on = tone.boundary.on = tone.silhouette.on = tone.interior.on = false;
    double first = 0.0;
    const int octaves = way == ink::stipple::SmallElements::Way::intensity ? 10 : 4;
    for (int octave = 0; octave < octaves; ++octave)
    {
      const float far = 8.0f * std::exp2(float(octave));
      const float pixel = 1.0f / 800.0f; // view units at distance 1
      const float voxel = 0.02f;
      ink::stipple::Tone::View view{};
      view.listed = 32.0f;
      view.nearest = view.closest = far - 1.0f;
      view.middle = far;
      view.halfRange = 1.0f;
      view.maximumStipples =
        ink::stipple::maximumStipples(voxel, pixel * view.nearest, tone.pixelsPerStipple);
      view.smallness =
        tone.smallElements.weight(ink::stipple::maximumStipples(voxel, pixel * far, tone.pixelsPerStipple));
      const ink::Light lampAtEye{ { 0.0f, 0.0f, 0.0f, 1.0f }, 1.0f };
      double ink = 0.0;
      const int count = 20000;
      for (int i = 0; i < count; ++i)
      {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double angle = i * 2.399963;
        const double r = std::sqrt(1.0 - z * z);
        const glm::vec3 normal(r * std::cos(angle), r * std::sin(angle), z);
        const double u = i * 0.618033988749895;
        const ink::stipple::Tone::Element one{ normal - glm::vec3(0.0f, 0.0f, far), normal, 1.0f, 1.0f, 32.0f,
          float(u - std::floor(u)), glm::vec3(0.0f) };
        for (int rank = 0; rank < 32; ++rank)
        {
          const auto mark = tone.mark(view, { &lampAtEye, 1 }, one, rank);
          ink += mark.opacity * mark.diameter * mark.diameter;
          if (mark.opacity == 0.0f)
          {
            break;
          }
        }
      }
      // The visible cap of the unit sphere is a little smaller than half, close by.
      const double pixels = 1.0 / (pixel * pixel) / (far * far - 1.0);
      const double gray = ink / pixels;
      first = octave == 0 ? gray : first;
      EXPECT_NEAR(gray / first, 1.0, 0.05) << "way " << int(way) << ", distance " << far;
    }
  }
}
