// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkVertexLimit_h
#define InkVertexLimit_h

#include <cstddef>
#include <limits>
#include <string>

/// Why a surface of so many corners of triangles, or discs, cannot be drawn: OpenGL counts them in an int.
/// Empty if it can.
inline std::string InkFindVertexProblem(std::size_t count)
{
  constexpr std::size_t most = std::numeric_limits<int>::max();
  return count <= most ? std::string()
                       : "OpenGL draws surfaces of up to " + std::to_string(most) +
      " corners of triangles or points; found " + std::to_string(count) + ".";
}

#endif
