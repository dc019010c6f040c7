// SPDX-License-Identifier: BSD-3-Clause
#include "Pose.h"

#include "InkHasPolygons.h"
#include "View.h"

#include "ReadError.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ink::cli
{
namespace
{

/// By how much another axis or side has to be better than the usual one.
constexpr double clearly = 1.25;

/// How much larger than that of any side the rectangle is that the top of what lies flat fills, and from how
/// many degrees above it is shown.
constexpr double flat = 2.0;
constexpr double raised = 30.0;

/// The part of the mesh's height that touches the ground.
constexpr double ground = 0.02;

struct Rectangle
{
  double low[2] = { HUGE_VAL, HUGE_VAL };
  double high[2] = { -HUGE_VAL, -HUGE_VAL };

  void add(double a, double b)
  {
    this->low[0] = std::min(this->low[0], a);
    this->low[1] = std::min(this->low[1], b);
    this->high[0] = std::max(this->high[0], a);
    this->high[1] = std::max(this->high[1], b);
  }
  double area() const
  {
    return std::max(this->high[0] - this->low[0], 0.0) * std::max(this->high[1] - this->low[1], 0.0);
  }
};

/// The rectangle around what touches the ground by that around all, with an axis up.
double baseOf(vtkPolyData* mesh, int up)
{
  const double* bounds = mesh->GetBounds();
  const double top = bounds[2 * up] + ground * (bounds[2 * up + 1] - bounds[2 * up]);
  Rectangle base;
  Rectangle all;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    const double a = p[(up + 1) % 3];
    const double b = p[(up + 2) % 3];
    if (!std::isfinite(p[0] + p[1] + p[2]))
    {
      continue;
    }
    all.add(a, b);
    if (p[up] <= top)
    {
      base.add(a, b);
    }
  }
  return all.area() > 0.0 ? base.area() / all.area() : 0.0;
}

std::string findUp(vtkPolyData* mesh, const std::filesystem::path& file)
{
  constexpr int y = 1;
  constexpr int z = 2;
  const double usual = io::suffixOf(file) == ".obj" ? 1.0 / clearly : clearly;
  return baseOf(mesh, y) > usual * baseOf(mesh, z) ? "y" : "z";
}

/// The sides that may be shown, the usual one first, and the top.
constexpr std::array<const char*, 5> sides{ "front", "left", "right", "back", "top" };
constexpr std::size_t top = 4;
using Views = std::array<View, sides.size()>;
using Areas = std::array<double, sides.size()>;

/// For each of these views of a mesh the area of its polygons that face the viewer, as it is seen.
Areas seenAreas(vtkPolyData* mesh, const Views& views)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* made = triangles->GetOutput();
  Areas areas{};
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  vtkCellArray* cells = made->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(count, ids);)
  {
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      made->GetPoint(ids[i], p[i]);
    }
    vtkMath::Subtract(p[1], p[0], p[1]);
    vtkMath::Subtract(p[2], p[0], p[2]);
    double normal[3];
    vtkMath::Cross(p[1], p[2], normal);
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      const double area = -0.5 * vtkMath::Dot(normal, views[i].direction);
      areas[i] += area > 0.0 ? area : 0.0;
    }
  }
  return areas;
}

/// For each of these views the area of the rectangle around all points, as it is seen.
Areas seenRectangles(vtkPolyData* points, const Views& views)
{
  Areas areas{};
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    double right[3];
    vtkMath::Cross(views[i].direction, views[i].up, right);
    Rectangle seen;
    for (int corner = 0; corner < 8; ++corner)
    {
      const double* b = points->GetBounds();
      const double p[3] = { b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2)] };
      seen.add(vtkMath::Dot(p, right), vtkMath::Dot(p, views[i].up));
    }
    areas[i] = seen.area();
  }
  return areas;
}

} // namespace

Pose findPose(vtkPolyData* mesh, const std::filesystem::path& file, const std::optional<std::string>& up)
{
  Pose pose;
  pose.up = up ? *up : findUp(mesh, file);
  Views views;
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    views[i] = namedViews().at(sides[i]);
    views[i].stand(pose.up);
  }
  const Areas rectangles = seenRectangles(mesh, views);
  const Areas areas = InkHasPolygons(mesh) ? seenAreas(mesh, views) : rectangles;
  std::size_t best = 0;
  for (std::size_t i = 1; i < top; ++i)
  {
    best = areas[i] > clearly * areas[best] ? i : best;
  }
  pose.view = sides[best];
  pose.elevation =
    rectangles[top] > flat * *std::max_element(rectangles.begin(), rectangles.begin() + top) ? raised : 0.0;
  return pose;
}

} // namespace ink::cli
