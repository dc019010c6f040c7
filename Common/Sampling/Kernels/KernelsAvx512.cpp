#define INK_KERNEL_SET avx512Kernels
#define INK_KERNEL_NAME avx512
#include "Sampling/Kernels/KernelSet.h"
