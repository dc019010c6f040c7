// SPDX-License-Identifier: BSD-3-Clause
// FreeSurfer's volumes: every number of the header that is used, and what is refused.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

/// A header and the values of Volume(), all with the most significant byte first.
struct Mgh
{
  std::int32_t version = 1;
  std::array<std::int32_t, 3> size{ Size[0], Size[1], Size[2] };
  std::int32_t frames = 1;
  std::int32_t type = 4;
  bool hasGeometry = true;
  std::array<float, 3> spacing{ 1.0F, 2.0F, 0.5F };
  std::array<float, 9> directions{ -1, 0, 0, 0, 0, -1, 0, 1, 0 };
  std::array<float, 3> center{ 10.0F, 20.0F, 30.0F };
  std::string values = Bytes(true);

  std::string bytes() const
  {
    std::string all;
    const auto add = [&all](auto value)
    {
      auto bytes = std::bit_cast<std::array<char, sizeof(value)>>(value);
      std::reverse(bytes.begin(), bytes.end());
      all.append(bytes.begin(), bytes.end());
    };
    add(this->version);
    std::for_each(this->size.begin(), this->size.end(), add);
    add(this->frames);
    add(this->type);
    add(std::int32_t{ 0 });
    add(static_cast<std::int16_t>(this->hasGeometry));
    std::for_each(this->spacing.begin(), this->spacing.end(), add);
    std::for_each(this->directions.begin(), this->directions.end(), add);
    std::for_each(this->center.begin(), this->center.end(), add);
    all.resize(284);
    return all + this->values;
  }
};

} // namespace

TEST(MghVolumes, ValuesLieWhereTheHeaderSays)
{
  for (const std::string& file :
    { Put("MghVolumes.mgh", Mgh().bytes()), Gzip("MghVolumes.mgz", Mgh().bytes()) })
  {
    const auto reader = UpdatedReaderOf(file);
    EXPECT_STREQ(reader->GetFormat(), "FreeSurfer volume") << file;
    EXPECT_EQ(reader->CanReadFile(file.c_str()), 1) << file;
    EXPECT_EQ(reader->HasPlainVoxels(), file.ends_with(".mgh")) << file;
    EXPECT_EQ(reader->GetNumberOfNotes(), 0) << file;
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(image->GetNumberOfPoints(), Size[0] * Size[1] * Size[2]) << file;
    ASSERT_EQ(image->GetScalarType(), VTK_SHORT) << file;
    ExpectValues(image, file);
    // The center is that of voxel size / 2. FreeSurfer's right and front are DICOM's left and back turned.
    EXPECT_EQ(PositionOf(image, 0, 0, 0), (std::array{ -13.5, -18.5, 35.0 })) << file;
    EXPECT_EQ(PositionOf(image, 1, 0, 0), (std::array{ -12.5, -18.5, 35.0 })) << file;
    EXPECT_EQ(PositionOf(image, 0, 1, 0), (std::array{ -13.5, -18.5, 33.0 })) << file;
    EXPECT_EQ(PositionOf(image, 0, 0, 1), (std::array{ -13.5, -19.0, 35.0 })) << file;
  }
}

TEST(MghVolumes, WithoutGeometryItIsFreeSurfersUsual)
{
  Mgh mgh;
  mgh.hasGeometry = false;
  const auto reader = UpdatedReaderOf(Put("MghVolumesUsual.mgh", mgh.bytes()));
  EXPECT_EQ(PositionOf(reader->GetOutput(), 0, 0, 0), (std::array{ -3.5, 3.0, 2.5 }));
  EXPECT_EQ(PositionOf(reader->GetOutput(), 1, 1, 1), (std::array{ -2.5, 2.0, 1.5 }));
}

TEST(MghVolumes, TypesAndFrames)
{
  const struct
  {
    std::int32_t type;
    int vtk;
    std::string first;
    double value;
  } types[] = { { 0, VTK_UNSIGNED_CHAR, "\xfe", 254.0 }, { 1, VTK_INT, "\xff\xff\xff\xfe", -2.0 },
    { 3, VTK_FLOAT, std::string("\xc0\x20\0\0", 4), -2.5 }, { 4, VTK_SHORT, "\xff\xfe", -2.0 },
    { 10, VTK_UNSIGNED_SHORT, "\xff\xfe", 65534.0 } };
  for (const auto& one : types)
  {
    Mgh mgh;
    mgh.type = one.type;
    mgh.frames = 2;
    mgh.values.clear();
    for (int i = 0; i < 2 * Size[0] * Size[1] * Size[2]; ++i)
    {
      mgh.values += one.first;
    }
    const auto reader = UpdatedReaderOf(Put("MghVolumesType.mgh", mgh.bytes()));
    ASSERT_EQ(reader->GetOutput()->GetScalarType(), one.vtk) << one.type;
    EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(6, 4, 5, 0), one.value) << one.type;
    ASSERT_EQ(reader->GetNumberOfNotes(), 1);
    EXPECT_STREQ(reader->GetNote(0), "it has 2 frames; the first is used");
  }
}

TEST(MghVolumes, WhatCannotBeReadIsOneError)
{
  const struct
  {
    std::function<void(Mgh&)> change;
    const char* words;
  } cases[] = {
    { [](Mgh& mgh) { mgh.version = 2; }, "it is no volume of FreeSurfer" },
    { [](Mgh& mgh) { mgh.type = 2; }, "its header says type 2; expected 0 (uint8), 1 (int32)" },
    { [](Mgh& mgh) { mgh.size[1] = 0; }, "its header says dimensions 7 x 0 x 6" },
    { [](Mgh& mgh) { mgh.values.resize(100); }, "it has 100 bytes of data, but its header promises 420" },
  };
  for (const auto& one : cases)
  {
    Mgh mgh;
    one.change(mgh);
    ExpectRefused(Put("MghVolumesBroken.mgh", mgh.bytes()), { one.words });
  }
}
