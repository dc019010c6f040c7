// SPDX-License-Identifier: BSD-3-Clause
// Every format, the errors, and that reading can be stopped.

#include "MeshTestReading.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkInkMeshReader.h"
#include "vtkNew.h"
#include "vtkPLYWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLWriter.h"
#include "vtkSphereSource.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

using MeshTestReading::ExpectError;

namespace
{

constexpr double radius = 3.0;

std::string Put(const std::string& name, const std::string& text)
{
  std::ofstream(name, std::ios::binary) << text;
  return name;
}

template <class Writer>
std::string WriteSphere(const std::string& name)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  vtkNew<Writer> writer;
  writer->SetInputConnection(sphere->GetOutputPort());
  writer->SetFileName(name.c_str());
  writer->Write();
  return name;
}

/// The same sphere as text: OBJ counts from 1.
std::string WriteObj(const std::string& name)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->Update();
  std::ofstream out(name);
  vtkPolyData* mesh = sphere->GetOutput();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    out << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(i, ids);
    out << "f " << ids->GetId(0) + 1 << " " << ids->GetId(1) + 1 << " " << ids->GetId(2) + 1 << "\n";
  }
  return name;
}

std::vector<std::string> AllMeshes(const std::string& name)
{
  return { WriteSphere<vtkPLYWriter>(name + ".ply"), WriteSphere<vtkSTLWriter>(name + ".stl"),
    WriteSphere<vtkXMLPolyDataWriter>(name + ".vtp"), WriteSphere<vtkPolyDataWriter>(name + ".vtk"),
    WriteObj(name + ".OBJ") };
}

} // namespace

TEST(MeshReader, ReadsEveryFormat)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  for (const std::string& file : AllMeshes("MeshReaderWhole"))
  {
    vtkNew<vtkInkMeshReader> reader;
    EXPECT_EQ(reader->CanReadFile(file.c_str()), 1) << file;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkPolyData* mesh = reader->GetOutput();
    EXPECT_EQ(mesh->GetNumberOfPoints(), sphere->GetOutput()->GetNumberOfPoints()) << file;
    EXPECT_EQ(mesh->GetNumberOfPolys(), sphere->GetOutput()->GetNumberOfPolys()) << file;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const double* p = mesh->GetPoint(i);
      EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), radius, 1e-5) << file;
    }
    EXPECT_NE(*reader->GetFormat(), '\0') << file;
    EXPECT_EQ(reader->GetNumberOfNotes(), 0) << file;
  }
}

TEST(MeshReader, CoordinatesKeepTheirDigits)
{
  constexpr double far = 4500000.125;
  for (const std::string& file :
    { Put("MeshReaderFar.xyz", "4500000.125 1 2 0 0 1\n# a comment\n1,2,3,0,1,0\n"),
      Put("MeshReaderFar.obj", "v 4500000.125 1 2\nv 0 1 0\nv 1 0 0\nf 1 2 3\n"),
      Put("MeshReaderFar.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
        "property double z\nproperty float heat\nend_header\n4500000.125 1 2 0.5\n") })
  {
    vtkNew<vtkInkMeshReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetPoint(0)[0], far) << file;
    vtkPointData* arrays = reader->GetOutput()->GetPointData();
    EXPECT_EQ(arrays->GetNormals() != nullptr, file.ends_with(".xyz")) << file;
    EXPECT_EQ(arrays->HasArray("heat") != 0, file.ends_with(".ply")) << file;
  }
}

TEST(MeshReader, StripsOfPlyFilesAreTriangles)
{
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                             "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                             "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
  vtkNew<vtkInkMeshReader> reader;
  // A strip of three triangles, all seen from the front; one that turns, with a point twice; and a new strip.
  reader->SetFileName(Put("MeshReaderStrips.ply", header + "15 0 1 2 3 4 -1 0 1 2 2 3 -1 4 2 3\n").c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  const std::vector<std::vector<vtkIdType>> expected = { { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 }, { 0, 1, 2 },
    { 4, 2, 3 } };
  ASSERT_EQ(mesh->GetNumberOfPolys(), static_cast<vtkIdType>(expected.size()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(i, ids);
    EXPECT_EQ(std::vector<vtkIdType>(ids->begin(), ids->end()), expected[static_cast<std::size_t>(i)]) << i;
  }
  ExpectError({ "a face has point 5, but there are 5 points" },
    Put("MeshReaderStripsBeyond.ply", header + "3 0 1 5\n"));
}

TEST(MeshReader, NotesWhatIsNotUsed)
{
  vtkNew<vtkInkMeshReader> reader;
  reader->SetFileName(Put("MeshReaderColumns.xyz", "1 2 3 200\n4 5 6 100\n").c_str());
  reader->Update();
  ASSERT_EQ(reader->GetNumberOfNotes(), 1);
  EXPECT_NE(
    std::string(reader->GetNote(0)).find("of the 4 columns only x, y and z are used"), std::string::npos);
  EXPECT_EQ(reader->GetNote(1), nullptr);
  EXPECT_EQ(reader->GetNote(-1), nullptr);
  reader->SetFileName(WriteSphere<vtkPLYWriter>("MeshReaderNothingToNote.ply").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetNumberOfNotes(), 0);
}

TEST(MeshReader, WhatCannotBeReadIsOneError)
{
  ExpectError({ "FileName is empty" }, "");
  ExpectError({ "'none.ply'", "no such file" }, "none.ply");
  ExpectError({ "the file is empty" }, Put("MeshReaderEmpty.obj", ""));
  ExpectError({ "unknown type '.txt'; expected one of .ply .obj .off .stl .vtp .vtu .vtk .xyz .pcd .gii" },
    Put("MeshReader.txt", "words"));
  ExpectError({ "it holds no points" }, Put("MeshReaderNothing.xyz", "# nothing\n"));
  ExpectError({ "line 2 is '1 2'; expected 3 numbers" }, Put("MeshReaderLine.xyz", "1 2 3\n1 2\n"));
  for (const char* suffix : { ".ply", ".obj", ".stl", ".vtp", ".vtu", ".vtk", ".xyz", ".pcd", ".gii" })
  {
    ExpectError({ "cannot read", "MeshReaderWords" },
      Put(std::string("MeshReaderWords") + suffix, "v ery few words\n"));
  }
  for (const std::string& file : AllMeshes("MeshReaderShort"))
  {
    if (!file.ends_with(".OBJ")) // which has no end that could be missing
    {
      std::ifstream in(file, std::ios::binary);
      const std::string bytes{ std::istreambuf_iterator<char>(in), {} };
      // Legacy files end with what describes arrays.
      const std::size_t cut = file.ends_with(".vtk") ? bytes.size() / 2 : 60;
      ExpectError({ "cannot read" }, Put("Cut" + file, bytes.substr(0, bytes.size() - cut)));
    }
  }
  vtkNew<vtkInkMeshReader> reader;
  for (const char* file : { "none.ply", "MeshReaderEmpty.obj", "MeshReader.txt", "." })
  {
    EXPECT_EQ(reader->CanReadFile(file), 0) << file;
  }
  EXPECT_EQ(reader->CanReadFile(nullptr), 0);
}

TEST(MeshReader, LegacyFilesOfImagesAndOfTooManyPointsAreRefused)
{
  const std::string image = Put("MeshReaderImage.vtk",
    "# vtk DataFile Version 3.0\nPOLYDATA\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n");
  ExpectError({ "'MeshReaderImage.vtk'", "expected DATASET POLYDATA" }, image);
  vtkNew<vtkInkMeshReader> reader;
  EXPECT_EQ(reader->CanReadFile(image.c_str()), 0);
  const std::string start = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\n";
  ExpectError({ "it says '1e+11' where a number of points was expected" },
    Put("MeshReaderMany.vtk", start + "POINTS 100000000000 float\n1 2 3\n"));
  ExpectError({ "the file ends within an array" },
    Put("MeshReaderMany.vtk", start + "POINTS 1000000000 float\n1 2 3\n"));
  ExpectError({ "cannot read" },
    Put("MeshReaderPolygons.vtk",
      start + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1000000000000000 4000000000000000\n3 0 1 2\n"));
  for (const char* count : { "4", "-3", "2", "1000000000" })
  {
    ExpectError({ "cannot read" },
      Put("MeshReaderCount.vtk",
        start + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n" + count + " 0 1 2\n"));
  }
  ExpectError({ "cannot read" },
    Put("MeshReaderPoint.vtk", start + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 7\n"));
}

TEST(MeshReader, CellsOfPointsThatAreNotThereAreRefused)
{
  const std::string file = WriteSphere<vtkXMLPolyDataWriter>("MeshReaderCells.vtp");
  vtkNew<vtkPolyData> broken;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  broken->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 0, 5 });
  broken->SetPolys(cells);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(broken);
  writer->SetFileName(file.c_str());
  writer->Write();
  ExpectError({ "a cell has point 5, but there are 1 points" }, file);
}

TEST(MeshReader, CanBeAborted)
{
  for (const std::string& file : AllMeshes("MeshReaderAborted"))
  {
    vtkNew<vtkInkMeshReader> reader;
    reader->SetFileName(file.c_str());
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
      { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
    reader->AddObserver(vtkCommand::ProgressEvent, abort);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
  }
}

TEST(MeshReader, LegacyFilesThatAreNotSound)
{
  const std::string start = "# vtk DataFile Version 5.1\ntest\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                            "0 0 0 1 0 0 0 1 0\n";
  const auto cells = [](const std::string& ends)
  { return "POLYGONS 3 4\nOFFSETS vtktypeint64\n" + ends + "\nCONNECTIVITY vtktypeint64\n0 1 2 0\n"; };
  ExpectError({ "a cell ends at number 3" }, Put("MeshReaderFalling.vtk", start + cells("0 4 3")));
  ExpectError({ "a cell ends at number 5" }, Put("MeshReaderBeyond.vtk", start + cells("0 3 5")));
  vtkNew<vtkInkMeshReader> reader;
  reader->SetFileName(Put("MeshReaderFewValues.vtk",
    start + cells("0 3 4") + "POINT_DATA 3\nFIELD FieldData 2\na 1 2 float\n1 2\nb 1 3 float\n1 2 3\n")
                        .c_str());
  reader->Update();
  ASSERT_EQ(reader->GetNumberOfNotes(), 1);
  EXPECT_STREQ(reader->GetNote(0), "its array a has 2 values for 3 points and is left out");
  EXPECT_FALSE(reader->GetOutput()->GetPointData()->HasArray("a"));
  EXPECT_TRUE(reader->GetOutput()->GetPointData()->HasArray("b"));
}
