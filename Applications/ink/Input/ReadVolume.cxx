// SPDX-License-Identifier: BSD-3-Clause
#include "ReadFile.h"

#include "InkImageSlabs.h"
#include "Progress.h"

#include "vtkInkVolumeReader.h"
#include "vtkNew.h"

#include <algorithm>

namespace ink::cli
{

Input readVolume(const InputOptions& options, Progress& progress)
{
  vtkNew<vtkInkVolumeReader> reader;
  reader->SetFileName(options.file.c_str());
  reader->SetSpacing(options.spacing[0], options.spacing[1], options.spacing[2]);
  if (const std::optional<RawLayout>& raw = options.raw)
  {
    reader->RawOn();
    reader->SetRawDimensions(raw->dimensions[0], raw->dimensions[1], raw->dimensions[2]);
    reader->SetRawScalarType(raw->type);
    reader->SetRawBigEndian(raw->bigEndian);
  }
  readHeader(reader, options.file, progress);
  const vtkSmartPointer<vtkAlgorithm> source = cropped(reader, options);

  Input input;
  auto bytes = static_cast<std::uint64_t>(reader->GetMemorySize());
  if (options.crop)
  {
    bytes = std::min(bytes, InkImageSlabs::GetBytes(source->GetOutputInformation(0)));
  }
  if (reader->HasPlainVoxels() && bytes > options.memory.ForWholeImage())
  {
    input.image = source;
  }
  else
  {
    requireMemory(options.file, bytes, options.memory);
    runReader(source, options.file, progress);
    input.data = source->GetOutputDataObject(0);
  }
  input.format = reader->GetFormat();
  input.components = reader->GetNumberOfFileComponents();
  takeNotes(reader.Get(), input);
  return input;
}

} // namespace ink::cli
