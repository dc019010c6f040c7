// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOCoreModule.h" // for the export macro

#include <filesystem>
#include <string>
#include <vector>

namespace ink::io
{

/// Whether a name is that of a series of files rather than of one: a .pvd or .series file, or a pattern with
/// * or ? or with a number as printf writes it, such as %04d, where there is no file of this very name.
/// Beside a number, which stands for any digits, * and ? stand for themselves.
VTKINKIOCORE_EXPORT bool isSeries(const std::filesystem::path& name);

/// The files of a series in their order: by time in .pvd and .series files, by the numbers in their names for
/// a pattern. @throws ReadError if there are none, or if there is not one file for each time
VTKINKIOCORE_EXPORT std::vector<std::filesystem::path> filesOfSeries(const std::filesystem::path& name);

} // namespace ink::io
