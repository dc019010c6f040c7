// SPDX-License-Identifier: BSD-3-Clause
#include "ReadFile.h"

#include "Progress.h"
#include "RawVolume.h"
#include "VolumeSlices.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInkVolumeReader.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace ink::cli
{
namespace
{

/// Where the voxels lie that a reader has not read.
vtkSmartPointer<vtkImageData> frameOf(vtkAlgorithm* reader)
{
  vtkInformation* info = reader->GetOutputInformation(0);
  auto frame = vtkSmartPointer<vtkImageData>::New();
  frame->SetExtent(info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  frame->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  frame->SetSpacing(info->Get(vtkDataObject::SPACING()));
  frame->SetDirectionMatrix(info->Get(vtkDataObject::DIRECTION()));
  return frame;
}

} // namespace

Input readVolume(const std::filesystem::path& file, const std::optional<RawLayout>& raw, const Memory& memory,
  Progress& progress)
{
  vtkNew<vtkInkVolumeReader> reader;
  reader->SetFileName(file.c_str());
  if (raw)
  {
    reader->RawOn();
    reader->SetRawDimensions(raw->dimensions[0], raw->dimensions[1], raw->dimensions[2]);
    reader->SetRawScalarType(raw->type);
    reader->SetRawSpacing(raw->spacing[0], raw->spacing[1], raw->spacing[2]);
    reader->SetRawBigEndian(raw->bigEndian);
  }
  readHeader(reader, file, progress);

  Input input;
  const auto bytes = static_cast<std::uint64_t>(reader->GetMemorySize());
  if (const io::RawVolume* voxels = reader->GetStoredVoxels(); voxels && bytes > memory.forWholeVolume())
  {
    input.volume = std::make_shared<VolumeSlices>(frameOf(reader), *voxels, memory);
  }
  else
  {
    requireMemory(file, bytes, memory);
    runReader(reader, file, progress);
    input.data = reader->GetOutput();
  }
  input.format = reader->GetFormat();
  input.components = reader->GetNumberOfFileComponents();
  takeNotes(reader.Get(), input);
  return input;
}

} // namespace ink::cli
