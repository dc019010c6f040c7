#include "SampleCommand.h"

#include "Errors.h"
#include "OutputFile.h"
#include "PointFile.h"
#include "PointStore.h"
#include "Progress.h"
#include "SampleMesh.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <iostream>
#include <limits>

namespace ink::cli
{

void sample(const SampleOptions& options)
{
  // What can fail soon should not fail late.
  const PointFormat format = pointFormatOf(options.output);
  const OutputFile output(options.output);

  Progress progress(options.quiet);
  const Input input = readInput(options.input, progress);
  PointStore points(std::numeric_limits<std::uint64_t>::max(), output.temporaryFolder());
  std::vector<std::string> notes = input.notes;
  if (auto* image = vtkImageData::SafeDownCast(input.data))
  {
    const auto keep = [&points](int surface, vtkPolyData* part) { points.add(surface, part); };
    const auto more = sampleVolume(image, options.volume, keep, progress);
    notes.insert(notes.end(), more.begin(), more.end());
  }
  else
  {
    if (!options.volume.isoValues.empty())
    {
      throw UsageError("--iso: a mesh has no iso-values, only volumes have");
    }
    sampleMesh(vtkPolyData::SafeDownCast(input.data), points, progress);
  }
  progress.step("writing " + options.output.filename().string());
  writePoints(points, format, output);
  progress.finish();

  if (!options.quiet)
  {
    for (const std::string& note : notes)
    {
      std::cerr << "ink: " << note << '\n';
    }
  }
}

} // namespace ink::cli
