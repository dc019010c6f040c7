// SPDX-License-Identifier: BSD-3-Clause
// Files of voxels alone whose names say what is in them: how they may say it, and what is refused.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include "vtkType.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

constexpr int Voxels = Size[0] * Size[1] * Size[2];

std::string Bytes(int perVoxel)
{
  std::string bytes;
  for (int i = 0; i < Voxels * perVoxel; ++i)
  {
    bytes += static_cast<char>(i % 251);
  }
  return bytes;
}

} // namespace

TEST(NamedRawVolumes, AsTheirNamesSay)
{
  const std::vector<std::pair<std::string, int>> files = {
    { "_7x5x6_uint8.raw", VTK_UNSIGNED_CHAR },
    { ".7X5X6.INT8.RAW", VTK_SIGNED_CHAR },
    { "-int16-7x5x6.raw", VTK_SHORT },
    { "_7x5x6_uint16.raw", VTK_UNSIGNED_SHORT },
    { "_7x5x6_float32_of2024.raw", VTK_FLOAT },
    { " (7x5x6, float64).raw", VTK_DOUBLE },
    { "_7x5x6.raw", VTK_UNSIGNED_CHAR },
    { "_7x5x6_short.raw", VTK_SHORT },
    { "_double_pendulum_7x5x6.raw", VTK_UNSIGNED_CHAR },
    { "_short_bone_7x5x6_uint8.raw", VTK_UNSIGNED_CHAR },
    { "_1x1x1mm_7x5x6_uint8.raw", VTK_UNSIGNED_CHAR },
    { "_1x1x1_7x5x6_uint8.raw", VTK_UNSIGNED_CHAR },
    { "_0.5x1x2_7x5x6_uint8.raw", VTK_UNSIGNED_CHAR },
    { "_uint16le_7x5x6.raw", VTK_UNSIGNED_SHORT },
  };
  for (const auto& [name, type] : files)
  {
    const int bytes = vtkDataArray::GetDataTypeSize(type);
    const auto reader = UpdatedReaderOf(Put("NamedRaw" + name, Bytes(bytes)));
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(image->GetNumberOfPoints(), Voxels) << name;
    EXPECT_EQ(image->GetDimensions()[0], 7) << name;
    EXPECT_EQ(image->GetDimensions()[2], 6) << name;
    EXPECT_EQ(image->GetScalarType(), type) << name;
    EXPECT_STREQ(reader->GetFormat(), "raw volume") << name;
    ASSERT_EQ(reader->GetNumberOfNotes(), 1) << name;
    const std::string note = reader->GetNote(0);
    EXPECT_NE(note.find("7 x 5 x 6"), std::string::npos) << note;
    EXPECT_EQ(note.find("little endian") != std::string::npos, bytes > 1) << note;
  }
}

TEST(NamedRawVolumes, TheTypeMayFollowFromTheSize)
{
  const auto reader = UpdatedReaderOf(Put("NamedRawTwoBytes_7x5x6.raw", Bytes(2)));
  EXPECT_EQ(reader->GetOutput()->GetScalarType(), VTK_UNSIGNED_SHORT);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(1, 0, 0, 0), 2 + 256 * 3);
}

TEST(NamedRawVolumes, BigEndian)
{
  for (const char* name :
    { "_7x5x6_uint16be", "_7x5x6_uint16_be", "_big-endian_7x5x6_uint16", "_7x5x6_uint16_MSB" })
  {
    const auto reader = UpdatedReaderOf(Put("NamedRaw" + std::string(name) + ".raw", Bytes(2)));
    ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), Voxels) << name;
    EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(1, 0, 0, 0), 256 * 2 + 3) << name;
    EXPECT_NE(std::string(reader->GetNote(0)).find("big endian"), std::string::npos) << name;
  }
}

TEST(NamedRawVolumes, WithoutADimensionOrATypeThereIsOneError)
{
  const std::string expected = "expected one such as skull_256x256x256_uint8.raw";
  ExpectRefused(Put("NamedRaw.raw", Bytes(1)), { "does not say what is in it", expected });
  ExpectRefused(Put("NamedRaw_7x5_uint8.raw", Bytes(1)), { expected });
  ExpectRefused(Put("NamedRaw_7x5x6x2_uint8.raw", Bytes(2)), { expected });
  ExpectRefused(Put("NamedRaw_7x5x0_uint8.raw", Bytes(1)), { expected });
  ExpectRefused(Put("NamedRaw_7x5x6_float16.raw", Bytes(2)), { "its name says 'float16'", "float32" });
  ExpectRefused(Put("NamedRaw_7x5x6_rgb.raw", Bytes(2)), { "its name says 'rgb'" });
  ExpectRefused(Put("NamedRaw_int8_to_uint8_7x5x6.raw", Bytes(1)), { "its name says 'uint8' and 'int8'" });
  ExpectRefused(Put("NamedRawFour_7x5x6.raw", Bytes(4)), { expected });
  ExpectRefused(
    Put("NamedRaw_7x5x7_uint8.raw", Bytes(1)), { "it has 210 bytes, but 7 x 5 x 7 unsigned char needs 245" });
  ExpectRefused(
    Put("NamedRaw_999999x999999x999999_float64.raw", Bytes(1)), { "it has 210 bytes, but 999999 x" });
}
