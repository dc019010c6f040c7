// SPDX-License-Identifier: BSD-3-Clause
#include "ReadFile.h"

#include "Errors.h"
#include "Progress.h"
#include "VtkMessages.h"

#include "vtkAlgorithm.h"

#include <exception>
#include <functional>

namespace ink::cli
{
namespace
{

/// Lets a reader do a part of its work. @throws Failure if it complains
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
  if (problem.starts_with("cannot read '"))
  {
    throw Failure(problem);
  }
  if (problem.empty() && reader->GetErrorCode() != 0)
  {
    problem = "VTK error " + std::to_string(reader->GetErrorCode());
  }
  if (!problem.empty())
  {
    failToRead(file, problem);
  }
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

void runReader(vtkAlgorithm* reader, const std::filesystem::path& file, Progress& progress)
{
  progress.step("reading " + file.filename().string(), reader);
  run(reader, file, [reader] { reader->Update(); });
}

void readHeader(vtkAlgorithm* reader, const std::filesystem::path& file, Progress& progress)
{
  progress.step("reading " + file.filename().string());
  run(reader, file, [reader] { reader->UpdateInformation(); });
}

} // namespace ink::cli
