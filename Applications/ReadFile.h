#pragma once

#include "Input.h"

#include "vtkAlgorithm.h"

namespace ink::cli
{

/// Runs a reader and checks what it left behind.
/// \throw Failure with what VTK said, if it said anything. Warnings count if they are asked to: the readers
/// of
///        legacy files only warn about missing data.
void runReader(
  vtkAlgorithm* reader, const std::filesystem::path& file, Progress& progress, bool warningsCount = false);

/// "cannot read 'file': reason" \throw Failure always.
[[noreturn]] void failToRead(const std::filesystem::path& file, const std::string& reason);

/// One of these for each kind of input; all as readInput.
Input readVolume(const std::filesystem::path& file, const std::string& suffix, Progress& progress);
Input readRawVolume(const std::filesystem::path& file, const RawLayout& layout, Progress& progress);
Input readDicomFolder(const std::filesystem::path& folder, Progress& progress);
Input readMesh(const std::filesystem::path& file, const std::string& suffix, Progress& progress);

} // namespace ink::cli
