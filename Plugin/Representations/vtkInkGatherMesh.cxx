// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkGatherMesh.h"

#include "Core/ParallelSort.h"
#include "InkHasPolygons.h"
#include "InkStyleProcesses.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace
{

/// Those that are not empty, without other parts' cells.
std::vector<vtkSmartPointer<vtkPolyData>> TakeOwn(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  std::vector<vtkSmartPointer<vtkPolyData>> taken;
  for (const auto& part : parts)
  {
    if (part->GetNumberOfPoints() > 0)
    {
      taken.push_back(vtkSmartPointer<vtkPolyData>::New());
      taken.back()->ShallowCopy(part);
      taken.back()->RemoveGhostCells();
    }
  }
  return taken;
}

/// Positions and normals are the same up to rounding: sources that close around themselves, as ParaView's
/// sphere, give one piece 0 and another the sine of 2 pi.
constexpr double FloatRounding = 0x1p-22;
constexpr double DoubleRounding = 0x1p-44;
constexpr double NormalRounding = 0x1p-12;

/// For each point the first one at the same position with the same normal.
std::vector<vtkIdType> FindFirsts(vtkPolyData* mesh)
{
  using Identity = std::array<double, 6>;
  const double* bounds = mesh->GetBounds();
  const double farthest = std::abs(
    *std::max_element(bounds, bounds + 6, [](double a, double b) { return std::abs(a) < std::abs(b); }));
  const bool doubles = mesh->GetPoints()->GetDataType() == VTK_DOUBLE;
  const double step = farthest > 0.0 ? farthest * (doubles ? DoubleRounding : FloatRounding) : 1.0;
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  std::vector<std::pair<Identity, vtkIdType>> points;
  points.reserve(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    Identity identity{};
    mesh->GetPoint(point, identity.data());
    if (normals)
    {
      normals->GetTuple(point, identity.data() + 3);
    }
    for (std::size_t i = 0; i < identity.size(); ++i)
    {
      identity[i] = std::round(identity[i] / (i < 3 ? step : NormalRounding));
    }
    // What is not a number has no order.
    if (identity == identity)
    {
      points.emplace_back(identity, point);
    }
  }
  ink::parallelSort(points.begin(), points.end());
  std::vector<vtkIdType> firsts(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  std::iota(firsts.begin(), firsts.end(), vtkIdType(0));
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    if (points[i].first == points[i - 1].first)
    {
      firsts[static_cast<std::size_t>(points[i].second)] =
        firsts[static_cast<std::size_t>(points[i - 1].second)];
    }
  }
  return firsts;
}

vtkSmartPointer<vtkCellArray> Renumber(vtkCellArray* cells, const std::vector<vtkIdType>& numbers)
{
  auto renumbered = vtkSmartPointer<vtkCellArray>::New();
  renumbered->AllocateExact(cells->GetNumberOfCells(), cells->GetNumberOfConnectivityIds());
  vtkNew<vtkIdList> points;
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    cell->GetCurrentCell(points);
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      points->SetId(i, numbers[static_cast<std::size_t>(points->GetId(i))]);
    }
    renumbered->InsertNextCell(points);
  }
  return renumbered;
}

} // namespace

vtkSmartPointer<vtkPolyData> vtkInkGatherMesh(const std::vector<vtkSmartPointer<vtkPolyData>>& parts,
  vtkInkCommonPoints common, vtkMultiProcessController* controller)
{
  std::vector<vtkSmartPointer<vtkPolyData>> own = TakeOwn(parts);
  if (controller->GetNumberOfProcesses() > 1)
  {
    std::vector<vtkSmartPointer<vtkDataObject>> received;
    controller->Gather(own.empty() ? vtkSmartPointer<vtkPolyData>::New() : InkAppend(own), received, 0);
    own.clear();
    for (const auto& one : received)
    {
      auto mesh = vtkPolyData::SafeDownCast(one);
      if (mesh && mesh->GetNumberOfPoints() > 0)
      {
        own.emplace_back(mesh);
      }
    }
  }
  if (own.empty())
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  const vtkSmartPointer<vtkPolyData> mesh = own.size() == 1 ? own.front() : InkAppend(own);
  const bool hasFaces = InkHasPolygons(mesh);
  if (hasFaces && (common == vtkInkCommonPoints::All || mesh->GetPointData()->GetNormals()))
  {
    const std::vector<vtkIdType> firsts = FindFirsts(mesh);
    mesh->SetPolys(Renumber(mesh->GetPolys(), firsts));
    mesh->SetStrips(Renumber(mesh->GetStrips(), firsts));
  }
  return mesh;
}
