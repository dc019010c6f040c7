// SPDX-License-Identifier: BSD-3-Clause
#ifndef StrokeScene_h
#define StrokeScene_h

#include "InkTestScene.h"
#include "vtkInkStrokeMapper.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <array>
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

#endif
