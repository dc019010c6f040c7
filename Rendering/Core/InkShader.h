// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkShader_h
#define InkShader_h

#include "vtkShaderProgram.h"

#include <cstddef>
#include <string>

/// A shader with a tag replaced, which is there once.
inline std::string InkReplaceInShader(std::string shader, const std::string& tag, const std::string& text)
{
  return shader.replace(shader.find(tag), tag.size(), text);
}

/// The definition of a feature, for InkWithFeatures.
inline std::string InkDefine(const std::string& feature)
{
  return "#define " + feature + '\n';
}
inline std::string InkDefine(const std::string& feature, std::size_t number)
{
  return InkDefine(feature + ' ' + std::to_string(number));
}

/// A form of a shader: with these definitions in the place that it has for them.
inline std::string InkWithFeatures(const std::string& shader, const std::string& features)
{
  return InkReplaceInShader(shader, "//INK::Features", features);
}

/// A color in 0..1 as a uniform.
inline void InkSetColorUniform(vtkShaderProgram* program, const char* name, const double* color)
{
  const float rgb[3] = { static_cast<float>(color[0]), static_cast<float>(color[1]),
    static_cast<float>(color[2]) };
  program->SetUniform3f(name, rgb);
}

#endif
