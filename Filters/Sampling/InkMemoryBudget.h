// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkMemoryBudget_h
#define InkMemoryBudget_h

#include "vtkInkFiltersSamplingModule.h" // for the export macro

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

/// Up to how much memory is taken, and what of it is for what, where an image is sampled a few slices at a
/// time. Sizes are in bytes.
struct VTKINKFILTERSSAMPLING_EXPORT InkMemoryBudget
{
  std::uint64_t Limit;

  /// What a size is at least that people give.
  static constexpr std::uint64_t Least = std::uint64_t{ 128 } << 20;

  explicit InkMemoryBudget(std::uint64_t limit)
    : Limit(limit)
  {
  }
  /// Of a property MaximumMemory, in MiB; 0: no limit.
  static InkMemoryBudget OfMebibytes(int mebibytes);
  /// Of a number with a unit, as 800MiB or 1.5GiB; units are powers of 1024, their iB may be left out.
  /// Nothing if it is none, or less than Least.
  static std::optional<InkMemoryBudget> Parse(const std::string& size);

  /// As a property MaximumMemory has it: whole MiB, 16 TiB at most.
  int GetMebibytes() const;

  /// An image of up to this size is read whole.
  std::uint64_t ForWholeImage() const { return this->GetFree() / 2; }
  /// For slices of a larger one.
  std::uint64_t ForSlices() const { return this->GetFree() / 4; }
  /// For the points that are made at a time.
  std::uint64_t ForNewPoints() const { return this->GetFree() / 4; }
  /// For the points that wait to be written.
  std::uint64_t ForKeptPoints() const { return this->GetFree() / 8; }

  /// The least limit whose share is as large as size, with that share being 1 / part of what is free.
  static std::uint64_t LimitFor(std::uint64_t size, int part);

private:
  /// Without the program itself and its libraries.
  std::uint64_t GetFree() const;
};

/// The machine's memory in bytes, or what its container may take of it if that is less.
VTKINKFILTERSSAMPLING_EXPORT std::uint64_t InkGetMachineMemory();

/// @param bytes the memory that each of `count` takes while they are made
/// @param names what they are: "samples"
/// @param most of them, whatever the memory
/// @param advice what to do with too many, after the message; may be empty
/// @throws std::invalid_argument where they are too many
VTKINKFILTERSSAMPLING_EXPORT void InkCheckMemory(double count, double bytes, const std::string& names,
  double most = std::numeric_limits<double>::infinity(), const std::string& advice = {});

/// "12 MiB", rounded up.
VTKINKFILTERSSAMPLING_EXPORT std::string InkFormatMemory(std::uint64_t bytes);

/// The memory in bytes that a point of a surface takes at most while it is made: coordinates in double, a
/// normal, a radius and an index.
constexpr std::uint64_t InkBytesPerPoint = 48;

/// The same of a point as it is made, as it is drawn, and as OpenGL may keep it.
constexpr std::uint64_t InkBytesPerDrawnPoint = 100;

/// What a voxel's distance from a contour takes, see ink::sliceDistances.
constexpr int InkBytesOfDistance = 4;

#endif
