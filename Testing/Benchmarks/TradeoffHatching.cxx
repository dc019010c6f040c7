// SPDX-License-Identifier: BSD-3-Clause
// Hatching: how close the lines are from which strokes are taken, against the error of the gray that the
// strokes of a picture make of them, and against the time to trace them.

#include "Tradeoff.h"

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

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

constexpr int Size = 400;
constexpr double Drawn = 6.0; // pixels between strokes in the picture
constexpr double Tone = 0.4;
constexpr int Windows = 8; // in which grays are measured, a row

/// Hills on a square from -1 to 1, seen from above.
vtkSmartPointer<vtkPolyData> Hills()
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
vtkSmartPointer<vtkPolyData> Strokes(vtkPolyData* hills, double share, bool local = true)
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

/// The root mean square of the relative errors of the windows' grays, in percent.
double ErrorOf(vtkPolyData* strokes, double height)
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
  mapper->SetDarkestTone(Tone);
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
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->SetParallelScale(0.5 * height);
  camera->SetClippingRange(5.0, 15.0);
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, Size - 1, Size - 1, 0, pixels);
  constexpr int side = Size / Windows;
  double sum = 0.0;
  for (int n = 0; n < Windows * Windows; ++n)
  {
    double ink = 0.0;
    for (int i = 0; i < side * side; ++i)
    {
      const int x = n % Windows * side + i % side;
      const int y = n / Windows * side + i / side;
      ink += 1.0 - pixels->GetComponent(y * Size + x, 0) / 255.0;
    }
    sum += std::pow(ink / (side * side) / Tone - 1.0, 2);
  }
  return 100.0 * std::sqrt(sum / (Windows * Windows));
}

} // namespace

int main()
{
  Tradeoff::PrintHeader();
  const vtkSmartPointer<vtkPolyData> hills = Hills();
  Tradeoff knob("LineSpacing (style line-art)",
    "Keep the default, lines as close as strokes are drawn; closer ones serve whoever comes nearer.",
    "root mean square of the relative error of grays in windows of 50 x 50 pixels, %",
    "lines of a family on 28,800 triangles, strokes 6 pixels apart in a picture of 400 x 400");
  for (const double share : { 4.0, 2.0, 1.0, 0.5, 0.25 })
  {
    const vtkSmartPointer<vtkPolyData> strokes = Strokes(hills, share);
    std::string name = std::to_string(share);
    name.erase(name.find_last_not_of('0') + 1);
    name.erase(name.find_last_not_of('.') + 1);
    knob.Add(
      name + " of the distance drawn", [=] { Strokes(hills, share); },
      { { "as far as meant", ErrorOf(strokes, 2.0) }, { "twice as near", ErrorOf(strokes, 1.0) },
        { "four times as near", ErrorOf(strokes, 0.5) } },
      share == 1.0 ? Tradeoff::Default : Tradeoff::Choice);
  }
  knob.Print(3);
  Tradeoff spacing("LocalSpacing (vtkInkHatching)",
    "Keep it on: real lines are closer here and wider there, and without it grays are, too.",
    "root mean square of the relative error of grays in windows of 50 x 50 pixels, %",
    "lines of a family on 28,800 triangles and their strokes, 6 pixels apart in a picture of 400 x 400");
  for (const bool local : { false, true })
  {
    const vtkSmartPointer<vtkPolyData> strokes = Strokes(hills, 1.0, local);
    spacing.Add(
      local ? "on" : "off, as published", [=] { Strokes(hills, 1.0, local); },
      { { "as far as meant", ErrorOf(strokes, 2.0) }, { "twice as near", ErrorOf(strokes, 1.0) },
        { "four times as near", ErrorOf(strokes, 0.5) } },
      local ? Tradeoff::Default : Tradeoff::Choice);
  }
  spacing.Print(3);
  return EXIT_SUCCESS;
}
