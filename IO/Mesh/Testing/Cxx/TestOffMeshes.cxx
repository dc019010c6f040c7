// SPDX-License-Identifier: BSD-3-Clause
// OFF meshes as programs write them, and what is refused.

#include "InkTestMessages.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkInkMeshReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace
{

std::string PutOff(const std::string& name, const std::string& text)
{
  const std::string file = "OffMeshes" + name + ".off";
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

vtkSmartPointer<vtkPolyData> ReadOff(const std::string& file)
{
  vtkNew<vtkInkMeshReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_STREQ(reader->GetFormat(), "OFF mesh");
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError) << file;
  return reader->GetOutput();
}

std::vector<vtkIdType> CornersOf(vtkCellArray* cells, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  cells->GetCellAtId(cell, ids);
  return { ids->begin(), ids->end() };
}

constexpr const char* Corners = "0 0 0\n4500000.125 0 0\n0 1 0\n1 1 1\n";
constexpr const char* Faces = "3 0 1 2\n4 1 3 2 0\n";

} // namespace

TEST(OffMeshes, AreReadAsProgramsWriteThem)
{
  const std::string lines = std::string(Corners) + Faces;
  const std::string files[] = { PutOff("Plain", "OFF\n4 2 0\n" + lines),
    PutOff("OneLine", "OFF 4 2 0\n" + lines), PutOff("NoSpace", "OFF4 2 0\n" + lines),
    PutOff("NoEdges", "OFF\n4 2\n" + lines),
    PutOff("Comments",
      "# by hand\nOFF\n\n4 2 0 # counts\n0 0 0\n4500000.125 0 0 # far\n\n0 1 0\n1 1 1\n" +
        std::string(Faces)),
    PutOff(
      "Windows", "OFF\r\n4 2 0\r\n0 0 0\r\n4500000.125 0 0\r\n0 1 0\r\n1 1 1\r\n3 0 1 2\r\n4 1 3 2 0\r\n"),
    PutOff(
      "FaceColors", "OFF\n4 2 0\n" + std::string(Corners) + "3 0 1 2 255 0 0\n4 1 3 2 0 0.5 0.5 0.5 1.0\n") };
  for (const std::string& file : files)
  {
    const auto mesh = ReadOff(file);
    ASSERT_EQ(mesh->GetNumberOfPoints(), 4) << file;
    EXPECT_EQ(mesh->GetPoint(1)[0], 4500000.125) << file;
    EXPECT_EQ(mesh->GetPoint(3)[2], 1.0) << file;
    ASSERT_EQ(mesh->GetNumberOfPolys(), 2) << file;
    EXPECT_EQ(CornersOf(mesh->GetPolys(), 0), (std::vector<vtkIdType>{ 0, 1, 2 })) << file;
    EXPECT_EQ(CornersOf(mesh->GetPolys(), 1), (std::vector<vtkIdType>{ 1, 3, 2, 0 })) << file;
    EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 0) << file;
  }
}

TEST(OffMeshes, NormalsAndColorsOfVertices)
{
  const auto mesh = ReadOff(PutOff("Rich",
    "CNOFF\n3 1 0\n0 0 0 0 0 1 255 0 128 255\n1 0 0 0 1 0 0 255 0 255\n0 1 0 1 0 0 0 0 7 255\n3 0 1 2\n"));
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  ASSERT_TRUE(normals);
  EXPECT_EQ(normals->GetComponent(1, 1), 1.0);
  EXPECT_EQ(normals->GetComponent(2, 0), 1.0);
  vtkDataArray* colors = mesh->GetPointData()->GetScalars();
  ASSERT_TRUE(colors && colors->GetNumberOfComponents() == 3);
  EXPECT_EQ(colors->GetComponent(0, 0), 255.0);
  EXPECT_EQ(colors->GetComponent(0, 2), 128.0);
  EXPECT_EQ(colors->GetComponent(2, 2), 7.0);

  const auto parts = ReadOff(PutOff("Parts", "COFF\n2 0 0\n0 0 0 1 0 0.5 1\n1 0 0 0 1 nan 1\n"));
  ASSERT_TRUE(parts->GetPointData()->GetScalars());
  EXPECT_EQ(parts->GetPointData()->GetScalars()->GetComponent(0, 0), 255.0) << "of 1";
  EXPECT_EQ(parts->GetPointData()->GetScalars()->GetComponent(0, 2), 127.0);
  EXPECT_EQ(parts->GetPointData()->GetScalars()->GetComponent(1, 2), 0.0);
  EXPECT_FALSE(ReadOff(PutOff("Missing", "COFF\n2 0 0\n0 0 0 1 0 0\n1 0 0\n"))->GetPointData()->GetScalars());
}

TEST(OffMeshes, FacesOfOneAndTwoCornersAreVerticesAndLines)
{
  std::string text = "OFF\n150 3 0\n";
  std::string large = "150";
  for (int i = 0; i < 150; ++i)
  {
    text += std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    large += " " + std::to_string(i);
  }
  const auto mesh = ReadOff(PutOff("Cells", text + "1 7\n2 3 4\n" + large + "\n"));
  EXPECT_EQ(CornersOf(mesh->GetVerts(), 0), (std::vector<vtkIdType>{ 7 }));
  EXPECT_EQ(CornersOf(mesh->GetLines(), 0), (std::vector<vtkIdType>{ 3, 4 }));
  EXPECT_EQ(CornersOf(mesh->GetPolys(), 0).size(), 150u) << "more corners than VTK's reader takes";
}

TEST(OffMeshes, WhatCannotBeReadIsOneError)
{
  const std::string corners = Corners;
  const std::pair<std::string, std::string> cases[] = {
    { "words\n", "it begins with 'words'; expected OFF" },
    { "4OFF\n1 0 0\n0 0 0 1\n", "it is not an OFF mesh of three dimensions" },
    { "# nothing\n", "it says nothing; expected OFF" },
    { "OFF BINARY\n", "it is a binary OFF mesh; expected one of text" },
    { "OFF\n", "the file ends where the numbers of vertices, faces and edges were expected" },
    { "OFF\n4\n", "line 2 is '4'; expected the numbers of vertices, faces and edges" },
    { "OFF\n-4 2 0\n", "line 2 is '-4 2 0'; expected the numbers" },
    { "OFF\n4.5 2 0\n", "line 2 is '4.5 2 0'; expected the numbers" },
    { "OFF\n2000000000 2 0\n0 0 0\n", "the file ends after 1 of the 2000000000 vertices that it promises" },
    { "OFF\n4 2 0\n" + corners + "3 0 1 2\n", "the file ends after 1 of the 2 faces that it promises" },
    { "OFF\n2 0 0\n0 0 0\n1 x 0\n", "line 4 is '1 x 0'; expected the numbers of a vertex" },
    { "OFF\n2 0 0\n0 0 0\n1 0\n", "line 4 is '1 0'; expected a vertex, three numbers" },
    { "NOFF\n1 0 0\n0 0 0\n", "line 3 is '0 0 0'; expected a vertex and its normal, six numbers" },
    { "OFF\n4 1 0\n" + corners + "3 0 1 4\n", "line 7 is '3 0 1 4'; expected corners from 0 to 3" },
    { "OFF\n4 1 0\n" + corners + "3 0 1 -1\n", "expected corners from 0 to 3" },
    { "OFF\n4 1 0\n" + corners + "3 0 1 1.5\n", "expected corners from 0 to 3" },
    { "OFF\n4 1 0\n" + corners + "4 0 1 2\n", "expected a face: the number of its corners, and theirs" },
    { "OFF\n4 1 0\n" + corners + "0\n", "expected a face: the number of its corners, and theirs" },
    { "OFF\n4 1 0\n" + corners + "3 0 one 2\n", "expected a face: the number of its corners, and theirs" },
    { "OFF\n0 0 0\n", "it holds no points" },
  };
  for (const auto& [text, words] : cases)
  {
    vtkNew<vtkInkMeshReader> reader;
    vtkNew<InkTestMessages> messages;
    messages->Observe(reader);
    messages->Observe(reader->GetExecutive());
    reader->SetFileName(PutOff("Broken", text).c_str());
    reader->Update();
    messages->Expect(text, { words });
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << text;
    EXPECT_NE(reader->GetErrorCode(), vtkErrorCode::NoError) << text;
  }
}
