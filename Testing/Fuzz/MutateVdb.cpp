// SPDX-License-Identifier: BSD-3-Clause
// How libFuzzer changes .vdb files.
//
// Most bytes of a small file are masks of inner nodes, nearly all zero, where a change only asks for nodes
// that are not there. So half of the changes are made near the beginning or the end, where the rest is.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t mostSize);
extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t mostSize, unsigned int seed)
{
  constexpr std::size_t near = 800;
  if (size <= near || seed % 2 == 0)
  {
    return LLVMFuzzerMutate(data, size, mostSize);
  }
  const std::size_t begin = seed % 4 == 1 ? 0 : size - near;
  std::vector<std::uint8_t> part(data + begin, data + begin + near);
  const std::size_t room = std::min(2 * near, near + (mostSize - size));
  part.resize(room);
  part.resize(LLVMFuzzerMutate(part.data(), near, room));
  std::vector<std::uint8_t> rest(data + begin + near, data + size);
  std::copy(part.begin(), part.end(), data + begin);
  std::copy(rest.begin(), rest.end(), data + begin + part.size());
  return begin + part.size() + rest.size();
}
