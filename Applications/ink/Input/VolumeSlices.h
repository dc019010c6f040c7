// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Memory.h"
#include "RawVolume.h"

#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <optional>

class vtkDataArray;
class vtkImageData;

namespace ink::cli
{

/// The slices along z of a volume of one component: of one in memory, or of one in a file that memory has no
/// room for, whose slices are read when they are needed.
class VolumeSlices
{
public:
  /// Of a volume in memory, with point scalars of one component.
  explicit VolumeSlices(vtkImageData* image);

  /// Of a volume in a file.
  /// @param frame where its voxels lie: extent, origin, spacing and direction
  /// @throws Failure if memory is not enough for a few slices.
  VolumeSlices(vtkImageData* frame, const io::RawVolume& voxels, const Memory& memory);

  /// The number of slices that are needed at a time: two that a layer of cells lies between, and one on
  /// either side for gradients.
  static constexpr int fewestAtOnce = 4;

  bool inMemory() const { return !this->Reader; }
  /// Where the voxels lie; it has values only if the volume is in memory.
  vtkImageData* frame() const;
  const std::array<int, 3>& dimensions() const { return this->Dimensions; }
  int type() const { return this->Type; } ///< as VTK_UNSIGNED_CHAR

  /// How many slices can be had at a time.
  int atOnce() const { return this->AtOnce; }

  /// Slices from `first` up to, but without, `end`, counted from 0, as a part of the whole image. It shows
  /// memory of this object that the next call may reuse, but for slices that were there already. @throws
  /// Failure if they cannot be read.
  vtkSmartPointer<vtkImageData> get(int first, int end);

private:
  std::size_t sliceBytes() const;
  void load(int first, int end);

  vtkSmartPointer<vtkImageData> Frame;
  std::array<int, 3> Dimensions;
  int Type;
  int AtOnce;
  std::optional<io::RawVolumeReader> Reader; ///< none if the volume is in memory

  /// Slices LoadedFirst to LoadedEnd - 1.
  unsigned char* Values = nullptr;
  std::unique_ptr<unsigned char[]> Buffer;
  int LoadedFirst = 0;
  int LoadedEnd = 0;
};

} // namespace ink::cli
