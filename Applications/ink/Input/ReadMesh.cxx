// SPDX-License-Identifier: BSD-3-Clause
#include "ReadFile.h"

#include "Progress.h"

#include "vtkInkMeshReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace ink::cli
{

Input readMesh(const InputOptions& options, Progress& progress)
{
  requireNoSpacing(options);
  vtkNew<vtkInkMeshReader> reader;
  reader->SetFileName(options.file.c_str());
  runReader(reader, options.file, progress);
  Input input;
  input.data = cropped(reader->GetOutput(), options);
  input.format = reader->GetFormat();
  takeNotes(reader.Get(), input);
  return input;
}

} // namespace ink::cli
