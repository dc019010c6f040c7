// SPDX-License-Identifier: BSD-3-Clause
// Gaussian's cubes: where values are along axes of any direction, orbitals, and what is refused.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

struct Cube
{
  std::string titles = "made by a test\n, 5 3 e\n";
  std::string atoms = "2 -1.5 2.5 10";
  std::string axes[3] = { "6 0.5 0 0", "5 0 2 0", "7 0 0 1" };
  std::string lines = "1 0 0.5 0.5 0.5\n8 8 1 1 1\n";
  std::string values;

  /// @param perVoxel the first of which is ValueAt() of x along the last axis
  explicit Cube(int perVoxel = 1)
  {
    for (int z = 0; z < Size[2]; ++z)
    {
      for (int y = 0; y < Size[1]; ++y)
      {
        for (int x = 0; x < Size[0]; ++x)
        {
          for (int n = 0; n < perVoxel; ++n)
          {
            this->values += ' ' + std::to_string(ValueAt(x, y, z) + n) + ".0E+00";
          }
        }
        this->values += '\n';
      }
    }
  }

  std::string bytes() const
  {
    return this->titles + this->atoms + '\n' + this->axes[0] + '\n' + this->axes[1] + '\n' + this->axes[2] +
      '\n' + this->lines + this->values;
  }
};

void ExpectPosition(
  vtkImageData* image, const std::array<int, 3>& voxel, const std::array<double, 3>& expected)
{
  const auto found = PositionOf(image, voxel[0], voxel[1], voxel[2]);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-6) << i;
  }
}

} // namespace

TEST(CubeFiles, TheLastAxisIsTheFastest)
{
  const std::string file = Put("CubeFiles.cube", Cube().bytes());
  const auto reader = UpdatedReaderOf(file);
  EXPECT_EQ(reader->CanReadFile(file.c_str()), 1);
  EXPECT_STREQ(reader->GetFormat(), "Gaussian cube");
  EXPECT_EQ(reader->GetNumberOfNotes(), 0);
  EXPECT_FALSE(reader->HasPlainVoxels());
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetNumberOfPoints(), Size[0] * Size[1] * Size[2]);
  EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
  ExpectValues(image, "cube");
  ExpectPosition(image, { 0, 0, 0 }, { -1.5, 2.5, 10.0 });
  ExpectPosition(image, { 6, 0, 0 }, { -1.5, 2.5, 16.0 });
  ExpectPosition(image, { 0, 3, 0 }, { -1.5, 8.5, 10.0 });
  ExpectPosition(image, { 0, 0, 4 }, { 0.5, 2.5, 10.0 });
}

TEST(CubeFiles, AxesHaveAnyDirectionAndUnit)
{
  Cube turned;
  turned.axes[0] = "-6 0.6 0.8 0";
  turned.axes[1] = "-5 -1.6 1.2 0";
  turned.axes[2] = "-7 0 0 -3";
  const auto reader = UpdatedReaderOf(Put("CubeFilesTurned.cube", turned.bytes()));
  EXPECT_EQ(reader->GetNumberOfNotes(), 0);
  ExpectValues(reader->GetOutput(), "turned");
  ExpectPosition(reader->GetOutput(), { 1, 2, 4 }, { -1.5 + 2.4 - 3.2, 2.5 + 3.2 + 2.4, 7.0 });

  Cube sheared;
  sheared.axes[1] = "5 0.2 2 0";
  const auto nearest = UpdatedReaderOf(Put("CubeFilesSheared.cube", sheared.bytes()));
  ASSERT_EQ(nearest->GetNumberOfNotes(), 1);
  EXPECT_STREQ(
    nearest->GetNote(0), "its axes are not at right angles; they are taken as the nearest that are");
  EXPECT_NEAR(nearest->GetOutput()->GetSpacing()[1], std::hypot(0.2, 2.0), 1e-12);

  Cube flat;
  flat.axes[1] = "5 0 0 0";
  const auto asWorld = UpdatedReaderOf(Put("CubeFilesFlat.cube", flat.bytes()));
  ASSERT_EQ(asWorld->GetNumberOfNotes(), 1);
  EXPECT_STREQ(asWorld->GetNote(0), "its axes lie in a plane; they are taken as the world's");
  ExpectPosition(asWorld->GetOutput(), { 0, 0, 0 }, { -1.5, 2.5, 10.0 });
}

TEST(CubeFiles, PartsAreReadInAnyOrder)
{
  Cube cube(2);
  cube.atoms += " 2";
  const auto reader = ReaderOf(Put("CubeFilesParts.cube", cube.bytes()));
  for (const auto& part :
    std::vector<std::array<int, 6>>{ { 1, 5, 2, 3, 3, 4 }, { 0, 6, 0, 4, 5, 5 }, { 6, 6, 4, 4, 0, 5 } })
  {
    reader->UpdateExtent(part.data());
    int extent[6];
    reader->GetOutput()->GetExtent(extent);
    EXPECT_EQ(std::to_array(extent), part);
    ExpectValues(reader->GetOutput(), "part");
  }
}

TEST(CubeFiles, OfSeveralValuesTheFirstIsUsed)
{
  Cube values(3);
  values.atoms += " 3";
  Cube orbitals(3);
  orbitals.atoms = "-2 -1.5 2.5 10 1";
  orbitals.lines += " 3 14\n15 16\n";
  // As Molden writes them.
  Cube unsaid(2);
  unsaid.lines += "2 5 6\r\n";
  for (const Cube& cube : { values, orbitals, unsaid })
  {
    const auto reader = UpdatedReaderOf(Put("CubeFilesOrbitals.cube", cube.bytes()));
    ExpectValues(reader->GetOutput(), cube.lines);
    const int expected = cube.lines == unsaid.lines ? 2 : 3;
    EXPECT_EQ(reader->GetNumberOfFileComponents(), expected);
    ASSERT_EQ(reader->GetNumberOfNotes(), 1);
    EXPECT_EQ(
      reader->GetNote(0), "its voxels have " + std::to_string(expected) + " components; the first is used");
  }
  Cube one;
  one.atoms = "-2 -1.5 2.5 10";
  one.lines += "1 7\n";
  const auto reader = UpdatedReaderOf(Put("CubeFilesOrbital.cube", one.bytes()));
  ExpectValues(reader->GetOutput(), "one orbital");
  EXPECT_EQ(reader->GetNumberOfNotes(), 0);
}

TEST(CubeFiles, ValuesMayBeWhole)
{
  Cube whole;
  whole.atoms = "0 0 0 0";
  whole.axes[0] = "2 1 0 0";
  whole.axes[1] = "2 0 1 0";
  whole.axes[2] = "2 0 0 1";
  whole.lines.clear();
  whole.values = "1 4\n2 5\n1 6\n1 7\n";
  const auto reader = UpdatedReaderOf(Put("CubeFilesWhole.cube", whole.bytes()));
  EXPECT_EQ(reader->GetNumberOfNotes(), 0);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0), 1.0);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(1, 1, 1, 0), 7.0);
}

TEST(CubeFiles, AListOfOrbitalsMayTakeLines)
{
  Cube many(12);
  many.atoms = "-2 -1.5 2.5 10 1";
  many.lines += "12 1 2 3 4 5 6 7 8 9\n10 11\n12\n";
  const auto reader = UpdatedReaderOf(Put("CubeFilesMany.cube", many.bytes()));
  ExpectValues(reader->GetOutput(), "twelve orbitals");
  EXPECT_EQ(reader->GetNumberOfFileComponents(), 12);
}

TEST(CubeFiles, WhatCannotBeReadIsOneError)
{
  const struct
  {
    std::function<void(Cube&)> change;
    std::vector<std::string> words;
  } cases[] = {
    { [](Cube& cube) { cube.atoms = "two 0 0 0"; },
      { "it says 'two' where the number of atoms was expected" } },
    { [](Cube& cube) { cube.atoms = "2 0 nan 0"; },
      { "it says 'nan' where the position of the first voxel was expected" } },
    { [](Cube& cube) { cube.atoms = "2 0 0 0 0"; },
      { "it says '0' where a number of values of 1 or more was expected" } },
    { [](Cube& cube) { cube.atoms = "2 0 0 0 1000"; },
      { "bytes of text, but its header promises 210000 values" } },
    { [](Cube& cube) { cube.axes[0] = "0 1 0 0"; }, { "its header says dimensions 7 x 5 x 0" } },
    { [](Cube& cube) { cube.axes[0] = "-9e9 1 0 0"; },
      { "it says '-9e9' where a number of voxels was expected" } },
    { [](Cube& cube) { cube.axes[0] = "1000000 1 0 0"; },
      { "bytes of text, but its header promises 35000000 values" } },
    { [](Cube& cube) { cube.axes[2] = "7 0 0"; },
      { "a line ends where the step between voxels was expected" } },
    { [](Cube& cube) { cube.atoms = "2000000000 0 0 0"; }, { "the file ends where an atom was expected" } },
    { [](Cube& cube) { cube.values.clear(); }, { "the file ends where the first value was expected" } },
    { [](Cube& cube)
      {
        cube.atoms = "-2 0 0 0";
        cube.lines += "0\n";
      },
      { "it says '0' where a number of orbitals of 1 or more was expected" } },
    { [](Cube& cube)
      {
        cube.atoms = "-2 0 0 0";
        cube.lines += "2000000000 1\n";
      },
      { "the file ends where the number of an orbital was expected" } },
    { [](Cube& cube)
      {
        cube.atoms = "-2 0 0 0";
        cube.values = "1 1";
      },
      { "the file ends where the first value was expected" } },
    { [](Cube& cube) { cube.values.resize(cube.values.size() - 12); },
      { "it holds fewer values than its header promises" } },
    { [](Cube& cube) { cube.values.replace(9, 3, "abc"); }, { "where the number of a voxel was expected" } },
  };
  for (const auto& one : cases)
  {
    Cube cube;
    one.change(cube);
    ExpectRefused(Put("CubeFilesBroken.cube", cube.bytes()), one.words);
  }
  ExpectRefused(Put("CubeFilesTitle.cube", "title"), { "the file ends where a second title was expected" });
}
