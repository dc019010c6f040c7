// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"

#include <string>

class vtkImageData;

namespace ink
{
struct VdbConversion;
}

namespace ink::cli
{

class Progress;

/// What of ink needs OpenVDB, whose library takes as long to load as all others of ink together.
struct VdbLibrary
{
  /// As readInput. @throws Failure
  Input (*read)(const InputOptions& options, Wanted wanted, Progress& progress);
  /// The bytes of a .vdb file of an image. @throws std::invalid_argument
  std::string (*convert)(vtkImageData* image, const VdbConversion& conversion);
};

/// Loads it when called first. @throws Failure if it cannot be loaded, with the reason
const VdbLibrary& vdbLibrary();

} // namespace ink::cli

/// What the library has by this name.
extern "C" const ink::cli::VdbLibrary inkVdbLibrary;
