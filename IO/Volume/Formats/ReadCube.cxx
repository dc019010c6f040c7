// SPDX-License-Identifier: BSD-3-Clause
// Cubes of Gaussian and other programs of chemistry: "cubegen", Gaussian 16 User's Reference.
#include "VolumeHeader.h"

#include "ReadError.h"
#include "TextHeader.h"
#include "Words.h"

#include "vtkType.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

constexpr int leastWhole = -std::numeric_limits<int>::max();

class CubeText
{
public:
  explicit CubeText(const fs::path& file)
    : File(file)
    , Stream(file, std::ios::binary)
  {
  }

  void nextLine(const char* expected)
  {
    if (!std::getline(this->Stream, this->Line))
    {
      failAtWord(this->File, "", expected);
    }
    this->Words = this->Line;
  }
  int whole(int least, const char* expected)
  {
    return takeWhole(this->wordsWith(expected), least, this->File, expected);
  }
  double number(const char* expected) { return takeNumber(this->wordsWith(expected), this->File, expected); }
  /// Those of the line that are left.
  std::string_view words() const { return this->Words; }
  bool hasWords() const { return this->Words.find_first_not_of(" \t\r") != std::string_view::npos; }

  /// Where in the file the next line begins. @throws ReadError at its end
  std::streamoff position(const char* expected)
  {
    if (!this->Stream.good())
    {
      failAtWord(this->File, "", expected);
    }
    return this->Stream.tellg();
  }

  /// Goes past some words, on any number of lines.
  void skip(int words, const char* expected)
  {
    for (int i = 0; i < words; ++i)
    {
      while (nextWord(this->Words).empty())
      {
        this->nextLine(expected);
      }
    }
  }

private:
  std::string_view& wordsWith(const char* expected)
  {
    if (!this->hasWords())
    {
      failToRead(this->File, "a line ends where " + std::string(expected) + " was expected");
    }
    return this->Words;
  }

  const fs::path& File;
  std::ifstream Stream;
  std::string Line;
  std::string_view Words;
};

bool areWhole(std::string_view words)
{
  return words.find_first_not_of("0123456789 \t\r") == std::string_view::npos;
}

/// How many orbitals words list, after their number; 0 if they do not.
int orbitalsIn(std::string_view words)
{
  const double count = areWhole(words) ? numberIn(nextWord(words)).value_or(0.0) : 0.0;
  int found = 0;
  while (!nextWord(words).empty())
  {
    ++found;
  }
  return found == count ? found : 0;
}

} // namespace

VolumeHeader readCubeHeader(const fs::path& file)
{
  CubeText cube(file);
  VolumeHeader header;
  header.format = "Gaussian cube";
  RawVolume& voxels = header.voxels;
  voxels.files = { file };
  voxels.type = VTK_FLOAT;
  voxels.encoding = VoxelEncoding::Text;
  cube.nextLine("a title");
  cube.nextLine("a second title");
  cube.nextLine("the number of atoms");
  const int atoms = cube.whole(leastWhole, "the number of atoms");
  for (double& origin : header.origin)
  {
    origin = cube.number("the position of the first voxel");
  }
  if (cube.hasWords())
  {
    voxels.components = cube.whole(1, "a number of values of 1 or more");
  }
  // The last axis is the fastest.
  double steps[9];
  for (int axis = 2; axis >= 0; --axis)
  {
    cube.nextLine("an axis");
    // A negative one says that distances are not in Bohr.
    voxels.dimensions[axis] = std::abs(cube.whole(leastWhole, "a number of voxels"));
    for (int i = 0; i < 3; ++i)
    {
      steps[3 * axis + i] = cube.number("the step between voxels");
    }
    header.spacing[axis] = spacingOf(std::hypot(steps[3 * axis], steps[3 * axis + 1], steps[3 * axis + 2]));
  }
  constexpr double sign[3] = { 1, 1, 1 };
  header.orientation.emplace(steps, header.origin, sign);
  for (int i = 0; i < std::abs(atoms); ++i)
  {
    cube.nextLine("an atom");
  }
  constexpr const char* values = "the first value";
  std::streamoff begin = cube.position(values);
  cube.nextLine(values);
  const bool areOrbitals = atoms < 0;
  int orbitals = orbitalsIn(cube.words());
  if (areOrbitals)
  {
    orbitals = cube.whole(1, "a number of orbitals of 1 or more");
    cube.skip(orbitals, "the number of an orbital");
  }
  if (orbitals > 0)
  {
    const std::streamoff next = cube.position(values);
    cube.nextLine(values);
    // Molden lists them where the number of atoms does not say so; values of another kind follow.
    if (areOrbitals || !areWhole(cube.words()))
    {
      voxels.components = orbitals;
      begin = next;
    }
  }
  voxels.offset = static_cast<std::uint64_t>(begin);
  header.components = voxels.components;
  voxels.check(file);
  return header;
}

} // namespace ink::io
