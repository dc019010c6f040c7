// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ink::cli
{

/// What VTK can draw with here.
struct Graphics
{
  bool works = false;
  std::string windowClass; ///< VTK's, as "vtkXOpenGLRenderWindow"
  std::string description; ///< vendor, renderer and version of OpenGL, or, if it does not work, why
};

/// Tries to make an OpenGL context. In a child process, because VTK ends the process if there is no display.
/// To be called before any threads are started.
Graphics probeGraphics();

} // namespace ink::cli
