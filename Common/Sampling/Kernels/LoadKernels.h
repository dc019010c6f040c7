// From samples to stencils. Included inside a namespace without a name.

#if defined(__x86_64__)

/// Four neighboring samples, or two pairs of them, as floats.
struct FloatLoader
{
  using Row = __m128;
  static INK_INLINE Row quad(const float* p) { return _mm_loadu_ps(p); }
  static INK_INLINE Row pairs(const float* p, const float* q)
  {
    // Through doubles of their own, as samples need not lie where doubles may.
    double low = 0.0;
    double high = 0.0;
    __builtin_memcpy(&low, p, 8);
    __builtin_memcpy(&high, q, 8);
    return _mm_castpd_ps(_mm_set_pd(high, low));
  }
  static INK_INLINE __m128 floats(Row r) { return r; }
#  if defined(__AVX2__)
  static INK_INLINE __m256 floats(Row a, Row b)
  {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(a), b, 1);
  }
#  endif
};

template <class T>
INK_INLINE int bytesOf(const T* p)
{
  int bytes = 0;
  __builtin_memcpy(&bytes, p, 4);
  return bytes;
}

/// Samples of 16 bits, in the low half of a register.
template <bool isSigned>
struct ShortLoader
{
  using T = std::conditional_t<isSigned, std::int16_t, std::uint16_t>;
  using Row = __m128i;
  static INK_INLINE Row quad(const T* p) { return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)); }
  static INK_INLINE Row pairs(const T* p, const T* q)
  {
    return _mm_unpacklo_epi32(_mm_cvtsi32_si128(bytesOf(p)), _mm_cvtsi32_si128(bytesOf(q)));
  }
  static INK_INLINE __m128 floats(Row r)
  {
    const __m128i wide =
      isSigned ? _mm_srai_epi32(_mm_unpacklo_epi16(r, r), 16) : _mm_unpacklo_epi16(r, _mm_setzero_si128());
    return _mm_cvtepi32_ps(wide);
  }
#  if defined(__AVX2__)
  static INK_INLINE __m256 floats(Row a, Row b)
  {
    const __m128i both = _mm_unpacklo_epi64(a, b);
    return _mm256_cvtepi32_ps(isSigned ? _mm256_cvtepi16_epi32(both) : _mm256_cvtepu16_epi32(both));
  }
#  endif
};

/// Samples of 8 bits, in the lowest quarter of a register.
template <bool isSigned>
struct ByteLoader
{
  using T = std::conditional_t<isSigned, std::int8_t, std::uint8_t>;
  using Row = __m128i;
  static INK_INLINE Row quad(const T* p) { return _mm_cvtsi32_si128(bytesOf(p)); }
  static INK_INLINE Row pairs(const T* p, const T* q)
  {
    return _mm_unpacklo_epi16(_mm_cvtsi32_si128(bytesOf(p)), _mm_cvtsi32_si128(bytesOf(q)));
  }
  static INK_INLINE __m128 floats(Row r)
  {
    const __m128i twice = _mm_unpacklo_epi8(r, isSigned ? r : _mm_setzero_si128());
    const __m128i wide = isSigned ? _mm_srai_epi32(_mm_unpacklo_epi16(twice, twice), 24)
                                  : _mm_unpacklo_epi16(twice, _mm_setzero_si128());
    return _mm_cvtepi32_ps(wide);
  }
#  if defined(__AVX2__)
  static INK_INLINE __m256 floats(Row a, Row b)
  {
    const __m128i both = _mm_unpacklo_epi32(a, b);
    return _mm256_cvtepi32_ps(isSigned ? _mm256_cvtepi8_epi32(both) : _mm256_cvtepu8_epi32(both));
  }
#  endif
};

template <class T>
struct LoaderOf;
template <>
struct LoaderOf<float>
{
  using Type = FloatLoader;
};
template <>
struct LoaderOf<std::int16_t>
{
  using Type = ShortLoader<true>;
};
template <>
struct LoaderOf<std::uint16_t>
{
  using Type = ShortLoader<false>;
};
template <>
struct LoaderOf<std::int8_t>
{
  using Type = ByteLoader<true>;
};
template <>
struct LoaderOf<std::uint8_t>
{
  using Type = ByteLoader<false>;
};

/// Rows of four samples, one for each of a few cells, to four rows of a batch.
#  if defined(__AVX2__)
constexpr int Group = 8;
template <class Loader, class Row>
INK_INLINE void transpose(const Row (&r)[Group], float* s0, float* s1, float* s2, float* s3)
{
  const __m256 a = Loader::floats(r[0], r[4]);
  const __m256 b = Loader::floats(r[1], r[5]);
  const __m256 c = Loader::floats(r[2], r[6]);
  const __m256 d = Loader::floats(r[3], r[7]);
  const __m256 ab = _mm256_unpacklo_ps(a, b);
  const __m256 AB = _mm256_unpackhi_ps(a, b);
  const __m256 cd = _mm256_unpacklo_ps(c, d);
  const __m256 CD = _mm256_unpackhi_ps(c, d);
  _mm256_storeu_ps(s0, _mm256_shuffle_ps(ab, cd, _MM_SHUFFLE(1, 0, 1, 0)));
  _mm256_storeu_ps(s1, _mm256_shuffle_ps(ab, cd, _MM_SHUFFLE(3, 2, 3, 2)));
  _mm256_storeu_ps(s2, _mm256_shuffle_ps(AB, CD, _MM_SHUFFLE(1, 0, 1, 0)));
  _mm256_storeu_ps(s3, _mm256_shuffle_ps(AB, CD, _MM_SHUFFLE(3, 2, 3, 2)));
}
#  else
constexpr int Group = 4;
template <class Loader, class Row>
INK_INLINE void transpose(const Row (&r)[Group], float* s0, float* s1, float* s2, float* s3)
{
  const __m128 a = Loader::floats(r[0]);
  const __m128 b = Loader::floats(r[1]);
  const __m128 c = Loader::floats(r[2]);
  const __m128 d = Loader::floats(r[3]);
  const __m128 ab = _mm_unpacklo_ps(a, b);
  const __m128 AB = _mm_unpackhi_ps(a, b);
  const __m128 cd = _mm_unpacklo_ps(c, d);
  const __m128 CD = _mm_unpackhi_ps(c, d);
  _mm_storeu_ps(s0, _mm_shuffle_ps(ab, cd, _MM_SHUFFLE(1, 0, 1, 0)));
  _mm_storeu_ps(s1, _mm_shuffle_ps(ab, cd, _MM_SHUFFLE(3, 2, 3, 2)));
  _mm_storeu_ps(s2, _mm_shuffle_ps(AB, CD, _MM_SHUFFLE(1, 0, 1, 0)));
  _mm_storeu_ps(s3, _mm_shuffle_ps(AB, CD, _MM_SHUFFLE(3, 2, 3, 2)));
}
#  endif

/// Where the samples of a group's cells lie.
template <class T, bool border>
struct CellGroup
{
  const T* first[Group];
  std::ptrdiff_t before[2][Group]; ///< along y and z
  std::ptrdiff_t after[2][Group];

  INK_INLINE CellGroup(const StencilSource<T>& source, int at)
  {
    for (int i = 0; i < Group; ++i)
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
  using Loader = typename LoaderOf<T>::Type;
  const CellGroup<T, border> cells(source, at);
  typename Loader::Row r[Group];
  const auto row = [&](int n) { return &batch.values[n][at]; };
  for (int n = 0; n < 4; ++n)
  {
    const std::ptrdiff_t across = (n & 1) * source.y + (n >> 1) * source.z;
    for (int i = 0; i < Group; ++i)
    {
      r[i] = Loader::quad(cells.first[i] + across - 1);
    }
    transpose<Loader>(r, row(Corners + n), row(2 * n), row(2 * n + 1), row(Corners + Edges + n));
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int upper = 0; upper < 2; ++upper)
    {
      const std::ptrdiff_t across = upper * (axis == 0 ? source.z : source.y);
      for (int i = 0; i < Group; ++i)
      {
        const T* p = cells.first[i] + across;
        r[i] = Loader::pairs(p + cells.beforeOf(source, axis, i), p + cells.afterOf(source, axis, i));
      }
      const int before = Corners + 4 * (axis + 1) + 2 * upper;
      const int after = before + Edges;
      transpose<Loader>(r, row(before), row(before + 1), row(after), row(after + 1));
    }
  }
}

template <class T, bool border>
INK_INLINE void loadWideGroup(const StencilSource<T>& source, int at, CellBatch<float>& batch)
{
  using Loader = typename LoaderOf<T>::Type;
  const CellGroup<T, border> cells(source, at);
  typename Loader::Row r[Group];
  for (int z = 0; z < 4; ++z)
  {
    for (int y = 0; y < 4; ++y)
    {
      for (int i = 0; i < Group; ++i)
      {
        const std::ptrdiff_t acrossY = y == 0 ? cells.beforeOf(source, 0, i)
          : y == 3                            ? cells.afterOf(source, 0, i)
                                              : (y - 1) * source.y;
        const std::ptrdiff_t acrossZ = z == 0 ? cells.beforeOf(source, 1, i)
          : z == 3                            ? cells.afterOf(source, 1, i)
                                              : (z - 1) * source.z;
        r[i] = Loader::quad(cells.first[i] + acrossY + acrossZ - 1);
      }
      const int n = 4 * y + 16 * z;
      transpose<Loader>(r, &batch.values[n][at], &batch.values[n + 1][at], &batch.values[n + 2][at],
        &batch.values[n + 3][at]);
    }
  }
}

template <class T>
INK_INLINE void loadCornerGroup(const StencilSource<T>& source, int at, CellBatch<float>& batch)
{
  using Loader = typename LoaderOf<T>::Type;
  typename Loader::Row r[Group];
  for (int y = 0; y < 2; ++y)
  {
    for (int i = 0; i < Group; ++i)
    {
      const T* p = source.data + source.offsets[at + i] + y * source.y;
      r[i] = Loader::pairs(p, p + source.z);
    }
    transpose<Loader>(r, &batch.values[2 * y][at], &batch.values[2 * y + 1][at], &batch.values[2 * y + 4][at],
      &batch.values[2 * y + 5][at]);
  }
}

#  if defined(__AVX2__)
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

/// Byte `n` of each element as a number.
template <bool isSigned, int n>
INK_INLINE __m256 byteOf(__m256i packed)
{
  if constexpr (isSigned)
  {
    return _mm256_cvtepi32_ps(_mm256_srai_epi32(_mm256_slli_epi32(packed, 24 - 8 * n), 24));
  }
  else
  {
    return _mm256_cvtepi32_ps(_mm256_and_si256(_mm256_srli_epi32(packed, 8 * n), _mm256_set1_epi32(255)));
  }
}

template <bool isSigned>
INK_INLINE void unpackBytes(const std::uint32_t* packed, float* s0, float* s1, float* s2, float* s3)
{
  const __m256i bytes = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(packed));
  _mm256_storeu_ps(s0, byteOf<isSigned, 0>(bytes));
  _mm256_storeu_ps(s1, byteOf<isSigned, 1>(bytes));
  _mm256_storeu_ps(s2, byteOf<isSigned, 2>(bytes));
  _mm256_storeu_ps(s3, byteOf<isSigned, 3>(bytes));
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
  for (int i = 0; i < count; i += Group)
  {
    const auto row = [&](int n) { return &batch.values[n][i]; };
    for (int n = 0; n < 4; ++n)
    {
      unpackBytes<std::is_signed_v<T>>(
        &packed[n][i], row(Corners + n), row(2 * n), row(2 * n + 1), row(Corners + Edges + n));
      const int before = Corners + 4 + 2 * n;
      const int after = before + Edges;
      unpackBytes<std::is_signed_v<T>>(
        &packed[4 + n][i], row(before), row(before + 1), row(after), row(after + 1));
    }
  }
}
#  endif

template <class T, NormalMethod method>
void load(const StencilSource<T>& source, int count, CellBatch<float>& batch)
{
#  if defined(__AVX2__)
  if constexpr (sizeof(T) == 1 && method != NormalMethod::Cell && method != NormalMethod::Regression)
  {
    loadBytes(source, count, batch);
    return;
  }
#  endif
  for (int at = 0; at < count; at += Group)
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

#endif
