// SPDX-License-Identifier: BSD-3-Clause
// The definition of one instruction set's kernels; each source that includes this defines INK_KERNEL_SET as
// their name first. Functions and templates have internal linkage, see SamplingKernels.h.

#include "Simd/SamplingKernels.h"

#include <type_traits>

#if defined(__x86_64__)
#  include <immintrin.h>
#elif defined(__aarch64__)
#  include <arm_neon.h>
#endif

#define INK_TEXT2(x) #x
#define INK_TEXT(x) INK_TEXT2(x)

namespace ink
{
namespace
{

#include "Simd/Simd.h"

#include "Simd/ClassifyKernels.h"
#include "Simd/ListKernels.h"
#include "Simd/LoadKernels.h"
#include "Simd/PlaceKernels.h"
#include "Simd/StippleKernels.h"
#include "Simd/ViewKernels.h"

template <class T>
constexpr TypedKernels<T> typedKernels()
{
  TypedKernels<T> kernels = { classify<T>, classifyAndMeasure<T>, classifyMixed<T>, judge<T>, {}, nullptr };
  if constexpr (sizeof(T) <= 2 || std::is_same_v<T, float>)
  {
    kernels.load[0] = loadStencils<T, NormalMethod::Cell>;
    kernels.load[1] = loadStencils<T, NormalMethod::InterpolatedGradient>;
    kernels.load[2] = loadStencils<T, NormalMethod::InterpolatedNormal>;
    kernels.load[3] = loadStencils<T, NormalMethod::Regression>;
  }
  if constexpr (sizeof(T) <= 4 || std::is_floating_point_v<T>)
  {
    kernels.view = viewBrick<T>;
  }
  return kernels;
}

#define INK_FOR_AXES(f, ...)                                                                                 \
  {                                                                                                          \
    f<__VA_ARGS__, GridAxes::Cubic>, f<__VA_ARGS__, GridAxes::Aligned>, f<__VA_ARGS__, GridAxes::General>    \
  }

template <class Real>
constexpr PlaceKernels<Real> placeKernels()
{
  return { { { INK_FOR_AXES(findPoints, Real, false, false), INK_FOR_AXES(findPoints, Real, false, true) },
             { INK_FOR_AXES(findPoints, Real, true, false), INK_FOR_AXES(findPoints, Real, true, true) } },
    { INK_FOR_AXES(findNormals, Real, NormalMethod::Cell),
      INK_FOR_AXES(findNormals, Real, NormalMethod::InterpolatedGradient),
      INK_FOR_AXES(findNormals, Real, NormalMethod::InterpolatedNormal),
      INK_FOR_AXES(findNormals, Real, NormalMethod::Regression) } };
}

} // namespace

extern const SamplingKernels INK_KERNEL_SET;
const SamplingKernels INK_KERNEL_SET = { INK_TEXT(INK_KERNEL_NAME), typedKernels<std::int8_t>(),
  typedKernels<std::uint8_t>(), typedKernels<std::int16_t>(), typedKernels<std::uint16_t>(),
  typedKernels<std::int32_t>(), typedKernels<std::uint32_t>(), typedKernels<std::int64_t>(),
  typedKernels<std::uint64_t>(), typedKernels<float>(), typedKernels<double>(), placeKernels<float>(),
  placeKernels<double>(), activeRows, listCells, findCorners, interleave, fillVoxel };

} // namespace ink
