// SPDX-License-Identifier: BSD-3-Clause
/// A style's parameters as JSON: {"style": "stipple", "parameters": {"Preset": "bone", ...}}.
#ifndef InkStyleFile_h
#define InkStyleFile_h

#include "vtkInkStyle.h"

#include <string>

/// All of the style's parameters.
std::string InkWriteStyleFile(vtkInkStyle* style);

/// @param settings what was read is added
/// @return what is wrong, with the key; empty if all is right
std::string InkReadStyleFile(const std::string& json, vtkInkStyle* style, vtkInkStyle::Settings& settings);

#endif
