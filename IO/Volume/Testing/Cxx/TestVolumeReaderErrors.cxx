// SPDX-License-Identifier: BSD-3-Clause
// What cannot be read: one message that says what was found and what was expected, and an empty output.

#include "VolumeTestFiles.h"

#include "InkTestMessages.h"

#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkInkVolumeReader.h"

#include <gtest/gtest.h>

#include <functional>

using namespace VolumeTestFiles;

namespace
{

void ExpectError(
  const std::vector<std::string>& words, const std::string& file,
  const std::function<void(vtkInkVolumeReader*)>& change = [](vtkInkVolumeReader*) {})
{
  vtkNew<vtkInkVolumeReader> reader;
  vtkNew<InkTestMessages> messages;
  messages->Observe(reader);
  messages->Observe(reader->GetExecutive());
  reader->SetFileName(file.empty() ? nullptr : file.c_str());
  change(reader);
  reader->Update();
  messages->Expect(file, words);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
  EXPECT_NE(reader->GetErrorCode(), vtkErrorCode::NoError) << file;
  EXPECT_EQ(reader->GetNumberOfNotes(), 0) << file;

  // Nothing of it is left.
  messages->Messages.clear();
  reader->RawOff();
  const std::string good = std::string("VolumeReaderBeside") +
    testing::UnitTest::GetInstance()->current_test_info()->name() + ".nii";
  reader->SetFileName(Write<vtkNIFTIImageWriter>(good, Volume(), [](auto*) {}).c_str());
  reader->Update();
  messages->Expect(file + ", then another", {});
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), Size[0] * Size[1] * Size[2]);
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError);

  // And nothing of the good one.
  reader->SetFileName(file.empty() ? nullptr : file.c_str());
  change(reader);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
  EXPECT_NE(reader->GetErrorCode(), vtkErrorCode::NoError) << file;
}

} // namespace

TEST(VolumeReaderErrors, NothingToRead)
{
  ExpectError({ "FileName is empty" }, "");
  ExpectError({ "'none.nii'", "no such file" }, "none.nii");
  ExpectError({ "the file is empty" }, Put("VolumeReaderEmpty.nii", ""));
  ExpectError({ "unknown type '.txt'; expected one of .nii .nii.gz" }, Put("VolumeReader.txt", "words"));
  std::filesystem::create_directories("VolumeReaderFolder");
  ExpectError({ "without DICOM files" }, "VolumeReaderFolder");
  vtkNew<vtkInkVolumeReader> reader;
  for (const char* file : { "none.nii", "VolumeReaderEmpty.nii", "VolumeReader.txt", "VolumeReaderFolder" })
  {
    EXPECT_EQ(reader->CanReadFile(file), 0) << file;
  }
  EXPECT_EQ(reader->CanReadFile(nullptr), 0);
}

TEST(VolumeReaderErrors, FilesOfOtherContents)
{
  for (const char* suffix : { ".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".vti", ".vtk" })
  {
    ExpectError({ "cannot read", "VolumeReaderWords" },
      Put(std::string("VolumeReaderWords") + suffix, "These are words, not voxels.\n"));
  }
}

TEST(VolumeReaderErrors, FilesThatEndTooSoon)
{
  for (const std::string& file : All("VolumeReaderShort"))
  {
    ExpectError({ "cannot read" }, CutShort(file, "Cut" + file, 80));
  }
}

TEST(VolumeReaderErrors, RawFilesOfAnotherSize)
{
  const std::string file = Put("VolumeReaderSize.raw", Bytes(false));
  const auto with = [](int x, int type)
  {
    return [x, type](vtkInkVolumeReader* reader)
    {
      reader->RawOn();
      reader->SetRawDimensions(x, Size[1], Size[2]);
      reader->SetRawScalarType(type);
    };
  };
  ExpectError({ "it has 420 bytes, but 8 x 5 x 6 short needs 480" }, file, with(8, VTK_SHORT));
  ExpectError({ "RawDimensions are 0 x 5 x 6; expected numbers of 1 or more" }, file, with(0, VTK_SHORT));
  ExpectError({ "RawScalarType is 13" }, file, with(7, VTK_STRING));
  ExpectError({ "RawScalarType is 1" }, file, with(7, VTK_BIT));
  ExpectError(
    { "it has 420 bytes, but 2147483647 x 2147483647 x 2147483647 unsigned char needs 9.90352e+27" }, file,
    [](vtkInkVolumeReader* reader)
    {
      reader->RawOn();
      reader->SetRawDimensions(VTK_INT_MAX, VTK_INT_MAX, VTK_INT_MAX);
    });
}

TEST(VolumeReaderErrors, NothingIsKnownOfTheFileBefore)
{
  vtkNew<vtkInkVolumeReader> reader;
  vtkNew<InkTestMessages> messages;
  messages->Observe(reader);
  reader->SetFileName(Write<vtkNIFTIImageWriter>("VolumeReaderBefore.nii", Volume(), [](auto*) {}).c_str());
  reader->UpdateInformation();
  EXPECT_STREQ(reader->GetFormat(), "NIfTI volume");
  EXPECT_TRUE(reader->HasPlainVoxels());
  reader->SetFileName("none.nii");
  reader->UpdateInformation();
  EXPECT_EQ(messages->Messages.size(), 1u);
  EXPECT_STREQ(reader->GetFormat(), "");
  EXPECT_FALSE(reader->HasPlainVoxels());
  EXPECT_EQ(reader->GetMemorySize(), 0);
}
