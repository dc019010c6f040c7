// SPDX-License-Identifier: BSD-3-Clause
// What is drawn around splatting lines does not notice them: actors before and after, backgrounds.
#include "InkTestChecks.h"
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

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

void TestBystanders(InkTestChecks& check)
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
      check(with.CountDifferent(without) > 100, "lines");
      const int different = CountDifferentRightOf(with, without, 240);
      check(different == 0, "bystanders as without lines", paper ? "" : " (no paper)",
        peeling ? " (depth peeling): " : ": ", different, " values differ");
    }
  }
}

void TestBackgrounds(InkTestChecks& check)
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
    check(different == 0, "a gradient background, ", different, " pixels differ");
  }
}

/// Alpha is 1 where there is paper and 0 elsewhere, for pictures with a transparent background. (What
/// translucent actors, and so ink without paper, add to alpha is VTK's choice: it differs between versions.)
void TestTransparentBackground(InkTestChecks& check)
{
  for (bool paper : { true, false })
  {
    SplattingLinesScene scene(InkTestPoints::Sphere(1.0, 0.05));
    scene.Mapper->SetPaperVisibility(paper);
    scene.Window->AlphaBitPlanesOn();
    scene.Renderer->SetBackgroundAlpha(0.0);
    scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    const InkTestImage image(scene.Window, 1, true);
    check(image.Channel(2, 2, 3) == 0, "a transparent background");
    check(image.Channel(100, 100, 3) == (paper ? 255 : 0), "alpha within the contour, ",
      image.Channel(100, 100, 3));
  }
}

} // namespace

int TestSplattingLinesState(int, char*[])
{
  InkTestChecks check;
  TestBystanders(check);
  TestBackgrounds(check);
  TestTransparentBackground(check);
  return check.Result();
}
