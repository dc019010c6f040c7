// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Simd/SamplingKernels.h"

#include <type_traits>

namespace ink
{

/// The type of fixed size that stands for a scalar type in the kernels.
template <class T>
using KernelScalar = std::conditional_t<std::is_floating_point_v<T>, T,
  std::conditional_t<sizeof(T) == 1, std::conditional_t<std::is_signed_v<T>, std::int8_t, std::uint8_t>,
    std::conditional_t<sizeof(T) == 2, std::conditional_t<std::is_signed_v<T>, std::int16_t, std::uint16_t>,
      std::conditional_t<sizeof(T) == 4, std::conditional_t<std::is_signed_v<T>, std::int32_t, std::uint32_t>,
        std::conditional_t<std::is_signed_v<T>, std::int64_t, std::uint64_t>>>>>;

template <class T>
const TypedKernels<KernelScalar<T>>& kernelsFor(const SamplingKernels& kernels)
{
  using K = KernelScalar<T>;
  if constexpr (std::is_same_v<K, std::int8_t>)
  {
    return kernels.i8;
  }
  else if constexpr (std::is_same_v<K, std::uint8_t>)
  {
    return kernels.u8;
  }
  else if constexpr (std::is_same_v<K, std::int16_t>)
  {
    return kernels.i16;
  }
  else if constexpr (std::is_same_v<K, std::uint16_t>)
  {
    return kernels.u16;
  }
  else if constexpr (std::is_same_v<K, std::int32_t>)
  {
    return kernels.i32;
  }
  else if constexpr (std::is_same_v<K, std::uint32_t>)
  {
    return kernels.u32;
  }
  else if constexpr (std::is_same_v<K, std::int64_t>)
  {
    return kernels.i64;
  }
  else if constexpr (std::is_same_v<K, std::uint64_t>)
  {
    return kernels.u64;
  }
  else if constexpr (std::is_same_v<K, float>)
  {
    return kernels.f32;
  }
  else
  {
    return kernels.f64;
  }
}

} // namespace ink
