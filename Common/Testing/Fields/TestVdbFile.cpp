// SPDX-License-Identifier: BSD-3-Clause
// Files as OpenVDB writes them, whole, cut short and changed.

#include "VdbVolumes.h"

#include <openvdb/math/Maps.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>
#include <string>

namespace
{

using namespace ink::testing;
using ink::VdbClass;
using ink::VdbError;
using ink::VdbFile;
using ink::VdbGrid;
using openvdb::Coord;
using openvdb::FloatGrid;

VdbFile listOf(const std::string& file)
{
  std::istringstream in(file, std::ios::binary);
  return VdbFile::list(in);
}

/// As openvdb::io::File writes it, with the positions of its grids.
std::string seekableFileOf(const openvdb::GridPtrVec& grids)
{
  struct Archive : openvdb::io::Archive
  {
    using openvdb::io::Archive::write;
  };
  openvdb::initialize();
  std::ostringstream out(std::ios::binary);
  Archive().write(out, openvdb::GridCPtrVec(grids.begin(), grids.end()), true);
  return out.str();
}

template <class Grid>
typename Grid::Ptr named(const std::string& name, typename Grid::Ptr grid = Grid::create())
{
  grid->setName(name);
  return grid;
}

FloatGrid::Ptr sphere()
{
  return named<FloatGrid>(
    "sphere", openvdb::tools::createLevelSetSphere<FloatGrid>(4.0f, { 1.0f, 2.0f, 3.0f }, 0.5f, 3.0f));
}

std::string errorOf(const std::function<void()>& body)
{
  try
  {
    body();
  }
  catch (const VdbError& error)
  {
    return error.what();
  }
  return "no error";
}

void expectError(const std::string& words, const std::function<void()>& body)
{
  const std::string error = errorOf(body);
  EXPECT_NE(error.find(words), std::string::npos) << "expected: " << words << "\nfound: " << error;
}

TEST(VdbFile, ListsGridsWithoutTheirVoxels)
{
  const auto half = sphere();
  half->setName("half");
  half->setSaveFloatAsHalf(true);
  const std::string file = seekableFileOf({ sphere(), half, named<openvdb::DoubleGrid>("density"),
    emptyGrid<openvdb::BoolGrid>("mask"), emptyGrid<openvdb::Vec3SGrid>("velocity"), sphere() });
  const VdbFile list = listOf(file);
  ASSERT_EQ(list.grids.size(), 6u);
  const std::string names[] = { "sphere[0]", "half", "density", "mask", "velocity", "sphere[1]" };
  const std::string types[] = { "float", "half", "double", "bool", "vec3s", "float" };
  for (std::size_t n = 0; n < list.grids.size(); ++n)
  {
    EXPECT_EQ(list.grids[n].name, names[n]);
    EXPECT_EQ(list.grids[n].type, types[n]);
    EXPECT_EQ(list.grids[n].problem.empty(), n != 3 && n != 4);
  }
  EXPECT_EQ(list.grids[0].gridClass, VdbClass::LevelSet);
  EXPECT_EQ(list.grids[2].gridClass, VdbClass::Unknown);
  EXPECT_EQ(list.grids[0].spacing, glm::dvec3(0.5));
  ASSERT_TRUE(list.grids[0].activeBox.has_value());
  EXPECT_EQ(*list.grids[0].activeBox, readGrid(file, "sphere[0]").activeBox());
  EXPECT_EQ(list.grids[0].activeCount, static_cast<std::int64_t>(sphere()->activeVoxelCount()));
  EXPECT_EQ(list.find("").name, "sphere[0]");
}

TEST(VdbFile, ReadsWhatOpenVdbWrites)
{
  const auto original = sphere();
  for (const bool half : { false, true })
  {
    for (const std::uint32_t compression : { 0u, 1u, 2u, 3u, 4u, 6u })
    {
      SCOPED_TRACE("compression " + std::to_string(compression) + (half ? ", half" : ""));
      original->setSaveFloatAsHalf(half);
      std::ostringstream out(std::ios::binary);
      openvdb::initialize();
      openvdb::io::Stream stream(out);
      stream.setCompression(compression);
      stream.write(openvdb::GridPtrVec{ original });
      const VdbGrid grid = readGrid(out.str());
      const auto box = padded(grid.activeBox(), 3);
      const auto dense = denseOf<float>(grid, box);
      std::size_t n = 0;
      for (int k = box.first.z; k <= box.last.z; ++k)
      {
        for (int j = box.first.y; j <= box.last.y; ++j)
        {
          for (int i = box.first.x; i <= box.last.x; ++i, ++n)
          {
            EXPECT_NEAR(dense.values[n], original->tree().getValue(Coord(i, j, k)), half ? 1e-3 : 0.0);
          }
        }
      }
    }
  }
}

TEST(VdbFile, ReadsEveryLinearTransform)
{
  const auto placed = [](const openvdb::math::Transform::Ptr& transform)
  {
    auto grid = named<FloatGrid>("density");
    grid->setTransform(transform);
    grid->tree().setValue(Coord(2, 3, 5), 1.0f);
    const VdbGrid read = readBack<FloatGrid>(grid);
    const auto p = transform->indexToWorld(Coord(2, 3, 5));
    const auto found = read.geometry(read.activeBox()).toWorld(glm::dvec3(0.0));
    EXPECT_LT(glm::distance(found, glm::dvec3(p.x(), p.y(), p.z())), 1e-12 * (1.0 + p.length()));
  };
  using openvdb::math::Transform;
  placed(Transform::createLinearTransform(1.0));
  placed(Transform::createLinearTransform(0.1));
  auto transform = Transform::createLinearTransform(0.3);
  transform->postTranslate({ 1e6, -3.0, 4.0 });
  placed(transform);
  transform->postRotate(0.4, openvdb::math::Y_AXIS);
  placed(transform);
  transform->postScale({ 1.0, -2.0, 3.0 });
  placed(transform);
  transform->preShear(0.3, openvdb::math::X_AXIS, openvdb::math::Y_AXIS);
  placed(transform);
  placed(Transform::Ptr(
    new Transform(openvdb::math::MapBase::Ptr(new openvdb::math::TranslationMap({ 1, 2, 3 })))));
  placed(
    Transform::Ptr(new Transform(openvdb::math::MapBase::Ptr(new openvdb::math::ScaleMap({ 1, 2, 3 })))));
  placed(Transform::Ptr(
    new Transform(openvdb::math::MapBase::Ptr(new openvdb::math::UnitaryMap({ 0, 0, 1 }, 0.5)))));
}

TEST(VdbFile, SharedTreesAreReadWithEachGrid)
{
  const auto first = sphere();
  const auto second = named<FloatGrid>("shared", FloatGrid::create(*first));
  second->setTree(first->treePtr());
  second->setTransform(openvdb::math::Transform::createLinearTransform(2.0));
  for (const std::string& file : { fileOf({ first, second }), seekableFileOf({ first, second }) })
  {
    EXPECT_EQ(readGrid(file, "shared").activeBox(), readGrid(file, "sphere").activeBox());
    EXPECT_EQ(readGrid(file, "shared").info().spacing, glm::dvec3(2.0));
  }
}

TEST(VdbFile, WhatCannotBeReadIsNamed)
{
  expectError("not an OpenVDB file", [] { listOf(""); });
  expectError("not an OpenVDB file", [] { listOf("these are no voxels at all"); });
  const std::string other =
    seekableFileOf({ emptyGrid<openvdb::Int32Grid>("count"), emptyGrid<openvdb::Vec3SGrid>("v") });
  expectError("'count' (int32), 'v' (vec3s)", [&] { readGrid(other); });
  expectError("'int32'; expected float, double or half", [&] { readGrid(other, "count"); });
  expectError("no grid 'density'", [&] { readGrid(fileOf({ sphere() }), "density"); });

  auto frustum = named<FloatGrid>("frustum");
  frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
    openvdb::BBoxd({ 0, 0, 0 }, { 10, 10, 10 }), 0.5, 10.0, 1.0));
  frustum->tree().setValue(Coord(1, 2, 3), 1.0f);
  expectError("NonlinearFrustumMap", [&] { readGrid(seekableFileOf({ frustum }), "frustum"); });

  std::string old = fileOf({ sphere() });
  old[8] = static_cast<char>(200);
  expectError("version 200; expected 222 to 224", [&] { listOf(old); });
}

TEST(VdbFile, TooLargeIsSaidBeforeItIsRead)
{
  const std::string file = fileOf({ sphere() });
  EXPECT_THROW(readGrid(file, "", 1000), ink::VdbTooLarge);
  expectError("MiB of memory; allowed are 1 MiB", [&] { readGrid(file, "", 1000); });
  const std::uint64_t memory = readGrid(file).memory();
  EXPECT_NO_THROW(readGrid(file, "", 2 * memory));
}

TEST(VdbFile, EveryTruncationIsAnError)
{
  auto grid = named<FloatGrid>("density");
  grid->tree().setValue(Coord(1, 2, 3), 1.0f);
  grid->tree().setValue(Coord(-300, 2, 3), 2.0f);
  for (const std::string& file : { fileOf({ grid }), seekableFileOf({ grid }) })
  {
    EXPECT_NO_THROW(readGrid(file));
    for (std::size_t size = 0; size < file.size(); size += size < 2000 ? 1 : 97)
    {
      const std::string cut = file.substr(0, size);
      EXPECT_THROW(readGrid(cut), VdbError) << "cut after " << size << " of " << file.size() << " bytes";
    }
  }
}

TEST(VdbFile, ChangedBytesNeverCrash)
{
  auto grid = named<FloatGrid>("density");
  grid->tree().setValue(Coord(1, 2, 3), 1.0f);
  grid->denseFill({ Coord(8, 8, 8), Coord(15, 15, 15) }, 3.0f);
  const std::string file = seekableFileOf({ grid });
  int errors = 0;
  for (std::size_t at = 0; at < file.size(); at += at < 1200 ? 1 : 61)
  {
    for (const int change : { 0x01, 0x80, 0xff })
    {
      std::string changed = file;
      changed[at] = static_cast<char>(changed[at] ^ change);
      try
      {
        const VdbGrid read = readGrid(changed, "", 64 << 20);
        sampleIsoSurface(read, 0.5);
      }
      catch (const VdbError&)
      {
        ++errors;
      }
    }
  }
  EXPECT_GT(errors, 100);
}

} // namespace
