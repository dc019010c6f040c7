// SPDX-License-Identifier: BSD-3-Clause
// Small random images, the same with every standard library.
#ifndef RandomImages_h
#define RandomImages_h

#include "InkTestRandom.h"

#include "Fields/Grid/GridGeometry.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/mat3x3.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

inline glm::dmat3 RandomDirection(InkTestRandom& random)
{
  glm::dmat3 direction(1.0);
  switch (random.UpTo(4))
  {
    case 0:
      break;
    case 1: // axes exchanged and mirrored
      direction = glm::dmat3(0, 1, 0, 0, 0, -1, 1, 0, 0);
      break;
    case 2: // turned
    {
      const double a = 6.28 * random.Share();
      const double b = 6.28 * random.Share();
      direction = glm::dmat3(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1) *
        glm::dmat3(1, 0, 0, 0, std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b));
      break;
    }
    default: // sheared
      direction[1][0] = random.Share();
      direction[2][1] = -random.Share();
  }
  return direction;
}

/// Of any scale, origin and first sample, and of axes that are mirrored, turned or sheared.
/// @param mayBeFar whether the origin can lie ten million samples away
inline ink::GridGeometry RandomGeometry(InkTestRandom& random, const glm::ivec3& dimensions, bool mayBeFar)
{
  const glm::ivec3 first(random.UpTo(9) - 4, random.UpTo(9) - 4, random.UpTo(9) - 4);
  const double scale = random.Once(3) ? random.Magnitude(-9, 9) : 1.0;
  glm::dvec3 spacing(scale);
  if (random.Once(2))
  {
    spacing *=
      glm::dvec3(random.Magnitude(-1.5, 1.5), random.Magnitude(-1.5, 1.5), random.Once(2) ? -1.0 : 1.0);
  }
  const double away = mayBeFar && random.Once(3) ? 1e7 : 10.0;
  const glm::dvec3 origin =
    scale * away * glm::dvec3(random.Share() - 0.5, random.Share() - 0.5, random.Share());
  return ink::GridGeometry(dimensions, origin, spacing, RandomDirection(random), first);
}

/// An image without values.
inline vtkSmartPointer<vtkImageData> MakeImage(const ink::GridGeometry& geometry)
{
  const glm::ivec3& first = geometry.first();
  const glm::ivec3 last = first + geometry.dimensions() - 1;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(first.x, last.x, first.y, last.y, first.z, last.z);
  image->SetSpacing(&geometry.spacing()[0]);
  image->SetOrigin(&geometry.origin()[0]);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      image->GetDirectionMatrix()->SetElement(row, column, geometry.direction()[column][row]);
    }
  }
  return image;
}

/// A value of the image's type: one of few, so that many are at an iso-value, or any.
template <class T>
T RandomValue(InkTestRandom& random, int kind, int levels)
{
  const int level = random.UpTo(levels);
  if (kind == 0)
  {
    return static_cast<T>(level);
  }
  if constexpr (std::is_integral_v<T>)
  {
    // All bits, at the ends of the type, or near its greatest value.
    const auto bits = static_cast<std::uint64_t>(random.Share() * 4294967296.0) << 32 |
      static_cast<std::uint64_t>(random.Share() * 4294967296.0);
    return kind == 1 ? static_cast<T>(bits)
      : kind == 2    ? (level % 2 ? std::numeric_limits<T>::max() : std::numeric_limits<T>::lowest())
                     : static_cast<T>(std::numeric_limits<T>::max() - static_cast<T>(level));
  }
  else
  {
    const auto largest = static_cast<double>(std::numeric_limits<T>::max());
    const double signedShare = 2 * random.Share() - 1;
    return kind == 1 ? static_cast<T>(signedShare)
      : kind == 2    ? static_cast<T>(signedShare * 0.99 * largest)
                     : static_cast<T>(1000 + signedShare);
  }
}

/// @param missing how many in a hundred are not finite, where the type has such
template <class T>
void FillRandomly(std::span<T> values, InkTestRandom& random, int kind, int levels, int missing)
{
  for (T& value : values)
  {
    value = RandomValue<T>(random, kind, levels);
    if constexpr (std::is_floating_point_v<T>)
    {
      if (random.UpTo(100) < missing)
      {
        value = random.Once(2) ? std::numeric_limits<T>::quiet_NaN() : -std::numeric_limits<T>::infinity();
      }
    }
  }
}

inline vtkSmartPointer<vtkUnsignedCharArray> RandomMarks(
  InkTestRandom& random, vtkIdType count, unsigned char mark, int percent)
{
  auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(count);
  for (vtkIdType n = 0; n < count; ++n)
  {
    marks->SetValue(n, random.UpTo(100) < percent ? mark : 0);
  }
  return marks;
}

/// Calls body(T(), the type's number) with one of the 13 scalar types of images, by the seed.
template <class Body>
void WithScalarType(unsigned seed, const Body& body)
{
  switch (seed % 13)
  {
    case 0:
      return body(char(), VTK_CHAR);
    case 1:
      return body(static_cast<signed char>(0), VTK_SIGNED_CHAR);
    case 2:
      return body(static_cast<unsigned char>(0), VTK_UNSIGNED_CHAR);
    case 3:
      return body(short(), VTK_SHORT);
    case 4:
      return body(static_cast<unsigned short>(0), VTK_UNSIGNED_SHORT);
    case 5:
      return body(int(), VTK_INT);
    case 6:
      return body(0U, VTK_UNSIGNED_INT);
    case 7:
      return body(0L, VTK_LONG);
    case 8:
      return body(0UL, VTK_UNSIGNED_LONG);
    case 9:
      return body(0LL, VTK_LONG_LONG);
    case 10:
      return body(0ULL, VTK_UNSIGNED_LONG_LONG);
    case 11:
      return body(0.0F, VTK_FLOAT);
    default:
      return body(0.0, VTK_DOUBLE);
  }
}

#endif
