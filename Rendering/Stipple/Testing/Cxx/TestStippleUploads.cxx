// SPDX-License-Identifier: BSD-3-Clause
// What is sent to the GPU, and when: stipples once to each window, colors when what makes them changes, and
// nothing for a slider.
#include "InkTestImage.h"
#include "InkTestStipples.h"
#include "StippleScene.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace
{

/// Voxels with the scalars 0 to 1 from left to right.
vtkSmartPointer<vtkPolyData> Voxels()
{
  auto voxels = InkTestStipples::SphereVoxels(1.0, 0.1, 8);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("Height");
  for (vtkIdType i = 0; i < voxels->GetNumberOfCells(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(0.5 + 0.5 * voxels->GetPoint(8 * i)[0]));
  }
  voxels->GetCellData()->SetScalars(scalars);
  return voxels;
}

} // namespace

TEST(StippleUploads, Colors)
{
  auto voxels = Voxels();
  vtkDataArray* scalars = voxels->GetCellData()->GetScalars();
  StippleScene scene(voxels);
  vtkInkStippleMapper* mapper = scene.Mapper;
  vtkNew<vtkLookupTable> table;
  table->Build();
  mapper->SetLookupTable(table);
  const InkTestImage plain(scene.Window);
  const vtkMTimeType stipples = mapper->GetUploadTime();
  EXPECT_TRUE(stipples > 0 && mapper->GetColorUploadTime() == 0) << "stipples without colors";

  const struct
  {
    const char* Name;
    bool Colors;
    std::function<void()> Make;
  } changes[] = {
    { "colors switched on", true, [&] { mapper->ScalarVisibilityOn(); } },
    { "no change", false, [] {} },
    { "a slider", false, [&] { mapper->SetBoundaryGain(2.0); } },
    { "another slider", false, [&] { mapper->SetStippleSize(3.0); } },
    { "the mapper modified", false, [&] { mapper->Modified(); } },
    { "the camera", false, [&] { scene.Renderer->GetActiveCamera()->Azimuth(10.0); } },
    { "another range", true, [&] { mapper->SetScalarRange(0.2, 0.8); } },
    { "another table", true,
      [&]
      {
        table->SetHueRange(0.1, 0.4);
        table->ForceBuild();
      } },
    { "other scalars", true,
      [&]
      {
        scalars->SetComponent(0, 0, 0.9);
        scalars->Modified();
      } },
    { "colors switched off", false, [&] { mapper->ScalarVisibilityOff(); } },
    { "a slider without colors", false, [&] { mapper->SetBoundaryGain(1.0); } },
    { "another ink", false, [&] { mapper->SetInkColor(0.2, 0.0, 0.0); } },
  };
  vtkMTimeType colors = 0;
  for (const auto& [name, sent, make] : changes)
  {
    make();
    scene.Window->Render();
    EXPECT_EQ(mapper->GetUploadTime(), stipples) << "no stipples sent for " << name;
    EXPECT_EQ((mapper->GetColorUploadTime() > colors), sent)
      << (sent ? "colors" : "no colors") << " sent for " << name;
    colors = mapper->GetColorUploadTime();
  }
}

/// The colors that are sent later stand where those do that are sent with the stipples.
TEST(StippleUploads, Order)
{
  auto voxels = Voxels();
  StippleScene later(voxels);
  later.Window->Render();
  later.Mapper->ScalarVisibilityOn();
  StippleScene once(voxels);
  once.Mapper->ScalarVisibilityOn();
  const InkTestImage expected(once.Window);
  EXPECT_EQ(InkTestImage(later.Window).CountDifferent(expected), 0) << "the same colors later";
  int blue = 0;
  int red = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      const int redder = expected.Channel(x, y, 0) - expected.Channel(x, y, 2);
      red += x < 60 ? redder > 60 : redder < -60 && x < 100;
      blue += x > 140 ? redder < -60 : redder > 60 && x > 100;
    }
  }
  EXPECT_TRUE(red > 100 && blue > 100) << "red to the left, blue to the right, found " << red << ", " << blue;
}

/// Scalars' opacities act: none for those that are to be clear, half the ink for half.
TEST(StippleUploads, Alpha)
{
  auto plane = InkTestStipples::PlaneSurface(2.0, 10, 16);
  vtkNew<vtkFloatArray> scalars;
  for (vtkIdType i = 0; i < plane->GetNumberOfCells(); ++i)
  {
    scalars->InsertNextValue(i % 10 < 5 ? 0.0f : 1.0f);
  }
  plane->GetCellData()->SetScalars(scalars);
  for (const bool bySize : { false, true })
  {
    StippleScene scene(plane);
    scene.AllOff();
    scene.Mapper->SetFadeBySize(bySize);
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(2);
    scene.Mapper->SetLookupTable(table);
    scene.Mapper->SetScalarRange(0.0, 1.0);
    scene.Mapper->ScalarVisibilityOn();
    const auto halves = [&](double left, double right)
    {
      table->SetTableValue(0, 0.0, 0.0, 0.0, left);
      table->SetTableValue(1, 0.0, 0.0, 0.0, right);
      const InkTestImage image(scene.Window);
      std::array<double, 2> ink{};
      for (int y = 0; y < 200; ++y)
      {
        for (int x = 0; x < 200; ++x)
        {
          // Dots on the border reach into the other half.
          ink[x >= 100] += std::abs(x - 100) > 3 ? 1.0 - image.Gray(x, y) / 255.0 : 0.0;
        }
      }
      return ink;
    };
    const auto full = halves(1.0, 1.0);
    const auto part = halves(0.0, 0.5);
    EXPECT_TRUE(full[0] > 500.0 && part[0] == 0.0) << "clear stipples, ink " << part[0];
    EXPECT_TRUE(part[1] / full[1] > 0.48 && part[1] / full[1] < 0.56)
      << "half the ink, found " << part[1] / full[1];
    vtkNew<vtkFloatArray> marks;
    scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks);
    double range[2];
    marks->GetRange(range, 1);
    EXPECT_TRUE(range[0] == 0.0 && std::abs(range[1] - 0.5) < 0.01)
      << "opacities up to a half, found " << range[1];
  }
}

/// One mapper in two windows: the stipples go to each once, whatever the order of pictures.
TEST(StippleUploads, TwoWindows)
{
  StippleScene scene(Voxels());
  vtkInkStippleMapper* mapper = scene.Mapper;
  mapper->ScalarVisibilityOn();
  mapper->SetSurfaceData(
    []
    {
      vtkNew<vtkSphereSource> sphere;
      sphere->SetRadius(0.9);
      sphere->Update();
      return vtkSmartPointer<vtkPolyData>(sphere->GetOutput());
    }());
  const InkTestImage first(scene.Window);
  vtkMTimeType both = 0;
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1.0, 1.0, 1.0);
    renderer->AddActor(scene.Actor);
    vtkNew<vtkRenderWindow> other;
    other->SetOffScreenRendering(true);
    other->SetMultiSamples(0);
    other->SetSize(200, 200);
    other->AddRenderer(renderer);
    renderer->ResetCamera();
    EXPECT_EQ(InkTestImage(other).CountDifferent(first), 0) << "the same picture in another window";
    both = mapper->GetUploadTime();
    const vtkMTimeType colors = mapper->GetColorUploadTime();
    for (int picture = 0; picture < 3; ++picture)
    {
      EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0) << "the first window's picture again";
      EXPECT_EQ(InkTestImage(other).CountDifferent(first), 0) << "the other window's picture again";
    }
    EXPECT_TRUE(mapper->GetUploadTime() == both && mapper->GetColorUploadTime() == colors)
      << "nothing sent again";
  }
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0) << "the picture without the other window";

  // Another input and back: each window has what belongs to the picture.
  auto input = vtkSmartPointer<vtkPolyData>(mapper->GetInput());
  mapper->SetInputData(InkTestStipples::SphereVoxels(0.5, 0.1, 4));
  EXPECT_GT(InkTestImage(scene.Window).CountDifferent(first), 100) << "another input's picture";
  mapper->SetInputData(input);
  EXPECT_EQ(InkTestImage(scene.Window).CountDifferent(first), 0) << "the first input's picture again";
}

/// To give the same surface again, as ParaView does before each picture, changes nothing.
TEST(StippleUploads, SameSurface)
{
  StippleScene scene(Voxels());
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkPolyData> other;
  other->DeepCopy(sphere->GetOutput());
  const auto modifies = [&](vtkPolyData* surface)
  {
    const vtkMTimeType before = scene.Mapper->GetMTime();
    scene.Mapper->SetSurfaceData(surface);
    return scene.Mapper->GetMTime() > before;
  };
  EXPECT_FALSE(modifies(nullptr)) << "no change from none to none";
  EXPECT_TRUE(modifies(other)) << "a surface is a change";
  EXPECT_FALSE(modifies(other)) << "the same surface is none";
  EXPECT_TRUE(modifies(sphere->GetOutput())) << "another surface is a change";
  EXPECT_TRUE(modifies(nullptr)) << "none is a change";
  // A filter's output given as data must not run the filter any more.
  scene.Mapper->SetSurfaceConnection(sphere->GetOutputPort());
  EXPECT_TRUE(modifies(sphere->GetOutput())) << "data instead of a connection is a change";
}
