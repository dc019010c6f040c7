// SPDX-License-Identifier: BSD-3-Clause
// Small random images, the same with every standard library.
#ifndef RandomImages_h
#define RandomImages_h

#include "InkTestRandom.h"

#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/mat3x3.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
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
