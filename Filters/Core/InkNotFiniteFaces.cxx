// SPDX-License-Identifier: BSD-3-Clause
#include "InkNotFiniteFaces.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkObject.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

struct FaceCount
{
  vtkIdType NotFinite = 0;
  vtkIdType All = 0;
};

FaceCount CountFaces(vtkPolyData* mesh)
{
  FaceCount count{ 0, mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() };
  std::vector<bool> notFinite(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  bool any = false;
  for (std::size_t i = 0; i < notFinite.size(); ++i)
  {
    double p[3];
    mesh->GetPoint(static_cast<vtkIdType>(i), p);
    notFinite[i] = !std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]);
    any = any || notFinite[i];
  }
  for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    const auto faces = vtk::TakeSmartPointer(cells->NewIterator());
    for (faces->GoToFirstCell(); any && !faces->IsDoneWithTraversal(); faces->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      faces->GetCurrentCell(size, points);
      count.NotFinite += std::any_of(points, points + size,
        [&](vtkIdType point) {
          return point >= 0 && point < mesh->GetNumberOfPoints() &&
            notFinite[static_cast<std::size_t>(point)];
        });
    }
  }
  return count;
}

} // namespace

void InkWarnOfNotFiniteFaces(vtkObject* filter, vtkPolyData* mesh)
{
  const FaceCount count = CountFaces(mesh);
  if (count.NotFinite > 0 && count.NotFinite < count.All)
  {
    vtkWarningWithObjectMacro(filter, << count.NotFinite << " of " << count.All
                                      << " faces have points that are not finite; expected finite "
                                         "coordinates. They are left out.");
  }
}

std::string InkDescribeNoFiniteFace(vtkPolyData* mesh)
{
  const FaceCount count = CountFaces(mesh);
  return count.All > 0 && count.NotFinite == count.All ? "all of its " + std::to_string(count.All) +
      " faces have points that are not finite; expected finite coordinates"
                                                       : std::string();
}
