// SPDX-License-Identifier: BSD-3-Clause
// GIFTI surfaces in each encoding, arrays of their points, and what is refused. The numbers as bytes and
// compressed are Python's.

#include "MeshTestReading.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <fstream>
#include <map>

using MeshTestReading::ExpectError;

namespace
{

using Attributes = std::map<std::string, std::string>;

/// An element DataArray of text numbers in rows. @param changed other attributes
std::string Array(const std::string& intent, const std::string& type, const std::string& rows,
  const std::string& columns, const std::string& data, const Attributes& changed = {})
{
  Attributes attributes{ { "Intent", "NIFTI_INTENT_" + intent }, { "DataType", "NIFTI_TYPE_" + type },
    { "ArrayIndexingOrder", "RowMajorOrder" }, { "Dimensionality", "2" }, { "Dim0", rows },
    { "Dim1", columns }, { "Encoding", "ASCII" }, { "Endian", "LittleEndian" }, { "ExternalFileName", "" } };
  for (const auto& [name, value] : changed)
  {
    attributes[name] = value;
  }
  std::string element = "<DataArray";
  for (const auto& [name, value] : attributes)
  {
    element += " " + name + "=\"" + value + "\"";
  }
  return element + ">\n<MetaData/><Data>" + data + "</Data></DataArray>\n";
}

constexpr const char* Corners = "0 0 0  1.5 0 0  0 1 0  1 1 -2";

std::string Points(const Attributes& changed = {}, const std::string& data = Corners)
{
  return Array("POINTSET", "FLOAT32", "4", "3", data, changed);
}

std::string Triangles(const std::string& data = "0 1 2\n1 3 2", const Attributes& changed = {})
{
  return Array("TRIANGLE", "INT32", "2", "3", data, changed);
}

std::string Put(const std::string& name, const std::string& arrays)
{
  const std::string file = "GiftiSurfaces" + name + ".gii";
  std::ofstream(file, std::ios::binary)
    << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    << "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
    << "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\">\n<MetaData/>\n"
    << arrays << "</GIFTI>\n";
  return file;
}

/// @param notes how many there should be
vtkSmartPointer<vtkPolyData> Read(const std::string& file, int notes = 0)
{
  vtkNew<vtkInkMeshReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError) << file;
  EXPECT_EQ(reader->GetNumberOfNotes(), notes) << file;
  return reader->GetOutput();
}

Attributes Encoded(const std::string& encoding, const std::string& endian = "LittleEndian",
  const std::string& order = "RowMajorOrder")
{
  return { { "Encoding", encoding }, { "Endian", endian }, { "ArrayIndexingOrder", order } };
}

} // namespace

TEST(GiftiSurfaces, EveryEncodingIsTheSame)
{
  const std::string arrays[] = { Points() + Triangles(),
    Points({ { "ArrayIndexingOrder", "ColumnMajorOrder" } }, "0 1.5 0 1  0 0 1 1  0 0 0 -2") + Triangles(),
    Points(Encoded("Base64Binary", "LittleEndian", "RowMajorOrder"),
      "AAAAAAAAAAAAAAAAAADA\n PwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAADA") +
      Triangles("AAAAAAEAAAACAAAAAQAAAAMAAAACAAAA", Encoded("Base64Binary", "LittleEndian", "RowMajorOrder")),
    Points(Encoded("GZipBase64Binary", "LittleEndian", "RowMajorOrder"), "eNpjYEAGB+xRuAwN9ggazD4AADswA/0=") +
      Triangles("eNpjYGBgYARiJijNDGUDAAB4AAo=", Encoded("GZipBase64Binary", "LittleEndian", "RowMajorOrder")),
    Points(Encoded("GZipBase64Binary", "BigEndian", "ColumnMajorOrder"),
      "eNpjYGBgsD/AAAb2DQxwAGIj80EApAwAaHQD/Q==") +
      Triangles("eNpjYAADRihmBmImEAYAAF0ACg==", Encoded("GZipBase64Binary", "BigEndian", "ColumnMajorOrder")),
    Points(Encoded("GIFTI_ENCODING_B64BIN", "GIFTI_ENDIAN_BIG", "RowMajorOrder"),
      "AAAAAAAAAAAAAAAAP8AA\n AAAAAAAAAAAAAAAAAD+AAAAAAAAAP4AAAD+AAADAAAAA") +
      Triangles("AAAAAAAAAAEAAAACAAAAAQAAAAMAAAAC",
        Encoded("GIFTI_ENCODING_B64BIN", "GIFTI_ENDIAN_BIG", "RowMajorOrder")),
    Triangles() + Points() };
  for (const std::string& surface : arrays)
  {
    const auto mesh = Read(Put("Encoded", surface));
    ASSERT_EQ(mesh->GetNumberOfPoints(), 4) << surface;
    EXPECT_EQ(mesh->GetPoint(1)[0], 1.5) << surface;
    EXPECT_EQ(mesh->GetPoint(2)[1], 1.0) << surface;
    EXPECT_EQ(mesh->GetPoint(3)[2], -2.0) << surface;
    ASSERT_EQ(mesh->GetNumberOfPolys(), 2) << surface;
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(1, ids);
    EXPECT_EQ(std::vector<vtkIdType>(ids->begin(), ids->end()), (std::vector<vtkIdType>{ 1, 3, 2 }))
      << surface;
    EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 0) << surface;
  }
}

TEST(GiftiSurfaces, ArraysOfPoints)
{
  std::string named = Array("SHAPE", "FLOAT32", "4", "1", "1 2 3 4.5");
  named.replace(named.find("<MetaData/>"), 11,
    "<MetaData><MD><Name><![CDATA[Other]]></Name><Value>no</Value></MD>"
    "<MD><Name><![CDATA[Name]]></Name><Value><![CDATA[thickness & more]]></Value></MD></MetaData>");
  const Attributes flat{ { "Dimensionality", "1" } };
  const auto mesh =
    Read(Put("Arrays",
           Points() + Triangles() + named + Array("LABEL", "INT32", "4", "1", "7 0 -1 7", flat) +
             Array("VECTOR", "FLOAT32", "4", "3", "0 0 1 0 1 0 1 0 0 0 0 -1") +
             Array("LABEL", "INT32", "4", "1", "1 2 3 4", flat) +
             Array("TIME_SERIES", "FLOAT32", "3", "1", "1 2 3", flat) + Points()),
      1);
  vtkPointData* arrays = mesh->GetPointData();
  ASSERT_EQ(arrays->GetNumberOfArrays(), 3);
  ASSERT_TRUE(arrays->GetArray("thickness & more"));
  EXPECT_EQ(arrays->GetArray("thickness & more")->GetComponent(3, 0), 4.5);
  ASSERT_TRUE(arrays->GetArray("label"));
  EXPECT_EQ(arrays->GetArray("label")->GetComponent(2, 0), -1.0) << "the first one";
  ASSERT_TRUE(arrays->GetArray("vector"));
  EXPECT_EQ(arrays->GetArray("vector")->GetComponent(3, 2), -1.0);

  vtkNew<vtkInkMeshReader> reader;
  reader->SetFileName("GiftiSurfacesArrays.gii");
  reader->Update();
  EXPECT_STREQ(reader->GetNote(0),
    "3 of its arrays are not used: NIFTI_INTENT_LABEL, NIFTI_INTENT_TIME_SERIES, NIFTI_INTENT_POINTSET");
  EXPECT_STREQ(reader->GetFormat(), "GIFTI surface (.gii)");
}

TEST(GiftiSurfaces, PointsWithoutTrianglesAreNoted)
{
  const auto mesh = Read(Put("Points", Points()), 1);
  EXPECT_EQ(mesh->GetNumberOfPoints(), 4);
  EXPECT_EQ(mesh->GetNumberOfCells(), 0);
}

TEST(GiftiSurfaces, WhatCannotBeReadIsOneError)
{
  const Attributes base64 = Encoded("Base64Binary");
  const Attributes compressed = Encoded("GZipBase64Binary");
  const std::string huge = "999999999999";
  const std::pair<std::string, std::string> cases[] = {
    { Array("SHAPE", "FLOAT32", "4", "1", "1 2 3 4") + Array("LABEL", "INT32", "4", "1", "1 2 3 4"),
      "it holds no points; its arrays: NIFTI_INTENT_SHAPE, NIFTI_INTENT_LABEL; expected "
      "NIFTI_INTENT_POINTSET" },
    { "", "it holds no points; its arrays: none" },
    { "<DataArray><Data>1<DataArray>2</DataArray>3</Data></DataArray>", "it holds no points" },
    { Points() + Triangles("0 1 2 1 4 2"), "triangle 1 has point 4, but there are 4 points, counted from 0" },
    { Points() + Triangles("0 1 2 1 -3 2"), "triangle 1 has point -3" },
    { Points() + Triangles("0 1 2 1 0.5 2"),
      "'NIFTI_INTENT_TRIANGLE' says '0.5'; expected a number of its DataType" },
    { Points() + Triangles("0 1 2 1    3"), "ends where number 6 of 6 was expected" },
    { Points() + Triangles("0 1 2 1 3 2 0"), "says '0' after the 6 numbers that it promises" },
    { Points() + Triangles("0 1 2 1 3 x"), "says 'x' where number 6 of 6 was expected" },
    { Points() + Triangles("0 1 2 1 3 2", { { "Dim1", "2" } }),
      "has 2 x 2 numbers; expected three in a row" },
    { Points({ { "Dim0", huge } }), "too few for the 1e+12 x 3 numbers that it promises" },
    { Points({ { "Dim0", "-4" } }), "says Dim0 '-4'; expected a whole number" },
    { Points({ { "Dim0", "1e300" } }), "says Dim0 '1e300'; expected a whole number" },
    { Points({ { "Dimensionality", "7" } }), "says Dimensionality '7'; expected a whole number from 0 to 6" },
    { Points({ { "DataType", "NIFTI_TYPE_COMPLEX64" } }),
      "says DataType 'NIFTI_TYPE_COMPLEX64'; expected NIFTI_TYPE_" },
    { Points({ { "DataType", "NIFTI_TYPE_INT32" } }, "0 0 0 1 0 0 0 1 0 1 1 1"),
      "says DataType 'NIFTI_TYPE_INT32'; expected NIFTI_TYPE_FLOAT32" },
    { Points({ { "ArrayIndexingOrder", "None" } }),
      "says ArrayIndexingOrder 'None'; expected RowMajorOrder" },
    { Points({ { "Encoding", "ExternalFileBinary" }, { "ExternalFileName", "other.dat" } }),
      "expected ASCII, Base64Binary or GZipBase64Binary, not numbers in the file 'other.dat'" },
    { Points(base64, "AAAA"), "has 4 characters, too few for the 4 x 3 numbers" },
    { Points(base64, std::string(64, '?')), "0 bytes of Base64 can be used; expected 48" },
    { Points(base64, std::string(80, 'A')), "expected 48" },
    { Points(Encoded("Base64Binary", "Middle"), std::string(64, 'A')), "says Endian 'Middle'" },
    { Points(compressed, std::string(64, 'A')), "has compressed numbers that are broken" },
    { Points({ { "Encoding", "GZipBase64Binary" }, { "Dim0", huge } }, std::string(64, 'A')),
      "has 64 characters of compressed numbers, too few" },
    { Points() + "<DataArray>", "it is no XML that can be read" },
    { Array("POINTSET", "FLOAT32", "0", "3", ""), "it holds no points" },
  };
  for (const auto& [arrays, words] : cases)
  {
    ExpectError({ "cannot read", words }, Put("Broken", arrays));
  }
  std::ofstream("GiftiSurfacesOther.gii") << "<VTKFile></VTKFile>\n";
  ExpectError({ "its first element is 'VTKFile'; expected GIFTI" }, "GiftiSurfacesOther.gii");
}

TEST(GiftiSurfaces, EntitiesMakeNoMoreTextThanTheFileHas)
{
  std::string entities = "<!ENTITY a \"1 1 1 1 1 1 1 1 1 1 \">";
  for (char name = 'b'; name < 'g'; ++name)
  {
    entities += std::string("<!ENTITY ") + name + " \"";
    for (int i = 0; i < 10; ++i)
    {
      entities += std::string("&") + static_cast<char>(name - 1) + ";";
    }
    entities += "\">";
  }
  std::ofstream("GiftiSurfacesEntities.gii")
    << "<!DOCTYPE GIFTI [" << entities << "]><GIFTI>" << Points({}, "&f;") << "</GIFTI>\n";
  ExpectError({ "its entities make more text than the file has" }, "GiftiSurfacesEntities.gii");
}
