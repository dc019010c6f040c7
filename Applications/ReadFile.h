#pragma once

#include "Input.h"

#include "vtkAlgorithm.h"

#include <cstdint>

namespace ink::cli
{

/// Runs a reader and checks what it left behind.
/// \throw Failure with what VTK said, if it said anything. Warnings count if they are asked to: the readers
/// of
///        legacy files only warn about missing data.
void runReader(vtkAlgorithm* reader, const std::filesystem::path& file, Progress& progress);

/// Lets a reader of volumes read the header of its file alone, and checks what that left behind.
/// \return the bytes that the volume has in memory; 0 if that is not known yet
/// \throw Failure as runReader
std::uint64_t readHeader(vtkAlgorithm* reader, const std::filesystem::path& file, Progress& progress);

/// Both for a volume that is read whole or not at all.
/// \throw Failure also if the volume is larger than memory
void runVolumeReader(
  vtkAlgorithm* reader, const std::filesystem::path& file, const Memory& memory, Progress& progress);

/// "cannot read 'file': reason" \throw Failure always.
[[noreturn]] void failToRead(const std::filesystem::path& file, const std::string& reason);

/// \throw Failure if voxels of so many bytes, which are read whole, are more than memory has room for.
void requireMemory(const std::filesystem::path& file, std::uint64_t bytes, const Memory& memory);

/// All bytes of a file. \throw Failure
std::string contentsOf(const std::filesystem::path& file);

/// One of these for each kind of input; all as readInput.
Input readVolume(
  const std::filesystem::path& file, const std::string& suffix, const Memory& memory, Progress& progress);
Input readVdb(const std::filesystem::path& file, const std::string& grid, Wanted wanted, const Memory& memory,
  Progress& progress);
Input readRawVolume(
  const std::filesystem::path& file, const RawLayout& layout, const Memory& memory, Progress& progress);
Input readDicomFolder(const std::filesystem::path& folder, const Memory& memory, Progress& progress);
Input readPoints(const std::filesystem::path& file, Progress& progress);
Input readMesh(const std::filesystem::path& file, const std::string& suffix, Progress& progress);

} // namespace ink::cli
