#include "CheckXmlFile.h"

#include "ReadFile.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>

namespace ink::cli
{

void checkXml(const std::filesystem::path& file)
{
  if (fileTail(file, 256).find("</VTKFile>") == std::string::npos)
  {
    failToRead(file, "the file ends without '</VTKFile>', the end of a VTK XML file");
  }
}

std::string fileTail(const std::filesystem::path& file, std::size_t size)
{
  std::ifstream stream(file, std::ios::binary);
  const std::uint64_t fileSize = std::filesystem::file_size(file);
  stream.seekg(static_cast<std::streamoff>(fileSize - std::min<std::uint64_t>(fileSize, size)));
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

} // namespace ink::cli
