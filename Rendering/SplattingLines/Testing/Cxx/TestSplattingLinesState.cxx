// SPDX-License-Identifier: BSD-3-Clause
// What is drawn around splatting lines does not notice them: actors before and after, backgrounds.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "InkOpenGLCompat.h"

#include "vtkCameraPass.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDepthPeelingPass.h"
#include "vtkIdList.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

/// Points and translucent triangles, which depend on blending, culling, the depth test and point sizes.
class Bystanders
{
public:
  Bystanders()
  {
    auto sphere = InkTestPoints::Sphere(0.4, 0.1, { 1.5, 0.0, 0.0 });
    vtkNew<vtkCellArray> vertices;
    vtkNew<vtkCellArray> triangles;
    for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
    {
      vertices->InsertNextCell(1, &i);
      const vtkIdType corners[3] = { i, (i + 5) % sphere->GetNumberOfPoints(),
        (i + 13) % sphere->GetNumberOfPoints() };
      triangles->InsertNextCell(3, corners);
    }
    vtkNew<vtkPolyData> dots;
    dots->SetPoints(sphere->GetPoints());
    dots->SetVerts(vertices);
    vtkNew<vtkPolyDataMapper> dotMapper;
    dotMapper->SetInputData(dots);
    this->Dots->SetMapper(dotMapper);
    this->Dots->GetProperty()->SetPointSize(5.0);
    this->Dots->GetProperty()->SetColor(1.0, 0.0, 0.0);

    vtkNew<vtkPolyData> shards;
    shards->SetPoints(sphere->GetPoints());
    shards->SetPolys(triangles);
    vtkNew<vtkPolyDataMapper> shardMapper;
    shardMapper->SetInputData(shards);
    this->Shards->SetMapper(shardMapper);
    this->Shards->GetProperty()->SetOpacity(0.4);
    this->Shards->GetProperty()->SetColor(0.0, 0.0, 1.0);
    this->Shards->GetProperty()->EdgeVisibilityOn();
  }
  vtkNew<vtkActor> Dots;
  vtkNew<vtkActor> Shards;
};

int CountDifferentRightOf(const InkTestImage& a, const InkTestImage& b, int left)
{
  int different = 0;
  for (int y = 0; y < a.GetHeight(); ++y)
  {
    for (int x = left; x < a.GetWidth(); ++x)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        different += a.Channel(x, y, channel) != b.Channel(x, y, channel);
      }
    }
  }
  return different;
}

/// Counts how often something happens.
class Counter : public vtkCommand
{
public:
  static Counter* New() { return new Counter; }
  void Execute(vtkObject*, unsigned long, void*) override { ++this->Count; }
  int Count = 0;
};

/// How often the mapper is drawn in a picture: once for each peel, and once before.
int CountPeels(SplattingLinesScene& scene)
{
  vtkNew<Counter> counter;
  const unsigned long tag = scene.Mapper->AddObserver(vtkCommand::StartEvent, counter);
  scene.Window->Render();
  scene.Mapper->RemoveObserver(tag);
  return counter->Count;
}

int CountGLErrors()
{
  int errors = 0;
  while (glGetError() != GL_NO_ERROR)
  {
    ++errors;
  }
  return errors;
}

} // namespace

TEST(SplattingLinesState, Bystanders)
{
  for (bool paper : { true, false })
  {
    for (bool peeling : { false, true })
    {
      SplattingLinesScene scene(InkTestPoints::Sphere(1.0, 0.05, { -1.0, 0.0, 0.0 }), 400, 200);
      Bystanders bystanders;
      scene.Mapper->SetPaperVisibility(paper);
      scene.Renderer->SetUseDepthPeeling(peeling);
      scene.Renderer->RemoveActor(scene.Actor);
      scene.Renderer->AddActor(bystanders.Dots);
      scene.Renderer->AddActor(scene.Actor);
      scene.Renderer->AddActor(bystanders.Shards);
      vtkNew<vtkActor> after;
      after->ShallowCopy(bystanders.Dots);
      after->SetPosition(0.0, 0.5, 0.0);
      scene.Renderer->AddActor(after);
      scene.Renderer->ResetCamera();
      const InkTestImage with(scene.Window);
      scene.Actor->VisibilityOff();
      const InkTestImage without(scene.Window);
      EXPECT_GT(with.CountDifferent(without), 100) << "lines";
      const int different = CountDifferentRightOf(with, without, 240);
      EXPECT_EQ(different, 0) << "bystanders as without lines" << (paper ? "" : " (no paper)")
                              << (peeling ? " (depth peeling): " : ": ") << different << " values differ";
    }
  }
}

TEST(SplattingLinesState, Backgrounds)
{
  for (bool paper : { true, false })
  {
    SplattingLinesScene scene(InkTestPoints::Sphere(1.0, 0.05));
    scene.Mapper->SetPaperVisibility(paper);
    scene.Renderer->GradientBackgroundOn();
    scene.Renderer->SetBackground2(1.0, 0.0, 0.0);
    const InkTestImage with(scene.Window);
    scene.Actor->VisibilityOff();
    const InkTestImage without(scene.Window);
    int different = 0;
    for (int i = 0; i < 200; ++i)
    {
      different += with.Channel(i, 5, 1) != without.Channel(i, 5, 1);
      different += with.Channel(5, i, 1) != without.Channel(5, i, 1);
      different += !paper && with.Channel(100, 60 + i % 80, 1) != without.Channel(100, 60 + i % 80, 1);
    }
    EXPECT_EQ(different, 0) << "a gradient background, " << different << " pixels differ";
  }
}

/// Alpha is 1 where there is paper and 0 elsewhere, for pictures with a transparent background. (What
/// translucent actors, and so ink without paper, add to alpha is VTK's choice: it differs between versions.)
TEST(SplattingLinesState, TransparentBackground)
{
  for (bool paper : { true, false })
  {
    SplattingLinesScene scene(InkTestPoints::Sphere(1.0, 0.05));
    scene.Mapper->SetPaperVisibility(paper);
    scene.Window->AlphaBitPlanesOn();
    scene.Renderer->SetBackgroundAlpha(0.0);
    scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    const InkTestImage image(scene.Window, 1, true);
    EXPECT_EQ(image.Channel(2, 2, 3), 0) << "a transparent background";
    EXPECT_EQ(image.Channel(100, 100, 3), (paper ? 255 : 0))
      << "alpha within the contour, " << image.Channel(100, 100, 3);
  }
}

/// Depth peeling counts the pixels that each peel adds. The splats, which are drawn when the view has
/// changed, are none of them. OpenGL has one such query at a time; the layers end where there are no more all
/// the same.
TEST(SplattingLinesState, Peeling)
{
  for (bool dual : { true, false })
  {
    auto points = InkTestPoints::Join(InkTestPoints::Sphere(1.0, 0.05), InkTestPoints::Sphere(0.5, 0.05));
    SplattingLinesScene scene(points);
    scene.Mapper->PaperVisibilityOff();
    scene.Mapper->HiddenLayersOn();
    scene.Mapper->SetNumberOfLayers(5);
    scene.Window->AlphaBitPlanesOn();
    Bystanders bystanders;
    scene.Renderer->AddActor(bystanders.Shards);
    scene.Renderer->UseDepthPeelingOn();
    scene.Renderer->SetMaximumNumberOfPeels(100);
    scene.Renderer->SetOcclusionRatio(0.0);
    vtkNew<vtkDepthPeelingPass> peeling;
    if (!dual)
    {
      vtkNew<vtkCameraPass> camera;
      vtkNew<vtkSequencePass> sequence;
      vtkNew<vtkRenderPassCollection> passes;
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkOpaquePass> opaque;
      vtkNew<vtkTranslucentPass> translucent;
      peeling->SetTranslucentPass(translucent);
      peeling->SetMaximumNumberOfPeels(100);
      peeling->SetOcclusionRatio(0.0);
      passes->AddItem(lights);
      passes->AddItem(opaque);
      passes->AddItem(peeling);
      sequence->SetPasses(passes);
      camera->SetDelegatePass(sequence);
      scene.Renderer->SetPass(camera);
    }
    scene.Window->Render();
    CountGLErrors();
    scene.Renderer->GetActiveCamera()->Azimuth(5.0);
    const int first = CountPeels(scene);
    const int layers = scene.Mapper->GetNumberOfDrawnLayers(scene.Renderer, scene.Actor);
    const int again = CountPeels(scene);
    const char* const how = dual ? " with dual depth peeling" : " with depth peeling";
    EXPECT_TRUE(again > 2 && first == again)
      << "as many peels" << how << " for a new view as for the same again: " << first << ", " << again;
    EXPECT_EQ(layers, 2) << "two layers" << how << ", found " << layers;
    EXPECT_EQ(CountGLErrors(), 0) << "no error of OpenGL" << how;
  }
}
