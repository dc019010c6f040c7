// SPDX-License-Identifier: BSD-3-Clause
// The one error of vtkInkMeshReader where it makes nothing of a file.
#ifndef MeshTestReading_h
#define MeshTestReading_h

#include "InkTestMessages.h"

#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkInkMeshReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace MeshTestReading
{

/// One message with these words, an error code, and an empty output. @param file empty: none is set
inline void ExpectError(const std::vector<std::string>& words, const std::string& file)
{
  vtkNew<vtkInkMeshReader> reader;
  vtkNew<InkTestMessages> messages;
  messages->Observe(reader);
  messages->Observe(reader->GetExecutive());
  reader->SetFileName(file.empty() ? nullptr : file.c_str());
  reader->Update();
  messages->Expect(file, words);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
  EXPECT_NE(reader->GetErrorCode(), vtkErrorCode::NoError) << file;
}

} // namespace MeshTestReading

#endif
