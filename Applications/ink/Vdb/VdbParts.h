// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VdbLibrary.h"

namespace ink::cli
{

/// VdbLibrary::read
Input readVdb(const InputOptions& options, Wanted wanted, Progress& progress);

/// VdbLibrary::convert
std::string convertToVdb(vtkImageData* image, const VdbConversion& conversion);

} // namespace ink::cli
