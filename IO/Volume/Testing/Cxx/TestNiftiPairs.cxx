// SPDX-License-Identifier: BSD-3-Clause
// NIfTI and Analyze volumes whose header and voxels are two files.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include "vtkType.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

template <class T>
void PutAt(std::string& bytes, std::size_t offset, T value)
{
  std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

/// Of Volume(), in Analyze 7.5 or as the first of a NIfTI pair.
std::string Header(bool nifti)
{
  std::string bytes(348, '\0');
  PutAt(bytes, 0, std::int32_t{ 348 });
  PutAt(bytes, 40, std::int16_t{ 4 });
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    PutAt(bytes, 42 + 2 * axis, static_cast<std::int16_t>(Size[axis]));
    PutAt(bytes, 80 + 4 * axis, 1.0F + 0.5F * static_cast<float>(axis));
  }
  PutAt(bytes, 48, std::int16_t{ 1 });
  PutAt(bytes, 70, std::int16_t{ 4 });
  if (nifti)
  {
    bytes.replace(344, 4, "ni1", 4);
  }
  return bytes;
}

/// @return the header's name
std::string PutPair(const std::string& name, const std::string& header)
{
  Put(name + ".img", Bytes(false));
  return Put(name + ".hdr", header);
}

void ExpectVolume(const std::string& file, const char* format)
{
  const auto reader = UpdatedReaderOf(file);
  EXPECT_STREQ(reader->GetFormat(), format) << file;
  EXPECT_EQ(reader->CanReadFile(file.c_str()), 1) << file;
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetNumberOfPoints(), Size[0] * Size[1] * Size[2]) << file;
  ASSERT_EQ(image->GetScalarType(), VTK_SHORT) << file;
  ExpectValues(image, file);
}

} // namespace

TEST(NiftiPairs, AreReadByEitherName)
{
  const std::string header = PutPair("NiftiPairs", Header(true));
  ExpectVolume(header, "NIfTI volume");
  ExpectVolume(std::filesystem::path(header).replace_extension(".img").string(), "NIfTI volume");
}

TEST(NiftiPairs, MayBeCompressed)
{
  Gzip("NiftiPairsCompressed.img.gz", Bytes(false));
  ExpectVolume(Gzip("NiftiPairsCompressed.hdr.gz", Header(true)), "NIfTI volume");
  Gzip("NiftiPairsHalf.img.gz", Bytes(false));
  ExpectVolume(Put("NiftiPairsHalf.hdr", Header(true)), "NIfTI volume");
}

TEST(NiftiPairs, OfAnalyzeGoToTheLeftTheFrontAndTheHead)
{
  std::string header = Header(false);
  PutAt(header, 116, 17.0F); // not used in Analyze 7.5
  const std::string file = PutPair("NiftiPairsAnalyze", header);
  ExpectVolume(file, "Analyze volume");
  const auto reader = UpdatedReaderOf(file);
  EXPECT_EQ(PositionOf(reader->GetOutput(), 1, 0, 0), (std::array{ 1.0, 0.0, 0.0 }));
  EXPECT_EQ(PositionOf(reader->GetOutput(), 0, 1, 0), (std::array{ 0.0, -1.5, 0.0 }));
  EXPECT_EQ(PositionOf(reader->GetOutput(), 0, 0, 1), (std::array{ 0.0, 0.0, 2.0 }));
}

TEST(NiftiPairs, OfAnalyzeSayWhereTheirSlicesAreOthers)
{
  std::string header = Header(false);
  EXPECT_EQ(UpdatedReaderOf(PutPair("NiftiPairsCoronal", header))->GetNumberOfNotes(), 0);
  header[252] = 1;
  const auto reader = UpdatedReaderOf(PutPair("NiftiPairsCoronal", header));
  ASSERT_EQ(reader->GetNumberOfNotes(), 1);
  EXPECT_NE(std::string(reader->GetNote(0)).find("orientation 1"), std::string::npos);
}

TEST(NiftiPairs, MayHaveTheMagicOfOneFileAndUpperCaseNames)
{
  std::string header = Header(true);
  header.replace(344, 4, "n+1", 4);
  Put("NiftiPairsUpper.IMG", Bytes(false));
  ExpectVolume(Put("NiftiPairsUpper.HDR", header), "NIfTI volume");
}

TEST(NiftiPairs, OfWhichTheVoxelsBeginAsDicomAreNotTakenForIt)
{
  std::string voxels = Bytes(false);
  // The group and the element that files begin with which have no preamble.
  voxels.replace(0, 8, std::string("\x08\0\x05\0\x04\0\0\0", 8));
  Put("NiftiPairsDicom.hdr", Header(true));
  const auto reader = UpdatedReaderOf(Put("NiftiPairsDicom.img", voxels));
  EXPECT_STREQ(reader->GetFormat(), "NIfTI volume");
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0), 8.0);
}

TEST(NiftiPairs, OfAnalyzeAreRescaledAsSpmDoes)
{
  std::string header = Header(false);
  PutAt(header, 112, 2.0F);
  const auto reader = UpdatedReaderOf(PutPair("NiftiPairsScaled", header));
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(3, 2, 1, 0), 2.0 * ValueAt(3, 2, 1));
}

TEST(NiftiPairs, AreRefusedWithoutTheOtherFile)
{
  ExpectRefused(
    Put("NiftiPairsAlone.hdr", Header(true)), { "NiftiPairsAlone.hdr", "ends in .img", "the voxels" });
  ExpectRefused(
    Put("NiftiPairsVoxels.img", Bytes(false)), { "NiftiPairsVoxels.img", "ends in .hdr", "the header" });
}

TEST(NiftiPairs, AreRefusedWhereTheHeaderIsNone)
{
  ExpectRefused(PutPair("NiftiPairsShort", "#?RADIANCE"), { "NiftiPairsShort.hdr", "10 bytes", "348" });
  ExpectRefused(PutPair("NiftiPairsOther", std::string(400, 'x')), { "NiftiPairsOther.hdr", "expected 348" });
  std::string large = Header(true);
  PutAt(large, 42, std::int16_t{ 3000 });
  ExpectRefused(PutPair("NiftiPairsLarge", large), { "NiftiPairsLarge.img", "bytes" });
  const std::string empty = PutPair("NiftiPairsEmpty", Header(true));
  Put("NiftiPairsEmpty.img", "");
  ExpectRefused(empty, { "NiftiPairsEmpty.img", "empty" });
}
