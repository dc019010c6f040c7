// SPDX-License-Identifier: BSD-3-Clause
// From samples to bits and ranges. Included inside a namespace without a name.

/// Reading memory is what limits these loops: wider vectors gain nothing, and a brick takes a whole one.
constexpr int BlockBytes = VectorBytes < 32 ? VectorBytes : 32;
template <class T>
constexpr int BlockLanes = BlockBytes / static_cast<int>(sizeof(T));
template <class T>
using Block = typename VectorOf<T, BlockBytes>::Type;

constexpr int WordBits = 64;
constexpr int BlockRows = BrickWidth;

template <class T>
constexpr bool IsFloating = false;
template <>
constexpr bool IsFloating<float> = true;
template <>
constexpr bool IsFloating<double> = true;

template <class T>
INK_INLINE Block<T> loadBlock(const T* from)
{
  return load<Block<T>>(from);
}

/// What is kept of a brick while its samples go by.
template <class T>
struct BrickRange
{
  Block<T> low;
  Block<T> high;
};

/// The last brick of rows that end before it does: read from a row's last BrickLength samples, the first of
/// which are another brick's and count as copies of the last one, which change no range.
template <class T>
struct RowEnd
{
  int others;

  INK_INLINE Block<T> load(const T* from, int i) const
  {
    typedef std::uint64_t Bits __attribute__((vector_size(BlockBytes)));
    // For each byte of a brick, whether it is the brick's own, seen from any byte on.
    constexpr int most = BrickLength<T> * static_cast<int>(sizeof(T));
    struct Masks
    {
      std::uint8_t bytes[2 * most] = {};
      constexpr Masks()
      {
        for (int n = most; n < 2 * most; ++n)
        {
          this->bytes[n] = 0xff;
        }
      }
    };
    static constexpr Masks masks;
    Bits own;
    __builtin_memcpy(&own, masks.bytes + most + (i - this->others) * static_cast<int>(sizeof(T)), sizeof own);
    const Block<T> last = Block<T>{} + from[BrickLength<T> - 1];
    return reinterpret_cast<Block<T>>(
      (reinterpret_cast<Bits>(loadBlock(from + i)) & own) | (reinterpret_cast<Bits>(last) & ~own));
  }
};

/// The bits of a brick's samples in one row. A sum stays NaN or infinite once a sample was.
/// @param end null for a whole brick
template <class T, bool measure>
INK_INLINE std::uint64_t classifyBrick(
  const T* from, const Block<T>& lowest, Block<T>& sum, BrickRange<T>& range, const RowEnd<T>* end = nullptr)
{
  std::uint64_t bits = 0;
  for (int i = 0; i < BrickLength<T>; i += BlockLanes<T>)
  {
    const Block<T> v = end ? end->load(from, i) : loadBlock(from + i);
    bits |= bitsOf<sizeof(T)>(v >= lowest) << i;
    if constexpr (IsFloating<T>)
    {
      sum += v;
    }
    if constexpr (measure)
    {
      range.low = v < range.low ? v : range.low;
      range.high = v > range.high ? v : range.high;
    }
  }
  return end ? bits >> end->others : bits;
}

template <class T>
INK_INLINE bool maybeMissing(const Block<T>& sum)
{
  if constexpr (IsFloating<T>)
  {
    const Block<T> rest = sum - sum;
    return bitsOf<sizeof(T)>(rest == rest) != (~std::uint64_t(0) >> (WordBits - BlockLanes<T>));
  }
  else
  {
    return false;
  }
}

/// The lesser of each element and the one so many bytes further up, or the larger, as far as the first asks.
template <class T, bool largest, int bytes, class V>
INK_INLINE void fold(V& v)
{
  if constexpr (bytes >= static_cast<int>(sizeof(T)))
  {
    typedef std::uint64_t Words __attribute__((vector_size(16)));
    const Words words = reinterpret_cast<Words>(v);
    V further;
    if constexpr (bytes == 8)
    {
      further = reinterpret_cast<V>(Words{ words[1], words[0] });
    }
    else
    {
      further = reinterpret_cast<V>(LittleEndian ? words >> 8 * bytes : words << 8 * bytes);
    }
    v = (largest ? v > further : v < further) ? v : further;
    fold<T, largest, bytes / 2>(v);
  }
}

/// The least element of a vector, or the largest.
template <class T, bool largest>
INK_INLINE T extremeOf(const Block<T>& block)
{
  using V = typename VectorOf<T, 16>::Type;
  V v = load<V>(&block);
  if constexpr (sizeof(block) > sizeof v)
  {
    const V upper = load<V>(reinterpret_cast<const char*>(&block) + sizeof v);
    v = (largest ? v > upper : v < upper) ? v : upper;
  }
  fold<T, largest, 8>(v);
  return v[0];
}

/// One brick's samples in the rows of a block.
template <class T, bool measure, int rows>
INK_INLINE bool classifyBrickRows(const T* from, std::ptrdiff_t stride, const Block<T>& bound, int firstBit,
  std::uint64_t* bits, T* low, T* high, const RowEnd<T>* end = nullptr)
{
  Block<T> sum = {};
  BrickRange<T> range;
  if constexpr (measure)
  {
    range.low = range.high = end ? Block<T>{} + from[BrickLength<T> - 1] : loadBlock(from);
  }
  for (int r = 0; r < rows; ++r)
  {
    // A machine that sees four streams of one line each fetches none of them ahead: the next block's turn.
    __builtin_prefetch(from + (r + rows) * stride);
    bits[r] |= classifyBrick<T, measure>(from + r * stride, bound, sum, range, end) << firstBit;
  }
  const bool bad = maybeMissing<T>(sum);
  if constexpr (measure)
  {
    *low = extremeOf<T, false>(range.low);
    *high = extremeOf<T, true>(range.high);
    if constexpr (IsFloating<T>)
    {
      *low = bad ? T(__builtin_nan("")) : *low;
      *high = bad ? T(__builtin_nan("")) : *high;
    }
  }
  return bad;
}

/// One word's samples in the rows of a block. Rows have at least a brick's samples up to this word's last.
template <class T, bool measure, int rows>
INK_INLINE int classifyWord(const T* first, std::ptrdiff_t stride, int samples, T lowest,
  std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
{
  const Block<T> bound = Block<T>{} + lowest;
  std::uint64_t bits[rows] = {};
  bool missing = false;
  int done = 0;
  for (int b = 0; done + BrickLength<T> <= samples; ++b, done += BrickLength<T>)
  {
    missing |=
      classifyBrickRows<T, measure, rows>(first + done, stride, bound, done, bits, low + b, high + b);
  }
  if (done < samples)
  {
    const RowEnd<T> end = { BrickLength<T> - (samples - done) };
    const int b = done / BrickLength<T>;
    missing |= classifyBrickRows<T, measure, rows>(
      first + done - end.others, stride, bound, done, bits, low + b, high + b, &end);
  }
  const std::uint64_t there = ~std::uint64_t(0) >> (WordBits - samples);
  std::uint64_t set = 0;
  std::uint64_t clear = 0;
  for (int r = 0; r < rows; ++r)
  {
    words[r * reach] = bits[r] & there;
    set |= bits[r] & there;
    clear |= ~bits[r] & there;
  }
  return (missing ? MaybeMissing : 0) | (set != 0 ? SomeSet : 0) | (clear != 0 ? SomeClear : 0);
}

template <class T, bool measure, int count>
INK_INLINE int classifySome(
  const RowBlock<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
{
  constexpr int bricksPerWord = WordBits / BrickLength<T>;
  int found = 0;
  const int whole = rows.samples / WordBits;
  for (int w = 0; w < whole; ++w)
  {
    const int b = w * bricksPerWord;
    found |= classifyWord<T, measure, count>(
      rows.first + w * WordBits, rows.stride, WordBits, lowest, words + w, reach, low + b, high + b);
  }
  const int rest = rows.samples - whole * WordBits;
  const int b = whole * bricksPerWord;
  if (rest > 0 && rows.samples >= BrickLength<T>)
  {
    found |= classifyWord<T, measure, count>(
      rows.first + whole * WordBits, rows.stride, rest, lowest, words + whole, reach, low + b, high + b);
  }
  else if (rest > 0)
  {
    // The last sample, repeated, changes no range. The rows after them are only prefetched.
    T padded[2 * count][BrickLength<T>];
    for (int r = 0; r < count; ++r)
    {
      const T* from = rows.first + r * rows.stride;
      for (int i = 0; i < BrickLength<T>; ++i)
      {
        padded[r][i] = from[i < rest ? i : rest - 1];
      }
    }
    found |= classifyWord<T, measure, count>(
      padded[0], BrickLength<T>, BrickLength<T>, lowest, words, reach, low, high);
    const std::uint64_t there = ~std::uint64_t(0) >> (WordBits - rest);
    found &= MaybeMissing;
    for (int r = 0; r < count; ++r)
    {
      words[r * reach] &= there;
      found |= (words[r * reach] != 0 ? SomeSet : 0) | (words[r * reach] != there ? SomeClear : 0);
    }
  }
  return found;
}

template <class T, bool measure>
INK_INLINE int classifyRows(
  const RowBlock<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
{
  static_assert(BlockRows == 4);
  switch (rows.rows)
  {
    case 1:
      return classifySome<T, measure, 1>(rows, lowest, words, reach, low, high);
    case 2:
      return classifySome<T, measure, 2>(rows, lowest, words, reach, low, high);
    case 3:
      return classifySome<T, measure, 3>(rows, lowest, words, reach, low, high);
    default:
      return classifySome<T, measure, 4>(rows, lowest, words, reach, low, high);
  }
}

template <class T>
int classify(const RowBlock<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach)
{
  return classifyRows<T, false>(rows, lowest, words, reach, nullptr, nullptr);
}
template <class T>
int classifyAndMeasure(
  const RowBlock<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
{
  return classifyRows<T, true>(rows, lowest, words, reach, low, high);
}
/// A mixed brick's bits, into words that hold what is known of the others.
template <class T>
INK_INLINE bool addBrick(
  const RowBlock<T>& rows, const Block<T>& bound, int brick, std::uint64_t* words, std::ptrdiff_t reach)
{
  const int first = brick * BrickLength<T>;
  const int count = rows.samples - first;
  Block<T> sum = {};
  BrickRange<T> none;
  const RowEnd<T> end = { BrickLength<T> - count };
  for (int r = 0; r < rows.rows; ++r)
  {
    const T* from = rows.first + r * rows.stride + first;
    std::uint64_t bits = 0;
    if (count >= BrickLength<T>)
    {
      bits = classifyBrick<T, false>(from, bound, sum, none);
    }
    else if (first >= end.others)
    {
      bits = classifyBrick<T, false>(from - end.others, bound, sum, none, &end);
    }
    else
    {
      T padded[BrickLength<T>];
      for (int i = 0; i < BrickLength<T>; ++i)
      {
        padded[i] = from[i < count ? i : count - 1];
      }
      bits = classifyBrick<T, false>(padded, bound, sum, none);
    }
    words[r * reach + first / WordBits] |= bits << first % WordBits;
  }
  return maybeMissing<T>(sum);
}

template <class T>
int classifyMixed(
  const RowBlock<T>& rows, T lowest, const std::uint8_t* states, std::uint64_t* words, std::ptrdiff_t reach)
{
  const Block<T> bound = Block<T>{} + lowest;
  const int bricks = (rows.samples + BrickLength<T> - 1) / BrickLength<T>;
  const int wordCount = (rows.samples + WordBits - 1) / WordBits;
  constexpr int bricksPerWord = WordBits / BrickLength<T>;
  constexpr std::uint64_t brickBits = ~std::uint64_t(0) >> (WordBits - BrickLength<T>);
  bool missing = false;
  for (int w = 0; w < wordCount; ++w)
  {
    std::uint64_t known = 0;
    for (int b = w * bricksPerWord; b < bricks && b < (w + 1) * bricksPerWord; ++b)
    {
      known |= (states[b] == 1 ? brickBits : 0) << b % bricksPerWord * BrickLength<T>;
    }
    for (int r = 0; r < rows.rows; ++r)
    {
      words[r * reach + w] = known;
    }
  }
  // They lie apart in memory, and so do those of the next layer, mostly the same: these are sent for already.
  constexpr int most = 64;
  int mixed[most + 1];
  for (int begin = 0; begin < bricks; begin += most)
  {
    int count = 0;
    for (int b = begin; b < bricks && b < begin + most; ++b)
    {
      mixed[count] = b;
      count += states[b] == 2;
    }
    for (int n = 0; n < count; ++n)
    {
      for (int r = 0; r < rows.rows; ++r)
      {
        __builtin_prefetch(rows.first + rows.next + r * rows.stride + mixed[n] * BrickLength<T>);
      }
    }
    for (int n = 0; n < count; ++n)
    {
      missing |= addBrick<T>(rows, bound, mixed[n], words, reach);
    }
  }
  std::uint64_t set = 0;
  std::uint64_t clear = 0;
  for (int w = 0; w < wordCount; ++w)
  {
    const int rest = rows.samples - w * WordBits;
    const std::uint64_t there = ~std::uint64_t(0) >> (rest < WordBits ? WordBits - rest : 0);
    for (int r = 0; r < rows.rows; ++r)
    {
      std::uint64_t& word = words[r * reach + w];
      word &= there;
      set |= word;
      clear |= ~word & there;
    }
  }
  return (missing ? MaybeMissing : 0) | (set != 0 ? SomeSet : 0) | (clear != 0 ? SomeClear : 0);
}

template <class T>
int judge(const T* low, const T* high, int count, T lowest, std::uint8_t* states)
{
  int anyAbove = 0;
  int anyBelow = 0;
  int anyMixed = 0;
  for (int b = 0; b < count; ++b)
  {
    const int above = low[b] >= lowest ? 1 : 0;
    const int below = high[b] < lowest ? 1 : 0;
    const int mixed = 1 - above - below;
    states[b] = static_cast<std::uint8_t>(above + 2 * mixed);
    anyAbove |= above;
    anyBelow |= below;
    anyMixed |= mixed;
  }
  return (anyMixed | (anyAbove & anyBelow)) != 0 ? 2 : anyAbove;
}

/// Some words of the rows of cells between two layers of samples.
template <class W>
INK_INLINE void activeWords(const std::uint64_t* lower, const std::uint64_t* upper, std::ptrdiff_t reach,
  int rows, std::uint64_t* active)
{
  const auto load = [](const std::uint64_t* from)
  {
    W words;
    __builtin_memcpy(&words, from, sizeof words);
    return words;
  };
  // Of the four samples around the edge between two rows of cells: any above, all above.
  W any[2];
  W all[2];
  for (int r = 0; r <= rows; ++r)
  {
    const W a = load(lower + r * reach);
    const W b = load(upper + r * reach);
    const W nextA = a >> 1 | load(lower + r * reach + 1) << 63;
    const W nextB = b >> 1 | load(upper + r * reach + 1) << 63;
    any[r & 1] = (a | nextA) | (b | nextB);
    all[r & 1] = (a & nextA) & (b & nextB);
    if (r > 0)
    {
      const W found = (any[0] | any[1]) & ~(all[0] & all[1]);
      __builtin_memcpy(active + (r - 1) * reach, &found, sizeof found);
    }
  }
}

void activeRows(const std::uint64_t* lower, const std::uint64_t* upper, std::ptrdiff_t reach, int rows,
  int words, std::uint64_t* active)
{
  constexpr int several = BlockBytes / 8;
  int w = 0;
  for (; w + several <= words; w += several)
  {
    activeWords<Block<std::uint64_t>>(lower + w, upper + w, reach, rows, active + w);
  }
  for (; w < words; ++w)
  {
    activeWords<std::uint64_t>(lower + w, upper + w, reach, rows, active + w);
  }
}
