// SPDX-License-Identifier: BSD-3-Clause
#include "Input.h"

#include "Core/FormatNumber.h"
#include "Errors.h"
#include "ReadError.h"
#include "ReadFile.h"
#include "Vdb/VdbLibrary.h"

#include "FileSeries.h"
#include "InkImageGrid.h"

#include "vtkImageData.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkMeshReader.h"
#include "vtkInkVolumeReader.h"
#include "vtkNew.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

constexpr const char* vdbSuffix = ".vdb";

/// Whether a list of words has this one.
bool contains(const std::string& words, const std::string& word)
{
  return (" " + words + " ").find(" " + word + " ") != std::string::npos;
}

std::string knownSuffixes()
{
  std::string list = vtkInkVolumeReader::GetFileExtensions();
#ifdef INK_WITH_OPENVDB
  list += std::string(" ") + vdbSuffix;
#endif
  std::istringstream meshes(vtkInkMeshReader::GetFileExtensions());
  for (std::string suffix; meshes >> suffix;)
  {
    list += contains(list, suffix) ? "" : " " + suffix;
  }
  return list;
}

Input read(const InputOptions& options, [[maybe_unused]] Wanted wanted, Progress& progress)
{
  const fs::path& file = options.file;
  io::checkExists(file);
  if (fs::is_directory(file))
  {
    return readVolume(options, progress);
  }
  if (options.raw)
  {
    return readVolume(options, progress);
  }
  const std::string suffix = io::suffixOf(file);
#ifdef INK_WITH_OPENVDB
  if (suffix == vdbSuffix)
  {
    requireNoSpacing(options);
    // What is cut out of a volume is cut out of its voxels.
    return vdbLibrary().read(options, options.crop ? Wanted::Values : wanted, progress);
  }
#else
  if (suffix == vdbSuffix)
  {
    failToRead(file, "this ink was built without OpenVDB");
  }
#endif
  if (!options.grid.empty())
  {
    throw UsageError("--grid: only OpenVDB files have grids, '" + file.string() + "' is none");
  }
  // Legacy VTK files of both have one suffix.
  if (suffix == ".vtk" && vtkNew<vtkInkMeshReader>()->CanReadFile(file.c_str()))
  {
    return readMesh(options, progress);
  }
  if (contains(vtkInkVolumeReader::GetFileExtensions(), suffix) ||
    vtkInkVolumeReader::IsDicomFile(file.c_str()))
  {
    return readVolume(options, progress);
  }
  if (contains(vtkInkMeshReader::GetFileExtensions(), suffix))
  {
    return readMesh(options, progress);
  }
  if (io::isSeries(file))
  {
    failToRead(file, "it is a series of files, which only 'ink render' takes; expected one file");
  }
  failToRead(file,
    "unknown type '" + suffix + "'; expected one of " + knownSuffixes() +
      ", a folder of DICOM or TIFF files, or any file with --raw");
}

} // namespace

Input readInput(const InputOptions& options, Progress& progress, Wanted wanted)
{
  Input input = read(options, wanted, progress);
  if (vtkImageData::SafeDownCast(input.data))
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(input.data);
    input.image = producer;
  }
  if (input.image)
  {
    vtkNew<vtkInkIsoSurfaceSampler> sampler;
    sampler->SetInputConnection(input.image->GetOutputPort());
    sampler->SetMaximumMemory(options.memory.GetMebibytes());
    input.sampler = sampler;
  }
  return input;
}

vtkSmartPointer<vtkImageData> frameOf(const Input& input)
{
  if (!input.image)
  {
    return nullptr;
  }
  input.image->UpdateInformation();
  return InkMakeFrame(input.image->GetOutputInformation(0));
}

void requireSlices(const Input& input)
{
  const vtkSmartPointer<vtkImageData> frame = frameOf(input);
  if (!frame)
  {
    return;
  }
  const int* dimensions = frame->GetDimensions();
  if (*std::min_element(dimensions, dimensions + 3) < 2)
  {
    // What the file's notes say may be why.
    throw Failure(std::accumulate(input.notes.begin(), input.notes.end(),
      "the volume is a single slice, " + formatDimensions(dimensions) +
        " voxels: expected two slices or more in each direction, so that there are surfaces between them",
      [](const std::string& message, const std::string& note) { return message + "; " + note; }));
  }
}

void takeSurfaceValue(const Input& input, std::vector<double>& isoValues, std::vector<std::string>& notes)
{
  if (isoValues.empty() && input.surfaceValue)
  {
    isoValues.push_back(*input.surfaceValue);
    notes.push_back("iso-value " + formatNumber(*input.surfaceValue) + ": that of the file's surface");
  }
}

} // namespace ink::cli
