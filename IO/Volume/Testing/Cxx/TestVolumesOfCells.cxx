// SPDX-License-Identifier: BSD-3-Clause
// Files of images that have values in their cells alone: each is a voxel in the cell's center.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include "InkTestMessages.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkInkVolumeReader.h"

#include <gtest/gtest.h>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

/// The values of Volume() in the cells around its points.
template <class Image = vtkImageData>
vtkSmartPointer<Image> VolumeOfCells(bool active = true)
{
  const auto points = Volume();
  auto image = vtkSmartPointer<Image>::New();
  image->SetDimensions(Size[0] + 1, Size[1] + 1, Size[2] + 1);
  image->SetSpacing(points->GetSpacing());
  image->SetOrigin(-0.5, -1.0, -0.25);
  vtkDataArray* values = points->GetPointData()->GetScalars();
  active ? image->GetCellData()->SetScalars(values) : image->GetCellData()->AddArray(values);
  return image;
}

std::vector<std::string> AllOfCells(const std::string& name)
{
  const auto uncompressed = [](auto* writer)
  {
    writer->SetCompressorTypeToNone();
    writer->SetDataModeToAppended();
  };
  const auto nothing = [](auto*) {};
  return { Write<vtkXMLImageDataWriter>(name + ".vti", VolumeOfCells(), nothing),
    Write<vtkXMLImageDataWriter>(name + "Plain.vti", VolumeOfCells(), uncompressed),
    Write<vtkXMLImageDataWriter>(name + "Array.vti", VolumeOfCells(false), nothing),
    Write<vtkStructuredPointsWriter>(name + ".vtk", VolumeOfCells<vtkStructuredPoints>(),
      [](auto* writer) { writer->SetFileTypeToBinary(); }),
    Write<vtkStructuredPointsWriter>(name + "Text.vtk", VolumeOfCells<vtkStructuredPoints>(),
      [](auto* writer) { writer->SetFileTypeToASCII(); }),
    Write<vtkStructuredPointsWriter>(name + "Array.vtk", VolumeOfCells<vtkStructuredPoints>(false),
      [](auto* writer) { writer->SetFileTypeToBinary(); }) };
}

void ExpectVoxels(vtkImageData* image, const std::string& name)
{
  const int* e = image->GetExtent();
  ASSERT_TRUE(image->GetPointData()->GetScalars()) << name;
  ASSERT_EQ(image->GetPointData()->GetScalars()->GetNumberOfTuples(), image->GetNumberOfPoints()) << name;
  for (int z = e[4]; z <= e[5]; ++z)
  {
    for (int y = e[2]; y <= e[3]; ++y)
    {
      for (int x = e[0]; x <= e[1]; ++x)
      {
        EXPECT_EQ(image->GetScalarComponentAsDouble(x, y, z, 0), ValueAt(x, y, z)) << name;
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(image->GetOrigin()[axis], 0.0) << name << " axis " << axis;
  }
}

} // namespace

TEST(VolumesOfCells, AreVoxelsInTheCellsCenters)
{
  for (const std::string& file : AllOfCells("VolumesOfCellsWhole"))
  {
    const auto reader = ReaderOf(file);
    reader->UpdateInformation();
    EXPECT_EQ(reader->GetMemorySize() > 0, file.find("Array.vti") == std::string::npos) << file;
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(image->GetNumberOfPoints(), Size[0] * Size[1] * Size[2]) << file;
    EXPECT_EQ(image->GetScalarType(), VTK_SHORT) << file;
    ExpectVoxels(image, file);
    std::string notes;
    for (int i = 0; i < reader->GetNumberOfNotes(); ++i)
    {
      notes += reader->GetNote(i);
    }
    EXPECT_NE(notes.find("its values are those of its cells"), std::string::npos) << file << ": " << notes;
  }
}

TEST(VolumesOfCells, PartsAreThoseOfTheWhole)
{
  for (const std::string& file : AllOfCells("VolumesOfCellsParts"))
  {
    const auto reader = ReaderOf(file);
    for (const std::array<int, 6>& part :
      { std::array{ 0, 6, 0, 4, 2, 3 }, std::array{ 1, 3, 2, 2, 5, 5 }, std::array{ 6, 6, 4, 4, 0, 5 } })
    {
      reader->UpdateExtent(part.data());
      ASSERT_GT(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
      ExpectVoxels(reader->GetOutput(), file);
    }
  }
}

TEST(VolumesOfCells, ValuesOfPointsComeFirst)
{
  const auto both = VolumeOfCells<vtkStructuredPoints>();
  vtkNew<vtkShortArray> ones;
  ones->SetName("ones");
  ones->SetNumberOfValues(both->GetNumberOfPoints());
  ones->FillValue(1);
  both->GetPointData()->SetScalars(ones);
  const auto nothing = [](auto*) {};
  for (const std::string& file : { Write<vtkXMLImageDataWriter>("VolumesOfCellsBoth.vti", both, nothing),
         Write<vtkStructuredPointsWriter>("VolumesOfCellsBoth.vtk", both, nothing) })
  {
    const auto reader = ReaderOf(file);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), both->GetNumberOfPoints()) << file;
    EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(1, 2, 3, 0), 1.0) << file;
    EXPECT_EQ(reader->GetNumberOfNotes(), 0) << file;
  }
}

TEST(VolumesOfCells, FilesWithoutValuesAndWithTooFewAreRefused)
{
  const auto none = VolumeOfCells<vtkStructuredPoints>();
  none->GetCellData()->Initialize();
  const std::string head =
    "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 3 3\n"
    "SPACING 1 1 1\nORIGIN 0 0 0\n";
  const std::pair<std::string, std::vector<std::string>> cases[] = {
    { Write<vtkXMLImageDataWriter>("VolumesOfCellsNone.vti", none, [](auto*) {}),
      { "it holds no values, neither at its points nor in its cells" } },
    { Put("VolumesOfCellsNone.vtk", head), { "it holds no values, neither at its points nor in its cells" } },
    { Put("VolumesOfCellsFew.vtk", head + "CELL_DATA 3\nSCALARS a short\nLOOKUP_TABLE default\n1 2 3\n"),
      { "it says '3' where the number of all cells, 8, was expected" } },
    { Put("VolumesOfCellsCut.vtk", head + "CELL_DATA 8\nSCALARS a short\nLOOKUP_TABLE default\n1 2 3\n"),
      { "a value" } },
    { Put("VolumesOfCellsBits.vtk",
        head + "CELL_DATA 8\nSCALARS a bit\nLOOKUP_TABLE default\n1 0 1 0 1 0 1 0\n"),
      { "its voxels are single bits" } }
  };
  for (const auto& [file, words] : cases)
  {
    const auto reader = ReaderOf(file);
    vtkNew<InkTestMessages> messages;
    messages->Observe(reader);
    messages->Observe(reader->GetExecutive());
    reader->Update();
    messages->Expect(file, words);
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
    EXPECT_NE(reader->GetErrorCode(), vtkErrorCode::NoError) << file;
  }
}
