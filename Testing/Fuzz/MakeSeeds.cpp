// SPDX-License-Identifier: BSD-3-Clause
// Writes small .vdb files of all kinds into a folder, for the fuzzer to start from: Corpus/vdb/seed-*.vdb.

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>

namespace
{

using openvdb::Coord;
using openvdb::DoubleGrid;
using openvdb::FloatGrid;

void write(const std::filesystem::path& folder, const std::string& name, const openvdb::GridPtrVec& grids,
  std::uint32_t compression)
{
  openvdb::io::File file((folder / (name + ".vdb")).string());
  file.setCompression(compression);
  file.write(grids);
}

template <class Grid>
typename Grid::Ptr some(const std::string& name)
{
  auto grid = Grid::create(0.0);
  grid->setName(name);
  grid->tree().setValue(Coord(1, 2, 3), 1.0);
  return grid;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: MakeSeeds FOLDER" << std::endl;
    return EXIT_FAILURE;
  }
  openvdb::initialize();
  const std::filesystem::path folder(argv[1]);
  std::filesystem::create_directories(folder);
  constexpr std::uint32_t blosc = openvdb::io::COMPRESS_BLOSC | openvdb::io::COMPRESS_ACTIVE_MASK;
  constexpr std::uint32_t zip = openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK;

  write(folder, "empty", { FloatGrid::create(1.0f) }, blosc);
  write(folder, "one-voxel", { some<FloatGrid>("a") }, blosc);
  write(folder, "double-zip", { some<DoubleGrid>("a") }, zip);
  write(folder, "plain", { some<FloatGrid>("a") }, openvdb::io::COMPRESS_ACTIVE_MASK);
  write(folder, "two-of-one-name", { some<FloatGrid>("a"), some<DoubleGrid>("a") }, blosc);
  const auto half = some<FloatGrid>("a");
  half->setSaveFloatAsHalf(true);
  write(folder, "half", { half }, blosc);
  const auto fog = some<DoubleGrid>("a");
  fog->setSaveFloatAsHalf(true);
  fog->setGridClass(openvdb::GRID_FOG_VOLUME);
  fog->sparseFill({ Coord(2, 2, 2), Coord(9, 5, 4) }, 0.5, true);
  write(folder, "fog-half-double", { fog }, openvdb::io::COMPRESS_ACTIVE_MASK);
  auto other = openvdb::Vec3SGrid::create();
  other->tree().setValue(Coord(0, 0, 0), openvdb::Vec3s(1.0f));
  write(folder, "other-types", { other, openvdb::BoolGrid::create(), some<FloatGrid>("a") }, blosc);
  // Within one inner node, the largest part of a small file.
  const auto sphere = openvdb::tools::createLevelSetSphere<FloatGrid>(2.0f, { 9.0f, 8.0f, 7.0f }, 1.0f, 2.0f);
  sphere->transform().postRotate(0.3, openvdb::math::X_AXIS);
  write(folder, "level-set", { sphere }, zip);
  const auto tiles = some<FloatGrid>("a");
  tiles->sparseFill({ Coord(-8, 0, 0), Coord(-1, 7, 7) }, 2.0f, true);
  tiles->sparseFill({ Coord(128, 0, 0), Coord(255, 127, 127) }, 3.0f, true);
  tiles->sparseFill({ Coord(-4096, 0, 0), Coord(-1, 4095, 4095) }, 0.0f, true);
  write(folder, "tiles", { tiles }, blosc);
  const auto extreme = some<DoubleGrid>("a");
  extreme->tree().setValue(Coord(-(1 << 29), 1 << 29, 5), 1e308);
  extreme->tree().setValue(Coord(2, 2, 3), std::numeric_limits<double>::quiet_NaN());
  extreme->tree().setValue(Coord(2, 3, 3), std::numeric_limits<double>::infinity());
  write(folder, "extreme", { extreme }, zip);

  openvdb::GridPtrVec shared{ some<FloatGrid>("a"), FloatGrid::create() };
  openvdb::gridPtrCast<FloatGrid>(shared[1])->setTree(openvdb::gridPtrCast<FloatGrid>(shared[0])->treePtr());
  shared[1]->setName("b");
  write(folder, "shared-tree", shared, blosc);
  std::ofstream stream(folder / "stream.vdb", std::ios::binary);
  openvdb::io::Stream(stream).write(shared);
  return EXIT_SUCCESS;
}
