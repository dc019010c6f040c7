// SPDX-License-Identifier: BSD-3-Clause
// Volumes of VolVis: plain ones and those of run lengths, whole and in parts, and what is refused.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

/// Alike in the upper half of each slice.
unsigned char ByteAt(int x, int y, int z)
{
  return static_cast<unsigned char>(y > 2 ? 200 + z : 40 * x + 5 * y + z);
}

std::string Slice(int z)
{
  std::string bytes;
  for (int y = 0; y < Size[1]; ++y)
  {
    for (int x = 0; x < Size[0]; ++x)
    {
      bytes += static_cast<char>(ByteAt(x, y, z));
    }
  }
  return bytes;
}

/// A run of values that differ, and one of values that do not.
std::string Runs(int z)
{
  const std::string slice = Slice(z);
  const char different = 3 * Size[0];
  const char alike = 2 * Size[0];
  return static_cast<char>(different | 0x80) + slice.substr(0, 3 * Size[0]) + alike + slice.back() + '\0';
}

struct Slc
{
  std::string magic = "11111";
  std::string size = "7 5 6 8";
  std::string spacing = "1.5 2.0 0.25";
  std::string kinds = "1 6 0";
  std::string compression = "1";
  std::string icon = "2 1 X012345";
  std::vector<std::string> slices;
  std::string before = " X"; ///< between the size of a slice's runs and them

  explicit Slc(bool compressed = true)
  {
    this->compression = compressed ? "1" : "0";
    for (int z = 0; z < Size[2]; ++z)
    {
      this->slices.push_back(compressed ? Runs(z) : Slice(z));
    }
  }

  std::string bytes() const
  {
    std::string all = this->magic + '\n' + this->size + '\n' + this->spacing + '\n' + this->kinds + ' ' +
      this->compression + '\n' + this->icon;
    for (const std::string& slice : this->slices)
    {
      all += this->compression == "1" ? std::to_string(slice.size()) + this->before + slice : slice;
    }
    return all;
  }
};

void ExpectBytes(vtkImageData* image, const std::string& name)
{
  int extent[6];
  image->GetExtent(extent);
  ASSERT_EQ(image->GetScalarType(), VTK_UNSIGNED_CHAR) << name;
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      for (int x = extent[0]; x <= extent[1]; ++x)
      {
        EXPECT_EQ(image->GetScalarComponentAsDouble(x, y, z, 0), ByteAt(x, y, z))
          << name << " at " << x << " " << y << " " << z;
      }
    }
  }
}

} // namespace

TEST(SlcVolumes, ValuesAndPositions)
{
  for (const bool compressed : { true, false })
  {
    const std::string file = Put("SlcVolumes.slc", Slc(compressed).bytes());
    const auto reader = UpdatedReaderOf(file);
    EXPECT_EQ(reader->CanReadFile(file.c_str()), 1);
    EXPECT_STREQ(reader->GetFormat(), "VolVis volume");
    EXPECT_EQ(reader->GetNumberOfNotes(), 0);
    EXPECT_EQ(reader->HasPlainVoxels(), !compressed);
    ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), Size[0] * Size[1] * Size[2]);
    ExpectBytes(reader->GetOutput(), compressed ? "run lengths" : "plain");
    EXPECT_EQ(PositionOf(reader->GetOutput(), 0, 0, 0), (std::array{ 0.0, 0.0, 0.0 }));
    EXPECT_EQ(PositionOf(reader->GetOutput(), 2, 3, 4), (std::array{ 3.0, 6.0, 1.0 }));
  }
}

TEST(SlcVolumes, PartsAreReadInAnyOrder)
{
  for (const bool compressed : { true, false })
  {
    const auto reader = ReaderOf(Put("SlcVolumesParts.slc", Slc(compressed).bytes()));
    for (const auto& part : std::vector<std::array<int, 6>>{
           { 1, 5, 2, 3, 3, 4 }, { 0, 6, 0, 4, 5, 5 }, { 6, 6, 4, 4, 0, 5 }, { 0, 6, 1, 2, 0, 1 } })
    {
      reader->UpdateExtent(part.data());
      int extent[6];
      reader->GetOutput()->GetExtent(extent);
      EXPECT_EQ(std::to_array(extent), part);
      ExpectBytes(reader->GetOutput(), "part");
    }
  }
}

TEST(SlcVolumes, RunsMayEndWithoutAMarkAndBeFollowedBySpace)
{
  Slc slc;
  for (std::string& slice : slc.slices)
  {
    slice.pop_back();
  }
  slc.icon = "0 0 X\n";
  slc.before = "\nX";
  ExpectBytes(UpdatedReaderOf(Put("SlcVolumesBare.slc", slc.bytes()))->GetOutput(), "bare");
}

TEST(SlcVolumes, TheLastValueOfASliceMayBeMissing)
{
  Slc slc;
  for (std::string& slice : slc.slices)
  {
    --slice[slice.size() - 3];
  }
  ExpectBytes(UpdatedReaderOf(Put("SlcVolumesOneLess.slc", slc.bytes()))->GetOutput(), "one less");
}

TEST(SlcVolumes, WhatCannotBeReadIsOneError)
{
  const struct
  {
    std::function<void(Slc&)> change;
    std::vector<std::string> words;
  } cases[] = {
    { [](Slc& slc) { slc.magic = "11112"; }, { "it is no volume of VolVis, which begins with 11111" } },
    { [](Slc& slc) { slc.size = "7 5 6 16"; }, { "its header says 16 bits a voxel; expected 8" } },
    { [](Slc& slc) { slc.size = "7 5 0 8"; }, { "its header says dimensions 7 x 5 x 0" } },
    { [](Slc& slc) { slc.size = "7 -5 6 8"; }, { "its header says dimensions 7 x -5 x 6" } },
    { [](Slc& slc) { slc.size = "7 5.5 6 8"; }, { "it says '5.5' where a number of voxels was expected" } },
    { [](Slc& slc) { slc.size = "2000000000 2000000000 2000000000 8"; }, { "its header says dimensions" } },
    { [](Slc& slc) { slc.size = "7 5 600 8"; },
      { "bytes of compressed data, but its header promises 21000" } },
    { [](Slc& slc) { slc.spacing = "1 inf 1"; }, { "it says 'inf' where a distance between voxels" } },
    { [](Slc& slc) { slc.kinds = "1 x 0"; }, { "it says 'x' where what the data comes from was expected" } },
    { [](Slc& slc) { slc.compression = "2"; },
      { "its header says compression 2; expected 0 (none) or 1 (run lengths)" } },
    { [](Slc& slc) { slc.icon = "2 -1 X"; }, { "it says '-1' where the height of the icon was expected" } },
    { [](Slc& slc) { slc.icon = "2 1 Y012345"; }, { "it says 'Y012345", "the X before the icon" } },
    { [](Slc& slc) { slc.icon = "2000000000 2000000000 X"; },
      { "it has 0 bytes of compressed data, but its header promises 210" } },
    { [](Slc& slc) { slc.before = " Z"; },
      { "it says '25 Z' where slice 1 begins; expected how many of the", "bytes left it takes, and an X" } },
    { [](Slc& slc) { slc.slices.pop_back(); }, { "it says ' ' where slice 6 begins" } },
    { [](Slc& slc) { slc.slices[1] = "\x7f" + std::string("a\0", 2); },
      { "the run lengths of slice 2 make more than its 35 values" } },
    { [](Slc& slc) { slc.slices[2] = "\x14" + std::string("a\0", 2); },
      { "the run lengths of slice 3 end after 20 of its 35 values" } },
    { [](Slc& slc) { slc.slices[3] = "\x14" + std::string("a\x8f") + "bcd"; },
      { "the run lengths of slice 4 end within a run, after 20 of its 35 values" } },
  };
  for (const auto& one : cases)
  {
    Slc slc;
    one.change(slc);
    ExpectRefused(Put("SlcVolumesBroken.slc", slc.bytes()), one.words);
  }
  Slc plain(false);
  plain.slices.back().pop_back();
  ExpectRefused(
    Put("SlcVolumesCut.slc", plain.bytes()), { "it has 209 bytes of data, but its header promises 210" });
  const std::string whole = Slc().bytes();
  ExpectRefused(Put("SlcVolumesCut.slc", whole.substr(0, whole.size() - 1)),
    { "where slice 6 begins; expected how many of the 24 bytes left" });
  ExpectRefused(Put("SlcVolumesCut.slc", "11111\n7 5"), { "the file ends where a number of voxels" });
  ExpectRefused(Gzip("SlcVolumesGzip.slc", whole), { "it is no volume of VolVis" });
}
