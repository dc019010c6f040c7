// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"

#include "vtkAlgorithm.h"

#include <cstdint>

namespace ink::cli
{

/// Runs a reader, whose errors may say themselves which file they are about, as those of vtkInk's readers do.
/// @throws Failure with what it said, if it said anything
void runReader(vtkAlgorithm* reader, const std::filesystem::path& file, Progress& progress);

/// The same, but for the header of the file alone.
void readHeader(vtkAlgorithm* reader, const std::filesystem::path& file, Progress& progress);

/// "cannot read 'file': reason" @throws Failure always.
[[noreturn]] void failToRead(const std::filesystem::path& file, const std::string& reason);

/// @throws Failure if voxels of so many bytes, which are read whole, are more than memory has room for.
void requireMemory(const std::filesystem::path& file, std::uint64_t bytes, const InkMemoryBudget& memory);

/// @throws UsageError if --spacing is given, for what is no file of voxels with distances between them.
void requireNoSpacing(const InputOptions& options);

/// What keeps the part that --crop names of what an algorithm makes; the algorithm itself without --crop.
/// @throws Failure if nothing of an image, which only UpdateInformation is asked of, is left
vtkSmartPointer<vtkAlgorithm> cropped(vtkAlgorithm* source, const InputOptions& options);
/// The same of data. @throws Failure if nothing is left
vtkSmartPointer<vtkDataObject> cropped(vtkDataObject* data, const InputOptions& options);

/// Adds the notes of a reader to those of what it read.
template <class Reader>
void takeNotes(Reader* reader, Input& input)
{
  for (int i = 0; i < reader->GetNumberOfNotes(); ++i)
  {
    input.notes.emplace_back(reader->GetNote(i));
  }
}

/// One of these for each kind of input; all as readInput.
Input readVolume(const InputOptions& options, Progress& progress);
Input readMesh(const InputOptions& options, Progress& progress);

} // namespace ink::cli
