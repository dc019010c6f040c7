// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestWeldedBox_h
#define InkTestWeldedBox_h

#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <cmath>

/// A source's polygons, without its normals, with one point at each position.
inline vtkSmartPointer<vtkPolyData> InkTestWelded(vtkPolyDataAlgorithm* source)
{
  source->Update();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(source->GetOutput()->GetPoints());
  bare->SetPolys(source->GetOutput()->GetPolys());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(bare);
  clean->Update();
  return clean->GetOutput();
}

/// Eight points, six quads, a value at each point.
inline vtkSmartPointer<vtkPolyData> InkTestWeldedBox()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(3.0);
  cube->SetYLength(2.0);
  vtkSmartPointer<vtkPolyData> box = InkTestWelded(cube);
  vtkNew<vtkDoubleArray> heat;
  heat->SetName("Heat");
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    heat->InsertNextValue(box->GetPoint(i)[0]);
  }
  box->GetPointData()->SetScalars(heat);
  return box;
}

/// Normals at the corners of a box that are the means of three faces.
inline void InkTestAddMeanNormals(vtkPolyData* box)
{
  vtkNew<vtkDoubleArray> means;
  means->SetName("Normals");
  means->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    double p[3];
    box->GetPoint(i, p);
    const double length = std::sqrt(3.0);
    means->InsertNextTuple3(std::copysign(1.0, p[0]) / length, std::copysign(1.0, p[1]) / length,
      std::copysign(1.0, p[2]) / length);
  }
  box->GetPointData()->SetNormals(means);
}

#endif
