// SPDX-License-Identifier: BSD-3-Clause
#define INK_KERNEL_SET avx512Kernels
#define INK_KERNEL_NAME avx512
#include "Simd/KernelSet.h"
