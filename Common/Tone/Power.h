// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink
{

/// base^exponent for a base that is not negative, and 0 for a negative one; 0^0 = 1, and 0 to a negative
/// power counts as 0, so that the result is always finite for a finite base. The k's that are exponents in Lu
/// et al. 2003, Table 1 are all used through this, here and in the shader alike.
float power(float base, float exponent);

} // namespace ink
