// SPDX-License-Identifier: BSD-3-Clause
// TIFF stacks as libtiff writes them: plain, compressed, in tiles and as planes, with what ImageJ and OME say
// beside the first page, in folders, and what is refused.

#include "VolumeTestFiles.h"
#include "VolumeTestReading.h"

#include <gtest/gtest.h>

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

using namespace VolumeTestFiles;
using namespace VolumeTestReading;

namespace
{

/// How the pages are written that hold the slices of Volume().
struct Stack
{
  int pages = Size[2];
  int compression = COMPRESSION_NONE;
  int components = 1;
  bool separate = false;
  bool tiled = false;
  int rowsPerStrip = 2;
  std::string mode = "w";
  std::string description{};
  float pixelsPerUnit = 0.0F;
  std::function<void(TIFF*, int page)> change{}; ///< of a page before its values are written
  std::function<int(int page)> sliceOf = [](int page) { return page; };
};

void WriteRows(TIFF* tiff, const Stack& stack, int slice)
{
  const int planes = stack.separate ? stack.components : 1;
  const int samples = stack.separate ? 1 : stack.components;
  std::vector<short> row(static_cast<std::size_t>(Size[0] * samples));
  for (int plane = 0; plane < planes; ++plane)
  {
    for (int y = 0; y < Size[1]; ++y)
    {
      for (int i = 0; i < Size[0] * samples; ++i)
      {
        row[static_cast<std::size_t>(i)] =
          static_cast<short>(ValueAt(i / samples, y, slice) + 7 * (plane + i % samples));
      }
      TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(y), static_cast<std::uint16_t>(plane));
    }
  }
}

void WriteTiles(TIFF* tiff, int slice)
{
  constexpr int length = 16; // the least there is, wider than the page
  std::array<short, std::size_t{ length } * length> tile{};
  for (int y = 0; y < Size[1]; ++y)
  {
    for (int x = 0; x < Size[0]; ++x)
    {
      tile[static_cast<std::size_t>(y * length + x)] = ValueAt(x, y, slice);
    }
  }
  TIFFWriteTile(tiff, tile.data(), 0, 0, 0, 0);
}

std::string WriteStack(const std::string& name, const Stack& stack)
{
  TIFF* tiff = TIFFOpen(name.c_str(), stack.mode.c_str());
  for (int page = 0; page < stack.pages; ++page)
  {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, Size[0]);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, Size[1]);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_INT);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, stack.components);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, stack.compression);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, stack.separate ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
    if (stack.tiled)
    {
      TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
      TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
    }
    else
    {
      TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, stack.rowsPerStrip);
    }
    if (page == 0 && !stack.description.empty())
    {
      TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, stack.description.c_str());
    }
    if (stack.pixelsPerUnit > 0.0F)
    {
      TIFFSetField(tiff, TIFFTAG_XRESOLUTION, static_cast<double>(stack.pixelsPerUnit));
      TIFFSetField(tiff, TIFFTAG_YRESOLUTION, static_cast<double>(stack.pixelsPerUnit) / 2.0);
    }
    if (stack.change)
    {
      stack.change(tiff, page);
    }
    if (stack.tiled)
    {
      WriteTiles(tiff, stack.sliceOf(page));
    }
    else
    {
      WriteRows(tiff, stack, stack.sliceOf(page));
    }
    TIFFWriteDirectory(tiff);
  }
  TIFFClose(tiff);
  return name;
}

void ExpectStack(vtkInkVolumeReader* reader, const std::string& name, int slices = Size[2])
{
  vtkImageData* image = reader->GetOutput();
  const int dimensions[3] = { Size[0], Size[1], slices };
  ASSERT_TRUE(std::equal(dimensions, dimensions + 3, image->GetDimensions())) << name;
  ASSERT_EQ(image->GetScalarType(), VTK_SHORT) << name;
  ExpectValues(image, name);
}

std::string NotesOf(vtkInkVolumeReader* reader)
{
  std::string notes;
  for (int i = 0; i < reader->GetNumberOfNotes(); ++i)
  {
    notes.append(i ? "; " : "").append(reader->GetNote(i));
  }
  return notes;
}

constexpr const char* unknownDistance =
  "it does not say how far its slices are apart; they are taken as far apart as its pixels";

} // namespace

TEST(TiffStacks, ValuesAreThoseOfThePagesHoweverTheyAreStored)
{
  const struct
  {
    const char* name;
    Stack stack;
    bool isPlain;
  } cases[] = { { "plain", {}, true }, { "one strip", { .rowsPerStrip = Size[1] }, true },
    { "big-endian", { .mode = "wb" }, true }, { "BigTIFF", { .mode = "w8" }, true },
    { "LZW", { .compression = COMPRESSION_LZW }, false },
    { "deflate", { .compression = COMPRESSION_ADOBE_DEFLATE, .mode = "wb" }, false },
    { "PackBits", { .compression = COMPRESSION_PACKBITS }, false },
    { "predicted",
      { .compression = COMPRESSION_LZW,
        .change = [](TIFF* tiff, int) { TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL); } },
      false },
    { "tiles", { .tiled = true }, false },
    { "compressed tiles", { .compression = COMPRESSION_ADOBE_DEFLATE, .tiled = true }, false },
    { "two components", { .components = 2 }, true },
    { "two planes", { .components = 2, .separate = true }, true },
    { "two compressed planes", { .compression = COMPRESSION_LZW, .components = 2, .separate = true },
      false } };
  for (const auto& one : cases)
  {
    const auto reader = UpdatedReaderOf(WriteStack("TiffStacks.tif", one.stack));
    ExpectStack(reader, one.name);
    EXPECT_EQ(reader->CanReadFile("TiffStacks.tif"), 1) << one.name;
    EXPECT_STREQ(reader->GetFormat(), "TIFF stack") << one.name;
    EXPECT_EQ(reader->HasPlainVoxels(), one.isPlain) << one.name;
    EXPECT_EQ(reader->GetNumberOfFileComponents(), one.stack.components) << one.name;
    EXPECT_NE(NotesOf(reader).find(unknownDistance), std::string::npos) << one.name;
    const double ones[3] = { 1, 1, 1 };
    EXPECT_TRUE(std::equal(ones, ones + 3, reader->GetOutput()->GetSpacing())) << one.name;
  }
}

TEST(TiffStacks, PartsAreThoseOfTheWhole)
{
  for (const int compression : { COMPRESSION_NONE, COMPRESSION_LZW })
  {
    const std::string file = WriteStack("TiffStacksPart.tiff", { .compression = compression });
    vtkNew<vtkInkVolumeReader> reader;
    reader->SetFileName(file.c_str());
    for (const auto& wanted : { std::array{ 0, 6, 0, 4, 4, 5 }, std::array{ 2, 3, 1, 2, 1, 3 } })
    {
      int extent[6];
      std::copy(wanted.begin(), wanted.end(), extent);
      reader->UpdateExtent(extent);
      for (int z = extent[4]; z <= extent[5]; ++z)
      {
        EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(3, 2, z, 0), ValueAt(3, 2, z));
        EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(2, 1, z, 0), ValueAt(2, 1, z));
      }
    }
  }
}

TEST(TiffStacks, ImageJSaysDistancesChannelsAndTimes)
{
  // Channels change fastest, then slices: of 2 channels and 2 times, all but the first hold other slices.
  const Stack hyperstack{ .pages = 2 * 3 * 2,
    .description = "ImageJ=1.53t\nimages=12\nchannels=2\nslices=3\nframes=2\nhyperstack=true\nunit=micron\n"
                   "spacing=1.5\nloop=false\n",
    .pixelsPerUnit = 4.0F,
    .sliceOf = [](int page) { return page < 6 && page % 2 == 0 ? page / 2 : 100; } };
  const auto reader = UpdatedReaderOf(WriteStack("TiffStacksImageJ.tif", hyperstack));
  ExpectStack(reader, "hyperstack", 3);
  const double spacing[3] = { 0.25, 0.5, 1.5 };
  EXPECT_TRUE(std::equal(spacing, spacing + 3, reader->GetOutput()->GetSpacing()));
  EXPECT_EQ(NotesOf(reader), "it has 2 channels; the first is used; it has 2 times; the first is used");

  // ImageJ does not write a distance of 1, but writes resolutions of pictures.
  const auto unwritten = UpdatedReaderOf(WriteStack("TiffStacksImageJ.tif",
    { .description = "ImageJ=1.53t\nimages=6\nslices=6\nunit=mm\n", .pixelsPerUnit = 4.0F }));
  EXPECT_EQ(unwritten->GetOutput()->GetSpacing()[2], 1.0);
  EXPECT_EQ(NotesOf(unwritten), "");
  const auto printed = UpdatedReaderOf(WriteStack("TiffStacksImageJ.tif",
    { .description = "ImageJ=1.53t\nimages=6\nslices=6\nunit=inch\n", .pixelsPerUnit = 72.0F }));
  EXPECT_EQ(printed->GetOutput()->GetSpacing()[2], printed->GetOutput()->GetSpacing()[0]);
  EXPECT_EQ(NotesOf(printed), unknownDistance);
}

TEST(TiffStacks, SlicesThatAreCalledTimesOrChannelsAreSlices)
{
  const auto times = UpdatedReaderOf(
    WriteStack("TiffStacksTimes.tif", { .description = "ImageJ=1.53t\nimages=6\nframes=6\nunit=mm\n" }));
  ExpectStack(times, "times");
  EXPECT_EQ(NotesOf(times), "it has one slice of each of 6 times, which are taken as slices");
  const auto channels = UpdatedReaderOf(
    WriteStack("TiffStacksTimes.tif", { .description = "ImageJ=1.53t\nimages=6\nchannels=6\nunit=mm\n" }));
  ExpectStack(channels, "channels");
  EXPECT_EQ(NotesOf(channels), "it has one slice of each of 6 channels, which are taken as slices");
}

TEST(TiffStacks, ImageJsLargeFilesHaveOneDirectoryForAllSlices)
{
  const std::string file = WriteStack("TiffStacksVirtual.tif",
    { .pages = 1, .rowsPerStrip = Size[1], .description = "ImageJ=1.53t\nimages=6\nslices=6\nunit=mm\n" });
  // The values of the first page come before its directory: put all in their place, behind the file's end.
  TIFF* tiff = TIFFOpen(file.c_str(), "r");
  std::uint64_t* offsets = nullptr;
  TIFFGetField(tiff, TIFFTAG_STRIPOFFSETS, &offsets);
  const auto offset = static_cast<std::uint32_t>(offsets[0]);
  TIFFClose(tiff);
  std::string bytes = ink::io::contentsOf(file);
  const auto end = static_cast<std::uint32_t>(bytes.size());
  std::string tag("\x11\x01\x04\x00\x01\x00\x00\x00", 8);
  const std::size_t entry = bytes.find(tag + std::string(reinterpret_cast<const char*>(&offset), 4));
  ASSERT_NE(entry, std::string::npos);
  std::memcpy(&bytes[entry + 8], &end, 4);
  const auto reader = UpdatedReaderOf(Put(file, bytes + Bytes(false)));
  ExpectStack(reader, "one directory");
  EXPECT_TRUE(reader->HasPlainVoxels());

  ExpectRefused(Put("TiffStacksVirtualShort.tif", bytes + Bytes(false).substr(0, 400)),
    { "it has 400 bytes of data, but ImageJ's lines promise 6 pages of 70 bytes" });
  ExpectRefused(
    WriteStack("TiffStacksVirtualMany.tif",
      { .pages = 1, .rowsPerStrip = Size[1], .description = "ImageJ=1.53t\nimages=1000000000\n" }),
    { "promise 1000000000 pages of 70 bytes" });
}

TEST(TiffStacks, OmeSaysDistancesAndTheOrderOfPages)
{
  const auto ome = [](const std::string& order)
  {
    return "<?xml version=\"1.0\"?><OME xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\"><Image "
           "ID=\"Image:0\"><Pixels ID=\"Pixels:0\" Type=\"int16\" SizeX=\"7\" SizeY=\"5\" SizeZ=\"3\" "
           "SizeC=\"2\" "
           "SizeT=\"2\" PhysicalSizeX=\"0.1\" PhysicalSizeY=\"0.2\" PhysicalSizeZ=\"0.5\" DimensionOrder=\"" +
      order + "\"/></Image></OME>";
  };
  const struct
  {
    const char* order;
    std::function<int(int)> sliceOf;
  } cases[] = { { "XYZCT", [](int page) { return page < 3 ? page : 100; } },
    { "XYCZT", [](int page) { return page < 6 && page % 2 == 0 ? page / 2 : 100; } },
    { "XYTZC", [](int page) { return page < 6 && page % 2 == 0 ? page / 2 : 100; } },
    { "XYCTZ", [](int page) { return page % 4 == 0 ? page / 4 : 100; } } };
  for (const auto& one : cases)
  {
    const auto reader = UpdatedReaderOf(WriteStack(
      "TiffStacks.ome.tif", { .pages = 12, .description = ome(one.order), .sliceOf = one.sliceOf }));
    ExpectStack(reader, one.order, 3);
    const double spacing[3] = { 0.1, 0.2, 0.5 };
    EXPECT_TRUE(std::equal(spacing, spacing + 3, reader->GetOutput()->GetSpacing())) << one.order;
    EXPECT_EQ(NotesOf(reader), "it has 2 channels; the first is used; it has 2 times; the first is used")
      << one.order;
  }
  // One file of several that belong together has other pages than are said.
  const auto part = UpdatedReaderOf(WriteStack("TiffStacks.ome.tif", { .description = ome("XYZCT") }));
  ExpectStack(part, "part");
}

TEST(TiffStacks, FoldersAreStacksInTheOrderOfNumbers)
{
  std::filesystem::remove_all("TiffStacksFolder");
  std::filesystem::create_directory("TiffStacksFolder");
  for (int z = 0; z < Size[2]; ++z)
  {
    WriteStack("TiffStacksFolder/slice" + std::to_string(z + 8) + ".tif",
      { .pages = 1, .compression = COMPRESSION_LZW, .sliceOf = [z](int) { return z; } });
  }
  Put("TiffStacksFolder/notes.txt", "words");
  const auto reader = UpdatedReaderOf("TiffStacksFolder");
  ExpectStack(reader, "folder");
  EXPECT_EQ(NotesOf(reader), unknownDistance);

  WriteStack("TiffStacksFolder/slice20.tif", { .pages = 2 });
  ExpectRefused("TiffStacksFolder", { "slice20.tif", "it has several pages; expected one slice in each" });
  WriteStack("TiffStacksFolder/slice20.tif", { .pages = 1, .components = 2 });
  ExpectRefused("TiffStacksFolder", { "slice20.tif", "another size, type or order of bytes than that of" });
}

TEST(TiffStacks, PagesThatAreNoSlicesAreLeftOut)
{
  // A smaller copy before all, and a map of another type behind.
  const Stack stack{ .pages = Size[2] + 2,
    .change =
      [](TIFF* tiff, int page)
    {
      if (page == 0)
      {
        TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE);
      }
      if (page == Size[2] + 1)
      {
        TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
      }
    },
    .sliceOf = [](int page) { return page - 1; } };
  const auto reader = UpdatedReaderOf(WriteStack("TiffStacksOthers.tif", stack));
  ExpectStack(reader, "others");
  EXPECT_EQ(
    NotesOf(reader).find("1 of its 7 pages have another size or type than the first and are left out"), 0u)
    << NotesOf(reader);
}

TEST(TiffStacks, BitsAreBlackAndWhite)
{
  // Two pages of rows of 11 pixels, which end within a byte.
  constexpr std::array<std::array<unsigned char, 2>, 3> rows{ { { 0b10110000, 0b01000000 },
    { 0b00000001, 0b11100000 }, { 0b11111111, 0b11100000 } } };
  const auto isSet = [&rows](int x, int y)
  { return (rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x / 8)] >> (7 - x % 8) & 1) != 0; };
  const auto write = [&rows](const std::string& name, int photometric, int compression)
  {
    TIFF* tiff = TIFFOpen(name.c_str(), "w");
    for (int page = 0; page < 2; ++page)
    {
      TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 11);
      TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 3);
      TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 1);
      TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
      TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, photometric);
      TIFFSetField(tiff, TIFFTAG_COMPRESSION, compression);
      TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 2);
      for (std::uint32_t y = 0; y < rows.size(); ++y)
      {
        std::array<unsigned char, 2> row = rows[y];
        TIFFWriteScanline(tiff, row.data(), y, 0);
      }
      TIFFWriteDirectory(tiff);
    }
    TIFFClose(tiff);
    return name;
  };
  for (const int compression : { COMPRESSION_NONE, COMPRESSION_PACKBITS, COMPRESSION_CCITTFAX4 })
  {
    for (const int photometric : { PHOTOMETRIC_MINISBLACK, PHOTOMETRIC_MINISWHITE })
    {
      const auto reader = UpdatedReaderOf(write("TiffStacksBits.tif", photometric, compression));
      vtkImageData* image = reader->GetOutput();
      ASSERT_EQ(image->GetNumberOfPoints(), 11 * 3 * 2) << compression << " " << photometric;
      EXPECT_EQ(image->GetScalarType(), VTK_UNSIGNED_CHAR);
      for (int i = 0; i < 11 * 3 * 2; ++i)
      {
        const int x = i % 11;
        const int y = i / 11 % 3;
        const bool isWhite = isSet(x, y) == (photometric == PHOTOMETRIC_MINISBLACK);
        EXPECT_EQ(image->GetScalarComponentAsDouble(x, y, i / 33, 0), isWhite ? 1.0 : 0.0)
          << compression << " " << photometric << " " << x << " " << y;
      }
    }
  }
}

TEST(TiffStacks, SpacingIsGivenInPlaceOfTheFiles)
{
  vtkNew<vtkInkVolumeReader> reader;
  reader->SetFileName(WriteStack("TiffStacksSpacing.tif", {}).c_str());
  reader->SetSpacing(0.0, -2.0, 3.0);
  reader->UpdateInformation();
  const double expected[3] = { 1, 2, 3 };
  EXPECT_TRUE(
    std::equal(expected, expected + 3, reader->GetOutputInformation(0)->Get(vtkDataObject::SPACING())));
  reader->Update();
  EXPECT_TRUE(std::equal(expected, expected + 3, reader->GetOutput()->GetSpacing()));
}

TEST(TiffStacks, WhatCannotBeReadIsOneError)
{
  ExpectRefused(Put("TiffStacksWords.tif", "These are words, not voxels.\n"), { "it is no TIFF file" });
  const auto with = [](std::uint32_t tag, int value)
  {
    return WriteStack("TiffStacksBroken.tif",
      { .pages = 1, .change = [=](TIFF* tiff, int) { TIFFSetField(tiff, tag, value); } });
  };
  ExpectRefused(
    with(TIFFTAG_BITSPERSAMPLE, 1), { "its values have 1 bits and sample format 2; expected integers" });
  ExpectRefused(with(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_COMPLEXINT), { "16 bits and sample format 5" });
  ExpectRefused(with(TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE), { "all of its pages are smaller copies" });
  ExpectRefused(with(TIFFTAG_IMAGEDEPTH, 2), { "expected 1 or more, in one layer" });

  // The end of what is compressed, or of the list of pages, is missing.
  const std::string whole = WriteStack("TiffStacksWhole.tif", { .compression = COMPRESSION_ADOBE_DEFLATE });
  const std::string bytes = ink::io::contentsOf(whole);
  ExpectRefused(
    Put("TiffStacksCut.tif", bytes.substr(0, bytes.size() / 2)), { "one of its pages is damaged" });
  for (const char* mode : { "w", "w8b" })
  {
    const std::string plain = WriteStack("TiffStacksPlain.tif", { .rowsPerStrip = Size[1], .mode = mode });
    ExpectRefused(
      CutShort(plain, "TiffStacksCut.tif", 2), { "it ends before it says whether there are more" });
  }
  std::string spoiled = bytes;
  std::fill(spoiled.begin() + 8, spoiled.begin() + 30, '\xff');
  ExpectRefused(Put("TiffStacksSpoiled.tif", spoiled), { "a page of it cannot be unpacked" });
}
