// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkShader_h
#define InkShader_h

#include <string>

/// A shader with a tag replaced, which is there once.
inline std::string InkReplaceInShader(std::string shader, const std::string& tag, const std::string& text)
{
  return shader.replace(shader.find(tag), tag.size(), text);
}

/// A form of a shader: with these definitions in the place that it has for them.
inline std::string InkWithFeatures(const std::string& shader, const std::string& features)
{
  return InkReplaceInShader(shader, "//INK::Features", features);
}

#endif
