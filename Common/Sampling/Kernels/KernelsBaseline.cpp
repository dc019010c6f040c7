#define INK_KERNEL_SET baselineKernels
#define INK_KERNEL_NAME baseline
#include "Sampling/Kernels/KernelSet.h"
