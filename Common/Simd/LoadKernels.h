// SPDX-License-Identifier: BSD-3-Clause
// From samples to stencils. Included inside a namespace without a name.

/// Four neighboring samples of a cell (`quad`), or two pairs of them (`pairs`), as they are in memory, and
/// those of a group of cells to four rows of a batch (`write`).
struct FloatLoader
{
  typedef double Doubles __attribute__((vector_size(16)));
  using Quad = Doubles;
  using Pairs = Doubles;
  static INK_INLINE Quad quad(const float* p) { return load<Quad>(p); }
  static INK_INLINE Pairs pairs(const float* p, const float* q)
  {
    // Through doubles of their own, as samples need not lie where doubles may.
    return Pairs{ load<double>(p), load<double>(q) };
  }
  static INK_INLINE Group<float> both(const Quad* r)
  {
#if defined(__AVX2__)
    return reinterpret_cast<Group<float>>(_mm256_insertf128_pd(_mm256_castpd128_pd256(r[0]), r[4], 1));
#else
    return reinterpret_cast<Group<float>>(r[0]);
#endif
  }
  static INK_INLINE void write(const Quad (&r)[GroupSize], float* s0, float* s1, float* s2, float* s3)
  {
    const Group<float> a = both(r);
    const Group<float> b = both(r + 1);
    const Group<float> c = both(r + 2);
    const Group<float> d = both(r + 3);
    const Group<float> ab = shuffleQuads<0, 1, 0, 1>(a, b);
    const Group<float> AB = shuffleQuads<2, 3, 2, 3>(a, b);
    const Group<float> cd = shuffleQuads<0, 1, 0, 1>(c, d);
    const Group<float> CD = shuffleQuads<2, 3, 2, 3>(c, d);
    storeVector(s0, shuffleQuads<0, 2, 0, 2>(ab, cd));
    storeVector(s1, shuffleQuads<1, 3, 1, 3>(ab, cd));
    storeVector(s2, shuffleQuads<0, 2, 0, 2>(AB, CD));
    storeVector(s3, shuffleQuads<1, 3, 1, 3>(AB, CD));
  }
};

/// Sample `n` of those in each word, as a number.
template <class T, int n>
INK_INLINE Group<float> sampleOf(const Group<std::int32_t>& words)
{
  constexpr int bits = 8 * static_cast<int>(sizeof(T));
  constexpr int below = LittleEndian ? n * bits : 32 - (n + 1) * bits;
  using Ints = Group<std::int32_t>;
  if constexpr (std::is_signed_v<T>)
  {
    return __builtin_convertvector((words << (32 - bits - below)) >> (32 - bits), Group<float>);
  }
  else
  {
    const Ints shifted = reinterpret_cast<Ints>(reinterpret_cast<Group<std::uint32_t>>(words) >> below);
    constexpr int last = below + bits == 32 ? -1 : (1 << bits) - 1;
    return __builtin_convertvector(shifted & last, Group<float>);
  }
}

/// Samples of 8 or 16 bits, which stay together until those of all cells are in one vector.
template <class T>
struct IntegerLoader
{
  using Words = Group<std::int32_t>;
  /// A double goes straight to a vector's register.
  using Pairs = double;
  using Quad = std::conditional_t<sizeof(T) == 1, std::int32_t, double>;
  static INK_INLINE Quad quad(const T* p) { return load<Quad>(p); }
  static INK_INLINE Pairs pairs(const T* p, const T* q)
  {
    // Of 8 bits four each, the last two of which are not used.
    typedef std::int32_t Two __attribute__((vector_size(8)));
    const Two two = { load<std::int32_t>(p), load<std::int32_t>(q) };
    return load<Pairs>(&two);
  }
  static INK_INLINE void write(const double (&r)[GroupSize], float* s0, float* s1, float* s2, float* s3)
  {
#if defined(__AVX2__)
    const Words a = reinterpret_cast<Words>(Group<double>{ r[0], r[1], r[4], r[5] });
    const Words b = reinterpret_cast<Words>(Group<double>{ r[2], r[3], r[6], r[7] });
#else
    const Words a = reinterpret_cast<Words>(Group<double>{ r[0], r[1] });
    const Words b = reinterpret_cast<Words>(Group<double>{ r[2], r[3] });
#endif
    const Words first = shuffleQuads<0, 2, 0, 2>(a, b);
    const Words second = shuffleQuads<1, 3, 1, 3>(a, b);
    storeVector(s0, sampleOf<T, 0>(first));
    storeVector(s1, sampleOf<T, 1>(first));
    storeVector(s2, sampleOf<T, 0>(second));
    storeVector(s3, sampleOf<T, 1>(second));
  }
  static INK_INLINE void write(const Words& words, float* s0, float* s1, float* s2, float* s3)
  {
    storeVector(s0, sampleOf<T, 0>(words));
    storeVector(s1, sampleOf<T, 1>(words));
    storeVector(s2, sampleOf<T, 2>(words));
    storeVector(s3, sampleOf<T, 3>(words));
  }
  static INK_INLINE void write(const std::int32_t (&r)[GroupSize], float* s0, float* s1, float* s2, float* s3)
  {
#if defined(__AVX2__)
    write(Words{ r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7] }, s0, s1, s2, s3);
#else
    write(Words{ r[0], r[1], r[2], r[3] }, s0, s1, s2, s3);
#endif
  }
};

template <class T>
using LoaderOf = std::conditional_t<std::is_same_v<T, float>, FloatLoader, IntegerLoader<T>>;

/// Where the samples of a group's cells lie.
template <class T, bool border>
struct CellGroup
{
  const T* first[GroupSize];
  std::ptrdiff_t before[2][GroupSize]; ///< along y and z
  std::ptrdiff_t after[2][GroupSize];

  INK_INLINE CellGroup(const StencilSource<T>& source, int at)
  {
    for (int i = 0; i < GroupSize; ++i)
    {
      this->first[i] = source.data + source.offsets[at + i];
      if constexpr (border)
      {
        for (int axis = 0; axis < 2; ++axis)
        {
          this->before[axis][i] = source.border[2 * axis][at + i];
          this->after[axis][i] = source.border[2 * axis + 1][at + i];
        }
      }
    }
  }
  INK_INLINE std::ptrdiff_t beforeOf(const StencilSource<T>& source, int axis, int i) const
  {
    return border ? this->before[axis][i] : axis == 0 ? -source.y : -source.z;
  }
  INK_INLINE std::ptrdiff_t afterOf(const StencilSource<T>& source, int axis, int i) const
  {
    return border ? this->after[axis][i] : axis == 0 ? 2 * source.y : 2 * source.z;
  }
};

template <class T, bool border>
INK_INLINE void loadGroup(const StencilSource<T>& source, int at, CellBatch<float>& batch)
{
  using Loader = LoaderOf<T>;
  const CellGroup<T, border> cells(source, at);
  typename Loader::Quad quads[GroupSize];
  typename Loader::Pairs pairs[GroupSize];
  const auto row = [&](int n) { return &batch.values[n][at]; };
  for (int n = 0; n < 4; ++n)
  {
    const std::ptrdiff_t across = (n & 1) * source.y + (n >> 1) * source.z;
    for (int i = 0; i < GroupSize; ++i)
    {
      quads[i] = Loader::quad(cells.first[i] + across - 1);
    }
    Loader::write(quads, row(Corners + n), row(2 * n), row(2 * n + 1), row(Corners + Edges + n));
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int upper = 0; upper < 2; ++upper)
    {
      const std::ptrdiff_t across = upper * (axis == 0 ? source.z : source.y);
      for (int i = 0; i < GroupSize; ++i)
      {
        const T* p = cells.first[i] + across;
        pairs[i] = Loader::pairs(p + cells.beforeOf(source, axis, i), p + cells.afterOf(source, axis, i));
      }
      const int before = Corners + 4 * (axis + 1) + 2 * upper;
      const int after = before + Edges;
      Loader::write(pairs, row(before), row(before + 1), row(after), row(after + 1));
    }
  }
}

template <class T, bool border>
INK_INLINE void loadWideGroup(const StencilSource<T>& source, int at, CellBatch<float>& batch)
{
  using Loader = LoaderOf<T>;
  const CellGroup<T, border> cells(source, at);
  typename Loader::Quad quads[GroupSize];
  for (int z = 0; z < 4; ++z)
  {
    for (int y = 0; y < 4; ++y)
    {
      for (int i = 0; i < GroupSize; ++i)
      {
        const std::ptrdiff_t acrossY = y == 0 ? cells.beforeOf(source, 0, i)
          : y == 3                            ? cells.afterOf(source, 0, i)
                                              : (y - 1) * source.y;
        const std::ptrdiff_t acrossZ = z == 0 ? cells.beforeOf(source, 1, i)
          : z == 3                            ? cells.afterOf(source, 1, i)
                                              : (z - 1) * source.z;
        quads[i] = Loader::quad(cells.first[i] + acrossY + acrossZ - 1);
      }
      const int n = 4 * y + 16 * z;
      Loader::write(quads, &batch.values[n][at], &batch.values[n + 1][at], &batch.values[n + 2][at],
        &batch.values[n + 3][at]);
    }
  }
}

template <class T>
INK_INLINE void loadCornerGroup(const StencilSource<T>& source, int at, CellBatch<float>& batch)
{
  using Loader = LoaderOf<T>;
  typename Loader::Pairs pairs[GroupSize];
  for (int y = 0; y < 2; ++y)
  {
    for (int i = 0; i < GroupSize; ++i)
    {
      const T* p = source.data + source.offsets[at + i] + y * source.y;
      pairs[i] = Loader::pairs(p, p + source.z);
    }
    Loader::write(pairs, &batch.values[2 * y][at], &batch.values[2 * y + 1][at], &batch.values[2 * y + 4][at],
      &batch.values[2 * y + 5][at]);
  }
}

#if defined(__AVX2__)
/// The four samples from the one before each cell on, for the cells of a segment: 4 bytes of a vector each.
/// Pairs leave out the first and the last.
enum class Packing
{
  Quads,
  LowerPairs,
  UpperPairs
};
template <Packing packing>
INK_INLINE __m256i packBytes(const void* first)
{
  const __m256i samples = _mm256_broadcastsi128_si256(_mm_loadu_si128(static_cast<const __m128i*>(first)));
  constexpr char no = -1;
  const auto pattern = [](int i, int byte) -> char
  {
    return packing == Packing::Quads   ? static_cast<char>(i + byte)
      : packing == Packing::LowerPairs ? (byte < 2 ? static_cast<char>(i + byte + 1) : no)
                                       : (byte < 2 ? no : static_cast<char>(i + byte - 1));
  };
  const auto p = [&](int i) { return pattern(i / 4, i % 4); };
  return _mm256_shuffle_epi8(samples,
    _mm256_setr_epi8(p(0), p(1), p(2), p(3), p(4), p(5), p(6), p(7), p(8), p(9), p(10), p(11), p(12), p(13),
      p(14), p(15), p(16), p(17), p(18), p(19), p(20), p(21), p(22), p(23), p(24), p(25), p(26), p(27), p(28),
      p(29), p(30), p(31)));
}

/// Samples of one byte: the cells of a segment share their rows' samples, so that one vector holds the row of
/// all of them. They come together as bytes, and become numbers a whole vector of cells at a time.
template <class T>
void loadBytes(const StencilSource<T>& source, int count, CellBatch<float>& batch)
{
  alignas(64) std::uint32_t packed[8][BatchStride];
  for (int s = 0; s < source.segmentCount; ++s)
  {
    const int lane = source.segments[s].lane;
    const T* cell = source.data + source.offsets[lane] - 1;
    const auto distance = [&](int n, std::ptrdiff_t usual)
    { return source.border[0] ? source.border[n][lane] : usual; };
    const std::ptrdiff_t around[2][2] = { { distance(0, -source.y), distance(1, 2 * source.y) },
      { distance(2, -source.z), distance(3, 2 * source.z) } };
    const auto put = [&](int row, __m256i bytes)
    { _mm256_storeu_si256(reinterpret_cast<__m256i*>(&packed[row][lane]), bytes); };
    for (int n = 0; n < 4; ++n)
    {
      put(n, packBytes<Packing::Quads>(cell + (n & 1) * source.y + (n >> 1) * source.z));
    }
    for (int n = 0; n < 4; ++n)
    {
      const int axis = n >> 1;
      const T* p = cell + (n & 1) * (axis == 0 ? source.z : source.y);
      put(4 + n,
        _mm256_or_si256(packBytes<Packing::LowerPairs>(p + around[axis][0]),
          packBytes<Packing::UpperPairs>(p + around[axis][1])));
    }
  }
  for (int i = 0; i < count; i += GroupSize)
  {
    const auto row = [&](int n) { return &batch.values[n][i]; };
    for (int n = 0; n < 4; ++n)
    {
      IntegerLoader<T>::write(load<Group<std::int32_t>>(&packed[n][i]), row(Corners + n), row(2 * n),
        row(2 * n + 1), row(Corners + Edges + n));
      const int before = Corners + 4 + 2 * n;
      const int after = before + Edges;
      IntegerLoader<T>::write(load<Group<std::int32_t>>(&packed[4 + n][i]), row(before), row(before + 1),
        row(after), row(after + 1));
    }
  }
}
#endif

template <class T, NormalMethod method>
void loadStencils(const StencilSource<T>& source, int count, CellBatch<float>& batch)
{
#if defined(__AVX2__)
  if constexpr (sizeof(T) == 1 && method != NormalMethod::Cell && method != NormalMethod::Regression)
  {
    loadBytes(source, count, batch);
    return;
  }
#endif
  for (int at = 0; at < count; at += GroupSize)
  {
    if constexpr (method == NormalMethod::Cell)
    {
      loadCornerGroup<T>(source, at, batch);
    }
    else if constexpr (method == NormalMethod::Regression)
    {
      source.border[0] ? loadWideGroup<T, true>(source, at, batch)
                       : loadWideGroup<T, false>(source, at, batch);
    }
    else
    {
      source.border[0] ? loadGroup<T, true>(source, at, batch) : loadGroup<T, false>(source, at, batch);
    }
  }
}
