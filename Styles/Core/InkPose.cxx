// SPDX-License-Identifier: BSD-3-Clause
#include "InkPose.h"

#include "InkHasPolygons.h"
#include "InkOrientation.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <vector>

namespace
{

/// By how much another axis or side has to be better than the usual one.
constexpr double Clearly = 1.25;

/// How much larger than that of any side the rectangle is that the top of what lies flat fills, and from how
/// many degrees above it is shown.
constexpr double Flat = 2.0;
constexpr double Raised = 30.0;

/// From which part of what is seen on it is one flat face, which is a silhouette of one tone, and how many
/// degrees the viewer goes to the right and upwards then.
constexpr double OneFace = 0.9;
constexpr double ObliqueAzimuth = 30.0;
constexpr double ObliqueElevation = 20.0;

/// How many times its size what a map locates is from the origin: surveys have their coordinates in meters
/// from a meridian and the equator, say, and z is the height.
constexpr double FarAway = 100.0;

/// How many times as long as it is wide and high what is not seen along its length is: in perspective its
/// near end would hide the rest.
constexpr double Long = 3.0;

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

/// The part of what lies over it that a base is at least for standing on it well, and for standing on it at
/// all: the lowest branches of a tree that lies are .02, the smallest of 17 bases of meshes with y up .045.
constexpr double GoodBase = 0.2;
constexpr double LeastBase = 0.03;

/// The rectangle around what touches the ground.
struct Base
{
  double area = 0.0; ///< world units
  double part = 0.0; ///< of the rectangle around all

  /// By parts, as what is large one way stands there on more. But a long body's flat end is a large part
  /// where it stands on that, and no reason not to stand on four feet.
  bool isClearlyBetterThan(const Base& other) const
  {
    return this->part > LeastBase && this->part > Clearly * other.part &&
      !(other.part >= GoodBase && other.area > this->area);
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

bool HasMapCoordinates(vtkPolyData* mesh)
{
  const double* b = mesh->GetBounds();
  const double size = std::max({ b[1] - b[0], b[3] - b[2], b[5] - b[4] });
  const auto middle = [b](int axis) { return std::abs(0.5 * (b[2 * axis] + b[2 * axis + 1])); };
  return std::min(middle(0), middle(1)) > FarAway * size && middle(2) < FarAway * size;
}

std::string FindUp(vtkPolyData* mesh, const std::string& file)
{
  const std::string suffix = vtksys::SystemTools::LowerCase(std::filesystem::path(file).extension().string());
  if (suffix == ".gii" || HasMapCoordinates(mesh))
  {
    return "z";
  }
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

/// What is seen of a mesh from a side.
struct Seen
{
  double Front = 0.0; ///< the area of polygons that face the viewer and are not hidden
  double Back = 0.0;  ///< of those that face away
  double Flat = 0.0;  ///< the part of what is seen that is at right angles to the view
};

/// Of how many cells the longer side of a small picture has, in which is found what is seen.
constexpr int Cells = 200;

/// The least cosine of the angle between what is seen as flat and the view.
constexpr double FlatCosine = 0.985;

/// A small picture of a mesh from one side: in each cell how much the nearest triangle faces the viewer.
class SmallPicture
{
public:
  SmallPicture(const InkOrientation& view, vtkPolyData* mesh)
    : View(view)
  {
    vtkMath::Cross(view.Direction, view.Up, this->Right);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const std::array<double, 3> p = this->Project(mesh->GetPoint(i));
      if (std::isfinite(p[0] + p[1] + p[2]))
      {
        this->All.add(p[0], p[1]);
      }
    }
    const double side = std::max(this->All.high[0] - this->All.low[0], this->All.high[1] - this->All.low[1]);
    this->Cell = side > 0.0 && std::isfinite(side) ? side / Cells : 0.0;
    if (this->Cell > 0.0)
    {
      this->Depths.assign(std::size_t{ Cells } * Cells, HUGE_VAL);
      this->Facing.assign(this->Depths.size(), 0.0);
    }
  }

  /// @param normal of any length
  void Draw(const double corners[3][3], const double normal[3])
  {
    const double length = vtkMath::Norm(normal);
    if (this->Cell == 0.0 || !(length > 0.0) || !std::isfinite(length))
    {
      return;
    }
    std::array<std::array<double, 3>, 3> p; // in cells, and in depth
    Rectangle box;
    for (std::size_t i = 0; i < 3; ++i)
    {
      p[i] = this->Project(corners[i]);
      p[i][0] = (p[i][0] - this->All.low[0]) / this->Cell;
      p[i][1] = (p[i][1] - this->All.low[1]) / this->Cell;
      box.add(p[i][0], p[i][1]);
    }
    const auto cross = [](const auto& a, const auto& b, double x, double y)
    { return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]); };
    const double area = cross(p[0], p[1], p[2][0], p[2][1]);
    const double facing = -vtkMath::Dot(normal, this->View.Direction) / length;
    for (int row = FirstCell(box.low[1]); row < EndCell(box.high[1]); ++row)
    {
      for (int column = FirstCell(box.low[0]); column < EndCell(box.high[0]); ++column)
      {
        const double x = column + 0.5;
        const double y = row + 0.5;
        const double a = cross(p[1], p[2], x, y) / area;
        const double b = cross(p[2], p[0], x, y) / area;
        const double depth = a * p[0][2] + b * p[1][2] + (1.0 - a - b) * p[2][2];
        const auto cell = static_cast<std::size_t>(row * Cells + column);
        // False for what is seen edge-on, which has no area.
        if (a >= 0.0 && b >= 0.0 && a + b <= 1.0 && depth < this->Depths[cell])
        {
          this->Depths[cell] = depth;
          this->Facing[cell] = facing;
        }
      }
    }
  }

  Seen Find() const
  {
    const auto count = [this](auto condition)
    { return static_cast<double>(std::count_if(this->Facing.begin(), this->Facing.end(), condition)); };
    const double front = count([](double facing) { return facing > 0.0; });
    const double back = count([](double facing) { return facing < 0.0; });
    const double flat = count([](double facing) { return std::abs(facing) > FlatCosine; });
    const double area = this->Cell * this->Cell;
    return { area * front, area * back, front + back > 0.0 ? flat / (front + back) : 0.0 };
  }

private:
  static int FirstCell(double low) { return std::max(static_cast<int>(std::ceil(low - 0.5)), 0); }
  static int EndCell(double high) { return std::min(static_cast<int>(std::floor(high + 0.5)), Cells); }

  std::array<double, 3> Project(const double p[3]) const
  {
    return { vtkMath::Dot(p, this->Right), vtkMath::Dot(p, this->View.Up),
      vtkMath::Dot(p, this->View.Direction) };
  }

  InkOrientation View;
  double Right[3];
  Rectangle All;
  double Cell = 0.0; ///< world units
  std::vector<double> Depths;
  std::vector<double> Facing; ///< cosines
};

std::array<Seen, Sides.size()> FindSeen(vtkPolyData* mesh, const SideViews& views)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* made = triangles->GetOutput();
  std::vector<SmallPicture> pictures;
  for (const InkOrientation& view : views)
  {
    pictures.emplace_back(view, mesh);
  }
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
    double sides[2][3];
    vtkMath::Subtract(p[1], p[0], sides[0]);
    vtkMath::Subtract(p[2], p[0], sides[1]);
    double normal[3];
    vtkMath::Cross(sides[0], sides[1], normal);
    for (SmallPicture& picture : pictures)
    {
      picture.Draw(p, normal);
    }
  }
  std::array<Seen, Sides.size()> seen;
  std::transform(pictures.begin(), pictures.end(), seen.begin(),
    [](const SmallPicture& picture) { return picture.Find(); });
  return seen;
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

bool IsSeenAlongItsLength(const double b[6], const InkOrientation& view)
{
  const double size[3] = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
  double across = 0.0;
  double along = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    double& longest = view.Direction[axis] != 0.0 ? along : across;
    longest = std::max(longest, size[axis]);
  }
  return along > Long * across;
}

} // namespace

InkPose InkFindPose(vtkPolyData* mesh, const std::string& file, const std::string& up)
{
  InkPose pose;
  pose.Up = up.empty() ? FindUp(mesh, file) : up;
  const SideViews views = SidesWithUp(pose.Up);
  const Areas rectangles = SeenRectangles(mesh->GetBounds(), views);
  Areas areas = rectangles;
  std::array<Seen, Sides.size()> seen;
  if (InkHasPolygons(mesh))
  {
    seen = FindSeen(mesh, views);
    // Polygons of a file may run either way round; most that is seen is their outside.
    const double outside = std::accumulate(seen.begin(), seen.end(), 0.0,
      [](double sum, const Seen& side) { return sum + side.Front - side.Back; });
    std::transform(seen.begin(), seen.end(), areas.begin(),
      [outside](const Seen& side) { return outside >= 0.0 ? side.Front : side.Back; });
  }
  const auto isAlong = [&](std::size_t i) { return IsSeenAlongItsLength(mesh->GetBounds(), views[i]); };
  std::size_t best = isAlong(0) ? 1 : 0;
  for (std::size_t i = best + 1; i < Top; ++i)
  {
    best = areas[i] > Clearly * areas[best] && !isAlong(i) ? i : best;
  }
  pose.View = Sides[best];
  const bool liesFlat =
    rectangles[Top] > Flat * *std::max_element(rectangles.begin(), rectangles.begin() + Top);
  if (liesFlat || (up.empty() && HasMapCoordinates(mesh)))
  {
    pose.Elevation = Raised;
  }
  else if (seen[best].Flat > OneFace)
  {
    pose.Azimuth = ObliqueAzimuth;
    pose.Elevation = ObliqueElevation;
  }
  return pose;
}

std::string InkFindSideOfFlat(const double bounds[6], const std::string& up, double times)
{
  constexpr std::size_t front = 0;
  constexpr std::size_t left = 1;
  const Areas areas = SeenRectangles(bounds, SidesWithUp(up));
  if (!(std::max(areas[left], areas[Top]) > times * areas[front]))
  {
    return Sides[front];
  }
  // What stands upright as a picture needs no better reason.
  return Sides[areas[Top] > Clearly * areas[left] ? Top : left];
}
