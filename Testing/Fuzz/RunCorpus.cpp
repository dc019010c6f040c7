// SPDX-License-Identifier: BSD-3-Clause
// Runs the fuzz target once over each file of some folders, without libFuzzer: any compiler will do.

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char* argv[])
{
  int count = 0;
  for (int i = 1; i < argc; ++i)
  {
    for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
    {
      std::cout << entry.path().filename().string() << std::endl;
      std::ifstream in(entry.path(), std::ios::binary);
      const std::string bytes{ std::istreambuf_iterator<char>(in), {} };
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++count;
    }
  }
  std::cout << count << " files" << std::endl;
  return count > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
