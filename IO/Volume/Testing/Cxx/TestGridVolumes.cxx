// SPDX-License-Identifier: BSD-3-Clause
// Files of rectilinear and structured grids, which become images.

#include "ReadError.h"
#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkRectilinearGridWriter.h"
#include "vtkStructuredGrid.h"
#include "vtkStructuredGridWriter.h"
#include "vtkXMLRectilinearGridWriter.h"
#include "vtkXMLStructuredGridWriter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

double Linear(double x, double y, double z)
{
  return 1.0 + 2.0 * x - y + 0.5 * z;
}

constexpr std::array<double, 5> xs{ 0.0, 0.5, 1.5, 2.0, 4.0 };

/// Uneven along x, 5 x 4 x 3 points.
vtkSmartPointer<vtkRectilinearGrid> Rectilinear(bool ofCells)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(5, 4, 3);
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkFloatArray> y;
  vtkNew<vtkFloatArray> z;
  for (int i = 0; i < 5; ++i)
  {
    x->InsertNextValue(xs[static_cast<std::size_t>(i)]);
    y->InsertNextValue(static_cast<float>(i));
    z->InsertNextValue(static_cast<float>(3 + 2 * i));
  }
  y->SetNumberOfTuples(4);
  z->SetNumberOfTuples(3);
  grid->SetXCoordinates(x);
  grid->SetYCoordinates(y);
  grid->SetZCoordinates(z);
  vtkNew<vtkFloatArray> values;
  values->SetName("density");
  const vtkIdType count = ofCells ? grid->GetNumberOfCells() : grid->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    double bounds[6];
    grid->GetPoint(i, p);
    if (ofCells)
    {
      grid->GetCellBounds(i, bounds);
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
      }
    }
    values->InsertNextValue(static_cast<float>(Linear(p[0], p[1], p[2])));
  }
  if (ofCells)
  {
    grid->GetCellData()->SetScalars(values);
  }
  else
  {
    grid->GetPointData()->SetScalars(values);
  }
  return grid;
}

/// Oblique.
vtkSmartPointer<vtkStructuredGrid> Structured()
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(5, 4, 3);
  vtkNew<vtkPoints> points;
  vtkNew<vtkShortArray> values;
  values->SetName("density");
  for (int i = 0; i < 60; ++i)
  {
    const int x = i % 5;
    const int y = i / 5 % 4;
    const int z = i / 20;
    points->InsertNextPoint(x + 0.5 * y, y, 2.0 * z);
    values->InsertNextValue(static_cast<short>(2 * Linear(x + 0.5 * y, y, 2.0 * z)));
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(values);
  return grid;
}

void ExpectLinear(vtkInkVolumeReader* reader, double scale, const std::string& file)
{
  vtkImageData* image = reader->GetOutput();
  ASSERT_GT(image->GetNumberOfPoints(), 0) << file;
  int found = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double value = image->GetPointData()->GetScalars()->GetComponent(i, 0);
    const double* p = image->GetPoint(i);
    const bool isInside = scale == 1.0 || (p[0] - 0.5 * p[1] >= 0.0 && p[0] - 0.5 * p[1] <= 4.0);
    if (isInside)
    {
      ++found;
      EXPECT_NEAR(value, scale * Linear(p[0], p[1], p[2]), 1e-4) << file;
    }
  }
  EXPECT_GT(found, 20) << file;
}

std::string NotesOf(vtkInkVolumeReader* reader)
{
  std::string notes;
  for (int i = 0; i < reader->GetNumberOfNotes(); ++i)
  {
    notes += std::string(reader->GetNote(i)) + "\n";
  }
  return notes;
}

const auto binary = [](auto* writer) { writer->SetFileTypeToBinary(); };
const auto text = [](auto* writer) { writer->SetFileTypeToASCII(); };
const auto nothing = [](auto*) {};

} // namespace

TEST(GridVolumes, RectilinearGridsAreResampled)
{
  for (const bool ofCells : { false, true })
  {
    const auto grid = Rectilinear(ofCells);
    const std::string name = ofCells ? "GridVolumesOfCells" : "GridVolumesRectilinear";
    for (const std::string& file : { Write<vtkXMLRectilinearGridWriter>(name + ".vtr", grid, nothing),
           Write<vtkRectilinearGridWriter>(name + ".vtk", grid, binary),
           Write<vtkRectilinearGridWriter>(name + "Text.vtk", grid, text) })
    {
      const auto reader = UpdatedReaderOf(file);
      EXPECT_NE(std::string(reader->GetFormat()).find("rectilinear grid"), std::string::npos) << file;
      EXPECT_EQ(reader->GetOutput()->GetDimensions()[1], ofCells ? 3 : 4) << file;
      EXPECT_EQ(reader->GetOutput()->GetDimensions()[2], ofCells ? 2 : 3) << file;
      ExpectLinear(reader, 1.0, file);
      EXPECT_EQ(reader->GetMemorySize(), reader->GetOutput()->GetNumberOfPoints() * 4) << file;
      EXPECT_FALSE(reader->HasPlainVoxels()) << file;
      const std::string notes = NotesOf(reader);
      EXPECT_NE(notes.find("its grid is resampled to "), std::string::npos) << file << notes;
      EXPECT_EQ(notes.find("its cells") != std::string::npos, ofCells) << file << notes;
    }
  }
}

TEST(GridVolumes, StructuredGridsAreResampled)
{
  const auto grid = Structured();
  for (const std::string& file :
    { Write<vtkXMLStructuredGridWriter>("GridVolumesStructured.vts", grid, nothing),
      Write<vtkStructuredGridWriter>("GridVolumesStructured.vtk", grid, binary),
      Write<vtkStructuredGridWriter>("GridVolumesStructuredText.vtk", grid, text) })
  {
    const auto reader = UpdatedReaderOf(file);
    EXPECT_NE(std::string(reader->GetFormat()).find("structured grid"), std::string::npos) << file;
    EXPECT_EQ(reader->GetOutput()->GetScalarType(), VTK_FLOAT) << file;
    ExpectLinear(reader, 2.0, file);
  }
}

TEST(GridVolumes, WhatIsHiddenHasNoValueInAnyFormat)
{
  for (const bool ofCells : { false, true })
  {
    const auto grid = Structured();
    if (ofCells)
    {
      grid->BlankCell(7);
    }
    else
    {
      grid->BlankPoint(22);
    }
    const std::string name = ofCells ? "GridVolumesHiddenCell" : "GridVolumesHiddenPoint";
    std::vector<vtkIdType> hidden;
    for (const std::string& file : { Write<vtkXMLStructuredGridWriter>(name + ".vts", grid, nothing),
           Write<vtkStructuredGridWriter>(name + ".vtk", grid, binary),
           Write<vtkStructuredGridWriter>(name + "Text.vtk", grid, text) })
    {
      const auto reader = UpdatedReaderOf(file);
      vtkDataArray* values = reader->GetOutput()->GetPointData()->GetScalars();
      ASSERT_TRUE(values) << file;
      hidden.push_back(0);
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
      {
        hidden.back() += std::isnan(values->GetComponent(i, 0)) ? 1 : 0;
      }
    }
    const auto whole =
      UpdatedReaderOf(Write<vtkXMLStructuredGridWriter>(name + "Whole.vts", Structured(), nothing));
    vtkDataArray* all = whole->GetOutput()->GetPointData()->GetScalars();
    vtkIdType outside = 0;
    for (vtkIdType i = 0; i < all->GetNumberOfTuples(); ++i)
    {
      outside += std::isnan(all->GetComponent(i, 0)) ? 1 : 0;
    }
    EXPECT_GT(hidden[0], outside) << name;
    EXPECT_EQ(hidden[1], hidden[0]) << name;
    EXPECT_EQ(hidden[2], hidden[0]) << name;
  }
}

TEST(GridVolumes, EvenPointsAreThoseOfAnImage)
{
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(Size[0], Size[1], Size[2]);
  const auto coordinates = [](int count, double step)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    for (int i = 0; i < count; ++i)
    {
      array->InsertNextValue(i * step);
    }
    return array;
  };
  grid->SetXCoordinates(coordinates(Size[0], 1.0));
  grid->SetYCoordinates(coordinates(Size[1], 2.0));
  grid->SetZCoordinates(coordinates(Size[2], 0.5));
  grid->GetPointData()->AddArray(Volume(3)->GetPointData()->GetScalars());
  for (const std::string& file : { Write<vtkXMLRectilinearGridWriter>("GridVolumesEven.vtr", grid, nothing),
         Write<vtkRectilinearGridWriter>("GridVolumesEven.vtk", grid, binary) })
  {
    const auto reader = UpdatedReaderOf(file);
    EXPECT_EQ(reader->GetOutput()->GetScalarType(), VTK_SHORT) << file;
    ExpectValues(reader->GetOutput(), file);
    EXPECT_EQ(reader->GetOutput()->GetSpacing()[2], 0.5) << file;
    EXPECT_EQ(NotesOf(reader), "array 'density' is used\nits voxels have 3 components; the first is used\n")
      << file;
    for (const std::array<int, 6>& part : { std::array{ 0, 6, 0, 4, 2, 3 }, std::array{ 1, 3, 2, 2, 5, 5 } })
    {
      const auto partReader = ReaderOf(file);
      partReader->UpdateExtent(part.data());
      EXPECT_EQ(partReader->GetOutput()->GetNumberOfPoints(),
        (part[1] - part[0] + 1) * (part[3] - part[2] + 1) * (part[5] - part[4] + 1))
        << file;
      ExpectValues(partReader->GetOutput(), file);
    }
  }
}

TEST(GridVolumes, WhatIsBrokenIsRefused)
{
  const std::string start = "# vtk DataFile Version 3.0\ntest\nASCII\n";
  const auto rectilinear = [&](const std::string& name, const std::string& x, const std::string& rest)
  {
    return Put("GridVolumes" + name + ".vtk",
      start + "DATASET RECTILINEAR_GRID\nDIMENSIONS 3 2 2\nX_COORDINATES " + x + rest);
  };
  const std::string yz = "Y_COORDINATES 2 float\n0 1\nZ_COORDINATES 2 float\n0 1\n";
  const std::string values =
    "POINT_DATA 12\nSCALARS a float\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7 8 9 10 11\n";
  EXPECT_EQ(
    UpdatedReaderOf(rectilinear("Good", "3 float\n0 1 2\n", yz + values))->GetOutput()->GetNumberOfPoints(),
    12);
  ExpectRefused(rectilinear("Many", "4 float\n0 1 2 3\n", yz + values), { "4 x_coordinates", "expected 3" });
  ExpectRefused(rectilinear("Type", "3 string\n0 1 2\n", yz + values), { "3 x_coordinates", "string" });
  ExpectRefused(rectilinear("Falls", "3 float\n0 2 1\n", yz + values), { "along x go from 2 to 1", "rise" });
  ExpectRefused(rectilinear("None", "3 float\n0 1 2\n", values), { "where its points are", "Z_COORDINATES" });
  ExpectRefused(
    rectilinear("Ends", "3 float\n0 1 2\n", yz + values.substr(0, values.size() - 12)), { "the file ends" });
  ExpectRefused(
    rectilinear("Points", "3 float\n0 1 2\n", "POINTS 12 float\n" + values), { "points", "keyword" });
  ExpectRefused(
    Put("GridVolumesStructured0.vtk", start + "DATASET STRUCTURED_GRID\nDIMENSIONS 3 2 2\n" + values),
    { "where its points are", "POINTS" });
  ExpectRefused(Put("GridVolumesUnstructured.vtk", start + "DATASET UNSTRUCTURED_GRID\nPOINTS 0 float\n"),
    { "unstructured_grid", "STRUCTURED_GRID" });
  const auto flat = Structured();
  flat->SetDimensions(5, 12, 1);
  ExpectRefused(Write<vtkXMLStructuredGridWriter>("GridVolumesFlat.vts", flat, nothing),
    { "5 x 12 x 1 points", "expected 2 or more" });
  const auto bare = Rectilinear(true);
  bare->GetCellData()->Initialize();
  ExpectRefused(Write<vtkXMLRectilinearGridWriter>("GridVolumesBare.vtr", bare, nothing), { "no values" });
  const std::string whole = Write<vtkXMLStructuredGridWriter>("GridVolumesWhole.vts", Structured(), nothing);
  const std::string cut = "GridVolumesCut.vts";
  std::string xml = ink::io::contentsOf(whole);
  xml.replace(xml.find("WholeExtent=\"0 4"), 16, "WholeExtent=\"0 400000");
  xml.replace(xml.find("Piece Extent=\"0 4"), 17, "Piece Extent=\"0 400000");
  ExpectRefused(Put(cut, xml), { "promises" });
  EXPECT_EQ(ReaderOf(cut)->CanReadFile(cut.c_str()), 0);
  EXPECT_EQ(ReaderOf(whole)->CanReadFile(whole.c_str()), 1);
}
