// SPDX-License-Identifier: BSD-3-Clause
#include "InkOrientation.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace
{

/// Turns two orthogonal unit vectors in their plane: a towards b by angle, and b with it.
void Turn(double a[3], double b[3], double angle)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (int i = 0; i < 3; ++i)
  {
    const double ai = a[i];
    a[i] = c * ai + s * b[i];
    b[i] = c * b[i] - s * ai;
  }
}

/// Where a subject's left, back and top are in the world.
struct Frame
{
  int Left[3];
  int Back[3];
  int Top[3];
};

constexpr const char* Axes[] = { "x", "y", "z", "-x", "-y", "-z" };
/// By the axis that points to the top. Meshes whose top is y face +z.
constexpr Frame Frames[] = {
  { { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 } },
  { { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } },
  { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
  { { 0, -1, 0 }, { 0, 0, 1 }, { -1, 0, 0 } },
  { { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 } },
  { { -1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 } },
};

constexpr double Third = std::numbers::inv_sqrt3;
constexpr double Sixth = Third / std::numbers::sqrt2;
constexpr const char* Names[] = { "front", "back", "left", "right", "top", "bottom", "iso" };
constexpr InkOrientation Views[] = {
  { { 0, 1, 0 }, { 0, 0, 1 } },
  { { 0, -1, 0 }, { 0, 0, 1 } },
  { { -1, 0, 0 }, { 0, 0, 1 } },
  { { 1, 0, 0 }, { 0, 0, 1 } },
  { { 0, 0, -1 }, { 0, 1, 0 } },
  { { 0, 0, 1 }, { 0, -1, 0 } },
  { { -Third, Third, -Third }, { -Sixth, Sixth, 2 * Sixth } },
};

} // namespace

const InkOrientation* InkOrientation::Find(const std::string& view)
{
  const auto found = std::find(std::begin(Names), std::end(Names), view);
  return found == std::end(Names) ? nullptr : &Views[found - std::begin(Names)];
}

std::span<const char* const> InkOrientation::GetViewNames()
{
  return Names;
}

std::span<const char* const> InkOrientation::GetAxes()
{
  return Axes;
}

void InkOrientation::Stand(const std::string& axis)
{
  const Frame& frame = Frames[std::find(std::begin(Axes), std::end(Axes), axis) - std::begin(Axes)];
  for (double* vector : { this->Direction, this->Up })
  {
    const double v[3] = { vector[0], vector[1], vector[2] };
    for (int i = 0; i < 3; ++i)
    {
      vector[i] = v[0] * frame.Left[i] + v[1] * frame.Back[i] + v[2] * frame.Top[i];
    }
  }
}

void InkOrientation::Rotate(double azimuth, double elevation)
{
  double left[3];
  vtkMath::Cross(this->Up, this->Direction, left);
  // A viewer who goes to the right looks to the left.
  Turn(this->Direction, left, vtkMath::RadiansFromDegrees(azimuth));
  double down[3] = { -this->Up[0], -this->Up[1], -this->Up[2] };
  Turn(this->Direction, down, vtkMath::RadiansFromDegrees(elevation));
  for (int i = 0; i < 3; ++i)
  {
    this->Up[i] = -down[i];
  }
}

void InkOrientation::TurnAround(const double axis[3], double degrees)
{
  const int main = static_cast<int>(
    std::max_element(axis, axis + 3, [](double a, double b) { return std::abs(a) < std::abs(b); }) - axis);
  const double angle = vtkMath::RadiansFromDegrees(std::copysign(1.0, axis[main]) * degrees);
  const int first = (main + 1) % 3;
  const int second = (main + 2) % 3;
  for (double* vector : { this->Direction, this->Up })
  {
    const double x = vector[first];
    const double y = vector[second];
    vector[first] = std::cos(angle) * x - std::sin(angle) * y;
    vector[second] = std::sin(angle) * x + std::cos(angle) * y;
  }
}
