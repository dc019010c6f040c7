// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Vdb/VdbTreeCheck.h"

#include <openvdb/io/Compression.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <vector>

namespace ink
{
namespace
{

// OpenVDB's flags of a grid's compression.
constexpr std::uint32_t Zip = 1;
constexpr std::uint32_t ActiveMask = 2;
constexpr std::uint32_t Blosc = 4;

/// Nodes further out than this could overflow the 32 bits of a voxel's index.
constexpr std::int32_t LargestIndex = 1 << 30;
constexpr std::int32_t UpperSize = 4096;

constexpr int UpperSlots = 32 * 32 * 32;
constexpr int LowerSlots = 16 * 16 * 16;
constexpr int LeafSlots = 8 * 8 * 8;

/// A bit for each slot of a node.
template <int slots>
struct Mask
{
  std::array<std::uint64_t, slots / 64> words;

  int countOn() const
  {
    int count = 0;
    for (const std::uint64_t word : this->words)
    {
      count += std::popcount(word);
    }
    return count;
  }
  bool overlaps(const Mask& other) const
  {
    std::uint64_t both = 0;
    for (std::size_t i = 0; i < this->words.size(); ++i)
    {
      both |= this->words[i] & other.words[i];
    }
    return both != 0;
  }
};

class TreeCheck
{
public:
  TreeCheck(VdbBytes& bytes, const VdbValueFormat& format)
    : Bytes(bytes)
    , Format(format)
  {
  }

  VdbTreeParts run()
  {
    this->root();
    for (std::uint64_t leaf = 0; leaf < this->Parts.leaves; ++leaf)
    {
      const auto active = this->Bytes.get<Mask<LeafSlots>>("the leaves' values");
      this->values(LeafSlots, active.countOn(), Unpacked::No, "the leaves' values");
    }
    return this->Parts;
  }

private:
  /// Whether chunks are decompressed to verify them.
  enum class Unpacked
  {
    No,
    Yes
  };

  void root()
  {
    constexpr const char* what = "the tree's root";
    if (const auto buffers = this->Bytes.get<std::int32_t>(what); buffers != 1)
    {
      throw VdbError("a tree in it has " + std::to_string(buffers) + " buffers; expected 1");
    }
    this->Bytes.skip(static_cast<std::uint64_t>(this->Format.size), what); // the background
    const auto tiles = this->Bytes.get<std::uint32_t>(what);
    const auto children = this->Bytes.get<std::uint32_t>(what);
    std::vector<std::array<std::int32_t, 3>> origins;
    for (std::uint32_t i = 0; i < tiles; ++i)
    {
      origins.push_back(this->origin());
      this->Bytes.skip(static_cast<std::uint64_t>(this->Format.size), what);
      if (this->Bytes.get<unsigned char>(what) > 1)
      {
        throw VdbError("a tile in it is neither active nor inactive");
      }
    }
    for (std::uint32_t i = 0; i < children; ++i)
    {
      origins.push_back(this->origin());
      this->upper();
    }
    std::sort(origins.begin(), origins.end());
    if (std::adjacent_find(origins.begin(), origins.end()) != origins.end())
    {
      throw VdbError("two of its nodes have the same origin");
    }
  }

  std::array<std::int32_t, 3> origin()
  {
    const auto origin = this->Bytes.get<std::array<std::int32_t, 3>>("the tree's root");
    for (const std::int32_t at : origin)
    {
      if (at % UpperSize != 0 || at > LargestIndex || at < -LargestIndex)
      {
        throw VdbError("a node in it lies at index " + std::to_string(at) + "; expected a multiple of " +
          std::to_string(UpperSize) + " from " + std::to_string(-LargestIndex) + " to " +
          std::to_string(LargestIndex));
      }
    }
    return origin;
  }

  /// The masks and tiles of an inner node.
  template <int slots>
  int innerNode()
  {
    constexpr const char* what = "the tree's inner nodes";
    const auto children = this->Bytes.get<Mask<slots>>(what);
    const auto active = this->Bytes.get<Mask<slots>>(what);
    if (children.overlaps(active))
    {
      throw VdbError("a slot of a node in it is both an active tile and a node");
    }
    // OpenVDB leaks the nodes under construction if the values of an inner one cannot be decompressed.
    // Leaves, the bulk of the memory, already belong to the tree by then.
    this->values(slots, active.countOn(), Unpacked::Yes, what);
    return children.countOn();
  }

  void upper()
  {
    ++this->Parts.upper;
    const int children = this->innerNode<UpperSlots>();
    for (int i = 0; i < children; ++i)
    {
      ++this->Parts.lower;
      const int leaves = this->innerNode<LowerSlots>();
      this->Parts.leaves += static_cast<std::uint64_t>(leaves);
      // Their values follow after all nodes; only their masks are here.
      this->Bytes.skip(static_cast<std::uint64_t>(leaves) * (LeafSlots / 8), "the leaves' masks");
    }
  }

  /// One node's values: a byte for the encoding of inactive values, the inactive values, then the others.
  void values(int slots, int active, Unpacked unpacked, const char* what)
  {
    enum Stored : std::uint8_t
    {
      OneInactive = 2,
      MaskOnly = 3,
      MaskAndOne = 4,
      MaskAndTwo = 5,
      All = 6
    };
    const auto stored = this->Bytes.get<std::uint8_t>(what);
    if (stored > All)
    {
      throw VdbError("the values of a node in it are stored in the unknown way " + std::to_string(stored));
    }
    const std::uint64_t inactive =
      stored == MaskAndTwo ? 2 : (stored == OneInactive || stored == MaskAndOne ? 1 : 0);
    const bool mask = stored == MaskOnly || stored == MaskAndOne || stored == MaskAndTwo;
    this->Bytes.skip(inactive * this->Format.size + (mask ? slots / 8 : 0), what);
    const bool activeOnly = (this->Format.compression & ActiveMask) != 0 && stored != All;
    const std::uint64_t count = static_cast<std::uint64_t>(activeOnly ? active : slots);
    if (count > 0 || !this->Format.half)
    {
      const std::uint64_t start = this->Bytes.position();
      const std::uint64_t size = count * (this->Format.half ? 2 : this->Format.size);
      this->chunk(size, what);
      if (unpacked == Unpacked::Yes && (this->Format.compression & (Zip | Blosc)) != 0)
      {
        const std::uint64_t end = this->Bytes.position();
        this->Bytes.seek(start, what);
        this->unpack(size, what);
        this->Bytes.seek(end, what);
      }
    }
  }

  /// Decompresses a chunk, known to be inside the file, as OpenVDB will.
  void unpack(std::uint64_t size, const char* what)
  {
    this->Room.resize(size);
    try
    {
      if ((this->Format.compression & Blosc) != 0)
      {
        openvdb::io::bloscFromStream(this->Bytes.stream(), this->Room.data(), size);
      }
      else
      {
        openvdb::io::unzipFromStream(this->Bytes.stream(), this->Room.data(), size);
      }
    }
    catch (const openvdb::Exception& error)
    {
      throw VdbError(
        std::string("a chunk of ") + what + " cannot be uncompressed: OpenVDB says: " + error.what());
    }
  }

  void chunk(std::uint64_t size, const char* what)
  {
    if ((this->Format.compression & (Zip | Blosc)) == 0)
    {
      this->Bytes.skip(size, what);
      return;
    }
    const auto length = this->Bytes.get<std::int64_t>(what);
    // A negative length: the values are incompressible and stored as they are.
    if (length <= 0 && length != -static_cast<std::int64_t>(size))
    {
      throw VdbError("a chunk of values in it has the length " + std::to_string(length) + "; expected " +
        std::to_string(-static_cast<std::int64_t>(size)));
    }
    if (length <= 0 || (this->Format.compression & Blosc) == 0)
    {
      this->Bytes.skip(static_cast<std::uint64_t>(length < 0 ? -length : length), what);
      return;
    }
    // Blosc is not given the length of a chunk: it trusts the chunk's own header.
    struct Header
    {
      std::uint8_t versions[4];
      std::uint32_t size;
      std::uint32_t blockSize;
      std::uint32_t length;
    };
    const auto header = this->Bytes.get<Header>(what);
    const std::uint64_t whole = static_cast<std::uint64_t>(length);
    if (whole < sizeof header || header.length != whole || header.size != size ||
      (size > 0 && (header.blockSize == 0 || header.blockSize > size)))
    {
      throw VdbError("a compressed chunk of " + std::to_string(length) + " bytes in it says that " +
        std::to_string(header.length) + " bytes hold " + std::to_string(header.size) + "; expected " +
        std::to_string(size));
    }
    this->Bytes.skip(whole - sizeof header, what);
  }

  VdbBytes& Bytes;
  VdbValueFormat Format;
  VdbTreeParts Parts;
  std::vector<char> Room; ///< for decompressed data
};

} // namespace

std::uint64_t VdbTreeParts::bytes(int valueSize) const
{
  // OpenVDB stores a pointer or a value of up to 8 bytes per slot, two masks and a few words per node.
  constexpr std::uint64_t words = 64;
  constexpr std::uint64_t slot = 8;
  return this->upper * (UpperSlots * slot + UpperSlots / 4 + words) +
    this->lower * (LowerSlots * slot + LowerSlots / 4 + words) +
    this->leaves * (LeafSlots * static_cast<std::uint64_t>(valueSize) + LeafSlots / 8 + words);
}

VdbTreeParts checkVdbTree(VdbBytes& bytes, const VdbValueFormat& format)
{
  return TreeCheck(bytes, format).run();
}

} // namespace ink
