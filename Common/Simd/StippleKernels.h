// SPDX-License-Identifier: BSD-3-Clause
// Filling a voxel with stipples. Included inside a namespace without a name; see VoxelFill.

// Eight numbers whatever the instruction set, so that each set chooses among the same candidates.
using Eight = VectorOf<float, 32>::Type;
using EightInts = VectorOf<std::int32_t, 32>::Type;
using EightBits = VectorOf<std::uint32_t, 32>::Type;
constexpr int EightLanes = VoxelFill::Lanes;

INK_INLINE Eight loadEight(const float* from)
{
  return load<Eight>(from);
}
INK_INLINE void storeEight(float* to, const Eight& v)
{
  __builtin_memcpy(to, &v, sizeof v);
}

INK_INLINE Eight lesser(const Eight& a, const Eight& b)
{
  return a < b ? a : b;
}

INK_INLINE unsigned bitsOfEight(const EightInts& mask)
{
#if defined(__AVX2__)
  return static_cast<unsigned>(bitsOf<4>(mask));
#else
  Mask<float> halves[2];
  __builtin_memcpy(halves, &mask, sizeof mask);
  return static_cast<unsigned>(bitsOf<4>(halves[0]) | bitsOf<4>(halves[1]) << 4);
#endif
}

#if defined(__AVX2__)
/// For each set of bits the numbers of those that are set, in bytes, the first in the lowest.
struct LaneLists
{
  std::uint64_t of[256];

  constexpr LaneLists()
    : of{}
  {
    for (unsigned bits = 0; bits < 256; ++bits)
    {
      int count = 0;
      for (unsigned lane = 0; lane < 8; ++lane)
      {
        if (bits >> lane & 1u)
        {
          this->of[bits] |= static_cast<std::uint64_t>(lane) << 8 * count++;
        }
      }
    }
  }
};
constexpr LaneLists laneLists;
#endif

/// The stipples that a voxel's new stipples keep away from, on its tangent plane.
struct Crowd
{
  float* x;
  float* y;
  /// How many stipples a voxel has when this one is drawn: its rank + 1.
  float* number;
  int size = 0;

  /// Adds those whose bits are set. May come from the crowd's own later members.
  INK_INLINE void add(unsigned wanted, const Eight& px, const Eight& py, const Eight& numbers)
  {
#if defined(__AVX2__)
    const __m256i lanes =
      _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(laneLists.of[wanted])));
    const auto pack = [&](const Eight& v)
    { return reinterpret_cast<Eight>(_mm256_permutevar8x32_ps(reinterpret_cast<__m256>(v), lanes)); };
    storeEight(this->x + this->size, pack(px));
    storeEight(this->y + this->size, pack(py));
    storeEight(this->number + this->size, pack(numbers));
    this->size += __builtin_popcount(wanted);
#else
    float lanes[3][EightLanes];
    storeEight(lanes[0], px);
    storeEight(lanes[1], py);
    storeEight(lanes[2], numbers);
    for (int i = 0; i < EightLanes; ++i)
    {
      this->x[this->size] = lanes[0][i];
      this->y[this->size] = lanes[1][i];
      this->number[this->size] = lanes[2][i];
      this->size += static_cast<int>(wanted >> i & 1u);
    }
#endif
  }

  /// Forgets those farther from the origin than the root of a square.
  INK_INLINE void keepWithin(float square)
  {
    const int before = this->size;
    this->size = 0;
    for (int n = 0; n < before; n += EightLanes)
    {
      const Eight px = loadEight(this->x + n);
      const Eight py = loadEight(this->y + n);
      const unsigned valid = before - n >= EightLanes ? 0xffu : (1u << (before - n)) - 1u;
      const unsigned within = bitsOfEight(px * px + py * py <= square);
      this->add(within & valid, px, py, loadEight(this->number + n));
    }
  }

  /// For each candidate the least squared distance to a member, times the larger of both numbers: in units of
  /// the area that a stipple has when both are drawn. Very large without members.
  INK_INLINE Eight leastSpacing(const Eight& px, const Eight& py, float own) const
  {
    const auto weightOf = [&](int n) { return own > this->number[n] ? own : this->number[n]; };
#if !defined(__AVX2__)
    // Compilers take vectors that are wider than the machine's apart through memory.
    using Half = Vector<float>;
    Half halves[6];
    __builtin_memcpy(halves, &px, sizeof px);
    __builtin_memcpy(halves + 2, &py, sizeof py);
    Half low = Half{} + 1e30f;
    Half high = low;
    for (int n = 0; n < this->size; ++n)
    {
      const auto nearer = [&](const Half& ownX, const Half& ownY, const Half& least)
      {
        const Half dx = ownX - this->x[n];
        const Half dy = ownY - this->y[n];
        const Half spacing = weightOf(n) * (dx * dx + dy * dy);
        return spacing < least ? spacing : least;
      };
      low = nearer(halves[0], halves[2], low);
      high = nearer(halves[1], halves[3], high);
    }
    halves[4] = low;
    halves[5] = high;
    return load<Eight>(halves + 4);
#else
    Eight least = Eight{} + 1e30f;
    for (int n = 0; n < this->size; ++n)
    {
      const Eight dx = px - this->x[n];
      const Eight dy = py - this->y[n];
      least = lesser(weightOf(n) * (dx * dx + dy * dy), least);
    }
    return least;
#endif
  }
};

/// All of the numbers to [-1/2, 1/2].
INK_INLINE Eight centered(const EightBits& bits)
{
  return __builtin_convertvector(reinterpret_cast<EightInts>(bits), Eight) * 0x1p-32f;
}

/// x, y, z of up to eight vectors that lie one after the other.
INK_INLINE void loadVectors(const float* from, int count, Eight vectors[3])
{
  float lanes[3][EightLanes];
  for (int i = 0; count >= EightLanes && i < EightLanes; i += GroupSize)
  {
#if defined(__AVX2__)
    const auto quads = [from](int n)
    {
      return _mm256_insertf128_ps(
        _mm256_castps128_ps256(_mm_loadu_ps(from + n)), _mm_loadu_ps(from + n + 12), 1);
    };
#else
    const auto quads = [from, i](int n) { return load<Group<float>>(from + 3 * i + n); };
#endif
    const Group<float> a = quads(0);                // x0 y0 z0 x1
    const Group<float> b = quads(4);                // y1 z1 x2 y2
    const Group<float> c = quads(8);                // z2 x3 y3 z3
    const auto xy = shuffleQuads<2, 3, 1, 2>(b, c); // x2 y2 x3 y3
    const auto yz = shuffleQuads<1, 2, 0, 1>(a, b); // y0 z0 y1 z1
    storeVector(lanes[0] + i, shuffleQuads<0, 3, 0, 2>(a, xy));
    storeVector(lanes[1] + i, shuffleQuads<0, 2, 1, 3>(yz, xy));
    storeVector(lanes[2] + i, shuffleQuads<1, 3, 0, 3>(yz, c));
  }
  for (int i = 0; count < EightLanes && i < EightLanes; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lanes[axis][i] = i < count ? from[3 * i + axis] : 0.0f;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    vectors[axis] = loadEight(lanes[axis]);
  }
}

INK_INLINE void mindNeighbors(const VoxelFill& voxel, Crowd& near)
{
  const Eight first = { 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f };
  for (int rank = 0; rank < voxel.count; rank += EightLanes)
  {
    const Eight sight = loadEight(voxel.sight + rank);
    const Eight numbers = first + static_cast<float>(rank);
    const int left = voxel.count - rank;
    const unsigned valid = left >= EightLanes ? 0xffu : (1u << left) - 1u;
    for (int n = 0; n < voxel.neighbors; ++n)
    {
      const float* const offset = voxel.offset[n];
      Eight step[3] = {};
      loadVectors(voxel.neighbor[n] + 3 * rank, left, step);
      for (int axis = 0; axis < 3; ++axis)
      {
        step[axis] = offset[axis] + step[axis];
      }
      const Eight x = voxel.planeX[0] * step[0] + voxel.planeX[1] * step[1] + voxel.planeX[2] * step[2];
      const Eight y = voxel.planeY[0] * step[0] + voxel.planeY[1] * step[1] + voxel.planeY[2] * step[2];
      near.add(bitsOfEight(x * x + y * y <= sight) & valid, x, y, numbers);
    }
  }
}

/// @param solved the axis of the same name in VoxelFill
template <int solved>
INK_INLINE void fillAlong(const VoxelFill& voxel)
{
  constexpr int axisA = (solved + 1) % 3;
  constexpr int axisB = (solved + 2) % 3;
  Crowd near{ voxel.nearX, voxel.nearY, voxel.nearNumber };
  mindNeighbors(voxel, near);

  // The additive recurrence with the powers of 1 / 1.2207440846, which fills the cube evenly from the first
  // point on (Roberts 2018). Whole numbers do not round.
  constexpr std::uint32_t step[3] = { 3518319155u, 2882110345u, 2360945575u };
  const EightBits lane = { 0, 1, 2, 3, 4, 5, 6, 7 };
  EightBits next[3];
  for (int i = 0; i < 3; ++i)
  {
    next[i] = voxel.start[i] + lane * step[i];
  }
  for (int rank = 0; rank < voxel.count; ++rank)
  {
    if (voxel.sortedOut >> rank & 1)
    {
      near.keepWithin(voxel.sight[rank]);
    }
    float chosen[3] = { 0.0f, 0.0f, 0.0f };
    float chosenX = 0.0f;
    float chosenY = 0.0f;
    float widest = -1.0f;
    // Hardly ever are all of them outside. In a thin layer at a voxel's corner the middle is then as good.
    for (int tries = 0; tries < 4 && widest < 0.0f; ++tries)
    {
      Eight position[3];
      position[axisA] = centered(next[0]);
      position[axisB] = centered(next[1]);
      position[solved] = voxel.height * centered(next[2]) - voxel.slope[0] * position[axisA] -
        voxel.slope[1] * position[axisB];
      for (int i = 0; i < 3; ++i)
      {
        next[i] += static_cast<std::uint32_t>(EightLanes) * step[i];
      }
      const Eight x =
        voxel.planeX[0] * position[0] + voxel.planeX[1] * position[1] + voxel.planeX[2] * position[2];
      const Eight y =
        voxel.planeY[0] * position[0] + voxel.planeY[1] * position[1] + voxel.planeY[2] * position[2];
      const EightInts inside = (position[solved] <= 0.5f) & (position[solved] >= -0.5f);
      // -1 where it is outside.
      const Eight outside = Eight{} - 1.0f;
      const Eight spacing = near.leastSpacing(x, y, static_cast<float>(rank + 1));
      const Eight judged = reinterpret_cast<Eight>(
        (reinterpret_cast<EightInts>(spacing) & inside) | (reinterpret_cast<EightInts>(outside) & ~inside));
      float spacings[EightLanes];
      storeEight(spacings, judged);
      for (int i = 0; i < EightLanes; ++i)
      {
        widest = spacings[i] > widest ? spacings[i] : widest;
      }
      if (widest >= 0.0f)
      {
        // Of equal ones the first.
        const int best = __builtin_ctz(bitsOfEight(judged == widest));
        alignas(32) float rows[5][EightLanes];
        storeEight(rows[0], position[0]);
        storeEight(rows[1], position[1]);
        storeEight(rows[2], position[2]);
        storeEight(rows[3], x);
        storeEight(rows[4], y);
        chosen[0] = rows[0][best];
        chosen[1] = rows[1][best];
        chosen[2] = rows[2][best];
        chosenX = rows[3][best];
        chosenY = rows[4][best];
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      voxel.stipples[3 * rank + axis] = chosen[axis];
    }
    near.x[near.size] = chosenX;
    near.y[near.size] = chosenY;
    near.number[near.size] = static_cast<float>(rank + 1);
    ++near.size;
  }
}

void fillVoxel(const VoxelFill& voxel)
{
  switch (voxel.solved)
  {
    case 0:
      fillAlong<0>(voxel);
      break;
    case 1:
      fillAlong<1>(voxel);
      break;
    default:
      fillAlong<2>(voxel);
  }
}
