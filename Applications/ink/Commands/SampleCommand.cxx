// SPDX-License-Identifier: BSD-3-Clause
#include "SampleCommand.h"

#include "Errors.h"
#include "OutputFile.h"
#include "PointFile.h"
#include "PointStore.h"
#include "Progress.h"
#include "SampleMesh.h"
#include "WritablePoints.h"

#include "vtkPolyData.h"

#include <iostream>

namespace ink::cli
{

void sample(const SampleOptions& options)
{
  // What can fail soon should not fail late.
  const PointFormat format = pointFormatOf(options.output);
  const OutputFile output(options.output);

  Progress progress(options.quiet);
  const Input input = readInput(
    options.input, progress, options.volume.isoValues.empty() ? Wanted::Surface : Wanted::GivenSurfaces);
  PointStore points(options.input.memory.ForKeptPoints(), output.temporaryFolder());
  std::vector<std::string> notes = input.notes;
  requireSlices(input);
  if (input.isVolume())
  {
    if (options.meshOption)
    {
      throw UsageError(*options.meshOption +
        ": expected a mesh, found a volume, which has a point in each voxel that its surface crosses");
    }
    const auto keep = [&points](int surface, vtkPolyData* part) { points.add(surface, part); };
    const auto more = sampleVolume(input, options.volume, options.input.memory, keep, progress);
    notes.insert(notes.end(), more.begin(), more.end());
  }
  else
  {
    if (!options.volume.isoValues.empty())
    {
      throw UsageError("--iso: a mesh has no iso-values, only volumes have");
    }
    const vtkSmartPointer<vtkPolyData> samples =
      sampleMesh(vtkPolyData::SafeDownCast(input.data), options.mesh, notes, progress);
    points.add(0, writablePoints(samples, format, notes));
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
    std::cerr << "ink: wrote " << options.output.string() << ": " << points.size() << " points\n";
  }
}

} // namespace ink::cli
