// SPDX-License-Identifier: BSD-3-Clause
// VolVis' volumes: R. Avila et al., VolVis: A Diversified Volume Visualization System, IEEE Visualization
// 1994; the header and the runs are as VTK's vtkSLCReader has them.
#include "VolumeHeader.h"

#include "FirstBytes.h"
#include "ReadError.h"
#include "TextHeader.h"
#include "Words.h"

#include "vtkType.h"

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace fs = std::filesystem;

namespace ink::io
{

VolumeHeader readSlcHeader(const fs::path& file)
{
  // Of twelve numbers.
  constexpr std::size_t longestText = 1024;
  const auto [compressed, bytes] = FirstBytes(file, longestText);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::string_view rest = text;
  if (compressed || nextWord(rest) != "11111")
  {
    failToRead(file, "it is no volume of VolVis, which begins with 11111");
  }
  VolumeHeader header;
  header.format = "VolVis volume";
  RawVolume& voxels = header.voxels;
  voxels.files = { file };
  voxels.type = VTK_UNSIGNED_CHAR;
  constexpr int least = std::numeric_limits<int>::min();
  for (int& dimension : voxels.dimensions)
  {
    dimension = takeWhole(rest, least, file, "a number of voxels");
  }
  const int bits = takeWhole(rest, least, file, "the number of a voxel's bits");
  if (bits != 8)
  {
    failToRead(file, "its header says " + std::to_string(bits) + " bits a voxel; expected 8");
  }
  for (double& spacing : header.spacing)
  {
    spacing = spacingOf(takeNumber(rest, file, "a distance between voxels"));
  }
  for (const char* expected : { "the unit of distances", "what the data comes from", "what was done to it" })
  {
    takeNumber(rest, file, expected);
  }
  const int compression = takeWhole(rest, least, file, "the kind of compression");
  if (compression != 0 && compression != 1)
  {
    failToRead(file,
      "its header says compression " + std::to_string(compression) +
        "; expected 0 (none) or 1 (run lengths)");
  }
  voxels.encoding = compression == 0 ? VoxelEncoding::Plain : VoxelEncoding::Runs;
  const auto width = static_cast<std::uint64_t>(takeWhole(rest, 0, file, "the width of the icon"));
  const auto height = static_cast<std::uint64_t>(takeWhole(rest, 0, file, "the height of the icon"));
  const std::string_view mark = nextWord(rest);
  if (!mark.starts_with('X'))
  {
    failAtWord(file, mark, "the X before the icon");
  }
  // Red, green and blue follow on the X.
  voxels.offset = static_cast<std::uint64_t>(mark.data() + 1 - text.data()) + 3 * width * height;
  voxels.check(file);
  return header;
}

} // namespace ink::io
