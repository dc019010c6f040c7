// SPDX-License-Identifier: BSD-3-Clause
#define INK_KERNEL_SET avx2Kernels
#define INK_KERNEL_NAME avx2
#include "Simd/KernelSet.h"
