// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink
{

/// How light a color looks: its luma (ITU-R BT.709).
/// @param rgb three numbers in 0..1
inline double lightness(const double* rgb)
{
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

} // namespace ink
