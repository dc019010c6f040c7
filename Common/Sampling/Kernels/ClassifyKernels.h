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
template <class T>
struct QuarterOf
{
  typedef T Type __attribute__((vector_size(16)));
};

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

#if defined(__x86_64__)
/// The lesser of each element and the one so many bytes further up, or the larger.
template <class T, bool largest, int bytes>
INK_INLINE void fold(typename QuarterOf<T>::Type& v)
{
  if constexpr (bytes >= static_cast<int>(sizeof(T)))
  {
    using V = typename QuarterOf<T>::Type;
    const V further = reinterpret_cast<V>(_mm_srli_si128(reinterpret_cast<__m128i>(v), bytes));
    v = (largest ? v > further : v < further) ? v : further;
    fold<T, largest, bytes / 2>(v);
  }
}
#endif

/// The least element of a vector, or the largest.
template <class T, bool largest>
INK_INLINE T extremeOf(const Block<T>& block)
{
#if defined(__x86_64__)
  using V = typename QuarterOf<T>::Type;
  V v;
  __builtin_memcpy(&v, &block, sizeof v);
  if constexpr (sizeof(block) > sizeof v)
  {
    V upper;
    __builtin_memcpy(&upper, reinterpret_cast<const char*>(&block) + sizeof v, sizeof upper);
    v = (largest ? v > upper : v < upper) ? v : upper;
  }
  fold<T, largest, 8>(v);
  return v[0];
#else
  T extreme = block[0];
  for (int i = 1; i < BlockLanes<T>; ++i)
  {
    extreme = (largest ? block[i] > extreme : block[i] < extreme) ? block[i] : extreme;
  }
  return extreme;
#endif
}

/// One word's samples in the rows of a block. All bricks are there to be read, but only `samples` count.
template <class T, bool measure, int rows>
INK_INLINE int classifyWord(const T* first, std::ptrdiff_t stride, int samples, T lowest,
  std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
{
  const Block<T> bound = Block<T>{} + lowest;
  std::uint64_t bits[rows] = {};
  bool missing = false;
  for (int b = 0; b * BrickLength<T> < samples; ++b)
  {
    const T* from = first + b * BrickLength<T>;
    Block<T> sum = {};
    BrickRange<T> range;
    if constexpr (measure)
    {
      range.low = range.high = loadBlock(from);
    }
    for (int r = 0; r < rows; ++r)
    {
      // A machine that sees four streams of one line each fetches none of them ahead: the next block's turn.
      __builtin_prefetch(from + (r + rows) * stride);
      bits[r] |= classifyBrick<T, measure>(from + r * stride, bound, sum, range) << (b * BrickLength<T>);
    }
    const bool bad = maybeMissing<T>(sum);
    missing |= bad;
    if constexpr (measure)
    {
      low[b] = extremeOf<T, false>(range.low);
      high[b] = extremeOf<T, true>(range.high);
      if constexpr (IsFloating<T>)
      {
        low[b] = bad ? T(__builtin_nan("")) : low[b];
        high[b] = bad ? T(__builtin_nan("")) : high[b];
      }
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

template <class T, bool measure, int count>
INK_INLINE int classifySome(
  const SampleRows<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
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
  if (rest > 0)
  {
    // The last sample, repeated, changes no range.
    T padded[count][WordBits];
    for (int r = 0; r < count; ++r)
    {
      const T* from = rows.first + r * rows.stride + whole * WordBits;
      for (int i = 0; i < WordBits; ++i)
      {
        padded[r][i] = from[i < rest ? i : rest - 1];
      }
    }
    const int b = whole * bricksPerWord;
    found |= classifyWord<T, measure, count>(
      padded[0], WordBits, rest, lowest, words + whole, reach, low + b, high + b);
  }
  return found;
}

template <class T, bool measure>
INK_INLINE int classifyRows(
  const SampleRows<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
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
int classify(const SampleRows<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach)
{
  return classifyRows<T, false>(rows, lowest, words, reach, nullptr, nullptr);
}
template <class T>
int classifyAndMeasure(
  const SampleRows<T>& rows, T lowest, std::uint64_t* words, std::ptrdiff_t reach, T* low, T* high)
{
  return classifyRows<T, true>(rows, lowest, words, reach, low, high);
}
/// A mixed brick's bits, into words that hold what is known of the others.
template <class T>
INK_INLINE bool addBrick(
  const SampleRows<T>& rows, const Block<T>& bound, int brick, std::uint64_t* words, std::ptrdiff_t reach)
{
  const int first = brick * BrickLength<T>;
  const int count = rows.samples - first;
  Block<T> sum = {};
  BrickRange<T> none;
  for (int r = 0; r < rows.rows; ++r)
  {
    const T* from = rows.first + r * rows.stride + first;
    T padded[BrickLength<T>];
    if (count < BrickLength<T>)
    {
      for (int i = 0; i < BrickLength<T>; ++i)
      {
        padded[i] = from[i < count ? i : count - 1];
      }
      from = padded;
    }
    words[r * reach + first / WordBits] |= classifyBrick<T, false>(from, bound, sum, none)
      << first % WordBits;
  }
  return maybeMissing<T>(sum);
}

template <class T>
int classifyMixed(
  const SampleRows<T>& rows, T lowest, const std::uint8_t* states, std::uint64_t* words, std::ptrdiff_t reach)
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
INK_INLINE void crossWords(const std::uint64_t* lower, const std::uint64_t* upper, std::ptrdiff_t reach,
  int rows, std::uint64_t* crossed)
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
      __builtin_memcpy(crossed + (r - 1) * reach, &found, sizeof found);
    }
  }
}

void crossRows(const std::uint64_t* lower, const std::uint64_t* upper, std::ptrdiff_t reach, int rows,
  int words, std::uint64_t* crossed)
{
  constexpr int several = BlockBytes / 8;
  int w = 0;
  for (; w + several <= words; w += several)
  {
    crossWords<Block<std::uint64_t>>(lower + w, upper + w, reach, rows, crossed + w);
  }
  for (; w < words; ++w)
  {
    crossWords<std::uint64_t>(lower + w, upper + w, reach, rows, crossed + w);
  }
}
