// SPDX-License-Identifier: BSD-3-Clause
#include "ReadFile.h"

#include "Errors.h"
#include "Progress.h"
#include "VtkMessages.h"

#include "vtkAlgorithm.h"
#include "vtkInkCrop.h"
#include "vtkNew.h"
#include "vtkTrivialProducer.h"

#include <cctype>
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

/// @throws Failure with what cropping complained about
void requireNoProblem(const VtkMessages& messages)
{
  if (std::string problem = messages.error(); !problem.empty())
  {
    problem[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(problem[0])));
    throw Failure("--crop: " + problem);
  }
}

} // namespace

void failToRead(const std::filesystem::path& file, const std::string& reason)
{
  throw Failure("cannot read '" + file.string() + "': " + reason);
}

void requireMemory(const std::filesystem::path& file, std::uint64_t bytes, const InkMemoryBudget& memory)
{
  if (bytes > memory.Limit)
  {
    failToRead(file,
      "its voxels take " + InkFormatMemory(bytes) + ": expected --memory of at least that, found " +
        InkFormatMemory(memory.Limit) +
        " (uncompressed NIfTI, NRRD, MetaImage, MRC, TIFF, legacy VTK and raw files need not fit)");
  }
}

void requireNoSpacing(const InputOptions& options)
{
  if (options.spacing != std::array<double, 3>{})
  {
    throw UsageError("--spacing: only images of voxels have distances between them, '" +
      options.file.string() + "' is none");
  }
}

vtkSmartPointer<vtkAlgorithm> cropped(vtkAlgorithm* source, const InputOptions& options)
{
  if (!options.crop)
  {
    return source;
  }
  vtkNew<vtkInkCrop> crop;
  crop->SetBox(options.crop->data());
  crop->SetInputConnection(source->GetOutputPort());
  const VtkMessages messages;
  crop->UpdateInformation();
  requireNoProblem(messages);
  return crop;
}

vtkSmartPointer<vtkDataObject> cropped(vtkDataObject* data, const InputOptions& options)
{
  if (!options.crop)
  {
    return data;
  }
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(data);
  const vtkSmartPointer<vtkAlgorithm> crop = cropped(producer, options);
  const VtkMessages messages;
  crop->Update();
  requireNoProblem(messages);
  return crop->GetOutputDataObject(0);
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
