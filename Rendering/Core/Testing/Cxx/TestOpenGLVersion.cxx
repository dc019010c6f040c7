// SPDX-License-Identifier: BSD-3-Clause
// Tests that ask Mesa for a version of OpenGL get that one.
#include "InkTestScene.h"

#include "InkOpenGLCompat.h"

#include "vtkPolyDataMapper.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

TEST(OpenGLVersion, IsWhatWasAskedFor)
{
  vtkNew<vtkPolyData> nothing;
  InkTestScene<vtkPolyDataMapper> scene(nothing);
  scene.Window->Render();
  const std::string version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  const std::string language = reinterpret_cast<const char*>(glGetString(GL_SHADING_LANGUAGE_VERSION));
  EXPECT_GE(std::stod(version), 3.2) << "OpenGL 3.2 at least, found " << version;
  const char* asked = std::getenv("MESA_GL_VERSION_OVERRIDE");
  if (asked && version.find("Mesa") != std::string::npos)
  {
    EXPECT_TRUE(version.starts_with(asked)) << "OpenGL " << asked << ", found " << version;
    EXPECT_TRUE(language.starts_with("1.50")) << "GLSL 1.50, found " << language;
  }
}
