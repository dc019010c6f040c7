#define INK_KERNEL_SET avx2Kernels
#define INK_KERNEL_NAME avx2
#include "Sampling/Kernels/KernelSet.h"
