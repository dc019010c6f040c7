// From samples to bits and ranges. Included inside a namespace without a name.

/// Reading memory is what limits these loops: wider vectors gain nothing, and a brick takes a whole one.
constexpr int BlockBytes = VectorBytes < 32 ? VectorBytes : 32;
template <class T>
constexpr int BlockLanes = BlockBytes / static_cast<int>(sizeof(T));
template <class T>
struct BlockOf
{
  typedef T Type __attribute__((vector_size(BlockBytes)));
};
template <class T>
using Block = typename BlockOf<T>::Type;

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
  Block<T> v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}

/// What is kept of a brick while its samples go by.
template <class T>
struct BrickRange
{
  Block<T> low;
  Block<T> high;
};

/// The bits of a brick's samples in one row. A sum stays NaN or infinite once a sample was.
template <class T, bool measure>
INK_INLINE std::uint64_t classifyBrick(
  const T* from, const Block<T>& lowest, Block<T>& sum, BrickRange<T>& range)
{
  std::uint64_t bits = 0;
  for (int i = 0; i < BrickLength<T>; i += BlockLanes<T>)
  {
    const Block<T> v = loadBlock(from + i);
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
  return bits;
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

/// One word's samples in all rows of a block. All bricks are there to be read, but only `samples` count.
template <class T, bool measure, bool mixed>
INK_INLINE int classifyWord(const T* first, std::ptrdiff_t stride, int rows, int samples, T lowest,
  const std::uint8_t* states, std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
{
  const Block<T> bound = Block<T>{} + lowest;
  std::uint64_t bits[BlockRows] = {};
  bool missing = false;
  for (int b = 0; b * BrickLength<T> < samples; ++b)
  {
    const T* from = first + b * BrickLength<T>;
    if constexpr (mixed)
    {
      if (states[b] != 2)
      {
        const std::uint64_t all = states[b] == 0 ? 0 : ~std::uint64_t(0) >> (WordBits - BrickLength<T>);
        for (int r = 0; r < rows; ++r)
        {
          bits[r] |= all << (b * BrickLength<T>);
        }
        continue;
      }
    }
    Block<T> sum = {};
    BrickRange<T> range;
    if constexpr (measure)
    {
      range.low = range.high = loadBlock(from);
    }
    for (int r = 0; r < rows; ++r)
    {
      bits[r] |= classifyBrick<T, measure>(from + r * stride, bound, sum, range) << (b * BrickLength<T>);
    }
    const bool bad = maybeMissing<T>(sum);
    missing |= bad;
    if constexpr (measure)
    {
      T least = range.low[0];
      T largest = range.high[0];
      for (int i = 1; i < BlockLanes<T>; ++i)
      {
        least = range.low[i] < least ? range.low[i] : least;
        largest = range.high[i] > largest ? range.high[i] : largest;
      }
      if constexpr (IsFloating<T>)
      {
        least = bad ? T(__builtin_nan("")) : least;
        largest = bad ? T(__builtin_nan("")) : largest;
      }
      low[b] = least;
      high[b] = largest;
    }
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

template <class T, bool measure, bool mixed>
INK_INLINE int classifyRows(const SampleRows<T>& rows, T lowest, const std::uint8_t* states,
  std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
{
  constexpr int bricksPerWord = WordBits / BrickLength<T>;
  int found = 0;
  const int whole = rows.samples / WordBits;
  for (int w = 0; w < whole; ++w)
  {
    const int b = w * bricksPerWord;
    found |= classifyWord<T, measure, mixed>(rows.first + w * WordBits, rows.stride, rows.rows, WordBits, lowest,
      states + b, words + w, reach, low + b, high + b);
  }
  const int rest = rows.samples - whole * WordBits;
  if (rest > 0)
  {
    // The last sample, repeated, changes no range.
    T padded[BlockRows][WordBits];
    for (int r = 0; r < rows.rows; ++r)
    {
      const T* from = rows.first + r * rows.stride + whole * WordBits;
      for (int i = 0; i < WordBits; ++i)
      {
        padded[r][i] = from[i < rest ? i : rest - 1];
      }
    }
    const int b = whole * bricksPerWord;
    found |= classifyWord<T, measure, mixed>(
      padded[0], WordBits, rows.rows, rest, lowest, states + b, words + whole, reach, low + b, high + b);
  }
  return found;
}

template <class T>
int classify(const SampleRows<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach)
{
  return classifyRows<T, false, false>(rows, lowest, nullptr, words, reach, nullptr, nullptr);
}
template <class T>
int classifyAndMeasure(
  const SampleRows<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
{
  return classifyRows<T, true, false>(rows, lowest, nullptr, words, reach, low, high);
}
template <class T>
int classifyMixed(const SampleRows<T>& rows, T lowest, const std::uint8_t* states, std::uint64_t* words,
  std::ptrdiff_t reach)
{
  return classifyRows<T, false, true>(rows, lowest, states, words, reach, nullptr, nullptr);
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

void pairRows(const std::uint64_t* a, const std::uint64_t* b, int words, std::uint64_t* any, std::uint64_t* all)
{
  for (int w = 0; w < words; ++w)
  {
    const std::uint64_t nextA = a[w] >> 1 | a[w + 1] << 63;
    const std::uint64_t nextB = b[w] >> 1 | b[w + 1] << 63;
    any[w] = (a[w] | nextA) | (b[w] | nextB);
    all[w] = (a[w] & nextA) & (b[w] & nextB);
  }
}

std::uint64_t crossRows(const std::uint64_t* anyLower, const std::uint64_t* allLower,
  const std::uint64_t* anyUpper, const std::uint64_t* allUpper, int words, std::uint64_t* crossed)
{
  std::uint64_t some = 0;
  for (int w = 0; w < words; ++w)
  {
    crossed[w] = (anyLower[w] | anyUpper[w]) & ~(allLower[w] & allUpper[w]);
    some |= crossed[w];
  }
  return some;
}
