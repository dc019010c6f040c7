// SPDX-License-Identifier: BSD-3-Clause
#include "ReadFile.h"

#include "Progress.h"

#include "vtkInkMeshReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace ink::cli
{

Input readMesh(const std::filesystem::path& file, Progress& progress)
{
  vtkNew<vtkInkMeshReader> reader;
  reader->SetFileName(file.c_str());
  runReader(reader, file, progress);
  Input input;
  input.data = reader->GetOutput();
  input.format = reader->GetFormat();
  takeNotes(reader.Get(), input);
  return input;
}

} // namespace ink::cli
