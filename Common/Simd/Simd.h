// SPDX-License-Identifier: BSD-3-Clause
// Vectors of the width of the instruction set that is compiled for, in the language that GCC and Clang have
// for them, so that every processor has these kernels. Intrinsics stand only where a compiler finds no good
// instruction by itself. Included inside a namespace without a name.

#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
constexpr int VectorBytes = 64;
#elif defined(__AVX2__)
constexpr int VectorBytes = 32;
#else
constexpr int VectorBytes = 16;
#endif

template <class T>
constexpr int Lanes = VectorBytes / static_cast<int>(sizeof(T));
/// How many elements of 32 bits are shuffled at once: wider vectors gain nothing there.
constexpr int GroupSize = VectorBytes < 32 ? 4 : 8;

// Comparing two vectors gives a vector of integers of the same size, -1 where it holds and 0 elsewhere.
template <class T, int bytes>
struct VectorOf
{
  typedef T Type __attribute__((vector_size(bytes)));
};
template <class T>
using Vector = typename VectorOf<T, VectorBytes>::Type;
template <class T>
using Group = typename VectorOf<T, 4 * GroupSize>::Type;

template <class Real>
struct MaskOf;
template <>
struct MaskOf<float>
{
  using Element = std::int32_t;
  static constexpr Element SignBit = 0x7fffffff;
};
template <>
struct MaskOf<double>
{
  using Element = std::int64_t;
  static constexpr Element SignBit = 0x7fffffffffffffff;
};
template <class Real>
using Mask = Vector<typename MaskOf<Real>::Element>;

#define INK_INLINE inline __attribute__((always_inline))

constexpr bool LittleEndian = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;

/// From anywhere in memory.
template <class V, class From>
INK_INLINE V load(const From* from)
{
  V v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
template <class T>
INK_INLINE Vector<T> loadVector(const T* from)
{
  return load<Vector<T>>(from);
}
template <class T, class V>
INK_INLINE void storeVector(T* to, const V& v)
{
  __builtin_memcpy(to, &v, sizeof v);
}

/// In each quarter of 16 bytes elements i and j of a, then k and l of b.
template <int i, int j, int k, int l, class V>
INK_INLINE V shuffleQuads(const V& a, const V& b)
{
#if defined(__clang__)
#  define INK_SHUFFLE(...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#  define INK_SHUFFLE(...) __builtin_shuffle(a, b, Group<std::int32_t>{ __VA_ARGS__ })
#endif
#if defined(__AVX2__)
  return INK_SHUFFLE(i, j, 8 + k, 8 + l, 4 + i, 4 + j, 12 + k, 12 + l);
#else
  return INK_SHUFFLE(i, j, 4 + k, 4 + l);
#endif
}

template <class Real>
INK_INLINE Vector<Real> keep(const Vector<Real>& v, const Mask<Real>& where)
{
  return reinterpret_cast<Vector<Real>>(reinterpret_cast<Mask<Real>>(v) & where);
}
template <class Real>
INK_INLINE Vector<Real> magnitude(const Vector<Real>& v)
{
  return keep<Real>(v, Mask<Real>{} + MaskOf<Real>::SignBit);
}

/// How often the masks held that were subtracted from `n`, as a number.
INK_INLINE Vector<float> countOf(const Mask<float>& n)
{
  return __builtin_convertvector(n, Vector<float>);
}
INK_INLINE Vector<double> countOf(const Mask<double>& n)
{
  // 2^52 + n has n in its last bits.
  constexpr double shift = 0x1p52;
  constexpr std::int64_t bits = 0x4330000000000000;
  return reinterpret_cast<Vector<double>>(n + bits) - shift;
}

// Compilers make one instruction of each.
INK_INLINE Vector<float> squareRoot(const Vector<float>& v)
{
  Vector<float> r;
  for (int i = 0; i < Lanes<float>; ++i)
  {
    r[i] = __builtin_sqrtf(v[i]);
  }
  return r;
}
INK_INLINE Vector<double> squareRoot(const Vector<double>& v)
{
  Vector<double> r;
  for (int i = 0; i < Lanes<double>; ++i)
  {
    r[i] = __builtin_sqrt(v[i]);
  }
  return r;
}

/// A bit for each element of a mask; elements are 1, 2, 4 or 8 bytes.
template <int size, class M>
INK_INLINE std::uint64_t bitsOf(const M& mask)
{
#if defined(__x86_64__)
#  if defined(__AVX512F__)
  if constexpr (sizeof(M) == 64)
  {
    const __m512i m = reinterpret_cast<__m512i>(mask);
    if constexpr (size == 1)
    {
      return _mm512_movepi8_mask(m);
    }
    else if constexpr (size == 2)
    {
      return _mm512_movepi16_mask(m);
    }
    else if constexpr (size == 4)
    {
      return _mm512_movepi32_mask(m);
    }
    else
    {
      return _mm512_movepi64_mask(m);
    }
  }
#  endif
#  if defined(__AVX2__)
  if constexpr (sizeof(M) == 32)
  {
    const __m256i m = reinterpret_cast<__m256i>(mask);
    if constexpr (size == 1)
    {
      return static_cast<std::uint32_t>(_mm256_movemask_epi8(m));
    }
    else if constexpr (size == 2)
    {
      const __m128i packed = _mm_packs_epi16(_mm256_castsi256_si128(m), _mm256_extracti128_si256(m, 1));
      return static_cast<std::uint32_t>(_mm_movemask_epi8(packed));
    }
    else if constexpr (size == 4)
    {
      return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(m)));
    }
    else
    {
      return static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_castsi256_pd(m)));
    }
  }
#  endif
  if constexpr (sizeof(M) == 16)
  {
    const __m128i m = reinterpret_cast<__m128i>(mask);
    if constexpr (size == 1)
    {
      return static_cast<std::uint32_t>(_mm_movemask_epi8(m));
    }
    else if constexpr (size == 2)
    {
      return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(m, _mm_setzero_si128())));
    }
    else if constexpr (size == 4)
    {
      return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(m)));
    }
    else
    {
      return static_cast<std::uint32_t>(_mm_movemask_pd(_mm_castsi128_pd(m)));
    }
  }
#elif defined(__aarch64__)
  if constexpr (size == 1)
  {
    const uint8x16_t weights = { 1, 2, 4, 8, 16, 32, 64, 128, 1, 2, 4, 8, 16, 32, 64, 128 };
    uint8x16_t sums = vandq_u8(reinterpret_cast<uint8x16_t>(mask), weights);
    for (int pairs = 0; pairs < 3; ++pairs)
    {
      sums = vpaddq_u8(sums, sums);
    }
    return vgetq_lane_u16(vreinterpretq_u16_u8(sums), 0);
  }
  else if constexpr (size == 2)
  {
    const uint16x8_t weights = { 1, 2, 4, 8, 16, 32, 64, 128 };
    return vaddvq_u16(vandq_u16(reinterpret_cast<uint16x8_t>(mask), weights));
  }
  else if constexpr (size == 4)
  {
    const uint32x4_t weights = { 1, 2, 4, 8 };
    return vaddvq_u32(vandq_u32(reinterpret_cast<uint32x4_t>(mask), weights));
  }
  else
  {
    const uint64x2_t weights = { 1, 2 };
    return vaddvq_u64(vandq_u64(reinterpret_cast<uint64x2_t>(mask), weights));
  }
#else
  std::uint64_t bits = 0;
  for (int i = 0; i < static_cast<int>(sizeof(M)) / size; ++i)
  {
    bits |= static_cast<std::uint64_t>(mask[i] & 1) << i;
  }
  return bits;
#endif
}
