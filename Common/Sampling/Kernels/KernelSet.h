// The definition of one instruction set's kernels; each source that includes this defines INK_KERNEL_SET as
// their name first. Functions and templates have internal linkage, see SamplingKernels.h.

#include "Sampling/Kernels/SamplingKernels.h"

#include <type_traits>

#if defined(__x86_64__)
#  include <immintrin.h>
#endif

#define INK_TEXT2(x) #x
#define INK_TEXT(x) INK_TEXT2(x)

namespace ink
{
namespace
{

#include "Sampling/Kernels/Simd.h"

#include "Sampling/Kernels/ClassifyKernels.h"
#include "Sampling/Kernels/ListKernels.h"
#include "Sampling/Kernels/LoadKernels.h"
#include "Sampling/Kernels/PlaceKernels.h"
#include "Sampling/Kernels/StippleKernels.h"

template <class T>
constexpr TypedKernels<T> typedKernels()
{
  TypedKernels<T> kernels = { classify<T>, classifyAndMeasure<T>, classifyMixed<T>, judge<T>, {} };
#if defined(__x86_64__)
  if constexpr (sizeof(T) <= 2 || std::is_same_v<T, float>)
  {
    kernels.load[0] = load<T, NormalMethod::Cell>;
    kernels.load[1] = load<T, NormalMethod::Gradient>;
    kernels.load[2] = load<T, NormalMethod::CentralDifference>;
    kernels.load[3] = load<T, NormalMethod::Regression>;
  }
#endif
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
      INK_FOR_AXES(findNormals, Real, NormalMethod::Gradient),
      INK_FOR_AXES(findNormals, Real, NormalMethod::CentralDifference),
      INK_FOR_AXES(findNormals, Real, NormalMethod::Regression) } };
}

} // namespace

extern const SamplingKernels INK_KERNEL_SET;
const SamplingKernels INK_KERNEL_SET = { INK_TEXT(INK_KERNEL_NAME), typedKernels<std::int8_t>(),
  typedKernels<std::uint8_t>(), typedKernels<std::int16_t>(), typedKernels<std::uint16_t>(),
  typedKernels<std::int32_t>(), typedKernels<std::uint32_t>(), typedKernels<std::int64_t>(),
  typedKernels<std::uint64_t>(), typedKernels<float>(), typedKernels<double>(), placeKernels<float>(),
  placeKernels<double>(), crossRows, listCells, findCorners, interleave, fillVoxel };

} // namespace ink
