// SPDX-License-Identifier: BSD-3-Clause
// Stacks of microscopes and micro-CT: TIFF 6.0 (Adobe 1992) and BigTIFF, with what ImageJ and OME-TIFF
// (I. Goldberg et al., The Open Microscopy Environment (OME) Data Model and XML file, Genome Biol. 6 (2005))
// write beside the first page about channels, times and distances.
#include "VolumeHeader.h"

#include "Core/FormatNumber.h"
#include "Pattern.h"
#include "ReadError.h"
#include "TiffFile.h"
#include "Words.h"

#include "vtkType.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

struct Page
{
  fs::path file;
  std::uint64_t directory;
  std::optional<std::uint64_t> plainOffset;
};

/// Pages whose values lie alike, and what is written beside the first.
struct Pages
{
  std::vector<Page> all;
  TiffLayout layout;
  bool bigEndian = false;
  std::string description;
  double pixelsPerUnit[2] = { 0, 0 };

  void add(const TiffFile& file)
  {
    this->all.push_back({ file.path(), file.directory(), file.plainOffset(this->layout) });
  }
  void begin(const TiffFile& file)
  {
    this->layout = file.layout();
    this->bigEndian = file.bigEndian();
    this->description = file.description();
    for (int axis = 0; axis < 2; ++axis)
    {
      this->pixelsPerUnit[axis] = file.pixelsPerUnit(axis);
    }
    this->add(file);
  }
};

Pages pagesOfFile(const fs::path& path, std::vector<std::string>& notes)
{
  TiffFile file(path);
  Pages pages;
  std::size_t others = 0;
  do
  {
    if (file.isReduced())
    {
      continue;
    }
    if (pages.all.empty())
    {
      pages.begin(file);
    }
    else if (file.layout() == pages.layout)
    {
      pages.add(file);
    }
    else
    {
      ++others;
    }
  } while (file.turnToNext());
  if (pages.all.empty())
  {
    failToRead(path, "all of its pages are smaller copies of others; expected the others as well");
  }
  if (others > 0)
  {
    notes.push_back(std::to_string(others) + " of its " + std::to_string(pages.all.size() + others) +
      " pages have another size or type than the first and are left out");
  }
  return pages;
}

bool isTiff(const fs::path& file)
{
  const std::string suffix = suffixOf(file);
  return suffix == ".tif" || suffix == ".tiff";
}

/// One slice of each file, in the order of the numbers in their names.
Pages pagesOfFolder(const fs::path& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    if (entry.is_regular_file() && isTiff(entry.path()))
    {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end(), comesBefore);
  Pages pages;
  for (const std::string& name : names)
  {
    TiffFile file(folder / name);
    if (pages.all.empty())
    {
      pages.begin(file);
    }
    else if (file.layout() != pages.layout || file.bigEndian() != pages.bigEndian)
    {
      failToRead(file.path(),
        "its page has another size, type or order of bytes than that of '" + pages.all.front().file.string() +
          "'; expected slices of one volume");
    }
    else
    {
      pages.add(file);
    }
    if (file.turnToNext() && !file.isReduced())
    {
      failToRead(file.path(), "it has several pages; expected one slice in each TIFF file of a folder");
    }
  }
  return pages;
}

/// @throws ReadError if pages promise more than their files can hold
void checkBytes(const Pages& pages, const fs::path& path)
{
  std::uint64_t stored = 0;
  bool isPlain = true;
  for (const Page& page : pages.all)
  {
    const bool isAnother = stored == 0 || page.file != pages.all.front().file;
    stored += isAnother ? static_cast<std::uint64_t>(fs::file_size(page.file)) : 0;
    isPlain = isPlain && page.plainOffset;
  }
  const double promised = static_cast<double>(pages.all.size()) * static_cast<double>(pages.layout.bytes());
  // Bits become bytes.
  const double mostPerByte = static_cast<double>(TiffFile::mostPerByte) * (pages.layout.bilevel ? 8.0 : 1.0);
  if (promised > static_cast<double>(stored) * (isPlain ? 1.0 : mostPerByte))
  {
    failToRead(path,
      "it has " + std::to_string(stored) + " bytes, but " + std::to_string(pages.all.size()) + " pages of " +
        std::to_string(pages.layout.width) + " x " + std::to_string(pages.layout.height) +
        " pixels, which need " + formatNumber(promised));
  }
}

/// What is said about how pages follow each other, and about distances; 0 where nothing is.
struct Stack
{
  std::size_t slices = 0;
  std::size_t channels = 1;
  std::size_t times = 1;
  std::size_t step = 1; ///< from a slice to the next one
  double spacing[3] = { 0, 0, 0 };
};

std::string wordAfter(std::string_view text, const std::string& key)
{
  std::string_view line;
  while (nextLine(text, line))
  {
    if (line.starts_with(key))
    {
      return std::string(line.substr(key.size()));
    }
  }
  return {};
}

std::size_t countIn(const std::string& word, std::size_t otherwise)
{
  constexpr double most = 1 << 30;
  const double number = numberIn(word).value_or(0.0);
  return number >= 1.0 && number <= most ? static_cast<std::size_t>(number) : otherwise;
}

/// ImageJ's lines of key=value: channels come first, then slices, then times.
Stack stackOfImageJ(const Pages& pages, std::size_t count)
{
  const std::string& text = pages.description;
  Stack stack;
  stack.channels = countIn(wordAfter(text, "channels="), 1);
  stack.times = countIn(wordAfter(text, "frames="), 1);
  stack.slices = countIn(wordAfter(text, "slices="), 0);
  if (stack.slices == 0)
  {
    stack.slices = std::max<std::size_t>(count / (stack.channels * stack.times), 1);
  }
  stack.step = stack.channels;
  for (int axis = 0; axis < 2; ++axis)
  {
    stack.spacing[axis] = pages.pixelsPerUnit[axis] > 0.0 ? 1.0 / pages.pixelsPerUnit[axis] : 0.0;
  }
  stack.spacing[2] = numberIn(wordAfter(text, "spacing=")).value_or(0.0);
  const std::string unit = wordAfter(text, "unit=");
  if (!(stack.spacing[2] != 0.0) && !unit.empty() && unit != "inch" && unit != "cm")
  {
    stack.spacing[2] = 1.0; // which ImageJ does not write
  }
  return stack;
}

/// An attribute of an element's tag; empty if it has none.
std::string attributeOf(const std::string& tag, const std::string& name)
{
  const std::vector<std::string> found = Pattern("\\s" + name + "\\s*=\\s*[\"']([^\"']*)[\"']").search(tag);
  return found.empty() ? "" : found[1];
}

/// The tag of OME's element Pixels, which is the first volume's; empty if there is none.
std::string pixelsOfOme(const std::string& text)
{
  const std::size_t begin = std::min(text.find("<Pixels "), text.find("<OME:Pixels "));
  const std::size_t end = text.find('>', std::min(begin, text.size()));
  constexpr std::size_t longest = 4096;
  return end != std::string::npos && end - begin < longest ? text.substr(begin, end - begin) : "";
}

Stack stackOfOme(const std::string& pixels)
{
  Stack stack;
  stack.slices = countIn(attributeOf(pixels, "SizeZ"), 1);
  stack.channels = countIn(attributeOf(pixels, "SizeC"), 1);
  stack.times = countIn(attributeOf(pixels, "SizeT"), 1);
  // As XYCZT: what stands before Z changes faster.
  const std::string order = attributeOf(pixels, "DimensionOrder");
  const std::string faster = order.substr(0, order.find('Z'));
  stack.step = (faster.find('C') != std::string::npos ? stack.channels : 1) *
    (faster.find('T') != std::string::npos ? stack.times : 1);
  const char* names[] = { "PhysicalSizeX", "PhysicalSizeY", "PhysicalSizeZ" };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    stack.spacing[axis] = numberIn(attributeOf(pixels, names[axis])).value_or(0.0);
  }
  return stack;
}

/// What the description says, if it speaks of as many pages as there are.
/// @param count of pages, or of those that the description promises
Stack stackOf(const Pages& pages, std::size_t count, std::vector<std::string>& notes)
{
  const std::string pixels = pixelsOfOme(pages.description);
  Stack stack = !pixels.empty()                ? stackOfOme(pixels)
    : pages.description.starts_with("ImageJ=") ? stackOfImageJ(pages, count)
                                               : Stack{};
  // Components of a pixel are channels that have no pages of their own.
  if (stack.slices * stack.times == count &&
    stack.channels == static_cast<std::size_t>(pages.layout.components))
  {
    stack.step = stack.step % stack.channels == 0 ? stack.step / stack.channels : stack.step;
    stack.channels = 1;
  }
  if (stack.slices * stack.channels * stack.times != count)
  {
    stack.slices = count;
    stack.channels = stack.times = stack.step = 1;
  }
  // Who writes an array of three axes without their names often means slices.
  constexpr std::size_t mostChannels = 5;
  if (stack.slices == 1 && (stack.times > 1 || stack.channels > mostChannels))
  {
    const bool isOfTimes = stack.times > 1;
    std::size_t& many = isOfTimes ? stack.times : stack.channels;
    notes.push_back("it has one slice of each of " + std::to_string(many) +
      (isOfTimes ? " times" : " channels") + ", which are taken as slices");
    std::swap(stack.slices, many);
    stack.step = isOfTimes ? stack.channels : 1;
  }
  if (stack.channels > 1)
  {
    notes.push_back("it has " + std::to_string(stack.channels) + " channels; the first is used");
  }
  if (stack.times > 1)
  {
    notes.push_back("it has " + std::to_string(stack.times) + " times; the first is used");
  }
  return stack;
}

int typeOf(const TiffLayout& layout)
{
  using Kind = TiffLayout::Kind;
  switch (layout.bits)
  {
    case 8:
      return layout.kind == Kind::Signed ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
    case 16:
      return layout.kind == Kind::Float ? VTK_FLOAT
        : layout.kind == Kind::Signed   ? VTK_SHORT
                                        : VTK_UNSIGNED_SHORT;
    case 32:
      return layout.kind == Kind::Float ? VTK_FLOAT
        : layout.kind == Kind::Signed   ? VTK_INT
                                        : VTK_UNSIGNED_INT;
    default:
      return layout.kind == Kind::Float ? VTK_DOUBLE
        : layout.kind == Kind::Signed   ? VTK_LONG_LONG
                                        : VTK_UNSIGNED_LONG_LONG;
  }
}

/// Where ImageJ has written more pages than a classic TIFF file can speak of: one directory, then all values.
/// @throws ReadError if there are fewer values than it says
std::size_t promisedPages(const Pages& pages)
{
  const Page& first = pages.all.front();
  if (pages.all.size() > 1 || !first.plainOffset || !pages.description.starts_with("ImageJ="))
  {
    return pages.all.size();
  }
  const std::size_t count = countIn(wordAfter(pages.description, "images="), 1);
  const auto size = static_cast<std::uint64_t>(fs::file_size(first.file));
  const std::uint64_t found = size - std::min(size, *first.plainOffset);
  if (static_cast<double>(count) * static_cast<double>(pages.layout.bytes()) > static_cast<double>(found))
  {
    failToRead(first.file,
      "it has " + std::to_string(found) + " bytes of data, but ImageJ's lines promise " +
        std::to_string(count) + " pages of " + std::to_string(pages.layout.bytes()) + " bytes");
  }
  return count;
}

void placeVoxels(const Pages& pages, const Stack& stack, std::size_t promised, RawVolume& voxels)
{
  const bool isPlain = std::all_of(
    pages.all.begin(), pages.all.end(), [](const Page& page) { return page.plainOffset.has_value(); });
  voxels.encoding = isPlain ? VoxelEncoding::Plain : VoxelEncoding::Pages;
  for (std::size_t slice = 0; slice < stack.slices; ++slice)
  {
    const std::size_t number = slice * stack.step;
    const bool isListed = promised == pages.all.size();
    const Page& page = pages.all[isListed ? number : 0];
    voxels.files.push_back(page.file);
    voxels.offsets.push_back(
      isPlain ? *page.plainOffset + (isListed ? 0 : number * pages.layout.bytes()) : page.directory);
  }
  voxels.dimensions[0] = pages.layout.width;
  voxels.dimensions[1] = pages.layout.height;
  voxels.dimensions[2] = static_cast<int>(stack.slices);
  voxels.type = typeOf(pages.layout);
  voxels.halves = pages.layout.kind == TiffLayout::Kind::Float && pages.layout.bits == 16;
  voxels.components = pages.layout.separate ? 1 : pages.layout.components;
  if (isPlain)
  {
    voxels.setBigEndian(pages.bigEndian);
  }
}

void placeSlices(const Stack& stack, VolumeHeader& header)
{
  const double* said = stack.spacing;
  header.spacing[0] = spacingOf(said[0] != 0.0 ? said[0] : said[1]);
  header.spacing[1] = spacingOf(said[1] != 0.0 ? said[1] : said[0]);
  header.spacing[2] = said[2] != 0.0 ? spacingOf(said[2]) : header.spacing[0];
  if (!(said[2] != 0.0) && stack.slices > 1)
  {
    header.notes.emplace_back(
      "it does not say how far its slices are apart; they are taken as far apart as its pixels");
  }
}

} // namespace

bool isFolderOfTiffs(const fs::path& folder)
{
  std::size_t files = 0;
  std::size_t tiffs = 0;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    files += entry.is_regular_file() ? 1 : 0;
    tiffs += entry.is_regular_file() && isTiff(entry.path()) ? 1 : 0;
  }
  return 2 * tiffs > files;
}

VolumeHeader readTiffHeader(const fs::path& path)
{
  VolumeHeader header;
  header.format = "TIFF stack";
  const Pages pages = fs::is_directory(path) ? pagesOfFolder(path) : pagesOfFile(path, header.notes);
  checkBytes(pages, path);
  const std::size_t promised = promisedPages(pages);
  const Stack stack = fs::is_directory(path) ? Stack{ .slices = promised, .spacing = {} }
                                             : stackOf(pages, promised, header.notes);
  if (pages.layout.kind == TiffLayout::Kind::Float && pages.layout.bits == 16 &&
    pages.layout.components > 1 && !pages.layout.separate)
  {
    failToRead(path, "its pixels are several floating-point numbers of 16 bits; expected one, or 32 bits");
  }
  placeVoxels(pages, stack, promised, header.voxels);
  header.components = pages.layout.components;
  placeSlices(stack, header);
  return header;
}

} // namespace ink::io
