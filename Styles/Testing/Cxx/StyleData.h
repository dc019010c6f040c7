// SPDX-License-Identifier: BSD-3-Clause
#ifndef StyleData_h
#define StyleData_h

#include "vtkImageData.h"
#include "vtkInkStyle.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

/// A ball of values up to 200 in the middle.
inline vtkSmartPointer<vtkImageData> MakeBall(int side = 16)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  vtkNew<vtkUnsignedCharArray> values;
  values->SetName("density");
  const double middle = (side - 1) / 2.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double r = std::hypot(p[0] - middle, p[1] - middle, p[2] - middle) / side;
    values->InsertNextValue(static_cast<unsigned char>(std::max(0.0, 200.0 * (1.0 - 2.0 * r))));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

inline vtkSmartPointer<vtkPolyData> MakeMesh()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(30);
  sphere->Update();
  return sphere->GetOutput();
}

inline vtkSmartPointer<vtkPolyData> MakeCloud()
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(MakeMesh()->GetPoints());
  return cloud;
}

inline vtkIdType CountOf(vtkInkStyle* style)
{
  return style->GetPiece(0)->GetNumberOfPoints();
}

/// The coordinates of all pieces.
inline std::vector<double> MarksOf(vtkInkStyle* style)
{
  std::vector<double> marks;
  for (int piece = 0; piece < style->GetNumberOfPieces(); ++piece)
  {
    for (vtkIdType i = 0; i < style->GetPiece(piece)->GetNumberOfPoints(); ++i)
    {
      const double* p = style->GetPiece(piece)->GetPoint(i);
      marks.insert(marks.end(), p, p + 3);
    }
  }
  return marks;
}

/// Lets a style make few marks, where a test is not of their number.
inline void MakeFewMarks(vtkInkStyle* style, int count = 2000)
{
  const std::map<std::string, int> few = { { "LineSpacing", 16 }, { "NumberOfSamples", count },
    { "NumberOfSurfaceStipples", count }, { "Subdivision", 1 } };
  for (int i = 0; i < style->GetNumberOfParameters(); ++i)
  {
    const auto found = few.find(style->GetParameterName(i));
    if (found != few.end())
    {
      style->SetParameter(found->first.c_str(), found->second);
    }
  }
}

#endif
