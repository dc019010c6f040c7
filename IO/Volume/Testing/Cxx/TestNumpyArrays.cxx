// SPDX-License-Identifier: BSD-3-Clause
// NumPy's arrays: every entry of the header that is used, and what is refused.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include <gtest/gtest.h>

#include <string>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

std::string Header(const std::string& dictionary, char version = 1)
{
  std::string all = "\x93NUMPY";
  all += { version, '\0', static_cast<char>(dictionary.size()), '\0' };
  return version == 1 ? all + dictionary : all + std::string(2, '\0') + dictionary;
}

/// The values of Volume().
std::string Array(const std::string& dictionary, bool bigEndian = false, char version = 1)
{
  return Header(dictionary, version) + Bytes(bigEndian);
}

const std::string Usual = "{'descr': '<i2', 'fortran_order': False, 'shape': (6, 5, 7), }\n";

TEST(NumpyArrays, OfEitherOrderOfAxesAndOfBytes)
{
  for (const std::string& file :
    {
      Put("NumpyArrays.npy", Array(Usual)),
      Put("NumpyArrays2.npy", Array(Usual, false, 2)),
      Put("NumpyArraysBig.npy", Array("{'descr': '>i2', 'fortran_order': False, 'shape': (6, 5, 7)}", true)),
      Put("NumpyArraysFortran.npy", Array("{'shape': (7,5,6), 'fortran_order': True, 'descr': '<i2'}")),
    })
  {
    const auto reader = UpdatedReaderOf(file);
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(image->GetNumberOfPoints(), 7 * 5 * 6) << file;
    EXPECT_EQ(image->GetScalarType(), VTK_SHORT);
    EXPECT_EQ(PositionOf(image, 1, 2, 3), (std::array<double, 3>{ 1.0, 2.0, 3.0 }));
    ExpectValues(image, file);
  }
  const auto part = ReaderOf("NumpyArrays.npy");
  const int extent[6] = { 2, 4, 1, 4, 3, 3 };
  part->UpdateExtent(extent);
  ExpectValues(part->GetOutput(), "part");
}

TEST(NumpyArrays, OfTypes)
{
  const auto first = [](const std::string& type, const std::string& bytes)
  {
    const auto reader = UpdatedReaderOf(Put("NumpyArraysType.npy",
      Header("{'descr': '" + type + "', 'fortran_order': False, 'shape': (2, 1, 1)}") + bytes));
    return reader->GetOutput()->GetScalarComponentAsDouble(0, 0, 1, 0);
  };
  EXPECT_EQ(first("|b1", std::string("\0\1", 2)), 1.0);
  EXPECT_EQ(first("|i1", "\1\xfe"), -2.0);
  EXPECT_EQ(first("<f2", std::string("\0\0\0\x42", 4)), 3.0);
  EXPECT_EQ(first(">f4", std::string("\0\0\0\0\x40\x40\0\0", 8)), 3.0);
  EXPECT_EQ(first("<i8", std::string(8, '\0') + std::string(8, '\xff')), -1.0);
}

TEST(NumpyArrays, HaveAFourthAxisOfComponents)
{
  const auto reader = UpdatedReaderOf(Put("NumpyArraysRgb.npy",
    Header("{'descr': '|u1', 'fortran_order': False, 'shape': (1, 1, 2, 3), }") + "\1\2\3\4\5\6"));
  EXPECT_EQ(reader->GetNumberOfFileComponents(), 3);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(1, 0, 0, 0), 4.0);
  // In Fortran's order one block after the other.
  const auto planes = UpdatedReaderOf(Put("NumpyArraysPlanes.npy",
    Header("{'descr': '|u1', 'fortran_order': True, 'shape': (2, 1, 1, 3), }") + "\1\2\3\4\5\6"));
  EXPECT_EQ(planes->GetNumberOfFileComponents(), 3);
  EXPECT_EQ(planes->GetOutput()->GetScalarComponentAsDouble(1, 0, 0, 0), 2.0);
}

TEST(NumpyArrays, AreReadCompressed)
{
  ExpectValues(UpdatedReaderOf(Gzip("NumpyArraysGzip.npy", Array(Usual)))->GetOutput(), "gzip");
}

TEST(NumpyArrays, OtherOnesAreRefused)
{
  const auto refuse = [](const std::string& bytes, const std::string& word) {
    ExpectRefused(Put("NumpyArraysRefused.npy", bytes), { "NumpyArraysRefused.npy", word });
  };
  const auto with = [](const std::string& descr, const std::string& shape)
  { return Array("{'descr': " + descr + ", 'fortran_order': False, 'shape': " + shape + ", }"); };
  refuse("no array", "no array of NumPy");
  refuse(Header(Usual, 2).replace(10, 1, "\1"), "its header has 65599 bytes");
  refuse(with("'<f2'", "(6, 5, 7, 3)"), "float16");
  refuse(Header(Usual).substr(0, 40), "before its header of 63 bytes");
  refuse(Array(Usual).substr(0, 400), "bytes");
  refuse(with("'<c8'", "(6, 5, 7)"), "'<c8'");
  refuse(with("'|O'", "(6, 5, 7)"), "'|O'");
  refuse(with("[('a', '<i2')]", "(6, 5, 7)"), "its values are ''");
  refuse(with("'<i2'", "(210,)"), "1 axes");
  refuse(with("'<i2'", "(6, 5, 7, 1, 1)"), "5 axes");
  refuse(with("'<i2'", "(6, 5, 7, 9)"), "4 axes");
  refuse(with("'<i2'", "(6, -5, 7)"), "(6, -5, 7)");
  refuse(with("'<i2'", "(0, 5, 7)"), "expected 1 or more");
  refuse(with("'<i2'", "6, 5, 7"), "0 axes");
}

} // namespace
