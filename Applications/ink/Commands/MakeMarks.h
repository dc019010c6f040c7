// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkStyle.h"

#include <functional>
#include <string>
#include <vector>

namespace ink::cli
{

class Progress;

/// Lets a style make its marks, with its progress shown.
/// @param notes those of the style are added
/// @param checkNone is called where there are none, and may throw to say why
/// @throws Failure if it fails or if there is nothing to draw
void makeMarks(vtkInkStyle* style, const vtkInkStyle::Input& input, std::vector<std::string>& notes,
  Progress& progress, const std::function<void()>& checkNone = {});

/// Options in place of the properties that a problem of vtkInk's classes names.
std::string inTermsOfInk(const std::string& problem);

} // namespace ink::cli
