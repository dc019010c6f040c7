// SPDX-License-Identifier: BSD-3-Clause
// What vtkInkGradient estimates, sample by sample, written down as slowly and plainly as it is defined and
// computed in long double.
#ifndef GradientReference_h
#define GradientReference_h

#include "Fields/Grid/GridField.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ink::testing
{

using Wide = long double;
using WideVector = glm::vec<3, long double>;
using WideMatrix = glm::mat<3, 3, long double>;

/// Takes derivatives per sample step to derivatives per world unit.
inline WideMatrix gradientToWorld(const GridGeometry& geometry)
{
  WideMatrix step(geometry.direction());
  for (int axis = 0; axis < 3; ++axis)
  {
    step[axis] *= static_cast<Wide>(geometry.spacing()[axis]);
  }
  return glm::transpose(glm::inverse(step));
}

/// The eigenvalues of a symmetric matrix, which becomes diagonal, and its eigenvectors as columns: Jacobi's
/// rotations.
inline WideMatrix diagonalize(WideMatrix& matrix)
{
  WideMatrix vectors(1.0L);
  for (int sweep = 0; sweep < 60; ++sweep)
  {
    for (int p = 0; p < 2; ++p)
    {
      for (int q = p + 1; q < 3; ++q)
      {
        if (matrix[p][q] == 0.0L)
        {
          continue;
        }
        const Wide angle = 0.5L * std::atan2(2.0L * matrix[p][q], matrix[q][q] - matrix[p][p]);
        WideMatrix rotation(1.0L);
        rotation[p][p] = rotation[q][q] = std::cos(angle);
        rotation[q][p] = std::sin(angle);
        rotation[p][q] = -std::sin(angle);
        matrix = glm::transpose(rotation) * matrix * rotation;
        matrix[p][q] = matrix[q][p] = 0.0L;
        vectors = vectors * rotation;
      }
    }
  }
  return vectors;
}

/// An estimate per sample step, and how far rounding the samples and sums may move it.
struct ReferenceGradient
{
  WideVector gradient = WideVector(0.0L);
  Wide value = 0.0L;
  /// The sum of the sizes of what is added up at most, for each of them.
  WideVector gradientTerms = WideVector(0.0L);
  Wide valueTerms = 0.0L;
  /// How many times larger the error of a coefficient may be than one of rounding.
  Wide condition = 1.0L;
};

template <class T>
ReferenceGradient referenceCentralDifference(const GridField<T>& field, const glm::ivec3& sample)
{
  ReferenceGradient result;
  if (!field.has(sample))
  {
    return result;
  }
  result.value = static_cast<Wide>(field.at(sample));
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::ivec3 ends[2] = { sample, sample };
    for (const int side : { 0, 1 })
    {
      glm::ivec3 neighbor = sample;
      neighbor[axis] += 2 * side - 1;
      ends[side] = field.has(neighbor) ? neighbor : sample;
    }
    const int steps = ends[1][axis] - ends[0][axis];
    const Wide before = static_cast<Wide>(field.at(ends[0]));
    const Wide after = static_cast<Wide>(field.at(ends[1]));
    result.gradient[axis] = steps == 0 ? 0.0L : (after - before) / steps;
    result.gradientTerms[axis] = std::abs(after) + std::abs(before);
  }
  return result;
}

template <class T>
ReferenceGradient referenceRegression(
  const GridField<T>& field, int radius, bool inverseDistance, const glm::ivec3& sample)
{
  ReferenceGradient result;
  if (!field.has(sample))
  {
    return result;
  }
  struct Neighbor
  {
    WideVector offset;
    Wide weight;
    Wide value;
  };
  std::vector<Neighbor> neighbors;
  WideMatrix step(field.geometry().direction());
  Wide nearest = 0.0L;
  for (const bool weigh : { false, true })
  {
    for (int c = -radius; c <= radius; ++c)
    {
      for (int b = -radius; b <= radius; ++b)
      {
        for (int a = -radius; a <= radius; ++a)
        {
          const WideVector offset(a, b, c);
          const Wide distance = glm::length(step * (offset * WideVector(field.geometry().spacing())));
          if (!weigh)
          {
            nearest = distance > 0.0L && (nearest == 0.0L || distance < nearest) ? distance : nearest;
          }
          else if (field.has(sample + glm::ivec3(a, b, c)))
          {
            const Wide weight = inverseDistance ? nearest / std::max(nearest, distance) : 1.0L;
            neighbors.push_back(
              { offset, weight, static_cast<Wide>(field.at(sample + glm::ivec3(a, b, c))) });
          }
        }
      }
    }
  }

  // Weighted least squares around the mean.
  Wide total = 0.0L;
  WideVector mean(0.0L);
  for (const Neighbor& n : neighbors)
  {
    total += n.weight;
    mean += n.weight * n.offset;
  }
  mean /= total;
  WideMatrix spread(0.0L);
  for (const Neighbor& n : neighbors)
  {
    spread += n.weight * glm::outerProduct(n.offset - mean, n.offset - mean);
  }
  // On a scale on which all axes that have neighbors are alike, directions without any are left out.
  WideVector scale(0.0L);
  for (int axis = 0; axis < 3; ++axis)
  {
    scale[axis] = spread[axis][axis] > 1e-15L ? 1.0L / std::sqrt(spread[axis][axis]) : 0.0L;
  }
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < 3; ++b)
    {
      spread[a][b] *= scale[a] * scale[b];
    }
  }
  const WideMatrix vectors = diagonalize(spread);
  WideMatrix inverse(0.0L);
  for (int n = 0; n < 3; ++n)
  {
    if (spread[n][n] > 1e-9L)
    {
      inverse += glm::outerProduct(vectors[n], vectors[n]) / spread[n][n];
      result.condition = std::max(result.condition, 1.0L / spread[n][n]);
    }
  }
  Wide largest = 0.0L;
  for (const Neighbor& n : neighbors)
  {
    largest = std::max(largest, std::abs(n.value));
  }
  result.valueTerms = largest;
  for (const Neighbor& n : neighbors)
  {
    const WideVector coefficient = n.weight * scale * (inverse * (scale * (n.offset - mean)));
    result.gradient += coefficient * n.value;
    const Wide level = n.weight / total - glm::dot(coefficient, mean);
    result.value += level * n.value;
    // A coefficient that should be 0 is so but for rounding of the others.
    result.gradientTerms += glm::abs(coefficient) * largest;
    result.valueTerms += std::abs(level) * largest;
  }
  return result;
}

/// The Laplacian of the samples smoothed by a Gaussian, axis by axis: along each a mean weighted by the
/// Gaussian, and the derivatives of the parabola that fits best with these weights.
template <class T>
class ReferenceLaplacian
{
public:
  /// @param deviation of the Gaussian along each axis, in samples
  ReferenceLaplacian(const GridField<T>& field, const glm::dvec3& deviation)
    : Field(field)
    , Deviation(deviation)
    , Size(field.geometry().dimensions())
  {
    const WideMatrix toWorld = gradientToWorld(field.geometry());
    this->Metric = glm::transpose(toWorld) * toWorld;
    this->AlongX = this->each(
      [&](const glm::ivec3& s)
      {
        return this->along(0, s,
          [&](const glm::ivec3& at) {
            return field.has(at) ? Smoothed{ true, { static_cast<Wide>(field.at(at)), 0.0L, 0.0L } }
                                 : Smoothed{};
          });
      });
    this->AlongY = this->each([&](const glm::ivec3& s)
      { return this->along(1, s, [&](const glm::ivec3& at) { return this->AlongX[this->index(at)]; }); });
  }

  Wide at(const glm::ivec3& sample) const
  {
    if (!this->Field.has(sample))
    {
      return 0.0L;
    }
    return this->along(2, sample, [&](const glm::ivec3& at) { return this->AlongY[this->index(at)]; })
      .values[1];
  }

private:
  /// After the axes so far: the smoothed value, the part of the Laplacian, and what the first derivatives
  /// along later axes are taken of to complete it.
  struct Smoothed
  {
    bool exists = false;
    std::array<Wide, 3> values{};
  };

  struct Line
  {
    Wide smooth = 0.0L;
    Wide first = 0.0L;
    Wide second = 0.0L;
  };

  std::size_t index(const glm::ivec3& s) const
  {
    return static_cast<std::size_t>(s.x + this->Size.x * (s.y + this->Size.y * s.z));
  }

  template <class Make>
  std::vector<Smoothed> each(const Make& make) const
  {
    std::vector<Smoothed> all;
    for (int k = 0; k < this->Size.z; ++k)
    {
      for (int j = 0; j < this->Size.y; ++j)
      {
        for (int i = 0; i < this->Size.x; ++i)
        {
          all.push_back(make(glm::ivec3(i, j, k)));
        }
      }
    }
    return all;
  }

  template <class At>
  Smoothed along(int axis, const glm::ivec3& sample, const At& at) const
  {
    const int reach = std::max(2, static_cast<int>(std::ceil(4.0 * this->Deviation[axis])));
    std::vector<int> offsets;
    std::vector<Smoothed> there;
    for (int offset = -reach; offset <= reach; ++offset)
    {
      glm::ivec3 other = sample;
      other[axis] += offset;
      if (other[axis] >= 0 && other[axis] < this->Size[axis])
      {
        const Smoothed one = at(other);
        if (one.exists)
        {
          offsets.push_back(offset);
          there.push_back(one);
        }
      }
    }
    const auto fit = [&](int which)
    {
      std::vector<Wide> values;
      for (const Smoothed& one : there)
      {
        values.push_back(one.values[static_cast<std::size_t>(which)]);
      }
      return this->fitLine(axis, offsets, values);
    };
    Smoothed result;
    result.exists = this->enough(axis, reach, offsets);
    if (!result.exists)
    {
      return result;
    }
    const WideMatrix& m = this->Metric;
    const Line value = fit(0);
    const Line part = fit(1);
    const Line mixed = fit(2);
    result.values[0] = value.smooth;
    switch (axis)
    {
      case 0:
        result.values[1] = m[0][0] * value.second;
        result.values[2] = value.first;
        break;
      case 1:
        result.values[1] = part.smooth + m[1][1] * value.second + 2.0L * m[0][1] * mixed.first;
        result.values[2] = 2.0L * (m[0][2] * mixed.smooth + m[1][2] * value.first);
        break;
      default:
        result.values[1] = part.smooth + m[2][2] * value.second + mixed.first;
    }
    return result;
  }

  /// Whether enough of the Gaussian has samples.
  bool enough(int axis, int reach, const std::vector<int>& offsets) const
  {
    Wide whole = 0.0L;
    Wide found = 0.0L;
    for (int offset = -reach; offset <= reach; ++offset)
    {
      whole += this->gauss(axis, offset, 0.1L);
      found += std::count(offsets.begin(), offsets.end(), offset) * this->gauss(axis, offset, 0.1L);
    }
    return found >= 0.01L * whole;
  }

  Wide gauss(int axis, int offset, Wide narrowest) const
  {
    const Wide width = std::max(static_cast<Wide>(this->Deviation[axis]), narrowest);
    return std::exp(-offset * offset / (2.0L * width * width));
  }

  Line fitLine(int axis, const std::vector<int>& offsets, const std::vector<Wide>& values) const
  {
    Line line;
    Wide total = 0.0L;
    for (std::size_t n = 0; n < offsets.size(); ++n)
    {
      line.smooth += this->gauss(axis, offsets[n], 0.1L) * values[n];
      total += this->gauss(axis, offsets[n], 0.1L);
    }
    line.smooth /= total;

    // Samples further away than four deviations only where there are too few within.
    const int within = std::max(1, static_cast<int>(std::ceil(4.0 * this->Deviation[axis])));
    const auto isNear = [&](int offset) { return std::abs(offset) <= within; };
    const bool nearOnly = std::count_if(offsets.begin(), offsets.end(), isNear) >= 3;
    std::vector<std::size_t> used;
    for (std::size_t n = 0; n < offsets.size(); ++n)
    {
      if (!nearOnly || isNear(offsets[n]))
      {
        used.push_back(n);
      }
    }
    const std::size_t terms = std::min<std::size_t>(used.size(), 3);
    if (terms < 2)
    {
      return line;
    }
    // The normal equations of a + b x + c x^2, or of a + b x.
    Wide system[3][4] = {};
    for (const std::size_t n : used)
    {
      const Wide weight = used.size() <= 3 ? 1.0L : this->gauss(axis, offsets[n], 0.5L);
      const Wide powers[3] = { 1.0L, static_cast<Wide>(offsets[n]),
        static_cast<Wide>(offsets[n]) * offsets[n] };
      for (std::size_t row = 0; row < terms; ++row)
      {
        for (std::size_t column = 0; column < terms; ++column)
        {
          system[row][column] += weight * powers[row] * powers[column];
        }
        system[row][3] += weight * powers[row] * values[n];
      }
    }
    for (std::size_t pivot = 0; pivot < terms; ++pivot)
    {
      for (std::size_t row = 0; row < terms; ++row)
      {
        const Wide factor = row == pivot ? 0.0L : system[row][pivot] / system[pivot][pivot];
        for (std::size_t column = 0; factor != 0.0L && column < 4; ++column)
        {
          system[row][column] -= factor * system[pivot][column];
        }
      }
    }
    line.first = system[1][3] / system[1][1];
    line.second = terms == 3 ? 2.0L * system[2][3] / system[2][2] : 0.0L;
    return line;
  }

  const GridField<T>& Field;
  glm::dvec3 Deviation;
  glm::ivec3 Size;
  WideMatrix Metric;
  std::vector<Smoothed> AlongX;
  std::vector<Smoothed> AlongY;
};

} // namespace ink::testing

#endif
