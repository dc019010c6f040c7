// SPDX-License-Identifier: BSD-3-Clause
// What an eye sees of the samples of a brick. Included inside a namespace without a name.

/// As many values that follow each other as a vector holds doubles.
template <class T>
INK_INLINE Vector<double> doublesAt(const T* p)
{
  using Values = typename VectorOf<T, Lanes<double> * static_cast<int>(sizeof(T))>::Type;
  if constexpr (sizeof(T) < 4)
  {
    // In two steps, for each of which there is an instruction.
    using Words = VectorOf<std::int32_t, Lanes<double> * 4>::Type;
    return __builtin_convertvector(__builtin_convertvector(load<Values>(p), Words), Vector<double>);
  }
  else
  {
    return __builtin_convertvector(load<Values>(p), Vector<double>);
  }
}

/// Looks at the rows that have samples to look at. The operations are those of GridField::gradientOfInner.
/// @return whether all is finite: otherwise samples or neighbors may be missing
template <class T>
bool viewBrick(const BrickSource<T>& source, BrickView& view)
{
  constexpr int lanes = Lanes<double>;
  constexpr int width = BrickView::width;
  std::uint64_t wrong = 0;
  for (int z = 0; z < width; ++z)
  {
    std::uint64_t front = 0;
    std::uint64_t inside = 0;
    for (int y = 0; y < width; ++y)
    {
      if ((source.needed[z] >> width * y & 31) == 0)
      {
        continue;
      }
      for (int x = 0; x < width; x += lanes)
      {
        const T* const p = source.first + x + y * source.y + z * source.z;
        const Vector<double> middle = doublesAt(p);
        const auto slope = [&](std::ptrdiff_t step)
        {
          const Vector<double> after = doublesAt(p + step);
          const Vector<double> before = doublesAt(p - step);
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
          slope(source.y) * source.view[1][y] + slope(source.z) * source.view[2][z]);
        const Vector<double> offset = middle * source.scale - source.iso;
        const int at = x + BrickView::rowSize * y + BrickView::layerSize * z;
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
