// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestMesh_h
#define InkTestMesh_h

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <limits>

/// A square, three more triangles on one of its edges, one without area, one with a point that is not finite,
/// one twice.
inline vtkSmartPointer<vtkPolyData> InkTestOddMesh(double scale)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const std::array<double, 3>& p : { std::array{ 0.0, 0.0, 0.0 }, std::array{ 1.0, 0.0, 0.0 },
         std::array{ 1.0, 1.0, 0.0 }, std::array{ 0.0, 1.0, 0.0 }, std::array{ 0.5, 0.0, 1.0 },
         std::array{ 0.5, 0.5, -1.0 }, std::array{ 2.0, 0.0, 0.0 } })
  {
    points->InsertNextPoint(scale * p[0], scale * p[1], scale * p[2]);
  }
  const vtkIdType missing = points->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2, 3 });
  polygons->InsertNextCell({ 0, 1, 4 });
  polygons->InsertNextCell({ 1, 0, 5 });
  polygons->InsertNextCell({ 0, 1, 4 });
  polygons->InsertNextCell({ 0, 1, 6 });
  polygons->InsertNextCell({ 0, 0, 1 });
  polygons->InsertNextCell({ 0, 1, missing });
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  return mesh;
}

/// What filters say of that mesh.
inline constexpr const char* InkTestOddFaces =
  "1 of 7 faces have points that are not finite; expected finite coordinates";

/// The same with no face that has finite points only.
inline vtkSmartPointer<vtkPolyData> InkTestNotFiniteMesh()
{
  const vtkSmartPointer<vtkPolyData> mesh = InkTestOddMesh(1.0);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    mesh->GetPoints()->SetPoint(i, 0.0, std::numeric_limits<double>::infinity(), 0.0);
  }
  return mesh;
}

inline constexpr const char* InkTestNotFiniteFaces =
  "all of its 7 faces have points that are not finite; expected finite coordinates";

#endif
