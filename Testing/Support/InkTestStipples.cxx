// SPDX-License-Identifier: BSD-3-Clause
#include "InkTestStipples.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace InkTestStipples
{

namespace
{

using Vector = std::array<double, 3>;

double Fraction(double value)
{
  return value - std::floor(value);
}

class Builder
{
public:
  Builder()
  {
    this->Points->SetDataTypeToDouble();
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Gradients->SetName("GradientMagnitude");
    this->Values->SetName("Value");
  }

  void BeginElement(const Vector& normal, double gradient, double value)
  {
    this->Cells->InsertNextCell(0);
    this->Length = 0;
    this->Normals->InsertNextTuple(normal.data());
    this->Gradients->InsertNextValue(static_cast<float>(gradient));
    this->Values->InsertNextValue(static_cast<float>(value));
  }

  void AddStipple(const Vector& position)
  {
    this->Cells->InsertCellPoint(this->Points->InsertNextPoint(position.data()));
    this->Cells->UpdateCellCount(++this->Length);
  }

  vtkSmartPointer<vtkPolyData> Finish(bool surface, double size, int listed)
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    data->SetVerts(this->Cells);
    data->GetCellData()->AddArray(this->Normals);
    if (!surface)
    {
      data->GetCellData()->AddArray(this->Gradients);
      data->GetCellData()->AddArray(this->Values);
    }
    const auto addField = [&data](const char* name, double value)
    {
      vtkNew<vtkFloatArray> array;
      array->SetName(name);
      array->InsertNextValue(static_cast<float>(value));
      data->GetFieldData()->AddArray(array);
    };
    addField("ElementKind", surface ? 1.0 : 0.0);
    addField("ElementSize", size);
    addField("StipplesPerElement", listed);
    return data;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkFloatArray> Gradients;
  vtkNew<vtkFloatArray> Values;
  int Length = 0;
};

/// Evenly spread numbers in [0, 1) x [0, 1) whatever how many of them are taken.
std::array<double, 2> Spread(int index, double start)
{
  return { Fraction(start + index * 0.7548776662466927), Fraction(start * 7.0 + index * 0.5698402909980532) };
}

} // namespace

vtkSmartPointer<vtkPolyData> SphereVoxels(double radius, double spacing, int stipplesPerVoxel)
{
  Builder builder;
  const int reach = static_cast<int>(radius / spacing) + 2;
  for (int k = -reach; k <= reach; ++k)
  {
    for (int j = -reach; j <= reach; ++j)
    {
      for (int i = -reach; i <= reach; ++i)
      {
        const Vector center{ i * spacing, j * spacing, k * spacing };
        const double distance = vtkMath::Norm(center.data());
        const double beyond = std::abs(distance - radius) / spacing;
        if (beyond >= 1.0 || distance == 0.0)
        {
          continue;
        }
        const Vector normal{ center[0] / distance, center[1] / distance, center[2] / distance };
        Vector u;
        Vector v;
        vtkMath::Perpendiculars(normal.data(), u.data(), v.data(), 0.0);
        builder.BeginElement(normal, 1.0 - 0.9 * beyond, 1.0 - 0.5 * beyond);
        const double start = Fraction(0.123 * i + 0.617 * j + 0.301 * k);
        for (int stipple = 0; stipple < stipplesPerVoxel; ++stipple)
        {
          const auto [a, b] = Spread(stipple, start);
          Vector position;
          for (int axis = 0; axis < 3; ++axis)
          {
            position[axis] = center[axis] + spacing * ((a - 0.5) * u[axis] + (b - 0.5) * v[axis]);
          }
          builder.AddStipple(position);
        }
      }
    }
  }
  return builder.Finish(false, spacing, stipplesPerVoxel);
}

vtkSmartPointer<vtkPolyData> SphereSurface(double radius, int patches, int stipplesPerPatch)
{
  Builder builder;
  const double pi = vtkMath::Pi();
  const int rows = std::max(1, static_cast<int>(std::sqrt(patches / 2.0)));
  const auto position = [&](double row, double column)
  {
    const double z = 1.0 - 2.0 * row / rows;
    const double angle = pi * column / rows;
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    return Vector{ r * std::cos(angle), r * std::sin(angle), z };
  };
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < 2 * rows; ++column)
    {
      builder.BeginElement(position(row + 0.5, column + 0.5), 1.0, 1.0);
      for (int stipple = 0; stipple < stipplesPerPatch; ++stipple)
      {
        const auto [a, b] = Spread(stipple, 0.37 * row + 0.11 * column);
        Vector p = position(row + a, column + b);
        for (double& coordinate : p)
        {
          coordinate *= radius;
        }
        builder.AddStipple(p);
      }
    }
  }
  const double area = 4.0 * pi * radius * radius;
  return builder.Finish(true, std::sqrt(area / (2.0 * rows * rows)), stipplesPerPatch);
}

vtkSmartPointer<vtkPolyData> PlaneSurface(double side, int elements, int stipplesPerElement)
{
  Builder builder;
  const double size = side / elements;
  for (int j = 0; j < elements; ++j)
  {
    for (int i = 0; i < elements; ++i)
    {
      builder.BeginElement({ 0.0, 0.0, 1.0 }, 1.0, 1.0);
      for (int stipple = 0; stipple < stipplesPerElement; ++stipple)
      {
        const auto [a, b] = Spread(stipple, Fraction(0.41 * i + 0.73 * j));
        builder.AddStipple({ size * (i + a) - 0.5 * side, size * (j + b) - 0.5 * side, 0.0 });
      }
    }
  }
  return builder.Finish(true, size, stipplesPerElement);
}

vtkSmartPointer<vtkPolyData> Transform(vtkPolyData* stipples, double scale, const double shift[3])
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->DeepCopy(stipples);
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    Vector p;
    result->GetPoint(i, p.data());
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = scale * p[axis] + shift[axis];
    }
    result->GetPoints()->SetPoint(i, p.data());
  }
  vtkDataArray* size = result->GetFieldData()->GetArray("ElementSize");
  size->SetComponent(0, 0, scale * size->GetComponent(0, 0));
  return result;
}

} // namespace InkTestStipples
