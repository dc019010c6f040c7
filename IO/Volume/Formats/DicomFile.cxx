// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFile.h"

#include "ReadError.h"
#include "Words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

constexpr std::uint32_t undefinedLength = 0xFFFFFFFF;

/// Group and element.
constexpr std::uint32_t tag(std::uint32_t group, std::uint32_t element)
{
  return group << 16 | element;
}

constexpr std::uint32_t item = tag(0xFFFE, 0xE000);
constexpr std::uint32_t sharedGroups = tag(0x5200, 0x9229);
constexpr std::uint32_t groupsOfFrames = tag(0x5200, 0x9230);

bool areGroups(std::uint32_t sequence)
{
  return sequence == sharedGroups || sequence == groupsOfFrames;
}

/// Whether a functional group says where frames lie, or what their values mean.
bool isGroupOfFrame(std::uint32_t sequence)
{
  constexpr std::array<std::uint32_t, 4> groups{ tag(0x0020, 0x9113), tag(0x0020, 0x9116),
    tag(0x0028, 0x9110), tag(0x0028, 0x9145) };
  return std::find(groups.begin(), groups.end(), sequence) != groups.end();
}

/// Goes through the elements of a file. Of those within sequences it takes what says where frames lie.
class Elements
{
public:
  explicit Elements(const fs::path& file)
    : File(file)
    , Stream(file, std::ios::binary)
    , Size(fs::file_size(file))
  {
  }

  /// Whether the mark is there, which stands after 128 bytes of anything, or elements are from the beginning
  /// on.
  bool start()
  {
    std::array<char, 132> bytes{};
    this->Stream.read(bytes.data(), bytes.size());
    if (this->Stream && std::string_view(bytes.data() + 128, 4) == "DICM")
    {
      return true;
    }
    this->Stream.clear();
    this->Stream.seekg(0);
    return this->startsWithElement(std::string_view(bytes.data(), 8));
  }

  void read(DicomFile& found)
  {
    while (found.pixelBytes == 0 && this->position() < this->Size)
    {
      this->leaveEnded();
      this->readElement(found);
    }
  }

private:
  /// A sequence, or an item of one, that is being read.
  struct Level
  {
    std::uint32_t key;
    std::uint64_t end; ///< where it ends in the file, if its length is known
    bool isImplicit;   ///< whether the elements in it have no types, whatever the file's have
  };

  /// Whether these are the tag of one of a file's first elements, little endian, and its type and length.
  bool startsWithElement(std::string_view bytes)
  {
    const std::uint32_t group = this->integer(bytes.substr(0, 2));
    const std::uint32_t element = this->integer(bytes.substr(2, 2));
    constexpr std::uint32_t lastOfFirst = 0x0020;
    const auto isCapital = [](char c) { return c >= 'A' && c <= 'Z'; };
    this->PlainIsExplicit = isCapital(bytes[4]) && isCapital(bytes[5]);
    constexpr std::uint32_t longest = 64;
    const std::uint32_t length = this->integer(bytes.substr(4, 4));
    const bool isLength = length > 0 && length <= longest && length % 2 == 0;
    return (group == 0x0002 || group == 0x0008) && element <= lastOfFirst &&
      (this->PlainIsExplicit || isLength);
  }

  std::uint64_t position()
  {
    return static_cast<std::uint64_t>(std::max<std::streamoff>(this->Stream.tellg(), 0));
  }

  [[noreturn]] void fail(const std::string& reason) const { failToRead(this->File, reason); }

  std::string bytes(std::size_t count)
  {
    std::string bytes(count, '\0');
    if (!this->Stream.read(bytes.data(), static_cast<std::streamsize>(count)))
    {
      this->fail("the file ends within an element");
    }
    return bytes;
  }

  std::uint32_t integer(std::string_view bytes) const
  {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
    {
      value = value << 8 | static_cast<unsigned char>(bytes[this->BigEndian ? i : bytes.size() - 1 - i]);
    }
    return value;
  }

  void readElement(DicomFile& found)
  {
    const std::string start = this->bytes(4);
    const bool isMeta = this->integer(std::string_view(start).substr(0, 2)) == 2;
    if (!isMeta && !this->PastMeta)
    {
      this->PastMeta = true;
      this->setSyntax(found);
    }
    const std::uint32_t key = tag(this->integer(std::string_view(start).substr(0, 2)),
      this->integer(std::string_view(start).substr(2, 2)));
    const bool isItem = key >> 16 == 0xFFFE;
    const bool isWithinImplicit = !this->Levels.empty() && this->Levels.back().isImplicit;
    const bool isExplicit = !isItem && (isMeta || this->Explicit) && !isWithinImplicit;
    std::uint32_t length = 0;
    bool isSequence = false;
    bool isUnknown = false;
    if (isExplicit)
    {
      const std::string type = this->bytes(2);
      static constexpr std::array<std::string_view, 13> longTypes{ "OB", "OD", "OF", "OL", "OV", "OW", "SQ",
        "SV", "UC", "UN", "UR", "UT", "UV" };
      isUnknown = type == "UN";
      // Within sequences, as in icons, pixels may be compressed: in items, too.
      isSequence = isUnknown || type == "SQ" || (!this->Levels.empty() && (type == "OB" || type == "OW"));
      const bool isLong = std::find(longTypes.begin(), longTypes.end(), type) != longTypes.end();
      if (isLong)
      {
        this->bytes(2);
      }
      length = this->integer(this->bytes(isLong ? 4 : 2));
    }
    else
    {
      length = this->integer(this->bytes(4));
      isSequence = true;
    }
    if (isItem)
    {
      this->enterOrLeave(key, length, found);
      return;
    }
    if (key == tag(0x7FE0, 0x0010) && this->Levels.empty())
    {
      found.pixelOffset = this->position();
      found.pixelBytes = length == undefinedLength ? this->Size - found.pixelOffset : length;
      return;
    }
    if (length == undefinedLength)
    {
      if (!isSequence)
      {
        this->fail("it has an element of undefined length that is no sequence");
      }
      // Of an unknown type it is written without types (PS3.5 6.2.2).
      this->enter(key, length, isUnknown);
      return;
    }
    if (length > this->Size - this->position())
    {
      this->fail("it has an element of " + std::to_string(length) + " bytes, but ends before");
    }
    constexpr std::uint32_t longest = 1 << 14;
    DicomFrame* const frame = this->frameOfLevel(found);
    const bool isGroup = this->isWithinGroups() && this->Levels.size() == 2 && isGroupOfFrame(key);
    if (isGroup || (this->Levels.empty() && areGroups(key)))
    {
      this->enter(key, length);
    }
    else if ((this->Levels.empty() || frame) && length <= longest)
    {
      const std::string value = this->bytes(length);
      if (!frame)
      {
        this->take(key, value, found);
      }
      this->takeOfFrame(key, value, frame ? *frame : found.shared);
    }
    else
    {
      this->Stream.seekg(length, std::ios::cur);
    }
  }

  void enter(std::uint32_t key, std::uint32_t length, bool isImplicit = false)
  {
    // Files nest few; one that does not would make a list as long as itself.
    constexpr std::size_t most = 64;
    if (this->Levels.size() == most)
    {
      this->fail("it has more than " + std::to_string(most / 2) + " sequences, each within the one before");
    }
    this->Levels.push_back({ key,
      length == undefinedLength ? std::numeric_limits<std::uint64_t>::max() : this->position() + length,
      isImplicit || (!this->Levels.empty() && this->Levels.back().isImplicit) });
  }

  /// Leaves the sequences and items whose length was given and that end here.
  void leaveEnded()
  {
    const std::uint64_t here = this->position();
    while (!this->Levels.empty() && this->Levels.back().end <= here)
    {
      this->Levels.pop_back();
    }
  }

  /// Whether what comes next are the functional groups of all frames, or of one.
  bool isWithinGroups() const
  {
    return this->Levels.size() >= 2 && areGroups(this->Levels[0].key) && this->Levels[1].key == item;
  }

  /// The frame, or all of them, whose functional group is being read; null if none is.
  DicomFrame* frameOfLevel(DicomFile& found) const
  {
    constexpr std::size_t depth = 4; // the groups, an item, one of them, an item
    if (this->Levels.size() != depth || !this->isWithinGroups() || !isGroupOfFrame(this->Levels[2].key))
    {
      return nullptr;
    }
    return this->Levels[0].key == sharedGroups ? &found.shared : &found.ownFrames.back();
  }

  /// Items of sequences, and the ends of those whose length was not given.
  void enterOrLeave(std::uint32_t key, std::uint32_t length, DicomFile& found)
  {
    if (key != item)
    {
      if (this->Levels.empty())
      {
        this->fail("it has the end of a sequence where none began");
      }
      this->Levels.pop_back();
      return;
    }
    const std::uint32_t sequence = this->Levels.empty() ? 0 : this->Levels.back().key;
    const bool isGroups = this->Levels.size() == 1 && areGroups(sequence);
    if (isGroups && sequence == groupsOfFrames)
    {
      if (found.ownFrames.size() == static_cast<std::size_t>(found.frames))
      {
        this->fail("it says " + std::to_string(found.frames) + " frames, but where more lie");
      }
      // What is said of all frames comes before.
      found.ownFrames.push_back(found.shared);
    }
    if (length != undefinedLength && length > this->Size - this->position())
    {
      this->fail("it has an item of " + std::to_string(length) + " bytes, but ends before");
    }
    if (length == undefinedLength || isGroups || isGroupOfFrame(sequence))
    {
      this->enter(key, length);
    }
    else
    {
      this->Stream.seekg(length, std::ios::cur);
    }
  }

  void setSyntax(const DicomFile& found)
  {
    this->Explicit =
      found.transferSyntax.empty() ? this->PlainIsExplicit : found.transferSyntax != "1.2.840.10008.1.2";
    // Big endian holds from this element's tag on, which is taken after this.
    this->BigEndian = found.transferSyntax == "1.2.840.10008.1.2.2";
    if (found.transferSyntax == "1.2.840.10008.1.2.1.99")
    {
      this->fail(
        "all of it is compressed (transfer syntax " + found.transferSyntax + "); expected plain elements");
    }
  }

  /// Numbers as text between backslashes.
  std::vector<double> numbers(std::string_view value) const
  {
    std::string words(value);
    std::replace_if(
      words.begin(), words.end(), [](char c) { return c == '\\' || c == '\0'; }, ' ');
    std::string_view rest = words;
    std::vector<double> numbers;
    for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest))
    {
      const std::optional<double> number = numberIn(word);
      if (!number || !std::isfinite(*number))
      {
        this->fail("it says '" + shortened(value) + "' where numbers were expected");
      }
      numbers.push_back(*number);
    }
    return numbers;
  }

  void copy(std::string_view value, std::size_t count, double* to) const
  {
    const std::vector<double> all = this->numbers(value);
    if (!all.empty() && all.size() < count)
    {
      this->fail(
        "it says '" + shortened(value) + "' where " + std::to_string(count) + " numbers were expected");
    }
    std::copy_n(all.begin(), std::min(all.size(), count), to);
  }

  static std::string name(std::string_view value)
  {
    return std::string(value.substr(0, value.find_last_not_of(std::string_view(" \0", 2)) + 1));
  }

  int smallInteger(std::string_view value) const
  {
    return static_cast<int>(this->integer(value.substr(0, 2)));
  }

  void take(std::uint32_t key, const std::string& value, DicomFile& found) const
  {
    switch (key)
    {
      case tag(0x0002, 0x0010):
        found.transferSyntax = name(value);
        break;
      case tag(0x0020, 0x000E):
        found.series = name(value);
        break;
      case tag(0x0020, 0x0013):
        this->copy(value, 1, &found.number);
        break;
      case tag(0x0028, 0x0002):
        found.components = this->smallInteger(value);
        break;
      case tag(0x0028, 0x0006):
        found.separatePlanes = this->smallInteger(value) == 1;
        break;
      case tag(0x0028, 0x0008): {
        double frames = 1.0;
        this->copy(value, 1, &frames);
        found.frames = static_cast<int>(std::clamp(frames, 0.0, 1e9));
        break;
      }
      case tag(0x0028, 0x0010):
        found.rows = this->smallInteger(value);
        break;
      case tag(0x0028, 0x0011):
        found.columns = this->smallInteger(value);
        break;
      case tag(0x0028, 0x0100):
        found.bits = this->smallInteger(value);
        break;
      case tag(0x0028, 0x0101):
        found.storedBits = this->smallInteger(value);
        break;
      case tag(0x3004, 0x000C):
        found.offsets = this->numbers(value);
        break;
      case tag(0x0028, 0x0103):
        found.isSigned = this->smallInteger(value) == 1;
        break;
      default:
        break;
    }
  }

  void takeOfFrame(std::uint32_t key, const std::string& value, DicomFrame& frame) const
  {
    switch (key)
    {
      case tag(0x0018, 0x0050):
        this->copy(value, 1, &frame.thickness);
        break;
      case tag(0x0018, 0x0088):
        this->copy(value, 1, &frame.distance);
        break;
      case tag(0x0020, 0x0032):
        this->copy(value, 3, frame.position);
        frame.hasPosition = !this->numbers(value).empty();
        break;
      case tag(0x0020, 0x0037): {
        std::array<double, 6> both{ 1.0, 0.0, 0.0, 0.0, 1.0, 0.0 };
        this->copy(value, both.size(), both.data());
        std::copy_n(both.begin(), 3, frame.row);
        std::copy_n(both.begin() + 3, 3, frame.column);
        break;
      }
      case tag(0x0028, 0x0030):
        // That between rows comes first.
        this->copy(value, 2, frame.spacing);
        std::swap(frame.spacing[0], frame.spacing[1]);
        break;
      case tag(0x0028, 0x1052):
        this->copy(value, 1, &frame.scale.intercept);
        break;
      case tag(0x0028, 0x1053):
      case tag(0x3004, 0x000E):
        this->copy(value, 1, &frame.scale.slope);
        break;
      default:
        break;
    }
  }

  const fs::path& File;
  std::ifstream Stream;
  std::uint64_t Size;
  bool PastMeta = false;
  bool Explicit = true;
  bool PlainIsExplicit = true; ///< whether elements have types where the file does not say
  bool BigEndian = false;
  std::vector<Level> Levels;
};

} // namespace

int DicomFile::valueBytes() const
{
  constexpr int bitsOfAByte = 8;
  return this->bits / bitsOfAByte;
}

std::uint64_t DicomFile::frameBytes() const
{
  return static_cast<std::uint64_t>(this->rows) * static_cast<std::uint64_t>(this->columns) *
    static_cast<std::uint64_t>(this->components) * static_cast<std::uint64_t>(this->valueBytes());
}

bool DicomFile::isCompressed() const
{
  // All other syntaxes but three are.
  constexpr std::string_view plain = "1.2.840.10008.1.2";
  return !this->transferSyntax.empty() && this->transferSyntax != plain &&
    this->transferSyntax != std::string(plain) + ".1" && this->transferSyntax != std::string(plain) + ".2";
}

std::optional<DicomFile> DicomFile::read(const fs::path& file)
{
  Elements elements(file);
  if (!elements.start())
  {
    return std::nullopt;
  }
  DicomFile found;
  found.path = file;
  try
  {
    elements.read(found);
  }
  catch (const ReadError& error)
  {
    found.problem = error.what();
  }
  found.bigEndian = found.transferSyntax == "1.2.840.10008.1.2.2";
  return found;
}

} // namespace ink::io
