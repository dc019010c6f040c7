// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelBytes.h"

#include "Core/ParallelChunks.h"
#include "DicomPixels.h"
#include "FileHandle.h"
#include "Inflater.h"
#include "RawVolume.h"
#include "ReadError.h"
#include "TiffFile.h"
#include "Words.h"

#include "vtkSetGet.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace ink::io
{
namespace
{

/// Of one file or several, each with as many bytes.
class StoredBytes : public VoxelBytes
{
public:
  explicit StoredBytes(const RawVolume& voxels)
    : Voxels(voxels)
    , PartBytes(voxels.fileBytes() / voxels.files.size())
  {
    this->openPart(0);
  }

  void read(std::uint64_t position, std::span<unsigned char> bytes) override
  {
    while (!bytes.empty())
    {
      const auto part = static_cast<std::size_t>(position / this->PartBytes);
      if (part != this->Part)
      {
        this->openPart(part);
      }
      const std::uint64_t within = position % this->PartBytes;
      const auto some = bytes.first(
        static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), this->PartBytes - within)));
      const std::uint64_t from = this->Voxels.offsetIn(part) + within;
      // Once more where that failed, for errno, which each thread has of its own.
      if (!this->readInChunks(from, some) && readAt(this->File.get(), from, some) != some.size())
      {
        failToRead(
          this->Voxels.files[part], errno ? std::strerror(errno) : "it was cut short while it was read");
      }
      position += some.size();
      bytes = bytes.subspan(some.size());
    }
  }

private:
  /// What a page cache holds is copied, and new pages of memory are cleared, on all threads.
  bool readInChunks(std::uint64_t position, std::span<unsigned char> bytes) const
  {
    constexpr std::size_t bytesOfAChunk = 1 << 20;
    std::atomic<bool> isWhole = true;
    parallelForChunks(
      bytes.size(),
      [&](std::size_t, std::size_t begin, std::size_t end)
      {
        if (readAt(this->File.get(), position + begin, bytes.subspan(begin, end - begin)) != end - begin)
        {
          isWhole = false;
        }
      },
      bytesOfAChunk);
    return isWhole;
  }

  void openPart(std::size_t part)
  {
    this->Part = part;
    this->File = openToRead(this->Voxels.files.at(part));
  }

  RawVolume Voxels;
  std::uint64_t PartBytes;
  std::size_t Part = 0;
  FileHandle File;
};

/// What can only be read from its beginning on.
class SerialBytes : public VoxelBytes
{
public:
  void read(std::uint64_t position, std::span<unsigned char> bytes) final
  {
    if (position < this->Position)
    {
      throw std::logic_error("VoxelBytes: backwards in voxels that are not stored plain");
    }
    std::array<unsigned char, 1 << 12> skipped;
    while (this->Position < position)
    {
      const auto some =
        static_cast<std::size_t>(std::min<std::uint64_t>(skipped.size(), position - this->Position));
      this->next(std::span(skipped).first(some));
      this->Position += some;
    }
    this->next(bytes);
    this->Position += bytes.size();
  }

protected:
  virtual void next(std::span<unsigned char> bytes) = 0;

private:
  std::uint64_t Position = 0;
};

class InflatedBytes : public SerialBytes
{
public:
  explicit InflatedBytes(const RawVolume& voxels)
    : File(voxels.files.front())
    , Stream(voxels.files.front(), voxels.offset)
  {
    std::vector<unsigned char> skipped(static_cast<std::size_t>(voxels.skipped));
    this->InflatedBytes::next(skipped);
  }

protected:
  void next(std::span<unsigned char> bytes) override
  {
    if (this->Stream.read(bytes) != bytes.size())
    {
      failToRead(this->File, "its compressed data ends before the values that its header promises do");
    }
  }

private:
  std::filesystem::path File;
  Inflater Stream;
};

/// Written by anyone for one type and read as another.
template <class T>
void append(std::vector<unsigned char>& bytes, double number)
{
  T value{};
  if constexpr (std::is_floating_point_v<T>)
  {
    value = static_cast<T>(number);
  }
  else
  {
    // Of 64 bits, the greatest is no double: the next above it is one more.
    const double least = static_cast<double>(std::numeric_limits<T>::lowest());
    const double greatest = static_cast<double>(std::numeric_limits<T>::max());
    if (number >= greatest)
    {
      value = std::numeric_limits<T>::max();
    }
    else if (number > least)
    {
      value = static_cast<T>(number);
    }
    else
    {
      value = number <= least ? std::numeric_limits<T>::lowest() : T{};
    }
  }
  const auto* begin = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), begin, begin + sizeof(T));
}

/// What is made piece by piece from the rest of a file.
class PieceBytes : public SerialBytes
{
public:
  explicit PieceBytes(const RawVolume& voxels)
    : File(voxels.files.front())
    , Contents(contentsOf(this->File))
    , Rest(
        std::string_view(this->Contents).substr(std::min<std::size_t>(voxels.offset, this->Contents.size())))
  {
  }

protected:
  void next(std::span<unsigned char> bytes) final
  {
    while (!bytes.empty())
    {
      if (this->Used == this->Piece.size())
      {
        this->Piece.clear();
        this->Used = 0;
        this->takePiece(this->Rest, this->Piece);
      }
      const std::size_t some = std::min(bytes.size(), this->Piece.size() - this->Used);
      std::copy_n(this->Piece.begin() + static_cast<std::ptrdiff_t>(this->Used), some, bytes.begin());
      this->Used += some;
      bytes = bytes.subspan(some);
    }
  }

  /// Makes the next piece, of one byte or more, of what it takes from the front of rest. @throws ReadError
  virtual void takePiece(std::string_view& rest, std::vector<unsigned char>& piece) = 0;

  const std::filesystem::path& file() const { return this->File; }

private:
  std::filesystem::path File;
  std::string Contents;
  std::string_view Rest;
  std::vector<unsigned char> Piece;
  std::size_t Used = 0;
};

/// Of numbers that are written out.
class TextBytes : public PieceBytes
{
public:
  explicit TextBytes(const RawVolume& voxels)
    : PieceBytes(voxels)
    , Type(voxels.type)
  {
  }

protected:
  void takePiece(std::string_view& rest, std::vector<unsigned char>& piece) override
  {
    const std::string_view word = nextWord(rest);
    const std::optional<double> number = numberIn(word);
    if (!number)
    {
      failToRead(this->file(),
        word.empty() ? "it holds fewer values than its header promises"
                     : "it says '" + shortened(word) + "' where the number of a voxel was expected");
    }
    switch (this->Type)
    {
      vtkTemplateMacro(append<VTK_TT>(piece, *number));
    }
  }

private:
  int Type;
};

/// Of VolVis' slices of bytes: how many bytes the slice's runs take, an X, and the runs.
class RunBytes : public PieceBytes
{
public:
  explicit RunBytes(const RawVolume& voxels)
    : PieceBytes(voxels)
    , Values(voxels.sliceValues())
  {
  }

protected:
  void takePiece(std::string_view& rest, std::vector<unsigned char>& piece) override
  {
    ++this->Slice;
    std::string_view runs = this->takeRuns(rest);
    piece.reserve(this->Values);
    while (!runs.empty())
    {
      const auto head = static_cast<unsigned char>(runs.front());
      runs.remove_prefix(1);
      const std::size_t count = head & 0x7fU;
      if (count == 0)
      {
        break; // as the last one is
      }
      const bool areAlike = head == count;
      const std::size_t stored = areAlike ? 1 : count;
      if (stored > runs.size())
      {
        this->fail("end within a run, after " + std::to_string(piece.size()) + " of");
      }
      if (count > this->Values - piece.size())
      {
        this->fail("make more than");
      }
      piece.insert(piece.end(), runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(stored));
      piece.insert(piece.end(), count - stored, piece.back());
      runs.remove_prefix(stored);
    }
    if (piece.size() + 1 == this->Values && !piece.empty())
    {
      piece.push_back(piece.back()); // some writers leave it out
    }
    if (piece.size() != this->Values)
    {
      this->fail("end after " + std::to_string(piece.size()) + " of");
    }
  }

private:
  std::string_view takeRuns(std::string_view& rest) const
  {
    const std::string_view word = nextWord(rest);
    const double size = numberIn(word).value_or(-1.0);
    // The runs follow on the X.
    const std::string_view mark = nextWord(rest);
    const std::size_t left = mark.empty() ? 0 : mark.size() - 1 + rest.size();
    if (!mark.starts_with('X') || !(size >= 0.0 && size <= static_cast<double>(left)))
    {
      failToRead(this->file(),
        "it says '" + shortened(word) + ' ' + shortened(mark.substr(0, 1)) + "' where slice " +
          std::to_string(this->Slice) + " begins; expected how many of the " + std::to_string(left) +
          " bytes left it takes, and an X");
    }
    const std::string_view runs(mark.data() + 1, static_cast<std::size_t>(size));
    rest = std::string_view(runs.data() + runs.size(), left - runs.size());
    return runs;
  }

  [[noreturn]] void fail(const std::string& how) const
  {
    failToRead(this->file(),
      "the run lengths of slice " + std::to_string(this->Slice) + ' ' + how + " its " +
        std::to_string(this->Values) + " values");
  }

  std::size_t Values; ///< of a slice
  int Slice = 0;      ///< from 1
};

void readPage(TiffFile& file, std::uint64_t directory, std::span<unsigned char> values)
{
  file.turnTo(directory);
  file.read(values);
}

void readPage(const DicomPixels& file, std::uint64_t frame, std::span<unsigned char> values)
{
  file.read(static_cast<std::size_t>(frame), values);
}

/// Reads pages, each from the file of the one before if that is the same.
/// @tparam File const if threads can share it
template <class File>
class Pages
{
public:
  explicit Pages(const RawVolume& voxels)
    : Voxels(voxels)
  {
  }

  /// For another thread.
  Pages fork() const { return std::is_const_v<File> ? *this : Pages(this->Voxels); }

  void open(std::size_t page)
  {
    const std::filesystem::path& path = this->Voxels.files.at(page);
    if (!this->Current || this->Current->path() != path)
    {
      this->Current = std::make_shared<File>(path);
    }
  }

  void read(std::size_t page, std::span<unsigned char> values)
  {
    this->open(page);
    readPage(*this->Current, this->Voxels.offsetIn(page), values);
  }

private:
  const RawVolume& Voxels;
  std::shared_ptr<File> Current;
};

/// Of pages that a library reads, whole ones at once on all threads. One that is not asked for whole is kept.
template <class File>
class PageBytes : public VoxelBytes
{
public:
  explicit PageBytes(const RawVolume& voxels)
    : Voxels(voxels)
    , Values(voxels.fileBytes() / voxels.files.size())
    , Kept(this->Voxels)
  {
  }

  void read(std::uint64_t position, std::span<unsigned char> bytes) override
  {
    const std::size_t size = this->Values.size();
    while (!bytes.empty())
    {
      const auto page = static_cast<std::size_t>(position / size);
      const auto within = static_cast<std::size_t>(position % size);
      std::size_t some = std::min(bytes.size(), size - within);
      if (within == 0 && bytes.size() >= size)
      {
        some = bytes.size() / size * size;
        this->readWhole(page, bytes.first(some));
      }
      else
      {
        this->turnTo(page);
        std::copy_n(this->Values.begin() + static_cast<std::ptrdiff_t>(within), some, bytes.begin());
      }
      position += some;
      bytes = bytes.subspan(some);
    }
  }

private:
  void readWhole(std::size_t first, std::span<unsigned char> bytes)
  {
    const std::size_t size = this->Values.size();
    this->Kept.open(first);
    parallelForChunks(
      bytes.size() / size,
      [&](std::size_t, std::size_t begin, std::size_t end)
      {
        Pages<File> pages = this->Kept.fork();
        for (std::size_t page = begin; page < end; ++page)
        {
          pages.read(first + page, bytes.subspan(page * size, size));
        }
      },
      pagesOfAChunk);
  }

  void turnTo(std::size_t page)
  {
    if (this->Page == page)
    {
      return;
    }
    this->Page.reset();
    this->Kept.read(page, this->Values);
    this->Page = page;
  }

  static constexpr std::size_t pagesOfAChunk = 4;

  RawVolume Voxels;
  std::optional<std::size_t> Page;
  std::vector<unsigned char> Values;
  Pages<File> Kept;
};

} // namespace

std::unique_ptr<VoxelBytes> VoxelBytes::open(const RawVolume& voxels)
{
  switch (voxels.encoding)
  {
    case VoxelEncoding::Compressed:
      return std::make_unique<InflatedBytes>(voxels);
    case VoxelEncoding::Text:
      return std::make_unique<TextBytes>(voxels);
    case VoxelEncoding::Runs:
      return std::make_unique<RunBytes>(voxels);
    case VoxelEncoding::Pages:
      return std::make_unique<PageBytes<TiffFile>>(voxels);
    case VoxelEncoding::Frames:
      return std::make_unique<PageBytes<const DicomPixels>>(voxels);
    default:
      return std::make_unique<StoredBytes>(voxels);
  }
}

} // namespace ink::io
