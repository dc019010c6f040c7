// SPDX-License-Identifier: BSD-3-Clause
// MRC and CCP4 maps: every number of the header that is used, in either order of bytes, and what is refused.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

/// A header word by word, as the standard counts them from 1, and the values of Volume().
struct Map
{
  std::array<std::int32_t, 256> words{};
  bool bigEndian = false;
  std::string extended;
  std::string values;

  explicit Map(bool big = false)
    : bigEndian(big)
    , values(Bytes(big))
  {
    this->set(1, { Size[0], Size[1], Size[2], 1 });
    this->set(8, { Size[0], Size[1], Size[2] });
    this->setReal(11, { 7.0F, 10.0F, 3.0F, 90.0F, 90.0F, 90.0F });
    this->set(17, { 1, 2, 3 });
    this->set(23, { 1 });
    this->setBytes(53, "MAP ");
    this->setBytes(54, big ? std::string("\x11\x11\0\0", 4) : std::string("\x44\x44\0\0", 4));
  }

  void set(std::size_t word, std::initializer_list<std::int32_t> numbers)
  {
    std::copy(numbers.begin(), numbers.end(), this->words.begin() + static_cast<std::ptrdiff_t>(word) - 1);
  }
  void setReal(std::size_t word, std::initializer_list<float> numbers)
  {
    for (const float number : numbers)
    {
      this->words[word++ - 1] = std::bit_cast<std::int32_t>(number);
    }
  }
  /// In the file as they are, in either order of bytes.
  void setBytes(std::size_t word, const std::string& bytes)
  {
    std::string swapped = bytes;
    if (this->bigEndian)
    {
      std::reverse(swapped.begin(), swapped.end());
    }
    std::memcpy(&this->words[word - 1], swapped.data(), 4);
  }

  std::string bytes() const
  {
    std::string all;
    for (const std::int32_t word : this->words)
    {
      std::array<char, 4> one;
      std::memcpy(one.data(), &word, 4);
      if (this->bigEndian)
      {
        std::reverse(one.begin(), one.end());
      }
      all.append(one.begin(), one.end());
    }
    return all + this->extended + this->values;
  }
};

void ExpectMap(vtkImageData* image, const std::string& name)
{
  ASSERT_EQ(image->GetNumberOfPoints(), Size[0] * Size[1] * Size[2]) << name;
  ASSERT_EQ(image->GetScalarType(), VTK_SHORT) << name;
  ExpectValues(image, name);
}

} // namespace

TEST(MrcMaps, ValuesAreReadInEitherOrderOfBytesAndFromCompressedFiles)
{
  Map extended;
  extended.extended = std::string(160, 'x');
  extended.set(24, { 160 });
  Map unstamped(true);
  unstamped.setBytes(54, std::string(4, '\0'));
  for (const std::string& file :
    { Put("MrcMapsLittle.mrc", Map().bytes()), Put("MrcMapsBig.map", Map(true).bytes()),
      Put("MrcMapsExtended.ccp4", extended.bytes()), Put("MrcMapsUnstamped.mrc", unstamped.bytes()),
      Gzip("MrcMaps.map.gz", Map().bytes()), Gzip("MrcMapsExtended.mrc.gz", extended.bytes()) })
  {
    const auto reader = UpdatedReaderOf(file);
    EXPECT_EQ(reader->CanReadFile(file.c_str()), 1) << file;
    EXPECT_STREQ(reader->GetFormat(), "MRC map") << file;
    EXPECT_EQ(reader->GetNumberOfNotes(), 0) << file;
    EXPECT_EQ(reader->HasPlainVoxels(), !file.ends_with(".gz")) << file;
    ExpectMap(reader->GetOutput(), file);
    EXPECT_EQ(PositionOf(reader->GetOutput(), 1, 1, 1), (std::array{ 1.0, 2.0, 0.5 })) << file;
  }
}

TEST(MrcMaps, ModesHaveTheirTypes)
{
  const struct
  {
    int mode;
    int type;
    std::string first;
    double value;
  } modes[] = { { 0, VTK_SIGNED_CHAR, "\xfe", -2.0 }, { 1, VTK_SHORT, std::string("\xfe\xff", 2), -2.0 },
    { 2, VTK_FLOAT, std::string("\0\0\x20\xc0", 4), -2.5 },
    { 6, VTK_UNSIGNED_SHORT, std::string("\xfe\xff", 2), 65534.0 },
    { 12, VTK_FLOAT, std::string("\0\xc1", 2), -2.5 } };
  for (const auto& mode : modes)
  {
    Map map;
    map.set(4, { mode.mode });
    map.values.clear();
    for (int i = 0; i < Size[0] * Size[1] * Size[2]; ++i)
    {
      map.values += mode.first;
    }
    const auto reader = UpdatedReaderOf(Put("MrcMapsMode.mrc", map.bytes()));
    ASSERT_EQ(reader->GetOutput()->GetScalarType(), mode.type) << mode.mode;
    EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(6, 4, 5, 0), mode.value) << mode.mode;
  }
}

TEST(MrcMaps, AxesRunAsTheHeaderSays)
{
  // Columns along z, rows along x, sections along y; the cell is 12 x 14 x 30 of 6, 7 and 15 samples.
  Map map;
  map.set(17, { 3, 1, 2 });
  map.set(8, { 6, 7, 15 });
  map.setReal(11, { 12.0F, 14.0F, 45.0F });
  map.set(5, { 10, 20, 30 });
  const auto image =
    vtkSmartPointer<vtkImageData>(UpdatedReaderOf(Put("MrcMapsAxes.map", map.bytes()))->GetOutput());
  ExpectMap(image, "axes");
  // The map starts 10 columns, 20 rows and 30 sections from the cell's corner.
  EXPECT_EQ(PositionOf(image, 0, 0, 0), (std::array{ 40.0, 60.0, 30.0 }));
  EXPECT_EQ(PositionOf(image, 1, 0, 0), (std::array{ 40.0, 60.0, 33.0 }));
  EXPECT_EQ(PositionOf(image, 0, 1, 0), (std::array{ 42.0, 60.0, 30.0 }));
  EXPECT_EQ(PositionOf(image, 0, 0, 1), (std::array{ 40.0, 62.0, 30.0 }));

  map.setReal(50, { -1.5F, 0.0F, 2.5F });
  const auto placed = UpdatedReaderOf(Put("MrcMapsOrigin.map", map.bytes()));
  EXPECT_EQ(PositionOf(placed->GetOutput(), 0, 0, 0), (std::array{ -1.5, 0.0, 2.5 }))
    << "the origin is known";
}

TEST(MrcMaps, WhatIsNotSaidIsAsUsual)
{
  Map map;
  map.set(8, { 0, 0, 0 });
  map.setReal(11, { 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F });
  map.set(17, { 0, 0, 0 });
  const auto reader = UpdatedReaderOf(Put("MrcMapsUsual.mrc", map.bytes()));
  ExpectMap(reader->GetOutput(), "usual");
  EXPECT_EQ(PositionOf(reader->GetOutput(), 1, 1, 1), (std::array{ 1.0, 1.0, 1.0 }));
  EXPECT_EQ(reader->GetNumberOfNotes(), 0);
}

TEST(MrcMaps, OldOnesThatDoNotSayWhatTheyAreHaveTheRightSize)
{
  Map map;
  map.setBytes(53, std::string(4, '\0'));
  map.extended = std::string(8, ' ');
  map.set(24, { 8 });
  ExpectMap(UpdatedReaderOf(Put("MrcMapsOld.mrc", map.bytes()))->GetOutput(), "old");
}

TEST(MrcMaps, NotesWhatIsNotUsed)
{
  Map oblique;
  oblique.setReal(14, { 90.0F, 90.0F, 120.0F });
  const auto reader = UpdatedReaderOf(Put("MrcMapsOblique.map", oblique.bytes()));
  ASSERT_EQ(reader->GetNumberOfNotes(), 1);
  EXPECT_NE(std::string(reader->GetNote(0)).find("90 90 120 degrees"), std::string::npos)
    << reader->GetNote(0);
  ExpectMap(reader->GetOutput(), "oblique");

  // Two volumes of three sections.
  Map stack;
  stack.set(23, { 401 });
  stack.set(8, { Size[0], Size[1], 3 });
  const auto first = UpdatedReaderOf(Put("MrcMapsStack.mrc", stack.bytes()));
  EXPECT_EQ(first->GetOutput()->GetDimensions()[2], 3);
  ASSERT_EQ(first->GetNumberOfNotes(), 1);
  EXPECT_STREQ(first->GetNote(0), "it has 2 volumes; the first is used");
}

TEST(MrcMaps, WhatCannotBeReadIsOneError)
{
  const struct
  {
    std::function<void(Map&)> change;
    std::vector<std::string> words;
  } cases[] = {
    { [](Map& map)
      {
        map.setBytes(53, "NOPE");
        map.values += '\0';
      },
      { "it is not an MRC or CCP4 map", "'MAP ' at byte 208" } },
    { [](Map& map)
      {
        map.setBytes(53, "NOPE");
        map.set(4, { 4 });
      },
      { "'MAP ' at byte 208" } },
    { [](Map& map) { map.set(4, { 4 }); }, { "its header says mode 4; expected 0 (int8), 1 (int16)" } },
    { [](Map& map) { map.set(4, { 101 }); }, { "its header says mode 101" } },
    { [](Map& map) { map.set(1, { 0 }); }, { "its header says dimensions 0 x 5 x 6" } },
    { [](Map& map) { map.set(2, { -5 }); }, { "its header says dimensions 7 x -5 x 6" } },
    { [](Map& map) {
       map.set(17, { 1, 1, 3 });
     },
      { "along the axes 1 x 1 x 3; expected 1, 2 and 3 in any order" } },
    { [](Map& map) { map.set(24, { -1 }); }, { "its header says that -1 bytes follow" } },
    { [](Map& map) { map.set(24, { 1 << 30 }); }, { "it has 0 bytes of data, but its header promises 420" } },
    { [](Map& map) { map.values.resize(100); }, { "it has 100 bytes of data, but its header promises 420" } },
    { [](Map& map) {
       map.set(1, { 1 << 30, 1 << 30, 1 << 30 });
     },
      { "its header says dimensions" } },
  };
  for (const auto& one : cases)
  {
    Map map;
    one.change(map);
    ExpectRefused(Put("MrcMapsBroken.mrc", map.bytes()), one.words);
  }
  ExpectRefused(Put("MrcMapsShort.map", Map().bytes().substr(0, 1000)),
    { "it has 1000 bytes; expected an MRC or CCP4 map, whose header has 1024" });
}
