// SPDX-License-Identifier: BSD-3-Clause
#ifndef RandomMeshes_h
#define RandomMeshes_h

#include "InkTestRandom.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

/// A small mesh, most often broken: points that are not finite, coincide or are on a line, faces that are
/// turned, twice there, missing or without area, edges of many faces, of any size and anywhere.
struct RandomMesh
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<vtkIdType, 3>> Triangles;

  explicit RandomMesh(InkTestRandom& random)
  {
    random.Once(3) ? this->AddSoup(random) : this->AddPatch(random);
    const int harms = random.UpTo(6);
    for (int n = 0; n < harms; ++n)
    {
      this->Harm(random);
    }
    const double scale = random.Once(4) ? random.Magnitude(-12.0, 12.0) : 1.0;
    const double origin = random.Once(4) ? random.Magnitude(0.0, 9.0) : 0.0;
    for (auto& point : this->Points)
    {
      for (double& x : point)
      {
        x = scale * x + origin;
      }
    }
  }

  vtkSmartPointer<vtkPolyData> Make(InkTestRandom& random) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(random.Once(2) ? VTK_FLOAT : VTK_DOUBLE);
    for (const auto& point : this->Points)
    {
      points->InsertNextPoint(point.data());
    }
    vtkNew<vtkCellArray> polys;
    for (const auto& triangle : this->Triangles)
    {
      polys->InsertNextCell(3, triangle.data());
    }
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(polys);
    if (random.Once(3))
    {
      vtkNew<vtkFloatArray> normals;
      normals->SetName("Normals");
      normals->SetNumberOfComponents(3);
      for (std::size_t i = 0; i < this->Points.size(); ++i)
      {
        const float bad = random.Once(10) ? std::numeric_limits<float>::quiet_NaN() : 0.0f;
        normals->InsertNextTuple3(bad, random.UpTo(3) - 1, random.UpTo(3) - 1);
      }
      mesh->GetPointData()->SetNormals(normals);
    }
    return mesh;
  }

private:
  vtkIdType AnyPoint(InkTestRandom& random) const
  {
    return random.UpTo(static_cast<int>(this->Points.size()));
  }

  void AddSoup(InkTestRandom& random)
  {
    const int points = 1 + random.UpTo(20);
    for (int n = 0; n < points; ++n)
    {
      this->Points.push_back({ random.Share(), random.Share(), random.Share() });
    }
    const int triangles = random.UpTo(40);
    for (int n = 0; n < triangles; ++n)
    {
      this->Triangles.push_back({ this->AnyPoint(random), this->AnyPoint(random), this->AnyPoint(random) });
    }
  }

  void AddPatch(InkTestRandom& random)
  {
    const int columns = 1 + random.UpTo(8);
    const int rows = 1 + random.UpTo(8);
    const double bend = 4.0 * random.Share() - 2.0;
    for (int n = 0; n < (columns + 1) * (rows + 1); ++n)
    {
      const double u = n % (columns + 1) / 8.0;
      const double v = n / (columns + 1) / 8.0;
      this->Points.push_back({ u, v, bend * (u * u - 0.3 * u * v) });
    }
    for (vtkIdType n = 0; n < columns * rows; ++n)
    {
      const vtkIdType corner = n / columns * (columns + 1) + n % columns;
      this->Triangles.push_back({ corner, corner + 1, corner + columns + 2 });
      this->Triangles.push_back({ corner, corner + columns + 2, corner + columns + 1 });
    }
  }

  void Harm(InkTestRandom& random)
  {
    auto& point = this->Points[static_cast<std::size_t>(this->AnyPoint(random))];
    const auto anyTriangle = [&]() -> std::array<vtkIdType, 3>& {
      return this->Triangles[static_cast<std::size_t>(random.UpTo(static_cast<int>(this->Triangles.size())))];
    };
    switch (random.UpTo(10))
    {
      case 0:
        point[0] = std::numeric_limits<double>::quiet_NaN();
        break;
      case 1:
        point[1] = std::numeric_limits<double>::infinity();
        break;
      case 2:
        point[2] = random.Magnitude(10.0, 300.0);
        break;
      case 3: // coincident points
        point = this->Points[static_cast<std::size_t>(this->AnyPoint(random))];
        break;
      case 4: // all on a line, or at one point
        for (auto& other : this->Points)
        {
          other = { random.Once(2) ? other[0] : 0.0, 0.0, 0.0 };
        }
        break;
      case 5: // isolated points
        this->Points.push_back({ random.Share(), random.Share(), random.Share() });
        break;
      case 6: // non-manifold edges
        this->Triangles.push_back({ this->AnyPoint(random), this->AnyPoint(random), this->AnyPoint(random) });
        break;
      default:
        if (!this->Triangles.empty())
        {
          switch (random.UpTo(4))
          {
            case 0: // turned
              std::swap(anyTriangle()[0], anyTriangle()[1]);
              break;
            case 1: // twice
              this->Triangles.push_back(anyTriangle());
              break;
            case 2: // a hole
              anyTriangle() = this->Triangles.back();
              this->Triangles.pop_back();
              break;
            default: // without area
              anyTriangle()[0] = anyTriangle()[1];
          }
        }
    }
  }
};

#endif
