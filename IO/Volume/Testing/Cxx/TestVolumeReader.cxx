// SPDX-License-Identifier: BSD-3-Clause
// Every format, whole and in parts, against the values that were written.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include "RawVolume.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInkNIFTIImageReader.h"
#include "vtkInkVolumeReader.h"
#include "vtkMatrix3x3.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

vtkSmartPointer<vtkInkVolumeReader> RawReaderOf(const std::string& file)
{
  auto reader = ReaderOf(file);
  reader->RawOn();
  reader->SetRawDimensions(Size);
  reader->SetRawScalarType(VTK_SHORT);
  return reader;
}

} // namespace

TEST(VolumeReader, ReadsEveryFormatWhole)
{
  for (const std::string& file : All("VolumeReaderWhole"))
  {
    const auto reader = ReaderOf(file);
    EXPECT_EQ(reader->CanReadFile(file.c_str()), 1) << file;
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(image->GetNumberOfPoints(), Size[0] * Size[1] * Size[2]) << file;
    EXPECT_EQ(image->GetScalarType(), VTK_SHORT) << file;
    EXPECT_EQ(image->GetSpacing()[1], 2.0) << file;
    EXPECT_EQ(image->GetSpacing()[2], 0.5) << file;
    EXPECT_NE(*reader->GetFormat(), '\0') << file;
    ExpectValues(image, file);

    const bool isVector = file.find('3') != std::string::npos;
    EXPECT_EQ(reader->GetNumberOfFileComponents(), isVector ? 3 : 1) << file;
    ASSERT_EQ(reader->GetNumberOfNotes(), isVector ? 1 : 0) << file;
    if (isVector)
    {
      EXPECT_STREQ(reader->GetNote(0), "its voxels have 3 components; the first is used");
    }
    EXPECT_EQ(reader->GetNote(-1), nullptr);
    EXPECT_EQ(reader->GetNote(reader->GetNumberOfNotes()), nullptr);
  }
}

TEST(VolumeReader, RangeIsKeptIfAskedFor)
{
  const std::string file = Write<vtkNIFTIImageWriter>("VolumeReaderRange.nii", Volume(), [](auto*) {});
  const auto isKept = [](vtkImageData* image)
  {
    vtkDataArray* values = image->GetPointData()->GetScalars();
    return values->HasInformation() && values->GetInformation()->Has(vtkDataArray::PER_COMPONENT());
  };
  const auto reader = UpdatedReaderOf(file);
  EXPECT_FALSE(isKept(reader->GetOutput()));
  reader->FindRangeOn();
  reader->Update();
  EXPECT_TRUE(isKept(reader->GetOutput()));
  vtkNew<vtkInkNIFTIImageReader> same;
  same->SetFileName(file.c_str());
  same->Update();
  EXPECT_TRUE(isKept(same->GetOutput()));
  vtkNew<vtkNIFTIImageReader> theirs;
  theirs->SetFileName(file.c_str());
  theirs->Update();
  for (vtkImageData* image : { reader->GetOutput(), same->GetOutput() })
  {
    EXPECT_EQ(image->GetScalarRange()[0], theirs->GetOutput()->GetScalarRange()[0]);
    EXPECT_EQ(image->GetScalarRange()[1], theirs->GetOutput()->GetScalarRange()[1]);
  }
}

TEST(VolumeReader, PartsAreThoseOfTheWhole)
{
  std::vector<std::string> files = All("VolumeReaderParts");
  files.push_back(Put("VolumeReaderParts.raw", Bytes(false)));
  files.push_back(Gzip("VolumeReaderParts.gz.raw", Bytes(false)));
  for (const std::string& file : files)
  {
    const auto reader = file.ends_with(".raw") ? RawReaderOf(file) : ReaderOf(file);
    // Slices, rows, columns, one voxel, and back again, which compressed files have to begin anew for.
    for (const std::vector<int>& part : { std::vector<int>{ 0, 6, 0, 4, 2, 3 }, { 0, 6, 1, 3, 0, 5 },
           { 2, 4, 0, 4, 1, 5 }, { 6, 6, 4, 4, 5, 5 }, { 0, 0, 0, 0, 0, 0 } })
    {
      reader->vtkAlgorithm::UpdateExtent(part.data());
      const int* extent = reader->GetOutput()->GetExtent();
      EXPECT_EQ(std::vector<int>(extent, extent + 6), part) << file;
      ExpectValues(reader->GetOutput(), file);
    }
  }
}

TEST(VolumeReader, RawFilesHaveTheLayoutThatIsSet)
{
  for (const bool bigEndian : { false, true })
  {
    const auto reader = RawReaderOf(Put("VolumeReaderLayout.raw", Bytes(bigEndian)));
    reader->SetRawBigEndian(bigEndian);
    reader->SetSpacing(0.25, 0.5, 3.0);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetSpacing()[2], 3.0);
    EXPECT_STREQ(reader->GetFormat(), "raw volume");
    ExpectValues(reader->GetOutput(), bigEndian ? "big-endian" : "little-endian");
    // No image can have these.
    reader->SetSpacing(-0.25, 0.0, 3.0);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetSpacing()[0], 0.25);
    EXPECT_EQ(reader->GetOutput()->GetSpacing()[1], 1.0);
  }
}

TEST(VolumeReader, CompressedRawFilesAreReadWhole)
{
  const std::string file = Gzip("VolumeReaderCompressed.raw.gz", Bytes(true));
  const auto reader = RawReaderOf(file);
  reader->RawBigEndianOn();
  reader->Update();
  EXPECT_STREQ(reader->GetFormat(), "compressed raw volume");
  EXPECT_FALSE(reader->HasPlainVoxels());
  ExpectValues(reader->GetOutput(), file);
}

TEST(VolumeReader, RescaledValuesHaveTheTypeThatWasAnnounced)
{
  struct Case
  {
    double slope;
    double intercept;
    int type;
  };
  // Of 16 bits: where all have room, whole numbers stay whole.
  for (const Case& one : { Case{ 1.0, -1000.0, VTK_INT }, Case{ 0.5, 3.0, VTK_FLOAT } })
  {
    const std::string file = Write<vtkNIFTIImageWriter>("VolumeReaderScaled.nii", Volume(),
      [&one](vtkNIFTIImageWriter* writer)
      {
        writer->SetRescaleSlope(one.slope);
        writer->SetRescaleIntercept(one.intercept);
      });
    const auto reader = ReaderOf(file);
    reader->UpdateInformation();
    vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(reader->GetOutputInformation(0),
      vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
    EXPECT_EQ(scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE()), one.type);
    EXPECT_FALSE(reader->HasPlainVoxels());
    ASSERT_EQ(reader->GetNumberOfNotes(), 1);
    EXPECT_NE(std::string(reader->GetNote(0)).find("rescaled"), std::string::npos);
    const int part[6] = { 1, 3, 2, 4, 0, 5 };
    reader->vtkAlgorithm::UpdateExtent(part);
    EXPECT_EQ(reader->GetOutput()->GetScalarType(), one.type);
    EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(3, 2, 4, 0),
      one.slope * ValueAt(3, 2, 4) + one.intercept);
  }
}

TEST(VolumeReader, SaysWhereStoredVoxelsLie)
{
  const std::vector<std::string> files = All("VolumeReaderStored");
  for (const std::string& file : files)
  {
    const auto reader = ReaderOf(file);
    EXPECT_FALSE(reader->HasPlainVoxels()) << "before anything is known";
    EXPECT_EQ(reader->GetMemorySize(), 0);
    reader->UpdateInformation();
    const bool isStored =
      file == files[0] || file == files[2] || file == files[3] || file == files[7] || file.ends_with(".nrrd");
    EXPECT_EQ(reader->HasPlainVoxels(), isStored) << file;
    // Of VTI, VTK's reader reads all components.
    const int read = file.ends_with("3.vti") ? 3 : 1;
    EXPECT_EQ(reader->GetMemorySize(), read * 2 * Size[0] * Size[1] * Size[2]) << file;
  }
}

TEST(VolumeReader, CanBeAborted)
{
  for (const std::string& file : All("VolumeReaderAborted"))
  {
    const auto reader = ReaderOf(file);
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
      { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
    const unsigned long observer = reader->AddObserver(vtkCommand::ProgressEvent, abort);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
    reader->RemoveObserver(observer);
    reader->SetAbortExecute(0);
    reader->Modified();
    reader->Update();
    ExpectValues(reader->GetOutput(), file + " after that");
  }
}
