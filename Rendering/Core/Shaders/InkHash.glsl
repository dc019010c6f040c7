// SPDX-License-Identifier: BSD-3-Clause
// A random number in [0, 1), the same for the same index.
float randomOf(uint index)
{
  return float((index * 2654435769u) >> 8u) / 16777216.0;
}
