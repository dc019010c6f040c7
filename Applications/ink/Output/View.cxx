// SPDX-License-Identifier: BSD-3-Clause
#include "View.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ink::cli
{
namespace
{

/// Turns two orthogonal unit vectors in their plane: a towards b by angle, and b with it.
void turn(double a[3], double b[3], double angle)
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
  int left[3];
  int back[3];
  int top[3];
};

/// By the axis that points to the top. Meshes whose top is y face +z.
const std::map<std::string, Frame>& frames()
{
  static const std::map<std::string, Frame> all{
    { "z", { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } },
    { "-z", { { -1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 } } },
    { "y", { { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } } },
    { "-y", { { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 } } },
    { "x", { { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 } } },
    { "-x", { { 0, -1, 0 }, { 0, 0, 1 }, { -1, 0, 0 } } },
  };
  return all;
}

} // namespace

void View::stand(const std::string& axis)
{
  const Frame& frame = frames().at(axis);
  for (double* vector : { this->direction, this->up })
  {
    const double v[3] = { vector[0], vector[1], vector[2] };
    for (int i = 0; i < 3; ++i)
    {
      vector[i] = v[0] * frame.left[i] + v[1] * frame.back[i] + v[2] * frame.top[i];
    }
  }
}

std::vector<std::string> upAxes()
{
  std::vector<std::string> axes;
  for (const auto& [axis, frame] : frames())
  {
    axes.push_back(axis);
  }
  return axes;
}

void View::rotate(double azimuth, double elevation)
{
  double left[3];
  vtkMath::Cross(this->up, this->direction, left);
  // A viewer who goes to the right looks to the left.
  turn(this->direction, left, vtkMath::RadiansFromDegrees(azimuth));
  double down[3] = { -this->up[0], -this->up[1], -this->up[2] };
  turn(this->direction, down, vtkMath::RadiansFromDegrees(elevation));
  for (int i = 0; i < 3; ++i)
  {
    this->up[i] = -down[i];
  }
}

void View::turnAround(const double axis[3], double degrees)
{
  const int main = static_cast<int>(
    std::max_element(axis, axis + 3, [](double a, double b) { return std::abs(a) < std::abs(b); }) - axis);
  const double angle = vtkMath::RadiansFromDegrees(std::copysign(1.0, axis[main]) * degrees);
  const int first = (main + 1) % 3;
  const int second = (main + 2) % 3;
  for (double* vector : { this->direction, this->up })
  {
    const double x = vector[first];
    const double y = vector[second];
    vector[first] = std::cos(angle) * x - std::sin(angle) * y;
    vector[second] = std::sin(angle) * x + std::cos(angle) * y;
  }
}

const std::map<std::string, View>& namedViews()
{
  constexpr double third = std::numbers::inv_sqrt3;
  constexpr double sixth = third / std::numbers::sqrt2;
  static const std::map<std::string, View> views{
    { "front", { { 0, 1, 0 }, { 0, 0, 1 } } },
    { "back", { { 0, -1, 0 }, { 0, 0, 1 } } },
    { "left", { { -1, 0, 0 }, { 0, 0, 1 } } },
    { "right", { { 1, 0, 0 }, { 0, 0, 1 } } },
    { "top", { { 0, 0, -1 }, { 0, 1, 0 } } },
    { "bottom", { { 0, 0, 1 }, { 0, -1, 0 } } },
    { "iso", { { -third, third, -third }, { -sixth, sixth, 2 * sixth } } },
  };
  return views;
}

} // namespace ink::cli
