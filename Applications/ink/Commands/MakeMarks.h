// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

class vtkDataObject;
class vtkInkStyle;

namespace ink::cli
{

class Progress;

/// Lets a style make its marks of data, with its progress shown.
/// @param notes those of the style are added
/// @throws Failure if it fails or if there is nothing to draw
void makeMarks(vtkInkStyle* style, vtkDataObject* data, std::vector<std::string>& notes, Progress& progress);

} // namespace ink::cli
