// SPDX-License-Identifier: BSD-3-Clause
// Edge voxels as strokes.
#include "InkStrokePoints.h"

#include "Core/Hash.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

InkVoxelArrays::InkVoxelArrays(vtkPolyData* data)
  : Data(data)
  , Gradients(data->GetPointData()->GetArray("Gradient"))
  , Values(data->GetPointData()->GetArray("Value"))
  , Radii(data->GetPointData()->GetArray("Radius"))
{
}

std::string InkVoxelArrays::FindProblem() const
{
  std::ostringstream message;
  const auto check = [&](vtkDataArray* array, int components, const char* name)
  {
    if (message.str().empty() && (!array || array->GetNumberOfComponents() != components))
    {
      message << "Segments through voxels need points with the array \"" << name << "\" of " << components
              << (components == 1 ? " component" : " components") << ", as of vtkInkEdgeVoxels; found "
              << (array ? std::to_string(array->GetNumberOfComponents()) + " components" : "none") << '.';
    }
  };
  check(this->Gradients, 3, "Gradient");
  check(this->Values, 1, "Value");
  check(this->Radii, 1, "Radius");
  const vtkIdType points = this->Data->GetNumberOfPoints();
  for (vtkDataArray* array : { this->Gradients, this->Values, this->Radii })
  {
    if (message.str().empty() && array->GetNumberOfTuples() != points)
    {
      message << "Segments through voxels need a value of \"" << array->GetName() << "\" for each of "
              << points << " points; found " << array->GetNumberOfTuples() << '.';
    }
  }
  // Positions on the GPU are ints, six for each of two points.
  constexpr vtkIdType most = std::numeric_limits<int>::max() / 12;
  if (message.str().empty() && points > most)
  {
    message << "Up to " << most << " voxels can be drawn; found " << points << '.';
  }
  return message.str();
}

InkStrokeArrays::Key InkVoxelArrays::GetKey() const
{
  const auto time = [](vtkObject* object) { return object ? object->GetMTime() : 0; };
  return { time(this->Data->GetPoints()), time(this->Gradients), time(this->Values), time(this->Radii) };
}

void InkStrokePoints::Read(const InkVoxelArrays& arrays)
{
  *this = {};
  double bounds[6];
  InkShiftScale::FindFiniteBounds(arrays.Data->GetPoints(), bounds);
  this->Frame = InkShiftScale::FromBounds(bounds);
  const vtkIdType count = arrays.Data->GetNumberOfPoints();
  const auto gradientAt = [&](vtkIdType id)
  {
    std::array<double, 3> gradient;
    arrays.Gradients->GetTuple(id, gradient.data());
    return gradient;
  };
  double greatest = 0.0;
  for (vtkIdType id = 0; id < count; ++id)
  {
    const auto [x, y, z] = gradientAt(id);
    const double magnitude = std::hypot(x, y, z);
    greatest = std::isfinite(magnitude) ? std::max(greatest, magnitude) : greatest;
  }
  this->GradientUnit = greatest > 0.0 ? greatest : 1.0;
  this->LocalBounds = { INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY };
  for (vtkIdType id = 0; id < count; ++id)
  {
    double p[3];
    float local[3];
    arrays.Data->GetPoint(id, p);
    this->Frame.ToLocal(p, local);
    const auto [x, y, z] = gradientAt(id);
    const double magnitude = std::hypot(x, y, z);
    const double halfLength = arrays.Radii->GetComponent(id, 0) * std::numbers::inv_sqrt3 / this->Frame.Unit;
    if (!(magnitude > 0.0) || !(halfLength > 0.0) ||
      !std::isfinite(magnitude + halfLength + local[0] + local[1] + local[2]))
    {
      continue;
    }
    const auto scaled = [&](double component) { return static_cast<float>(component / this->GradientUnit); };
    const Point point{ { local[0], local[1], local[2] },
      static_cast<float>(arrays.Values->GetComponent(id, 0)) };
    const Shape shape{ { scaled(x), scaled(y), scaled(z) }, static_cast<float>(halfLength) };
    const int first = static_cast<int>(this->Points.size());
    for (int end = 0; end < 2; ++end)
    {
      this->Points.push_back(point);
      this->Shapes.push_back(shape);
      this->Sources.push_back(id);
      this->Ids.push_back(static_cast<std::uint32_t>(id));
    }
    Stroke stroke{ first, first + 1, id, 0.0f, 0.0f, 0.0f, false };
    stroke.Priority = static_cast<float>(ink::unitDouble(ink::hash(static_cast<std::uint64_t>(id))));
    this->Strokes.push_back(stroke);
    this->AddToBounds(local, halfLength);
  }
}
