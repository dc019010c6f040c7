// SPDX-License-Identifier: BSD-3-Clause
// Points with normals for splatting lines: as many as one likes, with lines all over.
#ifndef BumpySphere_h
#define BumpySphere_h

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>

/// Points with normals, all of one radius.
struct Splats
{
  vtkSmartPointer<vtkPolyData> Points;
  double Radius = 0.0;
};

/// Evenly spread over a sphere with waves of a few percent.
inline Splats BumpySphere(vtkIdType count)
{
  Splats splats{ vtkSmartPointer<vtkPolyData>::New(),
    std::sqrt(4.0 * vtkMath::Pi() / static_cast<double>(count)) };
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  constexpr double waves = 9.0;
  constexpr double height = 0.03;
  const double turn = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  for (vtkIdType i = 0; i < count; ++i)
  {
    // A spiral by the golden angle.
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
    const double r = std::sqrt(1.0 - z * z);
    const double angle = std::fmod(turn * static_cast<double>(i), 2.0 * vtkMath::Pi());
    const double p[3] = { r * std::cos(angle), r * std::sin(angle), z };
    // The surface |x| = 1 + height times the product of the waves; its gradient is the normal's direction.
    double sines[3];
    double slopes[3];
    for (int c = 0; c < 3; ++c)
    {
      sines[c] = std::sin(waves * p[c]);
      slopes[c] = -height * waves * std::cos(waves * p[c]);
    }
    const double size = 1.0 + height * sines[0] * sines[1] * sines[2];
    const double tangent[3] = { slopes[0] * sines[1] * sines[2], slopes[1] * sines[0] * sines[2],
      slopes[2] * sines[0] * sines[1] };
    const double outward = vtkMath::Dot(tangent, p);
    double normal[3];
    for (int c = 0; c < 3; ++c)
    {
      normal[c] = p[c] + (tangent[c] - outward * p[c]) / size;
    }
    vtkMath::Normalize(normal);
    points->SetPoint(i, size * p[0], size * p[1], size * p[2]);
    normals->SetTuple(i, normal);
  }
  splats.Points->SetPoints(points);
  splats.Points->GetPointData()->SetNormals(normals);
  return splats;
}

#endif
