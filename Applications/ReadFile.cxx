#include "ReadFile.h"

#include "Errors.h"
#include "Progress.h"
#include "VtkMessages.h"

#include <exception>

namespace ink::cli
{

void failToRead(const std::filesystem::path& file, const std::string& reason)
{
  throw Failure("cannot read '" + file.string() + "': " + reason);
}

void runReader(
  vtkAlgorithm* reader, const std::filesystem::path& file, Progress& progress, bool warningsCount)
{
  progress.step("reading " + file.filename().string(), reader);
  const VtkMessages messages;
  try
  {
    reader->Update();
  }
  catch (const std::exception& exception)
  {
    // A header with senseless sizes asks for more memory than there is.
    failToRead(file, exception.what());
  }
  std::string problem = messages.error();
  if (problem.empty() && warningsCount)
  {
    problem = messages.warning();
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

} // namespace ink::cli
