// SPDX-License-Identifier: BSD-3-Clause
// vtkInkStippleMapper and odd data that vtkInkStippleGenerator makes of volumes and meshes: the right
// picture, or an empty one; with positions in either precision.
#include "InkTestMesh.h"
#include "InkTestStipples.h"
#include "StippleInk.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInkStippleGenerator.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace
{

using namespace StippleInk;

/// What the generator makes of a ball that fills most of n voxels a side.
Data StippleBall(int type, const std::array<int, 3>& n, const std::function<void(vtkImageData*)>& change)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(n.data());
  image->AllocateScalars(type, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkSmartPointer<vtkDataArray> range = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  const bool integer = type != VTK_FLOAT && type != VTK_DOUBLE;
  // Doubles just within a 64-bit integer's range.
  const double low = integer ? range->GetDataTypeMin() * (1.0 - 1e-15) : 0.0;
  const double high = integer ? range->GetDataTypeMax() * (1.0 - 1e-15) : 1.0;
  vtkIdType id = 0;
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        const auto coordinate = [](int index, int count)
        { return count > 1 ? (2.0 * index + 1.0) / count - 1.0 : 0.0; };
        const double r = std::hypot(coordinate(i, n[0]), coordinate(j, n[1]), coordinate(k, n[2]));
        const double share = std::clamp(0.5 + 6.0 * (0.75 - r), 0.0, 1.0);
        scalars->SetComponent(id++, 0, (1.0 - share) * low + share * high);
      }
    }
  }
  change(image);
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(image);
  generator->SetGradientPercentile(80.0);
  generator->Update();
  return generator->GetOutput();
}

Data StippleBall()
{
  return StippleBall(VTK_FLOAT, { 24, 24, 24 }, [](vtkImageData*) {});
}

InkTestImage Draw(
  const Data& data, const Change& change = [](StippleScene&) {})
{
  StippleScene scene(data, 120, 120);
  change(scene);
  return InkTestImage(scene.Window);
}

class StippleMapperExtremes : public StippleInk::Test
{
};

} // namespace

TEST_F(StippleMapperExtremes, Geometry)
{
  const double usual = FindInk("ball", StippleBall());
  EXPECT_TRUE(usual > 350.0 && usual < 500.0) << "ink of a ball, found " << usual;
  const auto expect =
    [&](const std::string& name, const std::function<void(vtkImageData*)>& change, const Change& view)
  {
    const Data data = StippleBall(VTK_FLOAT, { 24, 24, 24 }, change);
    ExpectInk(name, data, 0.95 * usual, 1.05 * usual, view);
  };
  const Change front = [](StippleScene&) {};
  const Change side = [](StippleScene& scene)
  {
    scene.Renderer->GetActiveCamera()->SetPosition(1.0, 0.0, 0.0);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    scene.Renderer->ResetCamera();
  };
  for (const double size : { 1e-9, 1e9 })
  {
    const auto scale = [&](vtkImageData* image) { image->SetSpacing(size, size, size); };
    expect("spacing " + std::to_string(size), scale, front);
    expect("spacing " + std::to_string(size) + " from the side", scale, side);
  }
  const auto far = [](vtkImageData* image)
  {
    image->SetOrigin(1e7, -1e7, 1e7);
    image->SetSpacing(0.01, 0.01, 0.01);
  };
  expect("far away", far, front);
  const auto turned = [](vtkImageData* image)
  { image->SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0); };
  expect("a turned image", turned, front);
  const auto mirrored = [](vtkImageData* image)
  { image->SetDirectionMatrix(-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0); };
  expect("a mirrored image", mirrored, front);

  // A needle as thin as a pixel, seen from the side or along it.
  for (const int axis : { 0, 1, 2 })
  {
    const auto stretch = [&](vtkImageData* image)
    {
      double spacing[3] = { 1.0, 1.0, 1.0 };
      spacing[axis] = 1000.0;
      image->SetSpacing(spacing);
    };
    const Data data = StippleBall(VTK_FLOAT, { 24, 24, 24 }, stretch);
    const std::string name = "spacing of 1000 along " + std::to_string(axis);
    // A thin line, whose pixels are too pale to show until there are many stipples.
    const Change dark[] = { [](StippleScene& scene) { scene.Mapper->SetPixelsPerStipple(0.1); },
      [&](StippleScene& scene)
      {
        side(scene);
        scene.Mapper->SetPixelsPerStipple(0.1);
      } };
    // Seen along it, it is less than a pixel.
    ExpectPale(name, data, axis == 2 ? 0.031 : 3.5, dark[0]);
    ExpectPale(name + " from the side", data, axis == 0 ? 0.031 : 3.5, dark[1]);
  }
}

TEST_F(StippleMapperExtremes, Values)
{
  const Data ball = StippleBall();
  const double usual = FindInk("ball", ball);
  // The ball is symmetric: of its many voxels of one gradient, rounding chooses which are steep enough.
  const auto whole = [](int type) { return StippleBall(type, { 24, 24, 24 }, [](vtkImageData*) {}); };
  const Data doubles = whole(VTK_DOUBLE);
  ExpectInk("doubles", doubles, 0.994 * usual, 1.006 * usual);
  const InkTestImage exact = Draw(doubles);
  for (const int type : { VTK_INT, VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG })
  {
    EXPECT_EQ(Draw(whole(type)).CountDifferent(exact), 0)
      << "the same picture of " << vtkImageScalarTypeNameMacro(type);
  }
  // Steps of values turn normals a little: measured .016% and .065%, .71% and .63% of the ink.
  const double ink = exact.Ink();
  for (const int type : { VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR })
  {
    const double part = type == VTK_SHORT || type == VTK_UNSIGNED_SHORT ? 0.0013 : 0.014;
    ExpectInk(std::string("the whole range of ") + vtkImageScalarTypeNameMacro(type), whole(type),
      (1.0 - part) * ink, (1.0 + part) * ink);
  }
  const auto spoil = [](vtkImageData* image)
  {
    for (vtkIdType n = 0; n < image->GetNumberOfPoints(); n += 17)
    {
      image->GetPointData()->GetScalars()->SetComponent(n, 0, n % 3 ? NaN : Infinity);
    }
  };
  // Of what is left the same share is stippled, and none of the holes is.
  const Data holes = StippleBall(VTK_FLOAT, { 24, 24, 24 }, spoil);
  ExpectInk("holes", holes, 0.92 * usual, 0.933 * usual);
  EXPECT_NEAR(static_cast<double>(holes->GetNumberOfCells()),
    16.0 / 17.0 * static_cast<double>(ball->GetNumberOfCells()), 12.0)
    << "stippled voxels";
  for (vtkIdType e = 0; e < holes->GetNumberOfCells(); ++e)
  {
    const double* value = holes->GetCellData()->GetArray("Value")->GetTuple(e);
    ASSERT_TRUE(value[0] >= 0.0 && value[0] <= 1.0) << "the value of a stippled voxel, " << value[0];
  }
}

TEST_F(StippleMapperExtremes, Shapes)
{
  const auto nothing = [](vtkImageData*) {};
  const Data one = StippleBall(VTK_FLOAT, { 1, 1, 1 }, nothing);
  ExpectInk("one voxel", one, 0.0, 0.0);
  const auto even = [](vtkImageData* image) { image->GetPointData()->GetScalars()->Fill(7.0); };
  ExpectInk("a constant", StippleBall(VTK_FLOAT, { 12, 12, 12 }, even), 0.0, 0.0);
  ExpectInk("no cells", vtkSmartPointer<vtkPolyData>::New(), 0.0, 0.0);
  const Data flat = StippleBall(VTK_FLOAT, { 40, 40, 1 }, nothing);
  // Normals lie in the plane and away from an eye before its middle: not lit.
  const auto unlit = [](StippleScene& scene) { scene.Mapper->LightingOff(); };
  ExpectAbout("one voxel thick", flat, 100.0, unlit);
  // All normals are seen edge-on; without a view of its plane it is a line.
  const auto edge = [](StippleScene& scene)
  {
    scene.Renderer->GetActiveCamera()->SetPosition(0.0, -300.0, 0.0);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    scene.Renderer->ResetCamera();
  };
  ExpectAbout("one voxel thick, from the edge", flat, 33.0, edge);
  const Data row = StippleBall(VTK_FLOAT, { 60, 1, 1 }, nothing);
  ExpectAbout("a row of voxels", row, 3.7, unlit);

  const auto close = [](StippleScene& scene)
  {
    scene.AllOff();
    scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 5.0);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    scene.Renderer->ResetCameraClippingRange(-1, 1, -1, 1, -1, 1);
  };
  ExpectAbout("one stipple", InkTestStipples::PlaneSurface(1.0, 1, 1), 1575.0, close);
  ExpectAbout("one element", InkTestStipples::PlaneSurface(1.0, 1, 64), 1460.0, close);

  // Half of the elements without stipples: half of the plane.
  const Data plane = InkTestStipples::PlaneSurface(2.0, 10, 12);
  const double whole = FindInk("plane", plane, [](StippleScene& scene) { scene.AllOff(); });
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkPoints> points;
  for (vtkIdType e = 0; e < plane->GetNumberOfCells(); ++e)
  {
    cells->InsertNextCell(e % 10 < 5 ? 12 : 0);
    for (vtkIdType i = 12 * e; e % 10 < 5 && i < 12 * (e + 1); ++i)
    {
      cells->InsertCellPoint(points->InsertNextPoint(plane->GetPoint(i)));
    }
  }
  Data half = vtkSmartPointer<vtkPolyData>::New();
  half->DeepCopy(plane);
  half->SetPoints(points);
  half->SetVerts(cells);
  const Change same = [](StippleScene& scene)
  {
    scene.AllOff();
    scene.Renderer->ResetCamera(-1.0, 1.0, -1.0, 1.0, 0.0, 0.0);
  };
  ExpectInk("elements without stipples", half, 0.49 * whole, 0.515 * whole, same);
  // But for dots that reach across the middle, the picture of the plane on the one side and paper on the
  // other.
  const InkTestImage all = Draw(plane, same);
  const InkTestImage left = Draw(half, same);
  constexpr int middle = 60;
  constexpr int reach = 4;
  for (int y = 0; y < 120; ++y)
  {
    for (int x = 0; x < middle - reach; ++x)
    {
      ASSERT_EQ(left.Gray(x, y), all.Gray(x, y)) << x << ", " << y;
    }
  }
  EXPECT_EQ(left.CountDark(middle + reach, 0, 120, 120, 255), 0);
}

/// Meshes through the generator: degenerate, non-manifold, of all sizes.
TEST_F(StippleMapperExtremes, Meshes)
{
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    const vtkSmartPointer<vtkPolyData> mesh = InkTestOddMesh(scale);
    vtkNew<vtkInkStippleGenerator> generator;
    generator->SetInputData(mesh);
    generator->SetNumberOfSurfaceStipples(4000);
    generator->Update();
    const auto connect = [&](StippleScene& scene)
    {
      // Hidden by the mesh as well.
      scene.Mapper->SetInputConnection(generator->GetOutputPort());
      scene.Mapper->LightingOff();
    };
    ExpectAbout("a mesh of size " + std::to_string(scale), generator->GetOutput(), 1785.0, connect);
  }
}
