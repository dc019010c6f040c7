// SPDX-License-Identifier: BSD-3-Clause
#include "VersionCommand.h"

#include "Graphics.h"

#include "vtkVersion.h"

#include <iostream>

namespace ink::cli
{

void version()
{
  const Graphics graphics = probeGraphics();
  std::cout << "vtkInk " << VTKINK_VERSION << '\n'
            << "VTK    " << vtkVersion::GetVTKVersion() << '\n'
            << "OpenGL " << graphics.description << '\n'
            << "window " << graphics.windowClass << '\n';
}

} // namespace ink::cli
