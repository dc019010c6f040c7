// SPDX-License-Identifier: BSD-3-Clause
#include "Core/FormatNumber.h"
#include "ReadError.h"

#include "DicomFile.h"
#include "VolumeHeader.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

void throwProblem(const DicomFile& file)
{
  if (!file.problem.empty())
  {
    throw ReadError(file.problem);
  }
}

/// The DICOM files of a folder that have pixels, by their series. Those that do not even tell their series
/// are left out, which is noted.
std::map<std::string, std::vector<DicomFile>> findSeries(
  const fs::path& folder, std::vector<std::string>& notes)
{
  std::map<std::string, std::vector<DicomFile>> all;
  std::vector<DicomFile> unknown;
  bool found = false;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    std::optional<DicomFile> file =
      entry.is_regular_file() ? DicomFile::read(entry.path()) : std::optional<DicomFile>();
    found = found || file;
    if (file && !file->problem.empty() && file->series.empty())
    {
      unknown.push_back(std::move(*file));
    }
    else if (file && (file->pixelBytes > 0 || !file->problem.empty()))
    {
      const std::string series = file->series;
      all[series].push_back(std::move(*file));
    }
  }
  if (!unknown.empty())
  {
    const auto first = std::min_element(
      unknown.begin(), unknown.end(), [](const DicomFile& a, const DicomFile& b) { return a.path < b.path; });
    if (all.empty())
    {
      throwProblem(*first);
    }
    notes.push_back(
      std::to_string(unknown.size()) + " of the folder's DICOM files left out: " + first->problem);
  }
  if (all.empty())
  {
    failToRead(folder, found ? "its DICOM files hold no pixels" : "it is a directory without DICOM files");
  }
  return all;
}

/// The series with most pictures; of several, the first by its name.
std::vector<DicomFile> readLargestSeries(const fs::path& folder, std::vector<std::string>& notes)
{
  auto all = findSeries(folder, notes);
  const auto largest = std::max_element(
    all.begin(), all.end(), [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  if (all.size() > 1)
  {
    notes.push_back("it holds " + std::to_string(all.size()) + " series; the one of " +
      std::to_string(largest->second.size()) + " slices is used");
  }
  return std::move(largest->second);
}

/// A file of several pictures, or those of its folder that belong to its series.
std::vector<DicomFile> readSeriesOf(const fs::path& path, std::vector<std::string>& notes)
{
  std::optional<DicomFile> file = DicomFile::read(path);
  if (!file)
  {
    failToRead(path, "it is no DICOM file");
  }
  throwProblem(*file);
  if (file->pixelBytes == 0)
  {
    failToRead(path, "it is a DICOM file without pixels");
  }
  if (file->frames > 1 || file->series.empty())
  {
    return { std::move(*file) };
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<DicomFile> series = std::move(findSeries(folder, notes)[file->series]);
  if (series.size() > 1)
  {
    notes.push_back(
      "it is one of " + std::to_string(series.size()) + " slices in its folder; all of them are read");
  }
  return series;
}

/// Plain pixels, as many as the file has to have.
/// @param alone whether the file is the whole volume
void check(const DicomFile& file, bool alone)
{
  throwProblem(file);
  // All other syntaxes but three are compressed.
  constexpr std::string_view plain = "1.2.840.10008.1.2";
  const std::string& syntax = file.transferSyntax;
  if (!syntax.empty() && syntax != plain && syntax != std::string(plain) + ".1" &&
    syntax != std::string(plain) + ".2")
  {
    failToRead(file.path, "its pixels are compressed (transfer syntax " + syntax + "); expected plain ones");
  }
  if (file.rows < 1 || file.columns < 1 || file.components < 1 || file.frames < 1 ||
    (file.frames > 1 && !alone))
  {
    failToRead(file.path,
      "it says " + std::to_string(file.rows) + " rows, " + std::to_string(file.columns) + " columns, " +
        std::to_string(file.components) + " components and " + std::to_string(file.frames) +
        " frames; expected 1 or more, and one frame in each file of a series");
  }
  if (file.bits != 8 && file.bits != 16 && file.bits != 32)
  {
    failToRead(file.path, "its pixels have " + std::to_string(file.bits) + " bits; expected 8, 16 or 32");
  }
  const std::uint64_t size = fs::file_size(file.path);
  const std::uint64_t needed = static_cast<std::uint64_t>(file.rows) *
    static_cast<std::uint64_t>(file.columns) * static_cast<std::uint64_t>(file.components) *
    static_cast<std::uint64_t>(file.frames) * static_cast<std::uint64_t>(file.bits / 8);
  if (size - std::min(size, file.pixelOffset) < needed || file.pixelBytes < needed)
  {
    failToRead(file.path, "the file ends before its " + std::to_string(needed) + " bytes of pixels do");
  }
}

int typeOf(const DicomFile& file)
{
  switch (file.bits)
  {
    case 8:
      return file.isSigned ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
    case 16:
      return file.isSigned ? VTK_SHORT : VTK_UNSIGNED_SHORT;
    default:
      return file.isSigned ? VTK_INT : VTK_UNSIGNED_INT;
  }
}

/// Where a slice lies along what is at right angles to the slices, else its number.
void sortSlices(std::vector<DicomFile>& files)
{
  double normal[3];
  vtkMath::Cross(files.front().row, files.front().column, normal);
  const bool hasPosition =
    std::all_of(files.begin(), files.end(), [](const DicomFile& file) { return file.hasPosition; });
  for (DicomFile& file : files)
  {
    file.number = hasPosition ? vtkMath::Dot(file.position, normal) : file.number;
  }
  std::sort(files.begin(), files.end(),
    [](const DicomFile& a, const DicomFile& b)
    { return a.number != b.number ? a.number < b.number : a.path < b.path; });
}

/// Notes it if sorted slices are not as far from each other as from the next, where one is missing, say.
void noteUnevenSlices(const std::vector<DicomFile>& files, double distance, std::vector<std::string>& notes)
{
  constexpr double tolerance = 0.05;
  double least = distance;
  double most = distance;
  for (std::size_t i = 1; i < files.size(); ++i)
  {
    const double between = files[i].number - files[i - 1].number;
    least = std::min(least, between);
    most = std::max(most, between);
  }
  if (most - least > tolerance * distance)
  {
    notes.push_back("its slices lie " + formatNumber(least) + " to " + formatNumber(most) +
      " apart; they are taken as " + formatNumber(distance) + " apart");
  }
}

} // namespace

VolumeHeader readDicomHeaders(const fs::path& path)
{
  VolumeHeader header;
  std::vector<DicomFile> files =
    fs::is_directory(path) ? readLargestSeries(path, header.notes) : readSeriesOf(path, header.notes);
  header.format = files.size() > 1 || fs::is_directory(path) ? "DICOM series" : "DICOM";
  sortSlices(files);
  const DicomFile& first = files.front();
  RawVolume& voxels = header.voxels;
  for (const DicomFile& file : files)
  {
    check(file, files.size() == 1);
    if (file.rows != first.rows || file.columns != first.columns || file.components != first.components ||
      typeOf(file) != typeOf(first))
    {
      failToRead(file.path,
        "its picture has another size or type than that in '" + first.path.string() +
          "'; expected slices of one volume");
    }
    voxels.files.push_back(file.path);
    voxels.offsets.push_back(file.pixelOffset);
    header.sliceScales.push_back(file.scale);
  }
  voxels.dimensions[0] = first.columns;
  voxels.dimensions[1] = first.rows;
  voxels.dimensions[2] = files.size() > 1 ? static_cast<int>(files.size()) : first.frames;
  voxels.type = typeOf(first);
  voxels.components = first.separatePlanes ? 1 : first.components;
  voxels.setBigEndian(first.bigEndian);
  header.components = first.components;
  header.scale = first.scale;
  const auto isFirst = [&](const ValueScale& scale) { return scale == first.scale; };
  if (std::all_of(header.sliceScales.begin(), header.sliceScales.end(), isFirst))
  {
    header.sliceScales.clear();
  }

  double steps[9];
  double normal[3];
  vtkMath::Cross(first.row, first.column, normal);
  std::copy_n(first.row, 3, steps);
  std::copy_n(first.column, 3, steps + 3);
  std::copy_n(normal, 3, steps + 6);
  constexpr double sign[3] = { 1, 1, 1 };
  header.orientation.emplace(steps, first.position, sign);
  const bool hasPositions = files.size() > 1 && first.hasPosition;
  const double distance = hasPositions
    ? (files.back().number - first.number) / static_cast<double>(files.size() - 1)
    : first.distance > 0.0 ? first.distance
                           : first.thickness;
  if (hasPositions)
  {
    noteUnevenSlices(files, distance, header.notes);
  }
  header.spacing[0] = spacingOf(first.spacing[0]);
  header.spacing[1] = spacingOf(first.spacing[1]);
  header.spacing[2] = spacingOf(distance);
  return header;
}

} // namespace ink::io
