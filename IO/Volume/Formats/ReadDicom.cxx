// SPDX-License-Identifier: BSD-3-Clause
#include "Core/FormatNumber.h"
#include "ReadError.h"

#include "DicomFile.h"
#include "DicomPixels.h"
#include "VolumeHeader.h"

#include "vtkMath.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
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

/// As far as there are bytes for them.
std::uint64_t countFrames(const std::vector<DicomFile>& files)
{
  return std::accumulate(files.begin(), files.end(), std::uint64_t(0),
    [](std::uint64_t sum, const DicomFile& file)
    {
      const std::uint64_t least = file.isCompressed() ? 1 : std::max<std::uint64_t>(file.frameBytes(), 1);
      return sum +
        std::clamp<std::uint64_t>(static_cast<std::uint64_t>(std::max(file.frames, 1)), 1,
          std::max<std::uint64_t>(file.pixelBytes / least, 1));
    });
}

/// The series with most pictures; of several, the first by its name.
std::vector<DicomFile> readLargestSeries(const fs::path& folder, std::vector<std::string>& notes)
{
  auto all = findSeries(folder, notes);
  const auto largest = std::max_element(all.begin(), all.end(),
    [](const auto& a, const auto& b) { return countFrames(a.second) < countFrames(b.second); });
  if (all.size() > 1)
  {
    notes.push_back("it holds " + std::to_string(all.size()) + " series; the one of " +
      std::to_string(countFrames(largest->second)) + " slices is used");
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
  return std::move(findSeries(folder, notes)[file->series]);
}

void checkFrames(const DicomFile& file)
{
  throwProblem(file);
  // More are the tiles of a microscope's picture.
  constexpr int most = 1 << 16;
  if (file.frames < 1 || file.frames > most)
  {
    failToRead(
      file.path, "it says " + std::to_string(file.frames) + " frames; expected 1 to " + std::to_string(most));
  }
}

/// Pixels of a size and type that can be read, and as many as the file has to have.
void checkPixels(const DicomFile& file)
{
  if (file.rows < 1 || file.columns < 1 || file.components < 1)
  {
    failToRead(file.path,
      "it says " + std::to_string(file.rows) + " rows, " + std::to_string(file.columns) + " columns and " +
        std::to_string(file.components) + " components; expected 1 or more");
  }
  if (file.bits != 8 && file.bits != 16 && file.bits != 32)
  {
    failToRead(file.path, "its pixels have " + std::to_string(file.bits) + " bits; expected 8, 16 or 32");
  }
  if (file.isCompressed())
  {
    DicomPixels{ file };
    return;
  }
  const std::uint64_t size = fs::file_size(file.path);
  const std::uint64_t needed = file.frameBytes() * static_cast<std::uint64_t>(file.frames);
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

/// One picture of a series.
struct Slice
{
  const DicomFile* file; ///< one of those of the series, which lie in the order of their numbers
  std::size_t number;    ///< in its file
  DicomFrame frame;
  double along = 0.0; ///< where it lies along what is at right angles to the slices, else when it was taken
};

/// Adds the pictures of a file.
void addSlices(const DicomFile& file, std::vector<Slice>& slices, std::vector<std::string>& notes)
{
  const auto count = static_cast<std::size_t>(file.frames);
  const bool saysAll = file.ownFrames.size() == count;
  if (!saysAll && !file.ownFrames.empty())
  {
    notes.push_back("it says of " + std::to_string(file.ownFrames.size()) + " of its " +
      std::to_string(count) + " frames where they lie, which is not used");
  }
  double normal[3];
  vtkMath::Cross(file.shared.row, file.shared.column, normal);
  for (std::size_t number = 0; number < count; ++number)
  {
    Slice slice{ &file, number, saysAll ? file.ownFrames[number] : file.shared };
    if (file.offsets.size() == count)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        slice.frame.position[axis] += file.offsets[number] * normal[axis];
      }
    }
    // Where a file says one place for several frames, it is that of the first.
    slice.frame.hasPosition =
      slice.frame.hasPosition && (count == 1 || saysAll || file.offsets.size() == count);
    slices.push_back(slice);
  }
}

bool havePositions(const std::vector<Slice>& slices)
{
  return std::all_of(
    slices.begin(), slices.end(), [](const Slice& slice) { return slice.frame.hasPosition; });
}

bool isSpacingClose(const Slice& a, const Slice& b, int axis)
{
  constexpr double tolerance = 1e-3;
  return std::abs(a.frame.spacing[axis] - b.frame.spacing[axis]) <=
    tolerance * std::abs(a.frame.spacing[axis]);
}

/// Whether two pictures can be slices of one volume.
bool areAlike(const Slice& a, const Slice& b)
{
  // Of directions, as files round them.
  constexpr double tolerance = 1e-3;
  const auto isClose = [](double c, double d) { return std::abs(c - d) < tolerance; };
  const DicomFile& first = *a.file;
  const DicomFile& second = *b.file;
  return first.rows == second.rows && first.columns == second.columns &&
    first.components == second.components && first.separatePlanes == second.separatePlanes &&
    first.bits == second.bits && first.isSigned == second.isSigned &&
    first.isCompressed() == second.isCompressed() && first.bigEndian == second.bigEndian &&
    isSpacingClose(a, b, 0) && isSpacingClose(a, b, 1) &&
    std::equal(a.frame.row, a.frame.row + 3, b.frame.row, isClose) &&
    std::equal(a.frame.column, a.frame.column + 3, b.frame.column, isClose);
}

/// Leaves out pictures that are unlike the most, as those that a scan was planned on are.
/// @param named a file whose picture is one of those to keep; empty: whichever
void keepMostAlike(std::vector<Slice>& slices, const fs::path& named, std::vector<std::string>& notes)
{
  std::vector<std::vector<Slice>> kinds;
  for (const Slice& slice : slices)
  {
    const auto kind = std::find_if(kinds.begin(), kinds.end(),
      [&](const std::vector<Slice>& one) { return areAlike(one.front(), slice); });
    (kind != kinds.end() ? *kind : kinds.emplace_back()).push_back(slice);
  }
  const auto rank = [&](const std::vector<Slice>& kind)
  {
    const bool hasNamed = std::any_of(kind.begin(), kind.end(),
      [&](const Slice& slice) { return slice.file->path.filename() == named.filename(); });
    return std::pair(hasNamed, kind.size());
  };
  const auto kept = std::max_element(
    kinds.begin(), kinds.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  if (kinds.size() > 1)
  {
    notes.push_back(std::to_string(slices.size() - kept->size()) + " of its " +
      std::to_string(slices.size()) + " pictures have another size, type, spacing or direction than the " +
      std::to_string(kept->size()) + " that are used");
  }
  slices = std::move(*kept);
}

/// Sorts slices by where they lie; if they do not say that, by their numbers.
void sortSlices(std::vector<Slice>& slices)
{
  double normal[3];
  vtkMath::Cross(slices.front().frame.row, slices.front().frame.column, normal);
  const bool byPosition = havePositions(slices);
  for (Slice& slice : slices)
  {
    slice.along = byPosition ? vtkMath::Dot(slice.frame.position, normal) : slice.file->number;
  }
  std::stable_sort(
    slices.begin(), slices.end(), [](const Slice& a, const Slice& b) { return a.along < b.along; });
}

/// Of sorted slices at one place, as a scan over time has them, keeps that with the lowest number.
void keepFirstOfPlace(std::vector<Slice>& slices, std::vector<std::string>& notes)
{
  // Of a pixel's size, but no more than files round in millimeters.
  const double tolerance = std::min(0.05 * slices.front().frame.spacing[0], 0.01);
  const std::size_t all = slices.size();
  std::vector<Slice> kept;
  for (const Slice& slice : slices)
  {
    if (kept.empty() || slice.along - kept.back().along > tolerance)
    {
      kept.push_back(slice);
    }
    else if (std::tie(slice.file, slice.number) < std::tie(kept.back().file, kept.back().number))
    {
      kept.back() = slice;
    }
  }
  slices = std::move(kept);
  if (slices.size() < all)
  {
    notes.push_back("its " + std::to_string(all) + " slices lie at " + std::to_string(slices.size()) +
      (slices.size() == 1 ? " place" : " places") + "; the first of each is used");
  }
}

/// From each of the sorted slices to the next.
std::vector<double> gapsBetween(const std::vector<Slice>& slices)
{
  std::vector<double> gaps;
  for (std::size_t i = 1; i < slices.size(); ++i)
  {
    gaps.push_back(slices[i].along - slices[i - 1].along);
  }
  return gaps;
}

double medianOf(std::vector<double> numbers)
{
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

/// Of sorted slices, leaves out those that lie far from most, as some of a scan's plan do.
void keepLongestRun(std::vector<Slice>& slices, std::vector<std::string>& notes)
{
  constexpr double far = 4.0; // usual distances; where slices are missing, it is still one volume
  const std::vector<double> gaps = gapsBetween(slices);
  if (gaps.size() < 2)
  {
    return;
  }
  const double farAway = far * medianOf(gaps);
  std::size_t longest = 0;
  std::size_t first = 0;
  for (std::size_t begin = 0, i = 0; i <= gaps.size(); ++i)
  {
    if (i == gaps.size() || gaps[i] > farAway)
    {
      const std::size_t count = i + 1 - begin;
      first = count > longest ? begin : first;
      longest = std::max(longest, count);
      begin = i + 1;
    }
  }
  if (longest < slices.size())
  {
    notes.push_back(std::to_string(slices.size() - longest) + " of its " + std::to_string(slices.size()) +
      " slices lie far from the others and are left out");
    const auto begin = slices.begin() + static_cast<std::ptrdiff_t>(first);
    slices = std::vector<Slice>(begin, begin + static_cast<std::ptrdiff_t>(longest));
  }
}

/// From slice to slice. Where it differs, as where one is missing, that is noted, and it is that of most, or
/// a mean.
double distanceOf(const std::vector<Slice>& slices, std::vector<std::string>& notes)
{
  const DicomFrame& first = slices.front().frame;
  const std::vector<double> gaps = gapsBetween(slices);
  if (gaps.empty() || !havePositions(slices))
  {
    const double distance = first.distance > 0.0 ? first.distance : first.thickness;
    if (!gaps.empty())
    {
      notes.push_back("it does not say where its pictures lie; they are taken as slices " +
        formatNumber(distance) + " apart");
    }
    return distance;
  }
  constexpr double tolerance = 0.05;
  constexpr double most = 0.75;
  const double median = medianOf(gaps);
  const auto usual = std::count_if(
    gaps.begin(), gaps.end(), [&](double gap) { return std::abs(gap - median) <= tolerance * median; });
  const double mean = (slices.back().along - slices.front().along) / static_cast<double>(slices.size() - 1);
  const double distance = usual < static_cast<std::ptrdiff_t>(gaps.size()) &&
      static_cast<double>(usual) >= most * static_cast<double>(gaps.size())
    ? median
    : mean;
  if (usual < static_cast<std::ptrdiff_t>(gaps.size()))
  {
    const auto [least, greatest] = std::minmax_element(gaps.begin(), gaps.end());
    notes.push_back("its slices lie " + formatNumber(*least) + " to " + formatNumber(*greatest) +
      " apart; they are taken as " + formatNumber(distance) + " apart");
  }
  return distance;
}

/// Where the pixels of each slice are.
void placePixels(const std::vector<Slice>& slices, RawVolume& voxels)
{
  const bool areCompressed = slices.front().file->isCompressed();
  voxels.encoding = areCompressed ? VoxelEncoding::Frames : VoxelEncoding::Plain;
  for (const Slice& slice : slices)
  {
    voxels.files.push_back(slice.file->path);
    voxels.offsets.push_back(
      areCompressed ? slice.number : slice.file->pixelOffset + slice.number * slice.file->frameBytes());
  }
}

} // namespace

VolumeHeader readDicomHeaders(const fs::path& path)
{
  VolumeHeader header;
  const bool isFolder = fs::is_directory(path);
  std::vector<DicomFile> files =
    isFolder ? readLargestSeries(path, header.notes) : readSeriesOf(path, header.notes);
  header.format = files.size() > 1 || isFolder ? "DICOM series" : "DICOM";
  // Not in the order of the folder.
  std::sort(files.begin(), files.end(),
    [](const DicomFile& a, const DicomFile& b)
    { return std::tie(a.number, a.path) < std::tie(b.number, b.path); });
  std::vector<Slice> slices;
  for (const DicomFile& file : files)
  {
    checkFrames(file);
    addSlices(file, slices, header.notes);
  }
  keepMostAlike(slices, isFolder ? fs::path() : path, header.notes);
  for (const DicomFile* checked = nullptr; const Slice& slice : slices)
  {
    if (slice.file != checked)
    {
      checked = slice.file;
      checkPixels(*checked);
    }
  }
  if (!isFolder && files.size() > 1)
  {
    header.notes.push_back(
      "it is one of " + std::to_string(slices.size()) + " slices in its folder; all of them are read");
  }
  sortSlices(slices);
  if (havePositions(slices))
  {
    keepFirstOfPlace(slices, header.notes);
    keepLongestRun(slices, header.notes);
  }
  const DicomFile& file = *slices.front().file;
  const DicomFrame& first = slices.front().frame;
  RawVolume& voxels = header.voxels;
  placePixels(slices, voxels);
  voxels.dimensions[0] = file.columns;
  voxels.dimensions[1] = file.rows;
  voxels.dimensions[2] = static_cast<int>(slices.size());
  voxels.type = typeOf(file);
  voxels.components = file.separatePlanes && !file.isCompressed() ? 1 : file.components;
  // Decompressed ones are in this machine's order.
  voxels.setBigEndian(file.isCompressed() ? std::endian::native == std::endian::big : file.bigEndian);
  header.components = file.components;
  header.scale = first.scale;
  const auto isFirst = [&](const Slice& slice) { return slice.frame.scale == first.scale; };
  if (!std::all_of(slices.begin(), slices.end(), isFirst))
  {
    std::transform(slices.begin(), slices.end(), std::back_inserter(header.sliceScales),
      [](const Slice& slice) { return slice.frame.scale; });
  }

  double steps[9];
  std::copy_n(first.row, 3, steps);
  std::copy_n(first.column, 3, steps + 3);
  vtkMath::Cross(first.row, first.column, steps + 6);
  if (slices.size() > 1 && havePositions(slices))
  {
    // Not at right angles where a scanner's gantry was tilted.
    vtkMath::Subtract(slices.back().frame.position, first.position, steps + 6);
  }
  constexpr double sign[3] = { 1, 1, 1 };
  header.orientation.emplace(steps, first.position, sign);
  header.spacing[0] = spacingOf(first.spacing[0]);
  header.spacing[1] = spacingOf(first.spacing[1]);
  header.spacing[2] = spacingOf(distanceOf(slices, header.notes));
  return header;
}

} // namespace ink::io
