// SPDX-License-Identifier: BSD-3-Clause
// Hatching from mesh to picture at the extremes: sizes and origins, strokes of very many and of hardly any
// points, meshes that are tiny, flat, broken or of one triangle. The picture shows whether it is right.

#include "InkTestScene.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkInkHatching.h"
#include "vtkInkLinesOfCurvature.h"
#include "vtkInkStrokeMapper.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace
{

constexpr int Size = 200;
constexpr double NoNumber = std::numeric_limits<double>::quiet_NaN();

/// A torus around z, of outer radius `scale`, at x = y = z = `origin`.
vtkSmartPointer<vtkPolyData> Torus(double scale, double origin)
{
  constexpr int rings = 72;
  constexpr int sides = 36;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (int i = 0; i < rings; ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const double u = 2.0 * std::numbers::pi * i / rings;
      const double v = 2.0 * std::numbers::pi * j / sides;
      const double r = 0.7 + 0.3 * std::cos(v);
      points->InsertNextPoint(origin + scale * r * std::cos(u), origin + scale * r * std::sin(u),
        origin + scale * 0.3 * std::sin(v));
      const vtkIdType a = i * sides + j;
      const vtkIdType b = i * sides + (j + 1) % sides;
      const vtkIdType c = (i + 1) % rings * sides + j;
      const vtkIdType d = (i + 1) % rings * sides + (j + 1) % sides;
      triangles->InsertNextCell({ a, c, b });
      triangles->InsertNextCell({ b, c, d });
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

/// Darkness of the picture, in black pixels.
double InkOf(vtkRenderWindow* window)
{
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int* size = window->GetSize();
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  double ink = 0.0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    ink += 1.0 - pixels->GetComponent(i, 0) / 255.0;
  }
  return ink;
}

/// The hatching of a mesh that fills the picture, and the ink of it.
double Hatch(vtkPolyData* mesh)
{
  vtkNew<vtkInkLinesOfCurvature> lines;
  lines->SetInputData(mesh);
  lines->SetFamiliesToBoth();
  lines->CombDirectionsOn();
  vtkNew<vtkInkHatching> hatching;
  hatching->SetInputConnection(lines->GetOutputPort());
  hatching->SetSurfaceData(mesh);
  hatching->Update();
  vtkPolyData* strokes = hatching->GetOutput();
  if (strokes->GetNumberOfLines() == 0)
  {
    return 0.0;
  }
  for (vtkIdType i = 0; i < strokes->GetNumberOfPoints(); ++i)
  {
    double p[3];
    strokes->GetPoint(i, p);
    EXPECT_TRUE(std::isfinite(p[0] + p[1] + p[2])) << "point " << i;
  }
  InkTestScene<vtkInkStrokeMapper> scene(strokes, Size, Size);
  scene.Mapper->SetSurfaceData(mesh);
  scene.Mapper->HatchingOn();
  scene.Mapper->SetCullingCosine(1.0);
  scene.Mapper->SetSizeUnitToPixels();
  scene.Mapper->SetHatchSpacing(4.0);
  scene.Mapper->SetLineWidth(0.6);
  return InkOf(scene.Window);
}

/// The ink of strokes with flat ends, whose coordinates are pixels.
double DrawStrokes(vtkPoints* points, vtkCellArray* lines, double width)
{
  vtkNew<vtkPolyData> strokes;
  strokes->SetPoints(points);
  strokes->SetLines(lines);
  InkTestScene<vtkInkStrokeMapper> scene(strokes, Size, Size);
  scene.Mapper->SetSizeUnitToPixels();
  scene.Mapper->SetLineWidth(width);
  scene.Mapper->SetCapToButt();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * Size);
  camera->SetFocalPoint(0.5 * Size, 0.5 * Size, 0.0);
  camera->SetPosition(0.5 * Size, 0.5 * Size, 1000.0);
  camera->SetClippingRange(1.0, 2000.0);
  return InkOf(scene.Window);
}

} // namespace

/// The same picture of a torus of any size, and far from the origin.
TEST(HatchingExtremes, SizesAndOrigins)
{
  const double usual = Hatch(Torus(1.0, 0.0));
  ASSERT_GT(usual, 500.0);
  for (const double scale : { 1e-9, 1e-3, 1e9 })
  {
    EXPECT_NEAR(Hatch(Torus(scale, 0.0)) / usual, 1.0, 0.03) << "scale " << scale;
  }
  EXPECT_NEAR(Hatch(Torus(1.0, 1e7)) / usual, 1.0, 0.06) << "at 1e7";
}

/// A mesh with points that are no numbers, with faces of no area and faces twice is hatched as without them.
TEST(HatchingExtremes, BrokenMeshes)
{
  const double usual = Hatch(Torus(1.0, 0.0));
  const vtkSmartPointer<vtkPolyData> bad = Torus(1.0, 0.0);
  const vtkIdType lost = bad->GetPoints()->InsertNextPoint(NoNumber, 0.0, 0.0);
  vtkNew<vtkCellArray> faces;
  faces->DeepCopy(bad->GetPolys());
  faces->InsertNextCell({ 0, 1, lost });
  faces->InsertNextCell({ 0, 0, 1 });
  faces->InsertNextCell({ 5, 6, 5 });
  bad->SetPolys(faces);
  EXPECT_NEAR(Hatch(bad) / usual, 1.0, 0.05);
}

/// Meshes that list each triangle twice, or both sides of it, with the same points or with others, are
/// hatched as those that list it once.
TEST(HatchingExtremes, TrianglesTwice)
{
  const vtkSmartPointer<vtkPolyData> once = Torus(1.0, 0.0);
  const double usual = Hatch(once);
  for (const bool reversed : { false, true })
  {
    for (const bool ownPoints : { false, true })
    {
      vtkNew<vtkPoints> points;
      points->DeepCopy(once->GetPoints());
      const vtkIdType offset = ownPoints ? once->GetNumberOfPoints() : 0;
      points->InsertPoints(offset, once->GetNumberOfPoints(), 0, once->GetPoints());
      vtkNew<vtkCellArray> faces;
      faces->DeepCopy(once->GetPolys());
      for (vtkIdType face = 0; face < once->GetNumberOfPolys(); ++face)
      {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        once->GetPolys()->GetCellAtId(face, size, corners);
        faces->InsertNextCell(
          { corners[reversed ? 2 : 0] + offset, corners[1] + offset, corners[reversed ? 0 : 2] + offset });
      }
      vtkNew<vtkPolyData> twice;
      twice->SetPoints(points);
      twice->SetPolys(faces);
      EXPECT_NEAR(Hatch(twice) / usual, 1.0, 0.05) << "reversed " << reversed << ", own points " << ownPoints;
    }
  }
}

/// Surfaces of hardly any faces have strokes, too.
TEST(HatchingExtremes, FewFaces)
{
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToIcosahedron();
  solid->Update();
  EXPECT_GT(Hatch(solid->GetOutput()), 400.0) << "20 triangles";
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.2);
  points->InsertNextPoint(0.0, 1.0, 0.4);
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> one;
  one->SetPoints(points);
  one->SetPolys(faces);
  Hatch(one); // has no direction of its own, and must end
}

/// One stroke of a million points is about as one of two: its edges are darker, as thousands of segments
/// share a pixel there.
TEST(HatchingExtremes, StrokeOfManyPoints)
{
  constexpr int count = 1000000;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(count);
  for (int i = 0; i < count; ++i)
  {
    points->SetPoint(i, 10.0 + 180.0 * i / (count - 1), 100.25, 0.0);
    lines->InsertCellPoint(i);
  }
  EXPECT_NEAR(DrawStrokes(points, lines, 6.0) / (180.0 * 6.0), 1.0, 0.2);
}

/// A hundred thousand strokes of two points, of which every tenth has no length and every tenth is nowhere.
TEST(HatchingExtremes, ManyShortStrokes)
{
  constexpr int rows = 100;
  constexpr int columns = 1000;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (int i = 0; i < rows * columns; ++i)
  {
    const double x = 0.2 * (i % columns);
    const double y = 2.0 * (i / columns) + 0.5; // NOLINT(bugprone-integer-division)
    const double length = i % 10 == 3 ? 0.0 : 0.2;
    const vtkIdType first = points->InsertNextPoint(i % 10 == 7 ? NoNumber : x, y, 0.0);
    points->InsertNextPoint(x + length, y, 0.0);
    lines->InsertNextCell({ first, first + 1 });
  }
  // A pixel wide, on the middle of every other row of pixels. The parts of a pixel that strokes cover are
  // blended one over the other, so what four fifths of it come to is less where strokes are shorter than a
  // pixel.
  const double share = DrawStrokes(points, lines, 1.0) / (0.5 * Size * Size);
  EXPECT_LE(share, 0.8);
  EXPECT_GE(share, 1.0 - std::pow(0.8, 4));
}
