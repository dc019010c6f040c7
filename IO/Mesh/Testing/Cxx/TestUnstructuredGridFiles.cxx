// SPDX-License-Identifier: BSD-3-Clause
// Unstructured grids: what of them becomes a mesh, with which values, and what is refused.

#include "MeshTestReading.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkInkMeshReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#ifdef __SANITIZE_ADDRESS__
#  include <sanitizer/lsan_interface.h>
#endif

#include <fstream>
#include <functional>
#include <string>
#include <vector>

using MeshTestReading::ExpectError;

namespace
{

/// Corners of three cubes in a row along x, numbered as VTK's voxels: 4 for each x.
void AddCorners(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int x = 0; x < 4; ++x)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      points->InsertNextPoint(x, corner % 2, corner / 2);
    }
  }
  grid->SetPoints(points);
}

/// Values along x: those of points are where these are, those of cells the numbers of the cells.
void AddValues(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> place;
  place->SetName("place");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    place->InsertNextValue(grid->GetPoint(i)[0]);
  }
  grid->GetPointData()->AddArray(place);
  vtkNew<vtkDoubleArray> number;
  number->SetName("number");
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    number->InsertNextValue(static_cast<double>(i));
  }
  grid->GetCellData()->AddArray(number);
}

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(
  const std::vector<std::pair<int, std::vector<vtkIdType>>>& cells)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  AddCorners(grid);
  for (const auto& [type, ids] : cells)
  {
    grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  }
  AddValues(grid);
  return grid;
}

constexpr int Solid = VTK_VOXEL;
const std::vector<std::pair<int, std::vector<vtkIdType>>> ThreeCubes{ { Solid, { 0, 1, 2, 3, 4, 5, 6, 7 } },
  { Solid, { 4, 5, 6, 7, 8, 9, 10, 11 } }, { Solid, { 8, 9, 10, 11, 12, 13, 14, 15 } } };

std::string WriteGrid(const std::string& name, vtkUnstructuredGrid* grid,
  const std::function<void(vtkXMLUnstructuredGridWriter*)>& set = {})
{
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  const std::string file = "UnstructuredGrid" + name + ".vtu";
  writer->SetFileName(file.c_str());
  if (set)
  {
    set(writer);
  }
  writer->Write();
  return file;
}

struct ReadGrid
{
  vtkNew<vtkInkMeshReader> reader;
  vtkPolyData* mesh;

  explicit ReadGrid(const std::string& file)
  {
    this->reader->SetFileName(file.c_str());
    this->reader->Update();
    this->mesh = this->reader->GetOutput();
    EXPECT_EQ(this->reader->GetErrorCode(), vtkErrorCode::NoError) << file;
  }

  /// The only one; empty if there is none.
  std::string Note() const
  {
    EXPECT_LE(this->reader->GetNumberOfNotes(), 1);
    const char* note = this->reader->GetNote(0);
    return note ? note : "";
  }
};

/// A tetrahedron as text, whose parts a test may replace.
struct GridText
{
  std::string points = "4";
  std::string cells = "1";
  std::string connectivity = "0 1 2 3";
  std::string offsets = "4";
  std::string types = "10";
  std::string faces;
  std::string values;
  std::string version = "1.0";

  std::string Put(const std::string& name) const
  {
    const std::string file = "UnstructuredGrid" + name + ".vtu";
    std::ofstream(file) << R"(<VTKFile type="UnstructuredGrid" version=")" << this->version
                        << R"(" byte_order="LittleEndian"><UnstructuredGrid><Piece NumberOfPoints=")"
                        << this->points << R"(" NumberOfCells=")" << this->cells << "\">" << this->values
                        << R"(<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">)"
                        << "0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>"
                        << Array("connectivity", this->connectivity) << Array("offsets", this->offsets)
                        << Array("types", this->types) << this->faces
                        << "</Cells></Piece></UnstructuredGrid></VTKFile>\n";
    return file;
  }

  static std::string Array(const std::string& name, const std::string& numbers)
  {
    return R"(<DataArray type="Int64" Name=")" + name + R"(" format="ascii">)" + numbers + "</DataArray>";
  }

  static GridText Polyhedron(const std::string& faces, const std::string& ends)
  {
    GridText grid;
    grid.types = std::to_string(VTK_POLYHEDRON);
    grid.faces = Array("faces", faces) + Array("faceoffsets", ends);
    return grid;
  }
};

/// VTK never frees the faces that it refuses.
struct VtkMayLeak
{
#ifdef __SANITIZE_ADDRESS__
  VtkMayLeak()
  {
    __lsan_disable();
  }
  ~VtkMayLeak()
  {
    __lsan_enable();
  }
#endif
};

constexpr const char* FourFaces = "4 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2";

} // namespace

TEST(UnstructuredGridFiles, TheOuterSurfaceKeepsWhatPointsAndCellsHave)
{
  const auto grid = MakeGrid(ThreeCubes);
  using Writer = vtkXMLUnstructuredGridWriter;
  const std::string files[] = { WriteGrid("Appended", grid),
    WriteGrid("Text", grid, [](Writer* writer) { writer->SetDataModeToAscii(); }),
    WriteGrid("Binary", grid, [](Writer* writer) { writer->SetDataModeToBinary(); }),
    WriteGrid("Raw", grid,
      [](Writer* writer)
      {
        writer->EncodeAppendedDataOff();
        writer->SetCompressorTypeToNone();
      }),
    WriteGrid("Large", grid, [](Writer* writer) { writer->SetHeaderTypeToUInt64(); }) };
  for (const std::string& file : files)
  {
    SCOPED_TRACE(file);
    const ReadGrid read(file);
    EXPECT_EQ(read.Note(), "the outer surface of its 3 solid cells is drawn");
    EXPECT_STREQ(read.reader->GetFormat(), "VTK XML unstructured grid (.vtu)");
    EXPECT_EQ(read.mesh->GetNumberOfPoints(), 16);
    ASSERT_EQ(read.mesh->GetNumberOfPolys(), 14);
    EXPECT_EQ(read.mesh->GetNumberOfCells(), 14);
    ASSERT_EQ(read.mesh->GetPointData()->GetNumberOfArrays(), 1);
    ASSERT_EQ(read.mesh->GetCellData()->GetNumberOfArrays(), 1);
    vtkDataArray* places = read.mesh->GetPointData()->GetArray("place");
    vtkDataArray* numbers = read.mesh->GetCellData()->GetArray("number");
    ASSERT_TRUE(places && numbers);
    for (vtkIdType i = 0; i < 16; ++i)
    {
      EXPECT_EQ(places->GetComponent(i, 0), read.mesh->GetPoint(i)[0]);
    }
    for (vtkIdType i = 0; i < 14; ++i)
    {
      double bounds[6];
      read.mesh->GetCellBounds(i, bounds);
      EXPECT_GE(numbers->GetComponent(i, 0), bounds[1] - 1.0);
      EXPECT_LE(numbers->GetComponent(i, 0), bounds[0]);
    }
  }
}

TEST(UnstructuredGridFiles, CellsThatAreFacesLinesOrVerticesAreTakenAsTheyAre)
{
  const ReadGrid flat(
    WriteGrid("Flat", MakeGrid({ { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_QUAD, { 4, 5, 7, 6 } } })));
  EXPECT_EQ(flat.mesh->GetNumberOfPolys(), 2);
  EXPECT_EQ(flat.Note(), "");
  const ReadGrid lines(
    WriteGrid("Lines", MakeGrid({ { VTK_LINE, { 0, 1 } }, { VTK_POLY_LINE, { 1, 2, 3 } } })));
  EXPECT_EQ(lines.mesh->GetNumberOfLines(), 2);
  EXPECT_EQ(lines.Note(), "");
  const ReadGrid points(
    WriteGrid("Vertices", MakeGrid({ { VTK_VERTEX, { 3 } }, { VTK_POLY_VERTEX, { 4, 5 } } })));
  EXPECT_EQ(points.mesh->GetNumberOfVerts(), 2);
  EXPECT_EQ(points.Note(), "");
  const ReadGrid mixed(WriteGrid("Mixed",
    MakeGrid({ ThreeCubes[0], { VTK_TRIANGLE, { 8, 9, 10 } }, { VTK_LINE, { 12, 13 } },
      { VTK_VERTEX, { 14 } }, { VTK_TETRA, { 8, 9, 10, 12 } } })));
  EXPECT_EQ(mixed.mesh->GetNumberOfVerts(), 1);
  EXPECT_EQ(mixed.mesh->GetNumberOfLines(), 1);
  EXPECT_GE(mixed.mesh->GetNumberOfPolys(), 6 + 4);
  EXPECT_EQ(mixed.Note(), "the outer surface of its 2 solid cells is drawn");
}

TEST(UnstructuredGridFiles, PointsWithoutCellsArePoints)
{
  const ReadGrid read(WriteGrid("NoCells", MakeGrid({})));
  EXPECT_EQ(read.mesh->GetNumberOfPoints(), 16);
  EXPECT_EQ(read.mesh->GetNumberOfCells(), 0);
  EXPECT_TRUE(read.mesh->GetPointData()->HasArray("place"));
}

TEST(UnstructuredGridFiles, CurvedFacesAreSubdivided)
{
  // A tetrahedron with the middles of its edges: 4 flat triangles for each of 4 faces.
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  const double corners[4][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } };
  for (const double* corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  for (const auto& [a, b] :
    { std::pair(0, 1), std::pair(1, 2), std::pair(0, 2), std::pair(0, 3), std::pair(1, 3), std::pair(2, 3) })
  {
    points->InsertNextPoint((corners[a][0] + corners[b][0]) / 2, (corners[a][1] + corners[b][1]) / 2,
      (corners[a][2] + corners[b][2]) / 2);
  }
  grid->SetPoints(points);
  const vtkIdType ids[] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 };
  grid->InsertNextCell(VTK_QUADRATIC_TETRA, 10, ids);
  AddValues(grid);
  const ReadGrid read(WriteGrid("Quadratic", grid));
  EXPECT_EQ(read.mesh->GetNumberOfPolys(), 16);
  EXPECT_EQ(read.mesh->GetNumberOfPoints(), 10);
  EXPECT_EQ(read.mesh->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(read.Note(), "the outer surface of its 1 solid cell is drawn");
}

TEST(UnstructuredGridFiles, PolyhedraHaveTheirFaces)
{
  // As files were written before VTK 9.4, and as the one at hand writes them.
  const ReadGrid text(GridText::Polyhedron(FourFaces, "17").Put("Faces"));
  EXPECT_EQ(text.mesh->GetNumberOfPolys(), 4);
  vtkNew<vtkUnstructuredGrid> grid;
  AddCorners(grid);
  for (const vtkIdType first : { 0, 4 })
  {
    vtkNew<vtkIdList> stream;
    stream->InsertNextId(6);
    for (const vtkIdType face : { 0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5 })
    {
      if (stream->GetNumberOfIds() % 5 == 1)
      {
        stream->InsertNextId(4);
      }
      stream->InsertNextId(first + face);
    }
    grid->InsertNextCell(VTK_POLYHEDRON, stream);
  }
  AddValues(grid);
  const ReadGrid written(WriteGrid("Polyhedra", grid));
  EXPECT_EQ(written.mesh->GetNumberOfPolys(), 10);
  EXPECT_EQ(written.Note(), "the outer surface of its 2 solid cells is drawn");
}

TEST(UnstructuredGridFiles, ArraysOfValuesMayHaveTheNamesOfThoseOfCells)
{
  const auto grid = MakeGrid(ThreeCubes);
  grid->GetPointData()->GetArray("place")->SetName("offsets");
  grid->GetPointData()->GetArray("offsets")->SetComponent(0, 0, 1e30);
  grid->GetCellData()->GetArray("number")->SetName("types");
  grid->GetCellData()->GetArray("types")->SetComponent(0, 0, -5.0);
  const ReadGrid read(WriteGrid("Names", grid));
  EXPECT_EQ(read.mesh->GetPointData()->GetArray("offsets")->GetRange()[1], 1e30);
  EXPECT_EQ(read.mesh->GetCellData()->GetArray("types")->GetRange()[0], -5.0);
}

TEST(UnstructuredGridFiles, WhatIsNotSoundIsRefused)
{
  const ReadGrid whole(GridText().Put("Whole"));
  EXPECT_EQ(whole.mesh->GetNumberOfPolys(), 4);
  using Part = std::string GridText::*;
  struct Fault
  {
    Part part;
    const char* text;
    const char* expected;
  };
  int number = 0;
  for (const Fault& fault :
    std::vector<Fault>{ { &GridText::connectivity, "0 1 2 4", "a cell has point 4, but there are 4 points" },
      { &GridText::connectivity, "0 1 2 -1", "a cell has point -1" },
      { &GridText::connectivity, "0 1 2", "has fewer values than it should" },
      { &GridText::offsets, "-4", "its cells say that they have -4 points" },
      { &GridText::offsets, "3", "cell 0 of VTK's type 10 has 3 points; expected 4" },
      { &GridText::offsets, "3000000000", "its cells say that they have 3e+09 points" },
      { &GridText::types, "12", "cell 0 of VTK's type 12 has 4 points; expected 8" },
      { &GridText::types, "1", "cell 0 of VTK's type 1 has 4 points; expected 1" },
      { &GridText::types, "36", "cell 0 of VTK's type 36 has 4 points; expected 6 or more" },
      { &GridText::types, "42", "cell 0, a polyhedron, has no faces" },
      { &GridText::types, "72", "a cell is of a higher order than quadratic, VTK's type 72" },
      { &GridText::types, "99", "a cell is of a type that is not read, VTK's type 99" },
      { &GridText::types, "266", "VTK's type 266" }, { &GridText::types, "-1", "VTK's type -1" },
      { &GridText::types, "0", "none of its 1 cells has an outer surface" },
      { &GridText::points, "3000000000", "3e+09 points" }, { &GridText::cells, "3000000000", "3e+09 cells" },
      { &GridText::cells, "-1", "NumberOfCells '-1'" },
      { &GridText::cells, "2", "has fewer values than it should" } })
  {
    GridText grid;
    grid.*fault.part = fault.text;
    ExpectError({ fault.expected }, grid.Put("Fault" + std::to_string(++number)));
  }
  // The values of cells.
  GridText values;
  values.values = "<CellData>" + GridText::Array("n", "") + "</CellData>";
  ExpectError({ "its array 'n' has fewer values than it should" }, values.Put("Values"));
  GridText rising;
  rising.cells = "2";
  rising.types = "10 10";
  rising.offsets = "4 3";
  ExpectError({ "not monotonically increasing" }, rising.Put("Rising"));
}

TEST(UnstructuredGridFiles, FacesThatAreNotSoundAreRefused)
{
  [[maybe_unused]] const VtkMayLeak leaks;
  struct Fault
  {
    const char* faces;
    const char* ends;
    const char* expected;
  };
  int number = 0;
  for (const Fault& fault : std::vector<Fault>{
         { "4 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 4", "17", "has a face with point 4, which is not its own" },
         { "4 3 0 2 1 3 0 1 3 3 1 2 3 2 0 3", "16", "has a face of fewer than 3 points" },
         { "4 3 0 2 1 3 0 1 3 3 1 2 3 9 0 3 2", "17", "do not end where their faceoffsets say" },
         { "9 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2", "17", "do not end where their faceoffsets say" },
         { "-1 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2", "17", "do not end where their faceoffsets say" },
         { "3000000000 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2", "17", "do not end where their faceoffsets say" },
         { "4 3 0 2 1 3 0 1 3 3 1 2 3 3000000000 0 3 2", "17", "do not end where their faceoffsets say" },
         { FourFaces, "13", "do not end where their faceoffsets say" },
         { FourFaces, "18", "its array 'faces' has fewer values than it should" },
         { FourFaces, "3000000000", "its cells say that they have 3e+09 faces" },
         { FourFaces, "-1", "cell 0, a polyhedron, has no faces" } })
  {
    ExpectError({ fault.expected },
      GridText::Polyhedron(fault.faces, fault.ends).Put("Faces" + std::to_string(++number)));
  }
}
