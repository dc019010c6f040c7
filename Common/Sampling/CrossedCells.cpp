// The samples of a row become bits, 64 to a word, and what the cells need is worked out on whole words: a bit
// of `above` is set where the sample is at or above the iso-value. A cell is crossed where its eight corners
// are neither all set nor all clear, and a row of cells sees its corners as four rows of bits and the same
// four shifted by one. See CrossingRule for the other rule, which also needs to know who is strictly above.

#include "Sampling/CrossedCells.h"

#include "Fields/Scalars.h"
#include "Sampling/ScalarBound.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace ink
{
namespace
{

using Word = std::uint64_t;
constexpr int WordBits = 64;

/// Eight bytes of 0 or 1 to eight bits, the first byte to the lowest: the multiplication brings bit n of the
/// result from byte n to the top byte.
Word packBytes(const unsigned char* flags)
{
  constexpr Word gather =
    std::endian::native == std::endian::little ? 0x0102040810204080 : 0x8040201008040201;
  Word bytes;
  std::memcpy(&bytes, flags, sizeof bytes);
  return bytes * gather >> 56;
}

/// Writes test(n) for n in [0, count) as bits; the rest of the last word is clear.
template <class Test>
void packBits(int count, Word* words, const Test& test)
{
  for (int begin = 0; begin < count; begin += WordBits)
  {
    alignas(WordBits) unsigned char flags[WordBits];
    if (count - begin >= WordBits)
    {
      for (int n = 0; n < WordBits; ++n)
      {
        flags[n] = test(begin + n);
      }
    }
    else
    {
      std::memset(flags, 0, sizeof flags);
      for (int n = 0; n < count - begin; ++n)
      {
        flags[n] = test(begin + n);
      }
    }
    Word word = 0;
    for (int byte = 0; byte < WordBits / 8; ++byte)
    {
      word |= packBytes(flags + 8 * byte) << (8 * byte);
    }
    *words++ = word;
  }
}

/// The bits of one layer of samples: rows of `words` words each.
struct LayerBits
{
  std::vector<Word> above;   ///< at or above the iso-value
  std::vector<Word> over;    ///< strictly above it; only for CrossingRule::Strict
  std::vector<Word> missing; ///< hidden or not finite; only where a sample can be
};

/// What four rows of corners, at words w and w + 1, say about the 64 cells between them. Rows are in the
/// order (j, k), (j + 1, k), (j, k + 1), (j + 1, k + 1).
struct CornerRows
{
  Word here[4];
  Word next[4]; ///< the same, one sample further

  template <class Row>
  CornerRows(const Row& row, int word, int words)
  {
    for (int r = 0; r < 4; ++r)
    {
      const Word following = word + 1 < words ? row(r)[word + 1] : 0;
      this->here[r] = row(r)[word];
      this->next[r] = this->here[r] >> 1 | following << (WordBits - 1);
    }
  }

  Word any() const
  {
    return this->here[0] | this->here[1] | this->here[2] | this->here[3] | this->next[0] | this->next[1] |
      this->next[2] | this->next[3];
  }
  Word all() const
  {
    return this->here[0] & this->here[1] & this->here[2] & this->here[3] & this->next[0] & this->next[1] &
      this->next[2] & this->next[3];
  }
};

Word crossedHalfOpen(const CornerRows& above)
{
  return above.any() & ~above.all();
}

Word crossedStrict(const CornerRows& above, const CornerRows& over)
{
  const auto edges = [](Word above1, Word over1, Word above2, Word over2)
  { return (~above1 & over2) | (over1 & ~above2) | (above1 & ~over1 & above2 & ~over2); };
  Word crossed = 0;
  for (int r = 0; r < 4; ++r)
  {
    crossed |= edges(above.here[r], over.here[r], above.next[r], over.next[r]);
  }
  constexpr int across[4][2] = { { 0, 1 }, { 2, 3 }, { 0, 2 }, { 1, 3 } };
  for (const auto& [r, s] : across)
  {
    crossed |= edges(above.here[r], over.here[r], above.here[s], over.here[s]);
    crossed |= edges(above.next[r], over.next[r], above.next[s], over.next[s]);
  }
  return crossed;
}

/// The bits from `begin` up to `end` in the word that starts at bit `first`.
Word rangeBits(int begin, int end, int first)
{
  const auto below = [](int bits) {
    return bits <= 0 ? Word(0) : bits >= WordBits ? ~Word(0) : (Word(1) << bits) - 1;
  };
  return below(end - first) & ~below(begin - first);
}

template <class T>
class CellFinder
{
public:
  CellFinder(const GridField<T>& field, double isoValue, CrossingRule rule, const CellSelection& selection)
    : Field(field)
    , Rule(rule)
    , AtLeast(ScalarBound<T>::atLeast(isoValue))
    , Above(ScalarBound<T>::above(isoValue))
    , Skipped(selection.skipped)
    , Cells(glm::max(field.geometry().dimensions() - 1, glm::ivec3(0)))
    , Begin(glm::clamp(selection.begin, glm::ivec3(0), this->Cells))
    , End(glm::clamp(selection.end, glm::ivec3(0), this->Cells))
    , Words((field.geometry().dimensions().x + WordBits - 1) / WordBits)
    , CanMiss(std::is_floating_point_v<T> || !field.hidden().empty())
  {
  }

  int layerCount() const
  {
    return this->Begin.x < this->End.x && this->Begin.y < this->End.y
      ? std::max(this->End.z - this->Begin.z, 0)
      : 0;
  }

  /// The cells of `count` layers, counted from the selection's first.
  void find(int firstLayer, int count, CrossedCells::Slab& slab) const
  {
    LayerBits lower;
    LayerBits upper;
    const int begin = this->Begin.z + firstLayer;
    this->classify(begin, lower);
    for (int k = begin; k < begin + count; ++k)
    {
      this->classify(k + 1, upper);
      for (int j = this->Begin.y; j < this->End.y; ++j)
      {
        this->findInRow(j, k, lower, upper, slab);
      }
      std::swap(lower, upper);
    }
  }

private:
  void classify(int k, LayerBits& layer) const
  {
    const glm::ivec3 samples = this->Field.geometry().dimensions();
    const std::size_t size = static_cast<std::size_t>(this->Words) * samples.y;
    layer.above.resize(size);
    layer.over.resize(this->Rule == CrossingRule::Strict ? size : 0);
    layer.missing.resize(this->CanMiss ? size : 0);
    for (int j = this->Begin.y; j <= this->End.y; ++j)
    {
      const std::size_t row = static_cast<std::size_t>(this->Words) * j;
      const std::size_t first = this->Field.geometry().offset({ 0, j, k });
      const T* values = this->Field.data() + first * this->Field.stride();
      // A stride that the compiler knows lets it compare many samples at once.
      if (this->Field.stride() == 1)
      {
        this->classifyRow(values, std::integral_constant<std::size_t, 1>(), first, row, layer);
      }
      else
      {
        this->classifyRow(values, this->Field.stride(), first, row, layer);
      }
    }
  }

  template <class Stride>
  void classifyRow(const T* values, Stride stride, std::size_t first, std::size_t row, LayerBits& layer) const
  {
    const int count = this->Field.geometry().dimensions().x;
    const auto compare = [&](const ScalarBound<T>& bound, Word* words)
    {
      if (bound.reachable)
      {
        const T lowest = bound.lowest;
        packBits(count, words, [=](int i) { return values[i * stride] >= lowest; });
      }
      else
      {
        std::fill_n(words, this->Words, Word(0));
      }
    };
    compare(this->AtLeast, &layer.above[row]);
    if (this->Rule == CrossingRule::Strict)
    {
      compare(this->Above, &layer.over[row]);
    }
    if (this->CanMiss)
    {
      Word* words = &layer.missing[row];
      if constexpr (std::is_floating_point_v<T>)
      {
        constexpr T largest = std::numeric_limits<T>::max();
        packBits(count, words, [=](int i) { return !(std::abs(values[i * stride]) <= largest); });
      }
      else
      {
        std::fill_n(words, this->Words, Word(0));
      }
      const ElementMarks& hidden = this->Field.hidden();
      for (int i = 0; !hidden.empty() && i < count; ++i)
      {
        words[i / WordBits] |= Word(hidden[first + i]) << (i % WordBits);
      }
    }
  }

  void findInRow(int j, int k, const LayerBits& lower, const LayerBits& upper, CrossedCells::Slab& slab) const
  {
    const auto rowsOf = [&](std::vector<Word> LayerBits::*bits)
    {
      return [&, bits](int r)
      {
        const LayerBits& layer = r < 2 ? lower : upper;
        return (layer.*bits).data() + static_cast<std::size_t>(this->Words) * (j + r % 2);
      };
    };
    for (int w = this->Begin.x / WordBits; w * WordBits < this->End.x; ++w)
    {
      const CornerRows above(rowsOf(&LayerBits::above), w, this->Words);
      Word crossed = this->Rule == CrossingRule::HalfOpen
        ? crossedHalfOpen(above)
        : crossedStrict(above, CornerRows(rowsOf(&LayerBits::over), w, this->Words));
      crossed &= rangeBits(this->Begin.x, this->End.x, w * WordBits);
      if (crossed != 0 && this->CanMiss)
      {
        crossed &= ~CornerRows(rowsOf(&LayerBits::missing), w, this->Words).any();
      }
      if (crossed != 0 && !this->Skipped.empty())
      {
        crossed = this->withoutSkipped(crossed, { w * WordBits, j, k });
      }
      if (crossed != 0)
      {
        slab.runs.push_back({ crossed, { w * WordBits, j, k } });
        slab.count += std::popcount(crossed);
      }
    }
  }

  Word withoutSkipped(Word crossed, const glm::ivec3& first) const
  {
    const std::size_t cell = first.x +
      static_cast<std::size_t>(this->Cells.x) * (first.y + static_cast<std::size_t>(this->Cells.y) * first.z);
    for (Word rest = crossed; rest != 0; rest &= rest - 1)
    {
      const int bit = std::countr_zero(rest);
      crossed &= ~(Word(this->Skipped[cell + bit]) << bit);
    }
    return crossed;
  }

  const GridField<T>& Field;
  CrossingRule Rule;
  ScalarBound<T> AtLeast;
  ScalarBound<T> Above;
  ElementMarks Skipped;
  glm::ivec3 Cells;
  glm::ivec3 Begin;
  glm::ivec3 End;
  int Words;
  bool CanMiss;
};

} // namespace

template <class T>
CrossedCells findCrossedCells(const GridField<T>& field, double isoValue, CrossingRule rule,
  const CellSelection& selection, const Progress& progress)
{
  CrossedCells cells;
  const glm::ivec3 size = glm::max(field.geometry().dimensions() - 1, glm::ivec3(0));
  const std::size_t count = static_cast<std::size_t>(size.x) * size.y * size.z;
  if (!selection.skipped.empty() && selection.skipped.bytes.size() < count)
  {
    throw std::invalid_argument("the grid has more cells than marks were given");
  }
  if (std::isnan(isoValue))
  {
    return cells;
  }
  // Each slab classifies one layer of samples that its neighbour classifies too: thin enough to share the
  // work out evenly, thick enough that this costs little.
  constexpr int layersPerSlab = 8;
  const CellFinder<T> finder(field, isoValue, rule, selection);
  const int layers = finder.layerCount();
  cells.slabs.resize((layers + layersPerSlab - 1) / layersPerSlab);
  const auto find = [&](std::size_t slab)
  {
    const int first = static_cast<int>(slab) * layersPerSlab;
    finder.find(first, std::min(layersPerSlab, layers - first), cells.slabs[slab]);
  };
  if (!parallelFor(cells.slabs.size(), find, progress))
  {
    return {};
  }
  for (CrossedCells::Slab& slab : cells.slabs)
  {
    slab.before = cells.count;
    cells.count += slab.count;
  }
  return cells;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template CrossedCells findCrossedCells(                                                                    \
    const GridField<T>&, double, CrossingRule, const CellSelection&, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)

} // namespace ink
