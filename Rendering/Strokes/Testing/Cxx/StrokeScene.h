// SPDX-License-Identifier: BSD-3-Clause
#ifndef StrokeScene_h
#define StrokeScene_h

#include "InkTestScene.h"
#include "vtkInkStrokeMapper.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

/// Strokes with sizes in pixels.
class StrokeScene : public InkTestScene<vtkInkStrokeMapper>
{
public:
  explicit StrokeScene(vtkPolyData* data, int width = 200, int height = 200)
    : InkTestScene(data, width, height)
  {
    this->Mapper->SetSizeUnitToPixels();
  }

  /// A parallel view along -z in which x and y are pixels.
  void LookAtPixels()
  {
    const int* size = this->Window->GetSize();
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * size[1]);
    camera->SetFocalPoint(0.5 * size[0], 0.5 * size[1], 0.0);
    camera->SetPosition(0.5 * size[0], 0.5 * size[1], 1000.0);
    camera->SetClippingRange(1.0, 2000.0);
  }
};

using StrokePolyline = std::vector<std::array<double, 3>>;

/// One stroke for each polyline, closed where the last point is the first.
inline vtkSmartPointer<vtkPolyData> MakeStrokes(const std::vector<StrokePolyline>& polylines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const StrokePolyline& polyline : polylines)
  {
    const bool closed = polyline.size() > 3 && polyline.front() == polyline.back();
    const vtkIdType first = points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(polyline.size()));
    for (std::size_t i = 0; i < polyline.size(); ++i)
    {
      const bool repeats = closed && i + 1 == polyline.size();
      lines->InsertCellPoint(repeats ? first : points->InsertNextPoint(polyline[i].data()));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

/// A spiral around z from the origin, 100 in radius and 200 high.
inline StrokePolyline Spiral(double scale = 1.0, double shift = 0.0)
{
  StrokePolyline spiral;
  for (int i = 0; i <= 300; ++i)
  {
    const double angle = i * 6.0 * std::numbers::pi / 300.0;
    const double radius = i / 3.0;
    spiral.push_back({ scale * radius * std::cos(angle) + shift, scale * radius * std::sin(angle) + shift,
      scale * (i * 2.0 / 3.0 - 100.0) + shift });
  }
  return spiral;
}

/// From x = 20 to 180, with a point in the middle.
inline StrokePolyline HorizontalLine(double y, double z = 0.0)
{
  return { { 20.0, y, z }, { 100.0, y, z }, { 180.0, y, z } };
}

/// A square of x and y from 0 to 200, at a height that may differ between left and right.
inline void AddSurface(StrokeScene& scene, vtkActor* actor, double left, double right, double opacity = 1.0)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, left);
  plane->SetPoint1(200.0, 0.0, right);
  plane->SetPoint2(0.0, 200.0, left);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLighting(false);
  actor->GetProperty()->SetColor(0.9, 0.9, 0.9);
  actor->GetProperty()->SetOpacity(opacity);
  scene.Renderer->AddActor(actor);
}

inline vtkSmartPointer<vtkFloatArray> Values(const char* name, const std::vector<float>& values)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  for (const float value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

#endif
