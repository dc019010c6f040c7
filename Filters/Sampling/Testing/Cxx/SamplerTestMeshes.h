// SPDX-License-Identifier: BSD-3-Clause
// Meshes for the tests of vtkInkSurfaceSampler.
#ifndef SamplerTestMeshes_h
#define SamplerTestMeshes_h

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

/// A grid of columns x rows quads, or twice as many triangles, at locate(u, v, position).
inline vtkSmartPointer<vtkPolyData> MakePatch(int columns, int rows, bool triangles,
  const std::function<void(double, double, double[3])>& locate, int type = VTK_FLOAT)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (int row = 0; row <= rows; ++row)
  {
    for (int column = 0; column <= columns; ++column)
    {
      double p[3];
      locate(static_cast<double>(column) / columns, static_cast<double>(row) / rows, p);
      points->InsertNextPoint(p);
    }
  }
  vtkNew<vtkCellArray> polys;
  for (vtkIdType row = 0; row < rows; ++row)
  {
    for (vtkIdType column = 0; column < columns; ++column)
    {
      const vtkIdType a = row * (columns + 1) + column;
      const vtkIdType corners[4] = { a, a + 1, a + columns + 2, a + columns + 1 };
      if (triangles)
      {
        const vtkIdType other[3] = { corners[0], corners[2], corners[3] };
        polys->InsertNextCell(3, corners);
        polys->InsertNextCell(3, other);
      }
      else
      {
        polys->InsertNextCell(4, corners);
      }
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

/// A square of a side length in the plane z = height.
inline vtkSmartPointer<vtkPolyData> MakeSquare(
  int cells, double side = 1.0, bool triangles = true, int type = VTK_FLOAT)
{
  return MakePatch(
    cells, cells, triangles,
    [=](double u, double v, double p[3])
    {
      p[0] = side * u;
      p[1] = side * v;
      p[2] = 0.0;
    },
    type);
}

/// A ball's surface with triangles of no area at the poles.
inline vtkSmartPointer<vtkPolyData> MakeBall(
  int cells, double radius, const std::vector<double>& center = { 0, 0, 0 }, int type = VTK_FLOAT)
{
  return MakePatch(
    2 * cells, cells, true,
    [=](double u, double v, double p[3])
    {
      const double pi = std::acos(-1.0);
      const double around = u == 1.0 ? 0.0 : 2.0 * pi * u;
      const double out = v == 0.0 || v == 1.0 ? 0.0 : std::sin(pi * v);
      p[0] = center[0] + radius * out * std::cos(around);
      p[1] = center[1] + radius * out * std::sin(around);
      p[2] = center[2] - radius * std::cos(pi * v);
    },
    type);
}

/// Slow and obvious.
inline double LeastDistance(vtkPolyData* points, vtkIdType count)
{
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> all(3 * static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->GetPoint(i, &all[3 * static_cast<std::size_t>(i)]);
  }
  for (std::size_t i = 0; i < all.size(); i += 3)
  {
    for (std::size_t j = 0; j < i; j += 3)
    {
      least = std::min(least, std::hypot(all[i] - all[j], all[i + 1] - all[j + 1], all[i + 2] - all[j + 2]));
    }
  }
  return least;
}

/// The distance between neighbors in a hexagonal lattice of as many points.
inline double HexagonalDistance(double area, vtkIdType count)
{
  return std::sqrt(2.0 * area / (std::sqrt(3.0) * static_cast<double>(count)));
}

/// Whether all points and all numbers in point arrays are finite.
inline bool IsFinite(vtkPolyData* points)
{
  for (int array = -1; array < points->GetPointData()->GetNumberOfArrays(); ++array)
  {
    vtkDataArray* data = array < 0 ? (points->GetPoints() ? points->GetPoints()->GetData() : nullptr)
                                   : points->GetPointData()->GetArray(array);
    for (vtkIdType i = 0; data && i < data->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < data->GetNumberOfComponents(); ++c)
      {
        if (!std::isfinite(data->GetComponent(i, c)))
        {
          return false;
        }
      }
    }
  }
  return true;
}

/// Whether two outputs have the same points and the same point arrays, to the bit.
inline bool AreEqual(vtkPolyData* a, vtkPolyData* b)
{
  const auto same = [](vtkDataArray* x, vtkDataArray* y)
  {
    if (!x || !y || x->GetNumberOfTuples() != y->GetNumberOfTuples() ||
      x->GetNumberOfComponents() != y->GetNumberOfComponents() || x->GetDataType() != y->GetDataType())
    {
      return false;
    }
    for (vtkIdType i = 0; i < x->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < x->GetNumberOfComponents(); ++c)
      {
        if (x->GetComponent(i, c) != y->GetComponent(i, c))
        {
          return false;
        }
      }
    }
    return true;
  };
  if (a->GetPointData()->GetNumberOfArrays() != b->GetPointData()->GetNumberOfArrays() ||
    !same(a->GetPoints()->GetData(), b->GetPoints()->GetData()))
  {
    return false;
  }
  for (int i = 0; i < a->GetPointData()->GetNumberOfArrays(); ++i)
  {
    if (!same(
          a->GetPointData()->GetArray(i), b->GetPointData()->GetArray(a->GetPointData()->GetArrayName(i))))
    {
      return false;
    }
  }
  return true;
}

#endif
