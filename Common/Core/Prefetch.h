// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink
{

/// Asks for an object's first and last bytes to be in the cache soon: all of it, if it takes up to 128 bytes
/// and is aligned to 64, or up to 65.
template <class T>
void prefetchObject(const T& object)
{
  const char* const begin = reinterpret_cast<const char*>(&object);
  __builtin_prefetch(begin);
  __builtin_prefetch(begin + sizeof(T) - 1);
}

} // namespace ink
