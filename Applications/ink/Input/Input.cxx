// SPDX-License-Identifier: BSD-3-Clause
#include "Input.h"

#include "Core/FormatNumber.h"
#include "Crop.h"
#include "Errors.h"
#include "ReadError.h"
#include "ReadFile.h"
#include "Series.h"
#include "VolumeSlices.h"

#include "vtkImageData.h"
#include "vtkInkMeshReader.h"
#include "vtkInkVolumeReader.h"

#include <algorithm>

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
  return list + " " + vtkInkMeshReader::GetFileExtensions();
}

Input read(const InputOptions& options, [[maybe_unused]] Wanted wanted, Progress& progress)
{
  const fs::path& file = options.file;
  io::checkExists(file);
  if (fs::is_directory(file))
  {
    return readVolume(file, {}, options.memory, progress);
  }
  if (options.raw)
  {
    return readVolume(file, options.raw, options.memory, progress);
  }
  const std::string suffix = io::suffixOf(file);
#ifdef INK_WITH_OPENVDB
  if (suffix == vdbSuffix)
  {
    return readVdb(file, options.grid, wanted, options.memory, progress);
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
  if (contains(vtkInkVolumeReader::GetFileExtensions(), suffix) ||
    vtkInkVolumeReader::IsDicomFile(file.c_str()))
  {
    return readVolume(file, {}, options.memory, progress);
  }
  if (contains(vtkInkMeshReader::GetFileExtensions(), suffix))
  {
    return readMesh(file, progress);
  }
  if (suffix == ".vtr" || suffix == ".vts" || suffix == ".vtu")
  {
    const std::string kind = suffix == ".vtr" ? "a rectilinear"
      : suffix == ".vts"                      ? "a structured"
                                              : "an unstructured";
    failToRead(file,
      "it is a file of " + kind +
        " grid; expected an image or a mesh: ParaView's filters Resample To Image and Extract Surface make "
        "them (.vti, "
        ".vtp), or VTK's vtkResampleToImage and vtkDataSetSurfaceFilter");
  }
  if (isSeries(file))
  {
    failToRead(file, "it is a series of files, which only 'ink render' takes; expected one file");
  }
  failToRead(file,
    "unknown type '" + suffix + "'; expected one of " + knownSuffixes() +
      ", a folder of DICOM files, or any file with --raw");
}

} // namespace

Input readInput(const InputOptions& options, Progress& progress, Wanted wanted)
{
  // What is cut out of a volume is cut out of its voxels.
  Input input = read(options, options.crop ? Wanted::Values : wanted, progress);
  if (options.crop)
  {
    crop(input, *options.crop);
  }
  if (auto* image = vtkImageData::SafeDownCast(input.data))
  {
    input.volume = std::make_shared<VolumeSlices>(image);
  }
  return input;
}

void requireSlices(const Input& input)
{
  if (!input.volume)
  {
    return;
  }
  const auto& dimensions = input.volume->dimensions();
  if (*std::min_element(dimensions.begin(), dimensions.end()) < 2)
  {
    throw Failure("the volume is a single slice, " + formatDimensions(dimensions.data()) +
      " voxels: expected two slices or more in each direction, so that there are surfaces between them");
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
