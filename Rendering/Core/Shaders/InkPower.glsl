// SPDX-License-Identifier: BSD-3-Clause
// A power that is defined for all bases: 0^0 is 1, and what is negative counts as 0.
float power(float base, float exponent)
{
  return base > 0.0 ? pow(base, exponent) : (base == 0.0 && exponent == 0.0 ? 1.0 : 0.0);
}
