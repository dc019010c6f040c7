// SPDX-License-Identifier: BSD-3-Clause
// DICOM's compressed pixels: every codec of GDCM's, whole and in parts, in one file and in several.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include <gdcmAttribute.h>
#include <gdcmImage.h>
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageWriter.h>
#include <gdcmReader.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmWriter.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

struct Codec
{
  const char* Name;
  gdcm::TransferSyntax::TSType Syntax;
};

const Codec Lossless[] = { { "run lengths", gdcm::TransferSyntax::RLELossless },
  { "JPEG", gdcm::TransferSyntax::JPEGLosslessProcess14_1 },
  { "JPEG-LS", gdcm::TransferSyntax::JPEGLSLossless },
  { "JPEG 2000", gdcm::TransferSyntax::JPEG2000Lossless } };

constexpr int Columns = 40; // GDCM's JPEG 2000 halves them several times
constexpr int Rows = 36;
constexpr int Slices = 6;

/// Slices of values as ValueAt() says, compressed.
void WriteImage(const std::string& file, gdcm::TransferSyntax::TSType syntax, int first, int count)
{
  std::vector<short> values;
  for (int z = first; z < first + count; ++z)
  {
    for (int y = 0; y < Rows; ++y)
    {
      for (int x = 0; x < Columns; ++x)
      {
        values.push_back(ValueAt(x, y, z));
      }
    }
  }
  gdcm::SmartPointer<gdcm::Image> image = new gdcm::Image;
  image->SetNumberOfDimensions(count > 1 ? 3 : 2);
  image->SetDimension(0, Columns);
  image->SetDimension(1, Rows);
  if (count > 1)
  {
    image->SetDimension(2, static_cast<unsigned int>(count));
  }
  image->SetPixelFormat(gdcm::PixelFormat::INT16);
  image->SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  image->SetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  gdcm::DataElement pixels(gdcm::Tag(0x7FE0, 0x0010));
  pixels.SetByteValue(reinterpret_cast<const char*>(values.data()),
    gdcm::VL(static_cast<std::uint32_t>(values.size() * sizeof(short))));
  image->SetDataElement(pixels);
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(syntax);
  change.SetInput(*image);
  ASSERT_TRUE(change.Change()) << file;
  gdcm::ImageWriter writer;
  writer.SetFileName(file.c_str());
  writer.SetImage(change.GetOutput());
  gdcm::Attribute<0x0008, 0x0016> kind;
  kind.SetValue(gdcm::MediaStorage::GetMSString(
    count > 1 ? gdcm::MediaStorage::EnhancedMRImageStorage : gdcm::MediaStorage::MRImageStorage));
  gdcm::Attribute<0x0020, 0x000E> series;
  series.SetValue("1.2.8");
  gdcm::DataSet& elements = writer.GetFile().GetDataSet();
  elements.Replace(kind.GetAsDataElement());
  elements.Replace(series.GetAsDataElement());
  ASSERT_TRUE(writer.Write()) << file;
}

void WriteSlice(const std::string& file, gdcm::TransferSyntax::TSType syntax, int z)
{
  WriteImage(file, syntax, z, 1);
  // ImageWriter has no place along z for a picture alone.
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  ASSERT_TRUE(reader.Read());
  gdcm::Attribute<0x0020, 0x0032> position = { { 0.0, 0.0, static_cast<double>(z) } };
  reader.GetFile().GetDataSet().Replace(position.GetAsDataElement());
  gdcm::Writer writer;
  writer.SetFile(reader.GetFile());
  writer.SetFileName(file.c_str());
  ASSERT_TRUE(writer.Write());
}

TEST(CompressedDicom, FramesOfOneFile)
{
  for (const Codec& codec : Lossless)
  {
    SCOPED_TRACE(codec.Name);
    const std::string file = "CompressedDicomFrames.dcm";
    WriteImage(file, codec.Syntax, 0, Slices);
    const auto reader = UpdatedReaderOf(file);
    EXPECT_FALSE(reader->HasPlainVoxels());
    ExpectValues(reader->GetOutput(), codec.Name);
  }
}

TEST(CompressedDicom, SlicesOfASeries)
{
  for (const Codec& codec : Lossless)
  {
    SCOPED_TRACE(codec.Name);
    const std::filesystem::path folder = "CompressedDicomSeries";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
    for (int z = 0; z < Slices; ++z)
    {
      WriteSlice((folder / (std::to_string(Slices - z) + ".dcm")).string(), codec.Syntax, z);
    }
    const auto reader = UpdatedReaderOf(folder.string());
    EXPECT_STREQ(reader->GetFormat(), "DICOM series");
    EXPECT_EQ(PositionOf(reader->GetOutput(), 1, 2, 3), (std::array<double, 3>{ 1.0, 2.0, 3.0 }));
    ExpectValues(reader->GetOutput(), codec.Name);
  }
}

/// Cuts each fragment of a file in two. @param withTable whether it says where those of each frame begin
void HalveFragments(const std::string& file, bool withTable)
{
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  ASSERT_TRUE(reader.Read());
  gdcm::DataElement pixels = reader.GetFile().GetDataSet().GetDataElement(gdcm::Tag(0x7FE0, 0x0010));
  const gdcm::SequenceOfFragments& whole = *pixels.GetSequenceOfFragments();
  gdcm::SmartPointer<gdcm::SequenceOfFragments> halves = new gdcm::SequenceOfFragments;
  std::vector<std::uint32_t> begins;
  std::uint32_t end = 0;
  const auto add = [&](const char* bytes, std::uint32_t count)
  {
    gdcm::Fragment fragment;
    fragment.SetByteValue(bytes, gdcm::VL(count));
    halves->AddFragment(fragment);
    end += 8 + count;
  };
  for (std::size_t i = 0; i < whole.GetNumberOfFragments(); ++i)
  {
    const gdcm::ByteValue& bytes = *whole.GetFragment(i).GetByteValue();
    const std::uint32_t first = bytes.GetLength() / 4 * 2;
    begins.push_back(end);
    add(bytes.GetPointer(), first);
    add(bytes.GetPointer() + first, bytes.GetLength() - first);
  }
  if (withTable)
  {
    halves->GetTable().SetByteValue(reinterpret_cast<const char*>(begins.data()),
      gdcm::VL(static_cast<std::uint32_t>(begins.size() * sizeof(std::uint32_t))));
  }
  pixels.SetValue(*halves);
  reader.GetFile().GetDataSet().Replace(pixels);
  gdcm::Writer writer;
  writer.SetFile(reader.GetFile());
  writer.SetFileName(file.c_str());
  ASSERT_TRUE(writer.Write());
}

TEST(CompressedDicom, FramesOfSeveralFragments)
{
  const std::string file = "CompressedDicomFragments.dcm";
  WriteImage(file, gdcm::TransferSyntax::JPEGLosslessProcess14_1, 0, Slices);
  HalveFragments(file, true);
  ExpectValues(UpdatedReaderOf(file)->GetOutput(), "with a table");
  HalveFragments(file, false);
  ExpectValues(UpdatedReaderOf(file)->GetOutput(), "by where a codestream begins");
  // Of one frame all of them are.
  WriteSlice(file, gdcm::TransferSyntax::JPEGLosslessProcess14_1, 0);
  HalveFragments(file, false);
  ExpectValues(UpdatedReaderOf(file)->GetOutput(), "of one frame");
}

TEST(CompressedDicom, AnyPart)
{
  const std::string file = "CompressedDicomParts.dcm";
  WriteImage(file, gdcm::TransferSyntax::JPEGLosslessProcess14_1, 0, Slices);
  const auto reader = ReaderOf(file);
  for (const int slice : { 3, 1, 5 })
  {
    const int extent[6] = { 2, 4, 1, 4, slice, slice };
    reader->UpdateExtent(extent);
    vtkImageData* image = reader->GetOutput();
    for (int y = 1; y <= 4; ++y)
    {
      for (int x = 2; x <= 4; ++x)
      {
        EXPECT_EQ(image->GetScalarComponentAsDouble(x, y, slice, 0), ValueAt(x, y, slice));
      }
    }
  }
}

} // namespace
