// SPDX-License-Identifier: BSD-3-Clause
// NIfTI-1 and NIfTI-2, as one file or as a pair of .hdr and .img, and the pairs of Analyze 7.5, whose header
// is that of NIfTI-1 without most of its numbers.
#include "VolumeHeader.h"

#include "Core/FormatNumber.h"
#include "FirstBytes.h"
#include "Inflater.h"
#include "OrderedBytes.h"
#include "ReadError.h"

#include "vtkMath.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

constexpr std::size_t sizeOfFirst = 348;
constexpr std::size_t sizeOfSecond = 540;
constexpr std::size_t axes = 8; ///< the numbers of `dim` and `pixdim`, the first of which is something else

/// Where the two versions of the format have what is used of it.
struct Offsets
{
  std::size_t dim;
  std::size_t datatype;
  std::size_t pixdim;
  std::size_t voxOffset;
  std::size_t slope;
  std::size_t intercept;
  std::size_t qformCode;
  std::size_t sformCode;
  std::size_t quaternion; ///< and the offset after it
  std::size_t rows;
};
constexpr Offsets first{ 40, 70, 76, 108, 112, 116, 252, 254, 256, 280 };
constexpr Offsets second{ 16, 12, 104, 168, 176, 184, 344, 348, 352, 400 };

/// A header of either version.
class NiftiHeader
{
public:
  /// @param pair whether the voxels are in another file
  NiftiHeader(std::span<const unsigned char> bytes, const fs::path& file, bool pair)
    : Bytes(bytes)
  {
    constexpr std::size_t magicOfFirst = 344;
    constexpr std::size_t magicOfSecond = 4;
    const auto is = [bytes](std::size_t offset, std::string_view magic)
    {
      return bytes.size() >= offset + magic.size() &&
        std::equal(magic.begin(), magic.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset));
    };
    // Some programs that take a file apart leave it the magic of one.
    const bool isOneOfSecond = is(magicOfSecond, std::string_view("n+2\0\r\n\032\n", 8));
    const bool isOneOfFirst = is(magicOfFirst, std::string_view("n+1\0", 4));
    this->IsSecond = bytes.size() >= sizeOfSecond &&
      (isOneOfSecond || (pair && is(magicOfSecond, std::string_view("ni2\0\r\n\032\n", 8))));
    const bool isFirst = isOneOfFirst || (pair && is(magicOfFirst, std::string_view("ni1\0", 4)));
    this->IsAnalyze = pair && !this->IsSecond && !isFirst;
    if (!pair && !this->IsSecond && !isFirst)
    {
      failToRead(file, "it is not a NIfTI volume: it has neither 'n+1' at byte 344 nor 'n+2' at byte 4");
    }
    const std::string kind = pair ? "header of a NIfTI or Analyze volume" : "NIfTI volume";
    if (bytes.size() < sizeOfFirst)
    {
      failToRead(file,
        "it is not a " + kind + ": it has " + std::to_string(bytes.size()) + " bytes; expected " +
          std::to_string(sizeOfFirst) + " or more");
    }
    const std::int32_t size = this->at<std::int32_t>(0);
    this->Swapped = size != this->size();
    if (this->Swapped && this->at<std::int32_t>(0) != this->size())
    {
      failToRead(file,
        "it is not a " + kind + ": its header says a size of " + std::to_string(size) + " bytes; expected " +
          std::to_string(this->size()));
    }
  }

  bool isAnalyze() const { return this->IsAnalyze; }
  /// Of Analyze: 0 for transverse slices, 1 for coronal, 2 for sagittal ones, 3 to 5 for these turned over.
  int slices() const { return this->Bytes[252]; }
  const Offsets& offsets() const { return this->IsSecond ? second : first; }
  std::int32_t size() const { return static_cast<std::int32_t>(this->IsSecond ? sizeOfSecond : sizeOfFirst); }
  bool bigEndian() const { return this->Swapped != (std::endian::native == std::endian::big); }

  /// The i-th of numbers that are real in both versions, from an offset on.
  double real(std::size_t offset, std::size_t i = 0) const
  {
    return this->IsSecond ? this->at<double>(offset + i * sizeof(double))
                          : static_cast<double>(this->at<float>(offset + i * sizeof(float)));
  }
  std::int64_t dimension(std::size_t i) const
  {
    return this->IsSecond ? this->at<std::int64_t>(second.dim + i * sizeof(std::int64_t))
                          : this->at<std::int16_t>(first.dim + i * sizeof(std::int16_t));
  }
  int code(std::size_t offset) const
  {
    return this->IsSecond ? this->at<std::int32_t>(offset) : this->at<std::int16_t>(offset);
  }
  int datatype() const { return this->at<std::int16_t>(this->offsets().datatype); }
  double voxelOffset() const
  {
    return this->IsSecond ? static_cast<double>(this->at<std::int64_t>(second.voxOffset))
                          : this->real(first.voxOffset);
  }

private:
  template <class T>
  T at(std::size_t offset) const
  {
    return valueFrom<T>(this->Bytes.data() + offset, this->Swapped);
  }

  std::span<const unsigned char> Bytes;
  bool IsSecond = false;
  bool IsAnalyze = false;
  bool Swapped = false;
};

struct NiftiType
{
  int code;
  int type;
  int components;
};
constexpr std::array<NiftiType, 14> types{ { { 2, VTK_UNSIGNED_CHAR, 1 }, { 4, VTK_SHORT, 1 },
  { 8, VTK_INT, 1 }, { 16, VTK_FLOAT, 1 }, { 32, VTK_FLOAT, 2 }, { 64, VTK_DOUBLE, 1 },
  { 128, VTK_UNSIGNED_CHAR, 3 }, { 256, VTK_SIGNED_CHAR, 1 }, { 512, VTK_UNSIGNED_SHORT, 1 },
  { 768, VTK_UNSIGNED_INT, 1 }, { 1024, VTK_LONG_LONG, 1 }, { 1280, VTK_UNSIGNED_LONG_LONG, 1 },
  { 1792, VTK_DOUBLE, 2 }, { 2304, VTK_UNSIGNED_CHAR, 4 } } };

/// The sform, else the qform, if there is one.
void orient(const NiftiHeader& nifti, VolumeHeader& header)
{
  const Offsets& offsets = nifti.offsets();
  // NIfTI: +x to the right, +y to the front.
  constexpr double sign[3] = { -1, -1, 1 };
  if (nifti.isAnalyze())
  {
    // Its usual order: from the right to the left, to the front, to the head.
    constexpr double steps[9] = { -1, 0, 0, 0, 1, 0, 0, 0, 1 };
    constexpr double origin[3] = { 0, 0, 0 };
    header.orientation.emplace(steps, origin, sign);
    constexpr int turnedSagittal = 5;
    if (nifti.slices() > 0 && nifti.slices() <= turnedSagittal)
    {
      header.notes.push_back("its header says orientation " + std::to_string(nifti.slices()) +
        "; it is taken as 0, transverse slices from the front to the back");
    }
    return;
  }
  if (nifti.code(offsets.sformCode) > 0)
  {
    double steps[9];
    double origin[3];
    for (std::size_t j = 0; j < 3; ++j)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        steps[3 * i + j] = nifti.real(offsets.rows, 4 * j + i);
      }
      origin[j] = nifti.real(offsets.rows, 4 * j + 3);
    }
    header.orientation.emplace(steps, origin, sign);
    for (int i = 0; i < 3; ++i)
    {
      header.spacing[i] = spacingOf(vtkMath::Norm(steps + 3 * i));
    }
    return;
  }
  if (nifti.code(offsets.qformCode) > 0)
  {
    double quaternion[4] = { 0.0, nifti.real(offsets.quaternion), nifti.real(offsets.quaternion, 1),
      nifti.real(offsets.quaternion, 2) };
    const double rest = 1.0 - vtkMath::Dot(quaternion + 1, quaternion + 1);
    quaternion[0] = rest > 0.0 ? std::sqrt(rest) : 0.0;
    double rotation[3][3];
    vtkMath::QuaternionToMatrix3x3(quaternion, rotation);
    // The first of `pixdim` is negative where the third index runs the other way.
    const double third = nifti.real(offsets.pixdim) < 0.0 ? -1.0 : 1.0;
    double steps[9];
    double origin[3];
    for (std::size_t j = 0; j < 3; ++j)
    {
      steps[j] = rotation[j][0];
      steps[3 + j] = rotation[j][1];
      steps[6 + j] = third * rotation[j][2];
      origin[j] = nifti.real(offsets.quaternion, 3 + j);
    }
    header.orientation.emplace(steps, origin, sign);
  }
}

/// The two files of a volume, each of which may be compressed; one and the same unless it is a pair.
struct NiftiFiles
{
  fs::path header;
  fs::path voxels;

  bool isPair() const { return this->header != this->voxels; }
};

bool isHeaderOfPair(const fs::path& file)
{
  return suffixOf(file).starts_with(".hdr");
}

/// @param file either of a pair, or one that has all
NiftiFiles findFiles(const fs::path& file)
{
  const bool isHeader = isHeaderOfPair(file);
  if (!isHeader && !suffixOf(file).starts_with(".img"))
  {
    return { file, file };
  }
  const std::optional<fs::path> other = findOtherOfPair(file);
  if (!other)
  {
    failToRead(file,
      "there is no file beside it that ends in " +
        std::string(isHeader ? ".img, in which the voxels" : ".hdr, in which the header") +
        " of a pair would be");
  }
  checkExists(*other);
  return isHeader ? NiftiFiles{ file, *other } : NiftiFiles{ *other, file };
}

} // namespace

std::optional<fs::path> findOtherOfPair(const fs::path& file)
{
  const std::string name = file.string();
  const std::string stem = name.substr(0, name.size() - suffixOf(file).size());
  const std::array<const char*, 2> ends =
    isHeaderOfPair(file) ? std::array{ ".img", ".IMG" } : std::array{ ".hdr", ".HDR" };
  for (const char* end : ends)
  {
    for (const char* compressed : { "", ".gz", ".GZ" })
    {
      const fs::path found = stem + end + compressed;
      std::error_code error;
      if (fs::is_regular_file(found, error))
      {
        return found;
      }
    }
  }
  return std::nullopt;
}

VolumeHeader readNiftiHeader(const fs::path& file)
{
  const NiftiFiles files = findFiles(file);
  const FirstBytes start(files.header, sizeOfSecond);
  const NiftiHeader nifti(start.bytes, files.header, files.isPair());
  const bool compressed = files.isPair() ? FirstBytes(files.voxels, 1).compressed : start.compressed;

  // A missing dimension is 1. The fourth is time, the fifth for vectors, whose components are volumes.
  std::array<std::int64_t, axes> dimensions;
  dimensions.fill(1);
  const std::int64_t count = nifti.dimension(0);
  double volumes = 1.0;
  for (std::size_t i = 1; i < axes && static_cast<std::int64_t>(i) <= count; ++i)
  {
    dimensions[i] = nifti.dimension(i);
    if (dimensions[i] < 1 || dimensions[i] > std::numeric_limits<int>::max())
    {
      failToRead(file, "its header says dimension " + std::to_string(dimensions[i]) + "; expected 1 or more");
    }
    volumes *= i > 3 ? static_cast<double>(dimensions[i]) : 1.0;
  }
  if (count < 1 || count >= static_cast<std::int64_t>(axes))
  {
    failToRead(file, "its header says " + std::to_string(count) + " dimensions; expected 1 to 7");
  }
  const auto type = std::find_if(
    types.begin(), types.end(), [&](const NiftiType& known) { return known.code == nifti.datatype(); });
  if (type == types.end())
  {
    failToRead(file,
      "its header says data type " + std::to_string(nifti.datatype()) +
        "; expected integers of 8 to 64 bits, float, double, complex numbers or colors");
  }

  VolumeHeader header;
  header.format = nifti.isAnalyze() ? "Analyze volume" : "NIfTI volume";
  header.voxels.files = { files.voxels };
  header.voxels.type = type->type;
  header.voxels.components = type->components;
  for (int i = 0; i < 3; ++i)
  {
    header.voxels.dimensions[i] = static_cast<int>(dimensions[i + 1]);
    header.spacing[i] = spacingOf(nifti.real(nifti.offsets().pixdim, i + 1));
  }
  header.voxels.setBigEndian(nifti.bigEndian());
  const double offset =
    std::max(nifti.voxelOffset(), files.isPair() ? 0.0 : static_cast<double>(nifti.size() + 4));
  constexpr double mostOffset = 1 << 30;
  if (!(offset <= mostOffset))
  {
    failToRead(
      file, "its header says that its voxels begin at byte " + formatNumber(offset) + "; expected fewer");
  }
  (compressed ? header.voxels.skipped : header.voxels.offset) = static_cast<std::uint64_t>(offset);
  header.voxels.encoding = compressed ? VoxelEncoding::Compressed : VoxelEncoding::Plain;
  header.voxels.check(files.voxels);
  // Of what comes after the first volume only the length is checked.
  const double promised = static_cast<double>(header.voxels.fileBytes()) * volumes + offset;
  const double found = static_cast<double>(fs::file_size(files.voxels)) *
    (compressed ? static_cast<double>(Inflater::mostPerByte) : 1.0);
  if (found < promised)
  {
    failToRead(files.voxels,
      "it has " + formatNumber(found) + " bytes, but its header promises " + formatNumber(promised) +
        " with all its volumes");
  }

  constexpr std::int64_t mostComponents = 1 << 20;
  header.components = static_cast<int>(std::min(dimensions[5], mostComponents)) * type->components;
  if (dimensions[4] > 1)
  {
    header.notes.push_back("it has " + std::to_string(dimensions[4]) + " time steps; the first is used");
  }
  header.scale.slope = nifti.real(nifti.offsets().slope);
  // Of Analyze's, SPM has made the first one a slope.
  header.scale.intercept = nifti.isAnalyze() ? 0.0 : nifti.real(nifti.offsets().intercept);
  if (!std::isfinite(header.scale.slope) || !std::isfinite(header.scale.intercept))
  {
    // How some programs say that there is nothing to be done.
    header.scale = {};
  }
  orient(nifti, header);
  return header;
}

} // namespace ink::io
