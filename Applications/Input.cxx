#include "Input.h"

#include "Errors.h"
#include "ReadFile.h"
#include "Series.h"
#include "Text.h"
#include "VolumeSlices.h"

#include "vtkImageData.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

constexpr std::array volumeSuffixes{ ".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".vti", ".vtk" };
constexpr std::array meshSuffixes{ ".ply", ".obj", ".stl", ".vtp", ".xyz" };

/// The suffix in small letters, ".nii.gz" being one.
std::string suffixOf(const fs::path& file)
{
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  const fs::path lower(name);
  const std::string last = lower.extension().string();
  return last == ".gz" ? lower.stem().extension().string() + last : last;
}

template <std::size_t N>
bool contains(const std::array<const char*, N>& suffixes, const std::string& suffix)
{
  return std::find(suffixes.begin(), suffixes.end(), suffix) != suffixes.end();
}

#ifdef INK_WITH_OPENVDB
constexpr std::array vdbSuffixes{ ".vdb" };
#else
constexpr std::array<const char*, 0> vdbSuffixes{};
#endif

std::string knownSuffixes()
{
  std::string list;
  for (const char* suffix : volumeSuffixes)
  {
    list += std::string(suffix) + " ";
  }
  for (const char* suffix : vdbSuffixes)
  {
    list += std::string(suffix) + " ";
  }
  for (const char* suffix : meshSuffixes)
  {
    list += std::string(suffix) + " ";
  }
  list.pop_back();
  return list;
}

Input read(const InputOptions& options, [[maybe_unused]] Wanted wanted, Progress& progress)
{
  const fs::path& file = options.file;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status))
  {
    failToRead(
      file, error && error != std::errc::no_such_file_or_directory ? error.message() : "no such file");
  }
  if (fs::is_directory(status))
  {
    return readDicomFolder(file, options.memory, progress);
  }
  if (!fs::is_regular_file(status))
  {
    failToRead(file, "it is neither a regular file nor a directory");
  }
  if (!std::ifstream(file).is_open())
  {
    failToRead(file, "permission denied");
  }
  if (fs::file_size(file) == 0)
  {
    failToRead(file, "the file is empty");
  }
  if (options.raw)
  {
    return readRawVolume(file, *options.raw, options.memory, progress);
  }
  const std::string suffix = suffixOf(file);
#ifdef INK_WITH_OPENVDB
  if (contains(vdbSuffixes, suffix))
  {
    return readVdb(file, options.grid, wanted, options.memory, progress);
  }
#else
  if (suffix == ".vdb")
  {
    failToRead(file, "this ink was built without OpenVDB");
  }
#endif
  if (!options.grid.empty())
  {
    throw UsageError("--grid: only OpenVDB files have grids, '" + file.string() + "' is none");
  }
  if (contains(volumeSuffixes, suffix))
  {
    return readVolume(file, suffix, options.memory, progress);
  }
  if (contains(meshSuffixes, suffix))
  {
    return suffix == ".xyz" ? readPoints(file, progress) : readMesh(file, suffix, progress);
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
  Input input = read(options, wanted, progress);
  if (auto* image = vtkImageData::SafeDownCast(input.data))
  {
    input.volume = std::make_shared<VolumeSlices>(image);
  }
  return input;
}

void takeSurfaceValue(const Input& input, std::vector<double>& isoValues, std::vector<std::string>& notes)
{
  if (isoValues.empty() && input.surfaceValue)
  {
    isoValues.push_back(*input.surfaceValue);
    notes.push_back("iso-value " + text(*input.surfaceValue) + ": that of the file's surface");
  }
}

} // namespace ink::cli
