// SPDX-License-Identifier: BSD-3-Clause
// Volumes whose values are known, in files that VTK's writers wrote.
#ifndef VolumeTestFiles_h
#define VolumeTestFiles_h

#include "ReadError.h"

#include "vtkImageData.h"
#include "vtkMetaImageWriter.h"
#include "vtkNIFTIImageWriter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkShortArray.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredPoints.h"
#include "vtkStructuredPointsWriter.h"
#include "vtkXMLImageDataWriter.h"
#include "vtk_zlib.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace VolumeTestFiles
{

constexpr int Size[3] = { 7, 5, 6 };

/// Of the first component.
constexpr short ValueAt(int x, int y, int z)
{
  return static_cast<short>(1000 * x - 100 * y + z);
}

/// @param Image vtkImageData or vtkStructuredPoints
template <class Image = vtkImageData>
vtkSmartPointer<Image> Volume(int components = 1)
{
  auto image = vtkSmartPointer<Image>::New();
  image->SetDimensions(Size[0], Size[1], Size[2]);
  image->SetSpacing(1.0, 2.0, 0.5);
  vtkNew<vtkShortArray> values;
  values->SetName("density");
  values->SetNumberOfComponents(components);
  for (int z = 0; z < Size[2]; ++z)
  {
    for (int y = 0; y < Size[1]; ++y)
    {
      for (int x = 0; x < Size[0]; ++x)
      {
        for (int c = 0; c < components; ++c)
        {
          values->InsertNextValue(static_cast<short>(ValueAt(x, y, z) + 7 * c));
        }
      }
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// All values of an image, wherever it lies in the volume.
inline void ExpectValues(vtkImageData* image, const std::string& name)
{
  int extent[6];
  image->GetExtent(extent);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  ASSERT_TRUE(scalars) << name;
  ASSERT_EQ(scalars->GetNumberOfComponents(), 1) << name;
  ASSERT_EQ(scalars->GetNumberOfTuples(), image->GetNumberOfPoints()) << name;
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      for (int x = extent[0]; x <= extent[1]; ++x)
      {
        EXPECT_EQ(image->GetScalarComponentAsDouble(x, y, z, 0), ValueAt(x, y, z))
          << name << " at " << x << " " << y << " " << z;
      }
    }
  }
}

/// The bytes of the volume, each value with its most significant byte first if that is asked for.
inline std::string Bytes(bool bigEndian)
{
  std::string bytes;
  for (int z = 0; z < Size[2]; ++z)
  {
    for (int y = 0; y < Size[1]; ++y)
    {
      for (int x = 0; x < Size[0]; ++x)
      {
        const auto value = static_cast<unsigned short>(ValueAt(x, y, z));
        const char low = static_cast<char>(value & 0xff);
        const char high = static_cast<char>(value >> 8);
        bytes += bigEndian ? high : low;
        bytes += bigEndian ? low : high;
      }
    }
  }
  return bytes;
}

inline std::string Put(const std::string& name, const std::string& bytes)
{
  std::ofstream(name, std::ios::binary) << bytes;
  return name;
}

inline std::string Gzip(const std::string& name, const std::string& bytes)
{
  gzFile file = gzopen(name.c_str(), "wb");
  gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(file);
  return name;
}

/// A file without the last bytes of another one.
inline std::string CutShort(const std::string& file, const std::string& name, std::size_t bytes)
{
  const std::string all = ink::io::contentsOf(file);
  return Put(name, all.substr(0, all.size() - bytes));
}

template <class Writer>
std::string Write(const std::string& name, vtkDataObject* data, const auto& change)
{
  vtkNew<Writer> writer;
  writer->SetFileName(name.c_str());
  writer->SetInputData(data);
  change(writer.Get());
  writer->Write();
  return name;
}

/// One file of each format.
inline std::vector<std::string> All(const std::string& name)
{
  const auto volume = Volume();
  const auto nothing = [](auto*) {};
  return {
    Write<vtkMetaImageWriter>(name + ".mha", volume, [](auto* writer) { writer->SetCompression(false); }),
    Write<vtkMetaImageWriter>(
      name + "Packed.mha", volume, [](auto* writer) { writer->SetCompression(true); }),
    Write<vtkMetaImageWriter>(name + "3.mha", Volume(3), [](auto* writer) { writer->SetCompression(false); }),
    Write<vtkNIFTIImageWriter>(name + ".nii", volume, nothing),
    Write<vtkNIFTIImageWriter>(name + ".nii.gz", volume, nothing),
    Write<vtkXMLImageDataWriter>(name + ".vti", volume, nothing),
    Write<vtkXMLImageDataWriter>(name + "3.vti", Volume(3), nothing),
    Write<vtkStructuredPointsWriter>(
      name + ".vtk", Volume<vtkStructuredPoints>(), [](auto* writer) { writer->SetFileTypeToBinary(); }),
    Write<vtkStructuredPointsWriter>(
      name + "Text.vtk", Volume<vtkStructuredPoints>(), [](auto* writer) { writer->SetFileTypeToASCII(); }),
    Put(name + ".nrrd",
      "NRRD0004\ntype: short\ndimension: 3\nsizes: 7 5 6\nspacings: 1 2 0.5\nencoding: raw\nendian: big\n\n" +
        Bytes(true)),
  };
}

} // namespace VolumeTestFiles

#endif
