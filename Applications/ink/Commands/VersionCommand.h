// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink::cli
{

/// Prints the versions of vtkInk, VTK and OpenGL to the standard output stream.
void version();

} // namespace ink::cli
