// SPDX-License-Identifier: BSD-3-Clause
#include "InkPose.h"

#include "InkHasPolygons.h"
#include "InkOrientation.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace
{

/// By how much another axis or side has to be better than the usual one.
constexpr double Clearly = 1.25;

/// How much larger than that of any side the rectangle is that the top of what lies flat fills, and from how
/// many degrees above it is shown.
constexpr double Flat = 2.0;
constexpr double Raised = 30.0;

/// The part of the mesh's height that touches the ground.
constexpr double Ground = 0.02;

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

/// The part of what lies over it that a base is at least for standing on it well.
constexpr double GoodBase = 0.2;

/// The rectangle around what touches the ground.
struct Base
{
  double area = 0.0; ///< world units
  double part = 0.0; ///< of the rectangle around all

  /// By parts, as what is large one way stands there on more. But a long body's flat end is a large part
  /// where it stands on that, and no reason not to stand on four feet.
  bool isClearlyBetterThan(const Base& other) const
  {
    return this->part > Clearly * other.part && !(other.part >= GoodBase && other.area > this->area);
  }
};

Base BaseOf(vtkPolyData* mesh, int up)
{
  const double* bounds = mesh->GetBounds();
  const double top = bounds[2 * up] + Ground * (bounds[2 * up + 1] - bounds[2 * up]);
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
  return { base.area(), all.area() > 0.0 ? base.area() / all.area() : 0.0 };
}

std::string FindUp(vtkPolyData* mesh, const std::string& file)
{
  std::string suffix = std::filesystem::path(file).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  const bool isObj = suffix == ".obj";
  const Base y = BaseOf(mesh, 1);
  const Base z = BaseOf(mesh, 2);
  return isObj ? (z.isClearlyBetterThan(y) ? "z" : "y") : (y.isClearlyBetterThan(z) ? "y" : "z");
}

/// The Sides that may be shown, the usual one first, and the top.
constexpr std::array<const char*, 5> Sides{ "front", "left", "right", "back", "top" };
constexpr std::size_t Top = 4;
using SideViews = std::array<InkOrientation, Sides.size()>;
using Areas = std::array<double, Sides.size()>;

SideViews SidesWithUp(const std::string& up)
{
  SideViews views;
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    views[i] = *InkOrientation::Find(Sides[i]);
    views[i].Stand(up);
  }
  return views;
}

/// For each of these views of a mesh the area of its polygons that face the viewer, as it is seen.
Areas SeenAreas(vtkPolyData* mesh, const SideViews& views)
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
      const double area = -0.5 * vtkMath::Dot(normal, views[i].Direction);
      areas[i] += area > 0.0 ? area : 0.0;
    }
  }
  return areas;
}

/// For each of these views the area of the rectangle around a box, as it is seen.
Areas SeenRectangles(const double b[6], const SideViews& views)
{
  Areas areas{};
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    double right[3];
    vtkMath::Cross(views[i].Direction, views[i].Up, right);
    Rectangle seen;
    for (int corner = 0; corner < 8; ++corner)
    {
      const double p[3] = { b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2)] };
      seen.add(vtkMath::Dot(p, right), vtkMath::Dot(p, views[i].Up));
    }
    areas[i] = seen.area();
  }
  return areas;
}

} // namespace

InkPose InkFindPose(vtkPolyData* mesh, const std::string& file, const std::string& up)
{
  InkPose pose;
  pose.Up = up.empty() ? FindUp(mesh, file) : up;
  const SideViews views = SidesWithUp(pose.Up);
  const Areas rectangles = SeenRectangles(mesh->GetBounds(), views);
  const Areas areas = InkHasPolygons(mesh) ? SeenAreas(mesh, views) : rectangles;
  std::size_t best = 0;
  for (std::size_t i = 1; i < Top; ++i)
  {
    best = areas[i] > Clearly * areas[best] ? i : best;
  }
  pose.View = Sides[best];
  pose.Elevation =
    rectangles[Top] > Flat * *std::max_element(rectangles.begin(), rectangles.begin() + Top) ? Raised : 0.0;
  return pose;
}

std::string InkFindSideOfFlat(const double bounds[6], const std::string& up)
{
  constexpr std::size_t front = 0;
  constexpr std::size_t left = 1;
  const Areas areas = SeenRectangles(bounds, SidesWithUp(up));
  if (!(std::max(areas[left], areas[Top]) > Flat * areas[front]))
  {
    return Sides[front];
  }
  // What stands upright as a picture needs no better reason.
  return Sides[areas[Top] > Clearly * areas[left] ? Top : left];
}
