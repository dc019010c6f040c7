// SPDX-License-Identifier: BSD-3-Clause
#define INK_KERNEL_SET baselineKernels
#define INK_KERNEL_NAME baseline
#include "Simd/KernelSet.h"
