// SPDX-License-Identifier: BSD-3-Clause
// Random sparse trees: vtkInkVDBIsoSurfaceSampler makes the points that vtkInkIsoSurfaceSampler makes of
// vtkInkVDBReader's image, to the bit, and that image has the tree's values. Ten trees are a test, named by
// the first one's seed.

#include "InkTestMessages.h"
#include "InkTestRandom.h"
#include "VDBTestFiles.h"

#include "vtkImageData.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkVDBIsoSurfaceSampler.h"
#include "vtkInkVDBReader.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{

using openvdb::Coord;
using openvdb::CoordBBox;

constexpr unsigned Trees = 120;
constexpr unsigned TreesOfTest = 10;

Coord RandomCoord(InkTestRandom& random, int size)
{
  return Coord(random.UpTo(size), random.UpTo(size), random.UpTo(size));
}

/// Values of few levels, so that neighbors are often equal, and what a half float holds exactly.
double RandomValue(InkTestRandom& random)
{
  return random.UpTo(9) / 4.0 - 1.0;
}

template <class Grid>
typename Grid::Ptr MakeGrid(InkTestRandom& random)
{
  const auto grid = Grid::create(static_cast<typename Grid::ValueType>(RandomValue(random)));
  grid->setName("random");
  grid->setSaveFloatAsHalf(random.Once(3));
  const openvdb::GridClass classes[] = { openvdb::GRID_UNKNOWN, openvdb::GRID_LEVEL_SET,
    openvdb::GRID_FOG_VOLUME };
  grid->setGridClass(classes[random.UpTo(3)]);
  const Coord first(random.UpTo(60) - 30, random.UpTo(60) - 30, random.UpTo(60) - 30);
  auto& tree = grid->tree();
  const auto value = [&] { return static_cast<typename Grid::ValueType>(RandomValue(random)); };
  // Boxes that become leaves and, where they fill blocks, tiles; noise; single voxels that are not active.
  for (int n = random.UpTo(4); n > 0; --n)
  {
    const Coord low = first + RandomCoord(random, 24);
    tree.sparseFill(CoordBBox(low, low + RandomCoord(random, 20)), value(), !random.Once(4));
  }
  for (int n = random.UpTo(3); n > 0; --n)
  {
    const Coord low = first + RandomCoord(random, 30);
    for (auto at = CoordBBox(low, low + RandomCoord(random, 9)).begin(); at; ++at)
    {
      tree.setValue(*at, value());
    }
  }
  for (int n = random.UpTo(8); n > 0; --n)
  {
    tree.setValueOff(first + RandomCoord(random, 36), value());
  }
  if (random.Once(3))
  {
    tree.setValue(
      first + RandomCoord(random, 30), std::numeric_limits<typename Grid::ValueType>::quiet_NaN());
  }
  if (random.Once(80))
  {
    // A tile of 128^3 voxels.
    tree.addTile(2, Coord(0, 0, -128), value(), true);
  }
  if (random.Once(2))
  {
    tree.prune();
  }
  // An image is the box of the active voxels: one around all, as the sparse sampler sees what lies beyond,
  // too.
  tree.setValue(first, value());
  tree.setValue(first + Coord(46, 46, 46), value());

  if (random.Once(2))
  {
    grid->transform().preScale(openvdb::Vec3d(0.5 + random.Share(), 0.5, 2.0));
    grid->transform().postRotate(random.Share(), openvdb::math::Y_AXIS);
  }
  grid->transform().postTranslate(openvdb::Vec3d(random.Share(), 10.0 * random.Share(), -3.0));
  return grid;
}

/// How many voxels of the image differ from the tree's.
template <class Grid>
vtkIdType CountWrong(const Grid& grid, vtkImageData* image, bool negate)
{
  const auto lookup = grid.getConstAccessor();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  int extent[6];
  image->GetExtent(extent);
  vtkIdType n = 0;
  vtkIdType wrong = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const double expected = (negate ? -1.0 : 1.0) * static_cast<double>(lookup.getValue(Coord(i, j, k)));
        const double found = scalars->GetComponent(n++, 0);
        wrong += found != expected && !(std::isnan(found) && std::isnan(expected));
      }
    }
  }
  return wrong;
}

template <class Sampler>
void SetUp(Sampler* sampler, unsigned seed)
{
  InkTestRandom random(seed);
  // Between the levels, where STRICT sees no flat pieces, or on one.
  const bool strict = random.Once(3);
  sampler->SetCrossingRule(strict ? Sampler::STRICT : Sampler::HALF_OPEN);
  for (int n = random.UpTo(2); n >= 0; --n)
  {
    sampler->SetValue(n, RandomValue(random) + (strict || random.Once(2) ? 0.11 : 0.0));
  }
  sampler->SetNormalMethod(random.UpTo(4));
  sampler->SetArithmeticPrecision(random.UpTo(2));
  sampler->SetOutputPointsPrecision(random.UpTo(2));
}

template <class Grid>
void CheckTree(unsigned seed)
{
  InkTestRandom random(seed);
  const auto grid = MakeGrid<Grid>(random);
  const std::string name = "seed " + std::to_string(seed);
  const std::string file = WriteVDB(".vdb", { grid });
  const bool levelSet = grid->getGridClass() == openvdb::GRID_LEVEL_SET;

  vtkNew<InkTestMessages> messages;
  vtkNew<vtkInkVDBReader> reader;
  messages->Observe(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  const vtkIdType wrong = CountWrong(*grid, reader->GetOutput(), levelSet);
  EXPECT_EQ(wrong, 0) << name << ": the tree's values, but for " << wrong << " of "
                      << reader->GetOutput()->GetNumberOfPoints();

  vtkNew<vtkInkIsoSurfaceSampler> dense;
  messages->Observe(dense);
  dense->SetInputConnection(reader->GetOutputPort());
  SetUp(dense.Get(), seed);
  dense->Update();
  const std::vector<VDBSample> expected = SamplesOf(dense->GetOutput());

  vtkNew<vtkInkVDBIsoSurfaceSampler> sparse;
  messages->Observe(sparse);
  sparse->SetFileName(file.c_str());
  SetUp(sparse.Get(), seed);
  sparse->Update();
  const std::vector<VDBSample> found = SamplesOf(sparse->GetOutput());
  EXPECT_EQ(found, expected) << name << ": the image's " << expected.size() << " samples, found "
                             << found.size() << " or others";

  std::vector<VDBSample> all;
  const int pieces = 2 + random.UpTo(4);
  for (int piece = 0; piece < pieces; ++piece)
  {
    sparse->UpdatePiece(piece, pieces, 0);
    const std::vector<VDBSample> part = SamplesOf(sparse->GetOutput());
    all.insert(all.end(), part.begin(), part.end());
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, found) << name << ": the same in " << pieces << " pieces";
  EXPECT_TRUE(messages->Messages.empty() || found.empty())
    << name << ": no message, found " << (messages->Messages.empty() ? "" : messages->Messages[0]);
}

class VDBRandom : public testing::TestWithParam<unsigned>
{
};

} // namespace

TEST_P(VDBRandom, SparseSamplesAreTheImages)
{
  for (unsigned seed = GetParam(); seed < GetParam() + TreesOfTest; ++seed)
  {
    if (seed % 3 == 0)
    {
      CheckTree<openvdb::DoubleGrid>(seed);
    }
    else
    {
      CheckTree<openvdb::FloatGrid>(seed);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Trees, VDBRandom, testing::Range(0u, Trees, TreesOfTest), testing::PrintToStringParamName());
