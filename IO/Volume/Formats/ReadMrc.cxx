// SPDX-License-Identifier: BSD-3-Clause
// Maps of electron microscopy and crystallography: A. Cheng et al., MRC2014: Extensions to the MRC format
// header for electron cryo-microscopy and tomography, J. Struct. Biol. 192 (2015); CCP4's are the same.
#include "VolumeHeader.h"

#include "Core/FormatNumber.h"
#include "FirstBytes.h"
#include "OrderedBytes.h"
#include "ReadError.h"

#include "vtkDataArray.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

constexpr std::size_t sizeOfHeader = 1024;
constexpr std::int32_t halfMode = 12;

/// Where the header has what is used of it: the numbers of the standard's words, each of 4 bytes, from 1.
enum Word
{
  Size = 1,
  Mode = 4,
  Start = 5,
  Sampling = 8,
  Cell = 11,
  Angles = 14,
  AxisOf = 17,
  SpaceGroup = 23,
  ExtendedHeader = 24,
  Origin = 50,
  Map = 53,
  MachineStamp = 54
};

class MrcHeader
{
public:
  MrcHeader(const std::vector<unsigned char>& bytes, const fs::path& file)
    : Bytes(bytes)
  {
    if (bytes.size() < sizeOfHeader)
    {
      failToRead(file,
        "it has " + std::to_string(bytes.size()) + " bytes; expected an MRC or CCP4 map, whose header has " +
          std::to_string(sizeOfHeader));
    }
    const unsigned char stamp = this->saysMap() ? this->word(MachineStamp)[0] : 0;
    constexpr unsigned char little = 0x44;
    constexpr unsigned char big = 0x11;
    // Where there is no stamp, sizes are small numbers.
    this->BigEndian = stamp == big ||
      (stamp != little && this->read<std::uint32_t>(Size, true) < this->read<std::uint32_t>(Size, false));
  }

  /// Whether it says what it is, as the standard has it since 2000. Before, other words were elsewhere where
  /// it has the origin and the machine stamp.
  bool saysMap() const { return std::memcmp(this->word(Map), "MAP ", 4) == 0; }
  bool bigEndian() const { return this->BigEndian; }
  std::int32_t whole(int word, int axis = 0) const
  {
    return this->read<std::int32_t>(word + axis, this->BigEndian);
  }
  double real(int word, int axis) const { return this->read<float>(word + axis, this->BigEndian); }
  /// What words of the header say, as "1 x 2 x 3".
  std::string triple(int word) const
  {
    const int numbers[3] = { this->whole(word), this->whole(word, 1), this->whole(word, 2) };
    return formatDimensions(numbers);
  }

private:
  const unsigned char* word(int number) const { return this->Bytes.data() + 4 * (number - 1); }
  template <class T>
  T read(int number, bool bigEndian) const
  {
    return valueFrom<T>(this->word(number), bigEndian != (std::endian::native == std::endian::big));
  }

  const std::vector<unsigned char>& Bytes;
  bool BigEndian = false;
};

/// @return VTK_VOID for complex numbers, packed ones, and what is none
int typeOf(const MrcHeader& mrc)
{
  switch (mrc.whole(Mode))
  {
    case 0:
      return VTK_SIGNED_CHAR;
    case 1:
      return VTK_SHORT;
    case 2:
    case halfMode:
      return VTK_FLOAT;
    case 6:
      return VTK_UNSIGNED_SHORT;
    default:
      return VTK_VOID;
  }
}

/// Whether a header that does not say what it is has a file of just the size that it would have.
bool fits(const MrcHeader& mrc, const fs::path& file)
{
  const int type = typeOf(mrc);
  if (type == VTK_VOID)
  {
    return false;
  }
  double bytes = mrc.whole(Mode) == halfMode ? 2.0 : vtkDataArray::GetDataTypeSize(type);
  for (int axis = 0; axis < 3; ++axis)
  {
    bytes *= std::max(mrc.whole(Size, axis), 0);
  }
  return bytes > 0.0 &&
    bytes + sizeOfHeader + mrc.whole(ExtendedHeader) == static_cast<double>(fs::file_size(file));
}

/// The number of voxels along the columns, rows and sections of the first volume.
void takeSize(const MrcHeader& mrc, const fs::path& file, VolumeHeader& header)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    header.voxels.dimensions[axis] = mrc.whole(Size, axis);
  }
  // Several volumes, one after the other, have one of the space groups above.
  constexpr int firstOfStacks = 401;
  constexpr int lastOfStacks = 630;
  const int group = mrc.whole(SpaceGroup);
  int& sections = header.voxels.dimensions[2];
  const int ofOne = mrc.whole(Sampling, 2);
  if (group >= firstOfStacks && group <= lastOfStacks && ofOne > 0 && ofOne < sections)
  {
    header.notes.push_back("it has " + std::to_string(sections / ofOne) + " volumes; the first is used");
    sections = ofOne;
  }
  header.voxels.checkDimensions(file);
}

/// Along which axis of the cell, from 0, columns, rows and sections run.
std::array<int, 3> axesOf(const MrcHeader& mrc, const fs::path& file)
{
  const std::array<int, 3> axes{ mrc.whole(AxisOf, 0), mrc.whole(AxisOf, 1), mrc.whole(AxisOf, 2) };
  std::array<int, 3> sorted = axes;
  std::sort(sorted.begin(), sorted.end());
  if (sorted == std::array{ 0, 0, 0 })
  {
    // Nobody has said so: as usual.
    return { 0, 1, 2 };
  }
  if (sorted != std::array{ 1, 2, 3 })
  {
    failToRead(file,
      "its header says that columns, rows and sections run along the axes " + mrc.triple(AxisOf) +
        "; expected 1, 2 and 3 in any order");
  }
  return { axes[0] - 1, axes[1] - 1, axes[2] - 1 };
}

/// Angles that are not given are right ones.
void noteAngles(const MrcHeader& mrc, VolumeHeader& header)
{
  const double angles[3] = { mrc.real(Angles, 0), mrc.real(Angles, 1), mrc.real(Angles, 2) };
  constexpr double right = 90.0;
  constexpr double tolerance = 0.05;
  const auto isRight = [](double angle)
  { return !(std::abs(angle) > 0.0) || std::abs(angle - right) < tolerance; };
  if (!std::all_of(angles, angles + 3, isRight))
  {
    header.notes.push_back(
      "the angles of its cell are " + formatTriple(angles) + " degrees; they are taken as right ones");
  }
}

/// Spacing, direction and the first voxel's position. The latter is the header's origin or, where that is 0,
/// as crystallography has it, where in the cell the map starts.
void place(const MrcHeader& mrc, const std::array<int, 3>& axes, VolumeHeader& header)
{
  double steps[9] = {};
  double origin[3];
  bool hasOrigin = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = mrc.saysMap() ? mrc.real(Origin, axis) : 0.0;
    hasOrigin = hasOrigin || origin[axis] != 0.0;
  }
  for (int i = 0; i < 3; ++i)
  {
    const int axis = axes[static_cast<std::size_t>(i)];
    const int samples = mrc.whole(Sampling, axis);
    const double length = mrc.real(Cell, axis);
    header.spacing[i] = samples > 0 ? spacingOf(length / samples) : 1.0;
    steps[3 * i + axis] = 1.0;
    if (!hasOrigin)
    {
      origin[axis] = header.spacing[i] * mrc.whole(Start, i);
    }
  }
  constexpr double sign[3] = { 1, 1, 1 };
  header.orientation.emplace(steps, origin, sign);
}

} // namespace

VolumeHeader readMrcHeader(const fs::path& file)
{
  const auto [compressed, bytes] = FirstBytes(file, sizeOfHeader);
  const MrcHeader mrc(bytes, file);
  if (!mrc.saysMap() && !fits(mrc, file))
  {
    failToRead(file,
      "it is not an MRC or CCP4 map: it does not say 'MAP ' at byte 208, "
      "and is not of the size that an older one would have");
  }
  VolumeHeader header;
  header.format = "MRC map";
  header.voxels.files = { file };
  header.voxels.type = typeOf(mrc);
  if (header.voxels.type == VTK_VOID)
  {
    failToRead(file,
      "its header says mode " + std::to_string(mrc.whole(Mode)) +
        "; expected 0 (int8), 1 (int16), 2 (float32), 6 (uint16) or 12 (float16)");
  }
  header.voxels.halves = mrc.whole(Mode) == halfMode;
  header.voxels.setBigEndian(mrc.bigEndian());
  takeSize(mrc, file, header);
  const std::array<int, 3> axes = axesOf(mrc, file);
  const std::int32_t extended = mrc.whole(ExtendedHeader);
  if (extended < 0)
  {
    failToRead(file,
      "its header says that " + std::to_string(extended) +
        " bytes follow before the voxels; expected 0 or more");
  }
  const std::uint64_t offset = sizeOfHeader + static_cast<std::uint64_t>(extended);
  (compressed ? header.voxels.skipped : header.voxels.offset) = offset;
  header.voxels.encoding = compressed ? VoxelEncoding::Compressed : VoxelEncoding::Plain;
  header.voxels.check(file);
  noteAngles(mrc, header);
  place(mrc, axes, header);
  return header;
}

} // namespace ink::io
