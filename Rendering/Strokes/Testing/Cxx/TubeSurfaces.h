// SPDX-License-Identifier: BSD-3-Clause
/// Closed surfaces around curves and points, with exact normals and distances: a torus, a knot, two spheres.
#ifndef TubeSurfaces_h
#define TubeSurfaces_h

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

struct TubeSurface
{
  std::string Name;
  /// A point of one of the patches, and its normal; u and v in [0, 1).
  struct Point
  {
    glm::dvec3 Position;
    glm::dvec3 Normal;
  };
  std::vector<std::function<Point(double, double)>> Patches;
  std::function<double(const glm::dvec3&)> Distance; ///< negative inside

  /// Patches as grids of columns x rows; the last column and row are the first again where they coincide.
  vtkSmartPointer<vtkPolyData> Mesh(int columns, int rows) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    vtkNew<vtkCellArray> polygons;
    for (const auto& patch : this->Patches)
    {
      const vtkIdType first = points->GetNumberOfPoints();
      for (int row = 0; row <= rows; ++row)
      {
        for (int column = 0; column <= columns; ++column)
        {
          const Point point = patch(double(column % columns) / columns, double(row) / rows);
          points->InsertNextPoint(point.Position.x, point.Position.y, point.Position.z);
          normals->InsertNextTuple3(point.Normal.x, point.Normal.y, point.Normal.z);
        }
      }
      for (vtkIdType row = 0; row < rows; ++row)
      {
        for (vtkIdType column = 0; column < columns; ++column)
        {
          const vtkIdType corner = first + row * (columns + 1) + column;
          polygons->InsertNextCell({ corner, corner + 1, corner + columns + 2 });
          polygons->InsertNextCell({ corner, corner + columns + 2, corner + columns + 1 });
        }
      }
    }
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(polygons);
    mesh->GetPointData()->SetNormals(normals);
    return mesh;
  }

  /// Whether the surface lies between a point on it and an eye. Beyond a cusp a contour lies under its
  /// surface by the cube of the way from there, so the tolerance is that of rounding.
  bool Hides(const glm::dvec3& point, const glm::dvec3& eye) const
  {
    const double whole = glm::distance(point, eye);
    const glm::dvec3 direction = (eye - point) / whole;
    for (double way = 0.004; way < std::min(whole, 8.0);)
    {
      const double distance = this->Distance(point + way * direction);
      if (distance < -1e-8)
      {
        return true;
      }
      way += std::max(distance, 0.004);
    }
    return false;
  }
};

/// A tube around a closed curve of a parameter from 0 to 1.
inline TubeSurface MakeTube(
  const std::string& name, const std::function<glm::dvec3(double)>& curve, double radius)
{
  TubeSurface tube;
  tube.Name = name;
  tube.Patches.push_back(
    [=](double u, double v)
    {
      const double step = 1e-5;
      const glm::dvec3 center = curve(u);
      const glm::dvec3 along = glm::normalize(curve(u + step) - curve(u - step));
      const glm::dvec3 side = glm::normalize(glm::cross(along, glm::dvec3(0.0, 0.0, 1.0)));
      const glm::dvec3 up = glm::cross(side, along);
      const double angle = 2.0 * std::numbers::pi * (v < 1.0 ? v : 0.0);
      const glm::dvec3 normal = std::cos(angle) * side + std::sin(angle) * up;
      return TubeSurface::Point{ center + radius * normal, normal };
    });
  constexpr int count = 1000;
  std::vector<glm::dvec3> samples;
  for (int i = 0; i < count; ++i)
  {
    samples.push_back(curve(static_cast<double>(i) / count));
  }
  tube.Distance = [=](const glm::dvec3& p)
  {
    const auto away = [&](const glm::dvec3& c) { return glm::dot(p - c, p - c); };
    int nearest = 0;
    double least = away(samples[0]);
    for (int i = 1; i < count; ++i)
    {
      const double distance = away(samples[i]);
      nearest = distance < least ? i : nearest;
      least = std::min(distance, least);
    }
    // From the nearest sample to the nearest point of the curve, by Newton's method.
    double u = static_cast<double>(nearest) / count;
    for (int i = 0; i < 4; ++i)
    {
      constexpr double step = 1e-4;
      const double before = away(curve(u - step));
      const double here = away(curve(u));
      const double after = away(curve(u + step));
      u -= 0.5 * step * (after - before) / (after - 2.0 * here + before);
    }
    return std::sqrt(away(curve(u))) - radius;
  };
  return tube;
}

inline TubeSurface MakeTorus()
{
  TubeSurface torus = MakeTube(
    "torus",
    [](double u)
    { return glm::dvec3(std::cos(2.0 * std::numbers::pi * u), std::sin(2.0 * std::numbers::pi * u), 0.0); },
    0.4);
  torus.Distance = [](const glm::dvec3& p) { return std::hypot(std::hypot(p.x, p.y) - 1.0, p.z) - 0.4; };
  return torus;
}

/// A trefoil.
inline TubeSurface MakeKnot()
{
  return MakeTube(
    "knot",
    [](double u)
    {
      const double t = 2.0 * std::numbers::pi * u;
      return 0.4 *
        glm::dvec3(std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t),
          -1.4 * std::sin(3.0 * t));
    },
    0.2);
}

/// One before the other, in part.
inline TubeSurface MakeSpheres()
{
  struct Sphere
  {
    glm::dvec3 Center;
    double Radius;
  };
  const std::vector<Sphere> spheres{ { { -0.4, 0.0, 0.3 }, 0.7 }, { { 0.5, 0.3, -0.9 }, 0.9 } };
  TubeSurface both;
  both.Name = "spheres";
  for (const Sphere& sphere : spheres)
  {
    both.Patches.push_back(
      [=](double u, double v)
      {
        const double longitude = 2.0 * std::numbers::pi * u;
        const double latitude = std::numbers::pi * (v - 0.5);
        const glm::dvec3 normal(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
          std::cos(latitude) * std::sin(longitude));
        return TubeSurface::Point{ sphere.Center + sphere.Radius * normal, normal };
      });
  }
  both.Distance = [=](const glm::dvec3& p)
  {
    double nearest = 1e30;
    for (const Sphere& sphere : spheres)
    {
      nearest = std::min(nearest, glm::distance(p, sphere.Center) - sphere.Radius);
    }
    return nearest;
  };
  return both;
}

#endif
