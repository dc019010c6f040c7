// SPDX-License-Identifier: BSD-3-Clause
// What an eye sees of the samples of a brick. Included inside a namespace without a name.

/// As many values that follow each other as a vector holds doubles.
template <class T>
INK_INLINE Vector<double> doublesAt(const T* p)
{
  using Values = typename VectorOf<T, Lanes<double>* static_cast<int>(sizeof(T))>::Type;
#if defined(__AVX2__)
  if constexpr (sizeof(T) <= 2)
  {
    // In two steps, for each of which there is an instruction. (Without a mask GCC 12 warns of its own
    // header.)
#  if defined(__AVX512F__)
    __m256i words;
    if constexpr (sizeof(T) == 1)
    {
      const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(p));
      words = std::is_signed_v<T> ? _mm256_cvtepi8_epi32(bytes) : _mm256_cvtepu8_epi32(bytes);
    }
    else
    {
      const __m128i pairs = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
      words = std::is_signed_v<T> ? _mm256_cvtepi16_epi32(pairs) : _mm256_cvtepu16_epi32(pairs);
    }
    return reinterpret_cast<Vector<double>>(_mm512_maskz_cvtepi32_pd(0xff, words));
#  else
    __m128i words;
    if constexpr (sizeof(T) == 1)
    {
      const __m128i bytes = _mm_cvtsi32_si128(load<std::int32_t>(p));
      words = std::is_signed_v<T> ? _mm_cvtepi8_epi32(bytes) : _mm_cvtepu8_epi32(bytes);
    }
    else
    {
      const __m128i pairs = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(p));
      words = std::is_signed_v<T> ? _mm_cvtepi16_epi32(pairs) : _mm_cvtepu16_epi32(pairs);
    }
    return reinterpret_cast<Vector<double>>(_mm256_cvtepi32_pd(words));
#  endif
  }
#endif
#if defined(__AVX512F__)
  if constexpr (std::is_same_v<T, float>)
  {
    return reinterpret_cast<Vector<double>>(_mm512_maskz_cvtps_pd(0xff, _mm256_loadu_ps(p)));
  }
#endif
  return __builtin_convertvector(load<Values>(p), Vector<double>);
}

/// Looks at the rows that have samples to look at. The operations are those of GridField::gradientOfInner.
/// @return whether all is finite: otherwise samples or neighbors may be missing
template <class T>
bool viewBrick(const BrickSource<T>& source, BrickView& view)
{
  constexpr int lanes = Lanes<double>;
  constexpr int width = BrickView::width;
  constexpr int rowSize = BrickView::rowSize;
  // All values once, with the neighbors of samples around them.
  constexpr int layerSize = rowSize * (width + 2);
  alignas(64) double values[layerSize * (width + 2) + rowSize];
  std::uint32_t rows[width + 4] = {}; // of layers from the second one before the brick on: bit y + 1
  for (int z = 0; z < width; ++z)
  {
    for (int y = 0; y < width; ++y)
    {
      rows[z + 2] |= static_cast<std::uint32_t>((source.needed[z] >> width * y & 31) != 0) << (y + 1);
    }
  }
  for (int z = 0; z < width + 2; ++z)
  {
    const std::uint32_t own = rows[z + 1];
    for (std::uint32_t left = own | own << 1 | own >> 1 | rows[z] | rows[z + 2]; left != 0; left &= left - 1)
    {
      const int y = __builtin_ctz(left);
      for (int x = 0; x < rowSize; x += lanes)
      {
        storeVector(values + x + rowSize * y + layerSize * z,
          doublesAt(source.first + (x - 1) + (y - 1) * source.y + (z - 1) * source.z));
      }
    }
  }
  std::uint64_t wrong = 0;
  for (int z = 0; z < width; ++z)
  {
    std::uint64_t front = 0;
    std::uint64_t inside = 0;
    for (std::uint32_t left = rows[z + 2]; left != 0; left &= left - 1)
    {
      const int y = __builtin_ctz(left) - 1;
      for (int x = 0; x < width; x += lanes)
      {
        const double* const p = values + (x + 1) + rowSize * (y + 1) + layerSize * (z + 1);
        const Vector<double> middle = loadVector(p);
        const auto slope = [&](int step)
        {
          const Vector<double> after = loadVector(p + step);
          const Vector<double> before = loadVector(p - step);
          if constexpr (std::is_integral_v<T>)
          {
            return 0.5 * (after - before); // exact, as the sum of both halves is
          }
          else
          {
            return 0.5 * (after - middle) + 0.5 * (middle - before);
          }
        };
        const Vector<double> facing = -(slope(1) * loadVector(source.view[0] + x) +
          slope(rowSize) * source.view[1][y] + slope(layerSize) * source.view[2][z]);
        const Vector<double> offset = middle * source.scale - source.iso;
        const int at = x + rowSize * y + BrickView::layerSize * z;
        storeVector(view.facing + at, facing);
        storeVector(view.offsets + at, offset);
        const int bit = x + width * y;
        const std::uint64_t row = (std::uint64_t(1) << (width - x)) - 1;
        front |= (bitsOf<8>(facing >= 0.0) & row) << bit;
        inside |= (bitsOf<8>(offset >= 0.0) & row) << bit;
        if constexpr (std::is_floating_point_v<T>)
        {
          wrong |= bitsOf<8>(facing - facing != 0.0) & row;
        }
      }
    }
    view.front[z] = static_cast<std::uint32_t>(front);
    view.inside[z] = static_cast<std::uint32_t>(inside);
  }
  return wrong == 0;
}
