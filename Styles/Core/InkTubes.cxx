// SPDX-License-Identifier: BSD-3-Clause
#include "InkTubes.h"

#include "InkDiscStipples.h"
#include "InkHasPolygons.h"
#include "InkSourcePoints.h"

#include "Core/FiniteBox.h"
#include "Core/FormatNumber.h"
#include "Core/KeyNumbers.h"
#include "Core/WeldedPoints.h"
#include "Curves/ChainSegments.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkTubeFilter.h"
#include "vtksys/SystemTools.hxx"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{

constexpr double RadiusInDiagonals = 0.003;
/// Round as they are drawn, if they are few.
constexpr int Sides = 16;
constexpr int SidesOfMany = 6;
constexpr std::size_t Many = 100'000; ///< segments

/// The cosine of the angle between two segments of a line from which on it turns back, where a tube around it
/// has no direction.
constexpr double Backwards = -0.999;

/// What lines are made of, as the filter of tubes wants them.
class LineSegments
{
public:
  explicit LineSegments(vtkPolyData* lines)
    : Given(lines)
    , Box(ink::finiteBox(static_cast<std::size_t>(lines->GetNumberOfPoints()),
        [this](std::size_t i) { return this->At(static_cast<vtkIdType>(i)); }))
    , Welded(this->MakeRelative())
    // Lines that have values of their own stay apart.
    , KeepsLines(lines->GetCellData()->GetNumberOfArrays() > 0)
    , Nodes(static_cast<std::size_t>(lines->GetLines()->GetNumberOfConnectivityIds()))
    , Known(static_cast<std::size_t>(lines->GetLines()->GetNumberOfConnectivityIds()))
  {
    const auto line = vtk::TakeSmartPointer(lines->GetLines()->NewIterator());
    for (line->GoToFirstCell(); !line->IsDoneWithTraversal(); line->GoToNextCell())
    {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      line->GetCurrentCell(count, points);
      for (vtkIdType i = 1; i < count; ++i)
      {
        this->Add(points[i - 1], points[i], line->GetCurrentCellId());
      }
    }
  }

  const std::vector<ink::Segment>& Get() const { return this->Segments; }
  const std::vector<vtkIdType>& GetPoints() const { return this->Points; }

  double GetDiagonal() const
  {
    const ink::FiniteBox used =
      ink::finiteBox(this->Points.size(), [this](std::size_t i) { return this->At(this->Points[i]); });
    return used.isEmpty() ? 0.0 : glm::length(used.high - used.low);
  }

  /// Joined to lines that turn back nowhere, with the values of their points, and of their cells.
  vtkSmartPointer<vtkPolyData> Join() const
  {
    auto joined = vtkSmartPointer<vtkPolyData>::New();
    joined->SetPoints(this->Given->GetPoints());
    joined->GetPointData()->ShallowCopy(this->Given->GetPointData());
    // They need not be at right angles to the lines.
    joined->GetPointData()->SetActiveNormals(nullptr);
    InkSetSourcePoints(joined, this->Given, {});
    vtkNew<vtkCellArray> cells;
    vtkCellData* values = joined->GetCellData();
    values->CopyAllocate(this->Given->GetCellData());
    const ink::Chains chains = ink::chainSegments(this->Segments, this->Points.size());
    for (std::size_t chain = 0; chain < chains.polylines.size(); ++chain)
    {
      const std::size_t begin = chains.polylines.offsets[chain];
      std::vector<vtkIdType> points;
      for (std::size_t i = begin; i < chains.polylines.offsets[chain + 1]; ++i)
      {
        points.push_back(this->Points[chains.nodes[i]]);
      }
      if (chains.polylines.closed[chain] != 0)
      {
        points.push_back(points.front());
      }
      const vtkIdType source = this->Given->GetNumberOfVerts() + this->LineOf[chains.segments[begin]];
      for (std::size_t first = 0; first + 1 < points.size();)
      {
        std::size_t last = first + 1;
        for (; last + 1 < points.size() && !this->TurnsBack(&points[last]); ++last)
        {
        }
        values->CopyData(this->Given->GetCellData(), source, cells->GetNumberOfCells());
        cells->InsertNextCell(static_cast<vtkIdType>(last - first + 1), &points[first]);
        first = last;
      }
    }
    joined->SetLines(cells);
    return joined;
  }

private:
  glm::dvec3 At(vtkIdType point) const
  {
    glm::dvec3 p;
    this->Given->GetPoint(point, &p.x);
    return p;
  }

  std::vector<glm::vec3> MakeRelative() const
  {
    std::vector<glm::vec3> positions(static_cast<std::size_t>(this->Given->GetNumberOfPoints()));
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      positions[i] = glm::vec3(this->At(static_cast<vtkIdType>(i)) - this->Box.low);
    }
    return positions;
  }

  /// Not what has no length, or is there already.
  void Add(vtkIdType from, vtkIdType to, vtkIdType line)
  {
    const std::uint32_t a = this->Welded.of[static_cast<std::size_t>(from)];
    const std::uint32_t b = this->Welded.of[static_cast<std::size_t>(to)];
    if (a == b || a == ink::WeldedPoints::none || b == ink::WeldedPoints::none)
    {
      return;
    }
    if (this->Known.numberOf(Key(std::min(a, b), std::max(a, b))) == this->Segments.size())
    {
      this->Segments.push_back({ this->NodeOf(a, from, line), this->NodeOf(b, to, line) });
      this->LineOf.push_back(line);
    }
  }

  std::uint32_t NodeOf(std::uint32_t position, vtkIdType point, vtkIdType line)
  {
    const std::uint32_t node = this->Nodes.numberOf(Key(this->KeepsLines ? line : 0, position));
    if (node == this->Points.size())
    {
      this->Points.push_back(point);
    }
    return node;
  }

  static std::uint64_t Key(vtkIdType first, std::uint32_t second)
  {
    return static_cast<std::uint64_t>(first) << 32 | second;
  }

  bool TurnsBack(const vtkIdType* point) const
  {
    const glm::dvec3 before = this->At(point[0]) - this->At(point[-1]);
    const glm::dvec3 after = this->At(point[1]) - this->At(point[0]);
    return glm::dot(before, after) <= Backwards * glm::length(before) * glm::length(after);
  }

  vtkPolyData* Given;
  ink::FiniteBox Box;
  ink::WeldedPoints Welded;
  bool KeepsLines;
  ink::KeyNumbers Nodes;              ///< by line, if lines are kept, and position
  ink::KeyNumbers Known;              ///< segments, by their positions
  std::vector<ink::Segment> Segments; ///< of nodes
  std::vector<vtkIdType> LineOf;      ///< of each segment
  std::vector<vtkIdType> Points;      ///< of each node
};

/// The name of the array that says how thick lines are; empty: none does.
std::string FindRadius(vtkPointData* values, const std::vector<vtkIdType>& points)
{
  for (int i = 0; i < values->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = values->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if ((name != "MaximumInscribedSphereRadius" && vtksys::SystemTools::LowerCase(name) != "radius") ||
      array->GetNumberOfComponents() != 1)
    {
      continue;
    }
    double most = 0.0;
    bool isRadius = true;
    for (const vtkIdType point : points)
    {
      const double radius = array->GetComponent(point, 0);
      isRadius = isRadius && std::isfinite(radius) && radius >= 0.0;
      most = std::max(most, radius);
    }
    if (isRadius && most > 0.0)
    {
      return name;
    }
  }
  return {};
}

} // namespace

bool InkIsOfLines(vtkPolyData* mesh)
{
  return mesh->GetNumberOfLines() > 0 && !InkHasPolygons(mesh) && !InkHasDiscs(mesh);
}

vtkSmartPointer<vtkPolyData> InkMakeTubes(vtkPolyData* lines, std::string& note)
{
  const LineSegments segments(lines);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(segments.Join());
  tubes->SetNumberOfSides(segments.Get().size() > Many ? SidesOfMany : Sides);
  tubes->CappingOn();
  const std::string array = FindRadius(lines->GetPointData(), segments.GetPoints());
  const double radius = RadiusInDiagonals * segments.GetDiagonal();
  if (array.empty())
  {
    tubes->SetRadius(radius);
    note = "there are no polygons, but lines; they are drawn as tubes of radius " + ink::formatNumber(radius);
  }
  else
  {
    tubes->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
    tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
    note = "there are no polygons, but lines; they are drawn as tubes, whose radius is the array " + array;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(tubes->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  auto made = vtkSmartPointer<vtkPolyData>::New();
  if (!segments.Get().empty())
  {
    triangles->Update();
    made->ShallowCopy(triangles->GetOutput());
  }
  if (!InkHasPolygons(made))
  {
    made->Initialize();
    note = "nothing to draw: the lines have no length";
  }
  return made;
}
