// SPDX-License-Identifier: BSD-3-Clause
// What vtkInkVolumeReader makes of a file, and the one error where it makes nothing.
#ifndef VolumeTestReading_h
#define VolumeTestReading_h

#include "InkTestMessages.h"

#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInkVolumeReader.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace VolumeTestReading
{

inline vtkSmartPointer<vtkInkVolumeReader> ReaderOf(const std::string& file)
{
  auto reader = vtkSmartPointer<vtkInkVolumeReader>::New();
  reader->SetFileName(file.c_str());
  return reader;
}

/// One that has read it.
inline vtkSmartPointer<vtkInkVolumeReader> UpdatedReaderOf(const std::string& file)
{
  auto reader = ReaderOf(file);
  reader->Update();
  return reader;
}

/// Where a voxel is.
inline std::array<double, 3> PositionOf(vtkImageData* image, int x, int y, int z)
{
  std::array<double, 3> position;
  const int index[3] = { x, y, z };
  image->TransformIndexToPhysicalPoint(index, position.data());
  return position;
}

/// One message with these words, and an empty output.
inline void ExpectRefused(const std::string& file, const std::vector<std::string>& words)
{
  vtkNew<vtkInkVolumeReader> reader;
  vtkNew<InkTestMessages> messages;
  messages->Observe(reader);
  messages->Observe(reader->GetExecutive());
  reader->SetFileName(file.c_str());
  reader->Update();
  messages->Expect(words.front(), words);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << words.front();
}

} // namespace VolumeTestReading

#endif
