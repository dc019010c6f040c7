// SPDX-License-Identifier: BSD-3-Clause
#include "Simd/SamplingKernels.h"

#include <atomic>
#include <cstdlib>
#include <cstring>

namespace ink
{

extern const SamplingKernels baselineKernels;
#ifdef INK_X86_KERNELS
extern const SamplingKernels avx2Kernels;
extern const SamplingKernels avx512Kernels;
#endif

namespace
{

std::atomic<const SamplingKernels*> inUse = nullptr;

const SamplingKernels& best()
{
  if (const char* name = std::getenv("VTKINK_INSTRUCTION_SET"))
  {
    if (const SamplingKernels* named = samplingKernelsOf(name))
    {
      return *named;
    }
  }
  for (const char* name : { "avx512", "avx2" })
  {
    if (const SamplingKernels* kernels = samplingKernelsOf(name))
    {
      return *kernels;
    }
  }
  return baselineKernels;
}

} // namespace

const SamplingKernels* samplingKernelsOf(const char* name)
{
  if (std::strcmp(name, "baseline") == 0)
  {
    return &baselineKernels;
  }
#ifdef INK_X86_KERNELS
  if (!__builtin_cpu_supports("bmi") || !__builtin_cpu_supports("bmi2"))
  {
    return nullptr;
  }
  if (std::strcmp(name, "avx2") == 0 && __builtin_cpu_supports("avx2"))
  {
    return &avx2Kernels;
  }
  if (std::strcmp(name, "avx512") == 0 && __builtin_cpu_supports("avx512f") &&
    __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
    __builtin_cpu_supports("avx512vl"))
  {
    return &avx512Kernels;
  }
#endif
  return nullptr;
}

const SamplingKernels& samplingKernels()
{
  const SamplingKernels* kernels = inUse;
  if (!kernels)
  {
    kernels = &best();
    inUse = kernels;
  }
  return *kernels;
}

void useSamplingKernels(const SamplingKernels* kernels)
{
  inUse = kernels;
}

} // namespace ink
