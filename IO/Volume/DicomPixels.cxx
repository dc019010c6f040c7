// SPDX-License-Identifier: BSD-3-Clause
#include "DicomPixels.h"

#include "FileHandle.h"
#include "OrderedBytes.h"
#include "ReadError.h"

#include <gdcmDataElement.h>
#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ink::io
{
namespace
{

std::uint32_t littleEndian(const void* bytes)
{
  return valueFrom<std::uint32_t>(bytes, std::endian::native == std::endian::big);
}

/// A file that is read from anywhere.
class Bytes
{
public:
  explicit Bytes(const std::filesystem::path& path)
    : Path(path)
    , File(openToRead(path))
  {
  }

  void read(std::uint64_t position, std::span<unsigned char> bytes) const
  {
    if (readAt(this->File.get(), position, bytes) != bytes.size())
    {
      failToRead(this->Path, "the file ends within its compressed pixels");
    }
  }

  std::uint32_t integer(std::uint64_t position) const
  {
    std::array<unsigned char, sizeof(std::uint32_t)> stored;
    this->read(position, stored);
    return littleEndian(stored.data());
  }

private:
  const std::filesystem::path& Path;
  FileHandle File;
};

/// What there is of an item (DICOM PS3.5 A.4): its tag and length, and what is in it.
constexpr std::uint64_t headBytes = 8;
constexpr std::uint32_t itemTag = 0xE000FFFE;
constexpr std::uint32_t endTag = 0xE0DDFFFE;

constexpr std::string_view runLengths = "1.2.840.10008.1.2.5";

/// Whether a fragment's first bytes are those that JPEG, JPEG-LS or JPEG 2000 begins with.
constexpr bool isCodestream(std::uint32_t bytes)
{
  const std::uint32_t marker = bytes & 0xFFFF;
  return marker == 0xD8FF || marker == 0x4FFF;
}

/// Whether the segments of run lengths, those of each byte of each component, are where the head says (PS3.5
/// G.5): GDCM believes it.
bool isHeadOfRunLengths(std::span<const char> data, int components, int bytesOfAValue)
{
  constexpr std::size_t headWords = 16;
  if (data.size() < headWords * sizeof(std::uint32_t))
  {
    return false;
  }
  const auto word = [&](std::size_t i) { return littleEndian(&data[i * sizeof(std::uint32_t)]); };
  const auto segments = static_cast<std::uint32_t>(components) * static_cast<std::uint32_t>(bytesOfAValue);
  bool isRight = segments < headWords && word(0) == segments && word(1) == headWords * sizeof(std::uint32_t);
  for (std::size_t i = 2; isRight && i <= segments; ++i)
  {
    isRight = word(i) > word(i - 1) && word(i) < data.size();
  }
  return isRight;
}

/// GDCM tells of each thing that it finds wrong on the terminal.
void silenceGdcm()
{
  static const bool isSilent = []
  {
    gdcm::Trace::DebugOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
    return true;
  }();
  static_cast<void>(isSilent);
}

gdcm::PixelFormat formatOf(const DicomFile& file)
{
  const auto bits = static_cast<unsigned short>(file.bits);
  const auto stored =
    static_cast<unsigned short>(file.storedBits > 0 ? std::min(file.storedBits, file.bits) : file.bits);
  return gdcm::PixelFormat(static_cast<unsigned short>(file.components), bits, stored,
    static_cast<unsigned short>(stored - 1), file.isSigned ? 1 : 0);
}

/// Repeats the sign of values in the bits that are not theirs, as some files leave it out where an unsigned
/// picture was compressed.
template <class T>
void extendSigns(std::span<unsigned char> values, int spareBits)
{
  for (std::size_t at = 0; at + sizeof(T) <= values.size(); at += sizeof(T))
  {
    const auto stored = valueFrom<std::make_unsigned_t<T>>(&values[at], false);
    const auto value = static_cast<T>(static_cast<T>(stored << spareBits) >> spareBits);
    std::memcpy(&values[at], &value, sizeof(T));
  }
}

/// A file that was one before.
DicomFile readAgain(const std::filesystem::path& path)
{
  std::optional<DicomFile> file = DicomFile::read(path);
  if (!file)
  {
    failToRead(path, "it is no DICOM file any more");
  }
  return std::move(*file);
}

} // namespace

DicomPixels::DicomPixels(const std::filesystem::path& path)
  : DicomPixels(readAgain(path))
{
}

DicomPixels::DicomPixels(DicomFile file)
  : File(std::move(file))
{
  if (this->File.components != 1 && this->File.components != 3)
  {
    failToRead(this->File.path,
      "its compressed pixels have " + std::to_string(this->File.components) + " components; expected 1 or 3");
  }
  if (this->File.transferSyntax == runLengths && this->File.components > 1 && this->File.valueBytes() > 1)
  {
    // GDCM mixes up their bytes.
    failToRead(this->File.path,
      "its pixels have " + std::to_string(this->File.components) + " components of " +
        std::to_string(this->File.bits) + " bits in run lengths; expected one, or 8 bits");
  }
  const Bytes bytes(this->File.path);
  // The first item says where the first fragment of each frame is, counted from the next item, or is empty.
  std::uint64_t position = this->File.pixelOffset;
  if (bytes.integer(position) != itemTag)
  {
    failToRead(this->File.path, "its compressed pixels do not begin with an item");
  }
  const std::uint32_t tableBytes = bytes.integer(position + sizeof(itemTag));
  const std::uint64_t table = position + headBytes;
  const std::uint64_t first = table + tableBytes;
  const auto frames = static_cast<std::size_t>(this->File.frames);
  std::vector<Fragment> fragments;
  position = first;
  for (std::uint32_t tag = bytes.integer(position); tag != endTag; tag = bytes.integer(position))
  {
    const std::uint32_t length = bytes.integer(position + sizeof(tag));
    if (tag != itemTag)
    {
      failToRead(this->File.path, "its compressed pixels hold something else than items");
    }
    fragments.push_back({ position + headBytes, length });
    position += headBytes + length;
  }
  constexpr double mostPerByte = 1 << 18; // an even picture, in JPEG-LS or JPEG 2000
  if (static_cast<double>(position - first) * mostPerByte <
    static_cast<double>(this->File.frameBytes()) * static_cast<double>(frames))
  {
    failToRead(this->File.path,
      "it has " + std::to_string(position - first) + " bytes of compressed pixels, but promises " +
        std::to_string(frames) + " times " + std::to_string(this->File.frameBytes()));
  }
  const bool hasTable = tableBytes == frames * sizeof(std::uint32_t);
  const auto begins = [&](const Fragment& fragment)
  {
    const std::size_t next = this->Frames.size();
    if (frames == fragments.size() || next == 0)
    {
      return true;
    }
    if (!hasTable)
    {
      return frames > 1 && fragment.length >= sizeof(std::uint32_t) &&
        isCodestream(bytes.integer(fragment.position));
    }
    return next < frames &&
      first + bytes.integer(table + next * sizeof(std::uint32_t)) + headBytes == fragment.position;
  };
  for (const Fragment& fragment : fragments)
  {
    (begins(fragment) ? this->Frames.emplace_back() : this->Frames.back()).push_back(fragment);
  }
  if (this->Frames.size() != frames)
  {
    failToRead(this->File.path,
      "it has " + std::to_string(fragments.size()) + " fragments of pixels, of which " +
        std::to_string(this->Frames.size()) + " begin a frame; expected " + std::to_string(frames));
  }
}

void DicomPixels::read(std::size_t frame, std::span<unsigned char> values) const
{
  silenceGdcm();
  const Bytes bytes(this->File.path);
  gdcm::SmartPointer<gdcm::SequenceOfFragments> sequence = new gdcm::SequenceOfFragments;
  std::vector<char> data;
  for (const Fragment& part : this->Frames.at(frame))
  {
    const std::size_t before = data.size();
    data.resize(before + part.length);
    bytes.read(part.position, { reinterpret_cast<unsigned char*>(data.data() + before), part.length });
  }
  const bool isDamaged = this->File.transferSyntax == runLengths &&
    !isHeadOfRunLengths(data, this->File.components, this->File.valueBytes());
  gdcm::Fragment fragment;
  fragment.SetByteValue(data.data(), gdcm::VL(static_cast<std::uint32_t>(data.size())));
  sequence->AddFragment(fragment);
  gdcm::DataElement pixels(gdcm::Tag(0x7FE0, 0x0010), 0, gdcm::VR::OB);
  pixels.SetValue(*sequence);
  gdcm::Image image;
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, static_cast<unsigned int>(this->File.columns));
  image.SetDimension(1, static_cast<unsigned int>(this->File.rows));
  image.SetPixelFormat(formatOf(this->File));
  image.SetPhotometricInterpretation(this->File.components == 3
      ? gdcm::PhotometricInterpretation::RGB
      : gdcm::PhotometricInterpretation::MONOCHROME2);
  image.SetPlanarConfiguration(0);
  image.SetTransferSyntax(gdcm::TransferSyntax::GetTSType(this->File.transferSyntax.c_str()));
  image.SetDataElement(pixels);
  if (isDamaged || image.GetBufferLength() != values.size() ||
    !image.GetBuffer(reinterpret_cast<char*>(values.data())))
  {
    failToRead(this->File.path,
      "its pixels cannot be decompressed (transfer syntax " + this->File.transferSyntax + ")");
  }
  const int spare = this->File.storedBits > 0 ? this->File.bits - this->File.storedBits : 0;
  if (this->File.isSigned && spare > 0)
  {
    switch (this->File.bits)
    {
      case 8:
        extendSigns<std::int8_t>(values, spare);
        break;
      case 16:
        extendSigns<std::int16_t>(values, spare);
        break;
      default:
        extendSigns<std::int32_t>(values, spare);
    }
  }
}

} // namespace ink::io
