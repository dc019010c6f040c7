// SPDX-License-Identifier: BSD-3-Clause
// PCD points as text, bytes and compressed, their arrays, and what is refused.

#include "MeshTestReading.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <bit>
#include <cstdint>
#include <fstream>

using MeshTestReading::ExpectError;

namespace
{

std::string Header(const std::string& points, const std::string& data)
{
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 2\nTYPE F "
         "F F U\n"
         "COUNT 1 1 1 1\nWIDTH " +
    points + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points + "\nDATA " + data + "\n";
}

/// Least significant byte first.
std::string Bytes(std::uint32_t number, int size = 4)
{
  std::string bytes;
  for (int i = 0; i < size; ++i)
  {
    bytes += static_cast<char>(number >> 8 * i);
  }
  return bytes;
}

std::string Bytes(float number)
{
  return Bytes(std::bit_cast<std::uint32_t>(number));
}

/// Two points, one after the other and one field after the other.
const std::string Binary = Bytes(1.5F) + Bytes(2.0F) + Bytes(3.0F) + Bytes(7, 2) + Bytes(-1.0F) +
  Bytes(-2.0F) + Bytes(-3.0F) + Bytes(700, 2);
const std::string ByField = Bytes(1.5F) + Bytes(-1.0F) + Bytes(2.0F) + Bytes(-2.0F) + Bytes(3.0F) +
  Bytes(-3.0F) + Bytes(7, 2) + Bytes(700, 2);

/// One run of bytes as they are.
std::string Packed(const std::string& bytes)
{
  return static_cast<char>(bytes.size() - 1) + bytes;
}

std::string Compressed(const std::string& packed, std::uint32_t size)
{
  return Bytes(static_cast<std::uint32_t>(packed.size())) + Bytes(size) + packed;
}

std::string Put(const std::string& name, const std::string& text)
{
  const std::string file = "PcdClouds" + name + ".pcd";
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

vtkSmartPointer<vtkPolyData> Read(const std::string& file, const std::vector<std::string>& notes = {})
{
  vtkNew<vtkInkMeshReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_STREQ(reader->GetFormat(), "PCD points");
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError) << file;
  std::vector<std::string> said;
  for (int i = 0; i < reader->GetNumberOfNotes(); ++i)
  {
    said.emplace_back(reader->GetNote(i));
  }
  EXPECT_EQ(said, notes) << file;
  return reader->GetOutput();
}

} // namespace

TEST(PcdClouds, TextBytesAndCompressedAreTheSame)
{
  for (const std::string& text : { Header("2", "ascii") + "1.5 2 3 7\n\n-1 -2 -3 700\n",
         Header("2", "binary") + Binary, Header("2", "binary") + Binary + "more",
         Header("2", "binary_compressed") + Compressed(Packed(ByField), 28) })
  {
    const auto cloud = Read(Put("Same", text));
    ASSERT_EQ(cloud->GetNumberOfPoints(), 2) << text;
    EXPECT_EQ(cloud->GetNumberOfCells(), 0) << text;
    EXPECT_EQ(cloud->GetPoint(0)[0], 1.5) << text;
    EXPECT_EQ(cloud->GetPoint(1)[1], -2.0) << text;
    EXPECT_EQ(cloud->GetPoint(1)[2], -3.0) << text;
    vtkDataArray* label = cloud->GetPointData()->GetArray("label");
    ASSERT_TRUE(label) << text;
    EXPECT_EQ(label->GetComponent(1, 0), 700.0) << text;
  }
}

TEST(PcdClouds, WhatIsCompressedMayRepeatItself)
{
  // 20 points of 14 bytes: four bytes, 7 + 2 + 200 more of these, and 5 + 2 and 7 + 2 + 51 of the same.
  const std::string one = Bytes(1.0F);
  const std::string packed = Packed(one) + std::string("\xE0\xC8\x03", 3) + std::string("\xA0\x03", 2) +
    std::string("\xE0\x33\x03", 3);
  const auto cloud = Read(Put("Repeats", Header("20", "binary_compressed") + Compressed(packed, 280)));
  ASSERT_EQ(cloud->GetNumberOfPoints(), 20);
  for (vtkIdType i = 0; i < 20; ++i)
  {
    EXPECT_EQ(cloud->GetPoint(i)[2], 1.0) << i;
  }
  EXPECT_EQ(cloud->GetPointData()->GetArray("label")->GetComponent(19, 0), 0x3F80);
}

TEST(PcdClouds, NormalsColorsAndPointsThatAreNone)
{
  // A color's bits as a float, of which a quiet NaN would change some.
  const std::string header =
    "VERSION .7\nFIELDS x y z rgb normal_x normal_y normal_z _ time histogram\n"
    "SIZE 8 8 8 4 4 4 4 1 8 4\nTYPE F F F F F F F U U F\nCOUNT 1 1 1 1 1 1 1 3 1 2\n";
  const auto cloud =
    Read(Put("Rich",
           header +
             "WIDTH 2\nHEIGHT 2\nDATA ascii\n"
             "4500000.125 0 0 2.3418052e-38 0 0 1 0 0 0 99 1 2\nnan nan nan 0 0 0 1 0 0 0 99 1 2\n"
             "1 0 0 0 nan nan nan 0 0 0 18446744073709551615 1 2\n0 0 inf 0 0 0 1 0 0 0 99 1 2\n"),
      { "2 of its 4 points, which have no coordinates, are left out", "its fields histogram are not used" });
  ASSERT_EQ(cloud->GetNumberOfPoints(), 2);
  EXPECT_EQ(cloud->GetPoint(0)[0], 4500000.125);
  vtkPointData* arrays = cloud->GetPointData();
  ASSERT_EQ(arrays->GetNumberOfArrays(), 3);
  ASSERT_TRUE(arrays->GetNormals());
  EXPECT_EQ(arrays->GetNormals()->GetComponent(0, 2), 1.0);
  EXPECT_EQ(arrays->GetNormals()->GetComponent(1, 0), 0.0) << "none";
  ASSERT_TRUE(arrays->GetScalars());
  EXPECT_STREQ(arrays->GetScalars()->GetName(), "RGB");
  EXPECT_EQ(arrays->GetScalars()->GetComponent(0, 0), 255.0);
  EXPECT_EQ(arrays->GetScalars()->GetComponent(1, 0), 0.0);
  EXPECT_EQ(arrays->GetArray("time")->GetComponent(0, 0), 99.0);

  const std::string colored = "FIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F F\nPOINTS 1\nDATA binary\n";
  const auto color =
    Read(Put("Color", colored + Bytes(1.0F) + Bytes(1.0F) + Bytes(1.0F) + Bytes(0xFF900102)));
  ASSERT_TRUE(color->GetPointData()->GetScalars());
  EXPECT_EQ(color->GetPointData()->GetScalars()->GetComponent(0, 0), 0x90);
  EXPECT_EQ(color->GetPointData()->GetScalars()->GetComponent(0, 1), 1.0);
  EXPECT_EQ(color->GetPointData()->GetScalars()->GetComponent(0, 2), 2.0);
}

TEST(PcdClouds, OldHeadersSayLess)
{
  const auto cloud =
    Read(Put("Old", "# .PCD v.5\r\nCOLUMNS x y z\r\nPOINTS 2\r\nDATA ascii\r\n1 2 3\r\n4 5 6\r\n"));
  ASSERT_EQ(cloud->GetNumberOfPoints(), 2);
  EXPECT_EQ(cloud->GetPoint(1)[2], 6.0);
}

TEST(PcdClouds, WhatCannotBeReadIsOneError)
{
  const std::string fields = "FIELDS x y z\nPOINTS 1\n";
  const std::string packed = Packed(ByField);
  const auto compressed = [](const std::string& bytes)
  { return Header("2", "binary_compressed") + Compressed(bytes, 28); };
  const std::pair<std::string, std::string> cases[] = {
    { "words\n", "it is no PCD file, or its header is broken: it says 'words'; expected VERSION" },
    { fields, "the file ends within its header; expected a line DATA" },
    { fields + "DATA zip\n", "its header says DATA 'zip'; expected ascii, binary or binary_compressed" },
    { "POINTS 1\nDATA ascii\n", "its header says no FIELDS; expected names as x y z" },
    { "FIELDS x y z\nDATA ascii\n1 2 3\n", "its header says no POINTS; expected how many there are" },
    { "FIELDS x y w\nPOINTS 1\nDATA ascii\n1 2 3\n",
      "its points have the fields 'x y w'; expected x, y and z" },
    { fields + "SIZE 4 4\nDATA ascii\n1 2 3\n",
      "its header says SIZE '4 4'; expected a word for each of the 3 fields" },
    { fields + "SIZE 4 4 3\nDATA ascii\n1 2 3\n",
      "its field 'z' has TYPE 'F' and SIZE '3'; expected I or U" },
    { fields + "COUNT 1 1 0\nDATA ascii\n1 2 3\n",
      "its header says COUNT '1 1 0'; expected whole numbers from 1" },
    { "FIELDS x y z\nPOINTS -1\nDATA ascii\n", "its header says POINTS '-1'; expected a whole number" },
    { "FIELDS x y z\nPOINTS 1.5\nDATA ascii\n", "its header says POINTS '1.5'; expected a whole number" },
    { fields + "WIDTH 2\nHEIGHT 3\nDATA ascii\n",
      "its header says POINTS '1'; expected 6, its WIDTH times its HEIGHT" },
    { "FIELDS x y z\nWIDTH 1e15\nHEIGHT 1e15\nDATA binary\n",
      "its header says WIDTH '1e15'; expected no more than" },
    { fields + "DATA ascii\n1 2\n", "line 4 is '1 2'; expected the 3 numbers of a point" },
    { fields + "DATA ascii\n1 2 3 4\n", "line 4 is '1 2 3 4'; expected the 3 numbers of a point" },
    { fields + "DATA ascii\n1 2 x\n", "line 4 is '1 2 x'; expected the 3 numbers of a point" },
    { Header("1", "ascii") + "1 2 3 65536\n", "expected the 4 numbers of a point" },
    { "FIELDS x y z\nPOINTS 2000000000\nDATA ascii\n1 2 3\n",
      "the file ends after 1 of the 2000000000 points that it promises" },
    { Header("1000000000000000", "binary") + Binary,
      "it has 28 bytes after its header, but its 1000000000000000 points" },
    { Header("2", "binary") + Binary.substr(1),
      "it has 27 bytes after its header, but its 2 points need 28" },
    { Header("2", "binary_compressed"), "it has 0 bytes after its header" },
    { Header("3", "binary_compressed") + Compressed(packed, 28), "its 3 points need 42" },
    { Header("1000000", "binary_compressed") + Compressed(packed, 14000000),
      "become 1.4e+07; its 1000000 points" },
    { compressed(packed).substr(0, compressed(packed).size() - 1),
      "29 bytes of compressed points become 28" },
    { compressed(Packed(ByField + "x")), "its compressed points are broken" },
    { compressed(Packed(ByField.substr(1))), "its compressed points are broken" },
    { compressed(std::string(1, '\x1F') + ByField), "its compressed points are broken" },
    { compressed(Packed("ab") + std::string("\xE0\x20", 2)), "its compressed points are broken" },
    { compressed(Packed("ab") + std::string("\xE0", 1)), "its compressed points are broken" },
    { compressed(Packed("ab") + std::string("\xE0\x11\x02", 3)), "its compressed points are broken" },
    { compressed(Packed("ab") + std::string("\xE0\x12\x01", 3)), "its compressed points are broken" },
    { "FIELDS x y z\nPOINTS 0\nDATA binary\n", "it holds no points" },
    { fields + "DATA ascii\nnan nan nan\n", "it holds no points" },
  };
  for (const auto& [text, words] : cases)
  {
    ExpectError({ "cannot read", words }, Put("Broken", text));
  }
}
