// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Simd/SamplingKernels.h"

namespace ink::testing
{

/// Makes a set of kernels the one in use for as long as it lives.
struct UseKernels
{
  explicit UseKernels(const SamplingKernels* kernels) { useSamplingKernels(kernels); }
  ~UseKernels() { useSamplingKernels(nullptr); }
};

} // namespace ink::testing
