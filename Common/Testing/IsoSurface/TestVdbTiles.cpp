// SPDX-License-Identifier: BSD-3-Clause
// Smoothed, divided, cut surfaces and their parts in a sparse grid against those of the same grid made dense:
// the same samples, to the bit.
#include "IsoSurface/Vdb/VdbTiles.h"

#include "VdbVolumes.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{

using namespace ink::testing;
using ink::CutSurface;
using ink::SmoothingTarget;
using ink::VdbGrid;
using ink::VdbTileOptions;
using ink::VoxelBox;

template <class Real = double>
Samples<Real> sampleTiles(
  const VdbGrid& grid, std::span<const double> isoValues, const VdbTileOptions& options)
{
  ink::VdbTileSamples<Real> found;
  EXPECT_TRUE(sampleVdbTiles(grid, isoValues, options, found));
  std::size_t count = 0;
  for (const std::size_t n : found.counts)
  {
    count += n;
  }
  EXPECT_EQ(found.counts.size(), isoValues.size());
  EXPECT_EQ(found.points.size(), 3 * count);
  EXPECT_EQ(found.normals.size(), 3 * count);
  return { found.points, found.normals };
}

/// What the dense grid gives: its cells, and the samples of its sides.
template <class T, class Real = double>
Samples<Real> sampleDense(
  const Volume<T>& volume, std::span<const double> isoValues, const VdbTileOptions& options)
{
  const auto field = volume.field();
  ink::IsoSurfaceResampling resampling = ink::makeIsoSurfaceResampling(volume.geometry, options.smoothing,
    options.subdivision, options.target, options.ofMask, options.shapeBased);
  resampling.borders = options.borders;
  Samples<Real> samples;
  const auto grow = [&](std::size_t count) { return samples.grow(count); };
  std::vector<std::size_t> counts;
  EXPECT_TRUE(ink::sampleResampledIsoSurfaces(
    field, isoValues, options.samples, {}, resampling, options.projectionSteps, nullptr, grow, counts));
  for (const double isoValue : isoValues)
  {
    const glm::ivec3 first = volume.geometry.first();
    const ink::CutSamples cut = ink::sampleCut(
      field, isoValue, options.cut, first, first + volume.geometry.dimensions() - 1, {}, resampling);
    for (std::size_t n = 0; n < cut.points.size(); ++n)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        samples.coordinates.push_back(static_cast<Real>(cut.points[n][axis]));
        samples.components.push_back(static_cast<float>(cut.normals[n][axis]));
      }
    }
  }
  return samples;
}

/// A wavy, noisy body that goes on beyond the volume, and floaters.
template <class T>
Volume<T> makeBody()
{
  return Volume<T>::from(ink::GridGeometry({ 70, 45, 38 }, { 10.0, -5.0, 3.0 }, { 0.5, 0.5, 1.0 },
                           glm::dmat3(1.0), { -7, 3, -20 }),
    [](const glm::dvec3& p)
    {
      const double wave = 20.0 * std::sin(0.7 * p.x) * std::cos(0.5 * p.y);
      const double floater = 120.0 * (glm::length(p - glm::dvec3(30.0, 5.0, -12.0)) < 1.6);
      return 100.0 - 3.0 * glm::length(p - glm::dvec3(14.0, 8.0, 0.0)) * 2.0 + wave + floater;
    });
}

VdbTileOptions optionsOf(double smoothing, int subdivision, SmoothingTarget target)
{
  VdbTileOptions options;
  options.samples.arithmetic = ink::Arithmetic::Double;
  options.smoothing = smoothing;
  options.subdivision = subdivision;
  options.target = target;
  return options;
}

} // namespace

TEST(VdbTiles, MasksOfLabelsAgreeWithDense)
{
  const auto volume = makeBody<float>();
  const VdbGrid grid = makeVdbGrid(volume.field(), {});
  const double isoValues[] = { 50.0, 20.0 };
  for (const double smoothing : { 0.0, 2.0 })
  {
    VdbTileOptions options = optionsOf(smoothing, 1, SmoothingTarget::Normals);
    const auto ofValues = sorted(sampleTiles(grid, isoValues, options));
    options.ofMask = true;
    options.cut = CutSurface::Cap;
    const auto expected = sorted(sampleDense(volume, isoValues, options));
    EXPECT_GT(expected.size(), 1000u);
    EXPECT_TRUE(sorted(sampleTiles(grid, isoValues, options)) == expected) << "smoothing " << smoothing;
    EXPECT_FALSE(ofValues == expected);
  }
}

TEST(VdbTiles, ContoursOfSlicesAgreeWithDense)
{
  const auto volume = makeBody<float>();
  ASSERT_TRUE(ink::thickSlices(volume.geometry.spacing()));
  const VdbGrid grid = makeVdbGrid(volume.field(), {});
  const double isoValues[] = { 50.0, 20.0 };
  for (const bool ofMask : { false, true })
  {
    VdbTileOptions options = optionsOf(0.7, 1, SmoothingTarget::Normals);
    options.ofMask = ofMask;
    options.cut = CutSurface::Rim;
    const auto ofValues = sorted(sampleTiles(grid, isoValues, options));
    options.shapeBased = true;
    const auto expected = sorted(sampleDense(volume, isoValues, options));
    EXPECT_GT(expected.size(), 1000u);
    EXPECT_TRUE(sorted(sampleTiles(grid, isoValues, options)) == expected) << (ofMask ? "mask" : "values");
    EXPECT_FALSE(ofValues == expected);
  }
}

TEST(VdbTiles, BordersOfLabelsAgreeWithDense)
{
  auto volume = makeBody<float>();
  for (float& value : volume.values)
  {
    value = std::max(std::round(value / 30.0f), 0.0f);
  }
  const VdbGrid grid = makeVdbGrid(volume.field(), {});
  const double isoValues[] = { 0.5 };
  VdbTileOptions options = optionsOf(2.0, 1, SmoothingTarget::Normals);
  options.ofMask = true;
  const auto smooth = sorted(sampleTiles(grid, isoValues, options));
  options.borders = true;
  const auto expected = sorted(sampleDense(volume, isoValues, options));
  EXPECT_GT(expected.size(), 1000u);
  EXPECT_TRUE(sorted(sampleTiles(grid, isoValues, options)) == expected);
  EXPECT_FALSE(smooth == expected);
}

TEST(VdbTiles, OfAWholeVolumeAgreeWithDense)
{
  const auto volume = makeBody<float>();
  const VdbGrid grid = makeVdbGrid(volume.field(), {});
  const double isoValues[] = { 50.0, 20.0 };
  for (const auto& [smoothing, subdivision, target] : { std::tuple(0.0, 1, SmoothingTarget::Surface),
         std::tuple(1.2, 1, SmoothingTarget::Surface), std::tuple(0.8, 2, SmoothingTarget::Normals) })
  {
    VdbTileOptions options = optionsOf(smoothing, subdivision, target);
    for (const CutSurface cut : { CutSurface::Open, CutSurface::Rim, CutSurface::Cap })
    {
      options.cut = cut;
      const auto expected = sorted(sampleDense(volume, isoValues, options));
      EXPECT_GT(expected.size(), 1000u);
      for (const char* threads : { "1", "2" })
      {
        setenv("VTK_SMP_MAX_THREADS", threads, 1);
        EXPECT_TRUE(sorted(sampleTiles(grid, isoValues, options)) == expected)
          << "smoothing " << smoothing << ", cut " << static_cast<int>(cut);
      }
      unsetenv("VTK_SMP_MAX_THREADS");
    }
  }
}

TEST(VdbTiles, MovedToTheSurfaceInSinglePrecisionAgreeWithDense)
{
  const auto volume = makeBody<float>();
  const VdbGrid grid = makeVdbGrid(volume.field(), {});
  VdbTileOptions options = optionsOf(1.0, 2, SmoothingTarget::Surface);
  options.samples.arithmetic = ink::Arithmetic::Single;
  options.projectionSteps = 2;
  const double isoValue[] = { 50.0 };
  EXPECT_TRUE(sorted(sampleTiles<float>(grid, isoValue, options)) ==
    sorted(sampleDense<float, float>(volume, isoValue, options)));
}

TEST(VdbTiles, OfADoubleGridWithoutADomainAgreeWithDense)
{
  openvdb::initialize();
  auto ball = openvdb::DoubleGrid::create(0.0);
  ball->setName("density");
  for (int k = -25; k <= 25; ++k)
  {
    for (int j = -25; j <= 25; ++j)
    {
      for (int i = -25; i <= 25; ++i)
      {
        const double inside = 12.0 - std::sqrt(1.0 * i * i + j * j + k * k);
        if (inside > 0.0)
        {
          ball->tree().setValue({ i, j, k }, std::min(inside, 2.0));
        }
      }
    }
  }
  const VdbGrid grid = readBack<openvdb::DoubleGrid>(ball);
  VdbTileOptions options = optionsOf(1.5, 1, SmoothingTarget::Surface);
  options.cut = CutSurface::Rim;
  const double isoValue[] = { 1.0 };
  const auto dense = denseOf<double>(grid, padded(grid.activeBox(), 12));
  const auto samples = sampleTiles(grid, isoValue, options);
  EXPECT_TRUE(sorted(samples) == sorted(sampleDense(dense, isoValue, options)));
  ASSERT_GT(samples.size(), 1000u);
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    EXPECT_NEAR(glm::length(samples.point(n)), 11.0, 0.5);
    EXPECT_GT(glm::dot(samples.normal(n), glm::normalize(samples.point(n))), 0.99);
  }
}

TEST(VdbTiles, PartsAreThoseOfTheWholeSurface)
{
  const auto volume = makeBody<float>();
  const VdbGrid grid = makeVdbGrid(volume.field(), {});
  VdbTileOptions options = optionsOf(0.5, 1, SmoothingTarget::Surface);
  options.cut = CutSurface::Rim;
  const double isoValue[] = { 50.0 };
  const auto all = sampleTiles(grid, isoValue, options);
  const auto isFloaters = [](const glm::dvec3& p)
  { return glm::length(p - glm::dvec3(30.0, 5.0, -12.0)) < 3.0; };
  std::size_t floaters = 0;
  for (std::size_t n = 0; n < all.size(); ++n)
  {
    floaters += isFloaters(all.point(n));
  }
  ASSERT_GT(floaters, 20u);
  for (const ink::ComponentSelection& parts :
    { ink::ComponentSelection{ 0.5, 0 }, ink::ComponentSelection{ 0.0, 1 } })
  {
    options.parts = parts;
    const auto kept = sampleTiles(grid, isoValue, options);
    // The waves cut off a little of the body, too.
    EXPECT_LE(kept.size(), all.size() - floaters);
    EXPECT_GT(static_cast<double>(kept.size()), 0.9 * static_cast<double>(all.size() - floaters));
    for (std::size_t n = 0; n < kept.size(); ++n)
    {
      EXPECT_FALSE(isFloaters(kept.point(n)));
    }
  }
}

TEST(VdbTiles, PiecesAreTheWhole)
{
  const auto volume = makeBody<float>();
  const VdbGrid grid = makeVdbGrid(volume.field(), {});
  const double isoValues[] = { 50.0, 20.0 };
  VdbTileOptions options = optionsOf(1.0, 1, SmoothingTarget::Normals);
  options.cut = CutSurface::Rim;
  for (const std::size_t largest : { 0, 1 })
  {
    options.parts.largest = largest;
    options.piece = 0;
    options.pieces = 1;
    const auto whole = sorted(sampleTiles(grid, isoValues, options));
    Samples<double> together;
    options.pieces = 3;
    for (options.piece = 0; options.piece < 3; ++options.piece)
    {
      const auto piece = sampleTiles(grid, isoValues, options);
      together.coordinates.insert(
        together.coordinates.end(), piece.coordinates.begin(), piece.coordinates.end());
      together.components.insert(together.components.end(), piece.components.begin(), piece.components.end());
    }
    EXPECT_TRUE(sorted(together) == whole);
  }
}

/// A piece takes the memory of its share, where it need not look at the whole.
TEST(VdbTiles, PiecesFitWhereTheWholeDoesNot)
{
  const auto volume = makeBody<float>();
  const VdbGrid grid = makeVdbGrid(volume.field(), {});
  const double isoValue[] = { 50.0 };
  VdbTileOptions options = optionsOf(0.0, 4, SmoothingTarget::Surface);
  ink::VdbTileSamples<double> samples;
  ASSERT_TRUE(sampleVdbTiles(grid, isoValue, options, samples));
  options.memory = 30 * samples.counts.front();
  EXPECT_THROW(sampleVdbTiles(grid, isoValue, options, samples), ink::VdbTooLarge);
  options.pieces = 8;
  EXPECT_TRUE(sampleVdbTiles(grid, isoValue, options, samples));
  options.parts.largest = 1;
  EXPECT_THROW(sampleVdbTiles(grid, isoValue, options, samples), ink::VdbTooLarge);
}

TEST(VdbTiles, RefuseWhatDoesNotFit)
{
  const auto volume = makeBody<float>();
  const VdbGrid grid = makeVdbGrid(volume.field(), {});
  const double isoValue[] = { 50.0 };
  VdbTileOptions options = optionsOf(0.0, 8, SmoothingTarget::Surface);
  ink::VdbTileSamples<double> samples;
  options.memory = 1'000'000;
  EXPECT_THROW(sampleVdbTiles(grid, isoValue, options, samples), ink::VdbTooLarge);
  options.memory = VdbGrid::noLimit;
  EXPECT_FALSE(sampleVdbTiles(grid, isoValue, options, samples, [](double) { return false; }));
  auto far = openvdb::FloatGrid::create(0.0f);
  far->tree().setValue({ 3'000'000, 0, 0 }, 1.0f);
  options.parts.largest = 1;
  options.subdivision = 1;
  options.smoothing = 1.0;
  const double middle[] = { 0.5 };
  EXPECT_THROW(
    sampleVdbTiles(readBack<openvdb::FloatGrid>(far), middle, options, samples), std::invalid_argument);
  // What nobody asked for is left.
  options.parts = { ink::ComponentSelection::automatic, 0 };
  options.smoothing = 0.3;
  EXPECT_TRUE(sampleVdbTiles(readBack<openvdb::FloatGrid>(far), middle, options, samples));
  EXPECT_GT(samples.counts.front(), 0u);
}
