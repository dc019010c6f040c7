// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#if defined(__linux__)
#  include <sys/mman.h>
#endif

namespace ink
{

/// Memory in pages of 2 MiB for large arrays that are read here and there, where the system has such pages
/// and gives them to those who ask (Linux: transparent huge pages on "madvise" or "always"): with pages of 4
/// KiB each read would wait for the translation of its address, too.
template <class T>
struct LargePageAllocator
{
  using value_type = T;
  static constexpr std::size_t pageSize = std::size_t{ 1 } << 21;

  LargePageAllocator() = default;
  template <class U>
  LargePageAllocator(const LargePageAllocator<U>&)
  {
  }

  T* allocate(std::size_t count)
  {
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T))
    {
      throw std::bad_array_new_length();
    }
    const std::size_t bytes = count * sizeof(T);
    const std::align_val_t alignment = alignmentOf(count);
    void* const memory = ::operator new(bytes, alignment);
#if defined(__linux__)
    if (alignment == std::align_val_t{ pageSize })
    {
      madvise(
        memory, bytes / pageSize * pageSize, MADV_HUGEPAGE); // a wish: whether it is met does not matter
    }
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count)
  {
    ::operator delete(memory, alignmentOf(count));
  }

  template <class U>
  bool operator==(const LargePageAllocator<U>&) const
  {
    return true;
  }

private:
  /// Smaller arrays stay in ordinary pages.
  static std::align_val_t alignmentOf(std::size_t count)
  {
    return std::align_val_t{ count * sizeof(T) >= 2 * pageSize ? pageSize : alignof(T) };
  }
};

/// A vector for large arrays that are read here and there.
template <class T>
using LargePageVector = std::vector<T, LargePageAllocator<T>>;

} // namespace ink
