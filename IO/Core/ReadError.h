// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOCoreModule.h" // for the export macro

#include "Core/Progress.h"

#include <filesystem>
#include <stdexcept>
#include <string>

namespace ink::io
{

/// Why a file is not read: "cannot read 'file': reason".
class ReadError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Ends reading because somebody asked for it.
class ReadAborted
{
};

/// @throws ReadError always
[[noreturn]] VTKINKIOCORE_EXPORT void failToRead(
  const std::filesystem::path& file, const std::string& reason);

/// Reports the share of a file that is read. @throws ReadAborted if progress asks to stop
VTKINKIOCORE_EXPORT void advance(const Progress& progress, double done);

/// All bytes of a file. @throws ReadError
VTKINKIOCORE_EXPORT std::string contentsOf(const std::filesystem::path& file);

/// What there is to read under a name. @throws ReadError if it is empty, or neither a regular file nor a
/// folder
VTKINKIOCORE_EXPORT void checkExists(const std::filesystem::path& file);

/// The end of a file's name in small letters, ".nii.gz" being one.
VTKINKIOCORE_EXPORT std::string suffixOf(const std::filesystem::path& file);

} // namespace ink::io
