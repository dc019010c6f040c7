// SPDX-License-Identifier: BSD-3-Clause
#include "InkTestPoints.h"

#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace InkTestPoints
{

namespace
{

class Builder
{
public:
  Builder()
  {
    this->Points->SetDataTypeToDouble();
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
  }
  void Add(const Vector& point, const Vector& normal)
  {
    this->Points->InsertNextPoint(point.data());
    this->Normals->InsertNextTuple(normal.data());
  }
  vtkSmartPointer<vtkPolyData> Finish()
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    data->GetPointData()->AddArray(this->Normals);
    return data;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Normals;
};

/// The parts a length falls into so that none is longer than the spacing.
int Parts(double length, double spacing)
{
  return std::max(1, static_cast<int>(std::ceil(length / spacing)));
}

} // namespace

vtkSmartPointer<vtkPolyData> Sphere(double radius, double spacing, Vector center)
{
  const double pi = vtkMath::Pi();
  const int count = Parts(4.0 * pi * radius * radius, spacing * spacing);
  Builder builder;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = i * pi * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - z * z);
    const Vector n{ r * std::cos(angle), r * std::sin(angle), z };
    builder.Add({ center[0] + radius * n[0], center[1] + radius * n[1], center[2] + radius * n[2] }, n);
  }
  return builder.Finish();
}

vtkSmartPointer<vtkPolyData> Torus(double radius, double tubeRadius, double spacing)
{
  const double turn = 2.0 * vtkMath::Pi();
  const int rings = Parts(turn * tubeRadius, spacing);
  Builder builder;
  for (int j = 0; j < rings; ++j)
  {
    const double v = turn * j / rings;
    const double r = radius + tubeRadius * std::cos(v);
    const int parts = Parts(turn * r, spacing);
    for (int i = 0; i < parts; ++i)
    {
      const double u = turn * (i + 0.5 * (j % 2)) / parts;
      builder.Add({ r * std::cos(u), r * std::sin(u), tubeRadius * std::sin(v) },
        { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) });
    }
  }
  return builder.Finish();
}

vtkSmartPointer<vtkPolyData> Plane(double side, double spacing)
{
  const int parts = Parts(side, spacing);
  Builder builder;
  for (int j = 0; j <= parts; ++j)
  {
    for (int i = 0; i <= parts; ++i)
    {
      builder.Add({ side * (i / double(parts) - 0.5), side * (j / double(parts) - 0.5), 0.0 }, { 0, 0, 1 });
    }
  }
  return builder.Finish();
}

void SetRadius(vtkPolyData* points, double radius)
{
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  radii->SetNumberOfTuples(points->GetNumberOfPoints());
  radii->Fill(radius);
  points->GetPointData()->AddArray(radii);
}

vtkSmartPointer<vtkPolyData> Join(vtkPolyData* a, vtkPolyData* b)
{
  Builder builder;
  for (vtkPolyData* part : { a, b })
  {
    vtkDataArray* normals = part->GetPointData()->GetArray("Normals");
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      Vector point;
      Vector normal;
      part->GetPoint(i, point.data());
      normals->GetTuple(i, normal.data());
      builder.Add(point, normal);
    }
  }
  return builder.Finish();
}

vtkSmartPointer<vtkPolyData> Transform(vtkPolyData* points, double scale, Vector shift)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->DeepCopy(points);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Vector p;
    points->GetPoint(i, p.data());
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = scale * p[axis] + shift[axis];
    }
    result->GetPoints()->SetPoint(i, p.data());
  }
  if (vtkDataArray* radii = result->GetPointData()->GetArray("Radius"))
  {
    for (vtkIdType i = 0; i < radii->GetNumberOfTuples(); ++i)
    {
      radii->SetTuple1(i, scale * radii->GetTuple1(i));
    }
  }
  return result;
}

} // namespace InkTestPoints
