// SPDX-License-Identifier: BSD-3-Clause
// Pictures against baselines: an analytic shape, and real CT data with paper and as ink over a shaded
// surface.
#include "InkTestBaseline.h"
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include "vtkFlyingEdges3D.h"
#include "vtkNIFTIImageReader.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

TEST(SplattingLinesBaselines, Pictures)
{

  SplattingLinesScene torus(InkTestPoints::Torus(1.0, 0.4, 0.03));
  torus.Renderer->GetActiveCamera()->Elevation(-55.0);
  torus.Renderer->ResetCamera();
  EXPECT_TRUE(InkTestMatchesBaseline(InkTestImage(torus.Window), "SplattingLinesTorus", 30.0))
    << "the torus' baseline";

  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(INK_DATA_DIR "/engine.nii.gz");
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputConnection(reader->GetOutputPort());
  surface->SetValue(0, 80.0);
  surface->ComputeScalarsOff();
  surface->Update();
  SplattingLinesScene engine(surface->GetOutput(), 300, 300);
  engine.Mapper->SetRadius(1.0);
  vtkCamera* camera = engine.Renderer->GetActiveCamera();
  camera->Azimuth(30.0);
  camera->Elevation(30.0);
  engine.Renderer->ResetCamera();
  camera->Zoom(1.4);
  EXPECT_TRUE(InkTestMatchesBaseline(InkTestImage(engine.Window), "SplattingLinesEngine", 100.0))
    << "the engine's baseline";

  engine.Mapper->PaperVisibilityOff();
  engine.Mapper->SetInkColor(0.1, 0.1, 0.4);
  vtkNew<vtkPolyDataMapper> shaded;
  shaded->SetInputConnection(surface->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(shaded);
  actor->GetProperty()->SetColor(1.0, 0.9, 0.7);
  engine.Renderer->AddActor(actor);
  EXPECT_TRUE(InkTestMatchesBaseline(InkTestImage(engine.Window), "SplattingLinesOverSurface", 100.0))
    << "the baseline of ink over a surface";
}
