// SPDX-License-Identifier: BSD-3-Clause
// Grays of strokes that are not evenly spaced: on a plane and a torus, where strokes end, at borders, for
// each fraction of them, with any number of threads, in hard cases.
#include "MeshesWithCurvature.h"
#include "StreamlineShapes.h"

#include "Tone/Hatching/LocalSpacing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

using namespace ink;
using namespace ink::hatching;

namespace
{

constexpr int bits = 6;
constexpr int count = 1 << bits; // of lines; their mean distance is 1, as is that of a side of the square

float progressivePriority(int line)
{
  int reversed = 0;
  for (int bit = 0; bit < bits; ++bit)
  {
    reversed |= ((line >> bit) & 1) << (bits - 1 - bit);
  }
  return (static_cast<float>(reversed) + 0.5f) / static_cast<float>(count);
}

void addStroke(FamilyStrokes& strokes, float priority, int points,
  const std::function<glm::vec3(double)>& position, const std::function<glm::vec3(double)>& normal)
{
  strokes.begins.resize(std::max<std::size_t>(strokes.begins.size(), 1));
  for (int i = 0; i < points; ++i)
  {
    strokes.points.push_back(position(double(i) / (points - 1)));
    strokes.normals.push_back(normal(double(i) / (points - 1)));
  }
  strokes.begins.push_back(static_cast<std::uint32_t>(strokes.points.size()));
  strokes.priorities.push_back(priority);
}

glm::vec3 up(double)
{
  return { 0.0f, 0.0f, 1.0f };
}

/// Strokes along x over a square of `count` times `count`, at y = count * share((i + 1/2) / count), from x =
/// begin(i) on.
FamilyStrokes squareStrokes(
  const std::function<double(double)>& share,
  const std::function<double(int)>& begin = [](int) { return 0.0; })
{
  FamilyStrokes strokes;
  for (int line = 0; line < count; ++line)
  {
    const double y = count * share((line + 0.5) / count);
    addStroke(
      strokes, progressivePriority(line), 2 * count,
      [&](double u) { return glm::vec3(begin(line) + u * (count - begin(line)), y, 0.0); }, up);
  }
  return strokes;
}

AreaSamples samplesOf(const test::Mesh& mesh)
{
  const std::vector<glm::vec3> normals(mesh.points.size(), up(0.0));
  return areaSamples(mesh.view(), normals, glm::dvec3(0.0), 1.0, 0.9f);
}

AreaSamples squareSamples(int cells)
{
  test::Mesh mesh;
  mesh.addPatch(cells, cells, [](double u, double v) { return glm::dvec3(count * u, count * v, 0.0); });
  return samplesOf(mesh);
}

/// The gray at a position of the square when a fraction of the strokes is drawn to cover all of it, blurred
/// over a radius, but for what lies beyond the square.
double grayAt(const FamilyStrokes& strokes, const std::vector<SpacingRatios>& ratios, float fraction,
  const glm::dvec2& at, double radius)
{
  const StrokeWidth widths{ 1.0f / fraction, 0.0f, 0.0f };
  const auto kernel = [&](const glm::dvec2& p)
  {
    const double share = 1.0 - glm::dot(p - at, p - at) / (radius * radius);
    return share > 0.0 ? share * share : 0.0;
  };
  double ink = 0.0;
  for (std::size_t stroke = 0; stroke < strokes.priorities.size(); ++stroke)
  {
    for (std::size_t i = strokes.begins[stroke]; i + 1 < strokes.begins[stroke + 1]; ++i)
    {
      const glm::dvec2 a(strokes.points[i]);
      const glm::dvec2 b(strokes.points[i + 1]);
      const auto width = [&](std::size_t point)
      { return double(widths.width(1.0f, 1.0f, strokes.priorities[stroke], ratios[point])); };
      ink += kernel(0.5 * (a + b)) * glm::length(b - a) * 0.5 * (width(i) + width(i + 1));
    }
  }
  double whole = 0.0;
  constexpr double step = 0.25;
  for (double y = 0.5 * step; y < count; y += step)
  {
    for (double x = 0.5 * step; x < count; x += step)
    {
      whole += kernel({ x, y }) * step * step;
    }
  }
  return ink / whole;
}

/// Of positions along y at the middle of the square, from a margin on: the largest relative error of the
/// gray.
double worstGray(const FamilyStrokes& strokes, const std::vector<SpacingRatios>& ratios, float fraction,
  double radius, double margin)
{
  double worst = 0.0;
  for (double y = margin; y <= count - margin; y += 1.3)
  {
    const double error = grayAt(strokes, ratios, fraction, { 0.5 * count, y }, radius) - 1.0;
    worst = std::max(worst, std::abs(error));
  }
  return worst;
}

} // namespace

/// From half to three halves of the mean distance, up and down within the square: a blur of five distances of
/// the strokes that are drawn gives the gray that is wanted.
TEST(LocalSpacing, GrayOfUnevenStrokes)
{
  for (const int waves : { 1, 2 })
  {
    const std::vector<float> fractions =
      waves == 1 ? std::vector<float>{ 2.0f, 1.4f, 1.0f, 0.7f, 0.5f } : std::vector<float>{ 2.0f, 1.0f };
    const FamilyStrokes strokes = squareStrokes(
      [=](double t)
      {
        const double phase = 2.0 * std::numbers::pi * waves;
        return t + 0.5 * std::sin(phase * t) / phase;
      });
    const std::vector<SpacingRatios> ratios = localSpacing(strokes, squareSamples(40));
    const std::vector<SpacingRatios> even(ratios.size(), evenSpacing);
    for (const float fraction : fractions)
    {
      const double radius = 5.0 / std::min(fraction, 1.0f);
      const double margin = fraction < 1.0f ? radius : 2.0; // where a border's own strokes may be left out
      const double found = worstGray(strokes, ratios, fraction, radius, margin);
      EXPECT_LT(found, 0.05) << waves << " waves, fraction " << fraction;
      EXPECT_GT(worstGray(strokes, even, fraction, radius, margin), 0.2) << "without, " << fraction;
      RecordProperty(
        "worst" + std::to_string(waves) + "of" + std::to_string(fraction), std::to_string(found));
    }
  }
}

/// Every second stroke begins in the middle: on both sides the gray is that which is wanted, and nearly so
/// between them.
TEST(LocalSpacing, StrokesThatEnd)
{
  const FamilyStrokes strokes =
    squareStrokes([](double t) { return t; }, [](int line) { return line % 2 == 0 ? 0.0 : 0.5 * count; });
  const std::vector<SpacingRatios> ratios = localSpacing(strokes, squareSamples(40));
  const std::vector<SpacingRatios> even(ratios.size(), evenSpacing);
  for (const double x : { 0.2, 0.35, 0.65, 0.8 })
  {
    EXPECT_NEAR(grayAt(strokes, ratios, 2.0f, { x * count, 30.3 }, 4.0), 1.0, 0.05) << "at " << x;
  }
  EXPECT_NEAR(grayAt(strokes, ratios, 2.0f, { 0.5 * count, 30.3 }, 4.0), 1.0, 0.12);
  EXPECT_LT(grayAt(strokes, even, 2.0f, { 0.2 * count, 30.3 }, 4.0), 0.6);
}

/// Lines around the tube of a torus come together inside: their distance there is known.
TEST(LocalSpacing, Torus)
{
  constexpr double radius = 30.0;
  constexpr double tube = 12.0;
  const test::MeshWithCurvature torus = test::closedTorus(radius, tube, 150, 80, 0.3);
  const auto lines = static_cast<int>(2.0 * std::numbers::pi * radius); // so their mean distance is 1
  const double mean = 2.0 * std::numbers::pi * radius / lines;
  std::vector<glm::vec3> normals;
  for (const glm::dvec3& p : torus.mesh.points)
  {
    const glm::dvec3 out = glm::normalize(glm::dvec3(p.x, p.y, 0.0));
    normals.emplace_back(glm::normalize(p - radius * out));
  }
  FamilyStrokes strokes;
  for (int line = 0; line < lines; ++line)
  {
    const double around = 2.0 * std::numbers::pi * line / lines;
    const glm::dvec3 out(std::cos(around), std::sin(around), 0.0);
    const auto normal = [=](double u)
    {
      const double across = 2.0 * std::numbers::pi * u;
      return glm::vec3(std::cos(across) * out + std::sin(across) * glm::dvec3(0.0, 0.0, 1.0));
    };
    addStroke(
      strokes, static_cast<float>(line) / static_cast<float>(lines), 61,
      [=](double u) { return glm::vec3((radius * out + tube * glm::dvec3(normal(u))) / mean); }, normal);
  }
  const std::vector<SpacingRatios> ratios =
    localSpacing(strokes, areaSamples(torus.mesh.view(), normals, glm::dvec3(0.0), mean, 0.9f));
  double squares = 0.0;
  for (std::size_t i = 0; i < ratios.size(); ++i)
  {
    const double away = mean * glm::length(glm::dvec2(strokes.points[i]));
    const double error = double(ratios[i][0]) * radius / away - 1.0;
    squares += error * error / static_cast<double>(ratios.size());
    ASSERT_NEAR(error, 0.0, 0.15) << "point " << i << ", " << away << " from the axis";
  }
  EXPECT_LT(std::sqrt(squares), 0.015);
  RecordProperty("rms", std::to_string(std::sqrt(squares)));
}

/// Even strokes stay as they are, at the borders, too, whatever the triangles are like.
TEST(LocalSpacing, EvenStrokes)
{
  const FamilyStrokes strokes = squareStrokes([](double t) { return t; });
  test::Mesh slivers;
  slivers.addPatch(1, 3000, [](double u, double v) { return glm::dvec3(count * u, count * v, 0.0); });
  for (const AreaSamples& surface :
    { squareSamples(1), squareSamples(7), squareSamples(300), samplesOf(slivers) })
  {
    const std::vector<SpacingRatios> ratios = localSpacing(strokes, surface);
    double squares = 0.0;
    for (std::size_t i = 0; i < ratios.size(); ++i)
    {
      const double error = double(ratios[i][0]) - 1.0;
      squares += error * error / static_cast<double>(ratios.size());
      ASSERT_NEAR(error, 0.0, 0.2) << strokes.points[i].x << ", " << strokes.points[i].y;
    }
    // Parts of thousands of slivers side by side have their centers by chance, and are few enough (.020 of
    // 384,000).
    EXPECT_LT(std::sqrt(squares), surface.size() > 300000 ? 0.03 : 0.01) << surface.size() << " parts";
    EXPECT_LT(surface.size(), 500000u);
  }
}

/// Strokes on one side of a wall do not count for those on the other one.
TEST(LocalSpacing, BothSidesOfAWall)
{
  FamilyStrokes strokes = squareStrokes([](double t) { return t; });
  const std::vector<SpacingRatios> alone = localSpacing(strokes, squareSamples(40));
  AreaSamples both = squareSamples(40);
  const std::size_t front = both.size();
  const AreaSamples back = squareSamples(40);
  for (std::size_t i = 0; i < back.size(); ++i)
  {
    both.positions.push_back(back.positions[i] - glm::vec3(0.0f, 0.0f, 0.3f));
    both.normals.push_back(-back.normals[i]);
    both.areas.push_back(back.areas[i]);
  }
  ASSERT_EQ(both.size(), 2 * front);
  const std::vector<SpacingRatios> ratios = localSpacing(strokes, both);
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    ASSERT_NEAR(ratios[i][0], alone[i][0], 1e-4f);
  }
}

TEST(LocalSpacing, TheSameForAnyNumberOfThreads)
{
  const FamilyStrokes strokes = squareStrokes([](double t) { return t * t; });
  const auto run = [&] { return localSpacing(strokes, squareSamples(150)); };
  EXPECT_EQ(test::onThreads(1, run), test::onThreads(2, run));
}

TEST(LocalSpacing, Stopped)
{
  const FamilyStrokes strokes = squareStrokes([](double t) { return t * t; });
  int calls = 0;
  const std::vector<SpacingRatios> ratios =
    localSpacing(strokes, squareSamples(20), [&](double) { return ++calls < 2; });
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(ratios, std::vector<SpacingRatios>(strokes.points.size(), evenSpacing));
}

/// Nothing, points that are not finite or repeat, strokes without a surface, a surface without most strokes:
/// ratios are within their bounds.
TEST(LocalSpacing, HardCases)
{
  EXPECT_TRUE(localSpacing({ {}, {}, { 0 }, {} }, {}).empty());
  EXPECT_TRUE(localSpacing({ {}, {}, { 0 }, {} }, squareSamples(3)).empty());
  FamilyStrokes strokes = squareStrokes([](double t) { return 0.1 * t; });
  for (const SpacingRatios& ratio : localSpacing(strokes, {}))
  {
    ASSERT_EQ(ratio, evenSpacing) << "no surface";
  }
  strokes.points[5].y = std::numeric_limits<float>::quiet_NaN();
  strokes.points[17] = glm::vec3(std::numeric_limits<float>::infinity());
  strokes.normals[40].x = std::numeric_limits<float>::quiet_NaN();
  strokes.points[60] = strokes.points[61];
  strokes.points[200] = glm::vec3(3e30f, 0.0f, 0.0f);
  strokes.normals[300] = glm::vec3(0.0f);
  addStroke(
    strokes, 0.5f, 2, [](double) { return glm::vec3(1.0f); }, up);
  for (const SpacingRatios& ratio : localSpacing(strokes, squareSamples(20)))
  {
    for (const float value : ratio)
    {
      ASSERT_TRUE(value >= 0.5f && value <= 2.0f) << value;
    }
  }
}

/// In parts the surface is as large as before; they are as small as is asked for, and never so many that
/// slivers take for ever.
TEST(AreaSamples, Areas)
{
  test::Mesh mesh = test::square(3);
  mesh.points.push_back({ 1e6, 0.0, 0.0 });
  mesh.points.push_back({ 1e6, 1e-9, 0.0 });
  mesh.triangles.push_back({ 0, 16, 17 }); // a sliver of half a thousandth
  mesh.triangles.push_back({ 0, 0, 1 });
  mesh.points.push_back(glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
  mesh.triangles.push_back({ 0, 1, 18 });
  // Far from all others one of less area than floats can say.
  mesh.points.insert(mesh.points.end(), { { -50.0, 0.0, 0.0 }, { -49.0, 0.0, 0.0 }, { -49.5, 1e-60, 0.0 } });
  mesh.triangles.push_back({ 19, 20, 21 });
  const std::vector<glm::vec3> normals(mesh.points.size(), up(0.0));
  const AreaSamples samples = areaSamples(mesh.view(), normals, { 0.5, 0.5, 0.0 }, 0.1, 0.7f);
  const auto sum = [](const AreaSamples& of)
  {
    double area = 0.0;
    for (const float part : of.areas)
    {
      area += double(part);
    }
    return area;
  };
  EXPECT_NEAR(sum(samples), 100.05, 1e-3);
  EXPECT_GT(samples.size(), 400u);
  EXPECT_LT(samples.size(), 2000u);
  EXPECT_LE(*std::max_element(samples.areas.begin(), samples.areas.end()), 0.5f * 0.7f * 0.7f);
  const AreaSamples fewer = joinSamples(samples, 2.0f);
  EXPECT_NEAR(sum(fewer), 100.05, 1e-3);
  EXPECT_LT(fewer.size(), 150u);
  for (std::size_t i = 0; i < fewer.size(); ++i)
  {
    EXPECT_EQ(fewer.normals[i], up(0.0));
    EXPECT_TRUE(std::isfinite(fewer.positions[i].x));
  }
}
