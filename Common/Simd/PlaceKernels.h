// SPDX-License-Identifier: BSD-3-Clause
// From stencils to points and normals. Included inside a namespace without a name.

constexpr int Across[3][2] = { { 1, 2 }, { 0, 2 }, { 0, 1 } };
template <int axis, int n>
constexpr int LowCorner = (n & 1) << Across[axis][0] | (n >> 1) << Across[axis][1];
template <int axis, int n>
constexpr int HighCorner = LowCorner<axis, n> | 1 << axis;

/// The row of a batch that holds the corner c.
template <NormalMethod method>
constexpr int CornerRow(int c)
{
  return method == NormalMethod::Regression ? (1 + (c & 1)) + 4 * (1 + (c >> 1 & 1)) + 16 * (1 + (c >> 2))
                                            : c;
}

/// The intersections of the surface with the four edges along an axis: adds up how far along they are, and
/// how many lie on the upper side of the two axes across.
template <class Real, bool strict, int axis>
struct AxisCrossings
{
  Vector<Real> along;
  Mask<Real> counts[4]; ///< -1 for each intersected edge

  template <int n>
  INK_INLINE Vector<Real> cross(
    const Vector<Real>* distance, const Mask<Real>* atLeast, const Mask<Real>* above)
  {
    constexpr int a = LowCorner<axis, n>;
    constexpr int b = HighCorner<axis, n>;
    Vector<Real> share = distance[a] / (distance[a] + distance[b]);
    if constexpr (strict)
    {
      const Mask<Real> both = atLeast[a] & ~above[a] & atLeast[b] & ~above[b];
      this->counts[n] = (above[a] & ~atLeast[b]) | (above[b] & ~atLeast[a]) | both;
      // Both distances are 0.
      const Vector<Real> middle = keep<Real>(Vector<Real>{} + Real(0.5), both);
      return keep<Real>(share, this->counts[n] & ~both) + middle;
    }
    else
    {
      this->counts[n] = atLeast[a] ^ atLeast[b];
      return keep<Real>(share, this->counts[n]);
    }
  }

  INK_INLINE AxisCrossings(const Vector<Real>* distance, const Mask<Real>* atLeast, const Mask<Real>* above)
  {
    const Vector<Real> t0 = this->template cross<0>(distance, atLeast, above);
    const Vector<Real> t1 = this->template cross<1>(distance, atLeast, above);
    const Vector<Real> t2 = this->template cross<2>(distance, atLeast, above);
    const Vector<Real> t3 = this->template cross<3>(distance, atLeast, above);
    this->along = (t0 + t1) + (t2 + t3);
  }
};

template <class Real, GridAxes axes>
INK_INLINE void takeStep(const Real (&matrix)[3][3], const Vector<Real> (&from)[3], Vector<Real> (&to)[3])
{
  if constexpr (axes == GridAxes::General)
  {
    for (int row = 0; row < 3; ++row)
    {
      to[row] = matrix[0][row] * from[0] + matrix[1][row] * from[1] + matrix[2][row] * from[2];
    }
  }
  else
  {
    for (int row = 0; row < 3; ++row)
    {
      to[row] = matrix[row][row] * from[row];
    }
  }
}

template <class Real, bool strict, bool wide, GridAxes axes>
std::uint64_t findPoints(CellBatch<Real>& batch, const KernelParameters<Real>& terms, int count)
{
  constexpr NormalMethod method = wide ? NormalMethod::Regression : NormalMethod::InterpolatedNormal;
  // Between these, squares of gradients neither overflow nor vanish.
  constexpr Real smallest = sizeof(Real) == 4 ? Real(1e-15) : Real(1e-140);
  constexpr Real largest = sizeof(Real) == 4 ? Real(1e15) : Real(1e140);
  std::uint64_t doubtful = 0;
  for (int i = 0; i < count; i += Lanes<Real>)
  {
    Vector<Real> distance[Corners];
    Mask<Real> atLeast[Corners];
    Mask<Real> above[Corners];
    for (int c = 0; c < Corners; ++c)
    {
      const Vector<Real> value = loadVector<Real>(&batch.values[CornerRow<method>(c)][i]);
      distance[c] = magnitude<Real>((value - terms.base) - terms.rest);
      atLeast[c] = value >= terms.atLeast;
      if constexpr (strict)
      {
        above[c] = value >= terms.above;
      }
    }
    const AxisCrossings<Real, strict, 0> x(distance, atLeast, above);
    const AxisCrossings<Real, strict, 1> y(distance, atLeast, above);
    const AxisCrossings<Real, strict, 2> z(distance, atLeast, above);
    const Mask<Real> upperX = (y.counts[1] + y.counts[3]) + (z.counts[1] + z.counts[3]);
    const Mask<Real> upperY = (x.counts[1] + x.counts[3]) + (z.counts[2] + z.counts[3]);
    const Mask<Real> upperZ = (x.counts[2] + x.counts[3]) + (y.counts[2] + y.counts[3]);
    const Mask<Real> all = ((x.counts[0] + x.counts[1]) + (x.counts[2] + x.counts[3])) +
      ((y.counts[0] + y.counts[1]) + (y.counts[2] + y.counts[3])) +
      ((z.counts[0] + z.counts[1]) + (z.counts[2] + z.counts[3]));
    const Vector<Real> share = Real(1.0) / countOf(-all);
    Vector<Real> mean[3] = { (x.along + countOf(-upperX)) * share, (y.along + countOf(-upperY)) * share,
      (z.along + countOf(-upperZ)) * share };
    if constexpr (sizeof(Real) == sizeof(double))
    {
      // Doubles too close for a crossing to be told from none: the cell's middle.
      const Mask<Real> none = all == 0;
      for (Vector<Real>& m : mean)
      {
        m = keep<Real>(m, ~none) + keep<Real>(Vector<Real>{} + Real(0.5), none);
      }
    }
    Vector<Real> step[3];
    takeStep<Real, axes>(terms.step, mean, step);
    for (int axis = 0; axis < 3; ++axis)
    {
      storeVector(&batch.means[axis][i], mean[axis]);
      storeVector(&batch.points[axis][i], loadVector<Real>(&batch.corners[axis][i]) + step[axis]);
    }
    if (terms.checkRange)
    {
      Vector<Real> farthest = distance[0];
      for (int c = 1; c < Corners; ++c)
      {
        farthest = distance[c] > farthest ? distance[c] : farthest;
      }
      const Mask<Real> fine = (farthest >= smallest) & (farthest <= largest);
      doubtful |= bitsOf<sizeof(Real)>(~fine) << i;
    }
  }
  return doubtful;
}

/// About 1 / sqrt(square), to 2.6e-5: the bits of a float, halved, are about half its logarithm, and the
/// polynomial is the one closest to 1 / sqrt over what the guess leaves. Only weights need no more. 0 gives a
/// finite number.
INK_INLINE Vector<float> reciprocalRoot(const Vector<float>& square)
{
  const Mask<float> bits = 0x5f3759df - (reinterpret_cast<Mask<float>>(square) >> 1);
  const Vector<float> guess = reinterpret_cast<Vector<float>>(bits);
  const Vector<float> left = (square * guess) * guess;
  return guess * (1.876347957f + left * (left * 0.375252078f - 1.251599211f));
}
INK_INLINE Vector<double> reciprocalRoot(const Vector<double>& square)
{
  return 1.0 / squareRoot(square + 0x1p-1022);
}

/// The square of the world's gradient.
template <class Real, GridAxes axes>
INK_INLINE Vector<Real> squareOf(const Vector<Real> (&g)[3], const Real (&q)[6])
{
  if constexpr (axes == GridAxes::Cubic)
  {
    return g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
  }
  else if constexpr (axes == GridAxes::Aligned)
  {
    return q[0] * g[0] * g[0] + q[1] * g[1] * g[1] + q[2] * g[2] * g[2];
  }
  else
  {
    return g[0] * (q[0] * g[0] + q[3] * g[1] + q[4] * g[2]) + g[1] * (q[1] * g[1] + q[5] * g[2]) +
      q[2] * g[2] * g[2];
  }
}

/// Twice the gradient at a corner, by central differences.
template <class Real, int corner, int axis>
INK_INLINE Vector<Real> centralDifference(const CellBatch<Real>& batch, int i)
{
  constexpr int n = (corner >> Across[axis][0] & 1) | (corner >> Across[axis][1] & 1) << 1;
  constexpr bool upper = corner >> axis & 1;
  constexpr int next = upper ? Corners + Edges + 4 * axis + n : HighCorner<axis, n>;
  constexpr int previous = upper ? LowCorner<axis, n> : Corners + 4 * axis + n;
  return loadVector<Real>(&batch.values[next][i]) - loadVector<Real>(&batch.values[previous][i]);
}

/// 18 times the gradient at a corner, by regression with equal weights: the sum of nine differences.
template <class Real>
INK_INLINE Vector<Real> regression(const CellBatch<Real>& batch, int i, int corner, int axis)
{
  constexpr int steps[3] = { 1, 4, 16 };
  const int middle = CornerRow<NormalMethod::Regression>(corner);
  const int a = steps[axis == 0 ? 1 : 0];
  const int b = steps[axis == 2 ? 1 : 2];
  Vector<Real> sum = {};
  for (int p = -1; p <= 1; ++p)
  {
    for (int q = -1; q <= 1; ++q)
    {
      const int row = middle + p * a + q * b;
      sum += loadVector<Real>(&batch.values[row + steps[axis]][i]) -
        loadVector<Real>(&batch.values[row - steps[axis]][i]);
    }
  }
  return sum;
}

/// What the corners' gradients add up to.
template <class Real, NormalMethod method, GridAxes axes>
struct DirectionSum
{
  Vector<Real> sum[3] = {};

  template <int corner>
  INK_INLINE void add(
    const CellBatch<Real>& batch, const KernelParameters<Real>& terms, int i, const Vector<Real>& share)
  {
    Vector<Real> g[3];
    if constexpr (method == NormalMethod::Regression)
    {
      g[0] = regression<Real>(batch, i, corner, 0);
      g[1] = regression<Real>(batch, i, corner, 1);
      g[2] = regression<Real>(batch, i, corner, 2);
    }
    else
    {
      g[0] = centralDifference<Real, corner, 0>(batch, i);
      g[1] = centralDifference<Real, corner, 1>(batch, i);
      g[2] = centralDifference<Real, corner, 2>(batch, i);
    }
    Vector<Real> weight = share;
    if constexpr (method != NormalMethod::InterpolatedGradient)
    {
      weight *= reciprocalRoot(squareOf<Real, axes>(g, terms.square));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->sum[axis] += weight * g[axis];
    }
  }
};

template <class Real, NormalMethod method, GridAxes axes>
INK_INLINE void sumDirections(
  const CellBatch<Real>& batch, const KernelParameters<Real>& terms, int i, Vector<Real> (&result)[3])
{
  const Vector<Real> x = loadVector<Real>(&batch.means[0][i]);
  const Vector<Real> y = loadVector<Real>(&batch.means[1][i]);
  const Vector<Real> z = loadVector<Real>(&batch.means[2][i]);
  const Vector<Real> x0 = Real(1.0) - x;
  const Vector<Real> y0 = Real(1.0) - y;
  const Vector<Real> z0 = Real(1.0) - z;
  const Vector<Real> yz[4] = { y0 * z0, y * z0, y0 * z, y * z };
  if constexpr (method == NormalMethod::Cell)
  {
    Vector<Real> v[Corners];
    for (int c = 0; c < Corners; ++c)
    {
      v[c] = loadVector<Real>(&batch.values[c][i]);
    }
    const Vector<Real> xz[4] = { x0 * z0, x * z0, x0 * z, x * z };
    const Vector<Real> xy[4] = { x0 * y0, x * y0, x0 * y, x * y };
    result[0] =
      (yz[0] * (v[1] - v[0]) + yz[1] * (v[3] - v[2])) + (yz[2] * (v[5] - v[4]) + yz[3] * (v[7] - v[6]));
    result[1] =
      (xz[0] * (v[2] - v[0]) + xz[1] * (v[3] - v[1])) + (xz[2] * (v[6] - v[4]) + xz[3] * (v[7] - v[5]));
    result[2] =
      (xy[0] * (v[4] - v[0]) + xy[1] * (v[5] - v[1])) + (xy[2] * (v[6] - v[2]) + xy[3] * (v[7] - v[3]));
  }
  else
  {
    DirectionSum<Real, method, axes> d;
    d.template add<0>(batch, terms, i, x0 * yz[0]);
    d.template add<1>(batch, terms, i, x * yz[0]);
    d.template add<2>(batch, terms, i, x0 * yz[1]);
    d.template add<3>(batch, terms, i, x * yz[1]);
    d.template add<4>(batch, terms, i, x0 * yz[2]);
    d.template add<5>(batch, terms, i, x * yz[2]);
    d.template add<6>(batch, terms, i, x0 * yz[3]);
    d.template add<7>(batch, terms, i, x * yz[3]);
    for (int axis = 0; axis < 3; ++axis)
    {
      result[axis] = d.sum[axis];
    }
  }
}

template <class Real, NormalMethod method, GridAxes axes>
std::uint64_t findNormals(CellBatch<Real>& batch, const KernelParameters<Real>& terms, int count)
{
  // Unit vectors that cancel leave rounding; gradients have any length that squares without overflow.
  constexpr bool units = method == NormalMethod::InterpolatedNormal || method == NormalMethod::Regression;
  constexpr Real smallest =
    units ? (sizeof(Real) == 4 ? Real(1e-4) : Real(1e-20)) : (sizeof(Real) == 4 ? Real(1e-30) : Real(1e-280));
  constexpr Real largest = units ? Real(2.0) : (sizeof(Real) == 4 ? Real(1e30) : Real(1e280));
  std::uint64_t doubtful = 0;
  for (int i = 0; i < count; i += Lanes<Real>)
  {
    Vector<Real> sum[3];
    sumDirections<Real, method, axes>(batch, terms, i, sum);
    Vector<Real> world[3];
    if constexpr (axes == GridAxes::Cubic)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        world[axis] = sum[axis];
      }
    }
    else
    {
      takeStep<Real, axes>(terms.direction, sum, world);
    }
    const Vector<Real> square = world[0] * world[0] + world[1] * world[1] + world[2] * world[2];
    // False for NaN.
    const Mask<Real> fine = (square >= smallest) & (square <= largest);
    doubtful |= bitsOf<sizeof(Real)>(~fine) << i;
    const Vector<Real> scale = Real(-1.0) / squareRoot(square);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector<Real> component = world[axis] * scale;
      if constexpr (sizeof(Real) == sizeof(float))
      {
        storeVector(&batch.normals[axis][i], component);
      }
      else
      {
        for (int lane = 0; lane < Lanes<Real>; ++lane)
        {
          batch.normals[axis][i + lane] = static_cast<float>(component[lane]);
        }
      }
    }
  }
  return doubtful;
}

void interleave(const float* x, const float* y, const float* z, int count, float* xyz)
{
  int i = 0;
  for (; i + GroupSize <= count; i += GroupSize)
  {
    const auto a = load<Group<float>>(x + i);
    const auto b = load<Group<float>>(y + i);
    const auto c = load<Group<float>>(z + i);
    // As the comments show for the first four.
    const auto xy = shuffleQuads<0, 2, 0, 2>(a, b);       // x0 x2 y0 y2
    const auto yz = shuffleQuads<1, 3, 1, 3>(b, c);       // y1 y3 z1 z3
    const auto zx = shuffleQuads<0, 2, 1, 3>(c, a);       // z0 z2 x1 x3
    const auto first = shuffleQuads<0, 2, 0, 2>(xy, zx);  // x0 y0 z0 x1
    const auto second = shuffleQuads<0, 2, 1, 3>(yz, xy); // y1 z1 x2 y2
    const auto third = shuffleQuads<1, 3, 1, 3>(zx, yz);  // z2 x3 y3 z3
    float* const to = xyz + 3 * i;
#if defined(__AVX2__)
    _mm256_storeu_ps(to, _mm256_permute2f128_ps(first, second, 0x20));
    _mm256_storeu_ps(to + 8, _mm256_permute2f128_ps(third, first, 0x30));
    _mm256_storeu_ps(to + 16, _mm256_permute2f128_ps(second, third, 0x31));
#else
    storeVector(to, first);
    storeVector(to + 4, second);
    storeVector(to + 8, third);
#endif
  }
  for (; i < count; ++i)
  {
    xyz[3 * i] = x[i];
    xyz[3 * i + 1] = y[i];
    xyz[3 * i + 2] = z[i];
  }
}
