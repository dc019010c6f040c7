// SPDX-License-Identifier: BSD-3-Clause
// Unstructured grids in legacy VTK files of both layouts, and what is refused.

#include "MeshTestReading.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkInkMeshReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

using MeshTestReading::ExpectError;

namespace
{

/// A tetrahedron and a triangle as text, in parts that a test may replace.
struct LegacyText
{
  std::string version = "3.0";
  std::string points = "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n";
  std::string cells = "CELLS 2 9\n4 0 1 2 3 3 0 1 2\n";
  std::string types = "CELL_TYPES 2\n10 5\n";
  std::string values = "POINT_DATA 4\nSCALARS a float 1\nLOOKUP_TABLE default\n1 2 3 4\n"
                       "CELL_DATA 2\nFIELD FieldData 1\nb 1 2 int\n7 8\n";

  std::string Put(const std::string& name) const
  {
    const std::string file = "LegacyGrid" + name + ".vtk";
    std::ofstream(file) << "# vtk DataFile Version " << this->version
                        << "\ntest\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                        << this->points << this->cells << this->types << this->values;
    return file;
  }
};

constexpr const char* NewCells =
  "CELLS 3 7\nOFFSETS vtktypeint64\n0 4 7\nCONNECTIVITY vtktypeint64\n0 1 2 3 0 1 2\n";

void ExpectTetrahedronAndTriangle(const std::string& file)
{
  SCOPED_TRACE(file);
  vtkNew<vtkInkMeshReader> reader;
  EXPECT_EQ(reader->CanReadFile(file.c_str()), 1);
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError);
  vtkPolyData* mesh = reader->GetOutput();
  EXPECT_EQ(mesh->GetNumberOfPoints(), 4);
  ASSERT_EQ(mesh->GetNumberOfPolys(), 5);
  ASSERT_EQ(reader->GetNumberOfNotes(), 1);
  EXPECT_STREQ(reader->GetNote(0), "the outer surface of its 1 solid cell is drawn");
  vtkDataArray* ofPoints = mesh->GetPointData()->GetArray("a");
  vtkDataArray* ofCells = mesh->GetCellData()->GetArray("b");
  ASSERT_TRUE(ofPoints && ofCells);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const double* p = mesh->GetPoint(i);
    EXPECT_EQ(ofPoints->GetComponent(i, 0), 1.0 + p[0] + 2.0 * p[1] + 3.0 * p[2]);
  }
  int triangles = 0;
  for (vtkIdType i = 0; i < 5; ++i)
  {
    triangles += ofCells->GetComponent(i, 0) == 8.0 ? 1 : 0;
  }
  EXPECT_EQ(triangles, 1);
  EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays() + mesh->GetCellData()->GetNumberOfArrays(), 2);
}

} // namespace

TEST(LegacyGrids, BothLayoutsAreRead)
{
  LegacyText text;
  ExpectTetrahedronAndTriangle(text.Put("Old"));
  text.points = "FIELD FieldData 1\nTIME 1 1 double\n2.5\n" + text.points;
  ExpectTetrahedronAndTriangle(text.Put("Time"));
  text.version = "5.1";
  text.cells = NewCells;
  ExpectTetrahedronAndTriangle(text.Put("New"));
  text.values = "CELL_DATA 2\nSCALARS b int 1\nLOOKUP_TABLE default\n7 8\nPOINT_DATA 4\nFIELD FieldData 1\n"
                "a 1 4 float\n1 2 3 4\n";
  ExpectTetrahedronAndTriangle(text.Put("CellsFirst"));
}

TEST(LegacyGrids, AreReadAsVtkWritesThem)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  for (int corner = 0; corner < 8; ++corner)
  {
    points->InsertNextPoint(corner % 2, corner / 2 % 2, corner / 4);
  }
  grid->SetPoints(points);
  const vtkIdType ids[] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  grid->InsertNextCell(VTK_VOXEL, 8, ids);
  // Texts, components of which some have names, and what comes after them.
  vtkNew<vtkStringArray> texts;
  texts->SetName("texts");
  vtkNew<vtkDoubleArray> parts;
  parts->SetName("parts");
  parts->SetNumberOfComponents(3);
  parts->SetComponentName(0, "first");
  parts->SetComponentName(2, "last");
  vtkNew<vtkDoubleArray> after;
  after->SetName("after");
  for (int i = 0; i < 8; ++i)
  {
    texts->InsertNextValue(std::string(static_cast<std::size_t>(40 * i), 'a'));
    parts->InsertNextTuple3(i, i, i);
    after->InsertNextValue(i);
  }
  grid->GetPointData()->AddArray(texts);
  grid->GetPointData()->AddArray(parts);
  grid->GetPointData()->AddArray(after);
  for (const int kind : { 42, 51, -42, -51 })
  {
    const int version = std::abs(kind);
    vtkNew<vtkUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->SetFileType(kind > 0 ? VTK_BINARY : VTK_ASCII);
    writer->SetFileVersion(version);
    writer->SetFileName("LegacyGridBinary.vtk");
    writer->Write();
    vtkNew<vtkInkMeshReader> reader;
    reader->SetFileName("LegacyGridBinary.vtk");
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 6) << version;
    ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), 8) << version;
    vtkDataArray* read = reader->GetOutput()->GetPointData()->GetArray("after");
    ASSERT_TRUE(read) << kind;
    EXPECT_EQ(read->GetComponent(7, 0), 7.0) << kind;
  }
}

TEST(LegacyGrids, WhatIsNotSoundIsRefused)
{
  using Part = std::string LegacyText::*;
  struct Fault
  {
    Part part;
    const char* text;
    const char* expected;
  };
  const char* tooMany = "it says '3e+09' where a number of";
  int number = 0;
  for (const Fault& fault :
    std::vector<Fault>{ { &LegacyText::points, "POINTS 3000000000 float\n0 0 0\n", tooMany },
      { &LegacyText::points, "POINTS -4 float\n0 0 0\n", "it says '-4' where a number of points" },
      { &LegacyText::points, "POINTS 1000000000 float\n0 0 0\n", "the file ends within an array" },
      { &LegacyText::points, "", "Number of points don't match" },
      { &LegacyText::points, "POINTS 4 words\n", "words" },
      { &LegacyText::cells, "CELLS 2 3000000000\n4 0 1 2 3 3 0 1 2\n", tooMany },
      { &LegacyText::cells, "CELLS 2 9\n4 0 1 2 4 3 0 1 2\n", "a cell has point 4, but there are 4 points" },
      { &LegacyText::cells, "CELLS 2 9\n4 0 1 2 3 4 0 1 2\n", "more points than they have" },
      { &LegacyText::cells, "CELLS 2 9\n4 0 1 2 3 -1 0 1 2\n", "more points than they have" },
      { &LegacyText::cells, "CELLS 3 9\n4 0 1 2 3 3 0 1 2\n",
        "it says 'cell_types' where a number of cells" },
      { &LegacyText::cells, "CELLS 1 9\n4 0 1 2 3 3 0 1 2\n", "fewer points than they have" },
      { &LegacyText::cells, "CELLS 1 5\n4 0 1 2 3\n", "it has types of 2 cells, but points of 1" },
      { &LegacyText::cells, "", "it has types of 2 cells, but points of 0" },
      { &LegacyText::types, "CELL_TYPES 3000000000\n10 5\n", tooMany },
      { &LegacyText::types, "CELL_TYPES 2\n12 5\n", "cell 0 of VTK's type 12 has 4 points; expected 8" },
      { &LegacyText::types, "CELL_TYPES 2\n42 5\n", "it has polyhedra; expected them in a .vtu file" },
      { &LegacyText::types, "CELL_TYPES 2\n266 5\n", "VTK's type 266" },
      { &LegacyText::types, "", "it has types of 0 cells, but points of 2" },
      { &LegacyText::values, "POINT_DATA 5\n", "Number of points don't match" },
      { &LegacyText::values, "CELL_DATA 1\n", "Number of cells don't match" },
      { &LegacyText::values, "WORDS 1\n", "it says 'words' where a keyword as POINTS" },
      { &LegacyText::values, "POINT_DATA 4\nFIELD FieldData 1\na 1 4294967295 int\n1 2 3\n",
        "a number of values" },
      { &LegacyText::values, "POINT_DATA 4\nFIELD FieldData 24\na 1 4 int\n1 2 3 4\n",
        "the file ends where a name" },
      { &LegacyText::values, "POINT_DATA 4\nFIELD FieldData 1\na 1 4 float\n1 2 3\n", "the file ends" } })
  {
    LegacyText text;
    text.*fault.part = fault.text;
    ExpectError({ fault.expected }, text.Put("Fault" + std::to_string(++number)));
  }
  LegacyText without;
  without.points = without.values = "";
  ExpectError({ "a cell has point 3, but there are 0 points" }, without.Put("NoPoints"));
  for (const auto& [cells, expected] : std::vector<std::pair<const char*, const char*>>{
         { "CELLS 3000000000 7\n", tooMany }, { "CELLS 3 3000000000\n", tooMany },
         { "CELLS 3 7\nOFFSETS vtktypeint64\n0 7 4\nCONNECTIVITY vtktypeint64\n0 1 2 3 0 1 2\n",
           "a cell ends at number 4" },
         { "CELLS 3 7\nOFFSETS vtktypeint64\n0 4 8\nCONNECTIVITY vtktypeint64\n0 1 2 3 0 1 2\n",
           "a cell ends at number 8" },
         { "CELLS 3 7\nOFFSETS vtktypeint64\n0 4 7\nCONNECTED vtktypeint64\n0 1 2 3 0 1 2\n",
           "it says 'connected' where connectivity" },
         { "CELLS 3 7\nOFFSETS string\n0 4 7\nCONNECTIVITY vtktypeint64\n0 1 2 3 0 1 2\n",
           "it says 'string' where a type of numbers" },
         { "CELLS 1 0\nOFFSETS vtktypeint64\n0\nCONNECTIVITY vtktypeint64\nCELLS 1 0\n",
           "it has cells twice" } })
  {
    LegacyText text;
    text.version = "5.1";
    text.cells = cells;
    ExpectError({ expected }, text.Put("NewFault" + std::to_string(++number)));
  }
}

TEST(LegacyGrids, NumbersMayFollowOnTheirSectionsLine)
{
  LegacyText text;
  text.points = "FIELD f 1\nname 1 2 string\none\ntwo%20words\nPOINTS 4 float 0 0 0 1 0 0\n0 1 0 0 0 1\n";
  text.cells = "CELLS 2 9 4\n0 1 2 3 3 0 1 2\n";
  text.types = "CELL_TYPES 2 10\n5\n";
  text.values = "POINT_DATA 4 FIELD FieldData 1 a 1 4 float 1 2\n3 4 CELL_DATA 2\nFIELD f 1\n"
                "b 1 2 int 7 8";
  ExpectTetrahedronAndTriangle(text.Put("SameLine"));
}

TEST(LegacyGrids, CellsOfMeshesEndInOrder)
{
  const std::string file = "LegacyGridMesh.vtk";
  std::ofstream(file) << "# vtk DataFile Version 5.1\ntest\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                         "0 0 0 1 0 0 0 1 0\nPOLYGONS 3 4\nOFFSETS vtktypeint64\n0 4 3\n"
                         "CONNECTIVITY vtktypeint64\n0 1 2 0\n";
  ExpectError({ "a cell ends at number 3" }, file);
}
