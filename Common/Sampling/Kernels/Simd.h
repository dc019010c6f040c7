// Vectors of the width of the instruction set that is compiled for. Included inside a namespace without a name.

#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
constexpr int VectorBytes = 64;
#elif defined(__AVX2__)
constexpr int VectorBytes = 32;
#else
constexpr int VectorBytes = 16;
#endif

template <class T>
constexpr int Lanes = VectorBytes / static_cast<int>(sizeof(T));

// Comparing two vectors gives a vector of integers of the same size, -1 where it holds and 0 elsewhere.
template <class T>
struct VectorOf
{
  typedef T Type __attribute__((vector_size(VectorBytes)));
};
template <class T>
using Vector = typename VectorOf<T>::Type;

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

template <class T>
INK_INLINE Vector<T> loadVector(const T* from)
{
  Vector<T> v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
template <class T, class V>
INK_INLINE void storeVector(T* to, const V& v)
{
  __builtin_memcpy(to, &v, sizeof v);
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

#if defined(__x86_64__)
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define INK_SQRT(type) squareRoot512_##type
#elif defined(__AVX2__)
#define INK_SQRT(type) _mm256_sqrt_##type
#else
#define INK_SQRT(type) _mm_sqrt_##type
#endif
#endif
#if defined(__AVX512F__)
// With a mask, because some compilers warn of the unmasked one's own unused operand.
#define squareRoot512_ps(v) _mm512_maskz_sqrt_ps(static_cast<__mmask16>(-1), v)
#define squareRoot512_pd(v) _mm512_maskz_sqrt_pd(static_cast<__mmask8>(-1), v)
#endif

INK_INLINE Vector<float> squareRoot(const Vector<float>& v)
{
#if defined(__x86_64__)
  return reinterpret_cast<Vector<float>>(INK_SQRT(ps)(v));
#else
  Vector<float> r;
  for (int i = 0; i < Lanes<float>; ++i)
  {
    r[i] = __builtin_sqrtf(v[i]);
  }
  return r;
#endif
}
INK_INLINE Vector<double> squareRoot(const Vector<double>& v)
{
#if defined(__x86_64__)
  return reinterpret_cast<Vector<double>>(INK_SQRT(pd)(v));
#else
  Vector<double> r;
  for (int i = 0; i < Lanes<double>; ++i)
  {
    r[i] = __builtin_sqrt(v[i]);
  }
  return r;
#endif
}

/// A bit for each element of a mask; elements are 1, 2, 4 or 8 bytes.
template <int size, class M>
INK_INLINE std::uint64_t bitsOf(const M& mask)
{
#if defined(__x86_64__)
#if defined(__AVX512F__)
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
#endif
#if defined(__AVX2__)
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
#endif
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
#endif
  std::uint64_t bits = 0;
  for (int i = 0; i < static_cast<int>(sizeof(M)) / size; ++i)
  {
    bits |= static_cast<std::uint64_t>(mask[i] & 1) << i;
  }
  return bits;
}
