// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatShader_h
#define InkSplatShader_h

#include <string>

/// A form of a shader: with these definitions in the place that it has for them.
inline std::string InkWithFeatures(std::string shader, const std::string& features)
{
  const std::string tag = "//INK::Features";
  return shader.replace(shader.find(tag), tag.size(), features);
}

#endif
