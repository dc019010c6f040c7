// SPDX-License-Identifier: BSD-3-Clause
// Gray of hatching on a surface with real lines of curvature, which are closer here and wider there.
#ifndef HatchedHills_h
#define HatchedHills_h

#include "vtkInkHatching.h"
#include "vtkInkLinesOfCurvature.h"
#include "vtkInkStrokeMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace HatchedHills
{

constexpr int Size = 400;     // pixels of a picture
constexpr double Drawn = 6.0; // pixels between strokes in it
constexpr int Side = 50; // pixels of windows that hold eight lines at the distance that they are made for

/// Hills on a square from -1 to 1, to be seen from above.
inline vtkSmartPointer<vtkPolyData> MakeHills()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0, -1.0, 0.0);
  plane->SetPoint1(1.0, -1.0, 0.0);
  plane->SetPoint2(-1.0, 1.0, 0.0);
  plane->SetResolution(120, 120);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  vtkSmartPointer<vtkPolyData> hills = triangles->GetOutput();
  hills->GetPointData()->Initialize();
  for (vtkIdType i = 0; i < hills->GetNumberOfPoints(); ++i)
  {
    double p[3];
    hills->GetPoint(i, p);
    hills->GetPoints()->SetPoint(i, p[0], p[1], 0.1 * std::sin(3.0 * p[0]) * std::cos(2.0 * p[1]));
  }
  return hills;
}

/// @param share the distance of the lines, of that of strokes in the picture
inline vtkSmartPointer<vtkPolyData> MakeStrokes(vtkPolyData* hills, double share, bool local = true)
{
  vtkNew<vtkInkLinesOfCurvature> lines;
  lines->SetInputData(hills);
  lines->CombDirectionsOn();
  lines->SetSpacing(share * Drawn * 2.0 / Size);
  vtkNew<vtkInkHatching> hatching;
  hatching->SetInputConnection(lines->GetOutputPort());
  hatching->SetSurfaceData(hills);
  hatching->SetLocalSpacing(local);
  hatching->Update();
  return hatching->GetOutput();
}

/// Of the grays of windows, relative to the tone that is wanted.
struct GrayErrors
{
  double RootMeanSquare;
  double Largest;
};

/// Over all of the hills.
/// @param zoom of the pictures, which are next to each other
/// @param side of windows, pixels
inline GrayErrors ErrorsOf(vtkPolyData* strokes, double tone, int zoom, int side)
{
  vtkNew<vtkInkStrokeMapper> mapper;
  mapper->SetInputData(strokes);
  mapper->HatchingOn();
  mapper->SetSizeUnitToPixels();
  mapper->SetHatchSpacing(Drawn);
  mapper->SetLineWidth(0.6);
  mapper->SetCrosshatching(0.0);
  mapper->SetSilhouetteWeight(0.0);
  mapper->SetDiffuseTruncation(0.0);
  mapper->SetDarkestTone(tone);
  mapper->SetCullingCosine(1.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AutomaticLightCreationOff(); // all is in the deepest shadow
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(Size, Size);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0 / zoom);
  camera->SetClippingRange(5.0, 15.0);
  const int windows = Size / side;
  GrayErrors errors{ 0.0, 0.0 };
  for (int view = 0; view < zoom * zoom; ++view)
  {
    const double x0 = (2 * (view % zoom) + 1.0) / zoom - 1.0;
    const double y0 = (2 * (view / zoom) + 1.0) / zoom - 1.0;
    camera->SetPosition(x0, y0, 10.0);
    camera->SetFocalPoint(x0, y0, 0.0);
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetPixelData(0, 0, Size - 1, Size - 1, 0, pixels);
    for (int n = 0; n < windows * windows; ++n)
    {
      double ink = 0.0;
      for (int i = 0; i < side * side; ++i)
      {
        const int x = n % windows * side + i % side;
        const int y = n / windows * side + i / side;
        ink += 1.0 - pixels->GetComponent(y * Size + x, 0) / 255.0;
      }
      const double error = ink / (side * side) / tone - 1.0;
      errors.RootMeanSquare += error * error;
      errors.Largest = std::max(errors.Largest, std::abs(error));
    }
  }
  errors.RootMeanSquare = std::sqrt(errors.RootMeanSquare / (windows * windows * zoom * zoom));
  return errors;
}

} // namespace HatchedHills

#endif
