#include "ReadFile.h"

#include "Errors.h"
#include "Progress.h"
#include "VtkMessages.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <fstream>
#include <functional>

namespace ink::cli
{
namespace
{

/// Lets a reader do a part of its work. \throw Failure if it complains
void run(vtkAlgorithm* reader, const std::filesystem::path& file, const std::function<void()>& part)
{
  const VtkMessages messages;
  try
  {
    part();
  }
  catch (const std::exception& exception)
  {
    // A header with senseless sizes asks for more memory than there is.
    failToRead(file, exception.what());
  }
  std::string problem = messages.error();
  if (problem.empty() && reader->GetErrorCode() != 0)
  {
    problem = "VTK error " + std::to_string(reader->GetErrorCode());
  }
  if (!problem.empty())
  {
    failToRead(file, problem);
  }
}

/// Of the point scalars that a reader announces.
std::uint64_t announcedBytes(vtkAlgorithm* reader)
{
  vtkInformation* info = reader->GetOutputInformation(0);
  const int* extent = info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(
    info, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  if (!extent || !scalars || !scalars->Has(vtkDataObject::FIELD_ARRAY_TYPE()))
  {
    return 0;
  }
  double bytes = vtkDataArray::GetDataTypeSize(scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE()));
  if (scalars->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()))
  {
    bytes *= scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
  }
  for (int i = 0; i < 3; ++i)
  {
    bytes *= std::max(static_cast<double>(extent[2 * i + 1]) - extent[2 * i] + 1.0, 0.0);
  }
  // A sparse grid's box may have more voxels than there are numbers of 64 bits.
  constexpr double moreThanAnyMachine = 1LL << 60;
  return static_cast<std::uint64_t>(std::min(bytes, moreThanAnyMachine));
}

} // namespace

void failToRead(const std::filesystem::path& file, const std::string& reason)
{
  throw Failure("cannot read '" + file.string() + "': " + reason);
}

void requireMemory(const std::filesystem::path& file, std::uint64_t bytes, const Memory& memory)
{
  if (bytes > memory.limit)
  {
    failToRead(file,
      "its voxels take " + memoryText(bytes) + ": expected --memory of at least that, found " +
        memoryText(memory.limit) +
        " (uncompressed NIfTI, NRRD, MetaImage, legacy VTK and raw files need not fit)");
  }
}

std::string contentsOf(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(std::filesystem::file_size(file)), '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
  {
    failToRead(file, "it was cut short while it was read");
  }
  return bytes;
}

void runReader(vtkAlgorithm* reader, const std::filesystem::path& file, Progress& progress)
{
  progress.step("reading " + file.filename().string(), reader);
  run(reader, file, [reader] { reader->Update(); });
}

std::uint64_t readHeader(vtkAlgorithm* reader, const std::filesystem::path& file, Progress& progress)
{
  progress.step("reading " + file.filename().string());
  run(reader, file, [reader] { reader->UpdateInformation(); });
  return announcedBytes(reader);
}

void runVolumeReader(
  vtkAlgorithm* reader, const std::filesystem::path& file, const Memory& memory, Progress& progress)
{
  const std::uint64_t bytes = readHeader(reader, file, progress);
  requireMemory(file, bytes, memory);
  runReader(reader, file, progress);
}

} // namespace ink::cli
